# SPDX-License-Identifier: GPL-3.0-or-later
"""What decides inside a coated body: the largest stresses and where they are."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .errors import InvalidArgumentError
from .interior import Interior, layer_energies
from .material import RIGID, SMOOTH
from .medium import Coated, Homogeneous, Layered, Pair
from .profile import FlatEndedCone, FlatEndedParaboloid, Profile
from .profile.base import _terms

__all__ = ["Critical", "InterfaceMaxima", "LayerMaxima", "Maximum"]

_FARTHEST = 3.0
"""Maxima are looked for up to so many times a + z from the axis: the ring of tension on a coating need not lie at the edge."""
_GRID, _ZOOM, ZOOMS = (41, 25), 9, 7
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


class LayerMaxima(NamedTuple):
    """The largest stresses in one layer."""

    von_mises: Maximum
    """largest von Mises stress"""
    tresca: Maximum
    """largest shear stress (s_1 - s_3)/2: by Tresca yield is where twice this is the yield stress"""
    tension: Maximum
    """largest principal stress s_1"""
    energy: float
    """elastic energy without friction [modulus length^3]; 0 in a rigid base"""


class InterfaceMaxima(NamedTuple):
    """The largest tractions at one interface."""

    z: float
    """its depth [length]"""
    shear: Maximum
    """largest shear stress, sqrt(s_rz^2 + s_tz^2)"""
    tension: Maximum
    """largest normal stress s_zz"""


class Critical(NamedTuple):
    """What decides inside a body."""

    layers: tuple[LayerMaxima, ...]
    """from the surface down, the half-space last"""
    interfaces: tuple[InterfaceMaxima, ...]
    """from the surface down"""
    surface: Maximum
    """largest principal stress on the free surface a <= r <= 3 a: the tension that opens ring cracks"""


def layers_of(medium: Any, body: str = "lower") -> tuple[list[float], bool]:
    """Thicknesses from the surface down [length], and whether the base is rigid."""
    if isinstance(medium, Pair):
        return layers_of(medium.upper if body == "upper" else medium.lower)
    if isinstance(medium, Homogeneous):
        return [], False
    if isinstance(medium, Coated):
        return [medium.thickness], medium.substrate in (RIGID, SMOOTH)
    if isinstance(medium, Layered):
        return [thickness for _, thickness in medium.layers], medium.substrate in (RIGID, SMOOTH)
    if medium is RIGID:
        raise InvalidArgumentError(f"body = {body!r} is not allowed: it is rigid")
    raise InvalidArgumentError(f"a {type(medium).__name__} has no layers to look into: use interior(...) for its stresses")


def critical(state: Any, body: str, friction: float) -> Critical:
    """What `State.critical` returns."""
    search = Search(state, body, friction)
    energies = layer_energies(state, body, len(search.faces))
    layers = [
        LayerMaxima(search.in_layer(i, von_mises), search.in_layer(i, _tresca), search.in_layer(i, tension), float(energies[i]))
        for i in range(search.layers)
    ]
    interfaces = [
        InterfaceMaxima(float(depth), search.at_interface(i, shear), search.at_interface(i, normal))
        for i, depth in enumerate(search.faces[1:])
    ]
    return Critical(tuple(layers), tuple(interfaces), search.outside())


def von_mises(field: Interior) -> NDArray[np.float64]:
    return np.asarray(field.von_mises)


def _tresca(field: Interior) -> NDArray[np.float64]:
    return np.asarray(field.tresca)


def tension(field: Interior) -> NDArray[np.float64]:
    return field.principal[..., 0]


def shear(field: Interior) -> NDArray[np.float64]:
    return np.hypot(field.s_rz, field.s_tz)


def normal(field: Interior) -> NDArray[np.float64]:
    return np.asarray(field.s_zz)


Measure = Callable[[Interior], NDArray[np.float64]]


class Search:
    """Maxima of one state in the plane of sliding: on a grid, then on ever smaller ones around the largest value."""

    def __init__(self, state: Any, body: str, friction: float, zooms: int = ZOOMS) -> None:
        contact, _ = state._owner, state._row()
        thicknesses, rigid = layers_of(contact.medium, body)
        self.faces = np.concatenate([[0.0], np.cumsum(thicknesses)])
        """upper faces of the layers [length]"""
        self.layers = len(self.faces) - rigid
        self.state, self._body, self._friction, self._zooms = state, body, friction, zooms
        self._radius = float(state.radius)
        if not self._radius > 0.0:
            raise InvalidArgumentError("the contact radius of the state must be greater than 0: there is no contact")
        self._angles = (0.0, math.pi) if friction else (0.0,)
        places = {0.0, self._radius, *(b for b in _flat_ends(contact.indenter) if b < self._radius)}
        self._singular = [r for r in sorted(places) if not math.isfinite(state.interior(r, 0.0, body).s_zz)]
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
        return self._largest(tension, (self._radius * (1.0 + off_edge), _FARTHEST * self._radius), (0.0, 0.0))

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
        where = r[:, None], z[None, :], self._body, "above", self._friction, angle
        field: Interior = self.state.interior(*where)
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
