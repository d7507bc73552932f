# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesion forces of a record on approach and retract, without a model."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .segments import curve

_CLEAR, _FAR = 5.0, 0.2
"""Smallest pull over the noise, and the fraction of the readings, the farthest ones, that are out of contact."""
_FEWEST = 20


class Pull(NamedTuple):
    """Lowest force of a branch: jump-in on approach, pull-off on retract.

    `find_pull` returns it.

    Examples
    --------
    >>> depth = np.linspace(-500e-9, 100e-9, 121)
    >>> force = np.where(depth > -50e-9, (depth - 50e-9) * 1e-2, 0.0)
    >>> pull = mdr.instruments.find_pull(depth, force)
    >>> print(f"{pull.force:.2e}")
    9.50e-10
    """

    force: float
    """force below the level without contact, > 0 [force]"""
    depth: float
    """depth of the lowest force [length]"""
    noise: float
    """standard deviation of the force without contact [force]"""


def find_pull(depth: ArrayLike, force: ArrayLike) -> Pull | None:
    """Find the largest adhesion force on one branch.

    Parameters
    ----------
    depth : array_like
        Depths of the branch in any order, baseline included [length].
    force : array_like
        Forces, as many [force].

    Returns
    -------
    Pull or None
        The lowest force; None if it is less than five times the noise, or there are fewer than 20 points.

    Raises
    ------
    InvalidArgumentError
        The columns differ in length, or depth or force is constant.

    Examples
    --------
    >>> depth = np.linspace(-500e-9, 100e-9, 121)
    >>> force = np.where(depth > -50e-9, (depth - 50e-9) * 1e-2, 0.0)
    >>> print(f"{mdr.instruments.find_pull(depth, force).depth * 1e9:.0f}")
    -50
    """
    d, f = curve(depth, force)
    if len(d) < _FEWEST:
        return None
    level, noise = _far_away(d, f)
    at = int(np.argmin(f))
    # of n readings the lowest is several standard deviations below by chance: its neighbours are also low
    low = float(np.median(f[max(at - 1, 0) : at + 2]))
    pull = level - low
    return Pull(pull, float(d[at]), noise) if pull > max(_CLEAR * noise, 0.0) else None


class Parting(NamedTuple):
    """Last rupture of a retract and energy lost in the cycle, from `find_parting`.

    Examples
    --------
    >>> approach, retract = np.linspace(-5e-7, 1e-7, 121), np.linspace(1e-7, -5e-7, 121)
    >>> pushed, pulled = np.maximum(approach, 0.0) * 1e-2, np.where(retract > -1e-7, retract * 1e-2, 0.0)
    >>> parting = mdr.instruments.find_parting(np.concatenate([approach, retract]), np.concatenate([pushed, pulled]))
    >>> print(f"{parting.rupture_depth * 1e9:.0f} {parting.energy:.2e}")
    -95 4.75e-17
    """

    rupture_depth: float
    """depth at which the force last rises from below the noise of the baseline [length]"""
    energy: float
    """energy lost in the cycle, the area between approach and retract [force length]"""


def find_parting(depth: ArrayLike, force: ArrayLike) -> Parting | None:
    """Find the last rupture and the energy lost of a cycle of approach and retract.

    Parameters
    ----------
    depth : array_like
        Depths of the cycle in the order of time, both branches from the baseline on [length].
    force : array_like
        Forces, as many [force]. The cycle turns at the largest force. The zero of each branch is the median of its farthest
        readings.

    Returns
    -------
    Parting or None
        Rupture and energy; None if the retract does not pull more than five times the noise, or a branch has fewer than 20 points.

    Raises
    ------
    InvalidArgumentError
        The columns differ in length, or depth or force is constant.

    Examples
    --------
    >>> approach, retract = np.linspace(-5e-7, 1e-7, 121), np.linspace(1e-7, -5e-7, 121)
    >>> pushed, pulled = np.maximum(approach, 0.0) * 1e-2, np.where(retract > -1e-7, retract * 1e-2, 0.0)
    >>> parting = mdr.instruments.find_parting(np.concatenate([approach, retract]), np.concatenate([pushed, pulled]))
    >>> print(f"{parting.energy:.2e}")
    4.75e-17
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
