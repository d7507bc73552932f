# SPDX-License-Identifier: GPL-3.0-or-later
"""Results on the page: numbers, sentences, figures and tables of a study, and its files."""

from __future__ import annotations

import base64
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import Any, TypeVar

import dash_bootstrap_components as dbc
import numpy as np
from dash import ALL, Dash, Input, Output, State, ctx, dcc, html, no_update

from .._units import with_micro
from ..cli.table import as_csv, as_rows
from ..cli.workbook import as_xlsx
from ..errors import CancelledError, MDRError
from ..panels import Cells, Figure, Panel, matplotlib, plotly
from ..problem import ProblemError
from ..progress import Progress
from ..studies.result import Result
from .jobs import BusyError
from .session import Session

_SOON = 0.4
"""Time in which most work ends, so that the page shows its result immediately [s]."""
_ROWS, _FEW = 50, 12
T = TypeVar("T")
_CONFIG: Any = {"displayModeBar": False, "responsive": True}


def on(dash: Dash, page: str, outputs: str, inputs: str, states: str = "", first: bool = False) -> Callable[[T], T]:
    """Return a decorator of callbacks.

    Places are "part.property" of a page, or of every component with an id of two steps, as in "form:set.value"; ".data" is the text
    of the page, and "#" begins the id of another component. For an output with "!" callbacks wait that have it as an input.

    first : whether the callback also runs when the page is drawn
    """
    out = [
        Output(_id(page, part), key.rstrip("!"), allow_duplicate=not (first or key.endswith("!")))
        for part, _, key in (one.rpartition(".") for one in outputs.split())
    ]
    places = [
        kind(_id(page, part), key)
        for kind, given in ((Input, inputs), (State, states))
        for part, _, key in (one.rpartition(".") for one in given.split())
    ]
    return dash.callback(out if len(out) > 1 else out[0], *places, prevent_initial_call=not first)


def _id(page: str, part: str) -> Any:
    kind, _, what = part.partition(":")
    if what:
        return {kind: page, what: ALL}
    return part[1:] if part.startswith("#") else f"{page}-{part}" if part else page


def frame(name: str, words: list[str]) -> Any:
    """Return the right side of a page: errors, tabs, progress and results. words : of the tabs"""
    cancel = html.Button("Cancel", id=f"{name}-cancel", n_clicks=0, type="button")
    return html.Div(
        [
            html.Div(id=f"{name}-alert", role="alert", className="alert"),
            tabs(f"{name}-tab", words, words[0], f"results of {name}"),
            html.Div([html.Div(id=f"{name}-progress"), cancel], id=f"{name}-busy", hidden=True, className="busy"),
            html.Div(id=f"{name}-said", role="status", className="unseen"),
            html.Div(id=f"{name}-results"),
            dcc.Interval(id=f"{name}-again", interval=300, disabled=True),
        ],
        className="results",
    )


def tabs(name: str, words: list[str], first: str, label: str) -> Any:
    """Return tabs that the arrows change; the page remembers the chosen one while it is open."""
    buttons = dbc.RadioItems(words, first, id=name, inline=True, persistence=True, persistence_type="session")
    named: dict[str, Any] = {"aria-label": label}
    return html.Nav(html.Fieldset([html.Legend(label, className="unseen"), buttons]), className="tabs", **named)


SHOWN = "results.children results.className alert.children where.data said.children again.disabled busy.hidden progress.children"
"""Places that `show` returns values for."""


def show(parts: Any, said: str = "") -> list[Any]:
    """Show results."""
    return [parts, "", "", None, said, True, True, []]


def show_refusal(name: str, refusal: Exception) -> list[Any]:
    """Show why there is no result; old results stay, dimmed, unless the tab is another."""
    place = None
    if isinstance(refusal, ProblemError) and refusal.path:
        place = "/".join(map(str, refusal.path[:-1] if refusal.entry else refusal.path)), refusal.advice
    return [_old(name), "dimmed", words_of(refusal), place, "", True, True, []]


def words_of(refusal: Exception) -> str:
    """Return what the alert has for an error."""
    words = str(refusal) if isinstance(refusal, MDRError) else f"This is a bug of mdrcontact, please report it: {refusal!r}"
    return "The work was cancelled." if isinstance(refusal, CancelledError) else words


def show_study(
    session: Session, name: str, key: Hashable, what: str, work: Callable[[Progress], T], report: Callable[[T], Any]
) -> Any:
    """Show the result of a study; if it takes longer than a moment, its progress. Other work is cancelled."""
    jobs = session.jobs
    if ctx.triggered_id == f"{name}-cancel":
        jobs.cancel()
    found = jobs.find(key)
    if found is None:
        job = jobs.latest if jobs.latest is not None and jobs.latest.key == key else None
        # when time has passed other work may have cancelled this one, which does not begin again
        if ctx.triggered_id not in (f"{name}-again", f"{name}-cancel") and (job is None or not job.is_alive()):
            jobs.cancel(wait=True)
            try:
                job = jobs.start(key, what, work)
            except BusyError as refusal:  # a second page was faster
                return show_refusal(name, refusal)
        if job is None:
            return show_refusal(name, CancelledError(""))
        job.join(_SOON)
        if job.is_alive():
            return [_old(name), "dimmed", "", None, no_update, False, False, _progress(*job.done)]
        if job.problem is not None:
            return show_refusal(name, job.problem)
        found = job.result
    return show(report(found), f"{what} computed")


