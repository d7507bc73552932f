# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `mdrcontact app`, with Dash and Plotly. It shows what the commands compute for the same text."""

from __future__ import annotations

from typing import Any

from dash import Dash, Input, Output, html

from .. import __version__
from . import design, measure, results, server
from .session import Session

__all__ = ["Session", "make_app"]

_PAGES: dict[str, Any] = {"Design": design, "Measure": measure}


def make_app(session: Session) -> Dash:
    """Return the page of a session. Its server is `dash.server`, a Flask application."""
    dash = server.make_dash()
    dash.layout = lambda: _layout(session)
    shown = [Output(f"{name}-page", "hidden") for name in _PAGES]
    dash.callback(*shown, Input("page", "value"))(lambda chosen: [name != chosen for name in _PAGES])
    for page in _PAGES.values():
        page.register(dash, session)
    server.guard(dash, session)
    return dash


def _layout(session: Session) -> Any:
    """The whole page: its header, and for each tab a form next to its results."""
    first = "Measure" if measure.begin(session)[0] else "Design"
    undo = html.Button("Undo", id="undo", title="Ctrl+Z", n_clicks=0, type="button")
    tabs = results.tabs("page", [*_PAGES], first, "pages")
    main = html.Main([html.Section(page.layout(session), id=f"{name}-page") for name, page in _PAGES.items()])
    return html.Div([html.Header([html.H1("mdrcontact"), tabs, undo, html.Small(f"version {__version__}")]), main])
