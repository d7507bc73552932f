# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact map`: effective modulus of a laterally heterogeneous structure at every place, for several contact radii."""

from __future__ import annotations

import argparse
import io
import sys
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from .. import lateral
from .._text import aligned, number
from .._units import LENGTH, MODULUS, practical
from ..material import Elastic
from ..problem import ProblemError
from ..problem.named import IRREGULAR, Folder, reason_of
from ..problem.section import Section
from ..problem.toml import parse_file
from . import files
from .map_figure import map_figure

HELP = "effective modulus at every place of a heterogeneous structure"

_TABLES = {"title": None, "structure": None, "map": None}
_STRUCTURE = {"labels": None, "spacing": LENGTH, "beside": None, "exponent": None, "phase": None}
_PHASE = {"E": MODULUS, "nu": None}


class MapProblem(NamedTuple):
    """What a map file says."""

    title: str
    voxels: lateral.Voxels
    radii: np.ndarray[Any, Any]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("problem", metavar="MAP.toml", help="the map file")
    parser.add_argument("--npy", type=Path, metavar="FILE.npy", help="write the maps as a NumPy array (radii, ny, nx) [Pa]")
    parser.add_argument("--plot", type=Path, metavar="FILE.png", help="draw structure and maps (.png, .pdf or .svg)")
    parser.add_argument("--overwrite", action="store_true", help="replace files that exist")
    parser.add_argument("--threads", type=int, default=0, metavar="N", help="how many threads (default: 0, one per core)")
    parser.add_argument("--memory", type=float, metavar="GIB", help="refuse to use more memory than this [GiB]")


def run(arguments: argparse.Namespace) -> None:
    """Computes, prints, writes."""
    files.check(arguments)
    problem = read(Path(arguments.problem))
    needed = lateral.map_memory(problem.voxels, problem.radii, threads=arguments.threads)
    nz, ny, nx = problem.voxels.labels.shape
    print(f"{problem.title}\n")
    print(f"{nx} x {ny} x {nz} voxels, {len(problem.radii)} radii: at most {needed / 2**20:.0f} MiB of memory", flush=True)
    maps, found = _maps(problem, arguments)
    print(_table(problem, found))
    files.write(
        arguments,
        npy=lambda: _as_npy(maps),
        plot=lambda: map_figure(problem.title, problem.voxels, problem.radii, maps),
    )


def _as_npy(maps: Any) -> bytes:
    buffer = io.BytesIO()
    np.save(buffer, maps)
    return buffer.getvalue()


def _maps(problem: MapProblem, arguments: argparse.Namespace) -> tuple[Any, dict[float, Any]]:
    """The maps, and least, mean and most of them for each exponent, (radii, 3): series, the structure's own, parallel."""
    own, found = problem.voxels.exponent, {}
    # its own maps last: those of the bounds are not kept
    for exponent in sorted({-1.0, 1.0, own}, key=lambda p: p == own):
        maps = lateral.effective_map(
            problem.voxels.replace(exponent=exponent), problem.radii, threads=arguments.threads, progress=sys.stderr.isatty(),
            memory_limit=None if arguments.memory is None else arguments.memory * 2**30,
        )  # fmt: skip
        found[exponent] = np.stack([maps.min((1, 2)), maps.mean((1, 2)), maps.max((1, 2))], axis=1)
    return maps, found


def _table(problem: MapProblem, found: dict[float, Any]) -> str:
    """The statistics of the maps, and how far the bounds are apart."""
    names = {-1.0: "in series (lower bound)", 1.0: "in parallel (upper bound)"}
    length, modulus = practical(LENGTH, problem.radii), practical(MODULUS, np.concatenate(list(found.values())).ravel())
    rows = [[f"radius [{length.name}]", "moduli", *(f"{word} [{modulus.name}]" for word in ("least", "mean", "most"))]]
    for i, a in enumerate(problem.radii):
        for exponent in sorted(found):
            numbers = (number(float(modulus.of(v))) for v in found[exponent][i])
            rows.append([number(float(length.of(a))), names.get(exponent, f"exponent {exponent:g}"), *numbers])
    apart = float((found[1.0] / found[-1.0]).max())
    words = (
        f"At one Poisson's ratio the exact modulus lies between the bounds: here the upper is up to {apart:.4g} times the lower."
    )
    return f"{aligned(rows, left=2)}\n\n{words}"


def read(path: Path) -> MapProblem:
    """Reads a map file; a fault in it is a `ProblemError` that names the file."""
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
