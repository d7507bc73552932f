# SPDX-License-Identifier: GPL-3.0-or-later
"""Marks of instruments: rows at which loading, a hold or unloading begins according to the file."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..records import Segment, segmentation
from ..records.segments import joined, kind_of_way
from .block import Block
from .cells import Cells

Array = NDArray[np.float64]

_TITLES = ("segment", "segments", "marker", "markers", "mark")
"""Titles of columns whose words are marks, in small letters."""
_KINDS = (
    ("hold", r"hold segment|drift hold|begin drift|end of loading|segment: pause"),
    ("unloading", r"unload|end of hold|end drift|segment: retract"),
    ("loading", r"load segment|surface marker|surface index$|cycle begin|segment: extend"),
)
"""Kind of segment after a mark whose words match; other marks begin no segment."""
_REMARK = re.compile(r"#\s*(segment: (?:extend|retract|pause)).*")
"""Comments of JPK above the rows of a segment."""
_FEWEST = 20
"""Readings in which a cycle may hide."""


class Mark(NamedTuple):
    """Words next to a row of a table, counted from 0."""

    row: int
    words: str

    @property
    def kind(self) -> str:
        """Kind of segment that begins here, "loading", "hold" or "unloading"; "" for none."""
        return next((kind for kind, pattern in _KINDS if re.search(pattern, self.words.lower())), "")


def find_marks(cells: Cells, block: Block, titles: Sequence[str], values: Array) -> tuple[Mark, ...]:
    """The marks of a table: words in a column of that title that holds no numbers, or where its numbers change; else comments."""
    places = [i for i, title in enumerate(titles) if title.strip().lower() in _TITLES]
    if not places:
        return _of_remarks(cells, block)
    column = values[:, places[0]]
    if np.isfinite(column).all():
        changes = [0, *(np.flatnonzero(np.diff(column)) + 1)]
        return tuple(Mark(int(i), f"segment {column[i]:g}") for i in changes) if 1 < len(changes) < len(column) // 3 else ()
    rows = cells.between(block.parts, block.first, block.last)
    words = ((i - block.first, row[places[0]].strip() if places[0] < len(row) else "") for i, _, row in rows)
    return tuple(Mark(i, text) for i, text in words if text and not np.isfinite(column[i]))


def _of_remarks(cells: Cells, block: Block) -> tuple[Mark, ...]:
    """Marks in comments; of several above one row the last counts."""
    found = cells.marked_lines(_REMARK)
    if not found:
        return ()
    lines = np.concatenate([np.asarray(part.stretch.lines) for part in block.parts])[block.first : block.last]
    rows = {int(np.searchsorted(lines, line)): words for line, words in found if line <= lines[-1]}
    return tuple(Mark(row, words) for row, words in sorted(rows.items()))


def segments_of_marks(marks: Sequence[Mark], depth: Array, force: Array) -> list[Segment] | None:
    """The segments as a file marks them, None where its marks begin none. A stretch of loading in which readings turn for sure
    holds cycles that are not marked."""
    begins = [(mark.row, mark.kind or _by_depth(marks, i, depth)) for i, mark in enumerate(marks)]
    begins = [(row, kind) for row, kind in begins if kind]
    if not begins:
        return None
    if begins[0][0] > 0:
        begins.insert(0, (0, "loading"))
    found: list[Segment] = []
    is_complete = all(mark.words.startswith("segment: ") for mark in marks)
    for (start, kind), stop in zip(begins, [*(row for row, _ in begins[1:]), len(depth)], strict=True):
        if stop > start:
            found += [Segment(kind, start, stop)] if is_complete else _within(kind, start, stop, depth, force)
    return joined(found)


def _by_depth(marks: Sequence[Mark], i: int, depth: Array) -> str:
    """Kind of a numbered segment, from the change of its depth."""
    if not marks[i].words.startswith("segment "):
        return ""
    stop = marks[i + 1].row if i + 1 < len(marks) else len(depth)
    return kind_of_way(float(depth[stop - 1] - depth[marks[i].row]), float(np.ptp(depth)))


def _within(kind: str, start: int, stop: int, depth: Array, force: Array) -> list[Segment]:
    whole = [Segment(kind, start, stop)]
    h, p = depth[start:stop], force[start:stop]
    is_curve = stop - start >= _FEWEST and np.isfinite(h).all() and np.isfinite(p).all() and np.ptp(h) > 0.0 and np.ptp(p) > 0.0
    if kind != "loading" or not is_curve:
        return whole
    guess = segmentation(h, p)
    turns = [s for i, s in enumerate(guess.segments) if s.kind == "unloading" and i not in guess.unsure]
    return [Segment(s.kind, start + s.start, start + s.stop) for s in guess.segments] if turns else whole
