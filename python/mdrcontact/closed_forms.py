# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed forms for a paraboloid or cone on an incompressible coated body.

A `Contact` on `Coated(..., model="gao")` gives the same numbers for incompressible bodies (nu = 1/2, E = 3 G).
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
    """Return the force F(a) of a paraboloid without adhesion, equation (24).

    Parameters
    ----------
    a : array_like
        Contact radii > 0, any shape [length].
    radius : float
        R, radius of curvature, > 0 [length].
    coating_shear : float
        G0, shear modulus of the coating, > 0 [modulus].
    substrate_shear : float
        G1, shear modulus of the substrate, > 0 [modulus].
    thickness : float
        h, thickness of the coating, > 0 [length].

    Returns
    -------
    float or ndarray
        F, in the shape of `a` [modulus length^2].

    Raises
    ------
    InvalidArgumentError
        A number is not finite and greater than 0.

    References
    ----------
    popov-2014, equation (24)

    Examples
    --------
    >>> F = mdr.closed_forms.coated_paraboloid_force(1e-6, 10e-6, 2e6, 1e6, 1e-6)
    >>> film = mdr.Coated(mdr.Elastic(6e6, 0.5), 1e-6, mdr.Elastic(3e6, 0.5), "gao")
    >>> print(f"{F:.6e} {mdr.Contact(mdr.Paraboloid(10e-6), film).at_radius(1e-6).force:.6e}")
    7.739535e-07 7.739535e-07
    """
    given = _numbers(radius=radius, coating_shear=coating_shear, substrate_shear=substrate_shear, thickness=thickness)
    return _values(_layout.FORM_PARABOLOID_FORCE, "a", a, given)


def coated_cone_force(
    a: ArrayLike, inclination: float, coating_shear: float, substrate_shear: float, thickness: float
) -> FloatOrArray:
    """Return the force F(a) of a cone without adhesion, equation (27).

    The force is `2 pi a^2 tan(phi) [G1 + (G0 - G1) (2/pi) arctan(h/a)]`.

    Parameters
    ----------
    a : array_like
        Contact radii > 0, any shape [length].
    inclination : float
        phi, angle between the face of the cone and the surface, 0 < phi < pi/2 [radian].
    coating_shear : float
        G0, shear modulus of the coating, > 0 [modulus].
    substrate_shear : float
        G1, shear modulus of the substrate, > 0 [modulus].
    thickness : float
        h, thickness of the coating, > 0 [length].

    Returns
    -------
    float or ndarray
        F, in the shape of `a` [modulus length^2].

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    References
    ----------
    popov-2014, equation (27)

    Examples
    --------
    >>> F = mdr.closed_forms.coated_cone_force(1e-6, 0.1, 2e6, 1e6, 1e-6)
    >>> print(f"{F:.6e} {2.0 * np.pi * 1e-12 * np.tan(0.1) * 1.5e6:.6e}")
    9.456320e-07 9.456320e-07
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
    """Return the depth d(a) of an adhesive paraboloid, equation (29).

    The depth is `a^2/R - sqrt(2 pi a gamma/E_eff(a))`.

    Parameters
    ----------
    a : array_like
        Contact radii > 0, any shape [length].
    radius : float
        R, radius of curvature, > 0 [length].
    coating_shear : float
        G0, shear modulus of the coating, > 0 [modulus].
    substrate_shear : float
        G1, shear modulus of the substrate, > 0 [modulus].
    thickness : float
        h, thickness of the coating, > 0 [length].
    work_of_adhesion : float
        gamma >= 0 [modulus length].

    Returns
    -------
    float or ndarray
        d, in the shape of `a` [length].

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    References
    ----------
    popov-2014, equation (29)

    Examples
    --------
    >>> d = mdr.closed_forms.coated_paraboloid_adhesive_depth(1e-6, 10e-6, 2e6, 1e6, 1e-6, 0.05)
    >>> print(f"{d:.4e}")
    -1.4202e-07
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
    """Return the radius scale `a_c = (pi gamma R^2/(32 G1))^(1/3)`, equation (31).

    At this contact radius a paraboloid on the uncoated substrate detaches under prescribed depth.

    Parameters
    ----------
    radius : float
        R, radius of curvature, > 0 [length].
    substrate_shear : float
        G1, shear modulus of the substrate, > 0 [modulus].
    work_of_adhesion : float
        gamma > 0 [modulus length].

    Returns
    -------
    float
        a_c [length].

    Raises
    ------
    InvalidArgumentError
        A number is not finite and greater than 0.

    References
    ----------
    popov-2014, equation (31)

    Examples
    --------
    >>> print(f"{mdr.closed_forms.adhesive_radius_scale(10e-6, 1e6, 0.05):.4e}")
    7.8884e-07
    """
    return _scale(_layout.FORM_RADIUS_SCALE, radius, substrate_shear, work_of_adhesion)


def adhesive_depth_scale(radius: float, substrate_shear: float, work_of_adhesion: float) -> float:
    """Return the depth scale d_c of an adhesive paraboloid, equation (31).

    The scale `d_c = 3 (pi^2 gamma^2 R/(2^10 G1^2))^(1/3)` is minus the depth at which a paraboloid on the uncoated substrate
    detaches under prescribed depth.

    Parameters
    ----------
    radius : float
        R, radius of curvature, > 0 [length].
    substrate_shear : float
        G1, shear modulus of the substrate, > 0 [modulus].
    work_of_adhesion : float
        gamma > 0 [modulus length].

    Returns
    -------
    float
        d_c [length].

    Raises
    ------
    InvalidArgumentError
        A number is not finite and greater than 0.

    References
    ----------
    popov-2014, equation (31)

    Examples
    --------
    >>> print(f"{mdr.closed_forms.adhesive_depth_scale(10e-6, 1e6, 0.05):.4e}")
    1.8668e-07
    >>> rubber = mdr.Homogeneous(mdr.Elastic(3e6, 0.5))
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), rubber, work_of_adhesion=0.05)
    >>> print(f"{contact.pull_off('depth').depth:.4e}")
    -1.8668e-07
    """
    return _scale(_layout.FORM_DEPTH_SCALE, radius, substrate_shear, work_of_adhesion)


def reduced_adhesive_depth(reduced_radius: ArrayLike, shear_ratio: float, reduced_thickness: float) -> FloatOrArray:
    """Return the reduced depth d/d_c of an adhesive paraboloid, equation (32).

    Parameters
    ----------
    reduced_radius : array_like
        a/a_c > 0, any shape [1].
    shear_ratio : float
        tau = G0/G1 > 0 [1].
    reduced_thickness : float
        h/a_c > 0 [1].

    Returns
    -------
    float or ndarray
        d/d_c, in the shape of `reduced_radius` [1].

    Raises
    ------
    InvalidArgumentError
        A number is not finite and greater than 0.

    References
    ----------
    popov-2014, equation (32)

    Examples
    --------
    >>> print(f"{mdr.closed_forms.reduced_adhesive_depth(1.0, 1.0, 1.0):.6f}")
    -1.000000
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
