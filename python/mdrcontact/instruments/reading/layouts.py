# SPDX-License-Identifier: GPL-3.0-or-later
"""Layouts of tables that hold more than one test, or one test in more columns than it has quantities."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...problem.roles import ROLES
from .titles import DIRECTIONS, bare, is_one_of, parts

Array = NDArray[np.float64]

NAMED_TESTS = (re.compile(r"[XY]_(?P<test>.+?)_(?P<name>[^_]+)_(?P<unit>[\[(][^\])]*[\])])"),)
"""Titles that name their test: Anton Paar."""
_NUMBER = re.compile(r"(?<!\d)(?<!\d\.)\d+(?!\.?\d)")
_WORD = re.compile(r"[^\W_]+")
_BRACKETS = re.compile(r"[\[({].*?[\])}]")
_WAYS = [[re.compile(rf"(?<![^\W_]){word}(?![^\W_])", re.IGNORECASE) for word in words] for words in DIRECTIONS]
"""Words for loading and for unloading."""
_FEWEST = 2
"""Columns of a test."""
_EQUAL = 1e-6
"""Difference over range below which columns are the same."""


class Test(NamedTuple):
    """The columns of one test of a table."""

    name: str
    titles: list[str]
    columns: list[int]
    """places in the table"""


def side_by_side(titles: Sequence[str]) -> list[Test]:
    """The tests whose columns stand side by side; one without a name where there is no more than one."""
    for find in (_named, _in_turn, _numbered, _prefixed):
        tests = find(titles)
        names = [set(map(bare, test.titles)) for test in tests]
        if len({test.name for test in tests}) > 1 and all(one == names[0] for one in names):
            return tests
    named = _named(titles)
    return named if len(named) == 1 else [Test("", list(titles), list(range(len(titles))))]


def _grouped(names: Sequence[tuple[str, str]], common: Sequence[tuple[int, str]] = ()) -> list[Test]:
    """Tests from the test and the title of each column; a test "" is no test. common : columns that belong to every test"""
    found: dict[str, Test] = {}
    for place, (test, title) in enumerate(names):
        if test:
            one = found.setdefault(test, Test(test, [title for _, title in common], [place for place, _ in common]))
            one.titles.append(title)
            one.columns.append(place)
    return list(found.values())


def _named(titles: Sequence[str]) -> list[Test]:
    """Tests by titles that name them."""
    for pattern in NAMED_TESTS:
        matches = [pattern.fullmatch(title) for title in titles]
        if all(matches):
            return _grouped([(m["test"], f"{m['name']} {m['unit']}") for m in matches if m])
    return []


def _in_turn(titles: Sequence[str]) -> list[Test]:
    """Tests by titles that repeat in turn."""
    count = len(titles)
    for period in range(_FEWEST, count // 2 + 1):
        if count % period == 0 and list(titles) == count // period * list(titles[:period]):
            return _grouped([(f"test {i // period + 1}", title) for i, title in enumerate(titles)])
    return []


def _numbered(titles: Sequence[str]) -> list[Test]:
    """Tests by a number in each title outside of its unit, as in "Depth 1 [nm]" or "Load (mN).2"; titles without one are common to
    all tests, or those of the first test if the others have the same with a number."""
    split = [_number_of(title) for title in titles]
    plain = [(i, titles[i]) for i, (number, _) in enumerate(split) if not number]
    numbered = {title for number, title in split if number}
    if plain and {title for _, title in plain} == numbered:
        # copies are counted from 1 or from 2
        before = 2 - min(int(number) for number, _ in split if number)
        return _grouped([(f"test {int(number) + before if number else 1}", title) for number, title in split])
    tests = _grouped([(f"test {number}" if number else "", title) for number, title in split], plain)
    return tests if all(sum(map(_has_role, test.titles[len(plain) :])) >= _FEWEST for test in tests) else []


def _has_role(title: str) -> bool:
    return any(is_one_of(name, aliases) for name, _ in parts(title) for _, aliases in ROLES.values())


def _prefixed(titles: Sequence[str]) -> list[Test]:
    """By names with a number before what is measured, as in "A_1 Depth [nm]"."""
    split = []
    for title in titles:
        name = bare(title)
        words = list(_WORD.finditer(name))
        begin = next((word.start() for word in reversed(words) if _has_role(name[word.start() :])), 0)
        test = name[:begin].strip(" _.-:#")
        split.append((test, title[begin:]) if re.search(r"\d", test) else ("", title))
    tests = _grouped(split) if all(test for test, _ in split) else []
    return tests if all(sum(map(_has_role, test.titles)) >= _FEWEST for test in tests) else []


def _number_of(title: str) -> tuple[str, str]:
    """The number of the test in a title, and the title without it."""
    hidden = _BRACKETS.sub(lambda match: len(match[0]) * "\0", title)
    match = next(iter(_NUMBER.finditer(hidden)), None)
    if match is None:
        return "", title
    before, after = title[: match.start()], title[match.end() :]
    before = re.sub(r"[\s_.#:(-]*(?:test|curve|no|nr|run)?[\s_.#:-]*$", "", before, flags=re.IGNORECASE)
    return match[0], (before + (" " if before and after and after[0] not in " _" else "") + after).strip(" _.-:#")


def without_copies(test: Test, values: Array) -> tuple[Test, list[int]]:
    """A test without columns that repeat another of its title and its numbers, and the places of columns that do not."""
    kept: dict[str, int] = {}
    differing = []
    for title, place in zip(test.titles, test.columns, strict=True):
        first = kept.setdefault(title, place)
        if first != place and not _are_equal(values[:, first], values[:, place]):
            differing.append(place)
    return Test(test.name, list(kept), list(kept.values())), differing


def _are_equal(one: Array, other: Array) -> bool:
    both = np.isfinite(one) & np.isfinite(other)
    if not both.any():
        return False
    return bool(np.abs(one - other)[both].max() <= _EQUAL * np.ptp(one[both]))


def in_and_out(titles: Sequence[str]) -> Mapping[int, int]:
    """For each column of loading that of unloading, found by the titles; empty if one has none."""
    for into, out in _WAYS:
        plain = {out.sub("", title): place for place, title in enumerate(titles) if out.search(title)}
        pairs = {i: plain[rest] for i, title in enumerate(titles) if into.search(title) and (rest := into.sub("", title)) in plain}
        if len(pairs) > 1 and all(re.search(r"\w{2}", rest) for rest in plain):
            return pairs
    return {}


def joined(values: Array, pairs: Mapping[int, int]) -> tuple[Array, int]:
    """The rows of the way in, then those of the way out from where the way in ends, and how many the way in has."""
    into, out = (values[:, list(places)] for places in (pairs.keys(), pairs.values()))
    into, out = (half[np.isfinite(half).any(axis=1)] for half in (into, out))
    if len(into) and len(out):
        scale = np.abs(np.nan_to_num(into)).max(axis=0) + np.finfo(float).tiny
        with np.errstate(all="ignore"):
            ends = [float(np.nansum(np.abs(row / scale - into[-1] / scale))) for row in (out[0], out[-1])]
        out = out[::-1] if ends[1] < ends[0] else out
    return np.vstack([into, out]), len(into)
