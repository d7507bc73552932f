# SPDX-License-Identifier: GPL-3.0-or-later
"""The tab Design: a problem, and what the commands compute of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import dash_bootstrap_components as dbc
from dash import Dash, ctx, html
from dash.exceptions import PreventUpdate

from .. import studies
from ..cli.example import examples
from ..errors import MDRError
from ..problem import edit, schema
from ..progress import Progress
from . import editor, results
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
    "Imprint": Shown(studies.imprint, table="imprint"),
    "Time": Shown(studies.history, table="history"),
    "Heat": Shown(studies.conduction, table="conduction"),
}


def _command(tab: str) -> str:
    return f"mdrcontact {STUDIES[tab].study.__name__} problem.toml"


def layout(session: Session) -> list[Any]:
    """Return the form and the results."""
    select = dbc.Select(id=f"{NAME}-example", options=[*examples()], value="", placeholder="choose one")
    example = html.Div([html.Label("example", htmlFor=f"{NAME}-example"), select], className="row")
    head = html.Div([html.Div(editor.buttons(NAME), className="buttons"), example], className="head")
    left = html.Form([head, html.Div(id=f"{NAME}-form")], className="form")
    return [*editor.stores(NAME, session.text or examples()[_FIRST]), left, results.frame(NAME, [*STUDIES, _FILE])]


def register(dash: Dash, session: Session) -> None:
    """Register the callbacks."""
    editor.register(dash, NAME, schema.PROBLEM)

    @results.on(dash, NAME, results.SHOWN, ".data tab.value again.n_intervals cancel.n_clicks", first=True)
    def compute(data: Any, tab: str, _ticks: Any, _cancel: Any) -> Any:
        """Show the results of the text."""
        text = data["text"]
        if tab == _FILE:
            return results.show(_file(text))
        study, options, _ = STUDIES[tab]

        def work(progress: Progress) -> Any:
            return study(session.problem(text), **options, progress=progress)

        def report(found: Any) -> list[Any]:
            return [*results.report(found, found.figure()), results.files(NAME, _command(tab))]

        return results.show_study(session, NAME, (NAME, tab, text), tab, work, report)

    @results.on(dash, NAME, "file.data", "of:get.n_clicks", ".data tab.value")
    def get(clicks: Any, data: Any, tab: str) -> Any:
        """Download a file of the result."""
        found = session.jobs.find((NAME, tab, data["text"]))
        if found is None or not any(clicks):
            raise PreventUpdate
        return results.written(found, ctx.triggered_id["get"], _command(tab))

    @results.on(dash, NAME, ".data example.value", "example.value", ".data")
    def choose(name: str, data: Any) -> Any:
        """Begin with an example."""
        if not name:
            raise PreventUpdate
        return editor.with_text(data, examples()[name]), ""


def _file(text: str) -> list[Any]:
    """The text, and the same work as commands and in Python."""
    try:
        tables = edit.value(text, (), {})
    except MDRError:
        tables = {}
    used = [one for one in STUDIES.values() if not one.table or one.table in tables]
    lines = [f"mdrcontact {one.study.__name__} problem.toml --plot {one.study.__name__}.png" for one in used]
    python = ["from mdrcontact import problem, studies", "", 'given = problem.load("problem.toml")']
    for study, options, _ in used:
        given = "".join(f", {name}={value}" for name, value in options.items())
        python.append(f"{study.__name__} = studies.{study.__name__}(given{given})")
    return editor.file_tab(NAME, text, lines, python)
