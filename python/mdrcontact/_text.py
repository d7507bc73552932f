# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists and tables for the screen and for notebooks."""

from __future__ import annotations

import itertools
import math
import textwrap
from collections.abc import Iterable, Sequence
from html import escape


def aligned(rows: Sequence[Sequence[str]], left: int | None = None) -> str:
    """Rows of words as a table; the first `left` columns begin flush left, the others end flush right; None: all left."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    begin = len(widths) if left is None else left
    lines = []
    for row in rows:
        cells = [cell.ljust(w) if i < begin else cell.rjust(w) for i, (cell, w) in enumerate(zip(row, widths, strict=True))]
        lines.append("  ".join(cells).rstrip())
    return "\n".join(lines)


def wrapped(rows: Sequence[Sequence[str]], width: int) -> list[list[str]]:
    """Rows of a table of at most `width` characters: what is wider than the other columns continues in further rows."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    room = width - 2 * (len(widths) - 1)
    most = max(widths)
    while sum(min(w, most) for w in widths) > room and most > 1:
        most -= 1
    found: list[list[str]] = []
    for row in rows:
        cells = [textwrap.wrap(cell, most) or [""] for cell in row]
        found += [list(line) for line in itertools.zip_longest(*cells, fillvalue="")]
    return found


def listed(title: object, lines: Iterable[str]) -> str:
    """Lines below their title."""
    return "\n".join([str(title), *(f"  {line}" for line in lines)])


def number(value: float) -> str:
    """A number for the screen: five digits."""
    if not math.isfinite(value):
        return "-"
    return f"{value:.5g}" if value == 0.0 or 1e-3 <= abs(value) < 1e6 else f"{value:.4e}"


def html_table(rows: Sequence[Sequence[str]]) -> str:
    """A table for a page or a notebook; its first row holds the titles."""
    lines = ["".join(f"<th>{escape(cell)}</th>" for cell in rows[0])]
    lines += ["".join(f"<td>{escape(cell)}</td>" for cell in row) for row in rows[1:]]
    return "<table>" + "".join(f"<tr>{line}</tr>" for line in lines) + "</table>"
