# SPDX-License-Identifier: GPL-3.0-or-later
"""Positions of the numbers of a table in a file."""

from __future__ import annotations

import math
from array import array
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .numerals import is_gap, is_number

_WORDS, _NUMBERS, _GAPS = range(3)


class Stretch(NamedTuple):
    """Rows that follow each other: their cells, or their numbers where all are finite."""

    lines: Sequence[int]
    """position of each in the file"""
    end: int
    """the line after the last"""
    rows: list[list[str]]
    numbers: NDArray[np.float64] | None = None
    mark: str = ""
    """the decimal mark by which the numbers are read; "" if they have none"""


class Part(NamedTuple):
    """A stretch without its cells, and its rows first ... last - 1 in the file."""

    first: int
    last: int
    stretch: Stretch


class _Run(NamedTuple):
    """Rows first ... last - 1, and how many numbers they hold."""

    first: int
    last: int
    weight: int


@dataclass
class Block:
    """The longest run of rows that hold numbers, one number for each column of the widest, in a file of many rows."""

    counts: NDArray[np.intc]
    """numbers in each row of the file"""
    lengths: NDArray[np.intc]
    """cells in each"""
    used: NDArray[np.intc]
    """cells in each, without empty ones at its end"""
    pure: NDArray[np.int8]
    """whether each holds nothing but numbers and gaps"""
    parts: list[Part]
    first: int = 0
    last: int = 0
    """the rows of the block are first ... last - 1"""
    width: int = 0
    """cells of the widest"""
    others: Sequence[_Run] = ()
    """all runs of rows of numbers"""

    def of(self, run: _Run, others: Sequence[_Run]) -> Block:
        """Another run of this file."""
        width = int(self.used[run.first : run.last].max(initial=0))
        return replace(self, first=run.first, last=run.last, width=width, others=others)

    def alike(self) -> list[Block]:
        """The other runs that have as many columns, in their order."""
        found = [self.of(run, self.others) for run in self.others if run.first != self.first]
        return [block for block in found if block.width == self.width]

    def size(self) -> int:
        """Its numbers less its other cells."""
        return int(2 * self.counts[self.first : self.last].sum() - self.used[self.first : self.last].sum())

    def line(self, row: int) -> int:
        """Position of a row in the file."""
        part = next(part for part in self.parts if row < part.last)
        return part.stretch.lines[row - part.first]

    def odd_row(self) -> int | None:
        """The first row that has another number of cells than most."""
        lengths = self.lengths[self.first : self.last]
        odd = np.flatnonzero(lengths != np.bincount(lengths).argmax())
        return self.first + int(odd[0]) if odd.size else None

    def neighbour(self) -> int | None:
        """A row of numbers alone, directly above or below, that is left out for its number of cells."""
        for row in (self.first - 1, self.last):
            if 0 <= row < len(self.counts) and self.counts[row] > 0 and self.pure[row]:
                return row
        return None

    def outside(self) -> int:
        """Number of rows elsewhere that could be rows of the table."""
        long = self.counts >= max(2, self.width - 1)
        return sum(int(long[other.first : other.last].sum()) for other in self.alike())


def find_block(stretches: Iterable[Stretch]) -> Block:
    """The table among the rows of a file."""
    counts, lengths, used, pure, parts = array("i"), array("i"), array("i"), array("b"), list[Part]()
    for stretch in stretches:
        begin = len(counts)
        if stretch.numbers is not None:
            rows, width = stretch.numbers.shape
            for kept in (counts, lengths, used):
                kept.extend(array("i", [width]) * rows)
            pure.extend(array("b", [1]) * rows)
        for row in stretch.rows:
            numbers, gaps, width = _counted(row)
            counts.append(numbers)
            lengths.append(len(row))
            used.append(width)
            pure.append(numbers + gaps == len(row))
        parts.append(Part(begin, len(counts), stretch._replace(rows=[])))
    block = Block(_shared(counts), _shared(lengths), _shared(used), np.frombuffer(pure, dtype=np.int8), parts)
    runs = _runs(block)
    return block.of(max(runs, key=lambda run: run.weight, default=_Run(0, 0, 0)), runs)


def _shared(numbers: array[int]) -> NDArray[np.intc]:
    return np.frombuffer(numbers, dtype=np.intc)


def _runs(file: Block) -> list[_Run]:
    """The runs of rows of numbers; what they hold is counted in rows of two or more."""
    if not len(file.counts):
        return []
    # cells without a number are gaps; a row of words alone ends the table
    kinds = np.where(file.counts > 0, _NUMBERS, np.where(file.pure, _GAPS, _WORDS))
    weights = np.concatenate([[0], np.cumsum(np.where(file.counts > 1, file.counts, 0))])
    ends = [*np.flatnonzero((np.diff(kinds) != 0) | (np.diff(file.lengths) != 0)) + 1, len(kinds)]
    found: list[_Run] = []
    first, begin = -1, 0
    for end in map(int, ends):
        kind, length = kinds[begin], file.lengths[begin]
        if kind == _WORDS or first < 0 or kind == _NUMBERS and abs(length - file.lengths[first]) > 1:
            first = begin if kind == _NUMBERS else -1
        if first >= 0:
            run = _Run(first, end, int(weights[end] - weights[first]))
            found = [*found[:-1], run] if found and found[-1].first == first else [*found, run]
        begin = end
    return found


def _counted(row: Sequence[str]) -> tuple[int, int, int]:
    """Counts of cells with numbers, of cells that mark missing numbers, and of used cells, without empty ones at the end."""
    with suppress(ValueError):
        if all(map(math.isfinite, map(float, row))):
            return len(row), 0, len(row)
    numbers = gaps = used = 0
    for i, cell in enumerate(row, start=1):
        if not cell:
            gaps += 1
            continue
        try:
            finite = math.isfinite(float(cell))
        except ValueError:
            finite = is_number(cell)
        if finite:
            numbers += 1
            used = i
        elif is_gap(cell):
            gaps += 1
            used = i if cell.strip() else used
        else:
            used = i
    return numbers, gaps, used
