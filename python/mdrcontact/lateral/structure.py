# SPDX-License-Identifier: GPL-3.0-or-later
"""What every laterally heterogeneous structure can do."""

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
    """Between which E_eff lies [modulus]."""

    lower: FloatOrArray
    """the moduli in series"""
    upper: FloatOrArray
    """the moduli in parallel"""


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
    """A half-space z > 0 whose elastic moduli vary in all three directions. It never changes and may be shared between threads."""

    def _own(self, created: tuple[int, int], **values: Any) -> None:
        """Takes over what a compiled constructor returned, and the fields as they were understood."""
        self._set(_handle=Handle(created), **values)

    def modulus(self, x: ArrayLike, y: ArrayLike, a: ArrayLike) -> FloatOrArray:
        """E_eff(a, x, y) = 2 G_eff/(1 - nu_eff) [modulus], equation (33), for contacts of radius a > 0 at (x, y) [length].

        G_eff = [sum of w G^p]^(1/p) with the structure's `exponent` p: 1 in parallel, -1 in series.
        The three broadcast: a line is x = array, y = 0; several radii at each of its points are a[:, None].
        """
        points = together(x=x, y=y, a=a)
        shape = points[0].shape
        if not points[0].size:
            return np.empty(shape)
        px, py, pa = (np.ascontiguousarray(p, dtype=np.float64).ravel() for p in points)
        values = self._values(px, py, pa)
        return values.reshape(shape) if shape else float(values[0])

    def bounds(self, x: ArrayLike, y: ArrayLike, a: ArrayLike) -> Bounds:
        """Between which E_eff(a, x, y) lies [modulus]: the moduli in series below, in parallel above; arguments as of modulus().

        At one Poisson's ratio the exact E_eff lies between the two at any contrast; with several it is a guide.
        """
        return Bounds(*(self.replace(exponent=p).modulus(x, y, a) for p in (-1.0, 1.0)))

    def _values(self, x: Any, y: Any, a: Any) -> Any:
        return call(native.structure_modulus, self._handle, x, y, a)

    def materials(self, x: ArrayLike, y: ArrayLike, z: ArrayLike) -> tuple[Any, Any]:
        """E and nu at points, which broadcast; z >= 0 [length]."""
        raise NotImplementedError


def elastic(name: str, material: Any) -> Elastic:
    """`material` if it is one."""
    if not isinstance(material, Elastic):
        raise ArgumentTypeError(f"{name} = {material!r} is not allowed: it must be a material, Elastic(E, nu)")
    return material


def exponent_of_mean(value: Any) -> float:
    """`value` if it is a number from -1 to 1."""
    p = number("exponent", value)
    if not abs(p) <= 1.0:
        raise InvalidArgumentError(
            f"exponent = {p!r} is not allowed: that of a mean must be at least -1 (series) and at most 1 (parallel)"
        )
    return p


def shear(material: Elastic) -> float:
    """G = E/(2 (1 + nu))."""
    return 0.5 * material.E / (1.0 + material.nu)
