# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of many curves on the page: their mean, a table from which curves are left out, and the map."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from dash import Dash, html, no_update
from dash.exceptions import PreventUpdate
from dash_ag_grid import AgGrid

from .._units import with_micro
from ..cli.table import as_rows
from ..instruments.fitting import FitResult
from ..problem import edit
from ..studies.many import FittedCurves
from . import editor, results
from .session import Session

GRID = "many-grid"
_OUT = ("data", "leave_out")
_HAND = "left out by hand"
_OPTIONS = {"rowSelection": {"mode": "multiRow", "enableClickSelection": False}, "enableCellTextSelection": True}


def report(run: Mapping[str, Any], found: FittedCurves) -> list[Any]:
    """Return the means, the figure or map, and a row for each curve."""
    parts: list[Any] = [html.H2(found.title), *(html.P(with_micro(words), className="note") for words in found.notes.values())]
    parts += [results.table(found.tables["spread"])] if "spread" in found.tables else []
    return [
        *parts,
        *results.items(found.doubts, "warnings"),
        grid(run, found),
        html.Div(id="many-one"),
        results.panels(found.figure()),
    ]


def grid(run: Mapping[str, Any], found: FittedCurves) -> Any:
    """Return the table of the curves: those that are not ticked are left out, and a row shows its fit."""
    titles, *cells = [[name, *map(with_micro, row)] for name, *row in as_rows(found.tables["curves"])]
    titles.append("why")
    why = {one.curve.name: "; ".join(one.rating.reasons) for one in found.fitted}
    failed = {
        curve.name: str(one.error) for curve, one in zip(found.curves, found.results, strict=True) if not isinstance(one, FitResult)
    }
    data = [dict(zip(map(str, range(len(titles))), [*row, failed.get(row[0], why.get(row[0], ""))], strict=True)) for row in cells]
    data += [{"0": name, str(len(titles) - 1): _HAND} for name in out_of(run)]
    columns = [{"field": str(i), "headerName": title, "tooltipField": str(i)} for i, title in enumerate(titles)]
    return AgGrid(
        id=GRID,
        rowData=data,
        columnDefs=columns,
        defaultColDef={"sortable": True, "filter": True, "resizable": True},
        selectedRows={"ids": [row["0"] for row in data if row[str(len(titles) - 1)] != _HAND]},
        dashGridOptions=_OPTIONS,
        getRowId="params.data[0]",
        columnSize="autoSize",
        style={"height": "420px"},
    )


def out_of(run: Mapping[str, Any]) -> list[str]:
    """Return the names of the curves that are left out by hand."""
    names = run["names"]
    return [*run["out"], *(f"{names[0]} {test}" for test in edit.value(run["text"], _OUT, []) if len(names) == 1)]


def register(dash: Dash, session: Session, page: str) -> None:
    """Register the callbacks of the table."""

    @results.on(dash, page, "run.data names.data .data", f"#{GRID}.selectedRows", f"#{GRID}.rowData run.data .data")
    def leave_out(ticked: Any, rows: Any, run: Any, data: Any) -> Any:
        """Leave out what is not ticked, and fit again: tests of a file by the text, files by their names."""
        if not isinstance(ticked, list):
            raise PreventUpdate  # the table was drawn
        chosen = {row["0"] for row in ticked}
        out = [row["0"] for row in rows or [] if row["0"] not in chosen]
        if not chosen or set(out) == set(out_of(run)):
            raise PreventUpdate
        names = run["names"]
        if len(names) > 1:
            files = {"names": names, "out": out}
            return {**run, **files}, files, no_update
        tests = [name.removeprefix(f"{names[0]} ") for name in out]
        text = edit.changed(run["text"], _OUT, tests) if tests else edit.without(run["text"], _OUT)
        return {**run, "text": text}, no_update, editor.with_text(data, text)

    @results.on(dash, page, "#many-one.children", f"#{GRID}.cellClicked", "run.data")
    def one(cell: Any, run: Any) -> Any:
        """Show the fit of a row."""
        found = session.jobs.find(editor.key_of(page, run))
        if not cell or found is None:
            raise PreventUpdate
        name = cell.get("rowId") or ""
        fit = next((one.fit for one in found.fitted if one.curve.name == name), None)
        return [html.H2(name), html.P(f"The model {fit.misfit_words()}."), results.panels(fit.plot(name))] if fit else []
