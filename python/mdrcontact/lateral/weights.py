# SPDX-License-Identifier: GPL-3.0-or-later
"""Weights of points and cells of a structure in E_eff."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._boundary import call, native, number, numbers, together
from ..errors import InvalidArgumentError


def density(rho: ArrayLike, z: ArrayLike, nu: float = 0.5) -> tuple[Any, Any]:
    """Return the weights of G (at constant nu) and of nu at points.

    The integral of each weight over the half-space is 1. Its integral over a plane z is dI0/dz and dI1/dz.

    Parameters
    ----------
    rho : array_like
        Distances from the axis, >= 0, in units of the contact radius [1]. `rho` and `z` broadcast.
    z : array_like
        Depths >= 0, in units of the contact radius [1].
    nu : float, optional
        Poisson's ratio of the reference medium, -1 < nu <= 0.5 [1].

    Returns
    -------
    tuple
        Weights of G and of nu, in the broadcast shape; infinite at the contact edge, rho = 1 and z = 0.

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    Examples
    --------
    >>> shear, poisson = mdr.lateral.density(0.0, 1.0)
    >>> print(f"{shear:.5f} {poisson:.5f}")
    0.03800 0.05066
    """
    r, d = together(rho=rho, z=z)
    if not r.size:
        return np.empty(r.shape), np.empty(r.shape)
    shear, poisson = call(native.lateral_density, r.ravel(), d.ravel(), number("nu", nu))
    if not r.shape:
        return float(shear[0]), float(poisson[0])
    return shear.reshape(r.shape), poisson.reshape(r.shape)


def cell_weights(
    a: float, x: ArrayLike, y: ArrayLike, z_top: float, z_bottom: float, nu: float = 0.5
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the weights of G and of nu integrated over cells between two depths.

    Parameters
    ----------
    a : float
        Contact radius > 0 [length].
    x : array_like
        Ascending lines between cells, relative to the axis of the contact, at least 2 [length].
    y : array_like
        As `x` [length].
    z_top : float
        Upper depth >= 0 [length].
    z_bottom : float
        Lower depth > `z_top` [length].
    nu : float, optional
        Poisson's ratio of the reference medium, -1 < nu <= 0.5 [1].

    Returns
    -------
    tuple of ndarray
        Weights of G and of nu, (len(y) - 1, len(x) - 1) [1].

    Raises
    ------
    InvalidArgumentError
        The lines do not ascend, or a number is outside its range.

    Examples
    --------
    >>> lines = np.linspace(-50.0, 50.0, 3)
    >>> shear, poisson = mdr.lateral.cell_weights(1.0, lines, lines, 0.0, 1.0)
    >>> print(f"{shear.sum():.4f} {mdr.weights.weight_i0(1.0):.4f}")
    0.3408 0.3408
    """
    lines_x, lines_y = numbers("x", x), numbers("y", y)
    if lines_x.ndim != 1 or lines_y.ndim != 1 or lines_x.size < 2 or lines_y.size < 2:
        raise InvalidArgumentError("x and y must be arrays of one dimension with at least 2 lines")
    depths = number("z_top", z_top), number("z_bottom", z_bottom)
    shear, poisson = call(native.lateral_cells, number("nu", nu), number("a", a), *depths, lines_x, lines_y)
    return shear, poisson
