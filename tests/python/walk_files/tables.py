# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables of problem files that are changed in one place: which keys the readers know, and what else could stand there."""

from __future__ import annotations

import contextlib
import copy
import re
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from mdrcontact import _units as units
from mdrcontact.problem.section import Section

Table = dict[str, Any]
_QUANTITY = re.compile(r"([-+]?[\d.]+(?:[eE][-+]?\d+)?) ?(.*)")
_STEP = re.compile(r'"[^"]*"|[^."]+')


class Seen(NamedTuple):
    """What readers requested of the tables of a file."""

    known: dict[str, Mapping[str, units.Dimension | None]]
    """by the name of a table: its keys"""
    choices: dict[tuple[str, str], list[str]]
    """by table and key: the words that may stand there"""


class Change(NamedTuple):
    """One place of a file, changed."""

    table: str
    key: str
    how: str
    tables: Table


@contextlib.contextmanager
def watched() -> Iterator[Seen]:
    """Notes which tables are read, with which keys and words."""
    seen = Seen({}, {})
    begin, choose = Section.__init__, Section.choice

    def noted_begin(self: Section, table: Any, path: str, known: Any, *more: Any, **named: Any) -> None:
        begin(self, table, path, known, *more, **named)
        seen.known.setdefault(path, known)

    def noted_choice(self: Section, key: str, choices: Any, default: str | None = None) -> str:
        choices = list(choices)
        seen.choices[self.path, key] = choices
        return choose(self, key, choices, default)

    Section.__init__, Section.choice = noted_begin, noted_choice  # type: ignore[method-assign]
    try:
        yield seen
    finally:
        Section.__init__, Section.choice = begin, choose  # type: ignore[method-assign]


def steps_to(path: str) -> list[Any]:
    """Where the table lies that readers call so: "medium.layer 2" is tables["medium"]["layer"][1]."""
    steps: list[Any] = []
    for step in [] if path == "the file" else _STEP.findall(path):
        name, _, place = step.strip('"').partition(" ")
        steps += [name, int(place) - 1] if place.isdecimal() else [step.strip('"')]
    return steps


def table_at(tables: Table, path: str) -> Table | None:
    """The table of that name, None for what no table of the file is."""
    found: Any = tables
    try:
        for step in steps_to(path):
            found = found[step]
    except (KeyError, IndexError, TypeError):
        return None
    return found if isinstance(found, dict) else None


def plain_name(path: str) -> str:
    """A table's name without the number among its like."""
    return re.sub(r'\."[^"]*"', "", re.sub(r" \d+", "", path))


def changes(
    tables: Table, seen: Seen, samples: Mapping[tuple[str, str], Any], others: Mapping[tuple[str, str], Any]
) -> list[Change]:
    """Every place of a file changed: numbers by 10 %, words by each other one, keys left out, absent keys put in.

    samples : by table and key, what stands there where it was absent, a value or a list of several
    others : by table and key, what else can stand there of what is neither number, quantity nor a word of a choice
    """
    found = []
    for path, known in seen.known.items():
        table = table_at(tables, path)
        if table is None:
            continue
        for key, dimension in known.items():
            place = plain_name(path), key
            if key in table:
                values = [*_other_values(table[key], seen.choices.get((path, key), ()), others.get(place, ()), place)]
                values.append(("left out", None))
            else:
                values = [(f"put in as {one!r}", one) for one in _samples(place, dimension, seen.choices.get((path, key)), samples)]
            for how, value in values:
                changed = copy.deepcopy(tables)
                inside = table_at(changed, path)
                assert inside is not None
                if value is None:
                    del inside[key]
                else:
                    inside[key] = value
                found.append(Change(path, key, how, changed))
    return found


def _samples(place: tuple[str, str], dimension: Any, choices: Any, samples: Mapping[tuple[str, str], Any]) -> list[Any]:
    for known in (place, ("*", place[1])):
        if known in samples:
            return list(samples[known])
    if dimension is not None and dimension != units.RATIO:
        return [dimension.example]
    if choices:
        return list(choices)
    raise AssertionError(f"[{place[0]}] {place[1]} is a key without a sample: give one in walk_files/cases.py")


def _other_values(value: Any, choices: Any, others: Any, place: tuple[str, str]) -> Iterator[tuple[str, Any]]:
    if isinstance(value, dict):
        return
    for other in others:
        if other != value:
            yield f"{other!r}", other
    if others:
        return
    if isinstance(value, str) and value in choices:
        yield from ((f"{other!r}", other) for other in choices if other != value)
    elif isinstance(value, list):
        for i, entry in enumerate(value):
            if not isinstance(entry, dict):
                for how, other in _other_values(entry, (), (), place):
                    yield f"entry {i + 1} {how}", [*value[:i], other, *value[i + 1 :]]
    else:
        yield "10 % more", more(value, place)


def more(value: Any, place: tuple[str, str]) -> Any:
    """A number or a quantity, ten per cent more of it."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, (int, float)) and value == 0:
        return 0.1
    if isinstance(value, int):
        return value + max(1, round(0.1 * value))
    if isinstance(value, float):
        return 1.1 * value
    match = _QUANTITY.fullmatch(value) if isinstance(value, str) else None
    if match is None:
        raise AssertionError(f"[{place[0]}] {place[1]} = {value!r}: say in walk_files/cases.py what else can stand there")
    return f"{1.1 * float(match[1]) or 0.1!r} {match[2]}"


def as_toml(tables: Table) -> str:
    """The tables as a file."""
    return "".join(f"{_name(key)} = {_value(value)}\n" for key, value in tables.items())


def _name(key: str) -> str:
    return key if re.fullmatch(r"\w+", key) else f'"{key}"'


def _value(value: Any) -> str:
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_name(key)} = {_value(one)}" for key, one in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(_value, value)) + "]"
    if isinstance(value, bool):
        return "true" if value else "false"
    return f'"{value}"' if isinstance(value, str) else repr(value)
