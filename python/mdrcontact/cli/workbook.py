# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of studies as workbooks."""

from __future__ import annotations

import importlib
import io
import math
from collections.abc import Iterable, Sequence
from typing import Any

from .. import __version__
from .._units import practical
from ..studies.result import Column, Mixed, Result, Table, Words
from .table import cell_text

_WIDTH = 48
"""Most letters that a column is wide."""

Cell = str | float


def as_xlsx(found: Result, command: str) -> bytes:
    """Return all tables of a result as a workbook: a sheet for each, after one with numbers, notes, warnings and the command."""
    book = importlib.import_module("openpyxl").Workbook()
    _fill(book.active, "result", _summary(found, command))
    for name, table in found.tables.items():
        _fill(book.create_sheet(), name, _rows(table))
    content = io.BytesIO()
    book.save(content)
    return content.getvalue()


def _summary(found: Result, command: str) -> Iterable[Sequence[Cell]]:
    yield ("quantity", "value", "unit")
    for name, number in found.numbers.items():
        unit = practical(number.dimension, [number.value])
        yield (name, float(unit.of(number.value)), unit.name)
    yield ()
    yield ("title", found.title)
    yield from (("note", line) for words in found.notes.values() for line in words.splitlines())
    yield from (("warning", words) for words in found.warnings)
    yield ("command", command)
    yield ("version", f"mdrcontact {__version__}")


def _rows(table: Table) -> Iterable[Sequence[Cell]]:
    yield [column.title for column in table]
    for i in range(len(table[0].values)):
        yield [_cell(column, i) for column in table]


def _cell(column: Column | Mixed | Words, row: int) -> Cell:
    """A number in the unit of its column, or a text."""
    if isinstance(column, Column) and row not in column.instead:
        return float(column.unit.of(column.values[row]))
    return cell_text(column, row)


def _fill(sheet: Any, name: str, rows: Iterable[Sequence[Cell]]) -> None:
    illegal = importlib.import_module("openpyxl.cell.cell").ILLEGAL_CHARACTERS_RE
    bold = importlib.import_module("openpyxl.styles").Font(bold=True)
    sheet.title, sheet.freeze_panes = name, "A2"
    widths: dict[str, int] = {}
    for i, row in enumerate(rows, start=1):
        for j, value in enumerate(row, start=1):
            cell = sheet.cell(i, j)
            if isinstance(value, float) and math.isfinite(value):
                cell.value = value
            elif not isinstance(value, float):
                cell.value = illegal.sub("", value)
                cell.data_type = "s"  # a text that begins with "=" is no formula
                widths[cell.column_letter] = max(widths.get(cell.column_letter, 0), len(value))
            if i == 1:
                cell.font = bold
    for letter, width in widths.items():
        sheet.column_dimensions[letter].width = min(width, _WIDTH) + 2
