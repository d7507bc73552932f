# SPDX-License-Identifier: GPL-3.0-or-later
"""The tab Measure: files of an instrument, and what a fit finds in them."""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Mapping
from typing import Any

import dash_bootstrap_components as dbc
from dash import Dash, ctx, dcc, html, no_update
from dash.exceptions import PreventUpdate

from .. import studies
from .._units import RATIO, shown, with_micro, without_micro
from ..cli import pages
from ..cli.files import DATA_SUFFIXES
from ..cli.table import as_csv
from ..errors import MDRError
from ..instruments.files.data_keys import KNOWN
from ..instruments.fitting import report as report_of
from ..instruments.fitting.gel import NAMES as GEL_NAMES
from ..instruments.fitting.parameters import pattern_of
from ..instruments.fitting.quantities import dimension_of, words_of
from ..instruments.schema import FIT, FREE, OPTIONS
from ..poroelastic import is_poroelastic
from ..problem import edit
from ..progress import Progress
from ..studies.fit import FittedCurve
from ..studies.many import FittedCurves
from . import editor, many, results
from .form import Path, dom_id, id_of, typed
from .session import Session

NAME = "measure"
_OPTIONS = dataclasses.replace(OPTIONS, fields=tuple(one for one in OPTIONS.fields if one.name != "free"))
_ROOT = dataclasses.replace(
    FIT, fields=tuple(one._replace(table=_OPTIONS) if one.name == "fit" else one for one in FIT.fields if one.name != "compute")
)
"""The file of a fit without what is sought, which has rows of its own."""
_FREE, _PRIOR = "#free", "#prior"
_AT = ("fit", "free")


def is_mine(text: str) -> bool:
    """Whether a text is that of a fit."""
    try:
        return "data" in edit.value(text, (), {})
    except MDRError:
        return False


def begin(session: Session) -> tuple[str, list[str]]:
    """Return the text and the files of measurements that the page begins with."""
    names = [name for name in session.files if name.lower().endswith(DATA_SUFFIXES)]
    if is_mine(session.text) or (names and not session.text):
        return session.text or inspected(session, names[0]).inspection.problem, names
    return "", []


def inspected(session: Session, name: str) -> Any:
    """Return what is in a file."""
    path = session.path(name)
    return session.jobs.now(("inspect", name, path.stat().st_mtime_ns), lambda: studies.inspect(path))


def layout(session: Session) -> list[Any]:
    """Return the form and the results."""
    words = "Drop files of an instrument here, or choose them"
    drop = html.Label([words, dcc.Upload("", id=f"{NAME}-drop", multiple=True)], className="drop")
    options = (("moves", "other ranges too"), ("compare", "all models too"))
    boxes = [dbc.Checkbox(id=f"{NAME}-{name}", label=words, value=False) for name, words in options]
    start = html.Button("Fit", id=f"{NAME}-start", n_clicks=0, type="button", className="main")
    head = html.Div(
        [html.Div([start, *editor.buttons(NAME)], className="buttons"), html.Div(boxes, className="buttons")], className="head"
    )
    left = [drop, head, html.Div(id=f"{NAME}-form"), html.Div(id=f"{NAME}-sought")]
    first, names = begin(session)
    data = {"names": {"names": names, "out": []}, "run": None}
    stores = [dcc.Store(id=f"{NAME}-{name}", storage_type="session", data=one) for name, one in data.items()]
    return [*editor.stores(NAME, first), *stores, html.Form(left, className="form"), results.frame(NAME, ["Data", "Fit", "File"])]


def free_of(text: str) -> dict[str, Mapping[str, Any]]:
    """Return the free numbers of a text, with what is known of each."""
    given = edit.value(text, _AT, [])
    return dict(given) if isinstance(given, dict) else {name: {} for name in given if isinstance(name, str)}


