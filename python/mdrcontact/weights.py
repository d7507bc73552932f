# SPDX-License-Identifier: GPL-3.0-or-later
"""Depth weights of the flat punch's strain energy, equations (13)-(18).

threads : for arrays, see `Contact`
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from . import _native
from ._boundary import FloatOrArray, evaluate, number, thread_count

__all__ = ["weight_phi", "weight_i0", "weight_i1", "weight_j0", "weight_j1"]

_NO_NU = 0.5  # the library takes a Poisson's ratio for all weights; I1 does not depend on it


def weight_phi(xi: ArrayLike, nu: float = 0.5, *, threads: int = 1) -> FloatOrArray:
    """Phi(xi) = dI0/dxi, equation (18) at nu = 1/2; xi = z/a >= 0, any shape."""
    return evaluate(_native.weight_phi, thread_count(threads), number("nu", nu), name="xi", values=xi)


def weight_i0(xi: ArrayLike, nu: float = 0.5, *, threads: int = 1) -> FloatOrArray:
    """I0(xi), equation (15): the share of the shear modulus above the depth z = xi a; xi >= 0, any shape."""
    return evaluate(_native.weight_i0, thread_count(threads), number("nu", nu), name="xi", values=xi)


def weight_i1(xi: ArrayLike, *, threads: int = 1) -> FloatOrArray:
    """I1(xi), equation (14): the share of Poisson's ratio above the depth z = xi a; xi >= 0, any shape."""
    return evaluate(_native.weight_i1, thread_count(threads), _NO_NU, name="xi", values=xi)


def weight_j0(xi: ArrayLike, nu: float = 0.5, *, threads: int = 1) -> FloatOrArray:
    """1 - I0(xi) to full relative precision, however close to 1 I0 is; xi >= 0, any shape."""
    return evaluate(_native.weight_j0, thread_count(threads), number("nu", nu), name="xi", values=xi)


def weight_j1(xi: ArrayLike, *, threads: int = 1) -> FloatOrArray:
    """1 - I1(xi) to full relative precision, however close to 1 I1 is; xi >= 0, any shape."""
    return evaluate(_native.weight_j1, thread_count(threads), _NO_NU, name="xi", values=xi)
