# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of studies: named numbers, sentences, warnings and tables, without a word on how they are shown."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple, ParamSpec, TypeVar

import numpy as np
from numpy.typing import NDArray

from .. import _warn
from .._units import QUANTITIES, Dimension, Unit, practical, shown
from ..progress import Progress

Array = NDArray[np.float64]
P = ParamSpec("P")
R = TypeVar("R", bound="Result")
T = TypeVar("T")


class Number(NamedTuple):
    """A quantity of a result."""

    value: float
    """in the SI unit of its dimension"""
    dimension: Dimension

    def __str__(self) -> str:
        """The value in its practical unit, as in "17.107 mN"."""
        return shown(self.value, self.dimension)


class Column(NamedTuple):
    """A named quantity, SI values, and the unit in which they are written."""

    name: str
    values: Array
    unit: Unit
    instead: Mapping[int, str] = {}
    """by row: words that take the place of a number"""

    @property
    def title(self) -> str:
        """Name and unit."""
        return f"{self.name} [{self.unit.name}]" if self.unit.name else self.name


class Mixed(NamedTuple):
    """A named quantity whose values differ so much that each has its own practical unit."""

    name: str
    values: Sequence[float]
    """in the SI unit of the dimension"""
    dimension: Dimension
    instead: Mapping[int, str] = {}
    """by row: words that take the place of a number"""

    @property
    def title(self) -> str:
        """The name."""
        return self.name


class Words(NamedTuple):
    """A column of words."""

    name: str
    values: Sequence[str]

    @property
    def title(self) -> str:
        """The name."""
        return self.name


Table = Sequence["Column | Mixed | Words"]
"""Columns of the same length, words that name the rows first."""


def column(name: str, values: Any, dimension: Dimension) -> Column:
    """A column in the practical unit that suits its largest value."""
    array = np.asarray(values, dtype=float)
    return Column(name, array, practical(dimension, array))


def in_words(rows: Iterable[Sequence[str]]) -> list[Words]:
    """A table of words from its rows, the titles first."""
    return [Words(title, cells) for title, *cells in zip(*rows, strict=True)]


def columns_of(states: Any, *names: str) -> list[Column]:
    """What states hold, by the names of their fields."""
    return [column(name.replace("_", " "), getattr(states, name), QUANTITIES[name]) for name in names]


def spread_over(count: int, most: int) -> list[int]:
    """At most `most` of the indices 0 ... count-1, evenly spread, the last one among them."""
    if count <= most:
        return list(range(count))
    return [round((i + 1) * count / most) - 1 for i in range(most)]


@dataclass(frozen=True, eq=False, kw_only=True)
class Result:
    """What a study found. The objects that a figure draws are further members of the result of each study."""

    title: str
    numbers: Mapping[str, Number] = field(default_factory=dict)
    """single quantities, by name"""
    notes: Mapping[str, str] = field(default_factory=dict)
    """sentences on the result, by what they are about"""
    tables: Mapping[str, Table] = field(default_factory=dict)
    """by name"""
    warnings: tuple[str, ...] = ()
    """reasons to doubt the numbers"""


def study(function: Callable[P, R]) -> Callable[P, R]:
    """Make a study of a function: its result carries the warnings, the `stop` of its keyword `progress` ends it."""

    @functools.wraps(function)
    def whole(*arguments: P.args, **options: P.kwargs) -> R:
        progress = options.get("progress")
        listened = progress.listened() if isinstance(progress, Progress) else nullcontext()
        cautions: Sequence[_warn.Caution] = ()
        try:
            with _warn.kept() as cautions, listened:
                found = function(*arguments, **options)
        finally:
            _warn.warn_all(cautions)
        return replace(found, warnings=(*found.warnings, *_warn.texts_of(cautions)))

    return whole


def in_turn(progress: Progress, parts: Iterable[T], total: int, what: str) -> Iterator[T]:
    """Go through the parts of a loop, and report each one that is done."""
    progress.step(0, total, what)
    for done, part in enumerate(parts, start=1):
        yield part
        progress.step(done, total, what)
