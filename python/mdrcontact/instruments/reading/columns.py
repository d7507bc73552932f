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

from ..._choices import nearest
from ..._units import Dimension, UnitError, is_unit, to_si
from ...problem.named import LARGEST_FILE, ContentError, NamedFile, ProblemError
from ...problem.roles import ROLES
from .block import Block, find_block
from .cells import Cells, Sheet, Text, is_spreadsheet, read_sheets
from .formats import Fact, Format, recognise, refuse_foreign
from .marks import Mark, find_marks
from .numerals import is_gap, is_number
from .values import read_values

_BRACKETS = re.compile(r"\s*(.*?)[\s_]*[\[(]\s*(.*?)\s*[\])]\s*")
_COMMA = re.compile(r"\s*(.+?)\s*[,/]\s*(\S+)\s*")
_NO_NUMBER = 1e300
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
    """of a spreadsheet, or the test of a text; default: all"""
    decimal: str = ""
    """the decimal mark, "." or ","; default: found from the numbers"""


class MeasuredTable(NamedTuple):
    """A table as it stands in the file: titles, units where a row of their own, the format or the problem file gives them, and
    numbers; cells that are no numbers are NaN."""

    path: Path
    titles: list[str]
    values: NDArray[np.float64]
    notes: list[str]
    units: Mapping[str, str]
    warnings: list[str]
    """doubts about it"""
    name: str = ""
    """of the sheet or the test, where the file has several"""
    marks: tuple[Mark, ...] = ()
    """of the instrument, in the order of the rows"""
    facts: tuple[Fact, ...] = ()
    """what the file says of the instrument"""
    is_named: bool = False
    """whether a problem names the file, of which errors then repeat nothing"""

    def column(self, title: str, dimension: Dimension) -> tuple[NDArray[np.float64], str]:
        """A column in SI units, and the unit it was in."""
        if title not in self.titles:
            best = self.those() if self.is_named else nearest(title, self.titles)
            raise ProblemError(f"{self.path}: there is no column {title!r}: {best}")
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
            f'the problem file: [data] {role} = "..."; {self.those()}'
        )

    def those(self) -> str:
        """Which columns there are; of a file that a problem names those that are titles of measurements, and how many others."""
        shown = [title for title in self.titles if not self.is_named or _is_of_measurements(title)]
        others = len(self.titles) - len(shown)
        words = [*map(repr, shown), *([f"{others} with other titles"] if others else [])]
        return f"there are {', '.join(words)}"

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
    """Reads the only table of a file, or its first; lines that begin with # are comments."""
    return read_tables(path, options)[0]


def read_tables(path: Path, options: TableOptions | None = None) -> list[MeasuredTable]:
    """Reads all tests of a file: sheets, tables one below the other with the same titles, or side by side with the same titles."""
    try:
        return _read(path, options or TableOptions())
    except MemoryError:
        size = path.stat().st_size / 1e6
        raise ProblemError(
            f"{path}: there is not enough memory to read its {size:.0f} MB: leave out rows or columns, or make files of parts"
        ) from None


def read_named(file: NamedFile) -> MeasuredTable:
    """Reads the only table, or the first, of a file that a problem names. Errors say where something is wrong and repeat nothing of
    it: it need not be a table."""
    content = file.content()
    try:
        return _parsed(file.path, content, TableOptions())[0]._replace(is_named=True)
    except ContentError as problem:
        raise ProblemError(problem.without) from None
    except MemoryError:
        raise ProblemError(f"{file.path}: there is not enough memory to read it: leave out rows or columns") from None


def _read(path: Path, options: TableOptions) -> list[MeasuredTable]:
    try:
        with path.open("rb") as file:
            content = file.read(LARGEST_FILE + 1)  # of a device there is no end
    except (OSError, ValueError) as problem:
        raise ProblemError(f"{path}: it cannot be read: {getattr(problem, 'strerror', None) or problem}") from problem
    if len(content) > LARGEST_FILE:
        raise ProblemError(f"{path}: it has more than {LARGEST_FILE // 1_000_000} MB: that is no measured curve")
    return _parsed(path, content, options)


def _parsed(path: Path, content: bytes, options: TableOptions) -> list[MeasuredTable]:
    if is_spreadsheet(path, content):
        return _tables_of_sheets(path, read_sheets(path, content, options.skip, options.sheet), options)
    refuse_foreign(path, content)
    return _chosen(path, _tables_of(Text(path, content, options.skip), options), options.sheet)


