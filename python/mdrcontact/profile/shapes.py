# SPDX-License-Identifier: GPL-3.0-or-later
"""Indenters with closed forms (theory/paper.md (1.1))."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from .._boundary import native, number
from .._units import ANGLE, LENGTH, RATIO
from ..errors import ArgumentTypeError, InvalidArgumentError
from .base import Profile

__all__ = [
    "Sphere",
    "Paraboloid",
    "Cone",
    "FlatPunch",
    "FlatEndedCone",
    "FlatEndedParaboloid",
    "RoundedCone",
    "PowerLaw",
]


@dataclass(frozen=True)
class Paraboloid(Profile):
    """Rigid paraboloid, `f(r) = r^2/(2 R)`, the approximation of a sphere for a << R.

    Parameters
    ----------
    radius : float
        R, radius of curvature, > 0 [length].

    Raises
    ------
    InvalidArgumentError
        `radius` is not finite and greater than 0.

    References
    ----------
    hertz-1882

    Examples
    --------
    >>> tip = mdr.Paraboloid(10e-6)
    >>> print(f"{tip.height(2e-6):.4e} {tip.mdr(2e-6):.4e}")
    2.0000e-07 4.0000e-07
    """

    radius: float = field(metadata={"dimension": LENGTH})

    def __post_init__(self) -> None:
        self._own(native.profile_paraboloid(*self._numbers()))

    @classmethod
    def between(cls, upper_radius: float, lower_radius: float) -> Paraboloid:
        """Return the gap between two curved bodies, `1/R = 1/R1 + 1/R2`.

        Parameters
        ----------
        upper_radius : float
            R1, radius of the ball, > 0 [length].
        lower_radius : float
            R2, radius of the other body: > 0 for a ball, < 0 for a socket, infinite for a plane [length]. A socket must be at least
            10 % wider than the ball. In narrower sockets the contact width is not small against the radii, and the bodies are not
            half-spaces.

        Returns
        -------
        Paraboloid
            The gap, with the radius R.

        Raises
        ------
        InvalidArgumentError
            `upper_radius` is not finite and greater than 0, `lower_radius` is 0, or the socket is too narrow.
        """
        upper, lower = number("upper_radius", upper_radius), number("lower_radius", lower_radius)
        if not 0.0 < upper < math.inf:
            raise InvalidArgumentError(f"upper_radius = {upper:g}: it must be finite and greater than 0")
        if math.isnan(lower) or lower == 0.0:
            raise InvalidArgumentError(f"lower_radius = {lower:g}: it must be a number other than 0")
        if -1.1 * upper < lower < 0.0:
            raise InvalidArgumentError(
                f"lower_radius = {lower:g}: a socket must be a tenth wider than the ball, {upper:g}, or the contact is conformal"
            )
        return cls(1.0 / (1.0 / upper + 1.0 / lower))


@dataclass(frozen=True)
class Sphere(Profile):
    """Rigid sphere, exact: `f(r) = R - sqrt(R^2 - r^2)`.

    Parameters
    ----------
    radius : float
        R, radius of the sphere, > 0 [length]. The contact radius stays below R.

    Raises
    ------
    InvalidArgumentError
        `radius` is not finite and greater than 0.

    Examples
    --------
    >>> ball = mdr.Sphere(10e-6)
    >>> print(f"{ball.height(2e-6):.4e}")
    2.0204e-07
    """

    radius: float = field(metadata={"dimension": LENGTH})

    def __post_init__(self) -> None:
        self._own(native.profile_sphere(*self._numbers()))


@dataclass(frozen=True)
class Cone(Profile):
    """Rigid cone, `f(r) = r tan(phi)`. Give one of the two angles.

    Parameters
    ----------
    inclination : float, optional
        phi, angle between the face of the cone and the surface, 0 < phi < pi/2 [radian].
    half_angle : float, optional
        Angle between the face and the axis, pi/2 - phi, 0 < half_angle < pi/2 [radian].
    degrees : bool, optional
        If True, the angle is given in degrees. The attribute `inclination` is in radian in both cases.

    Raises
    ------
    ArgumentTypeError
        Neither or both of the angles are given.
    InvalidArgumentError
        The angle is outside its range.

    References
    ----------
    sneddon-1965

    Examples
    --------
    >>> cone = mdr.Cone(half_angle=70.3, degrees=True)
    >>> print(f"{cone.inclination:.4f} {cone.mdr(1e-6):.4e}")
    0.3438 5.6243e-07
    """

    inclination: float = field(metadata={"dimension": ANGLE})

    def __init__(self, inclination: float | None = None, *, half_angle: float | None = None, degrees: bool = False) -> None:
        if (inclination is None) == (half_angle is None):
            raise ArgumentTypeError("give exactly one of inclination and half_angle")
        if inclination is not None:
            phi = _radians("inclination", inclination, degrees)
        else:
            angle = _acute("half_angle", number("half_angle", half_angle), degrees)
            phi = math.radians(90.0 - angle) if degrees else math.pi / 2 - angle
        self._own(native.profile_cone(phi), inclination=phi)


@dataclass(frozen=True)
class PowerLaw(Profile):
    """Rigid indenter with a power-law profile, `f(r) = c r^n`.

    Parameters
    ----------
    exponent : float
        n, 0 < n <= 100 [1].
    coefficient : float
        c > 0 [length^(1-n)].

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    Examples
    --------
    >>> tip = mdr.PowerLaw(4.0, 1e15)
    >>> print(f"{tip.height(1e-6):.4e}")
    1.0000e-09
    """

    exponent: float = field(metadata={"dimension": RATIO})
    coefficient: float

    def __post_init__(self) -> None:
        self._own(native.profile_power(*self._numbers()))


@dataclass(frozen=True)
class FlatPunch(Profile):
    """Rigid flat cylindrical punch. Its contact radius is constant.

    Parameters
    ----------
    radius : float
        b, radius of the punch and of every contact, > 0 [length].

    Raises
    ------
    InvalidArgumentError
        `radius` is not finite and greater than 0.

    Examples
    --------
    >>> punch = mdr.FlatPunch(5e-6)
    >>> contact = mdr.Contact(punch, mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
    >>> print(f"{contact.at_depth(10e-9).force:.4e}")
    7.4143e-03
    """

    radius: float = field(metadata={"dimension": LENGTH})

    def __post_init__(self) -> None:
        self._own(native.profile_flat_punch(*self._numbers()))


@dataclass(frozen=True)
class FlatEndedCone(Profile):
    """Truncated cone, `f(r) = (r - b) tan(phi)` for r > b.

    Parameters
    ----------
    end_radius : float
        b, radius of the flat end, > 0 [length].
    inclination : float
        phi, angle between face and surface, 0 < phi < pi/2 [radian].
    degrees : bool, optional
        If True, `inclination` is given in degrees. The attribute is in radian in both cases.

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    Examples
    --------
    >>> tip = mdr.FlatEndedCone(1e-6, 20.0, degrees=True)
    >>> print(f"{tip.height(2e-6):.4e}")
    3.6397e-07
    """

    end_radius: float = field(metadata={"dimension": LENGTH})
    inclination: float = field(metadata={"dimension": ANGLE})

    def __init__(self, end_radius: float, inclination: float, *, degrees: bool = False) -> None:
        end_radius, phi = number("end_radius", end_radius), _radians("inclination", inclination, degrees)
        self._own(native.profile_flat_cone(end_radius, phi), end_radius=end_radius, inclination=phi)


@dataclass(frozen=True)
class FlatEndedParaboloid(Profile):
    """Worn or truncated paraboloid, `f(r) = (r^2 - b^2)/(2 R)` for r > b.

    Parameters
    ----------
    end_radius : float
        b, radius of the flat end, > 0 [length].
    radius : float
        R, radius of curvature, > 0 [length].

    Raises
    ------
    InvalidArgumentError
        A number is not finite and greater than 0.

    Examples
    --------
    >>> tip = mdr.FlatEndedParaboloid(1e-6, 10e-6)
    >>> print(f"{tip.height(2e-6):.4e}")
    1.5000e-07
    """

    end_radius: float = field(metadata={"dimension": LENGTH})
    radius: float = field(metadata={"dimension": LENGTH})

    def __post_init__(self) -> None:
        self._own(native.profile_flat_paraboloid(*self._numbers()))


@dataclass(frozen=True)
class RoundedCone(Profile):
    """Cone with a parabolic tip that continues it smoothly.

    The profile is `r^2 tan(phi)/(2 b)` up to r = b and `(r - b/2) tan(phi)` beyond. The radius of curvature of the tip is
    b/tan(phi).

    Parameters
    ----------
    blend_radius : float
        b, radius at which the paraboloid ends and the cone begins, > 0 [length].
    inclination : float
        phi, angle between face and surface, 0 < phi < pi/2 [radian].
    degrees : bool, optional
        If True, `inclination` is given in degrees. The attribute is in radian in both cases.

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    Examples
    --------
    >>> tip = mdr.RoundedCone(200e-9, 19.7, degrees=True)
    >>> print(f"{tip.height(1e-6):.4e}")
    3.2225e-07
    """

    blend_radius: float = field(metadata={"dimension": LENGTH})
    inclination: float = field(metadata={"dimension": ANGLE})

    def __init__(self, blend_radius: float, inclination: float, *, degrees: bool = False) -> None:
        blend_radius, phi = number("blend_radius", blend_radius), _radians("inclination", inclination, degrees)
        self._own(native.profile_rounded_cone(blend_radius, phi), blend_radius=blend_radius, inclination=phi)


def _radians(name: str, angle: float, degrees: bool) -> float:
    value = _acute(name, number(name, angle), degrees)
    return math.radians(value) if degrees else value


def _acute(name: str, angle: float, degrees: bool) -> float:
    """`angle` if it is that of a cone. The library uses only the inclination in radian, and its error would name that."""
    right, unit = (90.0, "90 degrees") if degrees else (math.pi / 2, "pi/2 = 1.570796 radian")
    if not 0.0 < angle < right:
        raise InvalidArgumentError(f"{name} = {angle:g}: it must be greater than 0 and less than {unit}")
    return angle
