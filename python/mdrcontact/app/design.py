# SPDX-License-Identifier: GPL-3.0-or-later
"""The tab Design: a problem, and what the commands compute of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import dash_bootstrap_components as dbc
from dash import ALL, Dash, Input, Output, State, ctx, dcc, html, no_update
from dash.exceptions import PreventUpdate

from .. import studies
from ..cli.example import examples
from ..problem import edit, schema
from ..progress import Progress
from . import editor, results
from .form import dom_id
from .results import Answer, answer
from .session import Session

NAME = "design"
_FIRST = "sio2_on_si"
_FILE = "File"


class Shown(NamedTuple):
    """A tab of results: a study, which has the name of its command, with its options."""

    study: Callable[..., Any]
    options: Mapping[str, Any] = {}
    table: str = ""
    """without which the study has nothing to compute"""


STUDIES = {
    "Curves": Shown(studies.curve, {"pressures": True, "references": True}),
    "Models": Shown(studies.compare),
    "Stress": Shown(studies.stress, {"maps": True, "lines": True}),
    "Adhesion": Shown(studies.adhesion, table="adhesion"),
    "Friction": Shown(studies.friction, {"loops": True}, "friction"),
    "Wear": Shown(studies.wear, table="wear"),
    "Time": Shown(studies.history, table="history"),
    "Heat": Shown(studies.conduction, table="conduction"),
}


def computed(session: Session, text: str, tab: str) -> Answer:
    """Return what the study of a tab computes of a text, as its command does."""
    study, options, _ = STUDIES[tab]

    def work(progress: Progress) -> Any:
        return study(session.problem(text), **options, progress=progress)

    return answer(session, _key(text, tab), tab, work)


def _key(text: str, tab: str) -> tuple[str, ...]:
    return NAME, tab, text


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
        old: Any = [] if ctx.triggered_id == f"{NAME}-tab" else no_update
        if found.progress:
            return old, "dimmed", "", None, no_update, False, False, results.progress(found.progress)
        if found.refusal is not None:
            words = results.words_of(found.refusal)
            return old, "dimmed", words, results.place_of(found.refusal), "", True, True, []
        report = results.report(found.result, found.result.figure())
        return (
            [*report, results.files(NAME, f"mdrcontact {STUDIES[tab].study.__name__} problem.toml")],
            "",
            "",
            None,
            f"{tab} computed",
            True,
            True,
            [],
        )

    @dash.callback(
        Output(f"{NAME}-file", "data", allow_duplicate=True),
        Input({"of": NAME, "get": ALL}, "n_clicks"),
        State(NAME, "data"),
        State(f"{NAME}-tab", "value"),
        prevent_initial_call=True,
    )
    def get(clicks: Any, data: Any, tab: str) -> Any:
        """Download a file of the result."""
        found = session.jobs.find(_key(data["text"] if data else first, tab))
        if found is None or not any(clicks):
            raise PreventUpdate
        return results.written(found, found.figure(), ctx.triggered_id["get"])

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
    """The text, and the same work as commands and in Python."""
    own = {"form": NAME, "set": editor.TEXT}
    area = dbc.Textarea(id=own, value=text, debounce=True, spellcheck=False, className="text")
    tables = edit.value(text, (), {})
    used = [one for one in STUDIES.values() if not one.table or one.table in tables]
    lines = [f"mdrcontact {one.study.__name__} problem.toml --plot {one.study.__name__}.png" for one in used]
    python = ["from mdrcontact import problem, studies", "", 'given = problem.load("problem.toml")']
    for study, options, _ in used:
        given = "".join(f", {name}={value}" for name, value in options.items())
        python.append(f"{study.__name__} = studies.{study.__name__}(given{given})")
    return [
        html.Label("problem file", htmlFor=dom_id(own)),
        area,
        html.H2("The same as commands"),
        html.Pre("\n".join(lines)),
        html.H2("The same in Python"),
        html.Pre("\n".join(python)),
    ]
