# SPDX-License-Identifier: GPL-3.0-or-later
"""TOML files as tables; what is no TOML is a `ProblemError`."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

from .named import ContentError, NamedFile, ProblemError, reason_of

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

_LARGEST = 10_000_000
"""Bytes of a problem file."""


def parse_file(path: Path) -> dict[str, Any]:
    """The tables of a file of the user's; the words of an error do not name it, the caller does."""
    try:
        with path.open("rb") as file:
            content = file.read(_LARGEST + 1)  # of a device there is no end
    except (OSError, ValueError) as problem:
        raise ProblemError(f"it cannot be read: {reason_of(problem)}") from problem
    return parse_bytes(content)


def parse_named(file: NamedFile) -> dict[str, Any]:
    """The tables of a file that a problem names, of which no error repeats anything."""
    content = file.content()
    try:
        return parse_bytes(content)
    except ContentError as problem:
        raise ProblemError(f"{file.path}: {problem.without}") from None
    except ProblemError as problem:
        raise ProblemError(f"{file.path}: {problem}") from problem


def parse_bytes(content: bytes) -> dict[str, Any]:
    """The tables of what stands in a file."""
    if len(content) > _LARGEST:
        raise ProblemError(f"it has more than {_LARGEST // 1_000_000} MB: that is no problem file")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        raise ProblemError("it is not a text file in UTF-8: save it as one") from problem
    return parse_text(text.replace("\r\n", "\n").replace("\r", "\n"))


def parse_text(text: str) -> dict[str, Any]:
    """The tables of a text."""
    try:
        return tomllib.loads(text)
    except RecursionError as problem:
        raise ProblemError("it is not a problem file: its brackets are nested too deeply") from problem
    except ValueError as problem:
        # TOMLDecodeError, or Python's own refusal of a whole number with thousands of digits
        place = re.search(r"\(at [^()]*\)$", str(problem))
        words = f"it is not valid TOML: {problem}{_line(text, str(problem))}"
        raise ContentError(words, f"it is not valid TOML{f' {place[0]}' if place else ''}") from problem


def _line(text: str, words: str) -> str:
    """The line that the words of an error point to, and how numbers and quantities are written if it sets one."""
    place = re.search(r"\(at line (\d+), column \d+\)$", words)
    line = text.split("\n")[int(place[1]) - 1].strip() if place else ""
    rule = "; a number has a decimal point, words and quantities stand in straight quotes" if "=" in line else ""
    return f": {line[:80]}{rule}" if line else ""
