# SPDX-License-Identifier: GPL-3.0-or-later
"""Read TOML files as tables; a `ProblemError` reports what is not valid TOML."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from .named import ContentError, NamedFile, ProblemError, reason_of

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

_BARE = re.compile(r"[A-Za-z0-9_-]+")
_LARGEST = 10_000_000
"""Largest size of a problem file [bytes]."""


def parse_file(path: Path) -> dict[str, Any]:
    """Return the tables of a file of the user. The message of an error does not contain its name."""
    return parse_text(text_of(path))


def text_of(path: Path) -> str:
    """Return the text of a file of the user."""
    try:
        with path.open("rb") as file:
            content = file.read(_LARGEST + 1)  # a device has no end
    except (OSError, ValueError) as problem:
        raise ProblemError(f"it cannot be read: {reason_of(problem)}") from problem
    return _text(content)


def parse_named(file: NamedFile) -> dict[str, Any]:
    """Return the tables of a file that a problem names. No error repeats its contents."""
    content = file.content()
    try:
        return parse_text(_text(content))
    except ContentError as problem:
        raise ProblemError(problem.without, file=str(file.path)) from None
    except ProblemError as problem:
        raise problem.within(file.path) from problem


def _check_size(text: str | bytes) -> None:
    if len(text) > _LARGEST:
        raise ProblemError(f"it has more than {_LARGEST // 1_000_000} MB, too large for a problem file. Name another file.")


def _text(content: bytes) -> str:
    _check_size(content)
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError as problem:
        raise ProblemError("it is not a text file in UTF-8. Save it in UTF-8.") from problem


def parse_text(text: str) -> dict[str, Any]:
    """Return the tables of a text, which may begin with a byte order mark and have ends of lines of any system."""
    _check_size(text)
    text = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
    try:
        return tomllib.loads(text)
    except RecursionError as problem:
        raise ProblemError("its brackets are nested too deeply. Write a problem file without such brackets.") from problem
    except ValueError as problem:
        # TOMLDecodeError, or the error of Python for an integer with thousands of digits
        place = re.search(r"\(at [^()]*\)$", str(problem))
        words = f"it is not valid TOML: {problem}{_line(text, str(problem))}"
        raise ContentError(words, f"it is not valid TOML{f' {place[0]}' if place else ''}") from problem


def _line(text: str, words: str) -> str:
    """Return the line of an error, and how to write numbers and quantities if the line sets a value."""
    place = re.search(r"\(at line (\d+), column \d+\)$", words)
    line = text.split("\n")[int(place[1]) - 1].strip() if place else ""
    rule = ". Write numbers with a decimal point, words and quantities in straight quotes." if "=" in line else ""
    return f": {line[:80]}{rule}" if line else ""


def written(value: object) -> str:
    """Return a value as a file has it. Numbers keep their digits, tables are on one line."""
    if isinstance(value, Mapping):
        return "{ " + ", ".join(keyed(str(key), one) for key, one in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(written, value)) + "]"
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def keyed(key: str, value: object) -> str:
    """Return the line of a key."""
    return f"{quoted(key)} = {written(value)}"


def quoted(key: str) -> str:
    """Return a key, in quotes if it needs them."""
    return key if _BARE.fullmatch(key) else written(key)
