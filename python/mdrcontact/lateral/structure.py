# SPDX-License-Identifier: GPL-3.0-or-later
"""Base class of laterally heterogeneous structures."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._boundary import FloatOrArray, Handle, call, native, number, together
from .._value import Value
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..material import Elastic


class Bounds(NamedTuple):
    """Bounds of E_eff, from `Structure.bounds`.

    Examples
    --------
    >>> matrix, glass = mdr.Elastic(3e9, 0.3), mdr.Elastic(70e9, 0.3)
    >>> composite = mdr.lateral.Shapes(matrix, [mdr.lateral.Ball((0.0, 0.0, 8e-6), 5e-6, glass)])
    >>> lower, upper = composite.bounds(0.0, 0.0, 5e-6)
    >>> print(f"{lower:.3e} {upper:.3e}")
    3.654e+09 1.082e+10
    """

    lower: FloatOrArray
    """E_eff of the moduli in series [modulus]"""
    upper: FloatOrArray
    """E_eff of the moduli in parallel [modulus]"""


class PowerMean:
    """[sum w x^p]^(1/p) of numbers x > 0: the weighted sum is of transformed numbers, the mean is found from it."""

    def __init__(self, exponent: float, x: NDArray[np.float64]) -> None:
        self._exponent, self._reference = exponent, float(np.sqrt(x.min()) * np.sqrt(x.max()))

    def transformed(self, x: Any) -> Any:
        """phi(x) = ((x/r)^p - 1)/p, which becomes ln(x/r) for p = 0; x itself and 1/x for p = 1 and -1."""
        if abs(self._exponent) == 1.0:
            return x**self._exponent
        phi = np.log(x / self._reference)
        return np.expm1(self._exponent * phi) / self._exponent if self._exponent else phi

    def mean(self, phi: Any) -> Any:
        """The mean that belongs to a weighted sum of phi."""
        if abs(self._exponent) == 1.0:
            return phi**self._exponent
        return self._reference * np.exp(np.log1p(self._exponent * phi) / self._exponent if self._exponent else phi)


@dataclass(frozen=True, eq=False)
class Structure(Value):
    """Base class of half-spaces whose elastic moduli vary in all three directions.

    Structures are immutable and may be shared between threads. The surface is z = 0, and z points into the body.

    References
    ----------
    popov-2014, section 6

    Examples
    --------
    >>> plain = mdr.lateral.Shapes(mdr.Elastic(3e9, 0.35))
    >>> isinstance(plain, mdr.lateral.Structure)
    True
    >>> print(f"{plain.modulus(0.0, 0.0, 1e-6):.4e}")
    3.4188e+09
    """

    def _own(self, created: tuple[int, int], **values: Any) -> None:
        """Takes over what a compiled constructor returned, and the fields as they were understood."""
        self._set(_handle=Handle(created), **values)

    def modulus(self, x: ArrayLike, y: ArrayLike, a: ArrayLike) -> FloatOrArray:
        """Return the effective modulus `E_eff = 2 G_eff/(1 - nu_eff)`, equation (33).

        `G_eff = [sum of w G^p]^(1/p)` with the `exponent` p of the structure: 1 in parallel, -1 in series.

        Parameters
        ----------
        x : array_like
            Positions of contacts [length]. `x`, `y` and `a` broadcast: for a line, x = array and y = 0; for several radii, a[:,
            None].
        y : array_like
            Positions of contacts [length].
        a : array_like
            Contact radii > 0 [length].

        Returns
        -------
        float or ndarray
            E_eff, in the broadcast shape [modulus].

        Raises
        ------
        InvalidArgumentError
            A position is not finite, or a radius is not greater than 0.
        NoConvergenceError
            A quadrature does not reach the tolerance of the structure.
        """
        points = together(x=x, y=y, a=a)
        shape = points[0].shape
        if not points[0].size:
            return np.empty(shape)
        px, py, pa = (np.ascontiguousarray(p, dtype=np.float64).ravel() for p in points)
        values = self._values(px, py, pa)
        return values.reshape(shape) if shape else float(values[0])

    def bounds(self, x: ArrayLike, y: ArrayLike, a: ArrayLike) -> Bounds:
        """Return bounds of E_eff: the moduli in series and in parallel.

        At equal Poisson's ratios the exact E_eff lies between them at any contrast; with several ratios they are a guide.

        Parameters
        ----------
        x : array_like
            As in `modulus` [length].
        y : array_like
            As in `modulus` [length].
        a : array_like
            As in `modulus` [length].

        Returns
        -------
        Bounds
            Lower and upper bound, in the broadcast shape.

        Raises
        ------
        InvalidArgumentError
            As of `modulus`.
        """
        return Bounds(*(self.replace(exponent=p).modulus(x, y, a) for p in (-1.0, 1.0)))

    def _values(self, x: Any, y: Any, a: Any) -> Any:
        return call(native.structure_modulus, self._handle, x, y, a)

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
        """
        raise NotImplementedError


def elastic(name: str, material: Any) -> Elastic:
    """`material` if it is one."""
    if not isinstance(material, Elastic):
        raise ArgumentTypeError(f"{name} = {material!r}: it must be a material, Elastic(E, nu)")
    return material


def exponent_of_mean(value: Any) -> float:
    """`value` if it is a number from -1 to 1."""
    p = number("exponent", value)
    if not abs(p) <= 1.0:
        raise InvalidArgumentError(f"exponent = {p!r}: that of a mean must be at least -1 (series) and at most 1 (parallel)")
    return p


def shear(material: Elastic) -> float:
    """G = E/(2 (1 + nu))."""
    return 0.5 * material.E / (1.0 + material.nu)
