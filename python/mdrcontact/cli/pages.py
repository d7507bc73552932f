# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of studies as HTML files."""

from __future__ import annotations

from collections.abc import Sequence

from .._text import html_table
from ..instruments.fitting import GelFit, report
from ..instruments.fitting.quantities import measured, words_of
from ..studies.calibrate import CalibrateResult
from ..studies.fit import FittedCurve
from ..studies.many import FittedCurves
from ..studies.modulus import ModulusResult
from ..studies.result import Column
from .table import as_rows, with_errors

ANALYSIS = "Oliver and Pharr on the fitted body, standard errors of the stiffness alone"


def fit_page(found: FittedCurve, read: Sequence[str], origin: Sequence[str] = ()) -> str:
    """Return the page of one fit, with other choices and models. read : notes on the file; origin : blocks of `report.origin`"""
    blocks = report.blocks_of_gel(found.fit, read) if isinstance(found.fit, GelFit) else report.blocks_of(found.fit, read)
    if found.analysis is not None:
        blocks += [report.heading(ANALYSIS), html_table(as_rows(with_errors(found.tables["points"])))]
    if found.moves is not None and (lines := found.moves.summary()):
        blocks += [report.heading("Other choices"), report.items(lines), report.picture(found.moves.plot(), "other ranges")]
    if "models" in found.notes:
        words = "Drainages" if found.drainages else "Models"
        blocks += [report.heading(words), report.preformatted(found.notes["models"])]
    return report.page(found.title, [*blocks, *origin])


def calibrate_page(found: CalibrateResult, read: Sequence[str], origin: Sequence[str] = ()) -> str:
    """Return the page of a calibration. read : names of the tests"""
    blocks = report.blocks_of(found.fit, read)
    blocks += [report.heading("Agreement of the tests"), report.items(found.doubts, doubt=True)] if found.doubts else []
    return report.page(found.title, [*blocks, *origin])


def many_page(found: FittedCurves, origin: Sequence[str] = ()) -> str:
    """Return the page of the fits of many curves."""
    blocks = [report.paragraph(words) for words in found.notes.values()]
    blocks += [html_table(as_rows(found.tables["spread"]))] if "spread" in found.tables else []
    blocks += [report.picture(found.figure(), "estimates of all curves")]
    blocks += [report.items(found.doubts, doubt=True), report.heading("Curves"), html_table(as_rows(found.tables["curves"]))]
    blocks += [report.heading("What was assumed, for the first curve"), report.assumptions(found.fitted[0].fit)]
    return report.page(found.title, [*blocks, *origin])


def modulus_page(found: ModulusResult, read: Sequence[str], origin: Sequence[str] = ()) -> str:
    """Return the page of a modulus against depth. read : notes on the file"""
    problem, profile = found.problem, found.profile
    columns = [c for c in found.tables["points"] if isinstance(c, Column)]
    rows = [[c.title for c in columns]]
    rows += [[f"{float(c.unit.of(c.values[i])):.5g}" for c in columns] for i in range(len(profile.modulus))]
    notes = [report.paragraph(line) for note in found.notes.values() for line in note.splitlines()]
    blocks = [*notes, report.picture(found.figure(), "modulus and hardness against depth")]
    blocks += [report.heading("Warnings"), report.items(found.doubts, doubt=True) if found.doubts else report.paragraph("None.")]
    blocks += [report.heading("What was read"), report.items(read)]
    assumed = [f"indenter: {problem.indenter!r}", f"medium: {problem.medium!r}", f"instrument: {problem.instrument!r}"]
    priors = [f"{words_of(n)}: {measured(n, *f.prior)}" for n, f in problem.free.items() if f.prior]
    blocks += [report.heading("What was assumed"), report.items([*assumed, *priors])]
    blocks += [report.heading("Points"), html_table(rows)]
    return report.page(found.title, [*blocks, *origin])
