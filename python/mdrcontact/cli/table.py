# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of results as text for the screen and as CSV."""

from __future__ import annotations

import csv
import io

from .._text import aligned, number
from .._units import shown
from ..studies.result import Column, Mixed, Table, Words, spread_over


def spread_text(ratio: float) -> str:
    """How far the largest of some values is above the smallest, by their ratio."""
    if ratio < 3.0:
        return f"{100.0 * (ratio - 1.0):.1f} %"
    return f"factor {ratio:.1f}" if ratio < 100.0 else f"factor {ratio:.0f}"


def as_text(table: Table, rows: int | None = None) -> str:
    """A table for the screen with at most `rows` rows; columns of words that come first begin flush left."""
    count = len(table[0].values)
    picked = range(count) if rows is None else spread_over(count, rows)
    left = next((i for i, c in enumerate(table) if not isinstance(c, Words)), len(table))
    return aligned([[c.title for c in table], *([_cell(c, i) for c in table] for i in picked)], left=left)


def _cell(column: Column | Mixed | Words, row: int) -> str:
    if isinstance(column, Words):
        return column.values[row]
    if isinstance(column, Mixed):
        return column.instead[row] if row in column.instead else shown(column.values[row], column.dimension)
    return number(float(column.unit.of(column.values[row])))


def as_csv(table: Table) -> bytes:
    """All rows as CSV with full precision."""
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([c.title for c in table])
    for i in range(len(table[0].values)):
        writer.writerow([repr(float(c.unit.of(c.values[i]))) if isinstance(c, Column) else _cell(c, i) for c in table])
    return text.getvalue().encode()
