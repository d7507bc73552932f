# SPDX-License-Identifier: GPL-3.0-or-later
"""The tab Design: a problem, and what the commands compute of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import dash_bootstrap_components as dbc
from dash import Dash, Input, Output, State, ctx, dcc, html, no_update
from dash.exceptions import PreventUpdate

from .. import studies
from ..cli.example import examples
from ..problem import schema
from ..progress import Progress
from . import editor, results
from .results import Answer, answer
from .session import Session

NAME = "design"
_FIRST = "sio2_on_si"
_FILE = "File"


class Shown(NamedTuple):
    """A tab of results: a study with its options."""

    study: Callable[..., Any]
    options: Mapping[str, Any] = {}


STUDIES = {
    "Curves": Shown(studies.curve, {"pressures": True, "references": True}),
    "Models": Shown(studies.compare),
    "Stress": Shown(studies.stress, {"maps": True, "lines": True}),
    "Adhesion": Shown(studies.adhesion),
    "Friction": Shown(studies.friction, {"loops": True}),
    "Wear": Shown(studies.wear),
    "Time": Shown(studies.history),
    "Heat": Shown(studies.conduction),
}


def computed(session: Session, text: str, tab: str) -> Answer:
    """Return what the study of a tab computes of a text, as its command does."""
    study, options = STUDIES[tab]

    def work(progress: Progress) -> Any:
        return study(session.problem(text), **options, progress=progress)

    return answer(session, (tab, text), tab, work)


def first_text(session: Session) -> str:
    """Return the text that the page begins with."""
    return session.text or examples()[_FIRST]


def layout(session: Session) -> list[Any]:
    """Return the form and the results."""
    from .layout import tabs

    choose = dbc.Select(id=f"{NAME}-example", options={"": "choose one", **{name: name for name in examples()}}, value="")
    example = html.Div([html.Label("example", htmlFor=f"{NAME}-example"), choose], className="row")
    left = html.Form(
        [editor.head(NAME, "Open"), example, html.Div(id=f"{NAME}-form")], className="form", **{"aria-label": "problem"}
    )
    return [
        *editor.stores(NAME),
        dcc.Interval(id=f"{NAME}-again", interval=300, disabled=True),
        left,
        html.Div(
            [
                html.Div(id=f"{NAME}-alert", role="alert", className="alert"),
                tabs(f"{NAME}-tab", [*STUDIES, _FILE], "Curves", "results"),
                html.Div(
                    [html.Div(id=f"{NAME}-progress"), html.Button("Cancel", id=f"{NAME}-cancel", n_clicks=0, type="button")],
                    id=f"{NAME}-busy",
                    hidden=True,
                    className="busy",
                ),
                html.Div(id=f"{NAME}-said", role="status", className="unseen"),
                html.Div(id=f"{NAME}-results"),
            ],
            className="results",
        ),
    ]


def register(dash: Dash, session: Session) -> None:
    """Register the callbacks."""
    first = first_text(session)
    editor.register(dash, session, NAME, schema.PROBLEM, first)

    @dash.callback(
        Output(f"{NAME}-results", "children"),
        Output(f"{NAME}-results", "className"),
        Output(f"{NAME}-alert", "children"),
        Output(f"{NAME}-where", "data"),
        Output(f"{NAME}-said", "children"),
        Output(f"{NAME}-again", "disabled"),
        Output(f"{NAME}-busy", "hidden"),
        Output(f"{NAME}-progress", "children"),
        Input(NAME, "data"),
        Input(f"{NAME}-tab", "value"),
        Input(f"{NAME}-again", "n_intervals"),
        Input(f"{NAME}-cancel", "n_clicks"),
        State("page", "value"),
    )
    def compute(data: Any, tab: str, _ticks: Any, _cancel: Any, _page: str) -> Any:
        """Show the results of the text; old ones stay, dimmed, if it is refused."""
        text = data["text"] if data else first
        if ctx.triggered_id == f"{NAME}-cancel":
            session.jobs.cancel()
        if tab == _FILE:
            return _file(text), "", "", None, "", True, True, []
        found = computed(session, text, tab)
        if found.progress:
            return no_update, "dimmed", "", None, no_update, False, False, results.progress(found.progress)
        if found.refusal is not None:
            words = results.words_of(found.refusal)
            old = [] if ctx.triggered_id == f"{NAME}-tab" else no_update
            return old, "dimmed", words, results.place_of(found.refusal), "", True, True, []
        report = results.report(found.result, found.result.figure())
        return report, "", "", None, f"{tab} computed", True, True, []

    @dash.callback(
        Output(NAME, "data", allow_duplicate=True),
        Output(f"{NAME}-example", "value"),
        Input(f"{NAME}-example", "value"),
        State(NAME, "data"),
        prevent_initial_call=True,
    )
    def choose(name: str, data: Any) -> Any:
        """Begin with an example."""
        if not name:
            raise PreventUpdate
        return editor.with_text(data, examples()[name]), ""


def _file(text: str) -> list[Any]:
    area = dbc.Textarea(id={"form": NAME, "set": editor.TEXT}, value=text, debounce=True, spellCheck=False, className="text")
    return [html.Label("problem file", htmlFor="x"), area]
