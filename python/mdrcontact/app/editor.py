# SPDX-License-Identifier: GPL-3.0-or-later
"""The text of a problem file on the page, and its form. The browser keeps both, with the texts before, while its window is open."""

from __future__ import annotations

import base64
import json
from collections.abc import Callable
from typing import Any

import dash_bootstrap_components as dbc
from dash import Dash, ctx, dcc, html, no_update
from dash.exceptions import PreventUpdate

from ..errors import MDRError
from ..instruments.files.start_file import MARK
from ..problem.field import Table
from . import results
from .form import Path, acted, dom_id, edited, form, parts_of, path_of

TEXT = "#text"
"""Path of the input that has the whole text."""
Seek = Callable[[str, Path, Any], str]
_MOST = 50
"""Texts that can be undone."""


def stores(name: str, first: str) -> list[Any]:
    """Return what keeps the text, its refusal, and the structure of the form that is drawn. first : text before any change"""
    kept = dcc.Store(id=name, storage_type="session", data={"text": first, "past": [], "by": ""})
    return [kept, dcc.Store(id=f"{name}-drawn"), dcc.Store(id=f"{name}-where"), dcc.Download(id=f"{name}-file")]


def buttons(name: str) -> list[Any]:
    """Return the buttons above a form."""
    save = html.Button("Save", id=f"{name}-save", title="download the problem file", n_clicks=0, type="button")
    opened = html.Label(["Open", dcc.Upload("", id=f"{name}-open")], className="button")
    return [opened, save]


def file_tab(name: str, text: str, commands: list[str], python: list[str]) -> list[Any]:
    """Return the text of the problem file, and the same work as commands and in Python."""
    own = {"form": name, "set": TEXT}
    area = dbc.Textarea(id=own, value=text, debounce=True, className="text")
    parts = [html.Label("problem file", htmlFor=dom_id(own)), area, html.H2("The same as commands"), html.Pre("\n".join(commands))]
    return [*parts, html.H2("The same in Python"), html.Pre("\n".join(python))] if python else parts


def with_text(data: Any, text: str, by: str = "") -> dict[str, Any]:
    """Return the state with another text; the old one can be undone. by : path of the input or the button of the change"""
    return {"text": text, "past": [one for one in (*data["past"], data["text"]) if one][-_MOST:], "by": by}


def register(dash: Dash, name: str, root: Table, seek: Seek | None = None) -> None:
    """Let the form edit the text, and the text draw the form. seek : edits the text by inputs whose paths begin with #"""

    @results.on(dash, name, ".data! alert.children", "form:set.value form:act.n_clicks #undo.n_clicks", "#page.value .data")
    def change(_values: Any, _clicks: Any, _undo: Any, page: str, data: Any) -> Any:
        """Edit the text by the input or the button that was used."""
        used, value = ctx.triggered_id, ctx.triggered[0]["value"]
        if used == "undo":
            if not data["past"] or page.lower() != name:
                raise PreventUpdate
            *past, text = data["past"]
            return {"text": text, "past": past, "by": ""}, ""
        if used is None or len(ctx.triggered) > 1 or value is None or ("act" in used and not value):
            raise PreventUpdate  # the form was drawn
        try:
            new = _changed(root, data["text"], used, value, seek)
        except MDRError as refusal:
            return no_update, str(refusal)
        if new == data["text"]:
            raise PreventUpdate
        by = "" if used.get("set") == TEXT else used.get("set") or used["act"]
        return with_text(data, new, by), no_update

    @results.on(dash, name, "form.children form:part.children drawn.data", ".data", "drawn.data form:part.id", first=True)
    def draw(data: Any, drawn: Any, ids: Any) -> Any:
        """Draw the form; after an input only the parts that have other rows, so that the focus stays."""
        kept, by = [no_update] * len(ids), data["by"]
        if not data["text"]:
            return [], kept, None
        try:
            whole = form(name, root, data["text"], by)
        except MDRError:
            raise PreventUpdate from None  # the text is no TOML, which the results say
        found = parts_of(whole)
        structure = {path: own for path, (_, own) in found.items()}
        if not by or not drawn or structure[""] != drawn[""]:
            return whole, kept, structure
        changed = {path for path, own in structure.items() if drawn.get(path) != own}
        inner = {path for path in changed for other in changed if path.startswith(f"{other}/")}
        parts = [found[path][0].children if path in changed - inner else no_update for path in (one["part"] for one in ids)]
        return no_update, parts, structure

    @results.on(dash, name, "form:error.children", "where.data drawn.data", "form:error.id", first=True)
    def mark(where: Any, _drawn: Any, ids: Any) -> Any:
        """Show a refusal at its field."""
        path, words = where or (None, "")
        return [words if one["error"] == path else "" for one in ids]

    @results.on(dash, name, "file.data", "save.n_clicks", ".data")
    def save(_clicks: int, data: Any) -> Any:
        """Download the problem file."""
        return results.download("problem.toml", data["text"])

    @results.on(dash, name, ".data open.contents", "open.contents", ".data")
    def open_file(content: str, data: Any) -> Any:
        """Show the text of a problem file."""
        return with_text(data, content_of(content).decode("utf-8", "replace")), None  # the same file can be opened again


def _changed(root: Table, text: str, used: Any, value: Any, seek: Seek | None) -> str:
    if "act" in used:
        return acted(root, text, path_of(used["act"]))
    if used["set"] == TEXT:
        return str(value)
    path = path_of(used["set"])
    if seek is not None and str(path[0]).startswith("#"):
        return seek(text, path, value)
    new = edited(root, text, path, str(value))
    lines = set(text.splitlines())  # who changes a guess confirms it
    return "".join(line if line.strip("\n") in lines else line.replace(MARK, "") for line in new.splitlines(keepends=True))


def key_of(name: str, run: Any) -> tuple[str, str]:
    """Return the key of the result of a fit."""
    return name, json.dumps(run, sort_keys=True)


def content_of(uploaded: str) -> bytes:
    """Return the content of a file that was dropped."""
    return base64.b64decode(uploaded.partition(",")[2])
