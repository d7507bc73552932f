# SPDX-License-Identifier: GPL-3.0-or-later
"""The cells of a file that holds a table: text in any usual encoding and separator, or a sheet of a spreadsheet."""

from __future__ import annotations

import codecs
import csv
import io
import re
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import nullcontext, suppress
from functools import partial
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ... import _progress
from ..._choices import nearest
from ...problem.named import ContentError, ProblemError
from ...problem.roles import ROLES
from .block import Part, Stretch, find_block
from .numerals import Exact
from .units import like_ascii

SHEETS = (".xlsx", ".xlsm", ".xls")
_OLD_SPREADSHEET = (b"\xd0\xcf\x11\xe0", b"\x09\x00\x04\x00", b"\x09\x02\x06\x00", b"\x09\x04\x06\x00", b"\x09\x08")
_NEW_SPREADSHEET = b"PK\x03\x04"
_SEPARATORS = {"\t": "tabs", ";": "semicolons", ",": "commas", " ": "spaces"}
_SAMPLES, _SAMPLE = 8, 100
"""Samples, and lines in each, that show how columns are separated."""
_LONGEST_CELL = 3
"""Lines. What is longer has a quote that does not end."""
_EASTERN = ("cp932", "gb18030")
"""Encodings of Japan and China."""
_HEAD = 20_000
"""Bytes in which titles stand."""
_STRETCH, _MANY_LINES = 4096, 100_000
_NUMERIC = re.compile(r"[0-9.,;eE+\-\t ]+")
"""Lines that may be numbers alone."""


class Cells(ABC):
    """Rows of cells, which may be gone through more than once."""

    path: Path
    name = ""
    """of the sheet"""
    notes: list[str]
    """notes on how the file was interpreted"""
    by_blanks = False
    """whether blanks separate the columns: a missing cell then leaves no trace"""

    @abstractmethod
    def stretches(self) -> Iterator[Stretch]:
        """All rows."""

    @abstractmethod
    def rows(self, first: int, end: int) -> Iterable[list[str]]:
        """The rows of a stretch, from its first line and the line after its last."""

    @abstractmethod
    def place(self, line: int) -> str:
        """Position of a line in the file."""

    def shows_point(self, line: int) -> bool:
        """Whether a point in this line can only be a decimal one."""
        return False

    def remarks(self, first: int | None, last: int) -> list[str]:
        """The comments between two lines, or above the last one."""
        return []

    def marked_lines(self, pattern: re.Pattern[str]) -> list[tuple[int, str]]:
        """Comments of a pattern, each with the line that follows it."""
        return []

    def between(self, parts: Iterable[Part], first: int, last: int) -> Iterator[tuple[int, int, list[str]]]:
        """Those of rows first ... last - 1 that are in some parts of the file: number, line, cells."""
        for part in parts:
            begin, end = max(first - part.first, 0), min(last, part.last) - part.first
            if begin < end:
                lines = part.stretch.lines
                for k, row in enumerate(islice(self.rows(lines[0], part.stretch.end), begin, end), start=begin):
                    yield part.first + k, lines[k], row


class Text(Cells):
    """The cells of a text file; lines that begin with # are comments."""

    def __init__(self, path: Path, content: bytes, skip: int) -> None:
        text, encoding = decode(path, content)
        every = _like_ascii(text).splitlines()
        del text, content
        kept = (i for i, line in enumerate(every) if i >= skip and not _is_passed_over(line))
        self._numbers = np.fromiter(kept, dtype=np.int64)
        self._remarks = [(i, line) for i, line in enumerate(every) if line.lstrip().startswith("#") and i >= skip]
        self._lines = [every[i] for i in self._numbers]
        del every
        self._separator = _separator_of(self._lines)
        if not self._separator:
            raise ProblemError(f"{path}: there is no table of numbers in it: it must have a header line and two columns or more")
        self.path, self.by_blanks = path, self._separator == " "
        self.notes = [f"text in {encoding}", f"separated by {_SEPARATORS[self._separator]}"]

    def stretches(self) -> Iterator[Stretch]:
        first, count = 0, len(self._lines)
        with _progress.bar(count, "lines") if count > _MANY_LINES else nullcontext() as bar:
            while first < count:
                last = min(first + _STRETCH, count)
                found = _numbers_of(self._lines[first:last], self._separator)
                lines: Sequence[int] = range(first, last)
                rows: list[list[str]] = []
                if found is None:
                    last = first + _words_above(self._lines[first:last])
                    reader = _reader(self._lines[first : last + _LONGEST_CELL], self._separator)
                    numbered = list(self._until(reader, first, last))
                    last = first + reader.line_num
                    rows = [row for _, row in numbered]
                    lines = range(first, last) if len(rows) == last - first else [line for line, _ in numbered]
                yield Stretch(lines, last, rows, *(found or ()))
                if bar:
                    bar.update(last - first)
                first = last

    def _until(self, reader: Any, first: int, last: int) -> Iterator[tuple[int, list[str]]]:
        """The rows of lines first ... last - 1 with the line where each begins; the last row may end in a later line."""
        before = 0
        with suppress(csv.Error):
            for row in reader:
                if reader.line_num - before > _LONGEST_CELL:
                    break
                yield first + before, row
                before = reader.line_num
                if first + before >= last:
                    return
        raise ProblemError(f"{self.path}: {self.place(first + before)}: a quote begins a cell that does not end: remove it")

    def rows(self, first: int, end: int) -> Iterable[list[str]]:
        rows: Iterable[list[str]] = _reader(self._lines[first:end], self._separator)
        return rows

    def place(self, line: int) -> str:
        return f"line {self._numbers[line] + 1}"

    def remarks(self, first: int | None, last: int) -> list[str]:
        begin, end = (-1 if first is None else self._numbers[first]), self._numbers[last]
        return [line for i, line in self._remarks if begin < i < end]

    def marked_lines(self, pattern: re.Pattern[str]) -> list[tuple[int, str]]:
        found = [(i, match[1]) for i, line in self._remarks if (match := pattern.fullmatch(line.strip()))]
        return [(int(np.searchsorted(self._numbers, i)), words) for i, words in found]

    def shows_point(self, line: int) -> bool:
        return self._separator == "," and '"' not in self._lines[line]