def numbers_of(session: Session, text: str) -> dict[str, float | None]:
    """Return every number of a problem that a fit can find, and its value."""
    try:  # names that are sought may be those of another body
        found = session.fit_file(edit.changed(text, _AT, ["depth_offset"]))
    except MDRError:
        found = session.fit_file(text)
    if is_poroelastic(found.medium):
        return dict.fromkeys(GEL_NAMES)
    pattern = pattern_of(found.indenter, found.medium, found.instrument)
    return {name: float(value) for name, value in zip(pattern.names, pattern.values, strict=True) if name and math.isfinite(value)}


def sought(session: Session, text: str) -> Any:
    """Return a row for each number: its value, whether it is free, and how well it is known."""
    rows, free = [], free_of(text)
    numbers = numbers_of(session, text)
    for name, value in {**numbers, **dict.fromkeys(free.keys() - numbers.keys(), math.nan)}.items():
        own, known = id_of(NAME, "set", (_FREE, name)), id_of(NAME, "set", (_PRIOR, name))
        now = "" if value is None else "no number of this problem" if math.isnan(value) else shown(value, dimension_of(name), 6)
        box = dbc.Checkbox(id=own, value=name in free, label=html.Span([words_of(name), " ", html.Small(with_micro(now))]))
        sd = dbc.Input(id=known, value=with_micro(str(free.get(name, {}).get("prior_sd", ""))), placeholder="sd", debounce=True)
        label = html.Label(f"standard deviation of {words_of(name)}", htmlFor=dom_id(known), className="unseen")
        error = html.Span(id=id_of(NAME, "error", (*_AT, name)), className="error")
        rows.append(html.Div([box, html.Span([label, sd]), error], className="row"))
    hint = html.P("Ticked numbers are found. A number that is known beforehand has its standard deviation (sd).", className="hint")
    return html.Fieldset([html.Legend("sought"), hint, *rows])


def seek(session: Session, text: str, path: Path, value: Any) -> str:
    """Return the text after a change of what is sought."""
    what, name = str(path[0]), str(path[1])
    free = free_of(text)
    known = {key: old for key, old in free.get(name, {}).items() if not key.startswith("prior")}
    if what == _FREE and not value:
        rest = [one for one in free if one != name]
        return edit.without(text, (*_AT, name)) if any(free.values()) else edit.changed(text, _AT, rest)
    value = without_micro(value) if what == _PRIOR else value
    if what == _PRIOR and value:
        now = numbers_of(session, text).get(name) or 0.0
        is_plain = dimension_of(name) == RATIO
        known |= {
            "prior": now if is_plain else shown(now, dimension_of(name), 9),
            "prior_sd": typed(FREE.field("prior_sd")._replace(dimension=RATIO), value) if is_plain else value,
        }
    if not known and not any(free.values()):
        return edit.changed(text, _AT, [*dict.fromkeys((*free, name))])
    if isinstance(edit.value(text, _AT), list):
        text = edit.changed(text, _AT, {one: dict(old) for one, old in free.items()})
    return edit.changed(text, (*_AT, name), known)


def fitted(session: Session, run: Mapping[str, Any], progress: Progress) -> Any:
    """Return what the study finds in the curves that are not left out, as the command does."""
    problem, names = session.fit_file(run["text"]), [name for name in run["names"] if name not in run["out"]]
    paths = [session.path(name) for name in names]
    curves = problem.all_curves(paths, progress) if len(paths) > 1 else problem.curves(paths[0])
    if len(curves) > 1:
        return studies.many(problem, curves, progress=progress)
    data, notes = curves[0].read()
    return studies.fit(problem, data, moves=run["moves"], compare=run["compare"], progress=progress), notes


