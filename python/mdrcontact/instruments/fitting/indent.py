# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether loading and unloading of a record are those of an indent: plastic, and not of an elastic contact."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...loop import BRANCHES
from .data import ForceDepth

Array = NDArray[np.float64]

LOST, _LEFT = 0.15, 0.1
"""Losses of work and depth, relative to loading, that exceed noise and drift on an elastic body."""
_LOW, _HIGH, _LEVELS = 0.05, 0.95, 19
"""Force levels, relative to the largest, at which loading and unloading are compared."""
_FEWEST, _GROUPS = 8, 40
"""Fewest readings of each; number of groups into which more of them are averaged."""
_PULLS = 0.05
"""Tensile force of unloading, relative to the largest force, that indicates adhesion."""
_BEYOND = 1.1
"""Force of the other readings, relative to the largest of the fitted ones, that shows that loading continued."""

_SURE = 3.0
"""Standard errors of few noisy readings by which losses must be larger."""


class Indent(NamedTuple):
    """Loss of work and depth from loading to unloading, from `FitResult.indent`.

    Examples
    --------
    >>> way = np.linspace(0.0, 1.0, 60)
    >>> depth = np.concatenate([100e-9 * way, 100e-9 - 40e-9 * way])
    >>> force = 1e-3 * np.concatenate([way**2, (1.0 - way) ** 1.5])
    >>> data = mdr.instruments.ForceDepth(depth, force)
    >>> body = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    >>> result = mdr.instruments.fit(data.on("loading"), mdr.Berkovich(), body, ["E"])
    >>> print(f"{result.indent.returned:.2f} {result.indent.residual_depth * 1e9:.0f} nm", result.verdict)
    0.48 43 nm plastic or viscous, 43 % of the depth stays
    """

    returned: float
    """share of the work of loading that unloading gives back [1]"""
    residual_depth: float
    """depth that unloading leaves at a twentieth of the largest force [length]"""
    share: float
    """the same over the largest depth [1]"""
    is_within: bool
    """whether unloading begins at the end of the fitted loading; False: loading continued beyond it"""


def find_indent(data: ForceDepth, depth_offset: float, force_offset: float) -> Indent | None:
    """Compare loading with unloading, one of which may be outside the fit; None without both, or if they are elastic."""
    found = _ways(data)
    if found is None:
        return None
    (x_loading, loading), (x_unloading, unloading) = ((x, y - force_offset) for x, y in found)
    ends = [float(np.max(force)) for force in (loading, unloading)]
    # readings of both ways may be among those that are not fitted
    largest = min(ends)
    way, back = (_between(x, force, largest) for x, force in ((x_loading, loading), (x_unloading, unloading)))
    if min(len(way[0]), len(back[0])) < _FEWEST or np.min(unloading) < -_PULLS * largest:
        return None
    level = np.linspace(_LOW, _HIGH, _LEVELS) * largest
    down, up = _depths_at(level, *way), _depths_at(level, *back)
    mean = 0.5 * (level[1:] + level[:-1])
    work = float(mean @ np.diff(down))
    returned = float(mean @ np.diff(up)) / work if work > 0.0 else 1.0
    left = float(up[0] - down[0])
    # an offset that is fitted to unloading is the residual depth
    share = left / float(max(x_loading.max(), x_unloading.max()) - min(depth_offset, down[0]))
    noise = _SURE * max(_noise(*way), _noise(*back)) / largest
    if not (1.0 - returned > LOST + noise and share > _LEFT + noise):
        return None
    is_loading = data.branch is None or BRANCHES["unloading"] not in data.branch
    return Indent(returned, left, share, not is_loading or ends[1] <= _BEYOND * ends[0])


def _ways(data: ForceDepth) -> tuple[tuple[Array, Array], tuple[Array, Array]] | None:
    """Depth and force of loading and of unloading; None without one of them."""
    branches = np.unique(data.branch) if data.branch is not None else np.array([BRANCHES["loading"]])
    if len(branches) > 1:
        loading, unloading = data.on("loading"), data.on("unloading")
        return (loading.x, loading.y), (unloading.x, unloading.y)
    if data.unused is None or not len(data.unused[0]):
        return None
    fitted, other = (data.x, data.y), (data.unused[0], data.unused[1])
    return (fitted, other) if branches[0] == BRANCHES["loading"] else (other, fitted)


def _between(depth: Array, force: Array, largest: float) -> tuple[Array, Array]:
    """Readings about the levels: those out of contact are below, a hold is above."""
    keep = (force > 0.5 * _LOW * largest) & (force < 0.5 * (1.0 + _HIGH) * largest)
    return depth[keep], force[keep]


def _noise(depth: Array, force: Array) -> float:
    """Standard error of a level of the force, from second differences along the depth, which a smooth curve hardly has."""
    along = np.diff(force[np.argsort(depth, kind="stable")], 2)
    return float(np.sqrt(np.mean(along**2) / 6.0 * _LEVELS / len(force)))


def _depths_at(level: Array, depth: Array, force: Array) -> Array:
    """Depths at these forces, of readings in any order."""
    order = np.argsort(force, kind="stable")
    width = max(len(order) // _GROUPS, 1)
    # means over neighbours in force, whose noise would put them in another order
    weights = np.ones(width) / width
    return np.asarray(np.interp(level, np.convolve(force[order], weights, "valid"), np.convolve(depth[order], weights, "valid")))
