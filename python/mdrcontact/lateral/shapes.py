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
    """Layer between two depths.

    Examples
    --------
    >>> film = mdr.lateral.Layer(0.0, 1e-6, mdr.Elastic(10e9, 0.35))
    >>> body = mdr.lateral.Shapes(mdr.Elastic(3e9, 0.35), [film])
    >>> print(f"{body.modulus(0.0, 0.0, 1e-6):.4e}")
    6.8369e+09
    """

    top: float
    """upper depth >= 0 [length]"""
    bottom: float
    """lower depth > `top`, may be infinite [length]"""
    material: Elastic
    """material of the layer"""

    @property
    def parameters(self) -> tuple[float, ...]:
        """Coordinates in the order of enum mdr_shape of mdrcontact/lateral.h [length]."""
        return self.top, self.bottom

    def holds(self, x: Any, y: Any, z: Any) -> Any:
        """Return whether points lie inside.

        Parameters
        ----------
        x : array_like
            Coordinates of the points [length]; the three broadcast.
        y : array_like
            Coordinates of the points [length].
        z : array_like
            Depths of the points [length].

        Returns
        -------
        bool or ndarray
            True inside, in the broadcast shape.
        """
        return (z > self.top) & (z < self.bottom)


class HalfSpace(NamedTuple):
    """Half-space on one side of a plane interface.

    Examples
    --------
    >>> half = mdr.lateral.HalfSpace((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), mdr.Elastic(6e9, 0.35))
    >>> body = mdr.lateral.Shapes(mdr.Elastic(3e9, 0.35), [half])
    >>> print(f"{body.modulus(0.0, 0.0, 1e-6):.4e}")
    5.1282e+09
    """

    point: Vector
    """a point (x, y, z) of the interface [length]"""
    normal: Vector
    """a vector into the material, of any length"""
    material: Elastic
    """material of the half-space"""

    @property
    def parameters(self) -> tuple[float, ...]:
        """Coordinates in the order of enum mdr_shape of mdrcontact/lateral.h [length]."""
        return *self.point, *self.normal

    def holds(self, x: Any, y: Any, z: Any) -> Any:
        """Return whether points lie inside.

        Parameters
        ----------
        x : array_like
            Coordinates of the points [length]; the three broadcast.
        y : array_like
            Coordinates of the points [length].
        z : array_like
            Depths of the points [length].

        Returns
        -------
        bool or ndarray
            True inside, in the broadcast shape.
        """
        (px, py, pz), (nx, ny, nz) = self.point, self.normal
        return (x - px) * nx + (y - py) * ny + (z - pz) * nz > 0.0


