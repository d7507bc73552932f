# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of a measured curve: loading, holds, unloading, drift and pop-ins."""

from __future__ import annotations

import math
from collections.abc import Iterable
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..._boundary import number, numbers
from ...errors import InvalidArgumentError

Array = NDArray[np.float64]

_SHORTEST, _LONGEST = 200, 25
"""Rates are those over these parts of the points to either side: the longer, the more noise there is."""
_STILL = 0.15
"""A curve that moves slower than this part of its usual rate is held."""
_TURN, _TOGETHER = 10.0, 3.0
"""Standard deviations of the noise: a curve that goes back by more turns, and depth and force each by so much."""
_MOVES = 0.3
"""Fraction of the whole depth or height below which a segment of a file is a hold."""
_LEVEL, _SAME, _CREEP = 0.02, 0.05, 0.3
"""Of the rise of the force: what is above the noise of zero; of that level, or of the depth: what is held; of the depth: what a
hold of the force may creep."""
_FEWEST_RIPPLES, _PROGRESS = 2, 0.25
"""A hold wanders where so many small ways in a row, each of less than _SAME of the force, go on by less than this part of their
ways."""
_HARDLY = 1.5
_UNCLEAR = 3.0
"""Times the noise of a rate: slower is not told from still."""
_JUMP = 5.0
"""A pop-in is a step this much larger than its neighbours ..."""
_LARGE_JUMP = 0.01
"""... and at least this part of the depth."""
_NEIGHBOURS, _STAYS = 10, 0.5
_LOADED = 5.0
"""Standard deviations of the noise by which the force is clear of that without contact."""
_FAR, _FAR_STEPS, _FAR_NOISE = 0.02, 5.0, 10.0
"""A stray reading is this part of the range away from both neighbours, as many of their steps, and of the noise."""


class Segment(NamedTuple):
    """Part of a curve, from `find_segments`.

    Examples
    --------
    >>> depth = np.concatenate([np.linspace(0.0, 1e-7, 100), np.linspace(1e-7, 5e-8, 100)])
    >>> force = np.concatenate([np.linspace(0.0, 1e-3, 100), np.linspace(1e-3, 0.0, 100)])
    >>> segment = mdr.instruments.find_segments(depth, force)[0]
    >>> print(segment.kind, segment.points)
    loading slice(0, 101, None)
    """

    kind: str
    """"loading" (approach), "hold" or "unloading" (retract)"""
    start: int
    """position of the first point"""
    stop: int
    """position after the last point"""

    @property
    def points(self) -> slice:
        """The segment as a slice of the arrays."""
        return slice(self.start, self.stop)


class PopIn(NamedTuple):
    """Jump in depth at constant load, or in load at constant depth.

    `find_pop_in` returns it.

    Examples
    --------
    >>> depth = np.linspace(0.0, 100e-9, 100) + np.where(np.arange(100) >= 50, 30e-9, 0.0)
    >>> pop_in = mdr.instruments.find_pop_in(depth, np.linspace(0.0, 1e-3, 100))
    >>> print(pop_in.position, f"{pop_in.jump * 1e9:.1f}")
    49 33.0
    """

    position: int
    """position of the last point before the jump"""
    depth: float
    """depth at this point [length]"""
    force: float
    """force at this point [force]"""
    jump: float
    """jump of the depth [length]"""


class Drift(NamedTuple):
    """Thermal drift, from `drift_rate`.

    Examples
    --------
    >>> time = np.linspace(0.0, 60.0, 61)
    >>> drift = mdr.instruments.drift_rate(time, 50e-9 + 0.05e-9 * time)
    >>> print(f"{drift.rate * 1e9:.3f}")
    0.050
    """

    rate: float
    """slope of the depth against time during a hold [length/time]"""
    standard_error: float
    """standard error of the rate [length/time]"""


def curve(depth: ArrayLike, force: ArrayLike, fewest: int = 2) -> tuple[Array, Array]:
    """Depth and force of one curve, checked."""
    d, f = numbers("depth", depth), numbers("force", force)
    if d.ndim != 1 or d.shape != f.shape:
        raise InvalidArgumentError(
            f"depth and force have the shapes {d.shape} and {f.shape}: they must be two columns of one length"
        )
    if not (np.isfinite(d).all() and np.isfinite(f).all()):
        raise InvalidArgumentError("depth and force: they must be finite")
    if len(d) < fewest:
        raise InvalidArgumentError(f"too few points: {len(d)}; at least {fewest} are needed")
    if np.ptp(d) == 0.0 or np.ptp(f) == 0.0:
        raise InvalidArgumentError("depth or force is the same at all points: that is no curve")
    return d, f


