# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of measured data as instruments write them: text with or without preamble, header and a row of units, in any usual
encoding, separator and decimal sign, and sheets of spreadsheets."""

from __future__ import annotations

import codecs
import csv
import io
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._choices import nearest
from .section import ProblemError
from .units import Dimension, UnitError, is_unit, to_si

_BRACKETS = re.compile(r"\s*(.*?)[\s_]*[\[(]\s*(.*?)\s*[\])]\s*")
_COMMA = re.compile(r"\s*(.+?)\s*[,/]\s*(\S+)\s*")
_GAPS = ("", "-", "--", "---", "n/a", "#n/a", "null", "none", "1.#qnan", "1.#ind", "-1.#ind")
"""What stands in tables where a number is missing, besides nan and inf."""
_LARGEST_FILE = 200_000_000
_MANY_REPEATED, _MANY_OUTSIDE = 0.02, 0.05
"""Of the rows: more that stand twice, or outside of the table, are no accident."""
_SEPARATORS = {"\t": "tabs", ";": "semicolons", ",": "commas", " ": "spaces"}
_SHEETS = (".xlsx", ".xlsm")
_OF_SHEETS = ";"
"""Numbers that are words in a spreadsheet may have a decimal comma, as between semicolons."""
_LIKE_ASCII = str.maketrans({"\N{MICRO SIGN}": "u", "\N{GREEK SMALL LETTER MU}": "u", "\N{SUPERSCRIPT TWO}": "^2", "\xa0": " "})


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
    options = options or TableOptions()
    try:
        with path.open("rb") as file:
            content = file.read(_LARGEST_FILE + 1)  # of a device there is no end
    except (OSError, ValueError) as problem:
        raise ProblemError(f"{path}: it cannot be read: {getattr(problem, 'strerror', None) or problem}") from problem
    if len(content) > _LARGEST_FILE:
        raise ProblemError(f"{path}: it has more than {_LARGEST_FILE // 1_000_000} MB: that is no measured curve")
    if path.suffix.lower() in _SHEETS:
        return _table_of(path, *_sheet(path, content, options), options)
    if path.suffix.lower() == ".xls":
        raise ProblemError(f"{path}: old spreadsheets (.xls) are not read: save it as .xlsx or as .csv")
    text, encoding = decode(path, content)
    lines = text.translate(_LIKE_ASCII).splitlines()[options.skip :]
    lines = [line for line in lines if line.strip() and not line.lstrip().startswith("#")]
    best: tuple[int, str, list[list[str]]] | None = None
    for separator in _SEPARATORS:
        if separator == " ":
            # a unit in brackets belongs to the word before it
            rows = [re.sub(r"\s+(?=[\[(])", "", line).split() for line in lines]
        else:
            try:
                rows = list(csv.reader(lines, delimiter=separator))
            except csv.Error:  # a cell without end
                continue
        first, last = _block(rows, separator)
        cells = [cell for row in rows[first:last] for cell in row if cell.strip()]
        numbers = sum(math.isfinite(_number(cell, separator)) for cell in cells)
        # a wrong separator leaves cells that are no numbers
        size = max(2 * numbers - len(cells), 0)
        if best is None or size > best[0]:
            best = size, separator, rows
    if best is None or not best[0]:
        raise ProblemError(f"{path}: there is no table of numbers in it: it must have a header line and two columns or more")
    _, separator, rows = best
    return _table_of(path, rows, separator, [f"text in {encoding}", f"separated by {_SEPARATORS[separator]}"], options)


def decode(path: Path, content: bytes) -> tuple[str, str]:
    """The text of a file in UTF-8, UTF-16 or Latin-1, and which it was."""
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        encodings: tuple[str, ...] = ("utf-16",)
    elif content[1:200:2].count(0) > len(content[1:200:2]) // 2:
        encodings = ("utf-16-le",)
    else:
        encodings = ("utf-8-sig", "cp1252")
    if b"\0" in content[:4096] and not encodings[0].startswith("utf-16"):
        raise ProblemError(f"{path}: it is not a text file")
    for encoding in encodings:
        try:
            return content.decode(encoding), encoding.replace("-sig", "").upper().replace("CP1252", "Latin-1 (Windows-1252)")
        except UnicodeDecodeError:
            continue
    raise ProblemError(f"{path}: it is not a text file in UTF-8, UTF-16 or Latin-1")


def _sheet(path: Path, content: bytes, options: TableOptions) -> tuple[list[list[str]], str, list[str]]:
    """The cells of the chosen sheet of a spreadsheet, or of the first that holds a table."""
    try:
        import openpyxl
    except ImportError as problem:
        raise ProblemError(f'{path}: spreadsheets need openpyxl: pip install "mdrcontact[instruments]"') from problem
    try:
        book = openpyxl.load_workbook(io.BytesIO(content), read_only=True, data_only=True)
        sheets = {sheet.title: sheet for sheet in book.worksheets}
        if options.sheet and options.sheet not in sheets:
            raise ProblemError(f"{path}: there is no sheet {options.sheet!r}: {nearest(options.sheet, sheets)}")
        for name in [options.sheet] if options.sheet else sheets:
            cells = [["" if cell is None else str(cell) for cell in row] for row in sheets[name].iter_rows(values_only=True)]
            rows = [[cell.translate(_LIKE_ASCII) for cell in row] for row in cells[options.skip :] if any(row)]
            first, last = _block(rows, _OF_SHEETS)
            if last - first > 1:
                return rows, _OF_SHEETS, [f"sheet {name!r} of {len(sheets)}"]
    except ProblemError:
        raise
    except Exception as problem:  # noqa: BLE001 - a damaged archive raises almost anything
        raise ProblemError(f"{path}: it cannot be read as a spreadsheet: {type(problem).__name__}: {problem}") from problem
    raise ProblemError(f"{path}: no sheet holds a table of numbers; the sheets are {', '.join(map(repr, sheets))}")


def _block(rows: Sequence[Sequence[str]], separator: str) -> tuple[int, int]:
    """First and last + 1 of the longest run of rows that hold numbers, one number for each column of the widest."""
    numeric = [sum(math.isfinite(_number(cell, separator)) for cell in row) for row in rows]
    best = first = 0
    found = (0, 0)
    while first < len(rows):
        if numeric[first] == 0:
            first += 1
            continue
        last = first
        # cells without a number are gaps; a row of words alone ends the table
        while last < len(rows) and (
            numeric[last] > 0 and abs(len(rows[last]) - len(rows[first])) <= 1 or all(map(_is_gap, rows[last]))
        ):
            last += 1
        weight = sum(n for n in numeric[first:last] if n > 1)
        if weight > best:
            best, found = weight, (first, last)
        first = max(last, first + 1)
    return found


def _table_of(path: Path, rows: Sequence[Sequence[str]], separator: str, notes: list[str], options: TableOptions) -> MeasuredTable:
    first, last = _block(rows, separator)
    width = max(max((i for i, cell in enumerate(row, start=1) if cell.strip()), default=0) for row in rows[first:last])
    above = [[cell.strip() for cell in row] for row in rows[:first]]
    units: dict[str, str] = {}
    if options.columns:
        titles = list(options.columns)
        if len(titles) != width:
            raise ProblemError(f"{path}: [data] columns names {len(titles)} columns, and the table has {width}")
    else:
        titles, row_of_units = _header(path, above, width)
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
    values = np.full((last - first, len(titles)), np.nan)
    for i, row in enumerate(rows[first:last]):
        for j, cell in enumerate(row[: len(titles)]):
            values[i, j] = _number(cell, separator)
    where = f" after {len(above)} lines of header" if len(above) > 1 else ""
    notes = [f"{len(values)} rows, {len(titles)} columns{where}, {', '.join(notes)}"]
    outside = sum(
        sum(math.isfinite(_number(cell, separator)) for cell in row) >= max(2, width - 1) for row in [*rows[:first], *rows[last:]]
    )
    return MeasuredTable(path, titles, values, notes, units, _doubts(values, outside))


def _doubts(values: NDArray[np.float64], outside: int) -> list[str]:
    """What a table should not have: rows of numbers outside of it, and rows that repeat others."""
    words = []
    if outside > max(2, _MANY_OUTSIDE * len(values)):
        words.append(
            f"{outside} rows of numbers are not read: lines of words separate them from the table of {len(values)} rows. Remove "
            "the lines, or make a file of each part"
        )
    complete = values[np.isfinite(values).all(axis=1)]
    repeated = len(complete) - len(np.unique(complete, axis=0))
    if repeated > max(2, _MANY_REPEATED * len(values)):
        words.append(
            f"{repeated} of {len(values)} rows repeat others exactly: an instrument that stood still, coarse digits, or a table "
            "that was copied twice; the intervals count them as readings of their own"
        )
    return words


def _header(path: Path, above: Sequence[Sequence[str]], width: int) -> tuple[list[str], list[str]]:
    """Titles and units from the lines above the numbers: a line of titles, and perhaps one of units below it."""
    words = [list(row) for row in above if not all(_is_gap(cell) or math.isfinite(_number(cell, ";")) for cell in row)]
    rows = [row for row in words if width <= len(row) <= width + 1 and sum(map(bool, row)) >= max(1, width - 1)]
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


def _is_gap(cell: str) -> bool:
    """Whether a cell stands for a number that is missing."""
    cell = cell.strip().lower()
    if cell in _GAPS:
        return True
    try:
        return not math.isfinite(float(cell))
    except ValueError:
        return False


def _number(cell: str, separator: str) -> float:
    cell = cell.strip()
    point, comma = cell.rfind("."), cell.rfind(",")
    if point >= 0 and comma >= 0:
        # the first of two signs groups the thousands
        cell = cell.replace("," if comma < point else ".", "")
    if separator != ",":
        cell = cell.replace(",", ".")
    try:
        return float(cell)
    except ValueError:
        return math.nan


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
    """Why a unit does not fit, and how to write one that does."""
    try:
        to_si(1.0, unit, dimension)
    except UnitError as problem:
        return str(problem)
    return ""


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
