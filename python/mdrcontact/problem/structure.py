# SPDX-License-Identifier: GPL-3.0-or-later
"""Map files: the tables [structure] and [map] of a body of voxels."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import lateral
from .._units import LENGTH, MODULUS, RATIO
from ..material import Elastic
from .field import POSITIVE, Field, Range, Table
from .named import IRREGULAR, Folder, reason_of
from .section import ProblemError, Section
from .toml import parse_file

_PHASE = Table(
    "a phase; the first one also fills the body below the array",
    (
        Field("E", "Young's modulus", MODULUS, range=POSITIVE),
        Field("nu", "Poisson's ratio", RATIO, range=Range(-1.0, 0.5, has_largest=True)),
    ),
)
STRUCTURE = Table(
    "the structure",
    (
        Field("labels", "NumPy array (nz, ny, nx) of phase numbers, surface first", is_file=True, example='"labels.npy"'),
        Field("spacing", "edge lengths of a cell: z, y, x", LENGTH, range=POSITIVE, many=True, example='["1 um", "1 um", "1 um"]'),
        Field("beside", "surroundings of the array; padded: the first phase", default="periodic", choices=("periodic", "padded")),
        Field("exponent", "exponent of the mean: 1 in parallel, -1 in series", RATIO, 1.0, range=Range(-1.0, 1.0, True, True)),
        Field("phase", "the phases, in the order of their numbers", table=_PHASE, many=True),
    ),
    "docs/composites.md",
)
MAP = Table("where E_eff is computed", (Field("radii", "contact radii", LENGTH, range=POSITIVE, many=True),), "docs/composites.md")
KNOWN = Table(
    "a map",
    (
        Field("title", "title of the results", optional=True, example='"Glass in a polymer"'),
        Field("structure", STRUCTURE.meaning, table=STRUCTURE),
        Field("map", MAP.meaning, table=MAP),
    ),
    "docs/composites.md",
)
"""The file of mdrcontact map."""


class MapProblem(NamedTuple):
    """The contents of a map file."""

    title: str
    voxels: lateral.Voxels
    radii: NDArray[np.float64]
    """of contact [m]"""


def load_map(path: str | Path) -> MapProblem:
    """Read a map file.

    Parameters
    ----------
    path
        The file. The name of the array of labels is relative to its folder.

    Returns
    -------
    MapProblem
        Its contents, in SI units.

    Raises
    ------
    ProblemError
        If the file cannot be read, or its contents are wrong. The message names the file.

    Examples
    --------
    >>> import tempfile
    >>> from pathlib import Path
    >>> import numpy as np
    >>> from mdrcontact.problem import load_map
    >>> folder = Path(tempfile.mkdtemp())
    >>> np.save(folder / "labels.npy", np.zeros((2, 4, 4), dtype=int))
    >>> _ = (folder / "map.toml").write_text('''
    ... map = { radii = ["1 um"] }
    ... structure = { labels = "labels.npy", spacing = ["1 um", "1 um", "1 um"], phase = [{ E = "3 GPa", nu = 0.35 }] }
    ... ''')
    >>> load_map(folder / "map.toml").radii
    array([1.e-06])
    """
    path = Path(path)
    try:
        return _problem(parse_file(path), path)
    except ProblemError as problem:
        raise ProblemError(f"{path}: {problem}") from problem


def _problem(table: dict[str, Any], path: Path) -> MapProblem:
    whole = Section(table, "the file", KNOWN)
    for name in ("structure", "map"):
        if name not in whole:
            raise ProblemError(f"the table [{name}] is missing. A map file needs [structure] and [map].")
    structure = Section(table["structure"], "structure", STRUCTURE, Folder(path.parent))
    phases = []
    for section in structure.value("phase"):
        with section.words():
            phases.append(Elastic(section.quantity("E"), section.number("nu")))
    beside = structure.value("beside")
    with structure.words():
        voxels = lateral.Voxels(
            _labels(structure), phases, structure.quantities("spacing"), below=phases[0],
            beside="periodic" if beside == "periodic" else phases[0],
            exponent=structure.value("exponent"),
        )  # fmt: skip
    radii = np.array(Section(table["map"], "map", MAP).quantities("radii"))
    if not radii.size or not np.all(radii > 0.0):
        raise ProblemError(f"[map]: radii = {radii.tolist()!r} m: they must be at least one length, each greater than 0.")
    return MapProblem(str(whole.plain("title", path.stem)), voxels, radii)


def _labels(structure: Section) -> Any:
    file = structure.file("labels", "a file", "labels.npy")
    words = f"[structure]: labels = {file.path.name!r}: it cannot be read as a NumPy array (.npy)"
    assert file.place is not None
    try:
        with file.open():
            # a memory map: slices are read on demand
            return np.lib.format.open_memmap(file.place, mode="r")
    except OSError as problem:
        raise ProblemError(f"{words}: {reason_of(problem)}") from None
    except (ValueError, EOFError) as problem:
        # the message of NumPy repeats the begin of the file
        raise ProblemError(
            f"{words}: {problem if str(problem).endswith(IRREGULAR) else 'it is no such array. Write it with numpy.save'}."
        ) from None
