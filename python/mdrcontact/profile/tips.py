# SPDX-License-Identifier: GPL-3.0-or-later
"""Tips of nanoindentation: pyramids as their equivalent cones, and calibrated tips by their area function.

See theory/paper.md (1.4).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, ClassVar

from numpy.typing import ArrayLike

from .._boundary import native, number, row
from .._units import LENGTH
from .base import Profile

__all__ = [
    "Berkovich",
    "Vickers",
    "CubeCorner",
    "AreaFunction",
]


@dataclass(frozen=True)
class _Pyramid(Profile):
    """A pyramid as the cone of equal projected area at every height; `inclination` is that cone's [radian]."""

    half_angle_degrees: ClassVar[float]

    def __post_init__(self) -> None:
        self._own(native.profile_cone(self.inclination))

    @property
    def inclination(self) -> float:
        """phi of the equivalent cone, the angle between face and surface [radian]."""
        return math.radians(90.0 - self.half_angle_degrees)


@dataclass(frozen=True)
class Berkovich(_Pyramid):
    """Three-sided Berkovich pyramid as its equivalent cone, half-angle 70.30 degrees.

    The equivalent cone has the projected area of the pyramid at every height.

    Examples
    --------
    >>> tip = mdr.Berkovich()
    >>> print(tip.half_angle_degrees, f"{tip.inclination:.4f}")
    70.3 0.3438
    """

    half_angle_degrees = 70.30


@dataclass(frozen=True)
class Vickers(_Pyramid):
    """Four-sided Vickers pyramid as its equivalent cone, half-angle 70.30 degrees.

    The equivalent cone has the projected area of the pyramid at every height.

    Examples
    --------
    >>> tip = mdr.Vickers()
    >>> print(tip.half_angle_degrees, f"{tip.height(1e-6):.4e}")
    70.3 3.5805e-07
    """

    half_angle_degrees = 70.30


@dataclass(frozen=True)
class CubeCorner(_Pyramid):
    """Cube corner as its equivalent cone, half-angle 42.28 degrees.

    The equivalent cone has the projected area of the pyramid at every height.

    Examples
    --------
    >>> tip = mdr.CubeCorner()
    >>> print(tip.half_angle_degrees, f"{tip.height(1e-6):.4e}")
    42.28 1.0998e-06
    """

    half_angle_degrees = 42.28


@dataclass(frozen=True)
class AreaFunction(Profile):
    """Calibrated tip given by its area function A(f), with A = pi r^2.

    The area at height f is `A(f) = C0 f^2 + C1 f + C2 f^(1/2) + C3 f^(1/4) + ...`.

    Parameters
    ----------
    coefficients : array_like
        C0 [1], C1 [length], C2 [length^(3/2)], ... The area must grow with f between `min_height` and `max_height`.
    max_height : float
        Height up to which the tip is used, > `min_height` [length].
    min_height : float, optional
        Height below which the fitted area is not reliable; the tip there is a paraboloid that meets the area at this height
        [length]. 0, the default, uses the calibration from the apex on.

    Raises
    ------
    InvalidArgumentError
        The area does not grow with the height, or a height is outside its range.

    References
    ----------
    oliver-1992

    Examples
    --------
    >>> tip = mdr.AreaFunction([24.5, 1e-6], max_height=1e-6)
    >>> print(f"{tip.height(2e-6):.4e}")
    6.9606e-07
    """

    coefficients: tuple[float, ...]
    max_height: float = field(metadata={"dimension": LENGTH})
    min_height: float = field(metadata={"dimension": LENGTH})

    def __init__(self, coefficients: ArrayLike, *, max_height: float, min_height: float = 0.0) -> None:
        terms = row("coefficients", coefficients)
        max_height, min_height = number("max_height", max_height), number("min_height", min_height)
        self._own(
            native.profile_area_function(terms, min_height, max_height),
            coefficients=terms,
            max_height=max_height,
            min_height=min_height,
        )

    def _constants(self) -> dict[str, Any]:
        return {f"C{i}": value for i, value in enumerate(self.coefficients)}

    def _rebuilt(self, constants: dict[str, Any]) -> AreaFunction:
        return self.replace(coefficients=tuple(constants.values()))
