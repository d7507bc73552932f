# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a measured curve: loading, holds and unloading, thermal drift, pop-ins."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._boundary import number, numbers
from ..errors import InvalidArgumentError

Array = NDArray[np.float64]

_SHORTEST, _LONGEST = 200, 25
"""Rates are those over these parts of the points to either side: the longer, the more noise there is."""
_STILL = 0.15
"""A curve that moves slower than this part of its usual rate is held."""
_JUMP = 5.0
"""A pop-in is a step this much larger than its neighbours ..."""
_LARGE_JUMP = 0.01
"""... and at least this part of the depth."""
_NEIGHBOURS = 10
_FAR, _FAR_STEPS, _FAR_NOISE = 0.02, 5.0, 10.0
"""A stray reading is this part of the range away from both neighbours, as many of their steps, and of the noise."""


class Segment(NamedTuple):
    """A part of a curve: "loading" (approach), "hold" or "unloading" (retract), and its points start ... stop - 1."""

    kind: str
    start: int
    stop: int

    @property
    def points(self) -> slice:
        """Its place in the arrays."""
        return slice(self.start, self.stop)


class PopIn(NamedTuple):
    """A jump in depth at constant load, or in load at constant depth: the last point before it, and what stands there."""

    position: int
    depth: float
    force: float
    jump: float
    """of the depth"""


class Drift(NamedTuple):
    """Thermal drift: slope of the depth against time during a hold, and its standard error."""

    rate: float
    standard_error: float


def curve(depth: ArrayLike, force: ArrayLike, fewest: int = 2) -> tuple[Array, Array]:
    """Depth and force of one curve, checked."""
    d, f = numbers("depth", depth), numbers("force", force)
    if d.ndim != 1 or d.shape != f.shape:
        raise InvalidArgumentError(
            f"depth and force have the shapes {d.shape} and {f.shape}: they must be two columns of one length"
        )
    if not (np.isfinite(d).all() and np.isfinite(f).all()):
        raise InvalidArgumentError("depth and force are not allowed: they must be finite")
    if len(d) < fewest:
        raise InvalidArgumentError(f"too few points: {len(d)}; at least {fewest} are needed")
    if np.ptp(d) == 0.0 or np.ptp(f) == 0.0:
        raise InvalidArgumentError("depth or force is the same at all points: that is no curve")
    return d, f


