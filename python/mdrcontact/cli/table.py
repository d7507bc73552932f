# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of results as text for the screen and as CSV."""

from __future__ import annotations

import csv
import io

from .._text import aligned, number
from .._units import shown
from ..instruments.fitting.quantities import digits
from ..studies.result import Column, Mixed, Table, Words, spread_over


def spread_text(ratio: float) -> str:
    """Return the ratio of the largest to the smallest value as text."""
    if ratio < 3.0:
        return f"{100.0 * (ratio - 1.0):.1f} %"
    return f"factor {ratio:.1f}" if ratio < 100.0 else f"factor {ratio:.0f}"


def as_text(table: Table, rows: int | None = None, left: int | None = None) -> str:
    """Return a table as text with at most `rows` rows. The first `left` columns are flush left; default: those of words."""
    if left is None:
        left = next((i for i, c in enumerate(table) if not isinstance(c, Words)), len(table))
    return aligned(as_rows(table, rows), left=left)


def as_rows(table: Table, rows: int | None = None) -> list[list[str]]:
    """Return the titles and at most `rows` rows of a table as text."""
    count = len(table[0].values)
    picked = range(count) if rows is None else spread_over(count, rows)
    return [[c.title for c in table], *([cell_text(c, i) for c in table] for i in picked)]


def cell_text(column: Column | Mixed | Words, row: int) -> str:
    """Return a cell of a table as text."""
    if isinstance(column, Words):
        return column.values[row]
    if row in column.instead:
        return column.instead[row]
    if isinstance(column, Mixed):
        return shown(column.values[row], column.dimension)
    return number(float(column.unit.of(column.values[row])))


def with_errors(table: Table) -> list[Words]:
    """Return columns of numbers as text, each with the standard errors of the next column."""
    columns = [c for c in table if isinstance(c, Column)]
    found = []
    for c, error in zip(columns, [*columns[1:], None], strict=True):
        if c.name == "standard error":
            continue
        values = [float(v) for v in c.unit.of(c.values)]
        cells = [number(v) for v in values]
        if error is not None and error.name == "standard error":
            sds = [float(v) for v in error.unit.of(error.values)]
            cells = [f"{digits(v, sd)} ± {digits(sd, sd)}" for v, sd in zip(values, sds, strict=True)]
        found.append(Words(c.title, cells))
    return found


def as_csv(table: Table) -> bytes:
    """Return all rows as CSV with full precision."""
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([c.title for c in table])
    for i in range(len(table[0].values)):
        writer.writerow([_full(c, i) for c in table])
    return text.getvalue().encode()


def _full(column: Column | Mixed | Words, row: int) -> str:
    """Return a cell in full precision."""
    if isinstance(column, Column) and row not in column.instead:
        return repr(float(column.unit.of(column.values[row])))
    return cell_text(column, row)
