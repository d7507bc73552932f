# SPDX-License-Identifier: GPL-3.0-or-later
"""Structures given by functions of position."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._boundary import call, native, number, together
from ..errors import CallbackError, InvalidArgumentError, NoConvergenceError
from .structure import PowerMean, Structure, exponent_of_mean

_ORDERS = (8, 16, 32, 64)


@dataclass(frozen=True)
class Field(Structure):
    """A structure of moduli E(x, y, z) and nu(x, y, z).

    function : takes three arrays x, y, z of the same shape [length] and returns the pair (E, nu), each a number or such an array
    reference_nu : Poisson's ratio of the weights, -1 < nu <= 1/2
    tolerance : relative error of G_eff and nu_eff, 1e-10 to 0.1
    exponent : p of the mean G_eff = [sum of w G^p]^(1/p): 1 in parallel, -1 in series, 0 the mean of the logarithms

    Smooth functions converge fast. For those with jumps Shapes or Voxels are the better description.
    """

    function: Callable[..., Any]
    reference_nu: float
    tolerance: float = field(default=1e-5, kw_only=True)
    exponent: float = field(default=1.0, kw_only=True)

    def __post_init__(self) -> None:
        nu, wanted = number("reference_nu", self.reference_nu), number("tolerance", self.tolerance)
        if not 1e-10 <= wanted <= 0.1:
            raise InvalidArgumentError(f"tolerance = {wanted!r} is not allowed: it must be from 1e-10 to 0.1")
        if not -1.0 < nu <= 0.5:
            raise InvalidArgumentError(f"reference_nu = {nu!r} is not allowed: it must be greater than -1 and at most 0.5")
        self._set(reference_nu=nu, tolerance=wanted, exponent=exponent_of_mean(self.exponent))

    def materials(self, x: ArrayLike, y: ArrayLike, z: ArrayLike) -> tuple[Any, Any]:
        """E and nu at points, which broadcast."""
        px, py, pz = together(x=x, y=y, z=z)
        E, nu = (np.broadcast_to(np.asarray(v, dtype=float), px.shape) for v in self.function(px, py, pz))
        if not (np.all(np.isfinite(E)) and np.all(E > 0.0) and np.all((nu > -1.0) & (nu <= 0.5))):
            raise CallbackError("the function of the structure must return finite E > 0 and -1 < nu <= 0.5")
        return E, nu

    def _values(self, x: Any, y: Any, a: Any) -> Any:
        if not (np.all(np.isfinite(x)) and np.all(np.isfinite(y)) and np.all(np.isfinite(a)) and np.all(a > 0.0)):
            raise InvalidArgumentError("x, y and a must be finite, and a greater than 0")
        values = np.empty(len(x))
        for i in range(len(x)):
            values[i] = self._value(x[i], y[i], a[i])
        return values

    def _value(self, x: float, y: float, a: float) -> float:
        before = None
        for order in _ORDERS:
            points, weights = (rows.T for rows in call(native.lateral_rule, order, self.reference_nu))
            E, nu = self.materials(x + a * points[0], y + a * points[1], a * points[2])
            G = 0.5 * E / (1.0 + nu)
            mean = PowerMean(self.exponent, G)
            phi = mean.transformed(G)
            found = np.array([mean.mean(phi[0] + weights[0] @ (phi - phi[0])), nu[0] + weights[1] @ (nu - nu[0])])
            if before is not None:
                error = np.max(np.abs(found - before) / [found[0], 1.0 - found[1]])
                if error <= self.tolerance:
                    return float(2.0 * found[0] / (1.0 - found[1]))
            before = found
        raise NoConvergenceError(
            f"E_eff at x = {x:.7g}, y = {y:.7g}, a = {a:.7g} is known to {error:.2g} only: the tolerance is {self.tolerance:.2g}"
        )