def report(run: Mapping[str, Any], found: Any) -> list[Any]:
    """Return the verdict first, then estimates, figures, choices and models."""
    names = ("report.html", "fit.json", "csv", "xlsx", "png", "pdf")
    command = results.files(NAME, command_of(run), names)
    if isinstance(found, FittedCurves):
        return [*many.report(run, found), command]
    fit, notes = found
    if not hasattr(fit.fit, "interval_as_text"):  # a gel
        return [*results.report(fit, None), command]
    verdict = html.P(f"The model {fit.fit.misfit_words()}.", className="verdict")
    parts = [html.H2(fit.title), verdict, _estimates(fit), *results.items(fit.warnings, "warnings"), command]
    parts.append(results.panels(fit.figure()))
    if fit.moves is not None and fit.moves.summary():
        parts += [html.H2("Other choices"), *results.items(fit.moves.summary()), results.panels(fit.moves.plot())]
    if fit.ranking is not None:
        parts += [html.H2("Models"), html.Pre(fit.notes["models"])]
    if fit.refusal is not None:
        parts += [html.P(str(fit.refusal), className="warnings")]
    return [*parts, html.H2("What was read"), *results.items(notes), *results.folded(fit.tables)]


def _estimates(found: FittedCurve) -> Any:
    fit = found.fit
    rows = [["", "estimate", "95 % interval", "doubts"]]
    for name in fit.names:
        interval = fit.interval_as_text(name, given=found.intervals.get(name))
        rows.append([words_of(name), fit.as_text(name), interval, "; ".join(fit.doubts(name))])
    return results.rows(rows)


def command_of(run: Mapping[str, Any]) -> str:
    """Return the command that computes a fit."""
    data = run["names"][0] if len(run["names"]) == 1 else "FOLDER"
    return f"mdrcontact fit {data} --problem problem.toml --report report.html" + " --compare" * bool(run.get("compare"))


def file_of(session: Session, run: Mapping[str, Any], found: Any, what: str) -> Any:
    """Return a file of a fit for the download."""
    fit, notes = (found, []) if isinstance(found, FittedCurves) else found
    if what == "report.html":
        read = {name: session.path(name).read_bytes() for name in run["names"] if name not in run["out"]}
        origin = report_of.origin(read, run["text"], command_of(run))
        page = pages.many_page(fit, origin) if isinstance(fit, FittedCurves) else pages.fit_page(fit, notes, origin)
        return results.download(what, session.shortened(page))
    if what == "fit.json":
        return results.download(what, session.shortened(json.dumps(fit.to_dict(), indent=2, allow_nan=False)) + "\n")
    if what == "csv":
        return results.download("points.csv", as_csv(fit.tables["estimates" if isinstance(fit, FittedCurves) else "points"]))
    return results.written(fit, what, command_of(run))


