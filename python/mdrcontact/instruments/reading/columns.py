# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of measured data as instruments write them: text with or without preamble, header and a row of units, in any usual
encoding, separator and decimal sign, and sheets of spreadsheets."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..._choices import nearest
from ..._units import FORCE, LENGTH, SENSITIVITY, STIFFNESS, VOLTAGE, Dimension, UnitError
from ...problem.named import ContentError, NamedFile, ProblemError
from ...problem.roles import ROLES
from . import layouts
from .block import Block, find_block
from .cells import Cells, Sheet, Text, is_spreadsheet, read_sheets
from .content import content_of
from .formats import Fact, Format, recognise, refuse_foreign, tip_facts
from .header import Header, above, read_header, titles_above
from .marks import Mark, find_marks
from .titles import bare, is_measured, is_one_of, read_title, unit_in, words
from .units import factor
from .values import read_values

_NO_NUMBER = 1e300
_ROUNDED = 1e-3
"""Possible effect of omitted digits, relative to the largest deflection."""
_SETTINGS = 200
"""Rows of a sheet that may contain an area function of the tip."""
_MANY_REPEATED, _MANY_OUTSIDE = 0.02, 0.05
"""Fraction of the rows: more that occur twice, or outside of the table, are no accident."""


@dataclass(frozen=True)
class TableOptions:
    """Properties of a table that a problem file may give if the table lacks them."""

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
    """A table as the file contains it: titles, units where a row of their own, the format or the problem file gives them, and
    numbers; cells that are no numbers are NaN."""

    path: Path
    titles: list[str]
    values: NDArray[np.float64]
    notes: list[str]
    units: Mapping[str, str]
    warnings: list[str]
    """warnings about it"""
    name: str = ""
    """of the sheet or the test, where the file has several"""
    marks: tuple[Mark, ...] = ()
    """of the instrument, in the order of the rows"""
    facts: tuple[Fact, ...] = ()
    """properties of the instrument that the file states"""
    is_named: bool = False
    """whether a problem names the file, of which errors then repeat nothing"""
    others: Mapping[str, str] = {}
    """titles of the file that are not those of the table, with these"""

    def column(self, title: str, dimension: Dimension) -> tuple[NDArray[np.float64], str]:
        """A column in SI units, and the unit it was in."""
        own = self.own(title)
        if own is None:
            best = self.those() if self.is_named else nearest(title, self.titles)
            raise ProblemError(f"{self.path}: there is no column {title!r}: {best}")
        unit = self.unit_of(own, dimension)
        if unit is None:
            raise ProblemError(f"{self.path}: the column {title!r} does not state its unit: {self._remedy(own, dimension)}")
        return self.values[:, self.titles.index(own)] * (factor(unit, dimension) if unit else 1.0), unit

    def own(self, title: str) -> str | None:
        """The title of the table that a problem file means, however it writes micro signs and blanks; None for no column."""
        title = words(title)
        title = self.others.get(title, title)
        if title in self.titles:
            return title
        alike = [one for one in self.titles if one.replace(" ", "") == title.replace(" ", "")]
        return alike[0] if len(alike) == 1 else None

    def find(self, role: str, aliases: Sequence[str], dimension: Dimension) -> str:
        """The column whose name, without unit, is one of the aliases and whose unit fits; an error states the true reason."""
        named = self.named(aliases, dimension)
        for title in sorted(named, key=lambda title: "measured" not in title.lower()):
            if self.unit_of(title, dimension) is not None:
                return title
        # a letter with another unit is another quantity: H (GPa) is no depth
        named = [title for title in named if len(bare(title)) > 1 or title not in self.units and bare(title) in aliases]
        if named:
            raise ProblemError(
                f"{self.path}: the column {named[0]!r} should be the {role}, but does not state its unit: "
                f"{self._remedy(named[0], dimension)}"
            )
        for title in self.titles:
            pair = unit_in(title)
            if pair and len(pair[0]) > 1 and is_one_of(pair[0], aliases):
                raise ProblemError(f"{self.path}: the column {title!r} should be the {role}, but {_fault(pair[1], dimension)}")
        unit = dimension.example.split()[-1]
        raise ProblemError(
            f'{self.path}: no column is the {role}: give it this title with the unit, as in "{role} [{unit}]", or, for a fit, name '
            f'it in the problem file: [data] {role} = "..."; {self.those()}'
        )

    def those(self) -> str:
        """List the columns; of a file that a problem names, only titles of measurements and the number of others."""
        shown = [title for title in self.titles if not self.is_named or is_measured(title)]
        others = len(self.titles) - len(shown)
        words = [*map(repr, shown), *([f"{others} with other titles"] if others else [])]
        return f"there are {', '.join(words)}"

    def named(self, aliases: Sequence[str], dimension: Dimension) -> list[str]:
        """The columns whose name, without unit, is one of the aliases."""
        return [
            title
            for title in self.titles
            if is_one_of(bare(title) if title in self.units else read_title(title, dimension)[0], aliases)
        ]

    def unit_of(self, title: str, dimension: Dimension) -> str | None:
        """The unit of a column if it is one of that dimension; "" for plain numbers."""
        given = self.units.get(title)
        if given is None:
            return read_title(title, dimension)[1]
        try:
            factor(given, dimension)
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
        return _parsed(path, content_of(path), options or TableOptions())
    except MemoryError:
        size = path.stat().st_size / 1e6
        raise ProblemError(
            f"{path}: there is not enough memory to read its {size:.0f} MB: leave out rows or columns, or make files of parts"
        ) from None


