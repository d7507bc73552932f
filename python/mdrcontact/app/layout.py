# SPDX-License-Identifier: GPL-3.0-or-later
"""The layout of the page."""

from __future__ import annotations

from typing import Any

from dash import html

from .session import Session

TABS: tuple[Any, ...] = ()


def layout(_session: Session) -> Any:
    """Return the whole page."""
    return html.Main(html.H1("mdrcontact"))
