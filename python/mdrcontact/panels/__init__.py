# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures as data: what a study shows, before a library draws it for a file, a notebook or the page."""

from .figure import Figure
from .panel import Axis, Band, Bars, Cells, Label, Line, Panel, Part, Rule, along, cut, marked

__all__ = ["Axis", "Band", "Bars", "Cells", "Figure", "Label", "Line", "Panel", "Part", "Rule", "along", "cut", "marked"]
