# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of measured data: CSV or TSV with a header line that names the columns and their units."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._choices import nearest
from .section import ProblemError
from .units import Dimension, UnitError, to_si

_BRACKETS = re.compile(r"\s*(.*?)\s*[\[(]\s*(.*?)\s*[\])]\s*")
_LARGEST_FILE = 200_000_000


class MeasuredTable(NamedTuple):
    """A table as it stands in the file: titles and numbers; cells that are no numbers are NaN."""

    path: Path
    titles: list[str]
    values: NDArray[np.float64]
    notes: list[str]

    def column(self, title: str, dimension: Dimension) -> tuple[NDArray[np.float64], str]:
        """A column in SI units, and the unit it was in."""
        if title not in self.titles:
            raise ProblemError(f"{self.path}: there is no column {title!r}: {nearest(title, self.titles)}")
        unit = unit_of(title, dimension)
        if unit is None:
            raise ProblemError(
                f"{self.path}: the column {title!r} does not say its unit: write {dimension.name} as in "
                f'"{title} [{dimension.example.split()[-1]}]"'
            )
        factor = to_si(1.0, unit, dimension)
        return self.values[:, self.titles.index(title)] * factor, unit

    def find(self, aliases: Sequence[str], dimension: Dimension) -> str | None:
        """The column whose name, without unit, is one of the aliases and whose unit fits."""
        for title in self.titles:
            if unit_of(title, dimension) is not None and name_of(title, dimension).lower() in aliases:
                return title
        return None


def read_table(path: Path) -> MeasuredTable:
    """Reads a table; lines that begin with # are comments."""
    try:
        if path.stat().st_size > _LARGEST_FILE:
            raise ProblemError(f"{path}: it has more than {_LARGEST_FILE // 1_000_000} MB: that is no measured curve")
        text = path.read_text(encoding="utf-8-sig")
    except OSError as problem:
        raise ProblemError(f"{path}: it cannot be read: {problem.strerror or problem}") from problem
    except UnicodeDecodeError as problem:
        raise ProblemError(f"{path}: it is not a text file in UTF-8") from problem
    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    if len(lines) < 2:
        raise ProblemError(f"{path}: it must have a header line and at least one line of numbers")
    separator = max("\t;,", key=lines[0].count)
    rows = list(csv.reader(lines, delimiter=separator))
    titles = [title.strip() for title in rows[0]]
    if all(math.isfinite(_number(title, separator)) for title in titles):
        raise ProblemError(f"{path}: the first line holds numbers: it must name the columns and their units, as in depth [nm]")
    if len(set(titles)) < len(titles):
        raise ProblemError(f"{path}: two columns have the same title")
    values = np.full((len(rows) - 1, len(titles)), np.nan)
    for i, row in enumerate(rows[1:]):
        for j, cell in enumerate(row[: len(titles)]):
            values[i, j] = _number(cell, separator)
    name = {"\t": "tabs", ";": "semicolons", ",": "commas"}[separator]
    return MeasuredTable(path, titles, values, [f"{len(values)} rows, {len(titles)} columns, separated by {name}"])


def _number(cell: str, separator: str) -> float:
    cell = cell.strip()
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
    parts = title.split("_")
    found = [("_".join(parts[:i]), "_".join(parts[i:]).replace("_per_", "/")) for i in range(1, len(parts))]
    return [*found, (title, "")]


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


def describe(columns: Mapping[str, tuple[str, str, NDArray[np.float64]]]) -> list[str]:
    """What was understood: role, title, unit and range of each column."""
    lines = []
    for role, (title, unit, values) in columns.items():
        finite = values[np.isfinite(values)]
        span = f"{finite.min():.4g} to {finite.max():.4g} (SI)" if finite.size else "no numbers"
        lines.append(f"{role} from column {title!r}" + (f" in {unit}" if unit else "") + f": {span}")
    return lines
