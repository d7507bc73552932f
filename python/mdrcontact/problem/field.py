# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields and tables of problem files as data, for readers, `--help`, the guide and forms."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from inspect import Parameter, signature
from typing import Any, NamedTuple

from .._units import RATIO, Dimension


class Range(NamedTuple):
    """An interval of numbers [SI units], open at its ends unless `has_least`, `has_largest`."""

    least: float = -math.inf
    largest: float = math.inf
    has_least: bool = False
    has_largest: bool = False

    def holds(self, value: float) -> bool:
        """Return whether a number lies in the interval; NaN never does."""
        above = value >= self.least if self.has_least else value > self.least
        return above and (value <= self.largest if self.has_largest else value < self.largest)

    def __str__(self) -> str:
        ends = f">{'=' * self.has_least} {self.least:g}", f"<{'=' * self.has_largest} {self.largest:g}"
        return " and ".join(end for end, at in zip(ends, self, strict=False) if math.isfinite(at))


POSITIVE, NOT_NEGATIVE = Range(0.0), Range(0.0, has_least=True)
POISSON = Range(-1.0, 0.5, has_largest=True)
"""of Poisson's ratio"""


class Field(NamedTuple):
    """One key of a table, or one of its rules: `when` distinguishes fields of equal names.

    Words, files, booleans and tables have no `dimension`, numbers have `RATIO`. An absent key means `default` [SI units]; without
    a default the key is required unless `optional`. Instead of one of its `choices` a key can have a quantity or a table, if the
    field has one. `range` bounds a number, or each entry if there are `many`. A whole number is a multiple of `step`. The field
    belongs to its table if one of the keys of `when` is present with one of its values, () for any value; the key "" is the kind of
    a material. `example` is a value as a file has it, if neither dimension, default nor choices give one.
    """

    name: str
    meaning: str
    dimension: Dimension | None = None
    default: Any = None
    optional: bool = False
    choices: tuple[str, ...] = ()
    range: Range | None = None
    when: Mapping[str, tuple[str, ...]] = {}
    table: Table | None = None
    many: bool = False
    step: int = 0
    is_file: bool = False
    is_boolean: bool = False
    example: str = ""

    @property
    def required(self) -> bool:
        """Whether the key must be there, if the field belongs to its table."""
        return self.default is None and not self.optional

    @property
    def kind(self) -> str:
        """ "choice", "table", "file", "boolean", "whole number", "number", "quantity" or "text"."""
        plain = "text" if self.dimension is None else "number" if self.dimension == RATIO else "quantity"
        kinds = {"choice": self.choices, "table": self.table, "file": self.is_file, "boolean": self.is_boolean}
        return next(kind for kind, has in {**kinds, "whole number": self.step, plain: True}.items() if has)


@dataclass(frozen=True, eq=False)
class Table(Mapping[str, Dimension | None]):
    """A table of a problem file. As a mapping it gives the dimension of every key that its reader recognizes.

    Of each group in `one_of` exactly one key is given, of each in `at_most_one_of` one or none. The fields of the table that it
    `extends` are the first of its own. The keys of its `inner` table are errors with a message of their own. Other keys
    replace the `replaced` ones before the table is read. If a file has several such tables, each with its own name, `name` is
    an example of one.
    """

    meaning: str
    fields: tuple[Field, ...]
    guide: str = ""
    one_of: tuple[tuple[str, ...], ...] = ()
    at_most_one_of: tuple[tuple[str, ...], ...] = ()
    extends: Table | None = None
    inner: Table | None = None
    replaced: tuple[Field, ...] = ()
    name: str = ""

    def field(self, name: str, **words: str) -> Field:
        """Return the first field of a name that belongs to a table in which other keys have these words; KeyError for others."""
        fields = [one for one in self.fields if one.name == name] if words else [self._first[name]]
        for one in fields:
            if all(word in (one.when.get(key) or (word,)) for key, word in words.items()):
                return one
        raise KeyError(name)

    def keys_of(self, chooser: str, word: str) -> list[str]:
        """Return the keys that belong to a table in which the key `chooser` has this word."""

        def belongs(one: Field) -> bool:
            return not one.when or any(
                word in words if key == chooser else any(belongs(other) for other in self.fields if other.name == key)
                for key, words in one.when.items()
            )

        return list(dict.fromkeys(one.name for one in self.fields if belongs(one)))

    @cached_property
    def _first(self) -> dict[str, Field]:
        return {one.name: one for one in reversed(self.fields)}

    def __getitem__(self, key: str) -> Dimension | None:
        return self._first[key].dimension if key in self._first or self.inner is None else self.inner[key]

    def __iter__(self) -> Iterator[str]:
        return iter(dict.fromkeys((*(one.name for one in self.fields), *(self.inner or ()))))

    def __len__(self) -> int:
        return len(list(iter(self)))


def arguments(
    calls: Mapping[str, Callable[..., Any]], chooser: str, dimensions: Mapping[str, Dimension], fields: Iterable[Field]
) -> Iterator[Field]:
    """Yield fields with what the signatures of constructors, by kind, add: defaults, lists, and `when`.

    Kinds with the same default share a field. A field that is no argument stays as it is.
    """
    signatures = {kind: signature(call).parameters for kind, call in calls.items()}
    for one in fields:
        rules: dict[tuple[Any, bool], list[str]] = {}
        for kind in (kind for kind, parameters in signatures.items() if one.name in parameters):
            argument = signatures[kind][one.name]
            rules.setdefault((argument.default, not argument.annotation.startswith(("float", "str"))), []).append(kind)
        for (default, many), kinds in rules.items():
            number = default if isinstance(default, float) else None
            # a default that the range excludes marks a number that must be given
            optional = default is not Parameter.empty and (number is None or one.range is None or one.range.holds(number))
            known = one._replace(dimension=dimensions.get(one.name), default=number if optional else None, optional=optional)
            yield known._replace(when={chooser: tuple(kinds)}, many=many)
        if not rules:
            yield one
