# SPDX-License-Identifier: GPL-3.0-or-later
"""What every laterally heterogeneous structure can do."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .. import _native
from .._boundary import FloatOrArray, Handle, call, numbers
from .._value import Value
from ..errors import ArgumentTypeError
from ..material import Elastic


@dataclass(frozen=True)
class Structure(Value):
    """A half-space z > 0 whose elastic moduli vary in all three directions. It never changes and may be shared between threads."""

    def _own(self, created: tuple[int, int], **values: Any) -> None:
        """Takes over what a compiled constructor returned, and the fields as they were understood."""
        self._set(_handle=Handle(created, _native.structure_free), **values)

    def modulus(self, x: ArrayLike, y: ArrayLike, a: ArrayLike) -> FloatOrArray:
        """E_eff(a, x, y) = 2 G_eff/(1 - nu_eff) [modulus], equation (33), for contacts of radius a > 0 at (x, y) [length].

        The three broadcast: a line is x = array, y = 0; several radii at each of its points are a[:, None].
        """
        points = np.broadcast_arrays(numbers("x", x), numbers("y", y), numbers("a", a))
        shape = points[0].shape
        if not points[0].size:
            return np.empty(shape)
        px, py, pa = (np.ascontiguousarray(p, dtype=np.float64).ravel() for p in points)
        values = self._values(px, py, pa)
        return values.reshape(shape) if shape else float(values[0])

    def _values(self, x: Any, y: Any, a: Any) -> Any:
        return call(_native.structure_modulus, self._handle.address, x, y, a)

    def materials(self, x: ArrayLike, y: ArrayLike, z: ArrayLike) -> tuple[Any, Any]:
        """E and nu at points, which broadcast; z >= 0 [length]."""
        raise NotImplementedError


def elastic(name: str, material: Any) -> Elastic:
    """`material` if it is one."""
    if not isinstance(material, Elastic):
        raise ArgumentTypeError(f"{name} = {material!r} is not allowed: it must be a material, Elastic(E, nu)")
    return material


def shear(material: Elastic) -> float:
    """G = E/(2 (1 + nu))."""
    return 0.5 * material.E / (1.0 + material.nu)