class Sheet(Cells):
    """The cells of one sheet of a spreadsheet."""

    def __init__(self, path: Path, name: str, count: int, rows: Sequence[Sequence[object]], skip: int) -> None:
        words = [[_word(cell) for cell in row] for row in rows]
        numbered = [(i, row) for i, row in enumerate(words, start=1) if i > skip and any(row)]
        self.path, self.name = path, name
        self.notes = [f"sheet {name!r} of {count}"]
        self._numbers, self._rows = [i for i, _ in numbered], [row for _, row in numbered]

    def stretches(self) -> Iterator[Stretch]:
        yield Stretch(range(len(self._rows)), len(self._rows), self._rows)

    def rows(self, first: int, end: int) -> Iterable[list[str]]:
        return self._rows[first:end]

    def place(self, line: int) -> str:
        return f"row {self._numbers[line]}"

    def first(self, count: int) -> list[list[str]]:
        """The first rows."""
        return self._rows[:count]


def read_sheets(path: Path, content: bytes, skip: int, chosen: str) -> list[Sheet]:
    """The sheets of a spreadsheet, or the chosen one."""
    read = _old_sheets if content.startswith(_OLD_SPREADSHEET) else _new_sheets
    try:
        sheets = read(content)
        if chosen and chosen not in sheets:
            raise ProblemError(f"{path}: there is no sheet {chosen!r}: {nearest(chosen, sheets)}").at("data", "sheet")
        rows = {name: list(sheets[name]()) for name in ([chosen] if chosen else sheets)}
    except ProblemError:
        raise
    except ImportError as problem:
        raise ProblemError(f'{path}: spreadsheets need {problem.name}: pip install "mdrcontact[instruments]"') from problem
    except Exception as problem:  # noqa: BLE001 - a damaged file raises almost anything
        words = f"{path}: it cannot be read as a spreadsheet: {type(problem).__name__}"
        raise ContentError(f"{words}: {problem}", words) from problem
    return [Sheet(path, name, len(sheets), table, skip) for name, table in rows.items()]


_Rows = Callable[[], Iterable[Sequence[object]]]


def _new_sheets(content: bytes) -> dict[str, _Rows]:
    """The sheets of a .xlsx by name, by calamine where it is installed, which takes a tenth of openpyxl's time."""
    try:
        import python_calamine as calamine
    except ImportError:
        import openpyxl

        book = openpyxl.load_workbook(io.BytesIO(content), read_only=True, data_only=True)
        return {sheet.title: partial(sheet.iter_rows, values_only=True) for sheet in book.worksheets}
    book = calamine.CalamineWorkbook.from_filelike(io.BytesIO(content))
    names = [sheet.name for sheet in book.sheets_metadata if sheet.typ == calamine.SheetTypeEnum.WorkSheet]
    return {name: partial(_rows_by_calamine, book, name) for name in names}


def _rows_by_calamine(book: Any, name: str) -> list[list[object]]:
    rows: list[list[object]] = book.get_sheet_by_name(name).to_python(skip_empty_area=False)
    return rows


def _old_sheets(content: bytes) -> dict[str, _Rows]:
    """The sheets of a .xls by name."""
    import xlrd

    # it prints what it finds odd
    book = xlrd.open_workbook(file_contents=content, logfile=io.StringIO(), formatting_info=False)
    known = (xlrd.XL_CELL_TEXT, xlrd.XL_CELL_NUMBER)

    def rows(sheet: Any) -> Iterator[list[object]]:
        for i in range(sheet.nrows):
            yield [cell.value if cell.ctype in known else None for cell in sheet.row(i)]

    return {sheet.name: partial(rows, sheet) for sheet in book.sheets()}


def is_spreadsheet(path: Path, content: bytes) -> bool:
    """Whether to read a file as a spreadsheet; instruments also write text under the name .xls."""
    is_named = path.suffix.lower() in SHEETS
    return is_named and (content.startswith((*_OLD_SPREADSHEET, _NEW_SPREADSHEET)) or b"\0" in content[:4096] or not content)


