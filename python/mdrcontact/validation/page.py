# SPDX-License-Identifier: GPL-3.0-or-later
"""The validation as one HTML file and as a page of the guide."""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Sequence
from importlib import metadata
from typing import Any, NamedTuple

import numpy as np

from ..fitting import report
from . import limits
from .check import Check, Comparison

PROGRAMS = {"skfem": "scikit-fem", "tamaas": "tamaas", "ContactMechanics": "ContactMechanics"}
"""Modules of programs of others, and their names: the extra `validate` installs the first; the others compare half-spaces and, by
`compliance`, layers (examples/clients/layered_bem.py)."""
COMMAND = "mdrcontact validate --full --only"


class Row(NamedTuple):
    """A check and what came out; None where its program is missing or the run is a quick one."""

    check: Check
    found: Comparison | None
    why_not: str = ""

    @property
    def holds(self) -> bool:
        """Whether the deviation is within what the source's own error explains; true where nothing was run."""
        return self.found is None or self.found.deviation <= self.check.error

    def cells(self) -> list[str]:
        """Of the table."""
        deviation = self.why_not if self.found is None else f"{self.found.deviation:.1e}" + ("" if self.holds else " BEYOND")
        one = self.check
        return [one.capability, one.source, deviation, f"{one.error:.0e}", one.whose, f"{COMMAND} {one.name}"]


TITLES = ["capability", "compared with", "largest deviation", "bound", "whose error", "command"]


def run(checks: Sequence[Check], full: bool) -> list[Row]:
    """Runs those that can be run."""
    rows = []
    for check in checks:
        if check.needs and not is_installed(check.needs):
            rows.append(Row(check, None, f"not run: {PROGRAMS[check.needs]} is not installed"))
        elif check.is_long and not full:
            rows.append(Row(check, None, "not run: --full"))
        else:
            rows.append(Row(check, check.run()))
    return rows


def is_installed(module: str) -> bool:
    """Whether a program can be imported."""
    return importlib.util.find_spec(module) is not None


def programs() -> list[str]:
    """A sentence for each program of others."""
    words = []
    for module, name in PROGRAMS.items():
        try:
            words.append(f"{name} {metadata.version(name)}")
        except metadata.PackageNotFoundError:
            words.append(f"{name} is " + ("there, of unknown version" if is_installed(module) else "not installed"))
    return words


def html(rows: Sequence[Row]) -> str:
    """The page, with a picture of each comparison where matplotlib is installed."""
    blocks = [report.heading("Against formulas, tables and programs of others"), report.table([TITLES, *(r.cells() for r in rows)])]
    blocks += [report.paragraph(f"Programs: {', '.join(programs())}.")]
    blocks += [report.heading("What each model is good for"), report.table(limits.models())]
    blocks += [report.heading("Where the library ends"), report.table(limits.refusals())]
    if is_installed("matplotlib"):
        blocks.append(report.heading("Pictures"))
        blocks += [report.picture(_figure(row), row.check.capability) for row in rows if row.found is not None]
    return report.page("Validation", blocks)


def markdown(rows: Sequence[Row]) -> str:
    """The tables as a page of the guide."""
    parts = [
        "# Validation",
        "",
        "What the library computes beside formulas, tables and programs of others. `mdrcontact validate --full --markdown FILE`",
        'writes this page, `--html FILE` the same with a picture of each row; `pip install "mdrcontact[validate]"` brings',
        "the finite elements. The command at the end of a row repeats it.",
        "",
        *_table([TITLES, *([*r.cells()[:-1], f"`{r.cells()[-1]}`"] for r in rows)]),
        "",
        f"Programs: {', '.join(programs())}. Half-spaces and layers against ContactMechanics: [clients](clients.md).",
        "",
        "## What each model is good for",
        "",
        *_table(limits.models()),
        "",
        "## Where the library ends",
        "",
        *_table(limits.refusals()),
        "",
    ]
    return "\n".join(parts)


def _table(rows: Sequence[Sequence[str]]) -> list[str]:
    lines = ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]
    return [lines[0], "|" + "---|" * len(rows[0]), *lines[1:]]


def _figure(row: Row) -> Any:
    figure_class = importlib.import_module("matplotlib.figure").Figure
    figure = figure_class(figsize=(9.0, 3.2), layout="constrained")
    left, right = figure.subplots(1, 2)
    found = row.found
    assert found is not None
    left.plot(found.x, found.there, "o", mfc="none", label=row.check.source)
    left.plot(found.x, found.here, "+", label="mdrcontact")
    left.set(xlabel=found.x_name, title=row.check.capability)
    left.legend()
    off = np.maximum(np.abs(found.here - found.there) / found.scale, 1e-17)
    right.semilogy(found.x, off, ".")
    right.axhline(row.check.error, color="0.5", ls="--")
    right.set(xlabel=found.x_name, ylabel="deviation")
    right.set_title(f"bound: {row.check.whose}", fontsize="small")
    return figure
