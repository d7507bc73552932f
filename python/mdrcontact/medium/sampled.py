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
    """A medium known by a table of its effective contact modulus.

    a : contact radii > 0, ascending, at least 3 [length]. States are offered between the first and the last; below the first, where
        every contact begins, the modulus is taken as constant
    moduli : E_eff there, > 0 [modulus]; interpolated in ln a without overshoot
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
    """A medium known by a function E_eff(a).

    function : takes a contact radius and returns the effective contact modulus > 0 [modulus]. It is called while the object is
        made and never later; what it raises is raised to the caller. What is kept is compared with it between the samples too;
        peaks narrower than 0.5 % of the radius may be missed, steps below 1e-10 of the modulus are taken for noise. Adhesion by the
        energy balance is refused where the modulus has a kink at a radius of stable contacts: the edge rests there
    smallest_radius, largest_radius : the range of contact radii, 0 < smallest < largest [length]; as in `TabulatedMedium`

    Pickles if the function does (a function of a module does, a lambda does not).
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
