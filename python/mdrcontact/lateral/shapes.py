# SPDX-License-Identifier: GPL-3.0-or-later
"""Structures made of bodies in a background material."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from .. import _layout
from .._boundary import native, not_zero, number, numbers, record, together
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..material import Elastic
from .structure import Structure, elastic, exponent_of_mean

Vector = tuple[float, float, float]


class Layer(NamedTuple):
    """All between two depths, top < bottom [length]; an infinite `bottom` is allowed."""

    top: float
    bottom: float
    material: Elastic

    @property
    def parameters(self) -> tuple[float, ...]:
        """As in mdrcontact/lateral.h, enum mdr_shape."""
        return self.top, self.bottom

    def holds(self, x: Any, y: Any, z: Any) -> Any:
        """Whether points lie inside."""
        return (z > self.top) & (z < self.bottom)


class HalfSpace(NamedTuple):
    """All on one side of a plane interface: `point` (x, y, z) [length] lies on it, `normal` points into the material and has any
    length."""

    point: Vector
    normal: Vector
    material: Elastic

    @property
    def parameters(self) -> tuple[float, ...]:
        """As in mdrcontact/lateral.h, enum mdr_shape."""
        return *self.point, *self.normal

    def holds(self, x: Any, y: Any, z: Any) -> Any:
        """Whether points lie inside."""
        (px, py, pz), (nx, ny, nz) = self.point, self.normal
        return (x - px) * nx + (y - py) * ny + (z - pz) * nz > 0.0


class Ball(NamedTuple):
    """A spherical inclusion, whole or cut by the surface: centre (x, y, z), radius > 0 [length]."""

    centre: Vector
    radius: float
    material: Elastic

    @property
    def parameters(self) -> tuple[float, ...]:
        """As in mdrcontact/lateral.h, enum mdr_shape."""
        return *self.centre, self.radius

    def holds(self, x: Any, y: Any, z: Any) -> Any:
        """Whether points lie inside."""
        cx, cy, cz = self.centre
        return (x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2 < self.radius**2


class Fibre(NamedTuple):
    """An endless round cylinder: `point` (x, y, z) lies on its axis, `direction` has any length; radius > 0 [length]."""

    point: Vector
    direction: Vector
    radius: float
    material: Elastic

    @property
    def parameters(self) -> tuple[float, ...]:
        """As in mdrcontact/lateral.h, enum mdr_shape."""
        return *self.point, *self.direction, self.radius

    def holds(self, x: Any, y: Any, z: Any) -> Any:
        """Whether points lie inside."""
        (px, py, pz), (ux, uy, uz) = self.point, self.direction
        length = math.hypot(ux, uy, uz)
        dx, dy, dz = x - px, y - py, z - pz
        along = (dx * ux + dy * uy + dz * uz) / length
        return dx**2 + dy**2 + dz**2 - along**2 < self.radius**2


class Pillar(NamedTuple):
    """An upright round cylinder between two depths, top < bottom: axis at (x, y), radius > 0 [length]; an infinite `bottom` is
    allowed."""

    x: float
    y: float
    radius: float
    top: float
    bottom: float
    material: Elastic

    @property
    def parameters(self) -> tuple[float, ...]:
        """As in mdrcontact/lateral.h, enum mdr_shape."""
        return self.x, self.y, self.radius, self.top, self.bottom

    def holds(self, x: Any, y: Any, z: Any) -> Any:
        """Whether points lie inside."""
        return ((x - self.x) ** 2 + (y - self.y) ** 2 < self.radius**2) & (z > self.top) & (z < self.bottom)


class Box(NamedTuple):
    """A box: ranges (low, high) of x, y and z [length]."""

    x: tuple[float, float]
    y: tuple[float, float]
    z: tuple[float, float]
    material: Elastic

    @property
    def parameters(self) -> tuple[float, ...]:
        """As in mdrcontact/lateral.h, enum mdr_shape."""
        return *self.x, *self.y, *self.z

    def holds(self, x: Any, y: Any, z: Any) -> Any:
        """Whether points lie inside."""
        inside = (x > self.x[0]) & (x < self.x[1]) & (y > self.y[0]) & (y < self.y[1])
        return inside & (z > self.z[0]) & (z < self.z[1])


Shape = Layer | HalfSpace | Ball | Fibre | Pillar | Box


@dataclass(frozen=True)
class Shapes(Structure):
    """Bodies in a background half-space; where they overlap, the later one is there.

    background : material of the half-space
    shapes : Layer, HalfSpace, Ball, Fibre, Pillar, Box
    reference_nu : Poisson's ratio of the weights; None: the background's
    tolerance : relative error of G_eff and nu_eff by quadrature, 1e-10 to 0.1
    exponent : p of the mean G_eff = [sum of w G^p]^(1/p): 1 in parallel, -1 in series, 0 the mean of the logarithms
    """

    background: Elastic
    shapes: Sequence[Shape] = ()
    reference_nu: float | None = field(default=None, kw_only=True)
    tolerance: float = field(default=1e-5, kw_only=True)
    exponent: float = field(default=1.0, kw_only=True)

    def __post_init__(self) -> None:
        bodies = tuple(self.shapes)
        base, tolerance = elastic("background", self.background), number("tolerance", self.tolerance)
        exponent = exponent_of_mean(self.exponent)
        for body in bodies:
            if not isinstance(body, Shape):
                raise ArgumentTypeError(f"{body!r} is not allowed: a shape is a Layer, HalfSpace, Ball, Fibre, Pillar or Box")
            elastic(f"material of {type(body).__name__}", body.material)
        # f2py takes no empty arrays: a layer of the background above the surface is nothing
        known: tuple[Shape, ...] = bodies or (Layer(-2.0, -1.0, base),)
        table = np.zeros((len(known), 7))
        for i, body in enumerate(known):
            try:
                row = numbers("the shape", np.hstack([np.asarray(p) for p in body.parameters]))
            except ValueError as problem:
                raise InvalidArgumentError(f"{body!r} is not allowed: a coordinate is missing or too many") from problem
            if row.shape != (len(_LENGTHS[type(body)]),):
                raise InvalidArgumentError(f"{body!r} is not allowed: a coordinate is missing or too many")
            table[i, : row.size] = row
        nu = base.nu if self.reference_nu is None else number("reference_nu", self.reference_nu)
        chosen = {"reference_nu": nu, "tolerance": not_zero("tolerance", tolerance), "exponent": exponent}
        options = record(_layout.structure_options, reference_nu_is_given=True, exponent_is_given=True, **chosen)
        kinds, moduli = [_layout.SHAPE_LAYER + _KINDS.index(type(b)) for b in known], [b.material.E for b in known]
        ratios = [b.material.nu for b in known]
        created = native.structure_shapes(base.E, base.nu, kinds, table, moduli, ratios, options)
        self._own(created, shapes=bodies, tolerance=tolerance, exponent=exponent)

    def materials(self, x: ArrayLike, y: ArrayLike, z: ArrayLike) -> tuple[Any, Any]:
        """E and nu at points, which broadcast."""
        px, py, pz = np.atleast_1d(*together(x=x, y=y, z=z))
        E, nu = np.full(px.shape, self.background.E), np.full(px.shape, self.background.nu)
        for body in self.shapes:
            inside = body.holds(px, py, pz)
            E[inside], nu[inside] = body.material.E, body.material.nu
        return E, nu


_LENGTHS: dict[type[Any], range] = {
    Layer: range(2), HalfSpace: range(6), Ball: range(4), Fibre: range(7), Pillar: range(5), Box: range(6),
}  # fmt: skip
"""How many parameters a shape has."""
_KINDS = list(_LENGTHS)
"""In the order of enum mdr_shape in mdrcontact/lateral.h."""
