# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of the library, compared with formulas, tables and other programs."""

from __future__ import annotations

from .adhesive import ADHESION
from .check import Check, Comparison, Group
from .conducting import CONDUCTING
from .elements import ELEMENTS
from .inside import INSIDE
from .layers import LAYERS
from .normal import NORMAL
from .products import PRODUCTS
from .programs import PROGRAMS
from .relaxing import RELAXING
from .rubbing import RUBBING
from .wearing import WEARING
from .yielding import YIELDING

__all__ = ["CHECKS", "GROUPS", "Check", "Comparison"]

GROUPS: tuple[Group, ...] = (
    Group("normal", "Normal contact", NORMAL),
    Group("layers", "Layers that slide, rest on springs, or are under stress", LAYERS),
    Group("inside", "Stresses inside", INSIDE),
    Group("adhesion", "Adhesion", ADHESION),
    Group("friction", "Friction", RUBBING),
    Group("time", "Viscoelastic bodies and gels", RELAXING),
    Group("conduction", "Heat and current", CONDUCTING),
    Group("wear", "Wear", WEARING),
    Group("plastic", "Bodies that yield", YIELDING),
    Group("products", "Laws, fits, composites", PRODUCTS),
    Group("elements", "Finite elements", ELEMENTS),
    Group("programs", "Boundary-element programs", PROGRAMS),
)
"""The comparisons by capability, and those with programs of others."""
CHECKS: tuple[Check, ...] = tuple(check for group in GROUPS for check in group.checks)
"""All of them."""
