# SPDX-License-Identifier: GPL-3.0-or-later
"""Map files: the tables [structure] and [map] of a body of voxels."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import lateral
from .._units import LENGTH, MODULUS, RATIO
from ..material import Elastic
from .field import POISSON, POSITIVE, Field, Range, Table
from .named import IRREGULAR, Files, Folder, Given, GivenFiles, reason_of
from .section import WHOLE, ProblemError, Section
from .toml import parse_file, parse_text

_PHASE = Table(
    "a phase; the first one also fills the body below the array",
    (
        Field("E", "Young's modulus", MODULUS, range=POSITIVE),
        Field("nu", "Poisson's ratio", RATIO, range=POISSON),
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
        return _problem(parse_file(path), path.stem, Folder(path.parent))
    except ProblemError as problem:
        raise problem.within(path) from problem


def read_map_text(text: str, title: str = "", files: Given = ()) -> MapProblem:
    """Read the text of a map file from another source.

    Parameters
    ----------
    text
        The text. It may only name files that are given with it.
    title
        The title, if the text has none.
    files
        A dict from names of files to contents (bytes) or paths, or a list of paths.

    Returns
    -------
    MapProblem
        Its contents, in SI units.

    Raises
    ------
    ProblemError
        If the text is wrong, or names a file that is not given.

    Examples
    --------
    >>> import io
    >>> import numpy as np
    >>> from mdrcontact.problem import read_map_text
    >>> labels = io.BytesIO()
    >>> np.save(labels, np.zeros((2, 4, 4), dtype=int))
    >>> text = '''
    ... map = { radii = ["1 um"] }
    ... structure = { labels = "labels.npy", spacing = ["1 um", "1 um", "1 um"], phase = [{ E = "3 GPa", nu = 0.35 }] }
    ... '''
    >>> read_map_text(text, files={"labels.npy": labels.getvalue()}).radii
    array([1.e-06])
    """
    return _problem(parse_text(text), title, GivenFiles(files))


def _problem(table: dict[str, Any], title: str, files: Files) -> MapProblem:
    whole = Section(table, WHOLE, KNOWN)
    for name in ("structure", "map"):
        if name not in whole:
            raise ProblemError(f"the table [{name}] is missing", "A map file needs [structure] and [map]", key=name)
    structure = Section(table["structure"], "structure", STRUCTURE, files)
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
    section = Section(table["map"], "map", MAP)
    radii = np.array(section.quantities("radii"))
    if not radii.size:
        raise section.error("radii", "it needs at least one length", 'Write it as in radii = ["1 um"]')
    return MapProblem(str(whole.plain("title", title)), voxels, radii)


def _labels(structure: Section) -> Any:
    file = structure.file("labels", "a file", "labels.npy")
    words = "it cannot be read as a NumPy array (.npy)"
    try:
        if file.place is None:
            return np.lib.format.read_array(io.BytesIO(file.given), allow_pickle=False)
        with file.open():
            # a memory map: slices are read on demand
            return np.lib.format.open_memmap(file.place, mode="r")
    except OSError as problem:
        raise structure.error("labels", f"{words}: {reason_of(problem)}") from None
    except (ValueError, EOFError) as problem:
        # the message of NumPy repeats the begin of the file
        is_irregular = str(problem).endswith(IRREGULAR)
        rule = f"{words}: {problem if is_irregular else 'it is no such array'}"
        raise structure.error("labels", rule, "" if is_irregular else "Write it with numpy.save") from None
