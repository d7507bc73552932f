# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of many curves on the page: their mean, a table from which curves are left out, and the map."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from dash import html

from ..studies.many import FittedCurves
from . import results


def report(run: Mapping[str, Any], found: FittedCurves) -> list[Any]:
    """Return the means, the figure or map, and a row for each curve."""
    parts: list[Any] = [html.H2(found.title), *(html.P(words, className="note") for words in found.notes.values())]
    parts += [results.table(found.tables["spread"])] if "spread" in found.tables else []
    parts += [html.Ul([html.Li(words) for words in found.doubts], className="warnings")] if found.doubts else []
    return [*parts, results.panels(found.figure()), results.table(found.tables["curves"], 3000)]
