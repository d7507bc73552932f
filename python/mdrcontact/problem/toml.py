# SPDX-License-Identifier: GPL-3.0-or-later
"""TOML files as tables; what is no TOML is a `ProblemError`."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

from .section import ProblemError

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


def parse_file(path: Path) -> dict[str, Any]:
    """The tables of a file; the words of an error do not name it, the caller does."""
    text = ""
    try:
        text = path.read_text(encoding="utf-8-sig")
        return tomllib.loads(text)
    except OSError as problem:
        raise ProblemError(f"it cannot be read: {problem.strerror or problem}") from problem
    except UnicodeDecodeError as problem:
        raise ProblemError("it is not a text file in UTF-8: save it as one") from problem
    except RecursionError as problem:
        raise ProblemError("it is not a problem file: its brackets are nested too deeply") from problem
    except ValueError as problem:
        # TOMLDecodeError, or Python's own refusal of a whole number with thousands of digits
        raise ProblemError(f"it is not valid TOML: {problem}{_line(text, str(problem))}") from problem


def _line(text: str, words: str) -> str:
    """The line that the words of an error point to, and how numbers and quantities are written if it sets one."""
    place = re.search(r"\(at line (\d+), column \d+\)$", words)
    line = text.split("\n")[int(place[1]) - 1].strip() if place else ""
    rule = "; a number has a decimal point, words and quantities stand in straight quotes" if "=" in line else ""
    return f": {line[:80]}{rule}" if line else ""
