# SPDX-License-Identifier: GPL-3.0-or-later
"""From the cells of a table to numbers: one decimal mark for the whole table, found from all cells."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...problem.named import ContentError, ProblemError
from .block import Block
from .cells import Cells
from .numerals import MARKS, is_mangled, mark_of, number, with_points


class _Cell(NamedTuple):
    line: int
    column: int
    text: str


def read_values(cells: Cells, block: Block, titles: Sequence[str], decimal: str) -> NDArray[np.float64]:
    """The numbers of a table, NaN where there is none; `decimal` is its decimal mark, "" to find it."""
    shown = None if decimal else _evidence(cells, block, titles)
    mark = decimal or (mark_of(shown.text) if shown else ".")
    table = np.full((block.last - block.first, block.width), math.nan)
    mangled: dict[int, _Cell] = {}
    for part in block.parts:
        first, last = max(part.first, block.first), min(part.last, block.last)
        known = part.stretch.numbers
        if first < last and known is not None and part.stretch.mark in ("", mark):
            place = table[first - block.first : last - block.first]
            place[:, : known.shape[1]] = known[first - part.first : last - part.first]
            continue
        for i, line, row in cells.between([part], first, last):
            values = list(map(number, (with_points(row) if mark == "," else row)[: block.width]))
            table[i - block.first, : len(values)] = values
            for j, cell in enumerate(row[: block.width]):
                if cell and math.isnan(values[j]):
                    if mark_of(cell):
                        raise _two_marks(cells, titles, _Cell(line, j, cell), shown, mark)
                    if is_mangled(cell):
                        mangled.setdefault(j, _Cell(line, j, cell))
    # of a column of dates no cell is a number
    for lost in (lost for j, lost in mangled.items() if np.isfinite(table[:, j]).any()):
        raise ContentError(
            f"{_where(cells, titles, lost)}: {lost.text!r} is no number with a decimal {MARKS[mark]}: correct it",
            f"{_place(cells, lost)} is no number with a decimal {MARKS[mark]}: correct it",
        )
    return table


def _evidence(cells: Cells, block: Block, titles: Sequence[str]) -> _Cell | None:
    """A cell that shows the decimal mark; None where no number has a mark, or points that can only be decimal ones."""
    doubtful, columns, unmarked = None, set[int](), set[int]()
    for _, line, row in cells.between(block.parts, block.first, block.last):
        for j, cell in enumerate(row):
            if "." not in cell and "," not in cell:
                if j not in unmarked and math.isfinite(number(cell)):
                    unmarked.add(j)
                continue
            mark = mark_of(cell)
            if mark == "?":
                doubtful = doubtful or _Cell(line, j, cell)
                columns.add(j)
            elif mark:
                return _Cell(line, j, cell)
    # three decimals in every cell of a column are fixed digits, thousands occur next to smaller numbers
    if doubtful is None or cells.shows_point(doubtful.line) and not columns & unmarked:
        return None
    text = doubtful.text.strip()
    whole, rest = text.replace(",", ".").split(".")
    raise ContentError(
        f"{_where(cells, titles, doubtful)}: {text!r} may be {whole}{rest} or {whole}.{rest}0, and no other number of the table "
        f"shows which: write {whole}{rest}, or all with another number of decimals; or, for a fit, name the decimal mark in the "
        'problem file: [data] decimal = "." or ","',
        f"{_place(cells, doubtful)} has one mark and three digits behind it, and no other number of the table shows which mark "
        "is the decimal one: write all with another number of decimals",
    )


def _two_marks(cells: Cells, titles: Sequence[str], cell: _Cell, shown: _Cell | None, mark: str) -> ProblemError:
    known = f"{shown.text.strip()!r} in {cells.place(shown.line)}" if shown else f'[data] decimal = "{mark}"'
    return ContentError(
        f"{_where(cells, titles, cell)}: {cell.text.strip()!r} does not go with {known}, by which the decimal mark is a "
        f"{MARKS[mark]}: write all numbers of the table with one mark",
        f"{_place(cells, cell)} does not go with the decimal mark of others, a {MARKS[mark]}: write all numbers with one mark",
    )


def _place(cells: Cells, cell: _Cell) -> str:
    """Position of a cell, without a word of the file."""
    return f"{cells.path}: {cells.place(cell.line)}, column {cell.column + 1}: it"


def _where(cells: Cells, titles: Sequence[str], cell: _Cell) -> str:
    column = f", column {titles[cell.column]!r}" if cell.column < len(titles) else ""
    return f"{cells.path}: {cells.place(cell.line)}{column}"
