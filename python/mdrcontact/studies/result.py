# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of studies: named numbers, sentences, warnings and tables."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple, ParamSpec, TypeVar

import numpy as np
from numpy.typing import NDArray

from .. import _warn
from .._parts import share
from .._units import QUANTITIES, Dimension, Unit, practical, shown
from ..progress import Progress

Array = NDArray[np.float64]
P = ParamSpec("P")
R = TypeVar("R", bound="Result")
T = TypeVar("T")
U = TypeVar("U")


class Number(NamedTuple):
    """Quantity of a result, with its physical dimension.

    Examples
    --------
    >>> from mdrcontact import problem, studies
    >>> ball = {"shape": "sphere", "radius": "10 um"}
    >>> glass = {"type": "homogeneous", "material": {"E": "72 GPa", "nu": 0.17}}
    >>> found = studies.curve(problem.read({"indenter": ball, "medium": glass, "compute": {"depths": ["50 nm"]}}))
    >>> print(found.numbers["force"], f"{found.numbers['force'].value:.4e}")
    3.4934 mN 3.4934e-03
    """

    value: float
    """value in the SI unit of its dimension"""
    dimension: Dimension
    """physical dimension, which determines the units"""

    def __str__(self) -> str:
        """The value in its practical unit, as in "17.107 mN"."""
        return shown(self.value, self.dimension)


class Column(NamedTuple):
    """Column of a table: a quantity in SI units, and the unit in which it is written.

    Examples
    --------
    >>> from mdrcontact import problem, studies
    >>> ball = {"shape": "sphere", "radius": "10 um"}
    >>> glass = {"type": "homogeneous", "material": {"E": "72 GPa", "nu": 0.17}}
    >>> found = studies.curve(problem.read({"indenter": ball, "medium": glass, "compute": {"depths": ["50 nm", "100 nm"]}}))
    >>> depth = found.tables["states"][0]
    >>> print(depth.title, depth.values)
    depth [nm] [5.e-08 1.e-07]
    """

    name: str
    """name of the quantity"""
    values: Array
    """values in the SI unit"""
    unit: Unit
    """unit in which the values are written"""
    instead: Mapping[int, str] = {}
    """text that replaces a number, by row"""

    @property
    def title(self) -> str:
        """Name and unit of the column."""
        return f"{self.name} [{self.unit.name}]" if self.unit.name else self.name


class Mixed(NamedTuple):
    """Column of a table whose values each have their own practical unit.

    Examples
    --------
    >>> from mdrcontact import problem, studies
    >>> ball = {"shape": "sphere", "radius": "10 um"}
    >>> glass = {"type": "homogeneous", "material": {"E": "72 GPa", "nu": 0.17}}
    >>> found = studies.stress(problem.read({"indenter": ball, "medium": glass, "compute": {"depths": ["50 nm"]}}))
    >>> print([type(column).__name__ for column in found.tables["maxima"]])
    ['Words', 'Words', 'Mixed', 'Column', 'Mixed']
    """

    name: str
    """name of the quantity"""
    values: Sequence[float]
    """values in the SI unit of the dimension"""
    dimension: Dimension
    """physical dimension, which determines the units"""
    instead: Mapping[int, str] = {}
    """text that replaces a number, by row"""

    @property
    def title(self) -> str:
        """Name of the column."""
        return self.name


class Words(NamedTuple):
    """Column of text in a table.

    Examples
    --------
    >>> from mdrcontact.studies import Words
    >>> print(Words("model", ["gao", "exact"]).title)
    model
    """

    name: str
    """name of the column"""
    values: Sequence[str]
    """one text for each row"""

    @property
    def title(self) -> str:
        """Name of the column."""
        return self.name


Table = Sequence["Column | Mixed | Words"]
"""Columns of one length; columns of text that name the rows come first."""


def column(name: str, values: Any, dimension: Dimension) -> Column:
    """A column in the practical unit that suits its largest value."""
    array = np.asarray(values, dtype=float)
    return Column(name, array, practical(dimension, array))


def in_words(rows: Iterable[Sequence[str]]) -> list[Words]:
    """A table of words from its rows, the titles first."""
    return [Words(title, cells) for title, *cells in zip(*rows, strict=True)]


def columns_of(states: Any, *names: str) -> list[Column]:
    """Return columns of states by the names of their fields."""
    return [column(name.replace("_", " "), getattr(states, name), QUANTITIES[name]) for name in names]


def spread_over(count: int, most: int) -> list[int]:
    """At most `most` of the indices 0 ... count-1, evenly spread, the last one among them."""
    if count <= most:
        return list(range(count))
    return [round((i + 1) * count / most) - 1 for i in range(most)]


@dataclass(frozen=True, eq=False, kw_only=True)
class Result:
    """Result of a study.

    The result of each study has further members: the objects that its figure shows.

    Examples
    --------
    >>> from mdrcontact import problem, studies
    >>> ball = {"shape": "sphere", "radius": "10 um"}
    >>> glass = {"type": "homogeneous", "material": {"E": "72 GPa", "nu": 0.17}}
    >>> found = studies.curve(problem.read({"indenter": ball, "medium": glass, "compute": {"depths": ["50 nm"]}}))
    >>> table: studies.Table = found.tables["states"]
    >>> print(isinstance(found, studies.Result), len(table), found.warnings)
    True 6 ()
    """

    title: str
    """title of the problem"""
    numbers: Mapping[str, Number] = field(default_factory=dict)
    """single quantities by name"""
    notes: Mapping[str, str] = field(default_factory=dict)
    """sentences on the result, by their subject"""
    tables: Mapping[str, Table] = field(default_factory=dict)
    """tables by name"""
    warnings: tuple[str, ...] = ()
    """warnings about the numbers"""


def study(function: Callable[P, R]) -> Callable[P, R]:
    """Make a study of a function: its result contains the warnings, the `stop` of its keyword `progress` ends it."""

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


def shared(progress: Progress, work: Callable[[T], U], parts: Iterable[T], what: str) -> list[U]:
    """Return the results of independent parts of a loop in their order, and report how many are done."""
    tasks = list(parts)
    progress.step(0, len(tasks), what)
    return share(work, tasks, done=lambda done: progress.step(done, len(tasks), what))


def in_turn(progress: Progress, parts: Iterable[T], total: int, what: str) -> Iterator[T]:
    """Go through the parts of a loop, and report each one that is done."""
    progress.step(0, total, what)
    for done, part in enumerate(parts, start=1):
        yield part
        progress.step(done, total, what)
