# SPDX-License-Identifier: GPL-3.0-or-later
"""Titles and units of a table, from the lines above its numbers."""

from __future__ import annotations

from collections.abc import Container, Sequence
from typing import NamedTuple

from ...problem.named import ContentError, ProblemError
from .block import Block
from .cells import Cells
from .comments import MARKS, are_words, by_place, titles_in
from .titles import are_symbols, bracketed, is_measured, words
from .units import is_any_unit


class Header(NamedTuple):
    """The lines above a table."""

    rows: list[list[str]]
    """cells of the lines that are no comments"""
    remarks: list[str]
    """comments"""

    @property
    def lines(self) -> list[list[str]]:
        """All of them as cells; a comment has one."""
        return [*self.rows, *([MARKS.sub("", remark, count=1)] for remark in self.remarks)]


def above(cells: Cells, block: Block, begin: int) -> Header:
    """The lines between a row of the file and a block."""
    rows = [[cell.strip() for cell in row] for _, _, row in cells.between(block.parts, begin, block.first)]
    return Header(rows, cells.remarks(block.line(begin) if begin else None, block.line(block.first)))


def titles_above(cells: Cells, block: Block) -> list[str]:
    """The text of the last line above a block that is no line of units."""
    for row in reversed(above(cells, block, max(block.first - 2, 0)).rows):
        if not _units_of(row):
            return row
    return []


def read_header(cells: Cells, header: Header, width: int, known: Container[str]) -> tuple[list[str], list[str]]:
    """Titles and units of the columns: a line of titles, and perhaps one of units below it; comments if it does not exist.

    known : titles whose units a problem file gives
    """
    titles, units = _of_rows(header.rows, width, width if cells.by_blanks else width + 1)
    if not titles:
        titles, units = titles_in(header.remarks, width, is_measured)
    titles = titles or by_place([" ".join(row) for row in header.rows], width)
    if not titles:
        raise _no_titles(cells, header.rows, width)
    return _checked(cells, [words(title) for title in titles], units, known), [*units, *(width * [""])][:width]


def _of_rows(rows: Sequence[Sequence[str]], width: int, most: int) -> tuple[list[str], list[str]]:
    """Titles and units from lines that are no comments; empty where none has a title for each column."""
    worded = [_without_mark(row, width) for row in rows if are_words(row)]
    fitting = [(row + width * [""])[:width] for row in worded if width <= len(row) <= most]
    full = [row for row in fitting if sum(map(bool, row)) >= max(1, width - 1)]
    if not full:
        return [], []
    # of units some may be missing, of titles one
    titled = [row for row in fitting[:-1] if row in full]
    units = _units_of(fitting[-1]) if titled else []
    if not units:
        # a line of units may stand above the titles
        return full[-1], _units_of(fitting[-2]) if titled else []
    return next((row for row in reversed(titled) if any(map(is_measured, row))), titled[-1]), units


def _without_mark(row: Sequence[str], width: int) -> list[str]:
    """A line of words without the sign of a comment at its begin."""
    mark = MARKS.match(row[0]) if row else None
    if mark is None:
        return list(row)
    rest = row[0][mark.end() :]
    return [rest, *row[1:]] if rest or len(row) <= width else list(row[1:])


def _units_of(row: Sequence[str]) -> list[str]:
    """The units in a line that holds more units than other words; empty for other lines."""
    bare = [cell.strip("[](){} ") for cell in row]
    units = [cell if cell and is_any_unit(cell) else "" for cell in bare]
    count = sum(map(bool, units))
    if 2 * count <= sum(map(bool, bare)) or are_symbols([unit for unit in units if unit]):
        return []
    return units


def _checked(cells: Cells, titles: list[str], units: Sequence[str], known: Container[str]) -> list[str]:
    """The titles; units that occur twice are compared."""
    for place, (title, unit) in enumerate(zip(titles, units, strict=False), start=1):
        own = bracketed(title)
        if unit and own and own != unit and is_any_unit(own) and title not in known:
            raise ContentError(
                f"{cells.path}: the unit of the column {title!r} is {unit!r} in the row below the titles: give one in the "
                f'problem file: [data] units = {{ "{title}" = "{own}" }}',
                f"{cells.path}: the title of column {place} and the row below the titles have two units: keep one",
            )
    return [title or f"column {place}" for place, title in enumerate(titles, start=1)]


def _no_titles(cells: Cells, rows: Sequence[Sequence[str]], width: int) -> ProblemError:
    worded = [row for row in rows if are_words(row)]
    count = len(worded[-1]) if worded else 0
    shorter = f", but {count} words" if count > 1 else ""
    if 1 < count < width <= 2 * count:
        shorter += " (if commas are decimal signs, separate columns by semicolons or tabs)"
    return ProblemError(
        f"{cells.path}: no line above the numbers has names for the {width} columns{shorter}: write such a line, or, for a fit, "
        'name them in [data], as in columns = ["depth [nm]", "load [mN]"]'
    )
