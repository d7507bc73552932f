# SPDX-License-Identifier: GPL-3.0-or-later
"""The user's own effective modulus (theory/paper.md (3.1))."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from numpy.typing import ArrayLike

from .._boundary import native, number, row
from .._callback import Callback
from .._units import LENGTH, MODULUS
from ..errors import InvalidArgumentError
from .base import Medium


@dataclass(frozen=True)
class TabulatedMedium(Medium):
    """Medium given by a table of its effective contact modulus.

    Parameters
    ----------
    a : array_like
        Contact radii > 0, ascending, at least 3 [length]. States exist between the first and the last radius. Below the first
        radius, where every contact begins, the modulus is constant.
    moduli : array_like
        E_eff at these radii, > 0 [modulus]; interpolated in ln a without overshoot.

    Raises
    ------
    InvalidArgumentError
        The table is too short, does not ascend, or the two differ in length.

    Examples
    --------
    >>> medium = mdr.TabulatedMedium([1e-7, 1e-6, 1e-5], [74e9, 120e9, 165e9])
    >>> print(f"{medium.modulus(3e-7):.4e}")
    9.6072e+10
    """

    _is_table = True

    a: tuple[float, ...] = field(metadata={"dimension": LENGTH})
    moduli: tuple[float, ...] = field(metadata={"dimension": MODULUS})

    def __init__(self, a: ArrayLike, moduli: ArrayLike) -> None:
        radii, values = row("a", a), row("moduli", moduli)
        if len(radii) != len(values):
            raise InvalidArgumentError(f"a and moduli must have the same length; it is {len(radii)} and {len(values)}")
        self._own(native.medium_table(radii, values), a=radii, moduli=values)


@dataclass(frozen=True)
class CallableMedium(Medium):
    """Medium given by a user-defined function E_eff(a).

    Parameters
    ----------
    function : callable
        Function of one contact radius that returns the effective contact modulus > 0 [modulus].
    smallest_radius : float
        Smallest contact radius > 0 [length]. Below it, where every contact begins, the modulus is constant.
    largest_radius : float
        Largest contact radius > `smallest_radius` [length].

    Raises
    ------
    InvalidArgumentError
        A radius is outside its range.
    CallbackError
        The function returns NaN, infinity, no number or a modulus <= 0. An exception that it raises is passed on unchanged.

    Notes
    -----
    The function is called while the object is made and never later. The interpolation is checked between its samples; peaks
    narrower than 0.5 % of the radius may be missed, and steps below 1e-10 of the modulus count as noise. If the modulus has a kink
    at a radius of stable contacts, adhesion by the energy balance is not possible. The object pickles if the function does: a
    function of a module does, a lambda does not.

    Examples
    --------
    >>> h = 500e-9
    >>> medium = mdr.CallableMedium(lambda a: 74e9 + 97e9 * (a / h) / (1.0 + a / h), 1e-9, 1e-5)
    >>> print(f"{mdr.Contact(mdr.Sphere(10e-6), medium).at_depth(50e-9).force:.4e}")
    5.7918e-03
    """

    _is_table = True

    function: Callable[[float], float]
    smallest_radius: float
    largest_radius: float

    def __post_init__(self) -> None:
        callback = Callback("function", self.function)
        first, last = number("smallest_radius", self.smallest_radius), number("largest_radius", self.largest_radius)
        created = native.medium_function(callback.entry, None, first, last)
        callback.reraise()
        self._own(created, smallest_radius=first, largest_radius=last)
