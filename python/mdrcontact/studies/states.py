# SPDX-License-Identifier: GPL-3.0-or-later
"""The states of a problem, which several studies show."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from .._units import MODULUS, RATIO
from ..contact import Contact
from ..medium import Medium
from ..problem.compute import Control
from .result import Array, Column, column, columns_of

_CHUNKS = 50


class Curve(NamedTuple):
    """States at ascending prescribed values, SI units."""

    depth: Array
    radius: Array
    force: Array
    stiffness: Array
    """dF/dd at constant contact radius"""
    slope: Array
    """dF/dd along the branch of equilibria, which differs from the stiffness under adhesion"""

    @property
    def has_slope(self) -> bool:
        """Return whether the slope differs from the stiffness."""
        return not np.array_equal(self.slope, self.stiffness)

    @property
    def modulus(self) -> Array:
        """E_eff = k/(2a)."""
        return self.stiffness / (2.0 * self.radius)

    @property
    def mean_pressure(self) -> Array:
        """F/(pi a^2)."""
        return self.force / (math.pi * self.radius**2)


def solve(contact: Contact, control: Control, done: Callable[[int], None]) -> Curve:
    """The states at all prescribed values. done : called with the number of states after each part of them"""
    count = len(control.values)
    step = max(1, -(-count // _CHUNKS))
    parts = []
    for start in range(0, count, step):
        part = slice(start, min(start + step, count))
        parts.append(control.states(contact, part))
        done(part.stop)
    return Curve(*(np.concatenate([np.atleast_1d(getattr(part, name)) for part in parts]) for name in Curve._fields))


def thickness(medium: Medium) -> float | None:
    """Thickness h of the coating or of all layers together [m]; None for a medium without layers."""
    return math.fsum(h for _, h in medium._stack()) or None


def columns(curve: Curve, medium: Medium) -> list[Column]:
    """Return the columns of a curve."""
    h = thickness(medium)
    return [
        *columns_of(curve, "depth", "radius"),
        *([column("a/h", curve.radius / h, RATIO)] if h else []),
        *columns_of(curve, "force", "stiffness"),
        *(columns_of(curve, "slope") if curve.has_slope else []),
        column("effective modulus", curve.modulus, MODULUS),
        column("mean pressure", curve.mean_pressure, MODULUS),
    ]
