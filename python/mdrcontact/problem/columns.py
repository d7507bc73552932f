# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of measured data as instruments write them: text with or without preamble, header and a row of units, in any usual
encoding, separator and decimal sign, and sheets of spreadsheets."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._choices import nearest
from .block import Block, find_block
from .cells import SHEETS, Cells, Sheet, Text
from .numerals import is_gap, is_number
from .section import ProblemError
from .units import Dimension, UnitError, is_unit, to_si
from .values import read_values

_BRACKETS = re.compile(r"\s*(.*?)[\s_]*[\[(]\s*(.*?)\s*[\])]\s*")
_COMMA = re.compile(r"\s*(.+?)\s*[,/]\s*(\S+)\s*")
_LARGEST_FILE = 200_000_000
_MANY_REPEATED, _MANY_OUTSIDE = 0.02, 0.05
"""Of the rows: more that stand twice, or outside of the table, are no accident."""


@dataclass(frozen=True)
class TableOptions:
    """What a problem file may say about a table that does not say it itself."""

    columns: tuple[str, ...] = ()
    """titles of the columns in order, for a table without a header"""
    units: Mapping[str, str] = field(default_factory=dict)
    """units of columns, by title"""
    skip: int = 0
    """lines before the table"""
    sheet: str = ""
    """of a spreadsheet; default: the only one that holds a table"""
    decimal: str = ""
    """the decimal mark, "." or ","; default: found from the numbers"""


class MeasuredTable(NamedTuple):
    """A table as it stands in the file: titles, units where a row of their own or the problem file gives them, and numbers; cells
    that are no numbers are NaN."""

    path: Path
    titles: list[str]
    values: NDArray[np.float64]
    notes: list[str]
    units: Mapping[str, str]
    warnings: list[str]
    """what speaks against it"""

    def column(self, title: str, dimension: Dimension) -> tuple[NDArray[np.float64], str]:
        """A column in SI units, and the unit it was in."""
        if title not in self.titles:
            raise ProblemError(f"{self.path}: there is no column {title!r}: {nearest(title, self.titles)}")
        unit = self.unit_of(title, dimension)
        if unit is None:
            raise ProblemError(f"{self.path}: the column {title!r} does not say its unit: {self._remedy(title, dimension)}")
        factor = to_si(1.0, unit, dimension)
        return self.values[:, self.titles.index(title)] * factor, unit

    def find(self, role: str, aliases: Sequence[str], dimension: Dimension) -> str:
        """The column whose name, without unit, is one of the aliases and whose unit fits; a refusal names the true reason."""
        named = self.named(aliases, dimension)
        for title in named:
            if self.unit_of(title, dimension) is not None:
                return title
        if named:
            raise ProblemError(
                f"{self.path}: the column {named[0]!r} should be the {role}, but does not say its unit: "
                f"{self._remedy(named[0], dimension)}"
            )
        for title in self.titles:
            for name, unit in _splits(title):
                if unit and name.lower() in aliases:
                    raise ProblemError(f"{self.path}: the column {title!r} should be the {role}, but {_fault(unit, dimension)}")
        unit = dimension.example.split()[-1]
        raise ProblemError(
            f'{self.path}: no column is the {role}: name one so, with its unit, as in "{role} [{unit}]", or, for a fit, name it in '
            f'the problem file: [data] {role} = "..."; there are {", ".join(map(repr, self.titles))}'
        )

    def named(self, aliases: Sequence[str], dimension: Dimension) -> list[str]:
        """The columns whose name, without unit, is one of the aliases."""
        found = []
        for title in self.titles:
            bare = _BRACKETS.fullmatch(title)
            name = name_of(title, dimension) if title not in self.units else bare[1] if bare else title
            if name.lower() in aliases or name.lower().replace("_", " ") in aliases:
                found.append(title)
        return found

    def unit_of(self, title: str, dimension: Dimension) -> str | None:
        """The unit of a column if it is one of that dimension; "" for plain numbers."""
        given = self.units.get(title)
        if given is None:
            return unit_of(title, dimension)
        try:
            to_si(1.0, given, dimension)
        except UnitError:
            return None
        return given

    def _remedy(self, title: str, dimension: Dimension) -> str:
        unit = dimension.example.split()[-1]
        if title in self.units:
            return _fault(self.units[title], dimension)
        return f'write it as in "{title} [{unit}]", or, for a fit, in the problem file: [data] units = {{ "{title}" = "{unit}" }}'


