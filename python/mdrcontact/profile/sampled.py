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
    """Profile given by a table, interpolated smoothly and without overshoot.

    Parameters
    ----------
    r : array_like
        Radii, ascending from r[0] = 0, at least 3 [length].
    f : array_like
        Heights, f[0] = 0, as many as radii [length].

    Raises
    ------
    InvalidArgumentError
        The table is too short, does not ascend or does not begin at 0.

    Examples
    --------
    >>> r = np.linspace(0.0, 2e-6, 21)
    >>> tip = mdr.TabulatedProfile(r, r**2 / 20e-6)
    >>> print(f"{tip.height(1.05e-6):.3e} {tip.mdr(1.05e-6):.3e}")
    5.512e-08 1.102e-07
    """

    _is_table = True

    r: tuple[float, ...] = field(metadata={"dimension": LENGTH})
    f: tuple[float, ...] = field(metadata={"dimension": LENGTH})

    def __init__(self, r: ArrayLike, f: ArrayLike) -> None:
        radii, heights = _pair("r", r, "f", f)
        self._own(native.profile_table(_layout.HEIGHT, radii, heights), r=radii, f=heights)


@dataclass(frozen=True)
class TabulatedMDRProfile(Profile):
    """Profile whose one-dimensional profile g(x) is given by a table.

    The profile f(r) follows from the inverse transform, equation (4) of Popov (2014).

    Parameters
    ----------
    x : array_like
        Positions, ascending from x[0] = 0, at least 3 [length].
    g : array_like
        Values of g, g[0] = 0, as many as positions [length].

    Raises
    ------
    InvalidArgumentError
        The table is too short, does not ascend or does not begin at 0.

    References
    ----------
    popov-2014, equation (4)

    Examples
    --------
    >>> x = np.linspace(0.0, 2e-6, 21)
    >>> tip = mdr.TabulatedMDRProfile(x, x**2 / 10e-6)
    >>> print(f"{tip.height(1.05e-6):.3e} {tip.mdr(1.05e-6):.3e}")
    5.512e-08 1.102e-07
    """

    _is_table = True

    x: tuple[float, ...]
    g: tuple[float, ...]

    def __init__(self, x: ArrayLike, g: ArrayLike) -> None:
        positions, values = _pair("x", x, "g", g)
        self._own(native.profile_table(_layout.G, positions, values), x=positions, g=values)


@dataclass(frozen=True)
class CallableProfile(Profile):
    """Profile given by a user-defined function f(r).

    Parameters
    ----------
    f : callable
        Function of one radius r, 0 <= r <= `r_max`, that returns the height [length]. It must satisfy f(0) = 0, be positive beyond,
        never decrease and be smooth except for corners. A feature narrower than 1 % of `r_max` may be missed.
    r_max : float
        Largest radius at which f is defined, > 0 [length].

    Raises
    ------
    InvalidArgumentError
        `r_max` is not finite and greater than 0, or f decreases.
    CallbackError
        f returns NaN, infinity or no number. An exception that f raises is passed on unchanged.
    NoConvergenceError
        The values of f lose too many digits near the axis.

    Notes
    -----
    The function is called while the object is made and never later. A formula such as R - sqrt(R^2 - r^2) loses digits near the
    axis. It is continued there by a power series in r that its values determine to 3e-10; if that is not possible, the constructor
    raises `NoConvergenceError`. The form r^2/(R + sqrt(R^2 - r^2)) loses no digits. The object pickles if f does: a function of a
    module does, a lambda does not.

    Examples
    --------
    >>> tip = mdr.CallableProfile(lambda r: r**2 / 20e-6, 2e-6)
    >>> print(f"{tip.height(1e-6):.4e} {tip.mdr(1e-6):.4e}")
    5.0000e-08 1.0000e-07
    """

    _is_table = True

    f: Callable[[float], float]
    r_max: float

    def __post_init__(self) -> None:
        callback, r_max = Callback("f", self.f), number("r_max", self.r_max)
        # the library calls it largest_radius
        if not 0.0 < r_max < math.inf:
            raise InvalidArgumentError(f"r_max = {r_max:g}: it must be finite and greater than 0")
        created = native.profile_function(callback.entry, None, r_max)
        callback.reraise()
        self._own(created, r_max=r_max)