def read_named(file: NamedFile) -> MeasuredTable:
    """Read the only table, or the first, of a file that a problem names. The file need not be a table, so errors name the place
    and do not repeat its content."""
    content = file.content()
    try:
        return _parsed(file.path, content, TableOptions())[0]._replace(is_named=True)
    except ContentError as problem:
        raise ProblemError(problem.without) from None
    except MemoryError:
        raise ProblemError(f"{file.path}: there is not enough memory to read it: leave out rows or columns") from None


class _Kept(NamedTuple):
    """A spreadsheet that was read, and the options for it."""

    path: Path
    digest: bytes
    options: TableOptions
    tables: list[MeasuredTable]


_last: _Kept | None = None
"""The spreadsheet that was read last: an inspection reads a file several times, and each reading takes seconds."""


def _spreadsheet(path: Path, content: bytes, options: TableOptions) -> list[MeasuredTable]:
    global _last
    digest = hashlib.sha256(content).digest()
    kept = _last
    if kept is None or kept[:3] != (path, digest, options):
        tables = _tables_of_sheets(path, read_sheets(path, content, options.skip, options.sheet), options)
        for table in tables:
            table.values.setflags(write=False)
        kept = _last = _Kept(path, digest, options, tables)
    # notes and warnings are added to
    return [table._replace(notes=list(table.notes), warnings=list(table.warnings)) for table in kept.tables]


def _parsed(path: Path, content: bytes, options: TableOptions) -> list[MeasuredTable]:
    if is_spreadsheet(path, content):
        return _spreadsheet(path, content, options)
    refuse_foreign(path, content)
    return _chosen(path, _tables_of(Text(path, content, options.skip), options), options.sheet)


def _chosen(path: Path, tables: list[MeasuredTable], name: str) -> list[MeasuredTable]:
    """All tests, or that of a name."""
    found = [table for table in tables if not name or table.name == name]
    if not found:
        words = f"{path}: there is no test {name!r}: {nearest(name, [table.name for table in tables])}"
        raise ProblemError(words).at("data", "sheet")
    return found


def _tables_of_sheets(path: Path, sheets: Sequence[Sheet], options: TableOptions) -> list[MeasuredTable]:
    """The tables of all sheets that hold one; if all fail, the error of the longest is raised."""
    tables: list[MeasuredTable] = []
    faults: list[tuple[int, ProblemError]] = []
    for sheet in sheets:
        block = find_block(sheet.stretches())
        if block.last - block.first > 1:
            try:
                tables += _split(_table_of(sheet, block, above(sheet, block, 0), options), options)
            except ProblemError as problem:
                faults.append((block.last - block.first, problem))
    said = next((facts for sheet in sheets if (facts := tip_facts(sheet.first(_SETTINGS)))), ())
    tables = [table if table.facts else table._replace(facts=said) for table in tables]
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
    header = above(cells, block, 0)
    main = _table_of(cells, block, header, options)
    alike = [] if options.columns else [one for one in block.alike() if list(map(words, titles_above(cells, one))) == main.titles]
    if not alike:
        return _split(main._replace(warnings=[*_doubts_outside(block, 0), *main.warnings]), options)
    tests, begin = [], 0
    known = recognise(header.lines)
    for i, one in enumerate(sorted([block, *alike], key=lambda one: one.first), start=1):
        table = _table_of(cells, one, above(cells, one, begin), options, known)
        tests.append(table._replace(name=f"test {i}"))
        begin = one.last
    tests[0].warnings.extend(_doubts_outside(block, sum(len(test.values) for test in tests) - len(main.values)))
    return [part for test in tests for part in _split(test, options)]