def find_segments(depth: ArrayLike, force: ArrayLike) -> list[Segment]:
    """Loading, holds and unloading in the order in which they were measured.

    A point belongs to a hold where depth and force, as parts of their ranges, change by less than 15 % of the rate at which the
    curve is usually passed through; holds of a few points only are turns.
    """
    d, f = curve(depth, force, fewest=3)
    n = len(d)
    # the noise of a rate is to be a tenth of what counts as still
    noise = max(_noise(v) / float(np.ptp(v)) for v in (d, f))
    reach = max(2, n // _SHORTEST, min(n // _LONGEST, round(7.0 * noise * n)))
    i = np.arange(n)
    first, last = np.maximum(i - reach, 0), np.minimum(i + reach, n - 1)
    rates = np.array([(v[last] - v[first]) / (np.ptp(v) * (last - first)) for v in (d, f)])
    speed = np.hypot(*rates)
    # the speed at which half of the way is passed: long holds do not count
    order = np.argsort(speed)
    way = np.cumsum(speed[order])
    usual = speed[order][np.searchsorted(way, 0.5 * way[-1])]
    state = np.where(speed < _STILL * usual, 0, np.where(rates.sum(axis=0) > 0.0, 1, -1))
    runs = _runs(state)
    shortest = 3 * reach
    kept = [run for run in runs if run[2] - run[1] >= (shortest if run[0] == 0 else reach + 1)] or [
        max(runs, key=lambda r: r[2] - r[1])
    ]
    joined: list[list[int]] = []
    for kind, start, stop in kept:
        if joined and joined[-1][0] == kind:
            joined[-1][2] = stop
        else:
            joined.append([kind, start, stop])
    joined[0][1], joined[-1][2] = 0, n
    for one, other in pairwise(joined):
        between = slice(one[1], other[2])
        middle = (one[2] + other[1]) // 2
        if one[0] * other[0] < 0:
            # a turn lies where the curve is highest or lowest
            sum_of = d[between] / np.ptp(d) + f[between] / np.ptp(f)
            middle = between.start + int(np.argmax(one[0] * sum_of)) + 1
        one[2] = other[1] = min(max(middle, one[1] + 1), other[2] - 1)
    names = {1: "loading", 0: "hold", -1: "unloading"}
    return [Segment(names[kind], start, stop) for kind, start, stop in joined]


def _noise(values: Array) -> float:
    """Standard deviation of the readings, from second differences, which slopes do not enter."""
    return float(np.median(np.abs(np.diff(values, 2)))) / (0.6745 * math.sqrt(6.0)) if len(values) > 4 else 0.0


def find_strays(values: ArrayLike) -> NDArray[np.intp]:
    """Positions of single readings that lie far from both of their neighbours: where a curve jumps away and back at once."""
    v = numbers("values", values)
    if len(v) < 5:
        return np.zeros(0, dtype=np.intp)
    away = v[2:-2] - np.median([v[1:-3], v[2:-2], v[3:-1]], axis=0)
    step = np.abs(np.diff(v))
    usual = np.maximum(step[:-3], step[3:])
    least = np.maximum(max(_FAR * float(np.ptp(v)), _FAR_NOISE * _noise(v)), _FAR_STEPS * usual)
    return np.flatnonzero(np.abs(away) > least) + 2


def _runs(state: NDArray[np.int64]) -> list[tuple[int, int, int]]:
    ends = [0, *(np.flatnonzero(np.diff(state)) + 1).tolist(), len(state)]
    return [(int(state[a]), a, b) for a, b in pairwise(ends)]


def drift_rate(time: ArrayLike, depth: ArrayLike) -> Drift:
    """The thermal drift during a hold at small load: slope of the depth against time over its last 80 % (Oliver and Pharr 1992).
    The standard error allows for neighbouring readings that share their errors (effective number of points, see
    `effective_points`)."""
    t, d = curve(time, depth, fewest=5)
    t, d = t[len(t) // 5 :], d[len(d) // 5 :]
    if np.ptp(t) == 0.0:
        raise InvalidArgumentError("time is the same at all points of the hold: it says no rate")
    design = np.column_stack([np.ones_like(t), t - t.mean()])
    (_, rate), *_ = np.linalg.lstsq(design, d, rcond=None)
    left = d - d.mean() - rate * design[:, 1]
    n = effective_points(left)
    sd = math.sqrt(float(left @ left) / max(n - 2.0, 1.0) / len(left) * n)
    error = sd / math.sqrt(float(design[:, 1] @ design[:, 1])) * math.sqrt(len(left) / n)
    return Drift(float(rate), error)


def effective_points(residuals: ArrayLike) -> float:
    """How many independent readings residuals with the lag-1 correlation rho are worth: n (1 - rho)/(1 + rho) (Bartlett 1935), rho
    freed of the bias that few points give it, (1 + 4 rho)/n; at least 3."""
    r = np.asarray(residuals, dtype=float)
    total = float(r @ r)
    if len(r) < 4 or total == 0.0:
        return float(len(r))
    rho = float(r[1:] @ r[:-1]) / total
    rho = min(max(rho + (1.0 + 4.0 * rho) / len(r), 0.0), 0.99)
    return max(len(r) * (1.0 - rho) / (1.0 + rho), 3.0)


def without_drift(time: ArrayLike, depth: ArrayLike, rate: float) -> Array:
    """The depths freed of a drift that began with the first reading."""
    t, d = numbers("time", time), numbers("depth", depth)
    return np.asarray(d - number("rate", rate) * (t - t[0]))


def find_pop_in(depth: ArrayLike, force: ArrayLike) -> PopIn | None:
    """The first pop-in of a loading curve, None without one; up to there the contact was elastic.

    It is a step of the depth 5 times larger than those about it and at least 1 % of the largest depth, at a force that does not
    grow faster than before.
    """
    d, f = curve(depth, force)
    if len(d) < 2 * _NEIGHBOURS:
        return None
    step, rise = np.diff(d), np.diff(f)
    # a fast jump is a few points wide
    wide = d[3:] - d[:-3]
    for i in range(_NEIGHBOURS, len(wide) - 1):
        before = slice(max(0, i - _NEIGHBOURS), i)
        usual = float(np.median(wide[before]))
        noise = float(np.median(np.abs(step[before] - np.median(step[before])))) * 1.4826
        if wide[i] < max(_LARGE_JUMP * np.ptp(d), _JUMP * abs(usual), 6.0 * noise):
            continue
        onset = i + int(np.argmax(step[i : i + 3]))
        if np.sum(rise[i : i + 3]) > 3.0 * max(3.0 * float(np.median(rise[before])), 0.0) + 0.01 * np.ptp(f):
            continue
        return PopIn(onset, float(d[onset]), float(f[onset]), float(wide[i]))
    return None
