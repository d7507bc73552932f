# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong names are answered with the nearest right one."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from typing import Any

from .errors import InvalidArgumentError


def nearest(wrong: str, right: Iterable[str]) -> str:
    """Words to append to an error message: the nearest right name, or all of them where none is near."""
    by_lower = {name.lower(): name for name in right}
    if not by_lower:
        return "there is none to choose from"
    close = difflib.get_close_matches(wrong.lower(), by_lower, n=1, cutoff=0.5)
    if close:
        return f"did you mean {by_lower[close[0]]!r}?"
    return "choose from " + ", ".join(repr(name) for name in by_lower.values())


def suggestion(wrong: str, right: Iterable[str]) -> str:
    """Return the same as a sentence."""
    words = nearest(wrong, right)
    return f"{words[0].upper()}{words[1:]}" + "." * (not words.endswith("?"))


def code(name: str, value: Any, codes: dict[str, int], *allowed: str) -> int:
    """The code of a word; wrong words are answered with the nearest right one."""
    known = allowed or tuple(codes)
    if not isinstance(value, str) or value not in known:
        raise InvalidArgumentError(f"{name} = {value!r} is not allowed: {nearest(str(value), known)}")
    return codes[value]
