# SPDX-License-Identifier: GPL-3.0-or-later
"""Results on the page: numbers, sentences, figures and tables of a study, and its files."""

from __future__ import annotations

import base64
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple

import dash_bootstrap_components as dbc
from dash import Output, ctx, dcc, html, no_update

from .._units import with_micro
from ..cli.table import as_csv, as_rows
from ..cli.workbook import as_xlsx
from ..errors import CancelledError, MDRError
from ..panels import Figure, matplotlib, plotly
from ..problem import ProblemError
from ..progress import Progress
from ..studies.result import Result
from .jobs import BusyError
from .session import Session

_SOON = 0.4
"""Time in which most work ends, so that the page shows its result immediately [s]."""
_ROWS, _FEW = 50, 12
_CONFIG: Any = {"displayModeBar": False, "responsive": True}


class Answer(NamedTuple):
    """What a callback shows."""

    result: Any = None
    refusal: Exception | None = None
    progress: tuple[float, float | None, str] | None = None


def answer(session: Session, key: Hashable, what: str, work: Callable[[Progress], Any], start: bool = True) -> Answer:
    """Return the result of a study; if it takes longer than a moment, its progress. Other work is cancelled.

    start : False to ask for work that was begun before, which other work may have cancelled
    """
    found, jobs = session.jobs.find(key), session.jobs
    if found is not None:
        return Answer(found)
    job = jobs.latest if jobs.latest is not None and jobs.latest.key == key else None
    if start and (job is None or not job.is_running):
        jobs.end()
        try:
            job = jobs.start(key, what, work)
        except BusyError as refusal:  # a second page was faster
            return Answer(refusal=refusal)
    elif job is None:
        return Answer(refusal=CancelledError(""))
    job.wait(_SOON)
    return Answer(progress=job.done) if job.is_running else Answer(job.result, job.problem)


def begins(name: str) -> bool:
    """Return whether a callback begins work: not when time has passed or the work is cancelled."""
    return ctx.triggered_id not in (f"{name}-again", f"{name}-cancel")


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


def outputs(name: str) -> list[Output]:
    """Return what `show` returns values for."""
    ids = {"results": ("children", "className"), "alert": ("children",), "where": ("data",), "said": ("children",)}
    ids |= {"again": ("disabled",), "busy": ("hidden",), "progress": ("children",)}
    return [Output(f"{name}-{part}", key) for part, keys in ids.items() for key in keys]


def show(parts: Any, said: str = "") -> list[Any]:
    """Show results."""
    return [parts, "", "", None, said, True, True, []]


def show_answer(name: str, found: Answer, report: Callable[[Any], Any], said: str) -> list[Any]:
    """Show the result of a study, its progress, or why there is none; old results stay, dimmed, unless the tab is another."""
    old: Any = [] if ctx.triggered_id == f"{name}-tab" else no_update
    if found.progress:
        return [old, "dimmed", "", None, no_update, False, False, progress(found.progress)]
    if found.refusal is not None:
        return [old, "dimmed", words_of(found.refusal), place_of(found.refusal), "", True, True, []]
    return show(report(found.result), said)


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
        graph = dcc.Graph(figure=one, config=_CONFIG, style={"height": "340px"}, **own)
        caption = f"{panel.title}: {panel.y.title} over {panel.x.title}".removeprefix(": ")
        drawn.append(html.Figure([graph, html.Figcaption(caption, className="unseen")]))
    return html.Div(drawn, className="panels")


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


def words_of(refusal: Exception) -> str:
    """Return a refusal as the alert has it."""
    if isinstance(refusal, CancelledError):
        return "The work was cancelled."
    if isinstance(refusal, MDRError):
        return str(refusal)
    return f"This is a bug of mdrcontact, please report it: {type(refusal).__name__}: {refusal}"


def progress(state: tuple[float, float | None, str]) -> list[Any]:
    """Return what has been done."""
    done, total, what = state
    name: dict[str, Any] = {"aria-label": what}
    bar = html.Progress(value=str(done), max=str(total), **name) if total else html.Progress(**name)
    return [bar, html.Span(f"{what} {done:g} of {total:g}" if total else what)]


def place_of(refusal: Exception) -> tuple[str, str] | None:
    """Return the path of the field that a refusal is about, and its words; None if it is about no field."""
    if not isinstance(refusal, ProblemError) or not refusal.path:
        return None
    path = refusal.path[:-1] if refusal.entry else refusal.path
    return "/".join(map(str, path)), refusal.advice
