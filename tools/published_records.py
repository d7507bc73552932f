#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Published records: tools/published_records.py FOLDER

Fits every file of FOLDER whose name is in the tables below and prints the modulus beside that of another program, and calibrates a
tip on half of the tests on fused silica to measure the other half. It fetches nothing: the files are those of the test data of
nanite and afmformats (AFM-analysis) and of the examples of indentationGUI and micromechanics, laid there by hand. Status 1 where a
modulus is more than 0.5 % from the other program's, or that of a cycle further from that of fused silica than the table says.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np

from mdrcontact import Elastic, Homogeneous, MDRError
from mdrcontact.instruments import FitResult, Unloading, as_prior, fit, mean_of_tests, oliver_pharr
from mdrcontact.instruments.files.curves import Curve
from mdrcontact.instruments.files.fit_file import FitFile, load_fit_file
from mdrcontact.instruments.fitting.calibration import together, words_of_tests
from mdrcontact.instruments.fitting.data import Data

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

SILICA_PROBLEM = """
[indenter]
shape = "area-function"
coefficients = [24.5, 0]
length_unit = "nm"
max_height = "3 um"
[medium]
type = "homogeneous"
material = {{ E = "72 GPa", nu = 0.17 }}
[instrument]
indenter = {{ E = "1141 GPa", nu = 0.07 }}
stiffness_factor = 1.034
[data]
kind = "unloading"
contact_point = "{contact_point}"
[fit]
free = ["indenter.C0", "indenter.C1", "frame_compliance"]
"""
SILICA, DIAMOND = Elastic(72e9, 0.17), Elastic(1141e9, 0.07)
KNOWN_TO = 0.01
"""Relative standard error of the stiffness of the cycles that are judged."""


class OnSilica(NamedTuple):
    """Unloading curves on fused silica: which of the tests calibrate, and how the first contact is found."""

    file: str
    first: int
    contact_point: str
    near: float
    """how near to the modulus of fused silica the cycles are"""


ON_SILICA = (
    OnSilica("FusedSilica.xlsx", 1, "piecewise", 0.03),
    # by the maker's program its tests differ by as much
    OnSilica("FS1.txt", 0, "given", 0.07),
)


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


WEIGHT = 5e-7
"""nanite's default distance from the contact point within which residuals count less, in proportion to it [m]"""
KNOWN_WEIGHTED = (
    Known("fmt-jpk-fd_spot3-0192.jpk-force", 0, 22226.0),
    Known("fmt-jpk-fd_flipsign_2015.05.22-15.31.49.352.jpk-force", 0, 8269.3),
    Known("fmt-jpk-fd_single_tilted-baseline-drift-mitotic_2021-01-29.jpk-force", 0, 1379.9),
    Known("fmt-jpk-fd_single_tilted-baseline-shift-adyp_2023-06-26.jpk-force", 0, 1093.5),
    Known("fmt-jpk-fd_map0d_extracted.jpk-force-map", 0, 2912.2),
    Known("fmt-jpk-fd_map1d_2016-11-07.jpk-force-map", 0, 2784.2),
    Known("fmt-jpk-fd_map1d_2016-11-07.jpk-force-map", 1, 1662.8),
)


def row(path: Path, problem: Path, known: Known, weight: float = 0.0) -> tuple[str, bool]:
    """A line of the table, and whether the modulus is right."""
    begin = f"{path.name[:48]:48} {known.curve}  {known.modulus:10.5g} Pa"
    try:
        given = load_fit_file(problem)
        data, _ = given.curves(path)[known.curve].read()
        found = fit(
            data,
            given.indenter,
            given.medium,
            given.free,
            instrument=given.instrument,
            contact_weight=weight,
            contact_weight_rule="moving",
            **given.options,
        )
    except MDRError as refusal:
        return f"{begin}  refused: {refusal}", False
    off = found.estimates["E"] / known.modulus - 1.0
    return f"{begin}  {found.estimates['E']:10.5g} Pa  {100.0 * off:+7.3f} %  {found.verdict}", abs(off) <= ENOUGH