def _old(name: str) -> Any:
    return [] if ctx.triggered_id == f"{name}-tab" else no_update


def _progress(done: float, total: float | None, what: str) -> list[Any]:
    label: dict[str, Any] = {"aria-label": what}
    bar = html.Progress(value=str(done), max=str(total), **label) if total else html.Progress(**label)
    return [bar, html.Span(f"{what} {done:g} of {total:g}" if total else what)]


def panels(figure: Any, drags: str = "") -> Any:
    """Return the drawings of a figure, as many side by side as there is room. drags : page that takes ranges from them"""
    drawn, below = [], figure.panels[-1].x
    # a panel above another one has no name of its axis
    panels = tuple(
        one if one.x.title else one._replace(x=one.x._replace(name=below.name, unit=below.unit)) for one in figure.panels
    )
    for i, (one, panel) in enumerate(zip(plotly.draw(figure._replace(panels=panels)), panels, strict=True)):
        own: dict[str, Any] = {"id": {"of": drags, "drag": i}} if drags else {}
        one.update_layout({"dragmode": "select", "selectdirection": "h"} if drags else {})
        graph = dcc.Graph(figure=one, config=_CONFIG, style={"height": f"{_height(panel):.0f}px"}, **own)
        caption = f"{panel.title}: {panel.y.title} over {panel.x.title}".removeprefix(": ")
        drawn.append(html.Figure([graph, html.Figcaption(caption, className="unseen")]))
    return html.Div(drawn, className="panels")


def _height(panel: Panel) -> float:
    """Height of a drawing [px], less for a flat map."""
    maps = [one for one in panel.parts if isinstance(one, Cells) and panel.equal]
    x, y = (float(np.ptp(np.concatenate([getattr(one, name) for one in maps]))) if maps else 1.0 for name in "xy")
    return min(340.0, 130.0 + 300.0 * y / x)


def report(found: Result, figure: Figure | None) -> list[Any]:
    """Return numbers, warnings, notes, figure and tables of a study."""
    numbers = [html.Div([html.Dt(name), html.Dd(with_micro(str(number)))]) for name, number in found.numbers.items()]
    parts: list[Any] = [html.Dl(numbers, className="numbers")] if numbers else []
    parts += items(found.warnings, "warnings")
    parts += [html.P(with_micro(words), className="note") for about, words in found.notes.items() if about not in found.tables]
    parts += [panels(figure)] if figure is not None and figure.panels else []
    return [*parts, *folded(found.tables, found.notes)]


def items(lines: Iterable[Any], look: str = "") -> list[Any]:
    """Return a list, or nothing without lines. look : its class"""
    entries = [html.Li(with_micro(str(line))) for line in lines]
    return [html.Ul(entries, className=look)] if entries else []


def folded(tables: Mapping[str, Any], notes: Mapping[str, str] = MappingProxyType({})) -> list[Any]:
    """Return tables behind folds, each with what is said about it; short ones are open."""
    made = []
    for name, one in tables.items():
        words = [html.P(with_micro(notes[name]), className="note")] if name in notes else []
        made.append(html.Details([html.Summary(f"table: {name}"), *words, table(one)], open=len(one[0].values) <= _FEW))
    return made


def table(columns: Any) -> Any:
    """Return a table with at most 50 rows, spread over all."""
    count = len(columns[0].values)
    return rows(as_rows(columns, _ROWS), f"{_ROWS} of {count} rows; the CSV file has all" if count > _ROWS else "")


def rows(cells: Sequence[Sequence[str]], caption: str = "") -> Any:
    """Return a table of words, its titles first."""
    head, *body = [[with_micro(cell) for cell in row] for row in cells]
    lines = html.Tbody([html.Tr([html.Td(cell) for cell in row]) for row in body])
    titles = html.Thead(html.Tr([html.Th(cell, scope="col") if cell else html.Td() for cell in head]))
    return html.Div(html.Table([*([html.Caption(caption)] if caption else []), titles, lines]), className="table", tabIndex=0)


def files(page: str, command: str, names: Sequence[str] = ("csv", "xlsx", "png", "pdf", "svg")) -> Any:
    """Return the buttons of the files of a result, and the command that computes the same."""
    buttons = [html.Button(name, id={"of": page, "get": name}, n_clicks=0, type="button") for name in names]
    return html.Div(["download ", *buttons, html.Code(command)], className="files")


def written(found: Any, what: str, command: str) -> Any:
    """Return a file of a result for the download: "csv", "xlsx", or a format of a figure."""
    if what == "csv":
        return download("result.csv", as_csv([*found.tables.values()][-1]))
    if what == "xlsx":
        return download("result.xlsx", as_xlsx(found, command))
    return download(f"figure.{what}", matplotlib.rendered(matplotlib.draw(found.figure()), what))


def download(name: str, content: bytes | str) -> dict[str, Any]:
    """Return a file for the browser to save."""
    content = content.encode() if isinstance(content, str) else content
    return {"filename": name, "content": base64.b64encode(content).decode(), "base64": True, "type": "application/octet-stream"}
