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
    far: NDArray[np.float64] = f[np.argsort(d)[: max(int(_FAR * len(d)), 5)]]
    level = float(np.median(far))
    noise = 1.4826 * float(np.median(np.abs(far - level)))
    at = int(np.argmin(f))
    # of n readings the lowest is several standard deviations below by chance: its neighbours are low, too
    low = float(np.median(f[max(at - 1, 0) : at + 2]))
    pull = level - low
    return Pull(pull, float(d[at]), noise) if pull > max(_CLEAR * noise, 0.0) else None