def read_table(path: Path, options: TableOptions | None = None) -> MeasuredTable:
    """Reads a table; lines that begin with # are comments."""
    try:
        return _read(path, options or TableOptions())
    except MemoryError:
        size = path.stat().st_size / 1e6
        raise ProblemError(
            f"{path}: there is not enough memory to read its {size:.0f} MB: leave out rows or columns, or make files of parts"
        ) from None


def _read(path: Path, options: TableOptions) -> MeasuredTable:
    try:
        with path.open("rb") as file:
            content = file.read(_LARGEST_FILE + 1)  # of a device there is no end
    except (OSError, ValueError) as problem:
        raise ProblemError(f"{path}: it cannot be read: {getattr(problem, 'strerror', None) or problem}") from problem
    if len(content) > _LARGEST_FILE:
        raise ProblemError(f"{path}: it has more than {_LARGEST_FILE // 1_000_000} MB: that is no measured curve")
    if path.suffix.lower() in SHEETS:
        return _table_of(Sheet(path, content, options.skip, options.sheet), options)
    if path.suffix.lower() == ".xls":
        raise ProblemError(f"{path}: old spreadsheets (.xls) are not read: save it as .xlsx or as .csv")
    return _table_of(Text(path, content, options.skip), options)


def _table_of(cells: Cells, options: TableOptions) -> MeasuredTable:
    block = find_block(cells.stretches())
    _check_rows(cells, block)
    above = [[cell.strip() for cell in row] for _, _, row in cells.between(block.parts, 0, block.first)]
    titles, units = _named(cells, above, block.width, options)
    values = read_values(cells, block, titles, options.decimal)
    where = f" after {len(above)} lines of header" if len(above) > 1 else ""
    notes = [f"{len(values)} rows, {len(titles)} columns{where}, {', '.join(cells.notes)}"]
    return MeasuredTable(cells.path, titles, values, notes, units, _doubts(values, block.outside()))


def _check_rows(cells: Cells, block: Block) -> None:
    """Refuses rows of another number of cells, where nothing tells which of them are missing."""
    odd = block.odd_row() if cells.by_blanks else None
    if odd is not None:
        raise ProblemError(
            f"{cells.path}: {cells.place(block.line(odd))} has another number of words than the other rows: where blanks separate "
            "the columns, nothing tells which cell is missing: write nan for it, or separate the columns by tabs or semicolons"
        )
    beside = block.neighbour()
    if beside is not None:
        raise ProblemError(
            f"{cells.path}: {cells.place(block.line(beside))} holds numbers, but not one for each of the {block.width} columns: "
            "complete it, or begin it with # as a comment"
        )


def _named(cells: Cells, above: Sequence[Sequence[str]], width: int, options: TableOptions) -> tuple[list[str], dict[str, str]]:
    """Titles of the columns, and units that stand beside them."""
    path = cells.path
    units: dict[str, str] = {}
    if options.columns:
        titles = list(options.columns)
        if len(titles) != width:
            raise ProblemError(f"{path}: [data] columns names {len(titles)} columns, and the table has {width}")
    else:
        titles, row_of_units = _header(path, above, width, width if cells.by_blanks else width + 1)
        for title, unit in zip(titles, row_of_units, strict=False):
            own = _BRACKETS.fullmatch(title)
            if not unit or own and own[2] == unit:
                continue
            if own and is_unit(own[2]) and title not in options.units:
                raise ProblemError(
                    f"{path}: the unit of the column {title!r} is {unit!r} in the row below the titles: say which it is in the "
                    f'problem file: [data] units = {{ "{title}" = "{own[2]}" }}'
                )
            units[title] = unit
    titles = [title or f"column {i}" for i, title in enumerate(titles, start=1)]
    doubled = {title for title in titles if titles.count(title) > 1}
    if doubled:
        raise ProblemError(f"{path}: two columns have the same title, {sorted(doubled)[0]!r}: name all in [data] columns = [...]")
    for title, unit in options.units.items():
        if title not in titles:
            raise ProblemError(f"{path}: [data] units: there is no column {title!r}: {nearest(title, titles)}")
        units[title] = unit
    return titles, units


