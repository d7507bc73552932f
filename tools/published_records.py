#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Published force curves with known answers: tools/published_records.py FOLDER

Fits every file of FOLDER whose name is in the table below and prints the modulus beside that of another program. It fetches
nothing: the files are those of the test data of nanite and afmformats (AFM-analysis), laid there by hand. Status 1 where a modulus
is more than 0.5 % away.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

from mdrcontact import MDRError, fit
from mdrcontact.problem.fit_file import load_fit_file

PROBLEM = """
[indenter]
shape = "paraboloid"
radius = "5 um"
[medium]
type = "homogeneous"
material = { E = "3 kPa", nu = 0.5 }
[data]
kind = "force-depth"
[fit]
free = ["E"]
"""
ENOUGH = 0.005


class Known(NamedTuple):
    """The modulus that nanite 4 gives: model hertz_para, R = 5 um, nu = 0.5, force and tip offset corrected, contact point and
    baseline fitted, weight_cp = 0 [Pa]."""

    file: str
    curve: int
    modulus: float


KNOWN = (
    Known("zebrafish-head-section-gray-matter.jpk-force", 0, 140.79),
    Known("fmt-jpk-fd_spot3-0192.jpk-force", 0, 20848.0),
    Known("fmt-jpk-fd_flipsign_2015.05.22-15.31.49.352.jpk-force", 0, 7004.7),
    Known("fmt-jpk-fd_single_tilted-baseline-drift-mitotic_2021-01-29.jpk-force", 0, 1601.4),
    Known("fmt-jpk-fd_single_tilted-baseline-shift-adyp_2023-06-26.jpk-force", 0, 1099.8),
    Known("fmt-jpk-fd_map-data-reference-points.jpk-force-map", 0, 103.42),
    Known("fmt-jpk-fd_map-data-reference-points.jpk-force-map", 1, 22087.0),
    Known("fmt-jpk-fd_map-data-reference-points.jpk-force-map", 2, 78.904),
    Known("fmt-jpk-fd_map0d_extracted.jpk-force-map", 0, 2353.5),
    Known("fmt-jpk-fd_map1d_2016-11-07.jpk-force-map", 0, 2202.0),
    Known("fmt-jpk-fd_map1d_2016-11-07.jpk-force-map", 1, 1339.7),
    Known("fmt-jpk-fd_map1d_2016-11-07.jpk-force-map", 2, 1002.7),
    Known("fmt-jpk-fd_map1d_2016-11-07.jpk-force-map", 3, 3391.6),
    Known("fmt-jpk-fd_map2x2_extracted.jpk-force-map", 1, 6709.6),
    Known("fmt-jpk-fd_2020.02.07-16.29.05.036.jpk-qi-data", 0, 1403.4),
    Known("fmt-jpk-fd_2020.02.07-16.29.05.036.jpk-qi-data", 1, 3511.5),
    Known("fmt-jpk-fd_2020.02.07-16.29.05.036.jpk-qi-data", 2, 1712.1),
    Known("fmt-jpk-fd_2020.02.07-16.29.05.036.jpk-qi-data", 3, 1183.1),
)


def row(path: Path, problem: Path, known: Known) -> tuple[str, bool]:
    """A line of the table, and whether the modulus is right."""
    begin = f"{path.name[:48]:48} {known.curve}  {known.modulus:10.5g} Pa"
    try:
        given = load_fit_file(problem)
        data, _ = given.curves(path)[known.curve].read()
        found = fit(data, given.indenter, given.medium, given.free, instrument=given.instrument, **given.options)
    except MDRError as refusal:
        return f"{begin}  refused: {refusal}", False
    off = found.estimates["E"] / known.modulus - 1.0
    return f"{begin}  {found.estimates['E']:10.5g} Pa  {100.0 * off:+7.3f} %  {found.verdict}", abs(off) <= ENOUGH


def main() -> int:
    """Prints the table; 1 where a modulus is off."""
    if len(sys.argv) != 2 or not Path(sys.argv[1]).is_dir():
        print(__doc__)
        return 2
    paths = {path.name: path for path in Path(sys.argv[1]).rglob("*") if path.is_file()}
    right = True
    with tempfile.TemporaryDirectory() as folder:
        problem = Path(folder) / "problem.toml"
        problem.write_text(PROBLEM)
        for known in KNOWN:
            if known.file in paths:
                line, good = row(paths[known.file], problem, known)
                right = right and good
                print(line, flush=True)
            else:
                print(f"{known.file[:48]:48} {known.curve}  is not in the folder")
    return 0 if right else 1


if __name__ == "__main__":
    sys.exit(main())
