# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed forms for a paraboloid or cone on an incompressible coating (nu = 1/2), equations (24), (27), (29), (31), (32).

They are what a `Contact` on `Coated(..., model="gao")` gives for incompressible bodies, whose E is 3 G.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _layout
from ._boundary import FloatOrArray, evaluate, native, number

__all__ = [
    "coated_paraboloid_force",
    "coated_cone_force",
    "coated_paraboloid_adhesive_depth",
    "adhesive_radius_scale",
    "adhesive_depth_scale",
    "reduced_adhesive_depth",
]


def coated_paraboloid_force(
    a: ArrayLike, radius: float, coating_shear: float, substrate_shear: float, thickness: float
) -> FloatOrArray:
    """F(a) [modulus length^2] of a paraboloid without adhesion, equation (24).

    a : contact radii > 0 [length], any shape
    radius : R > 0 [length]
    coating_shear, substrate_shear : shear moduli G0, G1 > 0 [modulus]
    thickness : h > 0 [length]
    """
    given = _numbers(radius=radius, coating_shear=coating_shear, substrate_shear=substrate_shear, thickness=thickness)
    return _values(_layout.FORM_PARABOLOID_FORCE, "a", a, given)


def coated_cone_force(
    a: ArrayLike, inclination: float, coating_shear: float, substrate_shear: float, thickness: float
) -> FloatOrArray:
    """F(a) [modulus length^2] of a cone without adhesion, equation (27): 2 pi a^2 tan(phi) [G1 + (G0 - G1) (2/pi) arctan(h/a)].

    inclination : phi, 0 < phi < pi/2 [radian]; the others as in `coated_paraboloid_force`
    """
    given = _numbers(inclination=inclination, coating_shear=coating_shear, substrate_shear=substrate_shear, thickness=thickness)
    return _values(_layout.FORM_CONE_FORCE, "a", a, given)


def coated_paraboloid_adhesive_depth(
    a: ArrayLike,
    radius: float,
    coating_shear: float,
    substrate_shear: float,
    thickness: float,
    work_of_adhesion: float,
) -> FloatOrArray:
    """d(a) [length] of an adhesive paraboloid by the source's rule, equation (29): a^2/R - sqrt(2 pi a gamma/E_eff(a)).

    work_of_adhesion : gamma >= 0 [modulus length]; the others as in `coated_paraboloid_force`
    """
    given = _numbers(
        radius=radius,
        coating_shear=coating_shear,
        substrate_shear=substrate_shear,
        thickness=thickness,
        work_of_adhesion=work_of_adhesion,
    )
    return _values(_layout.FORM_ADHESIVE_DEPTH, "a", a, given)


def adhesive_radius_scale(radius: float, substrate_shear: float, work_of_adhesion: float) -> float:
    """a_c = (pi gamma R^2/(32 G1))^(1/3) [length], equation (31): the contact radius at which a paraboloid on the uncoated
    substrate breaks off under prescribed depth.

    radius : R > 0 [length]
    substrate_shear : G1 > 0 [modulus]
    work_of_adhesion : gamma > 0 [modulus length]
    """
    return _scale(_layout.FORM_RADIUS_SCALE, radius, substrate_shear, work_of_adhesion)


def adhesive_depth_scale(radius: float, substrate_shear: float, work_of_adhesion: float) -> float:
    """d_c = 3 (pi^2 gamma^2 R/(2^10 G1^2))^(1/3) [length], equation (31): minus the depth there. Arguments as in
    `adhesive_radius_scale`."""
    return _scale(_layout.FORM_DEPTH_SCALE, radius, substrate_shear, work_of_adhesion)


def reduced_adhesive_depth(reduced_radius: ArrayLike, shear_ratio: float, reduced_thickness: float) -> FloatOrArray:
    """d/d_c, equation (32): at^2/3 - (4/3) sqrt(at) [1 + (tau - 1) I0(ht/at; nu = 1/2)]^(-1/2).

    reduced_radius : at = a/a_c > 0, any shape
    shear_ratio : tau = G0/G1 > 0
    reduced_thickness : ht = h/a_c > 0
    """
    given = _numbers(shear_ratio=shear_ratio, reduced_thickness=reduced_thickness)
    return _values(_layout.FORM_REDUCED_DEPTH, "reduced_radius", reduced_radius, given)


def _numbers(**values: Any) -> list[float]:
    return [number(name, value) for name, value in values.items()]


def _scale(formula: int, radius: float, substrate_shear: float, work_of_adhesion: float) -> float:
    given = _numbers(substrate_shear=substrate_shear, work_of_adhesion=work_of_adhesion)
    return float(_values(formula, "radius", number("radius", radius), given))


def _values(formula: int, name: str, x: ArrayLike, constants: list[float]) -> FloatOrArray:
    numbers = np.array(constants)
    return evaluate(name, x, lambda points: native.closed_form(formula, points, numbers))