def _chosen(path: Path, tables: list[MeasuredTable], name: str) -> list[MeasuredTable]:
    """All tests, or that of a name."""
    found = [table for table in tables if not name or table.name == name]
    if not found:
        raise ProblemError(f"{path}: there is no test {name!r}: {nearest(name, [table.name for table in tables])}")
    return found


def _tables_of_sheets(path: Path, sheets: Sequence[Sheet], options: TableOptions) -> list[MeasuredTable]:
    """The tables of all sheets that hold one; what is wrong with all of them is what is wrong with the longest."""
    tables: list[MeasuredTable] = []
    faults: list[tuple[int, ProblemError]] = []
    for sheet in sheets:
        block = find_block(sheet.stretches())
        if block.last - block.first > 1:
            try:
                tables += _split(_table_of(sheet, block, _rows_above(sheet, block, 0), options))
            except ProblemError as problem:
                faults.append((block.last - block.first, problem))
    if not tables and faults:
        raise max(faults, key=lambda fault: fault[0])[1]
    if not tables:
        names = ", ".join(repr(sheet.name) for sheet in sheets)
        words = f"{path}: no sheet holds a table of numbers"
        raise ContentError(f"{words}; the sheets are {names}", words)
    return tables


def _tables_of(cells: Text, options: TableOptions) -> list[MeasuredTable]:
    """The longest table of a text, and those like it: with the same titles in a line above."""
    block = find_block(cells.stretches())
    _check_rows(cells, block)
    main = _table_of(cells, block, _rows_above(cells, block, 0), options)
    alike = [] if options.columns else [other for other in block.alike() if _titles_above(cells, other) == main.titles]
    if not alike:
        return _split(main._replace(warnings=[*_doubts_outside(block, 0), *main.warnings]))
    tests, begin = [], 0
    known = recognise(_rows_above(cells, block, 0))
    for i, one in enumerate(sorted([block, *alike], key=lambda one: one.first), start=1):
        table = _table_of(cells, one, _rows_above(cells, one, begin), options, known)
        tests.append(table._replace(name=f"test {i}"))
        begin = one.last
    tests[0].warnings.extend(_doubts_outside(block, sum(len(test.values) for test in tests) - len(main.values)))
    return tests


def _titles_above(cells: Text, block: Block) -> list[str]:
    """The words of the last line above a block that is no line of units."""
    for row in reversed(_rows_above(cells, block, max(block.first - 2, 0))):
        if _are_symbols(row) or not all(is_unit(cell.strip("[]() ")) for cell in row):
            return row
    return []


def _rows_above(cells: Cells, block: Block, begin: int) -> list[list[str]]:
    return [[cell.strip() for cell in row] for _, _, row in cells.between(block.parts, begin, block.first)]


def _table_of(
    cells: Cells, block: Block, above: Sequence[Sequence[str]], options: TableOptions, known: Format | None = None
) -> MeasuredTable:
    """The table of a block below a header, of a known format or of one that the header names."""
    titles, units = _named(cells, above, block.width, options)
    values = read_values(cells, block, titles, options.decimal)
    # of programs that write the largest number where there is none
    values[np.abs(values) > _NO_NUMBER] = np.nan
    known = known or recognise(above)
    where = f" after {len(above)} lines of header" if len(above) > 1 else ""
    notes = [f"{len(values)} rows, {len(titles)} columns{where}, {', '.join(cells.notes)}"]
    if known:
        notes[0] = f"{known.name}: {notes[0]}"
        units = {**{title: unit for title, unit in known.units.items() if title in titles}, **units}
    marks = find_marks(cells, block, titles, values)
    return MeasuredTable(
        cells.path, titles, values, notes, units, _doubts(values), cells.name, marks, known.facts(above) if known else ()
    )


def _split(table: MeasuredTable) -> list[MeasuredTable]:
    """A table whose titles repeat in turn as tables of one test each."""
    titles = table.titles
    period = titles.index(titles[0], 1) if titles.count(titles[0]) > 1 else len(titles)
    doubled = sorted({title for title in titles if titles.count(title) > 1})
    if not doubled:
        return [table]
    count = len(titles) // period
    if period < 2 or titles != count * titles[:period]:
        place = titles.index(doubled[0]) + 1
        raise ContentError(
            f"{table.path}: two columns have the same title, {doubled[0]!r}: name all in [data] columns = [...]",
            f"{table.path}: another column has the title of column {place}: give each its own",
        )
    tests = []
    for i in range(count):
        values = table.values[:, i * period : (i + 1) * period]
        values = values[np.isfinite(values).any(axis=1)]
        name = f"{table.name} test {i + 1}".strip()
        notes = [f"{table.notes[0]}; columns {i * period + 1} to {(i + 1) * period} of {count} tests side by side"]
        tests.append(table._replace(titles=titles[:period], values=values, name=name, notes=notes, warnings=_doubts(values)))
    return tests


