# SPDX-License-Identifier: GPL-3.0-or-later
"""The layout of the page: header, alert, and a form beside its results for each tab."""

from __future__ import annotations

from typing import Any

from dash import Dash, Input, Output, html

from .. import __version__
from . import design, measure, results
from .session import Session

_PAGES = {"Design": design, "Measure": measure}


def layout(session: Session) -> Any:
    """Return the whole page."""
    first = "Measure" if measure.begin(session)[1] or measure.is_mine(session.text) else "Design"
    undo = html.Button("Undo", id="undo", title="Alt+Z", accessKey="z", n_clicks=0, type="button")
    return html.Div(
        [
            html.Header(
                [html.H1("mdrcontact"), results.tabs("page", [*_PAGES], first, "pages"), undo, html.Small(f"version {__version__}")]
            ),
            html.Main([html.Section(page.layout(session), id=f"{name}-page") for name, page in _PAGES.items()]),
        ]
    )


class _Page:
    """What belongs to no tab."""

    @staticmethod
    def register(dash: Dash, session: Session) -> None:
        """Show the page that is chosen, and files by their names alone."""
        shown = [Output(f"{name}-page", "hidden") for name in _PAGES]
        dash.callback(*shown, Input("page", "value"))(lambda chosen: [name != chosen for name in _PAGES])

        def shorten(answer: Any) -> Any:
            if answer.mimetype == "application/json":
                answer.set_data(session.shortened(answer.get_data(as_text=True)))
            return answer

        dash.server.after_request(shorten)


TABS: tuple[Any, ...] = (_Page, design, measure)
