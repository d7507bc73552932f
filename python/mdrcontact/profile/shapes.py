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
    """A paraboloid, f = r^2/(2R): the usual approximation of a sphere for a << R. radius: R > 0 [length]."""

    radius: float = field(metadata={"dimension": LENGTH})

    def __post_init__(self) -> None:
        self._own(native.profile_paraboloid(*self._numbers()))

    @classmethod
    def between(cls, upper_radius: float, lower_radius: float) -> Paraboloid:
        """The gap between two curved bodies, 1/R = 1/R1 + 1/R2: a ball on a ball, or with lower_radius < 0 in a socket.

        upper_radius : R1 > 0 [length]
        lower_radius : R2, not 0; infinite for a plane. A socket must be at least a tenth wider than the ball: closer ones touch
            conformally, over a width that is no longer small against the radii, and are not half-spaces to each other
        """
        upper, lower = number("upper_radius", upper_radius), number("lower_radius", lower_radius)
        if not 0.0 < upper < math.inf:
            raise InvalidArgumentError(f"upper_radius = {upper:g} is not allowed: it must be finite and greater than 0")
        if math.isnan(lower) or lower == 0.0:
            raise InvalidArgumentError(f"lower_radius = {lower:g} is not allowed: it must be a number other than 0")
        if -1.1 * upper < lower < 0.0:
            raise InvalidArgumentError(
                f"lower_radius = {lower:g} is not allowed: a socket must be a tenth wider than the ball, {upper:g}, or the "
                "contact is conformal"
            )
        return cls(1.0 / (1.0 / upper + 1.0 / lower))


@dataclass(frozen=True)
class Sphere(Profile):
    """A sphere, exact: f = R - sqrt(R^2 - r^2). radius: R > 0 [length]; the contact radius stays below R."""

    radius: float = field(metadata={"dimension": LENGTH})

    def __post_init__(self) -> None:
        self._own(native.profile_sphere(*self._numbers()))


@dataclass(frozen=True)
class Cone(Profile):
    """A cone, f = r tan(phi). Give one of:

    inclination : phi, angle between the cone's face and the surface, 0 < phi < pi/2 [radian]
    half_angle : angle between the cone's face and its axis, pi/2 - phi, 0 < half_angle < pi/2 [radian]
    degrees : whether the angle is in degrees; `.inclination` is in radian all the same
    """

    inclination: float = field(metadata={"dimension": ANGLE})

    def __init__(self, inclination: float | None = None, *, half_angle: float | None = None, degrees: bool = False) -> None:
        if (inclination is None) == (half_angle is None):
            raise ArgumentTypeError("a cone needs one of inclination and half_angle, and not both")
        if inclination is not None:
            phi = _radians("inclination", inclination, degrees)
        else:
            angle = _acute("half_angle", number("half_angle", half_angle), degrees)
            phi = math.radians(90.0 - angle) if degrees else math.pi / 2 - angle
        self._own(native.profile_cone(phi), inclination=phi)


@dataclass(frozen=True)
class PowerLaw(Profile):
    """A power law, f = c r^n. exponent: n, 0 < n <= 100; coefficient: c > 0 [length^(1-n)]."""

    exponent: float = field(metadata={"dimension": RATIO})
    coefficient: float

    def __post_init__(self) -> None:
        self._own(native.profile_power(*self._numbers()))


@dataclass(frozen=True)
class FlatPunch(Profile):
    """A flat cylindrical punch. radius: b > 0 [length], the contact radius at every depth."""

    radius: float = field(metadata={"dimension": LENGTH})

    def __post_init__(self) -> None:
        self._own(native.profile_flat_punch(*self._numbers()))


@dataclass(frozen=True)
class FlatEndedCone(Profile):
    """A truncated cone, f = (r - b) tan(phi) for r > b.

    end_radius : b > 0, radius of the flat end [length]
    inclination : phi, angle between face and surface, 0 < phi < pi/2 [radian, or degrees with degrees=True]
    """

    end_radius: float = field(metadata={"dimension": LENGTH})
    inclination: float = field(metadata={"dimension": ANGLE})

    def __init__(self, end_radius: float, inclination: float, *, degrees: bool = False) -> None:
        end_radius, phi = number("end_radius", end_radius), _radians("inclination", inclination, degrees)
        self._own(native.profile_flat_cone(end_radius, phi), end_radius=end_radius, inclination=phi)


@dataclass(frozen=True)
class FlatEndedParaboloid(Profile):
    """A worn or truncated paraboloid, f = (r^2 - b^2)/(2R) for r > b.

    end_radius : b > 0, radius of the flat end [length]
    radius : R > 0, radius of curvature [length]
    """

    end_radius: float = field(metadata={"dimension": LENGTH})
    radius: float = field(metadata={"dimension": LENGTH})

    def __post_init__(self) -> None:
        self._own(native.profile_flat_paraboloid(*self._numbers()))


@dataclass(frozen=True)
class RoundedCone(Profile):
    """A cone whose tip is a paraboloid that meets it without a kink: f = r^2 tan(phi)/(2b) up to r = b, (r - b/2) tan(phi) beyond.

    blend_radius : b > 0, where the rounding ends [length]; the tip's radius of curvature is b/tan(phi)
    inclination : phi, angle between face and surface, 0 < phi < pi/2 [radian, or degrees with degrees=True]
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
    """`angle` if it is one of a cone. The library knows the inclination in radian only, and would name that one."""
    right, unit = (90.0, "90 degrees") if degrees else (math.pi / 2, "pi/2 = 1.570796 radian")
    if not 0.0 < angle < right:
        raise InvalidArgumentError(f"{name} = {angle:g} is not allowed: it must be greater than 0 and less than {unit}")
    return angle
