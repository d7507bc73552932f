# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrong names are answered with the nearest right one."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


def nearest(wrong: str, right: Iterable[str]) -> str:
    """Words to append to an error message: the nearest right name, or all of them where none is near."""
    by_lower = {name.lower(): name for name in right}
    if not by_lower:
        return "there is none to choose from"
    close = difflib.get_close_matches(wrong.lower(), by_lower, n=1, cutoff=0.5)
    if close:
        return f"did you mean {by_lower[close[0]]!r}?"
    return "choose from " + ", ".join(repr(name) for name in by_lower.values())
