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
    """Structure given by functions E(x, y, z) and nu(x, y, z).

    Smooth functions converge fast. For functions with jumps use `Shapes` or `Voxels`.

    Parameters
    ----------
    function : callable
        Function of three arrays x, y, z of one shape [length] that returns the pair (E, nu), each a number or an array of that
        shape.
    reference_nu : float
        Poisson's ratio of the weights, -1 < nu <= 0.5 [1].
    tolerance : float, optional
        Relative tolerance of G_eff and nu_eff, 1e-10 to 0.1 [1].
    exponent : float, optional
        p of the mean `G_eff = [sum of w G^p]^(1/p)`, -1 (series) to 1 (parallel); 0 is the mean of the logarithms [1].

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    Examples
    --------
    >>> graded = mdr.lateral.Field(lambda x, y, z: (1e9 * (1.0 + np.exp(-z / 1e-6)), 0.3), reference_nu=0.3)
    >>> print(f"{graded.modulus(0.0, 0.0, 1e-6):.4e}")
    1.5077e+09
    """

    function: Callable[..., Any]
    reference_nu: float
    tolerance: float = field(default=1e-5, kw_only=True)
    exponent: float = field(default=1.0, kw_only=True)

    def __post_init__(self) -> None:
        nu, wanted = number("reference_nu", self.reference_nu), number("tolerance", self.tolerance)
        if not 1e-10 <= wanted <= 0.1:
            raise InvalidArgumentError(f"tolerance = {wanted!r}: it must be from 1e-10 to 0.1")
        if not -1.0 < nu <= 0.5:
            raise InvalidArgumentError(f"reference_nu = {nu!r}: it must be greater than -1 and at most 0.5")
        self._set(reference_nu=nu, tolerance=wanted, exponent=exponent_of_mean(self.exponent))

    def materials(self, x: ArrayLike, y: ArrayLike, z: ArrayLike) -> tuple[Any, Any]:
        """Return Young's modulus and Poisson's ratio at points.

        Parameters
        ----------
        x : array_like
            Coordinates of the points [length]; the three broadcast.
        y : array_like
            Coordinates of the points [length].
        z : array_like
            Depths >= 0 of the points [length].

        Returns
        -------
        tuple of ndarray
            E [modulus] and nu [1].

        Raises
        ------
        CallbackError
            The function returns a value that is not finite or outside its range.
        """
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