def silica(path: Path, folder: Path, known: OnSilica) -> bool:
    """Prints the modulus of each test that did not calibrate; whether all its cycles are right."""
    problem = folder / "silica.toml"
    problem.write_text(SILICA_PROBLEM.format(contact_point=known.contact_point))
    given = load_fit_file(problem)
    curves = given.curves(path)
    half = [data for data, _ in (one.read() for one in curves[known.first :: 2]) if isinstance(data, Unloading)]
    tip = fit(together(half), given.indenter, given.medium, given.free, instrument=given.instrument, **given.options)
    print(f"{path.name}: calibrated on {len(half)} tests, chi-square/dof {tip.reduced_chi_square:.3g}")
    for words in words_of_tests(tip):
        print(f"  {words}")
    found = [_of_silica(one, tip, given) for one in curves[1 - known.first :: 2]]
    mean = mean_of_tests([test for test, _ in found], "E")
    low, high = (1e-9 * end for end in mean.interval)
    print(f"  mean of {mean.tests} tests {mean.value / 1e9:.2f} GPa, 95 % interval {low:.2f} to {high:.2f} GPa")
    _print_largest([one.read()[0] for one in curves])
    return max(away for _, away in found) < known.near and low <= 1e-9 * SILICA.E <= high


def _print_largest(tests: list[Data]) -> None:
    """What the tests read at their largest force, whatever tip, frame or fit: the same stiffness belongs to the same area, so that
    differences of the depth are those of the modulus of any method that takes the area from the depth."""
    last = [(test.x[-1], test.force[-1], test.y[-1]) for test in tests if isinstance(test, Unloading)]
    h, force, stiffness = (np.array(column) for column in zip(*last, strict=True))
    spans = ", ".join(
        f"{what} {100.0 * np.ptp(values) / np.mean(values):.2g} %"
        for what, values in (("force", force), ("stiffness", stiffness), ("depth", h), ("stiffness over depth", stiffness / h))
    )
    print(f"  at the largest force of {len(last)} tests, from least to largest: {spans}")


def _of_silica(one: Curve, tip: FitResult, given: FitFile) -> tuple[FitResult, float]:
    """Prints a test; its fit, and how far its cycles are away at most, 0 of a test that its fit rejects."""
    data, _ = one.read()
    assert isinstance(data, Unloading)
    body, known = Homogeneous(SILICA), [as_prior(tip)]
    found = fit(data, tip.indenter, body, ["E"], instrument=tip.instrument, known=known, **given.options)
    reduced = np.asarray(oliver_pharr(data, tip.indenter, tip.instrument, medium=body).reduced_modulus)
    moduli = (1.0 - SILICA.nu**2) / (1.0 / reduced - 1.0 / DIAMOND.contact_modulus) / 1e9
    errors = np.array([q.stiffness_error / q.stiffness for q in data.unloadings])
    sharp = moduli[errors < KNOWN_TO]
    maker = "".join(f", {fact}" for fact in one.facts)
    print(
        f"  {one.name[-8:]}: {found.as_text('E')}, {found.verdict}; {len(sharp)} of {len(moduli)} cycles known to 1 %: "
        f"{sharp.min():.1f} to {sharp.max():.1f} GPa{maker}"
    )
    return found, 0.0 if found.describes_data is False else float(abs(1e9 * sharp / SILICA.E - 1.0).max())


def main() -> int:
    """Prints the tables; 1 where a modulus is off."""
    if len(sys.argv) != 2 or not Path(sys.argv[1]).is_dir():
        print(__doc__)
        return 2
    paths = {path.name: path for path in Path(sys.argv[1]).rglob("*") if path.is_file()}
    right = True
    with tempfile.TemporaryDirectory() as folder:
        problem = Path(folder) / "problem.toml"
        problem.write_text(PROBLEM)
        for known, weight in [*((one, 0.0) for one in KNOWN), *((one, WEIGHT) for one in KNOWN_WEIGHTED)]:
            if known.file in paths:
                line, good = row(paths[known.file], problem, known, weight)
                right = right and good
                print(line, flush=True)
            else:
                print(f"{known.file[:48]:48} {known.curve}  is not in the folder")
        for record in ON_SILICA:
            if record.file in paths:
                right = silica(paths[record.file], Path(folder), record) and right
            else:
                print(f"{record.file} is not in the folder")
    return 0 if right else 1


if __name__ == "__main__":
    sys.exit(main())
