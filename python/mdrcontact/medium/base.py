# SPDX-License-Identifier: GPL-3.0-or-later
"""What every medium can do."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from numpy.typing import ArrayLike

from .. import _native
from .._boundary import FloatOrArray, Handle, evaluate, numbers
from .._value import Value


@dataclass(frozen=True)
class Medium(Value):
    """An elastic half-space: for a contact radius a it gives the effective contact modulus E_eff(a), equation (10).

    Lengths and moduli are in the units of the whole problem. A medium never changes and may be shared between threads.
    """

    def _own(self, created: tuple[int, int], **values: Any) -> None:
        """Takes over what a compiled constructor returned, and the fields as they were understood."""
        self._set(_handle=Handle(created, _native.medium_free), **values)

    def _tolerance(self) -> float:
        """The tolerance that was given for its solution, 0 where none was."""
        return 0.0

    def modulus(self, a: ArrayLike) -> FloatOrArray:
        """E_eff(a) [modulus] at contact radii a > 0 [length], any shape."""
        return evaluate("a", a, lambda radii: _native.medium_modulus(self._handle.address, radii))

    def stiffness(self, a: ArrayLike) -> FloatOrArray:
        """k(a) = dF/dd = 2 a E_eff(a) [modulus length] at contact radii a > 0 [length], any shape."""
        return evaluate("a", a, lambda radii: _native.medium_stiffness(self._handle.address, radii))

    def tangential_modulus(self, a: ArrayLike) -> FloatOrArray:
        """G_t(a) = k_t(a)/(2 a) [modulus] at contact radii a > 0 [length], any shape: what takes E_eff's place where a contact that
        sticks all over is displaced along the surface. 4 G/(2 - nu) of a homogeneous body.

        Known for homogeneous media with E and nu, the model "exact" (but for the displacement that varies as cos 2 phi around the
        axis: low by at most 0.35 %), Gao's weights with those of a tangential load, and pairs of these. The kernel of a layered
        body is tabulated in each call: ask for all radii at once.
        """
        return evaluate("a", a, lambda radii: _native.medium_tangential_modulus(self._handle.address, radii))

    def torsional_stiffness(self, a: ArrayLike) -> FloatOrArray:
        """M/phi [modulus length^3] at contact radii a > 0 [length], any shape, of a contact that sticks all over and is twisted
        about its axis: 16 G a^3/3 of a homogeneous body. Known, exactly, for homogeneous media with E and nu, the model "exact" and
        pairs of these."""
        return evaluate("a", a, lambda radii: _native.medium_torsional_stiffness(self._handle.address, radii))

    def tangential_stiffness(self, a: ArrayLike) -> FloatOrArray:
        """k_t(a) = dT/ds = 2 a G_t(a) [modulus length] at contact radii a > 0 [length], any shape; see `tangential_modulus`."""
        return 2.0 * numbers("a", a) * self.tangential_modulus(a)
