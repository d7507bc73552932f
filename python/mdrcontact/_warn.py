# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings: results carry them as values, and the user reads each once, at the line that called into this package.

Who listens belongs to a context (`contextvars`), which threads do not share: `warnings.catch_warnings` changes the filters of the
whole process, and one thread then takes, or loses, the warnings of another.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any, NamedTuple, TypeVar

_PACKAGE = __name__.partition(".")[0]

Channel = Callable[[str, type[Warning]], Any]
"""Takes the text and the class of a warning that the user is to read."""
Self = TypeVar("Self", bound="Warned")


class Caution(NamedTuple):
    """One warning as a value."""

    text: str
    kind: type[Warning]


class Warned:
    """Base of results with warnings. It follows a named tuple among the bases: numbers unpack as usual, and `warnings` is an
    attribute."""

    warnings: tuple[str, ...] = ()
    """warnings about these numbers; empty if there are none"""

    def _carrying(self: Self, found: Iterable[Caution]) -> Self:
        """Itself, which has just been made, with its warnings."""
        texts = texts_of(found)
        if texts:
            self.warnings = texts
        return self


_COLLECTOR: ContextVar[list[Caution] | None] = ContextVar("mdrcontact_collector", default=None)
"""of the computation inside which the present one runs; None: the user runs it"""
_CHANNEL: ContextVar[Channel | None] = ContextVar("mdrcontact_channel", default=None)
"""where the user reads; None: Python's `warnings`"""


class _Silence(list[Caution]):
    """A collector that keeps nothing, so that no search is needed."""

    def append(self, _caution: Caution) -> None:
        """Forgets it."""


def warn(text: str, kind: type[Warning]) -> None:
    """Report a warning to the collecting computation, or to the user at the line outside this package."""
    collector, channel = _COLLECTOR.get(), _CHANNEL.get()
    if collector is not None:
        collector.append(Caution(text, kind))
        return
    if channel is not None:
        channel(text, kind)
        return
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] == _PACKAGE:
        level, frame = level + 1, frame.f_back
    warnings.warn(text, kind, stacklevel=level)


def warn_all(cautions: Iterable[Caution]) -> None:
    """Warns of each."""
    for caution in cautions:
        warn(*caution)


def is_silent() -> bool:
    """Return whether warnings are dropped."""
    return isinstance(_COLLECTOR.get(), _Silence)


def is_collected() -> bool:
    """Return whether a computation collects warnings, which it takes of each result, also repeated ones."""
    return _COLLECTOR.get() is not None


def texts_of(cautions: Iterable[Caution]) -> tuple[str, ...]:
    """The sentences, each once."""
    return tuple(dict.fromkeys(caution.text for caution in cautions))


@contextmanager
def collected() -> Iterator[list[Caution]]:
    """Collect the warnings of the block in this thread as a list, hidden from the user."""
    found: list[Caution] = []
    with _kept_by(found):
        yield found


@contextmanager
def kept() -> Iterator[list[Caution]]:
    """Collect the warnings of the block in this thread as a list, which `warn_all` reports afterwards."""
    found: list[Caution] = []
    with _kept_by(found) if is_collected() else reported_to(lambda text, kind: found.append(Caution(text, kind))):
        yield found


@contextmanager
def silence() -> Iterator[None]:
    """Trial evaluations, and contacts in units of their own that no user sees: warnings are dropped. Also a decorator."""
    with _kept_by(_Silence()):
        yield


@contextmanager
def _kept_by(collector: list[Caution]) -> Iterator[None]:
    before = _COLLECTOR.set(collector)
    try:
        yield
    finally:
        _COLLECTOR.reset(before)


@contextmanager
def reported_to(channel: Channel) -> Iterator[None]:
    """Report to the user by `channel` instead of Python's `warnings`."""
    before = _CHANNEL.set(channel)
    try:
        yield
    finally:
        _CHANNEL.reset(before)


def heir() -> Callable[[], None]:
    """A function that lets another thread, which begins with a context of its own, warn whom the present one warns."""
    collector, channel = _COLLECTOR.get(), _CHANNEL.get()

    def inherit() -> None:
        _COLLECTOR.set(collector)
        _CHANNEL.set(channel)

    return inherit
