# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `map`: effective modulus of a laterally heterogeneous structure at every place, for several contact radii."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from .. import lateral
from .._units import LENGTH, MODULUS, RATIO, practical
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
        Follows the slices of all maps, and stops between two of them.

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
