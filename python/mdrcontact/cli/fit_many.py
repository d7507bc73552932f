# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact fit` on many curves: a folder, or a file with a map."""

from __future__ import annotations

import argparse
import csv
import functools
import io
import json
from pathlib import Path
from typing import Any

import numpy as np

from .. import _progress
from ..errors import MDRError
from ..fitting import FailedFit, FitResult, fit_many, report
from ..fitting.quantities import dimension_of, words_of
from ..problem.data import Curve
from ..problem.fit_file import FitFile
from ..problem.units import practical
from . import files, many_figure
from .table import aligned, number

_MOST_WARNINGS, _MOST_ROWS = 10, 300
"""On the screen."""


def run_folder(arguments: argparse.Namespace, problem: FitFile) -> None:
    """Fits every curve of a folder."""
    paths = files.data_files(arguments.data)
    curves: list[Curve] = []
    with _progress.bar(len(paths), "files") as bar:
        for path in paths:
            try:
                curves += problem.curves(path)
            except MDRError as refusal:
                curves.append(Curve(path.name, functools.partial(_refuse, refusal)))
            bar.update()
    run_curves(arguments, problem, curves)


def _refuse(refusal: MDRError) -> Any:
    raise refusal


def run_curves(arguments: argparse.Namespace, problem: FitFile, curves: list[Curve]) -> None:
    """Fits each curve and reports all of them."""
    print("\n".join([f"{len(curves)} curves in {arguments.data}; as in", *(f"  {note}" for note in _first_notes(curves))]))
    tasks = [functools.partial(_only_data, curve) for curve in curves]
    with _progress.bar(len(curves), "curves") as bar:
        results = fit_many(
            tasks,
            problem.indenter,
            problem.medium,
            problem.free,
            instrument=problem.instrument,
            progress=lambda done: bar.update(),
            **problem.options,
        )
    good = [(curve, r) for curve, r in zip(curves, results, strict=True) if isinstance(r, FitResult)]
    failed = [f"not fitted: {c.name}: {r.error}" for c, r in zip(curves, results, strict=True) if isinstance(r, FailedFit)]
    if not good:
        raise MDRError(f"no curve could be fitted: {'; '.join(failed[:3])}")
    names = good[0][1].names
    rows = _rows_of(curves, results, names)
    described = sum(r.describes_data is True and r.converged for _, r in good)
    unknown = sum(r.describes_data is None for _, r in good)
    verdict = f"{len(good)} of {len(curves)} curves fitted; {described} of {len(curves)} fits describe their data"
    if unknown:
        verdict += f", {unknown} have too few points to say"
    warned = [f"{curve.name}: {words}" for curve, r in good for words in r.warnings]
    spread, warned_of_spread = _spread([r for _, r in good], names)
    if len(rows) <= _MOST_ROWS:
        print("\n".join([aligned(rows, left=1), *failed]))
    print(f"\n{verdict}")
    for words in [*warned_of_spread, *warned[:_MOST_WARNINGS]]:
        print(f"warning: {words}")
    if len(warned) > _MOST_WARNINGS:
        print(f"and {len(warned) - _MOST_WARNINGS} more warnings: --report, --json and --csv have them all")
    print(aligned(spread, left=1))
    contents: dict[Path, bytes] = {}
    if arguments.csv:
        contents[arguments.csv] = _estimates(curves, results, names)
    if arguments.json:
        found = {
            curve.name: result.to_dict() if isinstance(result, FitResult) else {"error": str(result.error)}
            for curve, result in zip(curves, results, strict=True)
        }
        contents[arguments.json] = (json.dumps(found, indent=2, allow_nan=False) + "\n").encode()
    if arguments.plot:
        contents[arguments.plot] = files.rendered(many_figure.overview(good, names), files.figure_format(arguments.plot))
    if arguments.report:
        blocks = [report.paragraph(verdict, doubt=described + unknown < len(curves)), report.table(spread)]
        blocks += [report.picture(many_figure.overview(good, names), "estimates of all curves")]
        blocks += [report.items([*warned_of_spread, *failed, *warned], doubt=True), report.heading("Curves"), report.table(rows)]
        blocks += [report.heading("What was assumed, for the first curve"), report.assumptions(good[0][1])]
        contents[arguments.report] = report.page(problem.title, blocks).encode()
    files.write(contents, arguments.overwrite)


