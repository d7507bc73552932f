# SPDX-License-Identifier: GPL-3.0-or-later
"""Titles of columns, and their units, in lines that begin with #, or one title a line."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable, Iterable, Iterator, Sequence

from .numerals import is_gap, is_number

MARKS = re.compile(r"\s*(?:#|%|//|!|;|\*)+\s*")
_TITLES = re.compile(r"(?:fancyNames|columns|titles|names|fields|channels|header)\s*[:=]\s*(.+)", re.IGNORECASE)
_UNITS = re.compile(r"units?\s*[:=]\s*(.+)", re.IGNORECASE)
_BY_PLACE = re.compile(r"(?:columns?|col\.?|spalte|channel)?\s*\[?(\d{1,2})\]?\s*[:=.)-]\s*(.*[^\W\d].*)", re.IGNORECASE)
"""One title a line, with its place: "column 2: depth (nm)"."""


def _words(line: str) -> list[str]:
    try:
        return shlex.split(line, posix=True)
    except ValueError:
        return line.split()


def _ways(line: str) -> Iterator[list[str]]:
    """A line in cells, in each way in which columns are separated."""
    for separator in ("\t", ";", ",", "|"):
        if separator in line:
            yield [cell.strip(" \"'") for cell in line.split(separator)]
    yield re.split(r"\s{2,}", line.strip())
    if '"' not in line:
        # a unit in brackets belongs to the word before it
        together = re.sub(r"\s+(?=[\[(][^\[\]()]*[\])])", "\0", line)
        yield [cell.replace("\0", " ") for cell in together.split()]
    yield _words(line)


def _cells(line: str, width: int) -> list[str]:
    """One word for each column; empty if a line has another number of words, or numbers."""
    for cells in _ways(line):
        cells = cells[:-1] if len(cells) == width + 1 and not cells[-1] else cells
        if len(cells) == width and all(cells) and not any(is_number(cell) for cell in cells):
            return cells
    return []


def titles_in(lines: Sequence[str], width: int, is_title: Callable[[str], bool]) -> tuple[list[str], list[str]]:
    """Titles and units of the columns from lines of comments, the last that have them; none where there are none."""
    bare = [MARKS.sub("", line, count=1).strip() for line in lines]
    units = next(iter(_keyed(bare, _UNITS, width)), [])
    titles = next(iter(_keyed(bare, _TITLES, width)), []) or by_place(bare, width)
    if titles:
        return titles, units
    found = [cells for line in bare if (cells := _cells(line, width))]
    # a column may be titled #
    found_with_mark = [cells for line in lines if (cells := _cells(line, width))]
    named = [cells for cells in (*found_with_mark, *found) if any(map(is_title, cells))]
    named = named or [cells for cells in found if not any(cell.endswith((":", "=")) for cell in cells)]
    return (named[-1], units) if named else ([], [])


def _keyed(lines: Iterable[str], key: re.Pattern[str], width: int) -> Iterator[list[str]]:
    """The cells of lines that begin with a key; names for people come first."""
    found = [(line, cells) for line in lines if (match := key.fullmatch(line)) and (cells := _cells(match[1], width))]
    yield from (cells for _, cells in sorted(found, key=lambda pair: not pair[0].lower().startswith("fancy")))


def by_place(lines: Iterable[str], width: int) -> list[str]:
    """Titles, one a line, with their columns, counted from 0 or 1."""
    found = {int(match[1]): match[2].strip(" \"'") for line in lines if (match := _BY_PLACE.fullmatch(line.strip()))}
    for first in (1, 0):
        places = range(first, first + width)
        if set(places) <= set(found) and len(found) == width:
            return [found[place] for place in places]
    return []


def are_words(row: Sequence[str]) -> bool:
    """Whether a row has a cell that is neither a number nor a mark of a missing one."""
    return not all(is_gap(cell) or is_number(cell) for cell in row)
