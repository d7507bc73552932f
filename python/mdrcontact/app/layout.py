# SPDX-License-Identifier: GPL-3.0-or-later
"""The layout of the page: header, alert, and a form next to its results for each tab."""

from __future__ import annotations

from typing import Any

from dash import Dash, Input, Output, html

from .. import __version__
from . import design, measure, results
from .session import Session

_PAGES: dict[str, Any] = {"Design": design, "Measure": measure}


def layout(session: Session) -> Any:
    """Return the whole page."""
    first = "Measure" if measure.begin(session)[1] or measure.is_mine(session.text) else "Design"
    undo = html.Button("Undo", id="undo", title="Ctrl+Z", n_clicks=0, type="button")
    tabs = results.tabs("page", [*_PAGES], first, "pages")
    main = html.Main([html.Section(page.layout(session), id=f"{name}-page") for name, page in _PAGES.items()])
    return html.Div([html.Header([html.H1("mdrcontact"), tabs, undo, html.Small(f"version {__version__}")]), main])


def register(dash: Dash, session: Session) -> None:
    """Register the callbacks: those of the pages, which page is shown, and files by their names alone."""
    shown = [Output(f"{name}-page", "hidden") for name in _PAGES]
    dash.callback(*shown, Input("page", "value"))(lambda chosen: [name != chosen for name in _PAGES])
    for page in _PAGES.values():
        page.register(dash, session)

    def shorten(answer: Any) -> Any:
        if answer.mimetype == "application/json":
            answer.set_data(session.shortened(answer.get_data(as_text=True)))
        return answer

    dash.server.after_request(shorten)
