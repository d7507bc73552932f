# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a figure. Values are in the units of their axes."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._units import Dimension, Unit, practical

Array = NDArray[np.float64]
FEW = 12
"""Values that are marked each."""


class Axis(NamedTuple):
    """A quantity with its unit along one side of a panel."""

    name: str
    unit: str = ""
    log: bool = False
    low: float | None = None
    high: float | None = None
    whole: bool = False
    """True if its values are counts"""
    names: tuple[str, ...] = ()
    """of the values 1, 2, ..."""

    @property
    def title(self) -> str:
        """Name and unit."""
        return f"{self.name} [{self.unit}]" if self.unit else self.name


class Line(NamedTuple):
    """Points joined by a line, or points alone."""

    x: Array
    y: Array
    name: str = ""
    colour: int | str = 0
    """number of a colour that is distinct from the others, or "grey", "pale", "black", "white" """
    dash: int = 0
    """0 solid, 1 dashed, 2 dotted, -1 no line"""
    marker: str = ""
    """"." (small), "o", "s", "^" or "x" """
    width: float = 1.6
    error: Array | None = None
    """half length of the bars of y"""


class Rule(NamedTuple):
    """A straight line across a panel."""

    at: float
    vertical: bool = False
    name: str = ""
    """text at its end"""
    colour: int | str = "grey"
    dash: int = 2


class Label(NamedTuple):
    """A point with a text."""

    x: float
    y: float
    text: str
    colour: int | str = "black"
    marker: str = "o"


class Cells(NamedTuple):
    """A map of values over x and y."""

    x: Array
    y: Array
    values: Array
    """a row for each y; NaN for missing values"""
    axis: Axis
    """of the values; beyond its limits the colours end, and the bar has an arrow"""
    two_sided: bool = False
    """True if 0 is the middle of the colours"""
    smooth: bool = True
    """False for values of pixels"""
    bar: bool = True
    """True if the map shows the bar of its colours"""


class Bars(NamedTuple):
    """Counts between edges."""

    edges: Array
    counts: Array
    colour: int | str = 0


class Band(NamedTuple):
    """The region between two curves."""

    x: Array
    low: Array
    high: Array
    name: str = ""
    colour: int | str = "grey"


Part = Line | Rule | Label | Cells | Bars | Band


class Panel(NamedTuple):
    """One system of axes and what is drawn in it."""

    x: Axis
    y: Axis
    parts: tuple[Part, ...] = ()
    title: str = ""
    equal: bool = False
    """True if both axes have the same scale"""
    downward: bool = False
    """True if y is a depth"""


class Sheet(NamedTuple):
    """Panels under one title."""

    title: str
    """lines of text above the panels"""
    panels: tuple[Panel, ...]
    """systems of axes with what is drawn, row by row"""
    columns: int = 2
    """number of panels side by side"""
    heights: tuple[float, ...] = ()
    """of the rows, relative; equal if empty"""
    warnings: tuple[str, ...] = ()
    """sentences that a reader must not overlook"""


def along(name: str, dimension: Dimension, values: Any, **options: Any) -> tuple[Axis, Unit]:
    """Return an axis in the practical unit of its values, and the unit."""
    unit = practical(dimension, values)
    return Axis(name, unit.symbol, **options), unit


def marked(values: Any, marker: str = "o") -> str:
    """Return a marker if the values are few: the line between them only joins them."""
    return marker if len(values) <= FEW else ""


def cut(values: Array, low: float, high: float) -> Array:
    """Return values with NaN outside the limits."""
    return np.where((values < low) | (values > high), np.nan, values)


def limits(cells: Cells) -> tuple[float, float]:
    """Return the ends of the colours of a map."""
    low = float(np.nanmin(cells.values)) if cells.axis.low is None else cells.axis.low
    high = float(np.nanmax(cells.values)) if cells.axis.high is None else cells.axis.high
    return low, high if high > low else low + (1e-9 * abs(low) or 1.0)


def side_of(panel: Panel, label: Label) -> str:
    """Return the side of its point on which a text has room, "right" or "left"."""
    ends = [end for one in panel.parts if isinstance(one, Line | Cells) for end in (np.nanmin(one.x), np.nanmax(one.x))]
    return "right" if not ends or label.x < min(ends) + 0.6 * (max(ends) - min(ends)) else "left"


def place_of(panel: Panel, label: Label) -> tuple[str, str]:
    """Return where a text meets no line: "above" or "below" its point, on its side "right" or "left"; several texts in turn."""
    side = side_of(panel, label)
    labels = [part for part in panel.parts if isinstance(part, Label)]
    if len(labels) > 1:
        return ("above", "below")[labels.index(label) % 2], side
    return "above" if _rises(panel, label.x) == (side == "left") else "below", side


def _rises(panel: Panel, x: float) -> bool:
    """Whether the first line of a panel rises there."""
    for line in (part for part in panel.parts if isinstance(part, Line) and len(part.x) > 1):
        i = min(int(np.argmin(np.abs(line.x - x))), len(line.x) - 2)
        return bool((line.y[i + 1] - line.y[i]) * (line.x[i + 1] - line.x[i]) >= 0.0)
    return False