class Segmentation(NamedTuple):
    """Segments found from readings, and their reliability, from `segmentation`.

    Examples
    --------
    >>> depth = np.concatenate([np.linspace(0.0, 1e-7, 100), np.linspace(1e-7, 5e-8, 100)])
    >>> force = np.concatenate([np.linspace(0.0, 1e-3, 100), np.linspace(1e-3, 0.0, 100)])
    >>> found = mdr.instruments.segmentation(depth, force)
    >>> print([segment.kind for segment in found.segments], found.unsure)
    ['loading', 'unloading'] []
    """

    segments: list[Segment]
    """the segments in the order of measurement"""
    noise: tuple[float, float]
    """standard deviations of depth and force from reading to reading [length], [force]"""
    unsure: list[int]
    """positions in `segments` of those that move less than twice the threshold of a turn"""


def find_segments(depth: ArrayLike, force: ArrayLike) -> list[Segment]:
    """Find loading, holds and unloading in the order of measurement.

    Parameters
    ----------
    depth : array_like
        Depths in the order of measurement [length].
    force : array_like
        Forces, as many [force].

    Returns
    -------
    list of Segment
        The segments; see `segmentation` for their reliability.

    Raises
    ------
    InvalidArgumentError
        There are too few points, or depth or force is constant.

    Examples
    --------
    >>> depth = np.concatenate([np.linspace(0.0, 1e-7, 100), np.full(50, 1e-7), np.linspace(1e-7, 5e-8, 100)])
    >>> force = np.concatenate([np.linspace(0.0, 1e-3, 100), np.full(50, 1e-3), np.linspace(1e-3, 0.0, 100)])
    >>> print([segment.kind for segment in mdr.instruments.find_segments(depth, force)])
    ['loading', 'hold', 'unloading']
    """
    return segmentation(depth, force).segments


