# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact modulus`: the film's modulus at every depth of a dynamic measurement, and at zero depth."""

from __future__ import annotations

import argparse
import math
from typing import Any

import numpy as np

from .. import _progress
from .._text import listed
from .._units import LENGTH, MODULUS, RATIO, practical
from ..instruments.files.fit_file import FitFile, load_fit_file
from ..instruments.fitting import DepthProfile, StiffnessDepth, modulus_at_depths, report
from ..instruments.fitting.quantities import dimension_of, measured, words_of
from ..problem import ProblemError
from ..studies.result import Column, column
from . import files
from .table import as_csv, as_text

HELP = "film modulus against depth from dynamic (CSM) data, and at zero depth"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    files.add_fit(parser, "the modulus at each depth", "a table of depth, force and stiffness", "tip, medium, data and fit")


def run(arguments: argparse.Namespace) -> None:
    """Computes, prints, writes."""
    files.check(arguments)
    problem = load_fit_file(arguments.problem)
    print(f"{problem.title}\n")
    data, notes = problem.read_data(arguments.data)
    print(listed(arguments.data, notes))
    if not isinstance(data, StiffnessDepth):
        raise ProblemError('[data]: kind must be "stiffness-depth"')
    with _progress.bar(len(data), "points") as bar:
        profile = modulus_at_depths(
            data,
            problem.indenter,
            problem.medium,
            problem.free,
            instrument=problem.instrument,
            known=problem.options.get("known", ()),
            progress=lambda done: bar.update(),
        )
    thickness = getattr(getattr(problem.medium, "lower", problem.medium), "thickness", None)
    columns = _columns(profile, thickness)
    words = [*data.warnings, *profile.warnings]
    print(f"\n{as_text(columns, 20)}\n\n{profile.summary()}")
    for word in words:
        print(f"warning: {word}")
    files.write(
        arguments,
        csv=lambda: as_csv(columns),
        json=lambda: _plain(profile, words),
        plot=profile.plot,
        report=lambda: _report(problem, profile, columns, words, [f"file {arguments.data}", *notes]),
    )


def _report(problem: FitFile, profile: DepthProfile, columns: list[Column], warnings: list[str], read: list[str]) -> str:
    """All of it as one page."""
    rows = [[c.title for c in columns]]
    rows += [[f"{float(c.unit.of(c.values[i])):.5g}" for c in columns] for i in range(len(profile.modulus))]
    blocks = [report.paragraph(profile.summary()), report.picture(profile.plot(), "modulus against depth")]
    blocks += [report.heading("Warnings"), report.items(warnings, doubt=True) if warnings else report.paragraph("None.")]
    blocks += [report.heading("What was read"), report.items(read)]
    assumed = [f"indenter: {problem.indenter!r}", f"medium: {problem.medium!r}", f"instrument: {problem.instrument!r}"]
    priors = [f"{words_of(n)}: {measured(n, *f.prior)}" for n, f in problem.free.items() if f.prior]
    blocks += [report.heading("What was assumed"), report.items([*assumed, *priors])]
    blocks += [report.heading("Points"), report.table(rows)]
    return report.page(problem.title, blocks)


def _columns(profile: DepthProfile, thickness: float | None) -> list[Column]:
    found = profile.analysis
    unit = practical(dimension_of(profile.name), profile.modulus[np.isfinite(profile.modulus)])
    columns = [column("depth", found.depth, LENGTH), column("contact depth", found.contact_depth, LENGTH)]
    columns.append(column("contact radius a", found.radius, LENGTH))
    if thickness is not None:
        columns.append(column("a/h", found.radius / thickness, RATIO))
    columns += [column("E_r", found.reduced_modulus, MODULUS), column("hardness", found.hardness, MODULUS)]
    columns.append(Column(words_of(profile.name), profile.modulus, unit))
    columns.append(Column("standard error", profile.standard_error, unit))
    columns.append(Column("common error", profile.common_error, unit))
    return columns


def _plain(profile: DepthProfile, words: list[str]) -> dict[str, Any]:
    def numbers(values: Any) -> list[float | None]:
        return [float(v) if math.isfinite(v) else None for v in values]

    return {
        "parameter": profile.name,
        "unit": dimension_of(profile.name).si,
        "at_zero": profile.at_zero,
        "at_zero_error": profile.at_zero_error,
        "interval": list(profile.interval),
        "slope": profile.slope,
        "slope_error": profile.slope_error,
        "depth": numbers(profile.analysis.depth),
        "radius": numbers(profile.analysis.radius),
        "modulus": numbers(profile.modulus),
        "standard_error": numbers(profile.standard_error),
        "common_error": numbers(profile.common_error),
        "warnings": words,
    }
