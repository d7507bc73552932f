# SPDX-License-Identifier: GPL-3.0-or-later
"""The walk: each case, each command, each key changed; and the table of keys that rightly change nothing."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from fnmatch import fnmatch
from pathlib import Path
from typing import NamedTuple

from .cases import OTHERS, SAMPLES, Case
from .commands import REFUSALS, Answer, answer, difference
from .tables import as_toml, changes, plain_name, watched

SEEN = 1e-7
"""A change of an answer, 100 times the tolerance of states."""
PRESENTATION = ("title",)
"""Keys of the file that are words for the reader."""


class Triple(NamedTuple):
    """A key of a table, and who answers."""

    command: str
    case: str
    table: str
    key: str


class Effect(NamedTuple):
    """What came of one change."""

    triple: Triple
    how: str
    size: float
    """of the change of the answer; NaN where it is refused"""
    words: str
    """of the refusal"""

    @property
    def is_lost(self) -> bool:
        """Nothing changes, and nothing is said."""
        return self.size <= SEEN and self.triple.key not in PRESENTATION


class Rule(NamedTuple):
    """A line of exceptions.txt: what rightly changes nothing, and why."""

    command: str
    case: str
    table: str
    key: str
    how: str
    reason: str

    def covers(self, effect: Effect) -> bool:
        """Whether it is about this change; "*" is any case or change."""
        own, (command, case, table, key) = self, effect.triple
        places = own.command == command and own.table == table and own.key == key
        return places and own.case in ("*", case) and own.how in ("*", effect.how)


def rules() -> list[Rule]:
    """The table of exceptions."""
    lines = Path(__file__).with_name("exceptions.txt").read_text(encoding="utf-8").splitlines()
    found = []
    for line in lines:
        if line and not line.startswith("#"):
            where, place, how, reason = (part.strip() for part in line.split(" | "))
            command, _, case = where.partition("/")
            table, _, key = place.rpartition(":")
            found.append(Rule(command, case or "*", table, key, how, reason))
    return found


def walk(
    cases: Iterable[Case],
    folder: Path,
    known: list[Rule],
    chosen: Callable[[int], bool] = lambda _: True,
    request: Callable[[str, Path], Answer] = answer,
) -> Iterator[Effect]:
    """The effects of all changes of all cases, or of those whose number is chosen."""
    number = 0
    file = folder / "problem.toml"
    foreign = {(rule.command, rule.case, rule.key) for rule in known if rule.table == "the file" and rule.how == "*"}
    for case in cases:
        for name, text in case.files.items():
            (folder / name).write_text(text, encoding="utf-8")
        for command in case.commands:
            file.write_text(as_toml(case.tables), encoding="utf-8")
            with watched() as seen:
                before = request(command, file)
            for change in changes(case.tables, seen, SAMPLES, OTHERS):
                table = change.table.partition(".")[0].partition(" ")[0]
                if (command, "*", table) in foreign or (command, case.name, table) in foreign:
                    continue
                if not fnmatch(f"{change.table}:{change.key}", case.only):
                    continue
                number += 1
                if not chosen(number):
                    continue
                file.write_text(as_toml(change.tables), encoding="utf-8")
                triple = Triple(command, case.name, plain_name(change.table), change.key)
                try:
                    yield Effect(triple, change.how, difference(before, request(command, file)), "")
                except REFUSALS as refusal:
                    yield Effect(triple, change.how, float("nan"), str(refusal))
