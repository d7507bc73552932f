# SPDX-License-Identifier: GPL-3.0-or-later
"""The tab Measure: files of an instrument, and what a fit finds in them."""

from __future__ import annotations

from typing import Any

from dash import Dash, html

from .session import Session


def is_mine(text: str) -> bool:
    return "[data]" in text


def layout(session: Session) -> list[Any]:
    return [html.P("to come")]


def register(dash: Dash, session: Session) -> None:
    pass