def _spread(good: list[FitResult], names: tuple[str, ...]) -> tuple[list[list[str]], list[str]]:
    """The scatter between the curves against their own errors, and what is striking in it."""
    rows, words = [["between the curves", "median", "mean", "scatter", "median standard error", "scatter/error"]], []
    for name in names:
        unit = practical(dimension_of(name), [abs(r.estimates[name]) for r in good])
        v = np.array([r.estimates[name] for r in good]) / unit.factor
        errors = np.array([r.standard_errors[name] for r in good]) / unit.factor
        scatter, error = float(v.std(ddof=1)) if len(v) > 1 else float("nan"), float(np.median(errors))
        title = f"{words_of(name)} [{unit.name}]" if unit.name else words_of(name)
        ratio = f"{scatter / error:.2g}" if error > 0.0 and np.isfinite(scatter) else "-"
        rows.append([title, *(number(float(x)) for x in (np.median(v), v.mean(), scatter, error)), ratio])
        if error > 0.0 and scatter > 2.0 * error:
            words.append(f"{words_of(name)} scatters {ratio} times its errors: the curves differ, or errors are missing")
    return rows, words


def _rows_of(curves: list[Curve], results: list[Any], names: tuple[str, ...]) -> list[list[str]]:
    """One row for each file, failures too."""
    rows = [["file", *(words_of(name) for name in names), "chi-square/dof", "random with p", "describes its data"]]
    for curve, result in zip(curves, results, strict=True):
        if isinstance(result, FailedFit):
            rows.append([curve.name, *(len(names) * ["-"]), "-", "-", "not fitted"])
            continue
        told = [result.told(name) for name in names]
        can_say = result.describes_data is not None
        ratio = f"{result.reduced_chi_square:.3g}" if result.noise_is_known and can_say else "-"
        random = f"{result.pattern_probability:.2g}" if can_say else "-"
        verdict = {True: "yes", False: "NO", None: "too few points"}[result.describes_data]
        rows.append([curve.name, *told, ratio, random, verdict if result.converged else "not converged"])
    return rows


def _first_notes(curves: list[Curve]) -> list[str]:
    """What was understood of the first curve that can be read."""
    refusal: MDRError | None = None
    for curve in curves:
        try:
            return [curve.name, *curve.read()[1]]
        except MDRError as of_curve:
            refusal = refusal or of_curve
    assert refusal is not None
    raise refusal


def _only_data(curve: Curve) -> Any:
    return curve.read()[0]


def _estimates(curves: list[Curve], results: list[Any], names: tuple[str, ...]) -> bytes:
    """A CSV file with one row for each curve; a failure is a row with its reason."""
    good = [r for r in results if isinstance(r, FitResult)]
    units = {name: practical(dimension_of(name), [abs(r.estimates[name]) for r in good]) for name in names}
    titles = [f"{t}{name} [{units[name].name}]".replace(" []", "") for name in names for t in ("", "standard error of ")]
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["file", *titles, "converged", "describes its data", "chi-square/dof", "pattern p", "warnings"])
    for curve, r in zip(curves, results, strict=True):
        if isinstance(r, FailedFit):
            writer.writerow([curve.name, *(len(titles) + 4) * [""], f"not fitted: {r.error}"])
            continue
        values = [float(v) / units[n].factor for n in names for v in (r.estimates[n], r.standard_errors[n])]
        ratio = repr(r.reduced_chi_square) if r.noise_is_known and r.degrees_of_freedom >= 1.0 else ""
        marks = [int(r.converged), "" if r.describes_data is None else int(r.describes_data)]
        writer.writerow([curve.name, *map(repr, values), *marks, ratio, repr(r.pattern_probability), "; ".join(r.warnings)])
    return text.getvalue().encode()