def register(dash: Dash, session: Session) -> None:
    """Register the callbacks."""
    editor.register(dash, NAME, _ROOT, lambda text, path, value: seek(session, text, path, value))
    many.register(dash, session, NAME)

    @results.on(
        dash, NAME, "names.data .data alert.children tab.value drop.contents", "drop.contents", "drop.filename names.data .data"
    )
    def drop(contents: Any, names: Any, old: Any, data: Any) -> Any:
        """Keep the files in the order of their names, and begin with the first one, or with the problem file among them."""
        try:
            added = session.add({name: editor.content_of(one) for name, one in sorted(zip(names, contents, strict=True))})
            texts = [name for name in added if name.endswith(".toml")]
            rest = [name for name in added if name not in texts]
            given = [session.path(name).read_text("utf-8", "replace") for name in texts]
            text = given[0] if given else inspected(session, rest[0]).inspection.problem
            edit.value(text, ())  # an error if it is no TOML
        except MDRError as refusal:
            return no_update, no_update, str(refusal), no_update, None
        return {"names": rest, "out": []} if rest else old, editor.with_text(data, text), "", "Data", None

    @results.on(dash, NAME, "sought.children", ".data", first=True)
    def draw(data: Any) -> Any:
        """Draw what is sought, unless a row of it was changed, which shows what the user did."""
        text, by = data["text"], data["by"]
        before = free_of(data["past"][-1]) if by.startswith("#") else {}
        if by.startswith("#") and not (by.startswith(_FREE) and before.get(by.partition("/")[2])):
            raise PreventUpdate
        try:
            return sought(session, text) if text else []
        except MDRError:
            return []

    @results.on(dash, NAME, "run.data tab.value", "start.n_clicks .data", "names.data moves.value compare.value")
    def start(clicks: int, data: Any, files: Any, moves: bool, compare: bool) -> Any:
        """Fit the curves of the files. The text is an input: what is typed right before the click is then in it."""
        if f"{NAME}-start.n_clicks" not in ctx.triggered_prop_ids:
            raise PreventUpdate
        options = {"moves": moves, "compare": compare, "run": clicks}
        return {"text": data["text"], **files, **options}, "Fit"

    @results.on(dash, NAME, results.SHOWN, "run.data .data names.data tab.value again.n_intervals cancel.n_clicks", first=True)
    def compute(run: Any, data: Any, files: Any, tab: str, _ticks: Any, _cancel: Any) -> Any:
        """Show what the files have, or what the fit finds."""
        text = data["text"]
        if tab == "File":
            return results.show(editor.file_tab(NAME, text, [command_of({**files, "names": files["names"] or ["DATA"]})], []))
        if not files["names"]:
            return results.show([html.P("Drop a table, a spreadsheet or files of an AFM on the left to begin.", className="note")])
        try:
            if tab == "Data":
                return results.show(_found(inspected(session, files["names"][0])))
        except MDRError as refusal:
            return results.show_refusal(NAME, refusal)
        if not run:
            return results.show([html.P("Press Fit to find the ticked numbers.", className="note")])
        parts, look, *more = results.show_study(
            session,
            NAME,
            editor.key_of(NAME, run),
            "fit",
            lambda progress: fitted(session, run, progress),
            lambda one: report(run, one),
        )
        is_old = (run["text"], run["names"], run["out"]) != (text, files["names"], files["out"])
        return [parts, "dimmed" if is_old else look, *more]

    @results.on(dash, NAME, ".data", "of:drag.selectedData", "of:drag.figure .data")
    def drag(chosen: Any, figures: Any, data: Any) -> Any:
        """Fit the range that was dragged across a curve."""
        for one, figure in zip(chosen, figures, strict=True):
            if one and one.get("range"):
                axis = figure["layout"]["xaxis"]["title"]["text"]
                return editor.with_text(data, ranged(data["text"], axis, one["range"]["x"]))
        raise PreventUpdate

    @results.on(dash, NAME, "file.data", "of:get.n_clicks", "run.data")
    def get(clicks: Any, run: Any) -> Any:
        """Download a file of the fit."""
        found = session.jobs.find(editor.key_of(NAME, run))
        if found is None or not any(clicks):
            raise PreventUpdate
        return file_of(session, run, found, ctx.triggered_id["get"])


def _found(found: Any) -> list[Any]:
    """What a file has."""
    inspection = found.inspection
    words = [f"{inspection.kind}: {', '.join(found.curves[:3])}"] if found.curves else []
    parts: list[Any] = [html.H2(found.title), *results.items((*words, *inspection.notes))]
    parts += [html.P(str(found.refusal), className="warnings")] if found.refusal else []
    parts += results.items(found.facts)
    guessed, figure = ", ".join(found.guessed), found.figure()
    parts += [html.P(f"Not in the file, put in yours: {guessed}.", className="note"), *results.report(found, None)]
    if not figure.panels:
        return parts
    hint = html.P("Drag across a curve to choose the range of depth to fit.", className="hint")
    return [*parts, *([hint, results.panels(figure, NAME)] if _has_range(inspection.problem) else [results.panels(figure)])]


def _has_range(text: str) -> bool:
    return "min_depth" in KNOWN.keys_of("kind", edit.value(text, ("data", "kind"), ""))


def ranged(text: str, axis: str, ends: list[float]) -> str:
    """Return the text with a range of depth along an axis, whose title has the unit."""
    unit = axis.partition("[")[2].rstrip("]")
    for key, end in zip(("min_depth", "max_depth"), sorted(ends), strict=True):
        text = edit.changed(text, ("data", key), without_micro(f"{end:.4g} {unit}"))
    return text
