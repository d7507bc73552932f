# SPDX-License-Identifier: GPL-3.0-or-later
"""What every medium can do."""

from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike

from .. import _native
from .._boundary import FloatOrArray, Handle, evaluate, thread_count
from .._described import Described


class Medium(Described):
    """An elastic half-space: for a contact radius a it gives the effective contact modulus E_eff(a), equation (10).

    Lengths and moduli are in the units of the whole problem. A medium never changes and may be shared between threads.

    threads : for arrays, see `Contact`
    """

    _handle: Handle

    def _own(self, created: tuple[int, int], **arguments: Any) -> None:
        """Takes over what a compiled constructor returned and remembers the arguments that rebuild it."""
        object.__setattr__(self, "_handle", Handle(created, _native.medium_free))
        self._describe(**arguments)

    def modulus(self, a: ArrayLike, *, threads: int = 1) -> FloatOrArray:
        """E_eff(a) [pressure] at contact radii a > 0 [length], any shape."""
        return evaluate(_native.medium_modulus, thread_count(threads), self._handle.address, name="a", values=a)

    def stiffness(self, a: ArrayLike, *, threads: int = 1) -> FloatOrArray:
        """k(a) = dF/dd = 2 a E_eff(a) [force/length] at contact radii a > 0 [length], any shape."""
        return evaluate(_native.medium_stiffness, thread_count(threads), self._handle.address, name="a", values=a)
