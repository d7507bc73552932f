# SPDX-License-Identifier: GPL-3.0-or-later
"""Columns of numbers with units, as text for the screen and as CSV."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._text import aligned
from .._units import QUANTITIES, Dimension, Unit, practical


class Column(NamedTuple):
    """A named quantity, SI values, and the unit it is printed in."""

    name: str
    values: NDArray[np.float64]
    unit: Unit

    @property
    def title(self) -> str:
        """Name and unit."""
        return f"{self.name} [{self.unit.name}]" if self.unit.name else self.name


def column(name: str, values: NDArray[np.float64], dimension: Dimension) -> Column:
    """A column in the practical unit that suits its largest value."""
    return Column(name, values, practical(dimension, values))


def columns_of(states: Any, *names: str) -> list[Column]:
    """What states hold, by the names of their fields."""
    return [column(name.replace("_", " "), np.asarray(getattr(states, name), dtype=float), QUANTITIES[name]) for name in names]


def number(value: float) -> str:
    """A number for the screen: five digits."""
    if not np.isfinite(value):
        return "-"
    return f"{value:.5g}" if value == 0.0 or 1e-3 <= abs(value) < 1e6 else f"{value:.4e}"


def spread_over(count: int, most: int) -> list[int]:
    """At most `most` of the indices 0 ... count-1, evenly spread, the last one among them."""
    if count <= most:
        return list(range(count))
    return [round((i + 1) * count / most) - 1 for i in range(most)]


def as_text(columns: Sequence[Column], rows: int) -> str:
    """A table for the screen with at most `rows` rows."""
    picked = spread_over(len(columns[0].values), rows)
    body = [[number(float(c.unit.of(c.values[i]))) for c in columns] for i in picked]
    return aligned([[c.title for c in columns], *body], left=0)


def as_csv(columns: Sequence[Column], labels: tuple[str, Sequence[str]] | None = None) -> bytes:
    """All rows as CSV with full precision; `labels` is a column of words that goes first."""
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([*([labels[0]] if labels else []), *(c.title for c in columns)])
    for i in range(len(columns[0].values)):
        writer.writerow([*([labels[1][i]] if labels else []), *(repr(float(c.unit.of(c.values[i]))) for c in columns)])
    return text.getvalue().encode()
