# SPDX-License-Identifier: GPL-3.0-or-later
"""Goes through scenes: changes every member of their objects, and compares every answer with that of the unchanged object."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np

import mdrcontact as mdr

from .answers import ANSWERS, Answer, Numbers
from .exceptions import CONDITIONS, EXCEPTIONS, Exempt
from .scenes import Scene
from .tree import Change, changes, get, made, put

ENOUGH = 100.0
"""A change is larger than so many tolerances of the answer."""


@dataclass(frozen=True)
class Case:
    """What became of one answer of a scene when one member was changed."""

    scene: str
    change: Change
    answer: str
    outcome: str
    """matters, refused, same"""
    owner: Any = None
    """the object that has the member"""
    size: float = 0.0
    """relative change of the answer"""
    words: str = ""
    """of a refusal"""

    @property
    def triple(self) -> tuple[str, str, str]:
        return self.change.owner, self.change.member, self.answer

    def __str__(self) -> str:
        what = f"changes by {self.size:.1e}" if self.outcome == "same" else self.outcome
        return f"{self.change.key} at {self.scene}:{self.change.place} | {self.answer}: {what}"


@dataclass
class Report:
    """All cases of a walk."""

    cases: list[Case] = field(default_factory=list)

    @property
    def triples(self) -> set[tuple[str, str, str]]:
        return {case.triple for case in self.cases}

    def count(self, outcome: str) -> int:
        return sum(case.outcome == outcome for case in self.cases)

    def findings(self) -> list[Case]:
        """Members that do not matter, and are no exception."""
        return [case for case in self.cases if case.outcome == "same" and not any(_matches(line, case) for line in EXCEPTIONS)]

    def wrong_exceptions(self) -> list[str]:
        """Exceptions that no case needs, and those that hold for a case in which the member matters."""
        wrong = []
        for line in EXCEPTIONS:
            held = [case for case in self.cases if _matches(line, case)]
            if not held:
                wrong.append(f"{line}: no case needs it")
            wrong += [f"{line}: it matters in {case}" for case in held if case.outcome == "matters"]
        return wrong

    def never(self) -> set[tuple[str, str]]:
        """Classes and members that matter to no answer, and are refused by none."""
        matter = {case.triple[:2] for case in self.cases if case.outcome != "same"}
        return {case.triple[:2] for case in self.cases} - matter

    def summary(self) -> str:
        exempt = {case.triple for case in self.cases if case.outcome == "same"}
        return (
            f"{len(self.triples)} triples of class, member and answer in {len(self.cases)} cases: {self.count('matters')} matter, "
            f"{self.count('refused')} are refused, {self.count('same')} do not matter, which are {len(exempt)} triples in "
            f"{len(EXCEPTIONS)} lines of exceptions"
        )


def walk(scenes: Iterable[Scene]) -> Report:
    """Goes through scenes; a scene that cannot answer as it stands, and an exception that is no refusal, end it."""
    report = Report()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for scene in scenes:
            report.cases += _through(scene)
    return report


def _through(scene: Scene) -> Iterator[Case]:
    before = {name: _numbers(ANSWERS[name], made(scene.object)) for name in scene.answers}
    for change in changes(scene.object):
        if scene.only and not any(change.place.startswith(place) for place in scene.only):
            continue
        changed, refusal = _changed(scene, change)
        owner = get(scene.object, change.path[: change.depth])
        for name, numbers in before.items():
            known = ANSWERS[name]
            after: Any = refusal
            if refusal is None:
                try:
                    after = _numbers(known, changed)
                except mdr.MDRError as problem:
                    after = problem
            if isinstance(after, mdr.MDRError):
                yield Case(scene.name, change, name, "refused", owner, words=str(after))
                continue
            size = max(_difference(value, after.get(part)) for part, value in numbers.items())
            yield Case(scene.name, change, name, "matters" if size > ENOUGH * known.tolerance else "same", owner, size)


def _changed(scene: Scene, change: Change) -> tuple[Any, mdr.MDRError | None]:
    """The object with a member changed, or the last refusal of its values."""
    refusal = None
    for value in change.values:
        try:
            return made(put(scene.object, change.path, value)), None
        except mdr.MDRError as problem:
            refusal = problem
    return None, refusal


def _numbers(known: Answer, thing: Any) -> Numbers:
    return {name: np.asarray(value) for name, value in known.function(thing).items()}


def _difference(before: Any, after: Any) -> float:
    """Relative change of an answer; infinite where its shape changes."""
    if after is None or before.shape != after.shape:
        return np.inf
    if before.dtype.kind not in "iufcb":
        return 0.0 if np.array_equal(before, after) else np.inf
    assert not (np.isnan(before).any() or np.isnan(after).any()), "an answer is not a number"
    with np.errstate(invalid="ignore"):
        distance = np.where(before == after, 0.0, np.abs(after - before))
        scale = np.maximum(np.abs(before), np.abs(after))
        # entries of columns that are of one kind differ in size: each by itself, unless it is rounding beside the others
        largest = scale[np.isfinite(scale)].max(initial=0.0)
        part = np.where(distance > 0.0, distance / np.maximum(scale, 1e-9 * largest), 0.0)
    return float(np.where(np.isnan(part), np.inf, part).max(initial=0.0))


def _matches(line: Exempt, case: Case) -> bool:
    if line.answer != case.answer or line.member != case.change.key:
        return False
    if line.where in CONDITIONS:
        return CONDITIONS[line.where](case.owner)
    return line.where in ("", case.scene, f"{case.scene}:{case.change.place}")
