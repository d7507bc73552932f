# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings of many curves, one line for each cause."""

from __future__ import annotations

import re
from collections.abc import Iterable

_NUMBER = re.compile(
    r"[-+]?\b\d[\d.]*(?:e[-+]?\d+)?(?: ±)?(?: ?(?:%|[numkMGTpµ]?(?:m|N|Pa|s|Hz)(?:/[numkMµ]?(?:m|N|s))?\b))?", re.IGNORECASE
)


def by_cause(warned: Iterable[tuple[str, str]]) -> list[str]:
    """(curve, words) as one line for each cause, the most frequent first: how many curves have it, and the text of the first."""
    groups: dict[str, list[tuple[str, str]]] = {}
    for curve, words in warned:
        groups.setdefault(_NUMBER.sub("#", words), []).append((curve, words))
    lines = []
    for group in sorted(groups.values(), key=len, reverse=True):
        curves = dict.fromkeys(curve for curve, _ in group)
        first, words = group[0]
        lines.append(f"{first}: {words}" if len(curves) == 1 else f"{len(curves)} curves, as {first}: {words}")
    return lines
