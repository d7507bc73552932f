# SPDX-License-Identifier: GPL-3.0-or-later
"""What the library computes, against formulas, tables and programs of others."""

from __future__ import annotations

from .check import Check, Comparison
from .elements import ELEMENTS
from .formulas import FORMULAS
from .published import PUBLISHED

__all__ = ["CHECKS", "Check", "Comparison"]

CHECKS: tuple[Check, ...] = (*FORMULAS, *PUBLISHED, *ELEMENTS)
"""Every comparison, by the age of its source within each kind."""
