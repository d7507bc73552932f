# SPDX-License-Identifier: GPL-3.0-or-later
"""What decides inside a coated body: the largest stresses and where they are, and the load at which strengths are reached."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .errors import ArgumentTypeError, InvalidArgumentError, MDRError
from .interior import Interior, layer_energies
from .material import RIGID
from .medium import Coated, Homogeneous, Layered, Pair
from .profile import FlatEndedCone, FlatEndedParaboloid, FlatPunch, Profile
from .profile.base import _terms

__all__ = ["Critical", "Failure", "Layer", "Maximum"]

_FARTHEST = 3.0
"""Maxima are looked for up to so many times a + z from the axis: the ring of tension on a coating need not lie at the edge."""
_GRID, _ZOOM, _ZOOMS = (41, 25), 9, 7
_INSIDE = 1e-9
"""Faces are looked at from this little inside their layer, relative to a + z."""
_OFF_EDGE = 1e-3
"""Nothing is looked for nearer than this part of a to where stresses are infinite."""


class Maximum(NamedTuple):
    """A largest stress and where it is."""

    value: float
    """[modulus]; negative where all of it is compression"""
    r: float
    """distance from the axis [length]"""
    z: float
    """depth [length]"""
    angle: float
    """azimuth from the direction of sliding, 0 or pi; 0 without friction"""


class Layer(NamedTuple):
    """The largest stresses in one layer."""

    von_mises: Maximum
    """largest von Mises stress"""
    tresca: Maximum
    """largest shear stress (s_1 - s_3)/2: by Tresca yield is where twice this is the yield stress"""
    tension: Maximum
    """largest principal stress s_1"""
    energy: float
    """elastic energy without friction [modulus length^3]; 0 in a rigid base"""


class Interface(NamedTuple):
    """The largest tractions at one interface."""

    z: float
    """its depth [length]"""
    shear: Maximum
    """largest shear stress, sqrt(s_rz^2 + s_tz^2)"""
    tension: Maximum
    """largest normal stress s_zz"""


class Critical(NamedTuple):
    """What decides inside a body."""

    layers: tuple[Layer, ...]
    """from the surface down, the half-space last"""
    interfaces: tuple[Interface, ...]
    """from the surface down"""
    surface: Maximum
    """largest principal stress on the free surface a <= r <= 3 a: the tension that opens ring cracks"""


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


def layers_of(medium: Any, body: str = "lower") -> tuple[list[float], bool]:
    """Thicknesses from the surface down [length], and whether the base is rigid."""
    if isinstance(medium, Pair):
        return layers_of(medium.upper if body == "upper" else medium.lower)
    if isinstance(medium, Homogeneous):
        return [], False
    if isinstance(medium, Coated):
        return [medium.thickness], medium.substrate is RIGID
    if isinstance(medium, Layered):
        return [thickness for _, thickness in medium.layers], medium.substrate is RIGID
    if medium is RIGID:
        raise InvalidArgumentError(f"body = {body!r} is not allowed: it is rigid")
    raise InvalidArgumentError(f"a {type(medium).__name__} has no layers to look into: use interior(...) for its stresses")


def critical(contact: Any, state: Any, body: str, friction: float) -> Critical:
    """What `Contact.critical` returns."""
    search = _Search(contact, state, body, friction)
    energies = layer_energies(contact._handle.address, contact._one(state), body, len(search.faces))
    layers = [
        Layer(search.in_layer(i, _von_mises), search.in_layer(i, _tresca), search.in_layer(i, _tension), float(energies[i]))
        for i in range(search.layers)
    ]
    interfaces = [
        Interface(float(depth), search.at_interface(i, _shear), search.at_interface(i, _normal))
        for i, depth in enumerate(search.faces[1:])
    ]
    return Critical(tuple(layers), tuple(interfaces), search.outside())


def _von_mises(field: Interior) -> NDArray[np.float64]:
    return np.asarray(field.von_mises)


def _tresca(field: Interior) -> NDArray[np.float64]:
    return np.asarray(field.tresca)


def _tension(field: Interior) -> NDArray[np.float64]:
    return field.principal[..., 0]


def _shear(field: Interior) -> NDArray[np.float64]:
    return np.hypot(field.s_rz, field.s_tz)


def _normal(field: Interior) -> NDArray[np.float64]:
    return np.asarray(field.s_zz)


Measure = Callable[[Interior], NDArray[np.float64]]


class _Search:
    """Maxima of one state in the plane of sliding: on a grid, then on ever smaller ones around the largest value."""

    def __init__(self, contact: Any, state: Any, body: str, friction: float, zooms: int = _ZOOMS) -> None:
        contact._one(state)
        thicknesses, rigid = layers_of(contact.medium, body)
        self.faces = np.concatenate([[0.0], np.cumsum(thicknesses)])
        """upper faces of the layers [length]"""
        self.layers = len(self.faces) - rigid
        self._contact, self._state, self._body, self._friction, self._zooms = contact, state, body, friction, zooms
        self._radius = float(state.radius)
        if not self._radius > 0.0:
            raise InvalidArgumentError("the contact radius of the state must be greater than 0: there is no contact")
        self._angles = (0.0, math.pi) if friction else (0.0,)
        places = {0.0, self._radius, *(b for b in _flat_ends(contact.indenter) if b < self._radius)}
        self._singular = [r for r in sorted(places) if not math.isfinite(contact.interior(r, 0.0, state, body).s_zz)]
        self._grids: dict[tuple[float, ...], tuple[Any, Any, list[Interior]]] = {}

    def in_layer(self, i: int, measure: Measure) -> Maximum:
        """The largest value in a layer."""
        top = float(self.faces[i])
        bottom = float(self.faces[i + 1]) if i + 1 < len(self.faces) else math.inf
        reach = self._radius + top
        margin = _INSIDE * reach
        z = (top + margin if top else 0.0, min(bottom - margin, top + _FARTHEST * reach))
        return self._largest(measure, (0.0, _FARTHEST * reach), z)

    def at_interface(self, i: int, measure: Measure) -> Maximum:
        """The largest value at an interface."""
        depth = float(self.faces[i + 1])
        reach = self._radius + depth
        return self._largest(measure, (0.0, _FARTHEST * reach), (depth - _INSIDE * reach,) * 2)

    def outside(self) -> Maximum:
        """The largest tension on the free surface beside the contact."""
        off_edge = _OFF_EDGE if self._radius in self._singular else 0.0
        return self._largest(_tension, (self._radius * (1.0 + off_edge), _FARTHEST * self._radius), (0.0, 0.0))

    def is_beside_edge(self, found: Maximum) -> bool:
        """Whether a maximum belongs to the singular edge of a flat punch or an adhesive contact, no matter how weak."""
        return self._radius in self._singular and math.hypot(found.r - self._radius, found.z) < 5.0 * _OFF_EDGE * self._radius

    def _largest(self, measure: Measure, r: tuple[float, float], z: tuple[float, float]) -> Maximum:
        where = (*r, *z)
        if where not in self._grids:
            radii, depths = self._spread(r), self._towards(z)
            self._grids[where] = radii, depths, [self._field(radii, depths, angle) for angle in self._angles]
        radii, depths, fields = self._grids[where]
        best = Maximum(-math.inf, r[0], z[0], 0.0)
        for angle, field in zip(self._angles, fields, strict=True):
            found, (i, j) = self._top(measure(field), radii, depths)
            if found > best.value:
                here = Maximum(found, float(radii[i]), float(depths[j]), angle)
                best = self._zoom(measure, here, _around(radii, i), _around(depths, j))
        return best

    def _zoom(self, measure: Measure, best: Maximum, r: tuple[float, float], z: tuple[float, float]) -> Maximum:
        for _ in range(self._zooms):
            radii = np.linspace(*r, _ZOOM if r[1] > r[0] else 1)
            depths = np.linspace(*z, _ZOOM if z[1] > z[0] else 1)
            found, (i, j) = self._top(measure(self._field(radii, depths, best.angle)), radii, depths)
            if found >= best.value:
                best = Maximum(found, float(radii[i]), float(depths[j]), best.angle)
            r, z = _around(radii, i), _around(depths, j)
        return best

    def _field(self, r: NDArray[np.float64], z: NDArray[np.float64], angle: float) -> Interior:
        field: Interior = self._contact.interior(
            r[:, None], z[None, :], self._state, self._body, side="above", friction=self._friction, angle=angle
        )
        return field

    def _top(self, values: NDArray[np.float64], r: NDArray[np.float64], z: NDArray[np.float64]) -> tuple[float, tuple[int, int]]:
        """The largest value off what is singular, and its place."""
        allowed = np.isfinite(values)
        for place in self._singular:
            allowed &= np.hypot(r[:, None] - place, z[None, :]) >= _OFF_EDGE * self._radius
        chosen = np.where(allowed, values, -np.inf)
        i, j = np.unravel_index(np.argmax(chosen), chosen.shape)
        return float(chosen[i, j]), (int(i), int(j))

    def _spread(self, r: tuple[float, float]) -> NDArray[np.float64]:
        """Radii, half of them around the edge of the contact."""
        a = self._radius
        near = a * (1.0 + 0.3 * np.linspace(-1.0, 1.0, _GRID[0] // 2) ** 3)
        radii = np.concatenate([np.linspace(*r, _GRID[0] // 2 + 1), near, [a]])
        return np.unique(radii[(radii >= r[0]) & (radii <= r[1])])

    def _towards(self, z: tuple[float, float]) -> NDArray[np.float64]:
        """Depths, denser towards the upper face; one where there is only one."""
        if not z[1] > z[0]:
            return np.array([z[0]])
        return z[0] + (z[1] - z[0]) * np.linspace(0.0, 1.0, _GRID[1]) ** 2


def _flat_ends(indenter: Profile) -> list[float]:
    """Radii of the edges of flat ends [length]."""
    return [float(term.end_radius) for term in _terms(indenter) if isinstance(term, FlatEndedCone | FlatEndedParaboloid)]


def _around(values: NDArray[np.float64], i: int) -> tuple[float, float]:
    return float(values[max(i - 1, 0)]), float(values[min(i + 1, len(values) - 1)])


_MODES = {"yield": "layers", "tension": "layers", "interface shear": "interfaces", "interface tension": "interfaces"}
_WIDEST = 30.0
_SAMPLES = 16
_TOLERANCE = 1e-6
_SLACK = 1.1


def first_failure(
    contact: Any, strengths: Mapping[str, Sequence[float | None]], body: str, friction: float, largest_radius: float | None
) -> tuple[Failure, ...]:
    """What `Contact.first_failure` returns."""
    wanted = _wanted(contact, strengths, body)
    if isinstance(contact.indenter, FlatPunch):
        return _under_punch(contact, wanted, body, friction)
    radii = _radii(contact, largest_radius, body)
    coarse: dict[float, _Search] = {}
    fine: dict[float, _Search] = {}
    found = []
    for mode, place, strength in wanted:

        def ratio(
            radius: float, known: dict[float, _Search], mode: str = mode, place: int = place, strength: float = strength
        ) -> float:
            if radius not in known:
                state = contact.at_radius(radius)
                known[radius] = _Search(contact, state, body, friction, 0 if known is coarse else _ZOOMS)
            top = _measure(known[radius], mode, place)
            return 0.0 if known[radius].is_beside_edge(top) else top.value / strength

        bracket = _bracket(lambda radius: ratio(radius, coarse), radii)
        if bracket is not None:
            radius = _root(lambda radius: ratio(radius, fine), *bracket) if bracket[1] > bracket[0] else bracket[0]
            ratio(radius, fine)
            search = fine[radius]
            found.append(Failure(mode, place, strength, search._state, _measure(search, mode, place)))
    return tuple(sorted(found, key=lambda failure: float(failure.state.force)))


def _under_punch(contact: Any, wanted: list[tuple[str, int, float]], body: str, friction: float) -> tuple[Failure, ...]:
    """A contact of one radius: its stresses grow with the depth, so that one state tells all."""
    state = contact.at_depth(1e-3 * contact.indenter.radius)
    search = _Search(contact, state, body, friction)
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
    for mode, given in strengths.items():
        if mode not in _MODES:
            raise InvalidArgumentError(f"strengths: {mode!r} is not a way to fail: choose from {', '.join(map(repr, _MODES))}")
        values = list(given)
        count = counts[_MODES[mode]]
        if len(values) != count:
            raise InvalidArgumentError(
                f"strengths: {mode!r} has {len(values)} values: one for each of the {count} {_MODES[mode]} is needed, None where "
                "no failure is looked for"
            )
        for place, value in enumerate(values):
            if value is None:
                continue
            if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0.0 < value < math.inf:
                raise ArgumentTypeError(f"strengths: {mode!r} = {value!r} is not allowed: it must be greater than 0 and finite")
            wanted.append((mode, place, float(value)))
    if not wanted:
        raise InvalidArgumentError("strengths is not allowed: it names no strength")
    return wanted


def _radii(contact: Any, largest: float | None, body: str) -> NDArray[np.float64]:
    """Contact radii to look at, over four decades beyond the smallest one, as far as indenter and medium are defined."""
    total = math.fsum(layers_of(contact.medium, body)[0])
    last = _WIDEST * total if largest is None else float(largest)
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
            contact.at_radius(last)
            break
        except MDRError:
            last = flat + 0.9 * (last - flat)
    return flat + np.geomspace(1e-4 * (last - flat), last - flat, _SAMPLES)


def _measure(search: _Search, mode: str, place: int) -> Maximum:
    """The maximum that a mode is about; the tension of the first layer includes its free surface."""
    if mode == "interface shear":
        return search.at_interface(place, _shear)
    if mode == "interface tension":
        return search.at_interface(place, _normal)
    if mode == "yield":
        return search.in_layer(place, _von_mises)
    inside = search.in_layer(place, _tension)
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
