# SPDX-License-Identifier: GPL-3.0-or-later
"""Read the tables of a problem file with checks. An error names the place, the rule and the remedy."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from inspect import Parameter, signature
from typing import TYPE_CHECKING, Any, TypeVar

from .._choices import suggestion
from .._units import RATIO, Dimension, UnitError, parse, to_si
from ..errors import MDRError
from .field import NOT_NEGATIVE, POSITIVE, Field, Range, Table
from .named import Files, GivenFiles, NamedFile, ProblemError, last_of

if TYPE_CHECKING:
    from ..instruments.reading.columns import MeasuredTable

Made = TypeVar("Made")
WHOLE = "the file"
"""The name of the table that is the whole file."""
_ARGUMENT = re.compile(
    r"(?:entry (?P<entry>\d+) of )?(?:(?P<part>[a-z]+) )?(?:(?P<number>\d+) )?(?P<name>\w+)(?: = [^:]*)?: (?P<rule>.*)", re.DOTALL
)
"""A message of the library that begins with an argument."""
_SEVERAL = re.compile(r"(\w+)(?:,| and| has) ")
"""One that begins with several."""

__all__ = ["ProblemError", "Section"]


def _real(number: float) -> float:
    """Return a number as a float. An integer beyond the largest float is infinite, which the library does not accept."""
    try:
        return float(number)
    except OverflowError:
        return math.inf if number > 0 else -math.inf


def _bounds(allowed: Range) -> str:
    plain = {POSITIVE: "greater than 0 and finite", NOT_NEGATIVE: "at least 0 and finite"}
    return plain.get(allowed, str(allowed))


class Section:
    """One table of a problem file.

    `known` has its keys: a `Table` of the schema, or a mapping with a `Dimension` for quantities, None or `RATIO` for the rest. A
    quantity has its unit in the value, radius = "500 nm", or in the key, radius_nm = 500. Files that it names are among `files`;
    None: it may not name files.
    """

    def __init__(self, table: Any, path: str, known: Mapping[str, Dimension | None], files: Files | None = None) -> None:
        if not isinstance(table, dict):
            above, key, number = last_of(path)
            remedy = f"Write a line [{path}] and its keys below it"
            raise ProblemError("it must be a table", remedy, table=above, key=key, entry=number, value=table)
        self.path, self._files = path, files or GivenFiles()
        self._table = table
        self._schema = known if isinstance(known, Table) else None
        self._known = {key: dimension if dimension != RATIO else None for key, dimension in known.items()}
        for key in table:
            if key not in known and not any(d and key.startswith(f"{k}_") for k, d in self._known.items()):
                raise self.error(key, f"unknown key {key!r}", suggestion(key, known), shows=False)

    def error(self, key: str, rule: str, remedy: str = "", entry: int = 0, shows: bool = True) -> ProblemError:
        """Return the error of a key, with its value as the file has it if the message `shows` it. entry : of a list, from 1"""
        value = self._table.get(self._spelling(key) or key) if shows else None
        if entry and isinstance(value, list):
            value = value[entry - 1]
        return ProblemError(rule, remedy, table="" if self.path == WHOLE else self.path, key=key, entry=entry, value=value)

    def __contains__(self, key: str) -> bool:
        return self._spelling(key) is not None

    def only(self, keys: Iterable[str], because: str) -> None:
        """Raise an error for keys of the table that do not belong to this kind."""
        allowed = set(keys)
        for key in self._known:
            if key not in allowed and key in self:
                rule = f"the key {key!r} does not belong to {because}"
                raise self.error(key, rule, suggestion(key, sorted(allowed)), shows=False)

    def value(self, key: str, **words: str) -> Any:
        """Return the value of a key in SI units, checked by its field of the schema; if it is absent, the default.

        Lists must ascend, and a table is a `Section`. The words of other keys choose among fields of equal names.
        """
        assert self._schema is not None
        field = self._schema.field(key, **words)
        if key not in self and not field.required:
            return field.default
        if field.table is not None and not (field.choices and isinstance(self._table.get(key), str)):
            return self.children(key, field.table) if field.many else self.child(key, field.table)
        if field.choices:
            return self.choice(key, field.choices)
        if field.is_boolean:
            return self.truth(key)
        if field.many:
            return self.ascending(key, field.range is not None)
        if field.step:
            return self._whole(field)
        return self.number(key) if field.kind == "number" else self.quantity(key)

    def _whole(self, field: Field) -> int:
        assert field.range is not None
        least, largest = int(field.range.least), int(field.range.largest)
        value = self.count(field.name, field.default, largest)
        if value < least or value % field.step:
            rule = f"multiple of {field.step}" if field.step > 1 else "whole number"
            raise self.error(field.name, f"it must be a {rule} from {least} to {largest}")
        return value

    def quantity(self, key: str, default: float | None = None) -> float:
        """Return a quantity in SI units."""
        if default is not None and key not in self:
            return default
        value, suffix = self._found(key)
        return self._convert(key, value, suffix)

    def quantities(self, key: str) -> list[float]:
        """Return a list of quantities in SI units."""
        value, suffix = self._found(key)
        if not isinstance(value, list):
            raise self.error(key, "it must be a list", f"Write it as in {self._example(key, many=True)}")
        return [self._convert(key, one, suffix, i) for i, one in enumerate(value, start=1)]

    def entry(self, key: str, number: int) -> float:
        """Return one entry of a list of quantities in SI units. number : of the entry, from 1"""
        value, suffix = self._found(key)
        return self._convert(key, value[number - 1], suffix, number)

    def ascending(self, key: str, positive: bool = False) -> list[float]:
        """Return a list of at least one quantity in SI units, each greater than the one before it, and if `positive` than 0."""
        values = self.quantities(key)
        if not values:
            raise self.error(key, "it needs at least one value", f"Write it as in {self._example(key, many=True)}")
        for i, value in enumerate(values):
            before = values[i - 1] if i else 0.0 if positive else -math.inf
            if not before < value < math.inf:
                bound = "finite" + (" and greater than the one before it" if i else " and greater than 0" if positive else "")
                raise self.error(key, f"it must be {bound}", entry=i + 1)
        return values

    def number(self, key: str) -> float:
        """Return a number without unit."""
        value, _ = self._found(key, "0.3")
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise self.error(key, "it must be a number", "Write it without quotes and without a unit")
        return self._in_range(key, _real(value))

    def numbers(self, key: str) -> list[float]:
        """Return a list of numbers without unit."""
        value, _ = self._found(key)
        if not isinstance(value, list) or any(isinstance(v, bool) or not isinstance(v, (int, float)) for v in value):
            raise self.error(key, "it must be a list of numbers", f"Write it as in {key} = [0.2, 0.3]")
        return [self._in_range(key, _real(v), i) for i, v in enumerate(value, start=1)]

    def count(self, key: str, default: int, largest: int) -> int:
        """Return a whole number from 1 to `largest`."""
        value = self._table.get(key, default)
        if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= largest:
            raise self.error(key, f"it must be a whole number from 1 to {largest}")
        return value

    def choice(self, key: str, choices: Iterable[str], default: str | None = None) -> str:
        """Return one of several words."""
        if default is not None and key not in self:
            return default
        choices = list(choices)
        value, _ = self._found(key, f'"{choices[0]}"')
        if not isinstance(value, str) or value not in choices:
            raise self.error(key, "unknown word", suggestion(str(value), choices))
        return value

    def truth(self, key: str) -> bool:
        """Return true or false."""
        value, _ = self._found(key, "true")
        if not isinstance(value, bool):
            raise self.error(key, "it must be true or false", "Write it without quotes")
        return value

    def arguments(self, call: Callable[..., Any]) -> dict[str, Parameter]:
        """Return the arguments of a constructor that are keys of this table."""
        return {name: one for name, one in signature(call).parameters.items() if name in self._known}

    def make(self, call: Callable[..., Made], what: str = "", further: Iterable[str] = ()) -> Made:
        """Return the object that a constructor makes of the keys that are its arguments; one without a default must be there.

        If `what` describes the object, other keys than these and `further` ones are errors.
        """
        parameters = self.arguments(call)
        if what:
            self.only((*parameters, *further), what)
        needed = [name for name, one in parameters.items() if name in self or one.default is Parameter.empty]
        given = {name: self._value(name, str(parameters[name].annotation)) for name in needed}
        with self.words():
            return call(**given)

    def given(self, keys: Iterable[str]) -> dict[str, float]:
        """Return those of some numbers and quantities that are there, in SI units."""
        return {key: self._value(key, "float") for key in keys if key in self}

    def _value(self, key: str, kind: str) -> Any:
        """Return a word, a number or a list of numbers, by the annotation of an argument; quantities in SI units."""
        if kind == "str":
            return self.plain(key)
        one = kind.startswith("float")
        if self._known[key] is None:
            return self.number(key) if one else self.numbers(key)
        return self.quantity(key) if one else self.quantities(key)

    def plain(self, key: str, default: Any = None) -> Any:
        """Return a value as it is in the file."""
        return default if default is not None and key not in self else self._found(key)[0]

    def file(self, key: str, what: str, example: str) -> NamedFile:
        """Return the file that a key names."""
        name = self.plain(key)
        if not isinstance(name, str):
            raise self.error(key, f"it must be the name of {what}", f'Write it as in {key} = "{example}"')
        try:
            return self._files.find(name)
        except ProblemError as problem:
            raise self.error(key, problem.rule) from None

    def table(self, key: str, example: str) -> MeasuredTable:
        """Return the table in the file that a key names. Only this loads the reader, which belongs to `instruments`."""
        from ..instruments.reading.columns import read_named

        with self.about(key):
            return read_named(self.file(key, "a table", example))

    def child(self, key: str, known: Mapping[str, Dimension | None]) -> Section:
        """Return a table inside this one."""
        path = f"{self.path}.{key}"
        if key not in self:
            remedy = f"Write it with the keys {', '.join(list(known)[:2])} or others"
            raise self.error(key, f"the table [{path}] is missing", remedy, shows=False)
        return Section(self._table[key], path, known, self._files)

    def children(self, key: str, known: Mapping[str, Dimension | None]) -> list[Section]:
        """Return the tables [[...]] inside this one."""
        path = f"{self.path}.{key}"
        tables = self._table.get(key)
        if not isinstance(tables, list) or not tables:
            remedy = f"Write one for each {key.replace('_', ' ')}"
            raise self.error(key, f"the table [[{path}]] is missing", remedy, shows=False)
        return [Section(table, f"{path} {i}", known, self._files) for i, table in enumerate(tables, start=1)]

    @contextmanager
    def about(self, key: str) -> Iterator[None]:
        """Add the place in the file to errors that have none, as those of a file which a key names."""
        try:
            yield
        except ProblemError as problem:
            if not problem.key:
                problem.at(self.path, key)
            raise

    @contextmanager
    def words(self, **keys: str) -> Iterator[None]:
        """Add the place in the file to errors of the library, and the value as the file has it. keys : of arguments, by name"""
        try:
            yield
        except ProblemError:
            raise
        except MDRError as problem:
            raise self._placed(str(problem), keys) from problem

    def _placed(self, words: str, keys: Mapping[str, str]) -> ProblemError:
        """Return the error of the key that is the argument which a message of the library begins with."""
        several = _SEVERAL.match(words)
        if several is not None and several[1] in self._known:
            return self.error(several[1], words, shows=False)
        found = _ARGUMENT.match(words)
        if found is None:
            return ProblemError(words, table=self.path)
        rule, _, remedy = found["rule"].partition(". ")
        place = self._place(
            keys.get(found["name"], found["name"]), found["part"] or "", int(found["number"] or found["entry"] or 0)
        )
        if place is None:
            return ProblemError(words, table=self.path)
        section, key = place
        value = section.plain(key)
        is_entry = found["entry"] and isinstance(value, list) and int(found["entry"]) <= len(value)
        return section.error(key, rule, remedy, int(found["entry"]) if is_entry else 0)

    def _place(self, name: str, part: str, number: int) -> tuple[Section, str] | None:
        """Return the table with an argument, this one or one inside, and its key. part, number : of the body that has it"""
        for key in (name, f"{part}_{name}"):
            if key in self._known and key in self:
                return self, key
        tables = [one for one in self._schema.fields if one.table is not None] if self._schema else []
        for one in sorted(tables, key=lambda one: one.name != part):
            inside = self._table.get(one.name)
            for i, table in enumerate(inside if isinstance(inside, list) else [inside], start=1):
                if isinstance(table, dict) and (not isinstance(inside, list) or i == number):
                    path = f"{self.path}.{one.name}{f' {i}' if isinstance(inside, list) else ''}"
                    found = Section(table, path, one.table or {}, self._files)._place(name, "", 0)
                    if found is not None:
                        return found
        return None

    def _spelling(self, key: str) -> str | None:
        found = [k for k in self._table if k == key or (self._known.get(key) and k not in self._known and k.startswith(f"{key}_"))]
        if len(found) > 1:
            rule = f"{' and '.join(found)} give the same quantity twice"
            raise ProblemError(rule, "Keep one", table=self.path, key=key)
        return found[0] if found else None

    def _found(self, key: str, example: str = "...") -> tuple[Any, str]:
        spelling = self._spelling(key)
        if spelling is None:
            raise self.error(key, f"the key {key!r} is missing", f"Write it as in {self._example(key, example)}", shows=False)
        return self._table[spelling], spelling[len(key) + 1 :]

    def _convert(self, key: str, value: Any, suffix: str, entry: int = 0) -> float:
        dimension = self._known[key]
        assert dimension is not None
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
        try:
            if suffix and is_number:
                return self._in_range(key, to_si(_real(value), suffix, dimension), entry)
            if suffix:
                raise self.error(key, "it must be a number", "The key has the unit already", entry)
            if isinstance(value, str):
                return self._in_range(key, parse(value, dimension), entry)
        except UnitError as problem:
            rule, _, remedy = str(problem).partition(": ")
            own = f"{value!r} "
            rule = f"it {rule.removeprefix(own)}" if rule.startswith(own) else rule
            raise self.error(key, rule, remedy[:1].upper() + remedy[1:], entry) from None
        example = f"as in {self._example(key)}"
        if is_number:
            raise self.error(key, "it has no unit", f"Write {dimension.name} {example}", entry)
        raise self.error(key, f"it must be {dimension.name}", f"Write it {example}", entry)

    def _in_range(self, key: str, value: float, entry: int = 0) -> float:
        """Return a number in SI units, which must lie in the range of each field of the schema that has this key here."""
        fields = self._schema.fields if self._schema else ()
        ranges = [one.range for one in fields if one.name == key and self._may_belong(one)]
        bounds = [one for one in ranges if one is not None]
        if bounds and len(bounds) == len(ranges) and not any(one.holds(value) for one in bounds):
            raise self.error(key, f"it must be {_bounds(bounds[0])}", entry=entry)
        return value

    def _may_belong(self, field: Field) -> bool:
        """Whether a field may belong to this table, by the words in it."""
        words = {key: self._table.get(key) for key in field.when}
        return not words or any(not field.when[key] or word is None or word in field.when[key] for key, word in words.items())

    def _example(self, key: str, plain: str = "...", many: bool = False) -> str:
        dimension = self._known.get(key)
        text = f'"{dimension.example}"' if dimension else plain
        return f"{key} = [{text}, ...]" if many else f"{key} = {text}"