def _table_of(cells: Cells, block: Block, header: Header, options: TableOptions, known: Format | None = None) -> MeasuredTable:
    """The table of a block below a header, of a known format or of one that the header names."""
    titles, units = _named(cells, header, block.width, options)
    values = read_values(cells, block, titles, options.decimal)
    # of programs that write the largest number for a missing one
    values[np.abs(values) > _NO_NUMBER] = np.nan
    lines = header.lines
    known = known or recognise(lines)
    where = f" after {len(lines)} lines of header" if len(lines) > 1 else ""
    notes = [f"{len(values)} rows, {len(titles)} columns{where}, {', '.join(cells.notes)}"]
    if known:
        notes[0] = f"{known.name}: {notes[0]}"
        units = {**{title: unit for title, unit in known.units.items() if title in titles}, **units}
    marks = find_marks(cells, block, titles, values)
    return MeasuredTable(
        cells.path, titles, values, notes, units, _doubts(values), cells.name, marks, (known or Format("", "")).facts(lines)
    )


def _split(table: MeasuredTable, options: TableOptions) -> list[MeasuredTable]:
    """A table as tables of one test each: tests stand side by side, the way out beside the way in."""
    table = _without_gaps(table)
    pairs = layouts.in_and_out(table.titles)
    if pairs:
        return [_joined(table, pairs)]
    tests = layouts.side_by_side(table.titles)
    if len(tests) == 1 and len(set(tests[0].titles)) == len(table.titles):
        return [table._replace(titles=tests[0].titles, others=_others(table, tests[0], tests), units=_units(table, tests[0]))]
    return [_one_of(table, test, tests, options) for test in tests]


def _without_gaps(table: MeasuredTable) -> MeasuredTable:
    """A table without columns that have neither a title nor a number, which stand between tests."""
    empty = [not np.isfinite(column).any() for column in table.values.T]
    kept = [i for i, title in enumerate(table.titles) if not (empty[i] and title == f"column {i + 1}")]
    return table._replace(titles=[table.titles[i] for i in kept], values=table.values[:, kept]) if len(kept) < len(empty) else table


def _one_of(table: MeasuredTable, test: layouts.Test, tests: Sequence[layouts.Test], options: TableOptions) -> MeasuredTable:
    """One of the tests of a table."""
    kept, differing = layouts.without_copies(test, table.values)
    if differing:
        raise _two_of_a_title(table, differing[0])
    values = table.values[:, kept.columns]
    values = values[np.isfinite(values).any(axis=1)]
    notes, name = list(table.notes), table.name
    if len(tests) > 1:
        places = f"columns {min(test.columns) + 1} to {max(test.columns) + 1}"
        notes[0] = f"{notes[0]}; {places} of {len(tests)} tests side by side"
        name = f"{name} {test.name}".strip()
    return table._replace(
        titles=kept.titles,
        values=values,
        name=name,
        notes=notes,
        warnings=_doubts(values),
        units=_units(table, test),
        others=_others(table, test, tests),
        marks=table.marks if len(tests) == 1 else (),
    )


def _units(table: MeasuredTable, test: layouts.Test) -> dict[str, str]:
    """Units of a test by its own titles."""
    own = zip(test.titles, test.columns, strict=True)
    return {title: table.units[table.titles[place]] for title, place in own if table.titles[place] in table.units}


def _others(table: MeasuredTable, test: layouts.Test, tests: Sequence[layouts.Test]) -> dict[str, str]:
    """Titles of the file, of any of its tests, with the title of the same quantity in one of them."""
    own = {bare(title): title for title in test.titles}
    pairs = [(table.titles[place], own[bare(title)]) for one in tests for title, place in zip(one.titles, one.columns, strict=True)]
    return {title: one for title, one in pairs if title != one}


def _two_of_a_title(table: MeasuredTable, place: int) -> ProblemError:
    """Error for two columns of a test with one title, with a list of distinct titles."""
    title = table.titles[place]
    seen: dict[str, int] = {}
    apart: list[str] = []
    for one in table.titles:
        seen[one] = seen.get(one, 0) + 1
        apart.append(one if seen[one] == 1 else f"column {len(apart) + 1} {one}")
    listed = ", ".join(f'"{one}"' for one in apart)
    return ContentError(
        f"{table.path}: two columns have the same title, {title!r}, and other numbers: give each column a title of its own, as in "
        f"[data] columns = [{listed}]; tests side by side have the same titles in the same order",
        f"{table.path}: another column has the title of column {table.titles.index(title) + 1}: give each its own",
    )