def segmentation(depth: ArrayLike, force: ArrayLike) -> Segmentation:
    """Find loading, holds and unloading, cycles of any size, with their reliability.

    Parameters
    ----------
    depth : array_like
        Depths in the order of measurement [length].
    force : array_like
        Forces, as many [force].

    Returns
    -------
    Segmentation
        Segments, noise and unreliable segments.

    Raises
    ------
    InvalidArgumentError
        There are too few points, or depth or force is constant.

    Notes
    -----
    The noise from reading to reading follows from second differences. The curve turns where depth and force, relative to their
    ranges, together go back by 10 standard deviations of their sum; both must go the same way, and for more points than a jump. Two
    or more ways in a row, each of less than 5 % of the force, without progress are a hold that wanders. Between turns a point
    belongs to a hold if depth and force each change by less than 15 % of their usual rate in that part, or by no more than the
    errors that neighbouring readings share, at an almost constant force or depth.

    Examples
    --------
    >>> depth = np.concatenate([np.linspace(0.0, 1e-7, 100), np.linspace(1e-7, 5e-8, 100)])
    >>> force = np.concatenate([np.linspace(0.0, 1e-3, 100), np.linspace(1e-3, 0.0, 100)])
    >>> found = mdr.instruments.segmentation(depth, force)
    >>> print([(segment.kind, segment.start, segment.stop) for segment in found.segments])
    [('loading', 0, 101), ('unloading', 101, 200)]
    """
    d, f = curve(depth, force, fewest=3)
    noise = _noise(d), _noise(f)
    turns, wandering = _turns(d, f)
    parts: list[Segment] = []
    for start, stop in pairwise(turns):
        parts += _moves_and_holds(d, f, start, stop)
    parts = _with_holds(parts, wandering)
    limit = 2.0 * _TURN * _noise(d / np.ptp(d) + f / np.ptp(f))

    def is_small(part: Segment) -> bool:
        """Whether a part of the curve goes hardly further than noise does."""
        way = float(np.ptp(d[part.points]) / np.ptp(d) + np.ptp(f[part.points]) / np.ptp(f))
        return part.kind != "hold" and way < limit

    found = joined(parts)
    # between two holds it is a ripple of one; next to one, of a few points or at one force, a part of it
    kinds, few = ["", *(s.kind for s in found), ""], max(2, len(d) // _SHORTEST) + 1
    holds = [(kinds[i] == "hold") + (kinds[i + 2] == "hold") for i in range(len(found))]
    inside = [
        is_small(s) and (beside == 2 or beside == 1 and (s.stop - s.start <= few or _is_at_one_force(f, s)))
        for s, beside in zip(found, holds, strict=True)
    ]
    found = joined([s._replace(kind="hold") if still else s for s, still in zip(found, inside, strict=True)])
    found = _without_ripples(d, f, found)
    return Segmentation(found, noise, [i for i, s in enumerate(found) if is_small(s)])


def kind_of_way(way: float, whole: float) -> str:
    """Kind of a segment whose depth or height changes by `way`, in a record where it changes by `whole`."""
    return "hold" if abs(way) < _MOVES * whole else "loading" if way > 0.0 else "unloading"


def segments_of_numbers(numbers: NDArray[Any], depth: Array) -> tuple[Segment, ...] | None:
    """Segments that a file counts, one number for each reading; None where it counts one."""
    ends = [0, *(np.flatnonzero(np.diff(numbers)) + 1).tolist(), len(numbers)]
    whole = float(np.ptp(depth)) if len(depth) else 0.0
    kinds = [kind_of_way(float(depth[b - 1] - depth[a]), whole) for a, b in pairwise(ends) if b > a]
    return tuple(Segment(kind, a, b) for kind, (a, b) in zip(kinds, pairwise(ends), strict=True)) if len(kinds) > 1 else None


def _turns(d: Array, f: Array) -> tuple[list[int], list[tuple[int, int]]]:
    """First point, the points where the curve turns, and the one past the last; and where it wanders about one level."""
    s = d / np.ptp(d) + f / np.ptp(f)
    n = len(s)
    ends = _zigzag(s, _TURN * _noise(s))
    shortest = max(2, n // _SHORTEST) + 1
    least = _TOGETHER * _noise(d), _TOGETHER * _noise(f)
    while len(ends) > 2:
        legs = list(pairwise(ends))
        ways = np.array([abs(s[b] - s[a]) for a, b in legs])
        false = [i for i, (a, b) in enumerate(legs) if b - a < shortest or not _is_together(d, f, a, b, least)]
        if not false:
            break
        worst = min(false, key=lambda i: float(ways[i]))
        # without a leg its neighbours are one; the first and the last have one neighbour
        drop = {worst, worst + 1} - {0, len(ends) - 1} if 0 < worst < len(legs) - 1 else {1 if worst == 0 else len(ends) - 2}
        ends = [e for i, e in enumerate(ends) if i not in drop]
    ends, wandering = _without_wander(d, f, ends)
    return [0, *(e + 1 for e in ends[1:-1]), n], wandering


def _without_wander(d: Array, f: Array, ends: list[int]) -> tuple[list[int], list[tuple[int, int]]]:
    """The turns but for those of holds that wander, and these holds."""
    level = (f[ends] - f.min()) / np.ptp(f)
    small = np.abs(np.diff(level)) < np.minimum(_SAME, _CREEP * np.maximum(level[1:], level[:-1]))
    small &= np.abs(np.diff(d[ends])) < _SAME * np.ptp(d)
    s = d / np.ptp(d) + f / np.ptp(f)
    kept, holds = [*ends], list[tuple[int, int]]()
    for is_small, a, b in _runs(small.astype(np.int64)):
        inside = ends[a : b + 1]
        progress = abs(float(s[inside[-1]] - s[inside[0]]))
        if not is_small or b - a < _FEWEST_RIPPLES or progress > _PROGRESS * float(np.abs(np.diff(s[inside])).sum()):
            continue
        holds.append((inside[0], inside[-1]))
        # one turn stays where the way before and the way behind go against each other
        turns_there = a > 0 and b < len(ends) - 1 and (b - a) % 2 == 0
        kept = [e for e in kept if e in (0, len(s) - 1) or e not in inside or turns_there and e == inside[-1]]
    return kept, holds


def _is_together(d: Array, f: Array, a: int, b: int, least: tuple[float, float]) -> bool:
    """Whether depth and force go the same way between two readings, both by more than their noise: from one to the other, and, for
    they are the outermost of many, in the mean of their neighbours."""
    near = max(1, min(_NEIGHBOURS, len(d) // _SHORTEST, (b - a + 1) // 2))
    ways = []
    for v, noise in zip((d, f), least, strict=True):
        way, of_means = float(v[b] - v[a]), float(v[b - near + 1 : b + 1].mean() - v[a : a + near].mean())
        if way * of_means <= 0.0 or abs(way) <= noise or abs(of_means) <= noise / math.sqrt(near):
            return False
        ways.append(way)
    return ways[0] * ways[1] > 0.0


def _with_holds(parts: list[Segment], holds: list[tuple[int, int]]) -> list[Segment]:
    """The parts, with holds in their place."""
    for a, b in holds:
        cut: list[Segment] = []
        for part in parts:
            before, behind = part._replace(stop=min(part.stop, a)), part._replace(start=max(part.start, b))
            inside = Segment("hold", max(part.start, a), min(part.stop, b))
            cut += [one for one in (before, inside, behind) if one.stop > one.start]
        parts = cut
    return parts


def _without_ripples(d: Array, f: Array, parts: list[Segment]) -> list[Segment]:
    """The parts; what lies between two holds of one level, or next to a hold, and goes no further than the hold does is part of
    it."""
    found: list[Segment] = []
    for part in parts:
        before = next((i for i in reversed(range(len(found))) if found[i].kind == "hold"), None)
        if part.kind == "hold" and before is not None and _is_one_level(d, f, found[before], part):
            part, found = found[before]._replace(stop=part.stop), found[:before]
        found.append(part)
    still = [
        any(one.kind == "hold" and _goes_no_further(d, f, part, one) for one in found[max(i - 1, 0) : i + 2])
        for i, part in enumerate(found)
    ]
    return joined([part._replace(kind="hold") if held else part for part, held in zip(found, still, strict=True)])


def _is_one_level(d: Array, f: Array, one: Segment, other: Segment) -> bool:
    """Whether the way between two holds is no longer than those within them, in depth and force."""
    between = Segment("", one.stop, other.start)
    longer = max(one, other, key=lambda hold: float(np.ptp(f[hold.points])))
    steps = [abs(float(np.median(v[other.points]) - np.median(v[one.points]))) for v in (d, f)]
    own = [max(float(np.ptp(v[hold.points])) for hold in (one, other)) for v in (d, f)]
    return all(step <= most for step, most in zip(steps, own, strict=True)) and _goes_no_further(d, f, between, longer)


def _goes_no_further(d: Array, f: Array, part: Segment, hold: Segment) -> bool:
    """Whether depth and force go hardly further in a part than in a hold."""
    return all(float(np.ptp(v[part.points])) <= _HARDLY * float(np.ptp(v[hold.points])) for v in (d, f) if part.stop > part.start)


def _zigzag(s: Array, least: float) -> list[int]:
    """First reading, the highest and lowest readings between which `s` goes by more than `least`, and the last one."""
    ends = [0]
    high = low = 0
    direction = 0
    for i in range(1, len(s)):
        high, low = (i if s[i] >= s[high] else high), (i if s[i] <= s[low] else low)
        if direction >= 0 and s[high] - s[i] > least:
            if high > ends[-1]:
                ends.append(high)
            direction, low, high = -1, i, i
        elif direction <= 0 and s[i] - s[low] > least:
            if low > ends[-1]:
                ends.append(low)
            direction, low, high = 1, i, i
    return [*ends, len(s) - 1]


def _moves_and_holds(d: Array, f: Array, start: int, stop: int) -> list[Segment]:
    """One way between two turns: the holds in it, and the rest as loading or unloading."""
    h, p = d[start:stop], f[start:stop]
    n, ranges = len(h), [float(np.ptp(v)) for v in (d[start:stop], f[start:stop])]
    if n < 2 or not all(ranges):
        return [Segment("hold", start, stop)]
    kind = "loading" if (h[-1] - h[0]) / ranges[0] + (p[-1] - p[0]) / ranges[1] > 0.0 else "unloading"
    # the noise of a rate is to be a tenth of what counts as still
    noise = max(_noise(v) / r for v, r in zip((h, p), ranges, strict=True))
    reach = max(2, n // _SHORTEST, min(n // _LONGEST, round(7.0 * noise * n)))
    i = np.arange(n)
    first, last = np.maximum(i - reach, 0), np.minimum(i + reach, n - 1)
    still_both = np.ones(n, dtype=bool)
    for v in (h, p):
        speed = np.abs(v[last] - v[first]) / (last - first)
        # the speed at which half of the way is passed: long holds do not count
        order = np.argsort(speed)
        way = np.cumsum(speed[order])
        unclear = _UNCLEAR * math.sqrt(2.0) * _noise(v, reach) / (2 * reach)
        still_both &= speed < max(_STILL * speed[order][np.searchsorted(way, 0.5 * way[-1])], unclear)
    held = np.zeros(n, dtype=bool)
    for still, a, b in _runs(still_both.astype(np.int64)):
        if still and b - a >= 3 * reach and _is_held(h, p, a, b, f, _noise(p, reach)):
            held[a:b] = True
    return [Segment("hold" if still else kind, start + a, start + b) for still, a, b in _runs(held.astype(np.int64))]


def _is_held(h: Array, p: Array, a: int, b: int, force: Array, noise: float) -> bool:
    """Whether force or depth stay the same between two readings: a loading that begins slowly is no hold."""
    rise = float(np.ptp(force))
    level = abs(float(np.median(p[a:b])) - float(force.min()))
    if level > _LEVEL * rise:
        is_steady = np.ptp(p[a:b]) < _SAME * level + 6.0 * noise and np.ptp(h[a:b]) < _CREEP * np.ptp(h)
        return bool(is_steady or np.ptp(h[a:b]) < _SAME * np.ptp(h))
    return bool(np.ptp(h[a:b]) < 1e-3 * np.ptp(h) + 10.0 * _noise(h))


def _is_at_one_force(f: Array, part: Segment) -> bool:
    level = abs(float(np.median(f[part.points]) - f.min()))
    return float(np.ptp(f[part.points])) < _LEVEL * level + 6.0 * _noise(f)


def joined(parts: Iterable[Segment]) -> list[Segment]:
    """Neighbours of one kind as one segment."""
    found: list[Segment] = []
    for part in parts:
        if found and found[-1].kind == part.kind:
            found[-1] = found[-1]._replace(stop=part.stop)
        else:
            found.append(part)
    return found


def _noise(values: Array, lag: int = 1) -> float:
    """Standard deviation of the readings, from second differences over `lag` readings, which slopes do not enter."""
    if len(values) <= 4 * lag:
        return 0.0
    return float(np.median(np.abs(values[2 * lag :] - 2.0 * values[lag:-lag] + values[: -2 * lag]))) / (0.6745 * math.sqrt(6.0))


def find_strays(values: ArrayLike, *, ends: bool = False) -> NDArray[np.intp]:
    """Find single readings that lie far from both neighbours.

    Parameters
    ----------
    values : array_like
        Readings in the order of measurement.
    ends : bool, optional
        True also searches the first two and the last two readings, of a quantity that does not begin or end with a step.

    Returns
    -------
    ndarray
        Positions of the readings.

    Raises
    ------
    ArgumentTypeError
        The readings are not numbers.

    Examples
    --------
    >>> values = np.linspace(0.0, 1.0, 50)
    >>> values[20] = 5.0
    >>> print(mdr.instruments.find_strays(values))
    [20]
    """
    v = numbers("values", values)
    if len(v) < 5:
        return np.zeros(0, dtype=np.intp)
    away = v[1:-1] - np.median([v[:-2], v[1:-1], v[2:]], axis=0)
    step = np.abs(np.diff(v))
    usual = np.maximum(np.concatenate([[0.0], step[:-2]]), np.concatenate([step[2:], [0.0]]))
    far = np.zeros(len(v), dtype=bool)
    far[1:-1] = np.abs(away) > np.maximum(_far(v), _FAR_STEPS * usual)
    for first, inner in ((0, v[1:]), (-1, v[-2::-1])):
        far[first] = abs(v[first] - inner[0]) > max(_far(inner), _FAR_STEPS * float(np.abs(np.diff(inner[:_NEIGHBOURS])).max()))
    if not ends:
        far[[0, 1, -2, -1]] = False
    return np.flatnonzero(far)


def _far(values: Array) -> float:
    """Smallest distance of a stray reading from its neighbours."""
    return max(_FAR * float(np.ptp(values)), _FAR_NOISE * _noise(values))


def _runs(state: NDArray[np.int64]) -> list[tuple[int, int, int]]:
    ends = [0, *(np.flatnonzero(np.diff(state)) + 1).tolist(), len(state)]
    return [(int(state[a]), a, b) for a, b in pairwise(ends)]


def drift_rate(time: ArrayLike, depth: ArrayLike) -> Drift:
    """Fit the thermal drift during a hold at small load.

    It is the slope of the depth against time over the last 80 % of the hold.

    Parameters
    ----------
    time : array_like
        Times of the hold, at least 5 [time].
    depth : array_like
        Depths, as many [length].

    Returns
    -------
    Drift
        Rate and standard error, which includes the correlation of neighbouring readings.

    Raises
    ------
    InvalidArgumentError
        There are too few points, or the time or the depth is constant.

    References
    ----------
    oliver-1992
    bartlett-1935

    Examples
    --------
    >>> time = np.linspace(0.0, 60.0, 61)
    >>> noise = 0.1e-9 * np.random.default_rng(1).standard_normal(61)
    >>> drift = mdr.instruments.drift_rate(time, 50e-9 + 0.05e-9 * time + noise)
    >>> print(f"{drift.rate * 1e9:.3f} {drift.standard_error * 1e9:.3f}")
    0.050 0.001
    """
    t, d = curve(time, depth, fewest=5)
    t, d = t[len(t) // 5 :], d[len(d) // 5 :]
    if np.ptp(t) == 0.0:
        raise InvalidArgumentError("time is the same at all points of the hold: it determines no rate")
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
    """Return the depths without a drift that began with the first reading.

    Parameters
    ----------
    time : array_like
        Times [time].
    depth : array_like
        Depths [length].
    rate : float
        Drift rate [length/time].

    Returns
    -------
    ndarray
        depth - rate (time - time[0]) [length].

    Raises
    ------
    ArgumentTypeError
        An argument is not numeric.

    Examples
    --------
    >>> print(mdr.instruments.without_drift([0.0, 10.0], [50e-9, 51e-9], 0.05e-9))
    [5.00e-08 5.05e-08]
    """
    t, d = numbers("time", time), numbers("depth", depth)
    return np.asarray(d - number("rate", rate) * (t - t[0]))


def find_pop_in(depth: ArrayLike, force: ArrayLike) -> PopIn | None:
    """Find the first pop-in of a loading curve; before it the contact was elastic.

    A pop-in is a step of the depth 5 times larger than those around it and at least 1 % of the largest depth, at a force that does
    not grow faster than before. It must last: the ten readings after it are deeper than the ten before it by at least half of the
    step.

    Parameters
    ----------
    depth : array_like
        Depths in the order of measurement [length].
    force : array_like
        Forces, as many [force].

    Returns
    -------
    PopIn or None
        The pop-in; None if there is none.

    Raises
    ------
    InvalidArgumentError
        The columns differ in length, or depth or force is constant.

    Examples
    --------
    >>> depth = np.linspace(0.0, 100e-9, 100)
    >>> print(mdr.instruments.find_pop_in(depth, depth**1.5))
    None
    """
    d, f = curve(depth, force)
    if len(d) < 2 * _NEIGHBOURS:
        return None
    level, clear = float(np.median(f[:_NEIGHBOURS])), _LOADED * _noise(f)
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
        behind = d[i + 3 : i + 3 + _NEIGHBOURS]
        if behind.min() - d[max(0, onset + 1 - _NEIGHBOURS) : onset + 1].max() < _STAYS * wide[i]:
            continue
        if np.sum(rise[i : i + 3]) > 3.0 * max(3.0 * float(np.median(rise[before])), 0.0) + 0.01 * np.ptp(f):
            continue
        is_loaded = np.median(f[before]) > level + clear and np.median(f[i + 3 : i + 6]) > level - clear
        if not is_loaded:
            continue
        return PopIn(onset, float(d[onset]), float(f[onset]), float(wide[i]))
    return None
