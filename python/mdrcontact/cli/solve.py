# SPDX-License-Identifier: GPL-3.0-or-later
"""The states of a problem, with a progress bar where that takes long."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import _progress
from .._units import MODULUS, RATIO
from ..contact import Contact
from ..medium import Medium
from ..problem.compute import Control
from .table import Column, column, columns_of

Array = NDArray[np.float64]

_CHUNKS = 50


class Curve(NamedTuple):
    """States at ascending prescribed values, SI units."""

    depth: Array
    radius: Array
    force: Array
    stiffness: Array

    @property
    def modulus(self) -> Array:
        """E_eff = k/(2a)."""
        return self.stiffness / (2.0 * self.radius)

    @property
    def mean_pressure(self) -> Array:
        """F/(pi a^2)."""
        return self.force / (math.pi * self.radius**2)


@contextmanager
def progress(curves: int, control: Control) -> Iterator[Any]:
    """A bar on the terminal for that many curves, shown once the work has taken long enough to wonder about."""
    total = curves * len(control.values)
    with _progress.bar(total, "states") as bar:
        yield bar


def solve(contact: Contact, control: Control, bar: Any) -> Curve:
    """The states at all prescribed values."""
    count = len(control.values)
    step = max(1, -(-count // _CHUNKS))
    parts = []
    for start in range(0, count, step):
        part = slice(start, min(start + step, count))
        parts.append(control.states(contact, part))
        bar.update(part.stop - part.start)
    return Curve(*(np.concatenate([np.atleast_1d(getattr(part, name)) for part in parts]) for name in Curve._fields[:4]))


def thickness(medium: Medium) -> float | None:
    """Thickness h of the coating or of all layers together; None for a medium without layers."""
    return math.fsum(h for _, h in medium._stack()) or None


def columns(curve: Curve, medium: Medium) -> list[Column]:
    """What the tables show of a curve."""
    h = thickness(medium)
    return [
        *columns_of(curve, "depth", "radius"),
        *([column("a/h", curve.radius / h, RATIO)] if h else []),
        *columns_of(curve, "force", "stiffness"),
        column("effective modulus", curve.modulus, MODULUS),
        column("mean pressure", curve.mean_pressure, MODULUS),
    ]


def crossing(curve: Curve, value: float) -> float | None:
    """Depth at which the contact radius passes `value`, None if it does not within the curve."""
    if not curve.radius[0] < value < curve.radius[-1]:
        return None
    return float(np.interp(value, curve.radius, curve.depth))
