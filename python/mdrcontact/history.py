# SPDX-License-Identifier: GPL-3.0-or-later
"""Histories of contacts with viscoelastic bodies (docs/time.md)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout, _native
from ._boundary import check, numbers
from .errors import ArgumentTypeError, InvalidArgumentError

__all__ = ["History"]


class History(NamedTuple):
    """The path of a contact in time: arrays of one length."""

    time: NDArray[np.float64]
    """[time]"""
    depth: NDArray[np.float64]
    """d, indentation depth [length]"""
    radius: NDArray[np.float64]
    """a, contact radius, 0 where the bodies are apart [length]"""
    force: NDArray[np.float64]
    """F, normal force [modulus length^2]"""

    @property
    def work(self) -> float:
        """The work of the force along the path, int F dd [modulus length^3], by the trapezoidal rule: over a closed path the energy
        lost in the body."""
        return float(np.sum(0.5 * (self.force[1:] + self.force[:-1]) * np.diff(np.maximum(self.depth, 0.0))))


_GIVEN = {"depth": _layout.GIVEN_DEPTH, "force": _layout.GIVEN_FORCE, "radius": _layout.GIVEN_RADIUS}


def history(contact: int, time: ArrayLike, depth: ArrayLike | None, force: ArrayLike | None, radius: ArrayLike | None) -> History:
    """The history of a contact's handle."""
    prescribed = {"depth": depth, "force": force, "radius": radius}
    given = [name for name, values in prescribed.items() if values is not None]
    if len(given) != 1:
        raise ArgumentTypeError(f"a history needs one of depth, force and radius, not {' and '.join(given) or 'none'}")
    t, values = numbers("time", time), numbers(given[0], prescribed[given[0]])  # type: ignore[arg-type]
    if t.ndim != 1 or t.shape != values.shape:
        raise InvalidArgumentError(
            f"time and {given[0]} must have one dimension and the same length, not {t.shape} and {values.shape}"
        )
    if not t.size:
        return History(t, t.copy(), t.copy(), t.copy())
    status, *columns = _native.contact_history(contact, _GIVEN[given[0]], t, values)
    check(status)
    return History(t, *columns)
