# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured data of viscoelastic bodies, one class for each kind."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from .. import _layout
from .._boundary import number, numbers
from ..errors import InvalidArgumentError
from .data import Array, Data, column_of

_NOISE = 3.0
"""Standard deviations of the depth readings within which they turn."""
_ROUGH = 0.03
"""Readings this far off a path, as a part of its range, are of another path."""


class _InTime(Data):
    """Against times, which ascend."""

    def _check_order(self) -> None:
        back = np.flatnonzero(np.diff(self.x) <= 0.0)
        if len(back):
            raise InvalidArgumentError(f"entry {back[0] + 2} of time = {self.x[back[0] + 1]:.7g} is not allowed: times must ascend")


class ForceTime(_InTime):
    """Force against time of a viscoelastic body whose indentation depth is prescribed: approach, hold, retract; a relaxation test.

    time : ascending [time]
    depth : that the instrument reads, the deflection of a cantilever taken off: rises to one largest value, may be held there, and
        falls; in between linear in time. Readings whose noise goes back and forth are replaced by the closest such path [length]
    force : [modulus length^2]
    sd, relative_sd : of the force, as in ForceDepth
    """

    code, x_name, y_name, given_name = 5, "time", "force", "depth"

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
        assert self.given is not None
        path = _rise_and_fall(self.x, self.given)
        off = float(np.sqrt(np.mean((path - self.given) ** 2))) if len(path) else 0.0
        if off > 0.0 and off > _ROUGH * float(np.ptp(path)):
            raise InvalidArgumentError(
                f"depth is not allowed: it must rise to one largest value and fall; the closest such path is {off:.3g} from the "
                "readings. Give the path that was prescribed, or a part of the record"
            )
        if off > 0.0:
            self.warnings.append(f"the depth readings go back and forth: a path {off:.2g} (root mean square) from them is used")
        self.given = path


class DepthTime(_InTime):
    """Indentation depth against time of a viscoelastic body under a prescribed force: creep.

    time : ascending [time]
    force : in between linear in time; readings below force_offset are taken as none [modulus length^2]
    depth : [length]
    sd, relative_sd : of the depth, as in ForceDepth
    """

    code, x_name, y_name, given_name = 6, "time", "depth", "force"

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


class DynamicStiffness(Data):
    """Storage and loss of the contact stiffness against frequency.

    omega : angular frequencies > 0 [1/time]
    stiffness : k* = k' + i k'', complex [modulus length]
    radius : contact radius, a number or one for each point [length]
    sd, relative_sd : of the real and of the imaginary part alike, as in ForceDepth

    As data they are two points each, the storage and the loss.
    """

    code, x_name, y_name, given_name = 7, "omega", "stiffness", "radius"

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
        self.branch = np.tile(np.array([_layout.FIT_STORAGE, _layout.FIT_LOSS], np.int32), len(w))[self._kept]

    def _check_order(self) -> None:
        """Frequencies may stand in any order."""


def _rise_and_fall(time: Array, depth: Array) -> Array:
    """The readings, if they rise to one largest value and fall; else lines through the middles of what their best ascending and
    descending steps are (pool adjacent violators)."""
    top = int(np.argmax(depth)) if len(depth) else 0
    if not (np.diff(depth[: top + 1]) < 0.0).any() and not (np.diff(depth[top:]) > 0.0).any():
        return depth
    noise = 1.4826 * float(np.median(np.abs(np.diff(depth, 2)))) / np.sqrt(6.0)
    # a hold ends where the depth begins to fall for good
    turn = int(np.flatnonzero(depth >= depth.max() - 2.0 * _NOISE * noise)[-1])
    rise, fall = slice(0, turn + 1), slice(turn, len(depth))
    up = _ascending(time[rise], depth[rise])
    down = -_ascending(time[fall], -np.concatenate([up[-1:], np.minimum(depth[fall][1:], up[-1])]))
    return np.concatenate([up, np.minimum(down[1:], up[-1])])


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
