# SPDX-License-Identifier: GPL-3.0-or-later
"""Depth weights of the flat punch's strain energy, equations (12)-(18).

nu : Poisson's ratio, -1 < nu <= 1/2
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from . import _layout
from ._boundary import FloatOrArray, evaluate, native, number

__all__ = ["weight_phi", "weight_i0", "weight_i0_tangential", "weight_i1", "weight_j0", "weight_j0_tangential", "weight_j1"]

_NO_NU = 0.5  # the library takes a Poisson's ratio for all weights; I1 does not depend on it


def weight_phi(xi: ArrayLike, nu: float = 0.5) -> FloatOrArray:
    """Phi(xi) = dI0/dxi, equation (18) at nu = 1/2; xi = z/a >= 0, any shape."""
    poisson = number("nu", nu)
    return evaluate("xi", xi, lambda points: native.weight(_layout.WEIGHT_PHI, poisson, points))


def weight_i0(xi: ArrayLike, nu: float = 0.5) -> FloatOrArray:
    """I0(xi), equations (12)-(15): the share of the shear modulus above the depth z = xi a; xi >= 0, any shape."""
    poisson = number("nu", nu)
    return evaluate("xi", xi, lambda points: native.weight(_layout.WEIGHT_I0, poisson, points))


def weight_i1(xi: ArrayLike) -> FloatOrArray:
    """I1(xi), equations (12)-(15): the share of Poisson's ratio above the depth z = xi a; xi >= 0, any shape."""
    return evaluate("xi", xi, lambda points: native.weight(_layout.WEIGHT_I1, _NO_NU, points))


def weight_j0(xi: ArrayLike, nu: float = 0.5) -> FloatOrArray:
    """1 - I0(xi) to full relative precision, however close to 1 I0 is; xi >= 0, any shape."""
    poisson = number("nu", nu)
    return evaluate("xi", xi, lambda points: native.weight(_layout.WEIGHT_J0, poisson, points))


def weight_j1(xi: ArrayLike) -> FloatOrArray:
    """1 - I1(xi) to full relative precision, however close to 1 I1 is; xi >= 0, any shape."""
    return evaluate("xi", xi, lambda points: native.weight(_layout.WEIGHT_J1, _NO_NU, points))


def weight_i0_tangential(xi: ArrayLike, nu: float = 0.5) -> FloatOrArray:
    """I0(xi) of a load along the surface: the share of the shear modulus above the depth z = xi a in the tangential stiffness,
    I1 + [xi L - xi/(1 + xi^2)]/(2 pi (2 - nu)), L = ln(1 + 1/xi^2); xi >= 0, any shape. Poisson's ratio keeps the weight I1."""
    poisson = number("nu", nu)
    return evaluate("xi", xi, lambda points: native.weight(_layout.WEIGHT_I0_TANGENTIAL, poisson, points))


def weight_j0_tangential(xi: ArrayLike, nu: float = 0.5) -> FloatOrArray:
    """1 less `weight_i0_tangential` to full relative precision; xi >= 0, any shape."""
    poisson = number("nu", nu)
    return evaluate("xi", xi, lambda points: native.weight(_layout.WEIGHT_J0_TANGENTIAL, poisson, points))