def _doubts(values: NDArray[np.float64], outside: int) -> list[str]:
    """What a table should not have: rows of numbers outside of it, and rows that repeat others."""
    words = []
    if outside > max(2, _MANY_OUTSIDE * len(values)):
        words.append(
            f"{outside} rows of numbers are not read: lines of words separate them from the table of {len(values)} rows. Remove "
            "the lines, or make a file of each part"
        )
    complete = values[np.isfinite(values).all(axis=1)]
    in_order = complete[np.lexsort(complete.T)]
    repeated = int((in_order[1:] == in_order[:-1]).all(axis=1).sum())
    if repeated > max(2, _MANY_REPEATED * len(values)):
        words.append(
            f"{repeated} of {len(values)} rows repeat others exactly: an instrument that stood still, coarse digits, or a table "
            "that was copied twice; the intervals count them as readings of their own"
        )
    return words


def _header(path: Path, above: Sequence[Sequence[str]], width: int, most: int) -> tuple[list[str], list[str]]:
    """Titles and units from the lines above the numbers: a line of titles, and perhaps one of units below it."""
    words = [list(row) for row in above if not all(is_gap(cell) or is_number(cell) for cell in row)]
    rows = [row for row in words if width <= len(row) <= most and sum(map(bool, row)) >= max(1, width - 1)]
    if not rows:
        count = len(words[-1]) if words else 0
        shorter = f", but {count} words" if count > 1 else ""
        if 1 < count < width <= 2 * count:
            shorter += " (if commas are decimal signs, separate columns by semicolons or tabs)"
        raise ProblemError(
            f"{path}: no line above the numbers has names for the {width} columns{shorter}: write such a line, or, for a fit, name "
            'them in [data], as in columns = ["depth [nm]", "load [mN]"]'
        )
    padded = [(row + width * [""])[:width] for row in rows]
    bare = [cell.strip("[]() ") for cell in padded[-1]]
    if len(rows) > 1 and any(bare) and all(is_unit(cell) for cell in bare if cell):
        return padded[-2], bare
    return padded[-1], []


def _splits(title: str) -> list[tuple[str, str]]:
    """Name and unit, in every way that the title can be read."""
    match = _BRACKETS.fullmatch(title)
    if match:
        return [(match[1], match[2])]
    match = _COMMA.fullmatch(title)
    if match:
        return [(match[1], match[2]), (title, "")]
    parts = title.split("_")
    found = [("_".join(parts[:i]), "_".join(parts[i:]).replace("_per_", "/")) for i in range(1, len(parts))]
    return [*found, (title, "")]


def _fault(unit: str, dimension: Dimension) -> str:
    """That a unit does not fit, and which one does."""
    return f'{unit!r} is no unit of {dimension.name}: one is "{dimension.example.split()[-1]}"{dimension.hint}'


def unit_of(title: str, dimension: Dimension) -> str | None:
    """The unit in a title such as "depth [nm]", "h_nm", "S_N_per_m", if it is one of that dimension; "" for plain numbers."""
    for _, unit in _splits(title):
        if not unit:
            return "" if not dimension.si else None
        try:
            to_si(1.0, unit, dimension)
        except UnitError:
            continue
        return unit
    return None


def name_of(title: str, dimension: Dimension) -> str:
    """The title without its unit."""
    for name, unit in _splits(title):
        if not unit:
            return name
        try:
            to_si(1.0, unit, dimension)
        except UnitError:
            continue
        return name
    return title
