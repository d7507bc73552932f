# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers as tables contain them: decimal points and commas, groups of thousands, and marks of missing numbers."""

from __future__ import annotations

import math
import re
from typing import Any

_GAPS = ("", "-", "--", "---", "n/a", "#n/a", "null", "none", "1.#qnan", "1.#ind", "-1.#ind")
"""Marks of missing numbers in tables, in addition to nan and inf."""
_ONE_MARK = re.compile(r"[+-]?([0-9]*)([.,])([0-9]*)([eEdD][+-]?[0-9]+)?")
_GROUPED = re.compile(r"[+-]?[1-9][0-9]{0,2}([.,' ])[0-9]{3}(?:\1[0-9]{3})*(?:(?!\1)([.,])[0-9]*)?")
_SWAP = str.maketrans(".,", ",.")
MARKS = {".": "point", ",": "comma"}


class Exact(str):
    """The digits of a number that its file holds as a number: it has no decimal mark of a language."""

    def translate(self, _: Any) -> Exact:
        """Itself: there is nothing to translate."""
        return self


def with_points(row: list[str]) -> list[str]:
    """Cells with decimal commas as such with points; groups of thousands are then made by commas."""
    return [cell.translate(_SWAP) for cell in row]


def mark_of(cell: str) -> str:
    """The decimal mark that a number shows, "." or ","; "?" where its only mark may make a group of thousands; else ""."""
    if isinstance(cell, Exact):
        return ""
    one = _ONE_MARK.fullmatch(cell.strip())
    if one:
        whole, mark, rest, exponent = one.groups()
        if not whole and not rest:
            return ""
        return "?" if len(rest) == 3 and not exponent and 1 <= len(whole) <= 3 and whole[0] != "0" else str(mark)
    grouped = _GROUPED.fullmatch(cell.strip())
    if grouped is None:
        return ""
    # a mark that occurs twice separates groups
    return grouped[2] or grouped[1].translate(_SWAP).strip("' ")


def number(cell: str) -> float:
    """The value of a cell with a decimal point, its thousands grouped by commas, blanks, apostrophes or not; NaN for others."""
    if not cell:
        return math.nan
    try:
        return float(cell)
    except ValueError:
        cell = cell.strip()
    grouped = _GROUPED.fullmatch(cell)
    if grouped and grouped[1] != "." and grouped[2] != ",":
        return float(cell.replace(grouped[1], ""))
    one = _ONE_MARK.fullmatch(cell)
    if one and one[2] == "." and one[4]:
        return float(re.sub("[dD]", "e", cell))
    return math.nan


def is_number(cell: str) -> bool:
    """Whether a cell is a finite number, with either decimal mark."""
    return math.isfinite(number(cell)) or mark_of(cell) != ""


def is_gap(cell: str) -> bool:
    """Whether a cell marks a missing number."""
    cell = cell.strip().lower()
    if cell in _GAPS:
        return True
    try:
        return not math.isfinite(float(cell))
    except ValueError:
        return False


def is_mangled(cell: str) -> bool:
    """Whether a cell is of the digits and marks of a number, but is not one."""
    return re.fullmatch(r"[0-9.,' +eEdD-]*[.,'][0-9.,' +eEdD-]*", cell) is not None and any(map(str.isdigit, cell))
