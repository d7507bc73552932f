# SPDX-License-Identifier: GPL-3.0-or-later
"""The contact that closed forms are compared with, in any one consistent unit."""

from __future__ import annotations

import math

from ..contact import Contact, State
from ..friction import Friction
from ..material import Elastic
from ..medium import Homogeneous
from ..profile import Paraboloid
from .check import Array

SHEAR, NU, RADIUS = 1.3, 0.3, 2.0
"""Shear modulus, Poisson's ratio and radius of the paraboloid."""
MATERIAL = Elastic(2.0 * SHEAR * (1.0 + NU), NU)
BODY = Homogeneous(MATERIAL)
MODULUS = 2.0 * SHEAR / (1.0 - NU)
"""E*"""
FRICTION = 0.3
ROUNDING = 1e-9
LIBRARY = "rounding and tolerance of the library"


def ball() -> Contact:
    """The paraboloid on the half-space."""
    return Contact(Paraboloid(RADIUS), BODY)


def pressed() -> tuple[Friction, State]:
    """The same with friction, and a state of it."""
    contact = ball()
    return Friction(contact, FRICTION), contact.at_depth(0.01)


def hertz_force(depth: Array) -> Array:
    """F = (4/3) E* sqrt(R) d^(3/2)."""
    return 4.0 / 3.0 * MODULUS * math.sqrt(RADIUS) * depth**1.5