def _joined(table: MeasuredTable, pairs: Mapping[int, int]) -> MeasuredTable:
    """A table of one test whose unloading is in columns next to those of loading."""
    values, count = layouts.joined(table.values, pairs)
    titles = [table.titles[place] for place in pairs]
    others = {table.titles[out]: table.titles[into] for into, out in pairs.items()}
    notes = [f"{table.notes[0]}; {count} rows of loading, {len(values) - count} of unloading from the columns next to them"]
    units = {title: unit for title, unit in table.units.items() if title in titles}
    marks = (Mark(0, "segment: extend"), Mark(count, "segment: retract")) if 0 < count < len(values) else ()
    whole = table._replace(
        titles=titles, values=values, notes=notes, units=units, others=others, warnings=_doubts(values), marks=marks
    )
    return whole._replace(facts=(*whole.facts, *_lever_of(whole)))


def _lever_of(table: MeasuredTable) -> list[Fact]:
    """Spring constant and sensitivity, where columns have one deflection as a force, a length, or a voltage."""
    columns = {}
    for dimension in (FORCE, LENGTH, VOLTAGE):
        with suppress(ProblemError):
            columns[dimension] = table.column(table.find("deflection", ROLES["deflection"][1], dimension), dimension)[0]
    found = []
    said = {fact.name for fact in table.facts}
    for name, upper, lower, dimension in (
        ("spring_constant", FORCE, LENGTH, STIFFNESS),
        ("deflection_sensitivity", LENGTH, VOLTAGE, SENSITIVITY),
    ):
        if name not in said and upper in columns and lower in columns:
            factor = _ratio(columns[upper], columns[lower])
            found += [Fact(name, factor, dimension)] if factor > 0.0 else []
    return found


def _ratio(one: NDArray[np.float64], other: NDArray[np.float64]) -> float:
    """The factor by which one column is a multiple of another; 0 if it is not one."""
    finite = np.isfinite(one) & np.isfinite(other)
    if not finite.any():
        return 0.0
    one, other = one[finite], other[finite]
    top = int(np.abs(other).argmax())
    with np.errstate(all="ignore"):
        factor = float(one[top] / other[top])
        is_multiple = math.isfinite(factor) and np.abs(one - factor * other).max() < _ROUNDED * np.abs(one).max()
    return float(f"{factor:.4g}") if is_multiple else 0.0


def _check_rows(cells: Cells, block: Block) -> None:
    """Raise an error for rows with another number of cells, if the missing ones cannot be identified."""
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


def _named(cells: Cells, header: Header, width: int, options: TableOptions) -> tuple[list[str], dict[str, str]]:
    """Titles of the columns, and units next to them."""
    if options.columns:
        titles, row_of_units = list(map(words, options.columns)), width * [""]
        if len(titles) != width:
            words_of = f"{cells.path}: [data] columns names {len(titles)} columns, and the table has {width}"
            raise ProblemError(words_of).at("data", "columns")
    else:
        titles, row_of_units = read_header(cells, header, width, {words(title) for title in options.units})
    units = {title: unit for title, unit in zip(titles, row_of_units, strict=True) if unit}
    for given, unit in options.units.items():
        title = words(given)
        if title not in titles:
            words_of = f"{cells.path}: [data] units: there is no column {given!r}: {nearest(title, titles)}"
            raise ProblemError(words_of).at("data", "units")
        units[title] = unit
    return titles, units


def _doubts_outside(block: Block, read: int) -> list[str]:
    """Warning that rows of numbers are outside of the tables; `read` of them belong to other tests."""
    rows, outside = block.last - block.first, block.outside() - read
    if outside <= max(2, _MANY_OUTSIDE * rows):
        return []
    return [
        f"{outside} rows of numbers are not read: lines of words separate them from the table of {rows} rows. Remove "
        "the lines, or make a file of each part"
    ]


def _doubts(values: NDArray[np.float64]) -> list[str]:
    """Warning about rows that repeat others."""
    complete = values[np.isfinite(values).all(axis=1)]
    in_order = complete[np.lexsort(complete.T)]
    repeated = int((in_order[1:] == in_order[:-1]).all(axis=1).sum())
    if repeated <= max(2, _MANY_REPEATED * len(values)):
        return []
    return [
        f"{repeated} of {len(values)} rows repeat others exactly: an instrument that stood still, coarse digits, or a table "
        "that was copied twice; the intervals count them as readings of their own"
    ]


def _fault(unit: str, dimension: Dimension) -> str:
    """Text that a unit does not fit, and which one does."""
    return f'{unit!r} is no unit of {dimension.name}: one is "{dimension.example.split()[-1]}"{dimension.hint}'
