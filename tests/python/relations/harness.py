# SPDX-License-Identifier: GPL-3.0-or-later
"""A relation: a check, what it draws, how often, and how far from its tolerance it came."""

from __future__ import annotations

import functools
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import hypothesis
import numpy as np
from conftest import numbers_of
from hypothesis import HealthCheck, Phase, given, settings

import mdrcontact as mdr

SHORTEST_SENTENCE = 25
"""Characters of a refusal that names argument, value and what is allowed."""


@dataclass
class Tally:
    """What came of the draws of a relation."""

    draws: int = 0
    refusals: int = 0
    worst: float = 0.0
    """largest deviation over its tolerance"""


_tally = Tally()


def numbers_in(value: Any) -> Any:
    """The numbers of a state or of several, a row for each member; any other value as an array."""
    return np.asarray(numbers_of(value) if isinstance(value, mdr.State) else value)


def near(found: Any, expected: Any, tolerance: float, size: Any = None, what: str = "") -> None:
    """|found - expected| <= tolerance |size| everywhere; size: of the expected numbers themselves, or the one given. Equal
    infinities are near, NaN is not."""
    found, expected = np.broadcast_arrays(numbers_in(found), numbers_in(expected))
    room = tolerance * np.broadcast_to(np.abs(expected if size is None else size), found.shape)
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        distance = np.where(found == expected, 0.0, np.abs(found - expected) / room)
    distance = np.where(np.isnan(distance), np.inf, distance)
    worst = float(distance.max(initial=0.0))
    _tally.worst = max(_tally.worst, worst)
    if worst > 1.0:
        place = np.unravel_index(int(np.argmax(distance)), distance.shape)
        raise AssertionError(
            f"{what or 'found'}: {found[place]!r}, expected {expected[place]!r}: {worst:.3g} times the tolerance {tolerance:g}"
            + (f" of {np.broadcast_to(np.abs(size), found.shape)[place]!r}" if size is not None else "")
        )


def same(found: Any, expected: Any) -> None:
    """The same bits."""
    np.testing.assert_array_equal(numbers_in(found), numbers_in(expected), strict=True)


def grows(values: Any, what: str = "values") -> None:
    """Each number is larger than the one before."""
    assert np.all(np.diff(values) > 0.0), (what, values)


@dataclass(frozen=True)
class Relation:
    """A check over arguments drawn by Hypothesis. A draw that the library refuses with a sentence counts as a refusal where the
    inputs are extreme: `may_refuse` is the largest share of them; 0: no draw may be refused."""

    check: Callable[..., None]
    draws: int
    may_refuse: float
    strategies: dict[str, Any]

    @property
    def name(self) -> str:
        """Capability and relation."""
        capability = self.check.__module__.rpartition(".")[2].removeprefix("test_")
        return f"{capability}: {self.check.__name__.removeprefix('test_').replace('_', ' ')}"

    def run(self, draws: int, seed: int | None = None, shrink: bool = False) -> Tally:
        """So many draws, the same each time or those of a seed. An assertion, or any other exception, is a finding; shrink: make
        its example as simple as possible, which takes a while."""
        global _tally
        _tally = tally = Tally()
        chosen = settings(max_examples=draws, derandomize=seed is None, database=None, deadline=None, print_blob=False,
                          phases=[Phase.generate, *([Phase.shrink] if shrink else [])], report_multiple_bugs=False,
                          suppress_health_check=list(HealthCheck))  # fmt: skip
        test = chosen(given(**self.strategies)(self._counted(tally)))
        try:
            (test if seed is None else hypothesis.seed(seed)(test))()
        except BaseException as problem:
            problem.tally = tally  # type: ignore[attr-defined]
            raise
        return tally

    def _counted(self, tally: Tally) -> Callable[..., None]:
        @functools.wraps(self.check)
        def one(*arguments: Any, **named: Any) -> None:
            tally.draws += 1
            try:
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    _own_warnings_are_words()
                    self.check(*arguments, **named)
            except mdr.MDRError as refusal:
                if not self.may_refuse or len(str(refusal)) < SHORTEST_SENTENCE:
                    raise
                tally.refusals += 1

        return one


def _own_warnings_are_words() -> None:
    """What the library warns of holds all the same."""
    for name in mdr.errors.__all__:
        if name.endswith("Warning"):
            warnings.simplefilter("ignore", getattr(mdr.errors, name))


def relation(draws: int, may_refuse: float = 0.0, **strategies: Any) -> Callable[[Callable[..., None]], Callable[[], None]]:
    """Makes the test of a relation: `draws` in every run of the tests. The first line of its docstring says by which second way
    the numbers are found."""

    def make(check: Callable[..., None]) -> Callable[[], None]:
        known = Relation(check, draws, may_refuse, strategies)

        def test() -> None:
            tally = known.run(known.draws)
            assert tally.refusals <= known.may_refuse * tally.draws, f"{tally.refusals} of {tally.draws} draws are refused"

        test.__name__, test.__doc__, test.__module__ = check.__name__, check.__doc__, check.__module__
        test.relation = known  # type: ignore[attr-defined]
        return test

    return make