def _check_rows(cells: Cells, block: Block) -> None:
    """Refuses rows of another number of cells, where nothing shows which of them are missing."""
    odd = block.odd_row() if cells.by_blanks else None
    if odd is not None:
        raise ProblemError(
            f"{cells.path}: {cells.place(block.line(odd))} has another number of words than the other rows: where blanks separate "
            "the columns, nothing shows which cell is missing: write nan for it, or separate the columns by tabs or semicolons"
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
                raise ContentError(
                    f"{path}: the unit of the column {title!r} is {unit!r} in the row below the titles: say which it is in the "
                    f'problem file: [data] units = {{ "{title}" = "{own[2]}" }}',
                    f"{path}: the title of column {titles.index(title) + 1} and the row below the titles have two units: keep one",
                )
            units[title] = unit
    titles = [title or f"column {i}" for i, title in enumerate(titles, start=1)]
    for title, unit in options.units.items():
        if title not in titles:
            raise ProblemError(f"{path}: [data] units: there is no column {title!r}: {nearest(title, titles)}")
        units[title] = unit
    return titles, units


def _doubts_outside(block: Block, read: int) -> list[str]:
    """That rows of numbers stand outside of the tables; `read` of them belong to other tests."""
    rows, outside = block.last - block.first, block.outside() - read
    if outside <= max(2, _MANY_OUTSIDE * rows):
        return []
    return [
        f"{outside} rows of numbers are not read: lines of words separate them from the table of {rows} rows. Remove "
        "the lines, or make a file of each part"
    ]


def _doubts(values: NDArray[np.float64]) -> list[str]:
    """What a table should not have: rows that repeat others."""
    complete = values[np.isfinite(values).all(axis=1)]
    in_order = complete[np.lexsort(complete.T)]
    repeated = int((in_order[1:] == in_order[:-1]).all(axis=1).sum())
    if repeated <= max(2, _MANY_REPEATED * len(values)):
        return []
    return [
        f"{repeated} of {len(values)} rows repeat others exactly: an instrument that stood still, coarse digits, or a table "
        "that was copied twice; the intervals count them as readings of their own"
    ]


def _header(path: Path, above: Sequence[Sequence[str]], width: int, most: int) -> tuple[list[str], list[str]]:
    """Titles and units from the lines above the numbers: a line of titles, and perhaps one of units below it."""
    words = [list(row) for row in above if not all(is_gap(cell) or is_number(cell) for cell in row)]
    fitting = [(row + width * [""])[:width] for row in words if width <= len(row) <= most]
    rows = [row for row in fitting if sum(map(bool, row)) >= max(1, width - 1)]
    if not rows:
        count = len(words[-1]) if words else 0
        shorter = f", but {count} words" if count > 1 else ""
        if 1 < count < width <= 2 * count:
            shorter += " (if commas are decimal signs, separate columns by semicolons or tabs)"
        raise ProblemError(
            f"{path}: no line above the numbers has names for the {width} columns{shorter}: write such a line, or, for a fit, name "
            'them in [data], as in columns = ["depth [nm]", "load [mN]"]'
        )
    bare = [cell.strip("[]() ") for cell in fitting[-1]]
    # of units some may be missing, of titles one
    titled = [row for row in fitting[:-1] if row in rows]
    if titled and any(bare) and all(is_unit(cell) for cell in bare if cell) and not _are_symbols(bare):
        return titled[-1], bare
    return rows[-1], []


def _are_symbols(cells: Sequence[str]) -> bool:
    """Whether all of several words are names of columns: F, h and t are no farads, hours and tonnes."""
    names = {name for _, aliases in ROLES.values() for name in aliases}
    return len(cells) > 1 and all(cell.lower() in names for cell in cells)


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


def _is_of_measurements(title: str) -> bool:
    """Whether a title is the name of what instruments measure, or has a unit in brackets."""
    match = _BRACKETS.fullmatch(title)
    name, unit = (match[1], match[2]) if match else (title, "")
    return bool(unit and is_unit(unit)) or any(name.lower() in names for _, names in ROLES.values())


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
