# SPDX-License-Identifier: GPL-3.0-or-later
"""Depth weights of the strain energy under a flat punch, equations (12)-(18)."""

from __future__ import annotations

from numpy.typing import ArrayLike

from . import _layout
from ._boundary import FloatOrArray, evaluate, native, number

__all__ = ["weight_phi", "weight_i0", "weight_i0_tangential", "weight_i1", "weight_j0", "weight_j0_tangential", "weight_j1"]

_NO_NU = 0.5  # the library takes a Poisson's ratio for all weights; I1 does not depend on it


def weight_phi(xi: ArrayLike, nu: float = 0.5) -> FloatOrArray:
    """Return the weight `Phi(xi) = dI0/dxi`, equation (18) at nu = 1/2.

    Parameters
    ----------
    xi : array_like
        z/a, depth over contact radius, >= 0, any shape [1].
    nu : float, optional
        Poisson's ratio, -1 < nu <= 0.5 [1].

    Returns
    -------
    float or ndarray
        Phi, in the shape of `xi` [1].

    Raises
    ------
    InvalidArgumentError
        `xi` is negative, or `nu` is outside its range.

    References
    ----------
    popov-2014, equation (18)
    gao-1992

    Examples
    --------
    >>> print(np.round(mdr.weights.weight_phi([0.0, 0.5, 1.0]), 6))
    [0.31831  0.356507 0.31831 ]
    """
    poisson = number("nu", nu)
    return evaluate("xi", xi, lambda points: native.weight(_layout.WEIGHT_PHI, poisson, points))


def weight_i0(xi: ArrayLike, nu: float = 0.5) -> FloatOrArray:
    """Return the weight I0(xi), the share of the shear modulus above a depth.

    Parameters
    ----------
    xi : array_like
        z/a, depth over contact radius, >= 0, any shape [1].
    nu : float, optional
        Poisson's ratio, -1 < nu <= 0.5 [1].

    Returns
    -------
    float or ndarray
        I0, in the shape of `xi`, from 0 at the surface to 1 [1].

    Raises
    ------
    InvalidArgumentError
        `xi` is negative, or `nu` is outside its range.

    References
    ----------
    popov-2014, equations (12)-(15)
    gao-1992

    Examples
    --------
    >>> print(np.round(mdr.weights.weight_i0([0.0, 1.0, 10.0]), 6))
    [0.       0.340845 0.905033]
    """
    poisson = number("nu", nu)
    return evaluate("xi", xi, lambda points: native.weight(_layout.WEIGHT_I0, poisson, points))


def weight_i1(xi: ArrayLike) -> FloatOrArray:
    """Return the weight I1(xi), the share of Poisson's ratio above a depth.

    Parameters
    ----------
    xi : array_like
        z/a, depth over contact radius, >= 0, any shape [1].

    Returns
    -------
    float or ndarray
        I1, in the shape of `xi`, from 0 at the surface to 1 [1].

    Raises
    ------
    InvalidArgumentError
        `xi` is negative.

    References
    ----------
    popov-2014, equations (12)-(15)
    gao-1992

    Examples
    --------
    >>> print(np.round(mdr.weights.weight_i1([0.0, 1.0, 10.0]), 6))
    [0.       0.720636 0.968222]
    """
    return evaluate("xi", xi, lambda points: native.weight(_layout.WEIGHT_I1, _NO_NU, points))


def weight_j0(xi: ArrayLike, nu: float = 0.5) -> FloatOrArray:
    """Return `1 - I0(xi)` with full relative accuracy.

    Parameters
    ----------
    xi : array_like
        z/a, depth over contact radius, >= 0, any shape [1].
    nu : float, optional
        Poisson's ratio, -1 < nu <= 0.5 [1].

    Returns
    -------
    float or ndarray
        1 - I0, in the shape of `xi` [1].

    Raises
    ------
    InvalidArgumentError
        `xi` is negative, or `nu` is outside its range.

    References
    ----------
    gao-1992

    Examples
    --------
    >>> print(f"{mdr.weights.weight_j0(1e14):.6e} {1.0 - mdr.weights.weight_i0(1e14):.6e}")
    9.549297e-15 9.547918e-15
    """
    poisson = number("nu", nu)
    return evaluate("xi", xi, lambda points: native.weight(_layout.WEIGHT_J0, poisson, points))


def weight_j1(xi: ArrayLike) -> FloatOrArray:
    """Return `1 - I1(xi)` with full relative accuracy.

    Parameters
    ----------
    xi : array_like
        z/a, depth over contact radius, >= 0, any shape [1].

    Returns
    -------
    float or ndarray
        1 - I1, in the shape of `xi` [1].

    Raises
    ------
    InvalidArgumentError
        `xi` is negative.

    References
    ----------
    gao-1992

    Examples
    --------
    >>> print(f"{mdr.weights.weight_j1(1e6):.6e}")
    3.183099e-07
    """
    return evaluate("xi", xi, lambda points: native.weight(_layout.WEIGHT_J1, _NO_NU, points))


def weight_i0_tangential(xi: ArrayLike, nu: float = 0.5) -> FloatOrArray:
    """Return the weight I0(xi) of a tangential load.

    It is the share of the shear modulus above the depth z = xi a in the tangential stiffness,
    `I1 + [xi L - xi/(1 + xi^2)]/(2 pi (2 - nu))` with `L = ln(1 + 1/xi^2)`. Poisson's ratio has the weight I1.

    Parameters
    ----------
    xi : array_like
        z/a, depth over contact radius, >= 0, any shape [1].
    nu : float, optional
        Poisson's ratio, -1 < nu <= 0.5 [1].

    Returns
    -------
    float or ndarray
        I0 of a tangential load, in the shape of `xi`, from 0 at the surface to 1 [1].

    Raises
    ------
    InvalidArgumentError
        `xi` is negative, or `nu` is outside its range.

    Examples
    --------
    >>> print(np.round(mdr.weights.weight_i0_tangential([0.0, 1.0, 10.0]), 6))
    [0.       0.741129 0.968274]
    """
    poisson = number("nu", nu)
    return evaluate("xi", xi, lambda points: native.weight(_layout.WEIGHT_I0_TANGENTIAL, poisson, points))


def weight_j0_tangential(xi: ArrayLike, nu: float = 0.5) -> FloatOrArray:
    """Return 1 minus `weight_i0_tangential` with full relative accuracy.

    Parameters
    ----------
    xi : array_like
        z/a, depth over contact radius, >= 0, any shape [1].
    nu : float, optional
        Poisson's ratio, -1 < nu <= 0.5 [1].

    Returns
    -------
    float or ndarray
        1 - I0 of a tangential load, in the shape of `xi` [1].

    Raises
    ------
    InvalidArgumentError
        `xi` is negative, or `nu` is outside its range.

    Examples
    --------
    >>> print(f"{mdr.weights.weight_j0_tangential(1e6):.6e}")
    3.183099e-07
    """
    poisson = number("nu", nu)
    return evaluate("xi", xi, lambda points: native.weight(_layout.WEIGHT_J0_TANGENTIAL, poisson, points))
