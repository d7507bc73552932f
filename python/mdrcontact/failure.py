# SPDX-License-Identifier: GPL-3.0-or-later
"""The load at which the strengths of a coated body are reached."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _layout
from ._boundary import number
from .critical import ZOOMS, Maximum, Search, layers_of, normal, shear, tension, von_mises
from .errors import ArgumentTypeError, InvalidArgumentError, MDRError
from .profile import FlatPunch
from .profile.base import _terms

__all__ = ["Failure"]

_MODES = {"yield": "layers", "tension": "layers", "interface shear": "interfaces", "interface tension": "interfaces"}
_WIDEST = 30.0
_SAMPLES = 16
_TOLERANCE = 1e-6
_SLACK = 1.1


class Failure(NamedTuple):
    """A strength that is reached."""

    mode: str
    """one of "yield", "tension", "interface shear" and "interface tension"; see `Contact.first_failure`"""
    place: int
    """which layer or interface, 0 is the first one from the surface"""
    strength: float
    """[modulus]"""
    state: Any
    """the State at which it is reached; the smallest one looked at where it is reached at once, at any load"""
    at: Maximum
    """where in the body; its value is larger than the strength where that is reached at once"""

    @property
    def at_once(self) -> bool:
        """Whether the strength is reached at the smallest contact already, as under a sharp tip."""
        return self.at.value > 1.001 * self.strength


def first_failure(
    contact: Any, strengths: Mapping[str, Sequence[float | None]], body: str, friction: float, largest_radius: float | None
) -> tuple[Failure, ...]:
    """What `Contact.first_failure` returns."""
    wanted = _wanted(contact, strengths, body)
    if isinstance(contact.indenter, FlatPunch):
        return _under_punch(contact, wanted, body, friction)
    radii = _radii(contact, largest_radius, body)
    coarse: dict[float, Search] = {}
    fine: dict[float, Search] = {}
    found = []
    for mode, place, strength in wanted:

        def ratio(
            radius: float, known: dict[float, Search], mode: str = mode, place: int = place, strength: float = strength
        ) -> float:
            if radius not in known:
                state = contact._solve("radius", _layout.GIVEN_RADIUS, radius)
                known[radius] = Search(state, body, friction, 0 if known is coarse else ZOOMS)
            top = _measure(known[radius], mode, place)
            return 0.0 if known[radius].is_beside_edge(top) else top.value / strength

        bracket = _bracket(lambda radius: ratio(radius, coarse), radii)
        if bracket is not None:
            radius = _root(lambda radius: ratio(radius, fine), *bracket) if bracket[1] > bracket[0] else bracket[0]
            ratio(radius, fine)
            search = fine[radius]
            contact._doubts.of(search.state)
            found.append(Failure(mode, place, strength, search.state, _measure(search, mode, place)))
    return tuple(sorted(found, key=lambda failure: float(failure.state.force)))


def _under_punch(contact: Any, wanted: list[tuple[str, int, float]], body: str, friction: float) -> tuple[Failure, ...]:
    """A contact of one radius: its stresses grow with the depth, so that one state suffices."""
    state = contact.at_depth(1e-3 * contact.indenter.radius)
    search = Search(state, body, friction)
    found = []
    for mode, place, strength in wanted:
        top = _measure(search, mode, place)
        if top.value > 0.0 and not search.is_beside_edge(top):
            reached = contact.at_depth(float(state.depth) * strength / top.value)
            found.append(Failure(mode, place, strength, reached, top._replace(value=strength)))
    return tuple(sorted(found, key=lambda failure: float(failure.state.force)))


def _wanted(contact: Any, strengths: Mapping[str, Sequence[float | None]], body: str) -> list[tuple[str, int, float]]:
    """Mode, place and strength of every failure to look for."""
    thicknesses, rigid = layers_of(contact.medium, body)
    counts = {"layers": len(thicknesses) + (not rigid), "interfaces": len(thicknesses)}
    wanted = []
    if not isinstance(strengths, Mapping):
        raise ArgumentTypeError(
            f"strengths = {strengths!r} is not allowed: it must be a dict of lists, as in {{'yield': [1e9, None]}}"
        )
    for mode, given in strengths.items():
        if mode not in _MODES:
            raise InvalidArgumentError(f"strengths: {mode!r} is not a way to fail: choose from {', '.join(map(repr, _MODES))}")
        count = counts[_MODES[mode]]
        if isinstance(given, str) or not isinstance(given, Iterable):
            raise ArgumentTypeError(
                f"strengths: {mode!r} = {given!r} is not allowed: it must be a list, one for each of the {count} {_MODES[mode]}"
            )
        values = list(given)
        if len(values) != count:
            raise InvalidArgumentError(
                f"strengths: {mode!r} has {len(values)} values: one for each of the {count} {_MODES[mode]} is needed, from the "
                "surface down"
            )
        for place, value in enumerate(values):
            if value is None:
                continue
            strength = number(f"strengths: {mode!r}", value)
            if not 0.0 < strength < math.inf:
                raise InvalidArgumentError(
                    f"strengths: {mode!r} = {strength!r} is not allowed: it must be greater than 0 and finite"
                )
            wanted.append((mode, place, strength))
    if not wanted:
        raise InvalidArgumentError("strengths is not allowed: it names no strength")
    return wanted


def _radii(contact: Any, largest: float | None, body: str) -> NDArray[np.float64]:
    """Contact radii to look at, over four decades beyond the smallest one, as far as indenter and medium are defined."""
    total = math.fsum(layers_of(contact.medium, body)[0])
    last = _WIDEST * total if largest is None else number("largest_radius", largest)
    if not 0.0 < last < math.inf:
        raise InvalidArgumentError("largest_radius must be given, greater than 0: a body without layers has no length of its own")
    ends = [getattr(term, "end_radius", 0.0) for term in _terms(contact.indenter)]
    flat = float(min(ends))
    if not last > flat:
        if largest is not None:
            raise InvalidArgumentError(f"largest_radius = {last:g} is not allowed: it must be larger than the flat end, {flat:g}")
        last = 3.0 * flat
    while last > flat:
        try:
            contact._solve("radius", _layout.GIVEN_RADIUS, last)
            break
        except MDRError:
            last = flat + 0.9 * (last - flat)
    return flat + np.geomspace(1e-4 * (last - flat), last - flat, _SAMPLES)


def _measure(search: Search, mode: str, place: int) -> Maximum:
    """The maximum that a mode is about; the tension of the first layer includes its free surface."""
    if mode == "interface shear":
        return search.at_interface(place, shear)
    if mode == "interface tension":
        return search.at_interface(place, normal)
    if mode == "yield":
        return search.in_layer(place, von_mises)
    inside = search.in_layer(place, tension)
    return max(inside, search.outside()) if place == 0 else inside


def _bracket(ratio: Callable[[float], float], radii: NDArray[np.float64]) -> tuple[float, float] | None:
    """Radii between which the strength is first reached; twice the smallest one if it is reached there; None if nowhere. On the
    coarse grid a maximum may be missed by some per cent: the radii are not quite neighbours."""
    smallest = float(radii[0])
    if ratio(smallest) >= 1.0:
        return smallest, smallest
    for before, here in pairwise(radii.tolist()):
        if ratio(here) >= 1.0:
            return max(before / _SLACK, smallest), here
    return None


def _root(ratio: Callable[[float], float], low: float, high: float) -> float:
    """The radius at which the ratio is 1, by regula falsi (Illinois) in the logarithms."""
    f_low, f_high = ratio(low) - 1.0, ratio(high) - 1.0
    middle = high
    for _ in range(60):
        step = f_high / (f_high - f_low)
        middle = math.exp(math.log(high) - step * (math.log(high) - math.log(low)))
        f_middle = ratio(middle) - 1.0
        if abs(f_middle) < _TOLERANCE or abs(math.log(high / low)) < _TOLERANCE:
            break
        if f_middle * f_high < 0.0:
            low, f_low = high, f_high
        else:
            f_low *= 0.5
        high, f_high = middle, f_middle
    return middle
