# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured data of viscoelastic bodies, one class for each kind."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from ... import _layout
from ..._boundary import number, numbers
from ...errors import InvalidArgumentError
from .data import Array, Data, column_of

_NOISE = 3.0
"""Standard deviations of the depth readings within which they turn."""
_MOST_CORNERS, _ROUNDS, _FEWEST = 200, 3, 5
"""Corners of a path: largest number, rounds of adjustment, fewest readings for a straight piece."""
_ROUGH = 0.03
"""Readings this far off a path, as a part of its range, are of another path."""


class _InTime(Data):
    """Against times, which ascend."""

    def _check_order(self) -> None:
        back = np.flatnonzero(np.diff(self.x) <= 0.0)
        if len(back):
            raise InvalidArgumentError(f"entry {back[0] + 2} of time = {self.x[back[0] + 1]:.7g}: times must ascend")

    def _follow_path(self) -> tuple[float, float]:
        """Replace prescribed readings whose noise goes back and forth by straight pieces; the distance of the pieces from the
        readings (root mean square), and that as a part of their range. Readings of another kind of path are left as they are."""
        assert self.given is not None
        path = _rise_and_fall(self.x, self.given)
        off = float(np.sqrt(np.mean((path - self.given) ** 2))) if len(path) else 0.0
        if off == 0.0:
            return 0.0, 0.0
        span = float(np.ptp(path))
        share = off / span if span > 0.0 else np.inf
        if share <= _ROUGH:
            self.given = path
            self.warnings.append(
                f"the {self.given_name} readings go back and forth: a path of straight pieces, {off:.2g} (root mean square) from "
                f"them, {100.0 * share:.2g} % of its range, is used"
            )
        return off, share


class ForceTime(_InTime):
    """Measured force against time of a viscoelastic body at a prescribed depth.

    The test is approach, hold and retract, or a relaxation test.

    Parameters
    ----------
    time : array_like
        Ascending times [time].
    depth : array_like
        Depth without the deflection of a cantilever [length]. It rises to one largest value, may be held there, and falls, linear
        in between. Readings whose noise goes back and forth are replaced by straight pieces; the standard errors do not include the
        error of these.
    force : array_like
        Forces [modulus length^2].
    sd : float or array_like, optional
        Standard deviation of the force, as in `ForceDepth` [modulus length^2].
    relative_sd : float, optional
        As in `ForceDepth` [1].
    missing : {"raise", "drop"}, optional
        As in `ForceDepth`.

    Raises
    ------
    InvalidArgumentError
        The times do not ascend, or the depth does not rise to one largest value and fall.

    Examples
    --------
    >>> polymer = mdr.Viscoelastic(1e6, [(9e6, 1.0)], nu=0.5)
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(polymer))
    >>> time = np.linspace(0.0, 5.0, 40)
    >>> path = contact.history(time, depth=np.minimum(time, 1.0) * 1e-6)
    >>> data = mdr.instruments.ForceTime(time, path.depth, path.force)
    >>> start = mdr.Homogeneous(mdr.Viscoelastic(2e6, [(5e6, 1.0)], nu=0.5))
    >>> result = mdr.instruments.fit(data, mdr.Paraboloid(10e-6), start, ["relaxed_shear_modulus", "terms[0].modulus"])
    >>> print(f"{result.estimates['relaxed_shear_modulus'] / 1e6:.3f} {result.estimates['terms[0].modulus'] / 1e6:.3f}")
    1.000 9.000
    """

    code, x_name, y_name, given_name = _layout.FIT_FORCE_TIME, "time", "force", "depth"

    def __init__(
        self,
        time: ArrayLike,
        depth: ArrayLike,
        force: ArrayLike,
        *,
        sd: ArrayLike | None = None,
        relative_sd: float | None = None,
        missing: str = "raise",
    ) -> None:
        super().__init__(time, force, depth, sd, relative_sd, missing)
        off, share = self._follow_path()
        if share > _ROUGH:
            raise InvalidArgumentError(
                f"depth: it must rise to one largest value and fall; the closest such path is {off:.3g} from the "
                "readings. Give the path that was prescribed, or a part of the record"
            )


