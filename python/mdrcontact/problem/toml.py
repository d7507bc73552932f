# SPDX-License-Identifier: GPL-3.0-or-later
"""TOML files as tables; what is no TOML is a `ProblemError`."""

from __future__ import annotations

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
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as problem:
        raise ProblemError(f"it cannot be read: {problem.strerror or problem}") from problem
    except UnicodeDecodeError as problem:
        raise ProblemError("it is not a text file in UTF-8") from problem
    except RecursionError as problem:
        raise ProblemError("it is not a problem file: its brackets are nested too deeply") from problem
    except ValueError as problem:
        # TOMLDecodeError, or Python's own refusal of a whole number with thousands of digits
        raise ProblemError(f"it is not valid TOML: {problem}") from problem
