# SPDX-License-Identifier: GPL-3.0-or-later
"""How hard a tip was pulled, on its way in and out: numbers of the record, without a model."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .segments import curve

_CLEAR, _FAR = 5.0, 0.2
"""Times the noise that a pull must be, and the part of the readings, farthest away, that is without contact."""
_FEWEST = 20


class Pull(NamedTuple):
    """The lowest force of a branch below the force far away: jump into contact on approach, pull-off on retract."""

    force: float
    """how far below, greater than 0"""
    depth: float
    """where"""
    noise: float
    """standard deviation of the force far away"""


def find_pull(depth: ArrayLike, force: ArrayLike) -> Pull | None:
    """The largest pull on one branch, approach or retract; None where it is less than five times the noise, or the curve has fewer
    than 20 points.

    depth, force : of the branch, in any order, baseline included [length], [force]; n numbers each
    """
    d, f = curve(depth, force)
    if len(d) < _FEWEST:
        return None
    level, noise = _far_away(d, f)
    at = int(np.argmin(f))
    # of n readings the lowest is several standard deviations below by chance: its neighbours are low, too
    low = float(np.median(f[max(at - 1, 0) : at + 2]))
    pull = level - low
    return Pull(pull, float(d[at]), noise) if pull > max(_CLEAR * noise, 0.0) else None


class Parting(NamedTuple):
    """How a tip came off, and what the cycle cost."""

    rupture_depth: float
    """where the force last rises from below the noise of the baseline to it: the last rupture"""
    energy: float
    """lost in the cycle, the area between approach and retract"""


def find_parting(depth: ArrayLike, force: ArrayLike) -> Parting | None:
    """The last rupture and the energy lost of a cycle of approach and retract; None where the retract does not pull more than five
    times the noise, or a branch has fewer than 20 points.

    depth, force : of the cycle in the order of time, both branches from the baseline on [length], [force]; n numbers each. It turns
        at the largest force. Each branch has the median of its own farthest readings as its zero of the force
    """
    d, f = curve(depth, force)
    top = int(np.argmax(f))
    branches = [(d[: top + 1], f[: top + 1]), (d[top:], f[top:])]
    if min(len(part) for part, _ in branches) < _FEWEST or find_pull(*branches[1]) is None:
        return None
    levels = [_far_away(*branch) for branch in branches]
    energy = sum(_area(x, y - level) for (x, y), (level, _) in zip(branches, levels, strict=True))
    (x, y), (level, noise) = branches[1], levels[1]
    pulled = np.flatnonzero(_smooth(y) < level - _CLEAR * noise)
    return Parting(float(x[pulled[-1]]), energy)


def _far_away(d: NDArray[np.float64], f: NDArray[np.float64]) -> tuple[float, float]:
    """Level and noise of the force without contact."""
    far = f[np.argsort(d)[: max(int(_FAR * len(d)), 5)]]
    level = float(np.median(far))
    return level, 1.4826 * float(np.median(np.abs(far - level)))


def _area(x: NDArray[np.float64], y: NDArray[np.float64]) -> float:
    """int y dx along the readings."""
    return float(np.sum(0.5 * (y[1:] + y[:-1]) * np.diff(x)))


def _smooth(f: NDArray[np.float64]) -> NDArray[np.float64]:
    """Medians of three: of n readings some lie several standard deviations below by chance."""
    padded = np.concatenate([f[:1], f, f[-1:]])
    return np.asarray(np.median([padded[:-2], padded[1:-1], padded[2:]], axis=0))