class DepthTime(_InTime):
    """Measured depth against time of a viscoelastic body under a given force.

    The test is a creep test.

    Parameters
    ----------
    time : array_like
        Ascending times [time].
    force : array_like
        Forces, linear in between [modulus length^2]; readings below `force_offset` count as none. Readings whose noise goes back
        and forth about a path that rises to one largest value, may be held there, and falls, are replaced by straight pieces; the
        standard errors do not include the error of these.
    depth : array_like
        Depths [length].
    sd : float or array_like, optional
        Standard deviation of the depth, as in `ForceDepth` [length].
    relative_sd : float, optional
        As in `ForceDepth` [1].
    missing : {"raise", "drop"}, optional
        As in `ForceDepth`.

    Raises
    ------
    InvalidArgumentError
        The times do not ascend, or as of `ForceDepth`.

    Examples
    --------
    >>> polymer = mdr.Viscoelastic(1e6, [(9e6, 1.0)], nu=0.5)
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(polymer))
    >>> time = np.linspace(0.0, 5.0, 40)
    >>> path = contact.history(time, force=np.minimum(time, 1.0) * 1e-5)
    >>> data = mdr.instruments.DepthTime(time, path.force, path.depth)
    >>> start = mdr.Homogeneous(mdr.Viscoelastic(2e6, [(9e6, 1.0)], nu=0.5))
    >>> result = mdr.instruments.fit(data, mdr.Paraboloid(10e-6), start, ["relaxed_shear_modulus"])
    >>> print(f"{result.estimates['relaxed_shear_modulus'] / 1e6:.3f}")
    1.000
    """

    code, x_name, y_name, given_name = _layout.FIT_DEPTH_TIME, "time", "depth", "force"

    def __init__(
        self,
        time: ArrayLike,
        force: ArrayLike,
        depth: ArrayLike,
        *,
        sd: ArrayLike | None = None,
        relative_sd: float | None = None,
        missing: str = "raise",
    ) -> None:
        super().__init__(time, depth, force, sd, relative_sd, missing)
        self._follow_path()


class DynamicStiffness(Data):
    """Measured storage and loss stiffness of a contact against frequency.

    Each frequency makes two data points, storage and loss.

    Parameters
    ----------
    omega : array_like
        Angular frequencies > 0 [1/time].
    stiffness : array_like
        Complex stiffness k* = k' + i k'' [modulus length].
    radius : float or array_like
        Contact radius, one or one for each point [length].
    sd : float or array_like, optional
        Standard deviation of real and imaginary part, as in `ForceDepth` [modulus length].
    relative_sd : float, optional
        Standard deviation relative to |k*| [1].
    missing : {"raise", "drop"}, optional
        As in `ForceDepth`.

    Raises
    ------
    InvalidArgumentError
        The columns differ in length.

    Examples
    --------
    >>> polymer = mdr.Viscoelastic(1e6, [(9e6, 1.0)], nu=0.5)
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(polymer))
    >>> omega = np.geomspace(0.1, 10.0, 8)
    >>> data = mdr.instruments.DynamicStiffness(omega, contact.dynamic_stiffness(omega, radius=2e-6), 2e-6, relative_sd=0.01)
    >>> start = mdr.Homogeneous(mdr.Viscoelastic(2e6, [(9e6, 1.0)], nu=0.5))
    >>> result = mdr.instruments.fit(data, mdr.Paraboloid(10e-6), start, ["relaxed_shear_modulus"])
    >>> print(len(data), f"{result.estimates['relaxed_shear_modulus'] / 1e6:.3f}")
    16 1.000
    """

    code, x_name, y_name, given_name = _layout.FIT_DYNAMIC_STIFFNESS, "omega", "stiffness", "radius"

    def __init__(
        self,
        omega: ArrayLike,
        stiffness: ArrayLike,
        radius: ArrayLike,
        *,
        sd: ArrayLike | None = None,
        relative_sd: float | None = None,
        missing: str = "raise",
    ) -> None:
        w, k = column_of("omega", omega), np.asarray(stiffness)
        if k.shape != w.shape:
            raise InvalidArgumentError(f"omega and stiffness must have the same length, not {w.shape} and {k.shape}")
        if relative_sd is not None and sd is None:
            sd, relative_sd = number("relative_sd", relative_sd) * np.abs(k), None
        a = np.broadcast_to(numbers("radius", radius), w.shape) if np.ndim(radius) == 0 else column_of("radius", radius)
        if sd is not None:
            errors = numbers("sd", sd)
            sd = np.repeat(np.full(w.shape, errors) if errors.ndim == 0 else column_of("sd", errors), 2)
        parts = numbers("stiffness", np.column_stack([k.real, k.imag]).ravel())
        super().__init__(np.repeat(w, 2), parts, np.repeat(a, 2), sd, None, missing)
        self.branch = np.tile(np.array([_layout.STORAGE, _layout.LOSS], np.int32), len(w))[self._kept]

    def _check_order(self) -> None:
        """Frequencies may have any order."""