def _of_words(content: bytes) -> list[str]:
    """Encodings in which a file holds the name of a column in Japanese or Chinese; in Latin-1 it may be text, too."""
    begin = content[:_HEAD]
    names = [name for _, aliases in ROLES.values() for name in aliases if len(name) > 1 and name > "\u3000"]
    words = {encoding: [word for name in names if (word := name.encode(encoding, "ignore"))] for encoding in _EASTERN}
    return [encoding for encoding in _EASTERN if any(len(word) > 2 and word in begin for word in words[encoding])]


def decode(path: Path, content: bytes) -> tuple[str, str]:
    """The text of a file in UTF-8, UTF-16, Latin-1, or an encoding of Japan or China, and which it was."""
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        encodings: tuple[str, ...] = ("utf-16",)
    elif content[1:200:2].count(0) > len(content[1:200:2]) // 2:
        encodings = ("utf-16-le",)
    else:
        encodings = ("utf-8-sig", *_of_words(content), "cp1252", *_EASTERN)
    if b"\0" in content[:4096] and not encodings[0].startswith("utf-16"):
        raise ProblemError(f"{path}: it is not a text file")
    for encoding in encodings:
        try:
            return content.decode(encoding), encoding.replace("-sig", "").upper().replace("CP1252", "Latin-1 (Windows-1252)")
        except UnicodeDecodeError:
            continue
    raise ProblemError(f"{path}: it is not a text file in UTF-8, UTF-16 or Latin-1")


def _is_passed_over(line: str) -> bool:
    """Whether a line is empty or a comment; #N/A is a number that is missing."""
    begin = line.lstrip()[:4]
    return begin == "" or begin[0] == "#" and begin.lower() != "#n/a"


def _like_ascii(text: str) -> str:
    """Replace typographic variants of signs by plain ones, and non-breaking blanks within a number by apostrophes."""
    if text.isascii():
        return text
    return like_ascii(re.sub("(?<=[0-9])[\xa0\N{THIN SPACE}\N{NARROW NO-BREAK SPACE}](?=[0-9]{3})", "'", text))


def _word(cell: object) -> str:
    if cell is None:
        return ""
    is_number = isinstance(cell, (int, float)) and not isinstance(cell, bool)
    return Exact(cell) if is_number else _like_ascii(str(cell))


def _reader(lines: Iterable[str], separator: str) -> Any:
    return csv.reader(map(_single_blanks, lines) if separator == " " else lines, delimiter=separator)


def _single_blanks(line: str) -> str:
    # a unit in brackets belongs to the word before it
    return " ".join((re.sub(r"\s+(?=[\[(])", "", line) if "[" in line or "(" in line else line).split())


def _numbers_of(lines: list[str], separator: str) -> tuple[NDArray[np.float64], str] | None:
    """The numbers and the decimal mark of lines with the same count of finite numbers and nothing else; None for other lines."""
    text = "\n".join(lines)
    if text.count(f"{separator}\n") == len(lines) - 1 and text.endswith(separator):
        text = text.replace(f"{separator}\n", "\n")[:-1]
        lines = text.split("\n")
    points, commas = "." in text, separator != "," and "," in text
    # NumPy passes over empty lines
    if '"' in text or points and commas or "" in lines:
        return None
    if commas:
        lines = text.replace(",", ".").split("\n")
    try:
        numbers = np.loadtxt(lines, delimiter=None if separator == " " else separator, comments=None, ndmin=2)
    except ValueError:
        return None
    return (numbers, "." if points else "," if commas else "") if np.isfinite(numbers).all() else None


def _words_above(lines: Sequence[str]) -> int:
    """How many lines to read by cells: those above numbers that continue to the last line, or all."""
    count = len(lines)
    while count and _NUMERIC.fullmatch(lines[count - 1]):
        count -= 1
    return count or len(lines)


def _separator_of(lines: Sequence[str]) -> str:
    """The separator of the columns; "" if there is no table."""
    if len(lines) > _SAMPLES * _SAMPLE:
        begins = np.linspace(0, len(lines) - _SAMPLE, _SAMPLES, dtype=int)
        sample = _best_separator([line for begin in begins for line in lines[begin : begin + _SAMPLE]])
        if sample:
            return sample
    return _best_separator(lines)


def _best_separator(lines: Sequence[str]) -> str:
    """The separator that gives most numbers in these lines, and fewest other cells."""
    best, found = 0, ""
    for separator in _SEPARATORS:
        if not any(separator in line for line in lines):
            continue
        try:
            rows = list(_reader(lines, separator))
        except csv.Error:  # a cell without end
            continue
        block = find_block([Stretch((), 0, rows)])
        # commas may be decimal ones, unless they also separate the titles
        is_clear = separator in "\t;" or separator == "," and block.first > 0 and len(rows[block.first - 1]) == block.width
        if is_clear and block.width > 1 and block.pure[block.first : block.last].all():
            # blanks and commas within its cells make groups of thousands
            return separator
        # a wrong separator leaves cells that are no numbers
        size = block.size()
        if size > best:
            best, found = size, separator
    return found
