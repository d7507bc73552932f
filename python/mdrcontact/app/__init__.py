# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of `mdrcontact app`, with Dash and Plotly. It shows what the commands compute for the same text."""

from __future__ import annotations

from dash import Dash

from . import layout, server
from .session import Session

__all__ = ["Session", "make_app"]


def make_app(session: Session) -> Dash:
    """Return the page of a session. Its server is `dash.server`, a Flask application."""
    dash = server.make_dash()
    dash.layout = lambda: layout.layout(session)
    layout.register(dash, session)
    server.guard(dash, session)
    return dash
