# SPDX-License-Identifier: GPL-3.0-or-later
"""The one place where the files that a problem names are found and opened.

A problem file on the command line names any regular file, as its user may. A problem that is given as text comes from elsewhere: it
opens what is given with it, by name, and nothing else. No error repeats what stands in a file that a problem names.
"""

from __future__ import annotations

import os
import stat
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple

from ..errors import ArgumentTypeError, InvalidArgumentError

LARGEST_FILE = 200_000_000
"""Bytes that are read of a file at most."""
IRREGULAR = "not a file: name a regular file"
_NO_WAIT = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)

Given = Mapping[str, "bytes | str | os.PathLike[str]"] | Iterable["str | os.PathLike[str]"]
"""Files that come with a problem: by name their content or their place; or places, whose names are those of the files."""


class ProblemError(InvalidArgumentError):
    """A problem file is wrong; the words say where and what is expected."""


class ContentError(ProblemError):
    """The same in words that repeat what stands in the file, for one that the user names; `without` are words for others."""

    def __init__(self, words: str, without: str) -> None:
        super().__init__(words)
        self.without = without

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (str(self), self.without)


class NamedFile(NamedTuple):
    """A file that a problem names."""

    path: Path
    """by which it is called in errors"""
    place: Path | None
    """where it lies"""
    given: bytes = b""
    """what stands in it, if it does not lie anywhere"""

    def content(self) -> bytes:
        """What stands in it; a ProblemError names the file."""
        if self.place is None:
            return self.given
        try:
            with self.open() as file:
                content = file.read(LARGEST_FILE + 1)
        except (OSError, ValueError) as problem:
            raise ProblemError(f"{self.path}: it cannot be read: {reason_of(problem)}") from None
        if len(content) > LARGEST_FILE:
            raise ProblemError(f"{self.path}: it has more than {LARGEST_FILE // 1_000_000} MB: name a smaller file")
        return content

    def open(self) -> BinaryIO:
        """The file, open for reading; OSError where it is none. Devices are not touched, pipes not waited for."""
        assert self.place is not None
        _check_regular(self.place.stat().st_mode)
        number = os.open(self.place, os.O_RDONLY | _NO_WAIT)
        try:
            # what it was a moment ago is no promise
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
    """Why a file cannot be opened, without its name."""
    if isinstance(problem, OSError):
        return problem.strerror or type(problem).__name__
    return str(problem)


class Files(ABC):
    """The files that a problem may name."""

    @abstractmethod
    def find(self, where: str, name: str) -> NamedFile:
        """The file of a name. where : the key that names it, for errors"""


class Folder(Files):
    """Any file; relative names begin at the folder of the problem file."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def find(self, where: str, name: str) -> NamedFile:
        place = self._folder / name
        return NamedFile(place, place)


def _content_or_place(name: str, given: Any) -> bytes | Path:
    """What stands in a file that is given, or where it lies."""
    if isinstance(given, (bytes, bytearray, memoryview)):
        return bytes(given)
    if isinstance(given, (str, os.PathLike)):
        return Path(given)
    raise ArgumentTypeError(f"files: {name!r} is given as {type(given).__name__}: it must be bytes, or the path of a file")


class GivenFiles(Files):
    """Those that come with the problem, and no other."""

    def __init__(self, given: Given = ()) -> None:
        if isinstance(given, Mapping):
            pairs = [(str(name), value) for name, value in given.items()]
        elif isinstance(given, (str, bytes)):
            raise InvalidArgumentError(f"files = {given!r} is not allowed: it must be a list of paths, or a dict of names")
        else:
            pairs = [(Path(path).name, path) for path in given]
        self._files = {name: _content_or_place(name, value) for name, value in pairs}
        if len(self._files) < len(pairs):
            twice = next(name for name in self._files if [name for name, _ in pairs].count(name) > 1)
            raise InvalidArgumentError(f"files: two are called {twice!r}: give a dict with a name for each")

    def find(self, where: str, name: str) -> NamedFile:
        if name not in self._files:
            those = f"the files given: {', '.join(self._files)}" if self._files else "the files given, which are none"
            raise ProblemError(f"{where} = {name!r} is not allowed: it is not among {those}")
        found = self._files[name]
        return NamedFile(Path(name), None, found) if isinstance(found, bytes) else NamedFile(Path(name), found)
