# SPDX-License-Identifier: GPL-3.0-or-later
"""Map files: the tables [structure] and [map] of a body of voxels."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import lateral
from .._units import LENGTH, MODULUS
from ..material import Elastic
from .named import IRREGULAR, Folder, reason_of
from .section import ProblemError, Section
from .toml import parse_file

_TABLES = {"title": None, "structure": None, "map": None}
_STRUCTURE = {"labels": None, "spacing": LENGTH, "beside": None, "exponent": None, "phase": None}
_PHASE = {"E": MODULUS, "nu": None}


class MapProblem(NamedTuple):
    """What a map file says."""

    title: str
    voxels: lateral.Voxels
    radii: NDArray[np.float64]
    """of contact [m]"""


def load_map(path: str | Path) -> MapProblem:
    """Reads a map file; a fault in it is a `ProblemError` that names the file."""
    path = Path(path)
    try:
        return _problem(parse_file(path), path)
    except ProblemError as problem:
        raise ProblemError(f"{path}: {problem}") from problem


def _problem(table: dict[str, Any], path: Path) -> MapProblem:
    whole = Section(table, "the file", _TABLES)
    for name in ("structure", "map"):
        if name not in whole:
            raise ProblemError(f"the table [{name}] is missing: a map has [structure] and [map]")
    structure = Section(table["structure"], "structure", _STRUCTURE, Folder(path.parent))
    phases = []
    for section in structure.children("phase", _PHASE):
        with section.words():
            phases.append(Elastic(section.quantity("E"), section.number("nu")))
    beside = structure.choice("beside", ("periodic", "padded"), "periodic")
    with structure.words():
        voxels = lateral.Voxels(
            _labels(structure), phases, structure.quantities("spacing"), below=phases[0],
            beside="periodic" if beside == "periodic" else phases[0],
            exponent=structure.number("exponent", 1.0),
        )  # fmt: skip
    radii = np.array(Section(table["map"], "map", {"radii": LENGTH}).quantities("radii"))
    if not radii.size or not np.all(radii > 0.0):
        raise ProblemError("[map]: radii must be at least one length, all greater than 0")
    return MapProblem(str(whole.plain("title", path.stem)), voxels, radii)


def _labels(structure: Section) -> Any:
    file = structure.file("labels", "a file", "labels.npy")
    words = f"[structure]: labels = {file.path.name!r} cannot be read as a NumPy array (.npy)"
    assert file.place is not None
    try:
        with file.open():
            # mapped, not read: slices come from the file when they are needed
            return np.lib.format.open_memmap(file.place, mode="r")
    except OSError as problem:
        raise ProblemError(f"{words}: {reason_of(problem)}") from None
    except (ValueError, EOFError) as problem:
        # NumPy repeats the begin of what is no array
        raise ProblemError(f"{words}: {problem if str(problem).endswith(IRREGULAR) else 'write it with numpy.save'}") from None
