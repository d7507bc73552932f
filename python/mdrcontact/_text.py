# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists and tables for the screen."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence


def aligned(rows: Sequence[Sequence[str]], left: int | None = None) -> str:
    """Rows of words as a table; the first `left` columns begin flush left, the others end flush right; None: all left."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    begin = len(widths) if left is None else left
    lines = []
    for row in rows:
        cells = [cell.ljust(w) if i < begin else cell.rjust(w) for i, (cell, w) in enumerate(zip(row, widths, strict=True))]
        lines.append("  ".join(cells).rstrip())
    return "\n".join(lines)


def listed(title: object, lines: Iterable[str]) -> str:
    """Lines below their title."""
    return "\n".join([str(title), *(f"  {line}" for line in lines)])


def number(value: float) -> str:
    """A number for the screen: five digits."""
    if not math.isfinite(value):
        return "-"
    return f"{value:.5g}" if value == 0.0 or 1e-3 <= abs(value) < 1e6 else f"{value:.4e}"
