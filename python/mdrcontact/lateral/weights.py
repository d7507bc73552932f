# SPDX-License-Identifier: GPL-3.0-or-later
"""How much each point and each cell of a structure counts (theory/lateral.md (2.4), (2.5))."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._boundary import call, native, number, numbers, together
from ..errors import InvalidArgumentError


def density(rho: ArrayLike, z: ArrayLike, nu: float = 0.5) -> tuple[Any, Any]:
    """Weights of G (at constant nu) and of nu at distance rho from the axis and depth z, both >= 0 in units of a; they broadcast.

    nu : Poisson's ratio of the reference medium. Each weight has the integral 1 over the half-space; over a plane z it is
    dI0/dz and dI1/dz of theory/paper.md (3.3), (3.4). Infinite at the edge of the contact, rho = 1, z = 0.
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
    """Weights of G and of nu integrated over cells between ascending lines x and y, relative to the contact's axis, and two depths.

    Returns two arrays of shape (len(y) - 1, len(x) - 1).
    """
    lines_x, lines_y = numbers("x", x), numbers("y", y)
    if lines_x.ndim != 1 or lines_y.ndim != 1 or lines_x.size < 2 or lines_y.size < 2:
        raise InvalidArgumentError("x and y must be arrays of one dimension with at least 2 lines")
    depths = number("z_top", z_top), number("z_bottom", z_bottom)
    shear, poisson = call(native.lateral_cells, number("nu", nu), number("a", a), *depths, lines_x, lines_y)
    return shear, poisson
