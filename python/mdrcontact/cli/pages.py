# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of studies as HTML files."""

from __future__ import annotations

from collections.abc import Sequence

from ..instruments.fitting import report
from ..instruments.fitting.quantities import measured, words_of
from ..studies.modulus import ModulusResult
from ..studies.result import Column


def modulus_page(found: ModulusResult, read: Sequence[str]) -> str:
    """Everything about a modulus against depth. read : what was understood of the file"""
    problem, profile = found.problem, found.profile
    columns = [c for c in found.tables["points"] if isinstance(c, Column)]
    rows = [[c.title for c in columns]]
    rows += [[f"{float(c.unit.of(c.values[i])):.5g}" for c in columns] for i in range(len(profile.modulus))]
    blocks = [report.paragraph(profile.summary()), report.picture(profile.plot(), "modulus against depth")]
    blocks += [report.heading("Warnings"), report.items(found.doubts, doubt=True) if found.doubts else report.paragraph("None.")]
    blocks += [report.heading("What was read"), report.items(read)]
    assumed = [f"indenter: {problem.indenter!r}", f"medium: {problem.medium!r}", f"instrument: {problem.instrument!r}"]
    priors = [f"{words_of(n)}: {measured(n, *f.prior)}" for n, f in problem.free.items() if f.prior]
    blocks += [report.heading("What was assumed"), report.items([*assumed, *priors])]
    blocks += [report.heading("Points"), report.table(rows)]
    return report.page(found.title, blocks)
