# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `map`: effective modulus of a laterally heterogeneous structure at every place, for several contact radii."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from .. import lateral
from .._units import LENGTH, MODULUS, RATIO, practical
from ..panels import Axis, Cells, Figure, Line, Panel, Rule
from ..problem import MapProblem
from ..progress import Progress
from .result import Array, Column, Number, Result, Table, Words, column, study

_SERIES, _PARALLEL = -1.0, 1.0
_NAMES = {_SERIES: "in series (lower bound)", _PARALLEL: "in parallel (upper bound)"}


@dataclass(frozen=True, eq=False, kw_only=True)
class MapResult(Result):
    """Maps of a structure. Table: "moduli", the least, mean and most of each map."""

    problem: MapProblem
    maps: Array
    """of the effective modulus under the exponent of the structure [Pa], (radii, ny, nx)"""
    moduli: Mapping[float, Array]
    """by exponent of the mean: least, mean and most of the maps [Pa], (radii, 3)"""

    def figure(self) -> Figure:
        """Return the structure from above and in section, and a map for each contact radius with the contact to scale."""
        return Figure(self.title, tuple(_panels(self)), columns=3)


def _panels(found: MapResult) -> Iterator[Panel]:
    voxels = found.problem.voxels
    nz, ny, nx = voxels.labels.shape
    dz, dy, dx = voxels.spacing
    length = practical(LENGTH, [max(nx * dx, ny * dy)])
    unit = practical(MODULUS, [float(np.max(found.maps))])
    x, y = (
        np.asarray(length.of(start + step * (np.arange(count) + 0.5)))
        for start, step, count in zip(voxels.origin, (dx, dy), (nx, ny), strict=True)
    )
    z = np.asarray(length.of(dz * (np.arange(nz) + 0.5)))
    phases = np.array([material.contact_modulus for material in voxels.phases], dtype=np.float64)
    of_phase = Axis("E* of the phase", unit.symbol, low=float(unit.of(phases.min())), high=float(unit.of(phases.max())))
    across, side, deep = (Axis(name, length.symbol) for name in ("x", "y", "depth z"))
    top, section = (unit.of(phases)[np.asarray(voxels.labels[part])] for part in (0, np.s_[:, ny // 2, :]))
    surface = Cells(x, y, top, of_phase, smooth=False, bar=False)
    line = Rule(float(y[ny // 2]), name="section", colour=1, dash=0)
    yield Panel(across, side, (surface, line), "structure at the surface", equal=True)
    yield Panel(across, deep, (Cells(x, z, section, of_phase, smooth=False),), "section", equal=True, downward=True)
    turn = np.linspace(0.0, 2.0 * np.pi, 73)
    for radius, values in zip(found.problem.radii, found.maps, strict=True):
        a = float(length.of(radius))
        middle = x[0] + 0.14 * (x[-1] - x[0]), y[0] + 0.14 * (y[-1] - y[0])
        circle = Line(middle[0] + a * np.cos(turn), middle[1] + a * np.sin(turn), "", "white")
        cells = Cells(x, y, unit.of(values), Axis("E_eff", unit.symbol), smooth=False)
        limits = across._replace(low=x[0], high=x[-1]), side._replace(low=y[0], high=y[-1])
        yield Panel(*limits, (cells, circle), f"contact radius a = {a:.3g} {length.symbol} (circle)", equal=True)


@study
def map(problem: MapProblem, *, threads: int = 0, memory_limit: float | None = None, progress: Progress | None = None) -> MapResult:
    """Compute maps of the effective modulus and of its bounds.

    Parameters
    ----------
    problem : MapProblem
        Structure and contact radii, as `mdrcontact.problem.load_map` returns them.
    threads : int, optional
        Number of threads >= 1, or 0 for one per core.
    memory_limit : float, optional
        Largest memory that the maps may use [bytes].
    progress : Progress, optional
        Reports the slices of all maps, and can stop the work between two of them.

    Returns
    -------
    MapResult
        `maps`; numbers "least" and "most" of them, and "bounds apart", the largest ratio of the bounds.

    Raises
    ------
    OutOfMemoryError
        The maps need more than `memory_limit`.
    MDRError
        The maps cannot be computed.

    Examples
    --------
    >>> import numpy as np
    >>> from mdrcontact import Elastic, lateral, studies
    >>> from mdrcontact.problem import MapProblem
    >>> labels = np.random.default_rng(1).integers(0, 2, (4, 8, 8))
    >>> voxels = lateral.Voxels(labels, [Elastic(3e9, 0.35), Elastic(70e9, 0.22)], 1e-6, below=Elastic(3e9, 0.35))
    >>> found = studies.map(MapProblem("Two phases", voxels, np.array([1e-6, 3e-6])))
    >>> found.maps.shape
    (2, 8, 8)
    """
    progress = progress or Progress()
    own, done = problem.voxels.exponent, 0
    # the structure's own maps last: those of the bounds are not kept
    exponents = sorted({_SERIES, _PARALLEL, own}, key=lambda p: p == own)
    slices = problem.voxels.labels.shape[0]
    total, moduli = len(exponents) * slices, {}
    for exponent in exponents:
        followed = _part_of(progress, done, total)
        maps = lateral.effective_map(
            problem.voxels.replace(exponent=exponent), problem.radii, threads=threads, progress=followed, memory_limit=memory_limit
        )
        moduli[exponent] = np.stack([maps.min((1, 2)), maps.mean((1, 2)), maps.max((1, 2))], axis=1)
        done += slices
    apart = float((moduli[_PARALLEL] / moduli[_SERIES]).max())
    words = (
        f"At one Poisson's ratio the exact modulus lies between the bounds: here the upper is up to {apart:.4g} times the lower."
    )
    return MapResult(
        title=problem.title,
        numbers={
            "least": Number(float(maps.min()), MODULUS),
            "most": Number(float(maps.max()), MODULUS),
            "bounds apart": Number(apart, RATIO),
        },
        notes={"bounds": words},
        tables={"moduli": _table(problem.radii, moduli)},
        problem=problem,
        maps=maps,
        moduli=moduli,
    )


def _part_of(progress: Progress, done: int, total: int) -> Progress:
    """The progress of work that is a part of another."""
    return Progress(lambda part, _total, what: progress.step(done + part, total, what))


def _table(radii: Array, moduli: Mapping[float, Array]) -> Table:
    """A row for each radius and exponent."""
    names = [_NAMES.get(exponent, f"exponent {exponent:g}") for exponent in sorted(moduli)]
    values = np.stack([moduli[exponent] for exponent in sorted(moduli)], axis=1).reshape(-1, 3)
    unit = practical(MODULUS, values.ravel())
    return [
        column("radius", np.repeat(radii, len(names)), LENGTH),
        Words("moduli", names * len(radii)),
        *(Column(name, values[:, i], unit) for i, name in enumerate(("least", "mean", "most"))),
    ]