def _rise_and_fall(time: Array, depth: Array) -> Array:
    """The readings, if they rise to one largest value and fall; else the path of few straight pieces that is closest to them."""
    top = int(np.argmax(depth)) if len(depth) else 0
    if not (np.diff(depth[: top + 1]) < 0.0).any() and not (np.diff(depth[top:]) > 0.0).any():
        return depth
    noise = 1.4826 * float(np.median(np.abs(np.diff(depth, 2)))) / np.sqrt(6.0)
    # a hold ends where the depth begins to fall for good
    turn = int(np.flatnonzero(depth >= depth.max() - 2.0 * _NOISE * noise)[-1])
    rise, fall = slice(0, turn + 1), slice(turn, len(depth))
    up = _ascending(time[rise], depth[rise])
    down = -_ascending(time[fall], -np.concatenate([up[-1:], np.minimum(depth[fall][1:], up[-1])]))
    steps = np.concatenate([up, np.minimum(down[1:], up[-1])])
    return _straightened(time, depth, steps, max(noise, 1e-6 * float(np.ptp(depth))))


def _straightened(time: Array, depth: Array, steps: Array, noise: float) -> Array:
    """Straight pieces between the corners of a path, by least squares through the readings. Steps of noise would each be a history
    of its own, in which contacts shrink and grow."""
    tolerance = _NOISE * noise
    corners = _corners(time, steps, tolerance)
    while len(corners) > _MOST_CORNERS:
        tolerance *= 2.0
        corners = _corners(time, steps, tolerance)
    at = time[corners]
    while (i := _slows_down(at, _through(time, depth, at), 3.0 * tolerance)) is not None:
        # the readings next to a turn are within twice the tolerance of the top, and one more corner may follow it
        at = np.delete(at, i)
    for _ in range(_ROUNDS):
        at = _where_lines_meet(time, depth, at)
    return np.asarray(np.interp(time, at, _through(time, depth, at)))


def _where_lines_meet(time: Array, depth: Array, at: Array) -> Array:
    """Corners between straight lines through the readings of each piece, where those suffice."""
    ends = np.searchsorted(time, at)
    lines = [np.polyfit(time[a:b], depth[a:b], 1) if b - a >= _FEWEST else None for a, b in pairwise(ends)]
    moved = at.copy()
    for i, (before, behind) in enumerate(pairwise(lines), start=1):
        if before is None or behind is None or before[0] == behind[0]:
            continue
        meet = float((behind[1] - before[1]) / (before[0] - behind[0]))
        if 0.5 * (at[i - 1] + at[i]) < meet < 0.5 * (at[i] + at[i + 1]):
            moved[i] = meet
    return moved


def _through(time: Array, depth: Array, at: Array) -> Array:
    """Depths at the corners: least squares, then made to rise and fall."""
    piece = np.clip(np.searchsorted(at, time, "right") - 1, 0, len(at) - 2)
    share = (time - at[piece]) / (at[piece + 1] - at[piece])
    rows = np.arange(len(time))
    design = np.zeros((len(time), len(at)))
    design[rows, piece], design[rows, piece + 1] = 1.0 - share, share
    values = np.linalg.lstsq(design, depth)[0]
    top = int(np.argmax(values))
    values[: top + 1] = np.maximum.accumulate(values[: top + 1])
    values[top:] = np.minimum.accumulate(values[top:])
    return np.asarray(values)


def _slows_down(time: Array, values: Array, tolerance: float) -> int | None:
    """A corner of the retract at which it slows down by no more than noise: a viscoelastic body would touch again there."""
    slopes = np.diff(values) / np.diff(time)
    for i in range(int(np.argmax(values)) + 1, len(values) - 1):
        chord = float(np.interp(time[i], time[[i - 1, i + 1]], values[[i - 1, i + 1]]))
        if slopes[i] > slopes[i - 1] and abs(values[i] - chord) <= tolerance:
            return i
    return None


def _corners(time: Array, path: Array, tolerance: float) -> list[int]:
    """Positions between which a path is straight to a tolerance (Ramer 1972, Comput. Graph. Image Process. 1, 244)."""
    kept, pieces = {0, len(path) - 1}, [(0, len(path) - 1)]
    while pieces:
        first, last = pieces.pop()
        part = slice(first, last + 1)
        off = np.abs(path[part] - np.interp(time[part], time[[first, last]], path[[first, last]]))
        worst = first + int(np.argmax(off))
        if off[worst - first] > tolerance and first < worst < last:
            kept.add(worst)
            pieces += [(first, worst), (worst, last)]
    return sorted(kept)


def _ascending(time: Array, values: Array) -> Array:
    """Lines through the middles of the steps of the closest ascending sequence."""
    sums: list[float] = []
    counts: list[int] = []
    for value in values:
        sums.append(float(value))
        counts.append(1)
        while len(sums) > 1 and sums[-2] / counts[-2] >= sums[-1] / counts[-1]:
            last, count = sums.pop(), counts.pop()
            sums[-1] += last
            counts[-1] += count
    ends = np.cumsum(counts)
    starts = ends - counts
    middles = 0.5 * (time[starts] + time[ends - 1])
    return np.asarray(np.interp(time, middles, np.array(sums) / np.array(counts)))
