# SPDX-License-Identifier: GPL-3.0-or-later
"""Find and open the files that a problem names.

A problem file on the command line may name any regular file. A problem that is given as text opens only files that are given with
it, by name. No error repeats the contents of a file that a problem names.
"""

from __future__ import annotations

import copy
import os
import re
import stat
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple

from ..errors import ArgumentTypeError, InvalidArgumentError

LARGEST_FILE = 200_000_000
"""Largest size of a file [bytes]."""
IRREGULAR = "not a file. Name a regular file"
_LONGEST = 300
"""Longest text of a value in an error."""
_STEP = re.compile(r'"[^"]*"|[^."]+')
"""A step of the name of a table."""
_NUMBERED = re.compile(r" \d+$")
_NO_WAIT = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)

Given = Mapping[str, "bytes | str | os.PathLike[str]"] | Iterable["str | os.PathLike[str]"]
"""Files that come with a problem: contents or paths by name, or paths, which have the names of their files."""


class ProblemError(InvalidArgumentError):
    """Raised for an error in a problem file. The message has the attributes: the place, the value, the rule and the remedy."""

    def __init__(
        self, rule: str, remedy: str = "", *, table: str = "", key: str = "", entry: int = 0, value: Any = None, file: str = ""
    ) -> None:
        self.rule, self.remedy = rule, remedy
        self.table, self.key, self.entry = table, key, entry
        """as in "medium.layer 2" and "E"; number of the entry of a list, from 1; empty or 0: the error has none"""
        self.value = value
        """as the file has it; None: the key is absent"""
        self.file = file
        what = f"{key} = {_short(value)}: " if key and value is not None else ""
        entry_of = f"entry {entry} of " if entry and what else ""
        sentences = f"{_ended(rule)} {_ended(remedy)}" if remedy else rule if not what else _ended(rule)
        super().__init__("".join([f"{file}: " if file else "", f"[{table}]: " if table else "", entry_of, what, sentences]))

    def within(self, file: object) -> ProblemError:
        """Return the error with the name of its file."""
        found = copy.copy(self)
        found.file = str(file)
        found.args = (f"{file}: {self}",)
        return found

    @property
    def advice(self) -> str:
        """Return rule and remedy as sentences, for a place that shows key and value itself."""
        return " ".join(_ended(one[:1].upper() + one[1:]) for one in (self.rule, self.remedy) if one)

    def at(self, table: str, key: str) -> ProblemError:
        """Give the error its place, and return it; the message stays."""
        self.table, self.key = table, key
        return self

    @property
    def path(self) -> tuple[str | int, ...]:
        """Return the path of its value for `mdrcontact.problem.edit`: ("medium", "layer", 1, "E")."""
        steps: list[str | int] = [*([self.key] if self.key else []), *([self.entry - 1] if self.entry else [])]
        above = self.table
        while above:
            above, name, number = last_of(above)
            steps = [name, *([number - 1] if number else []), *steps]
        return tuple(steps)


class ContentError(ProblemError):
    """Raised with a message that repeats contents of a file of the user; `without` is the message for other files."""

    def __init__(self, words: str, without: str = "") -> None:
        super().__init__(words)
        self.without = without


def last_of(table: str) -> tuple[str, str, int]:
    """Return the name of the table around a table, its own name, and its number among its like or 0."""
    last = _STEP.findall(table)[-1]
    name, _, number = (last, "", "") if last.startswith('"') or not _NUMBERED.search(last) else last.rpartition(" ")
    return table.removesuffix(last).removesuffix("."), name.strip('"'), int(number or 0)


def _ended(sentence: str) -> str:
    return sentence if sentence.endswith((".", "?")) else f"{sentence}."


def _short(value: Any) -> str:
    """Return a value as the file has it, cut if it is long."""
    try:
        words = repr(value)
    except ValueError:  # an integer of thousands of digits
        return "a number of thousands of digits"
    return words if len(words) <= _LONGEST else f"{words[:_LONGEST]}..."


class NamedFile(NamedTuple):
    """A file that a problem names."""

    path: Path
    """its name in errors"""
    place: Path | None
    """its path; None: it is not on the disk"""
    given: bytes = b""
    """its contents, if it is not on the disk"""

    def content(self) -> bytes:
        """Return its contents; a ProblemError names the file."""
        if self.place is None:
            return self.given
        try:
            with self.open() as file:
                content = file.read(LARGEST_FILE + 1)
        except (OSError, ValueError) as problem:
            raise ProblemError(f"{self.path}: it cannot be read: {reason_of(problem)}") from None
        if len(content) > LARGEST_FILE:
            raise ProblemError(f"{self.path}: it has more than {LARGEST_FILE // 1_000_000} MB. Name a smaller file.")
        return content

    def open(self) -> BinaryIO:
        """Open the file for reading; OSError if it does not exist. Devices and pipes are not opened."""
        assert self.place is not None
        _check_regular(self.place.stat().st_mode)
        number = os.open(self.place, os.O_RDONLY | _NO_WAIT)
        try:
            # it may have changed since the first check
            _check_regular(os.fstat(number).st_mode)
            return os.fdopen(number, "rb")
        except BaseException:
            os.close(number)
            raise


def _check_regular(mode: int) -> None:
    if not stat.S_ISREG(mode):
        kind = "a folder" if stat.S_ISDIR(mode) else "a pipe, a socket or a device"
        raise ValueError(f"it is {kind}, {IRREGULAR}")


def reason_of(problem: Exception) -> str:
    """Return the reason why a file cannot be opened, without its name."""
    if isinstance(problem, OSError):
        return problem.strerror or type(problem).__name__
    return str(problem)


class Files(ABC):
    """The files that a problem may name."""

    @abstractmethod
    def find(self, name: str) -> NamedFile:
        """Return the file of a name."""


class Folder(Files):
    """Any file; names are relative to the folder of the problem file."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def find(self, name: str) -> NamedFile:
        place = self._folder / name
        return NamedFile(place, place)


def _content_or_place(name: str, given: Any) -> bytes | Path:
    """Return the contents of a file, or its path."""
    if isinstance(given, (bytes, bytearray, memoryview)):
        return bytes(given)
    if isinstance(given, (str, os.PathLike)):
        return Path(given)
    raise ArgumentTypeError(f"files[{name!r}] = {given!r}: it must be bytes, or the path of a file.")


class GivenFiles(Files):
    """Only the files that come with the problem."""

    def __init__(self, given: Given = ()) -> None:
        if isinstance(given, Mapping):
            pairs = [(str(name), value) for name, value in given.items()]
        elif isinstance(given, (str, bytes)):
            raise InvalidArgumentError(f"files = {given!r}: it must be a list of paths, or a dict of names.")
        else:
            pairs = [(Path(path).name, path) for path in given]
        self._files = {name: _content_or_place(name, value) for name, value in pairs}
        if len(self._files) < len(pairs):
            twice = next(name for name in self._files if [name for name, _ in pairs].count(name) > 1)
            raise InvalidArgumentError(f"files: two have the name {twice!r}. Give a dict with a name for each.")

    def find(self, name: str) -> NamedFile:
        if name not in self._files:
            those = f"the given files: {', '.join(self._files)}" if self._files else "the given files. There are none"
            raise ProblemError(f"it is not among {those}.")
        found = self._files[name]
        return NamedFile(Path(name), None, found) if isinstance(found, bytes) else NamedFile(Path(name), found)
