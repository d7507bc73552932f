# SPDX-License-Identifier: GPL-3.0-or-later
"""Indenters from measured tables and from user functions."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

from numpy.typing import ArrayLike

from .. import _layout
from .._boundary import native, number, row
from .._callback import Callback
from .._units import LENGTH
from ..errors import InvalidArgumentError
from .base import Profile

__all__ = [
    "TabulatedProfile",
    "TabulatedMDRProfile",
    "CallableProfile",
]


def _pair(x_name: str, x: ArrayLike, y_name: str, y: ArrayLike) -> tuple[tuple[float, ...], tuple[float, ...]]:
    positions, values = row(x_name, x), row(y_name, y)
    if len(positions) != len(values):
        raise InvalidArgumentError(f"{x_name} and {y_name} must have the same length; it is {len(positions)} and {len(values)}")
    return positions, values


@dataclass(frozen=True)
class TabulatedProfile(Profile):
    """A profile from a table, interpolated smoothly and without overshoot between the points.

    r : radii, r[0] = 0, ascending, at least 3 [length]
    f : heights, f[0] = 0, same length [length]
    """

    _is_table = True

    r: tuple[float, ...] = field(metadata={"dimension": LENGTH})
    f: tuple[float, ...] = field(metadata={"dimension": LENGTH})

    def __init__(self, r: ArrayLike, f: ArrayLike) -> None:
        radii, heights = _pair("r", r, "f", f)
        self._own(native.profile_table(_layout.HEIGHT, radii, heights), r=radii, f=heights)


@dataclass(frozen=True)
class TabulatedMDRProfile(Profile):
    """The profile f(r) whose one-dimensional profile is the table g(x): the inverse transform, equation (4).

    x : positions, x[0] = 0, ascending, at least 3 [length]
    g : values, g[0] = 0, same length [length]
    """

    _is_table = True

    x: tuple[float, ...]
    g: tuple[float, ...]

    def __init__(self, x: ArrayLike, g: ArrayLike) -> None:
        positions, values = _pair("x", x, "g", g)
        self._own(native.profile_table(_layout.G, positions, values), x=positions, g=values)


@dataclass(frozen=True)
class CallableProfile(Profile):
    """A profile from a user function.

    f : takes a radius r, 0 <= r <= r_max, and returns the height [length]; f(0) = 0, greater than 0 beyond, never decreasing,
        smooth but for corners; a feature narrower than 1 % of r_max may go unseen. It is called while the object is made and
        never later; what it raises is raised to the caller. A formula that loses its digits towards the axis,
        R - sqrt(R^2 - r^2), is continued by a power series in r that its values determine to 3e-10, or refused with
        NoConvergenceError; r^2/(R + sqrt(R^2 - r^2)) loses none
    r_max : largest radius at which f is defined [length], > 0

    Pickles if f does (a function of a module does, a lambda does not).
    """

    _is_table = True

    f: Callable[[float], float]
    r_max: float

    def __post_init__(self) -> None:
        callback, r_max = Callback("f", self.f), number("r_max", self.r_max)
        # the library calls it largest_radius
        if not 0.0 < r_max < math.inf:
            raise InvalidArgumentError(f"r_max = {r_max:g} is not allowed: it must be finite and greater than 0")
        created = native.profile_function(callback.entry, None, r_max)
        callback.reraise()
        self._own(created, r_max=r_max)