class Ball(NamedTuple):
    """Spherical inclusion, whole or cut by the surface.

    Examples
    --------
    >>> ball = mdr.lateral.Ball((0.0, 0.0, 8e-6), 5e-6, mdr.Elastic(70e9, 0.22))
    >>> body = mdr.lateral.Shapes(mdr.Elastic(3e9, 0.35), [ball])
    >>> print(np.round(body.modulus(0.0, 0.0, [1e-6, 10e-6]) / 1e9, 3))
    [11.3    5.533]
    """

    centre: Vector
    """centre (x, y, z) [length]"""
    radius: float
    """radius > 0 [length]"""
    material: Elastic
    """material of the ball"""

    @property
    def parameters(self) -> tuple[float, ...]:
        """Coordinates in the order of enum mdr_shape of mdrcontact/lateral.h [length]."""
        return *self.centre, self.radius

    def holds(self, x: Any, y: Any, z: Any) -> Any:
        """Return whether points lie inside.

        Parameters
        ----------
        x : array_like
            Coordinates of the points [length]; the three broadcast.
        y : array_like
            Coordinates of the points [length].
        z : array_like
            Depths of the points [length].

        Returns
        -------
        bool or ndarray
            True inside, in the broadcast shape.
        """
        cx, cy, cz = self.centre
        return (x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2 < self.radius**2


class Fibre(NamedTuple):
    """Endless round cylinder.

    Examples
    --------
    >>> fibre = mdr.lateral.Fibre((0.0, 0.0, 8e-6), (0.0, 1.0, 0.0), 5e-6, mdr.Elastic(70e9, 0.22))
    >>> body = mdr.lateral.Shapes(mdr.Elastic(3e9, 0.35), [fibre])
    >>> print(f"{body.modulus(0.0, 0.0, 10e-6):.4e}")
    1.2398e+10
    """

    point: Vector
    """a point (x, y, z) of the axis [length]"""
    direction: Vector
    """a vector along the axis, of any length"""
    radius: float
    """radius > 0 [length]"""
    material: Elastic
    """material of the fibre"""

    @property
    def parameters(self) -> tuple[float, ...]:
        """Coordinates in the order of enum mdr_shape of mdrcontact/lateral.h [length]."""
        return *self.point, *self.direction, self.radius

    def holds(self, x: Any, y: Any, z: Any) -> Any:
        """Return whether points lie inside.

        Parameters
        ----------
        x : array_like
            Coordinates of the points [length]; the three broadcast.
        y : array_like
            Coordinates of the points [length].
        z : array_like
            Depths of the points [length].

        Returns
        -------
        bool or ndarray
            True inside, in the broadcast shape.
        """
        (px, py, pz), (ux, uy, uz) = self.point, self.direction
        length = math.hypot(ux, uy, uz)
        dx, dy, dz = x - px, y - py, z - pz
        along = (dx * ux + dy * uy + dz * uz) / length
        return dx**2 + dy**2 + dz**2 - along**2 < self.radius**2


class Pillar(NamedTuple):
    """Upright round cylinder between two depths.

    Examples
    --------
    >>> pillar = mdr.lateral.Pillar(0.0, 0.0, 5e-6, 0.0, 20e-6, mdr.Elastic(70e9, 0.22))
    >>> body = mdr.lateral.Shapes(mdr.Elastic(3e9, 0.35), [pillar])
    >>> print(f"{body.modulus(0.0, 0.0, 1e-6):.4e}")
    6.5646e+10
    """

    x: float
    """position of the axis [length]"""
    y: float
    """position of the axis [length]"""
    radius: float
    """radius > 0 [length]"""
    top: float
    """upper depth >= 0 [length]"""
    bottom: float
    """lower depth > `top`, may be infinite [length]"""
    material: Elastic
    """material of the pillar"""

    @property
    def parameters(self) -> tuple[float, ...]:
        """Coordinates in the order of enum mdr_shape of mdrcontact/lateral.h [length]."""
        return self.x, self.y, self.radius, self.top, self.bottom

    def holds(self, x: Any, y: Any, z: Any) -> Any:
        """Return whether points lie inside.

        Parameters
        ----------
        x : array_like
            Coordinates of the points [length]; the three broadcast.
        y : array_like
            Coordinates of the points [length].
        z : array_like
            Depths of the points [length].

        Returns
        -------
        bool or ndarray
            True inside, in the broadcast shape.
        """
        return ((x - self.x) ** 2 + (y - self.y) ** 2 < self.radius**2) & (z > self.top) & (z < self.bottom)


class Box(NamedTuple):
    """Box with faces along the axes.

    Examples
    --------
    >>> box = mdr.lateral.Box((-5e-6, 5e-6), (-5e-6, 5e-6), (0.0, 5e-6), mdr.Elastic(70e9, 0.22))
    >>> body = mdr.lateral.Shapes(mdr.Elastic(3e9, 0.35), [box])
    >>> print(f"{body.modulus(0.0, 0.0, 1e-6):.4e}")
    6.2145e+10
    """

    x: tuple[float, float]
    """range (low, high) of x [length]"""
    y: tuple[float, float]
    """range (low, high) of y [length]"""
    z: tuple[float, float]
    """range (low, high) of z, depths [length]"""
    material: Elastic
    """material of the box"""

    @property
    def parameters(self) -> tuple[float, ...]:
        """Coordinates in the order of enum mdr_shape of mdrcontact/lateral.h [length]."""
        return *self.x, *self.y, *self.z

    def holds(self, x: Any, y: Any, z: Any) -> Any:
        """Return whether points lie inside.

        Parameters
        ----------
        x : array_like
            Coordinates of the points [length]; the three broadcast.
        y : array_like
            Coordinates of the points [length].
        z : array_like
            Depths of the points [length].

        Returns
        -------
        bool or ndarray
            True inside, in the broadcast shape.
        """
        inside = (x > self.x[0]) & (x < self.x[1]) & (y > self.y[0]) & (y < self.y[1])
        return inside & (z > self.z[0]) & (z < self.z[1])


Shape = Layer | HalfSpace | Ball | Fibre | Pillar | Box


@dataclass(frozen=True)
class Shapes(Structure):
    """Half-space with bodies in a background material.

    Where bodies overlap, the later one counts.

    Parameters
    ----------
    background : Elastic
        Material of the half-space.
    shapes : sequence of Layer, HalfSpace, Ball, Fibre, Pillar or Box, optional
        The bodies.
    reference_nu : float, optional
        Poisson's ratio of the weights [1]; None is that of the background.
    tolerance : float, optional
        Relative tolerance of G_eff and nu_eff, 1e-10 to 0.1 [1].
    exponent : float, optional
        p of the mean `G_eff = [sum of w G^p]^(1/p)`, -1 (series) to 1 (parallel); 0 is the mean of the logarithms [1].

    Raises
    ------
    ArgumentTypeError
        A body is not a shape, or a material is not `Elastic`.
    InvalidArgumentError
        A coordinate is missing or outside its range.

    References
    ----------
    popov-2014, section 6

    Examples
    --------
    >>> ball = mdr.lateral.Ball((0.0, 0.0, 8e-6), 5e-6, mdr.Elastic(70e9, 0.22))
    >>> composite = mdr.lateral.Shapes(mdr.Elastic(3e9, 0.35), [ball])
    >>> print(np.round(composite.modulus([0.0, 20e-6], 0.0, 5e-6) / 1e9, 3))
    [11.843  3.484]
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
                raise ArgumentTypeError(f"{body!r}: a shape is a Layer, HalfSpace, Ball, Fibre, Pillar or Box")
            elastic(f"material of {type(body).__name__}", body.material)
        # f2py takes no empty arrays: a layer of the background above the surface is nothing
        known: tuple[Shape, ...] = bodies or (Layer(-2.0, -1.0, base),)
        table = np.zeros((len(known), 7))
        for i, body in enumerate(known):
            try:
                row = numbers("the shape", np.hstack([np.asarray(p) for p in body.parameters]))
            except ValueError as problem:
                raise InvalidArgumentError(f"{body!r}: a coordinate is missing or too many") from problem
            if row.shape != (len(_LENGTHS[type(body)]),):
                raise InvalidArgumentError(f"{body!r}: a coordinate is missing or too many")
            table[i, : row.size] = row
        nu = base.nu if self.reference_nu is None else number("reference_nu", self.reference_nu)
        chosen = {"reference_nu": nu, "tolerance": not_zero("tolerance", tolerance), "exponent": exponent}
        options = record(_layout.structure_options, reference_nu_is_given=True, exponent_is_given=True, **chosen)
        kinds, moduli = [_layout.SHAPE_LAYER + _KINDS.index(type(b)) for b in known], [b.material.E for b in known]
        ratios = [b.material.nu for b in known]
        created = native.structure_shapes(base.E, base.nu, kinds, table, moduli, ratios, options)
        self._own(created, shapes=bodies, tolerance=tolerance, exponent=exponent)

    def materials(self, x: ArrayLike, y: ArrayLike, z: ArrayLike) -> tuple[Any, Any]:
        """Return Young's modulus and Poisson's ratio at points.

        Parameters
        ----------
        x : array_like
            Coordinates of the points [length]; the three broadcast.
        y : array_like
            Coordinates of the points [length].
        z : array_like
            Depths >= 0 of the points [length].

        Returns
        -------
        tuple of ndarray
            E [modulus] and nu [1].
        """
        px, py, pz = np.atleast_1d(*together(x=x, y=y, z=z))
        E, nu = np.full(px.shape, self.background.E), np.full(px.shape, self.background.nu)
        for body in self.shapes:
            inside = body.holds(px, py, pz)
            E[inside], nu[inside] = body.material.E, body.material.nu
        return E, nu


_LENGTHS: dict[type[Any], range] = {
    Layer: range(2), HalfSpace: range(6), Ball: range(4), Fibre: range(7), Pillar: range(5), Box: range(6),
}  # fmt: skip
"""Number of parameters of each shape."""
_KINDS = list(_LENGTHS)
"""In the order of enum mdr_shape in mdrcontact/lateral.h."""
