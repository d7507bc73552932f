# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact fit`: film properties from measured curves."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import numpy as np

from .. import _progress
from .._text import aligned, listed, number
from .._units import AREA, FORCE, LENGTH, MODULUS, QUANTITIES, RATIO, STIFFNESS, practical
from ..instruments.files.curves import Curve
from ..instruments.files.fit_file import FitFile, load_fit_file
from ..instruments.fitting import (
    FitResult,
    OliverPharr,
    StiffnessDepth,
    compare_drainages,
    compare_models,
    find_moves,
    fit,
    fit_gel,
    oliver_pharr,
    report,
)
from ..instruments.fitting.quantities import digits
from ..problem import ProblemError
from ..studies.result import Column, column
from . import files, fit_many
from .table import as_csv

HELP = "film properties from measured curves, with intervals"

_ANALYSIS = "Oliver and Pharr on the fitted body, standard errors of the stiffness alone"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    data, says = "a table, an AFM file, or a folder of them", "indenter, medium, data and fit"
    files.add_fit(parser, "points and residuals, or for a folder the estimates", data, says)
    words = "draw how far the modulus moves with range, branch and contact point, of one curve"
    parser.add_argument("--ranges", type=Path, metavar="FILE.png", help=words)
    parser.add_argument("--keep-all", action="store_true", help="of a folder or map: let doubtful curves into the mean, too")
    parser.add_argument("--compare", action="store_true", help="fit under every medium model as well, and rank them")
    parser.add_argument(
        "--interval",
        choices=("normal", "profile", "monte-carlo"),
        default="normal",
        help="how intervals are found (default: normal, from the standard error)",
    )


def run(arguments: argparse.Namespace) -> None:
    """Fits, prints, writes."""
    files.check(arguments)
    problem = load_fit_file(arguments.problem)
    print(f"{problem.title}\n")
    if arguments.data.is_dir():
        fit_many.run_folder(arguments, problem)
        return
    curves = problem.curves(arguments.data)
    if len(curves) > 1:
        fit_many.run_curves(arguments, problem, curves)
    else:
        _run_one(arguments, problem, curves[0])


def _run_one(arguments: argparse.Namespace, problem: FitFile, curve: Curve) -> None:
    data, notes = curve.read()
    print(listed(arguments.data, notes))
    print(f"  indenter: {problem.indenter!r}\n  medium: {problem.medium!r}\n")
    if problem.drainage is not None:
        _run_gel(arguments, problem, data)
        return
    with _progress.waiting("fit"):
        result = fit(data, **problem.arguments)
    analysis: list[list[str]] = []
    if isinstance(data, StiffnessDepth) and data.unloadings:
        analysis = oliver_pharr_rows(_analysis(result))
        print(f"{_ANALYSIS}:\n" + aligned(analysis, left=0) + "\n")
    print(result.summary())
    moves: Any = None
    if arguments.ranges or arguments.report:
        moves = find_moves(result)
        print("".join(f"{line}\n" for line in moves.summary()), end="")
    intervals = {}
    if arguments.interval != "normal":
        with _progress.bar(len(result.names), "intervals") as bar:
            for name in result.names:
                intervals[name] = result.interval(name, method=arguments.interval, seed=0)
                bar.update()
        for name, (lower, upper) in intervals.items():
            print(f"{arguments.interval} 95 % interval of {name}: {number(lower)} to {number(upper)}")
    ranking = None
    if arguments.compare:
        ranking = compare_models(data, **problem.arguments)
        print(f"\n{ranking.summary()}")

    def numbers() -> dict[str, Any]:
        found = {**result.to_dict(), "file": str(arguments.data)}
        for name, ends in intervals.items():
            found["parameters"][name][f"{arguments.interval}_interval"] = [v if np.isfinite(v) else None for v in ends]
        return found

    def describe() -> str:
        blocks = report.blocks_of(result, [f"file {arguments.data}, problem file {arguments.problem}", *notes])
        if analysis:
            blocks += [report.heading(_ANALYSIS), report.table(analysis)]
        if moves.summary():
            blocks += [report.heading("Other choices"), report.items(moves.summary()), report.picture(moves.plot(), "other ranges")]
        if ranking is not None:
            blocks += [report.heading("Models"), report.preformatted(ranking.summary())]
        return report.page(problem.title, blocks)

    files.write(
        arguments,
        csv=lambda: as_csv(_points(result)),
        json=numbers,
        plot=result.plot,
        ranges=lambda: moves.plot(),
        report=describe,
    )


def _run_gel(arguments: argparse.Namespace, problem: FitFile, data: Any) -> None:
    """A gel, under the drainage of the file; --compare shows all three."""
    for name in ("plot", "report", "ranges"):
        if getattr(arguments, name):
            raise ProblemError(f"--{name} is not offered for gels: --csv has the points, --json the numbers")
    found = fit_gel(data, problem.indenter, problem.medium, list(problem.free), drainage=str(problem.drainage))
    print(found.summary())
    if arguments.compare:
        for other in compare_drainages(data, problem.indenter, problem.medium, list(problem.free)):
            print(f"\n{other.summary()}")
    parameters = {
        name: {"value": value, "standard_error": found.errors[name], "interval": list(found.intervals[name])}
        for name, value in found.values.items()
    }
    files.write(
        arguments,
        csv=lambda: as_csv(_columns(data, found.fitted)),
        json=lambda: {
            "drainage": found.drainage,
            "sum_of_squares": found.chi_square,
            "notes": list(found.notes),
            "parameters": parameters,
        },
    )


def _analysis(result: FitResult) -> OliverPharr:
    """Contact depth and area on the body that was found."""
    return oliver_pharr(result.data, result.indenter, result.instrument, medium=result.medium)  # type: ignore[arg-type]


def oliver_pharr_columns(found: OliverPharr) -> list[Column]:
    """Oliver and Pharr's numbers as columns with standard errors."""
    kinds = (("contact_depth", LENGTH), ("area", AREA), ("reduced_modulus", MODULUS), ("hardness", MODULUS))
    columns = [column("depth", found.depth, LENGTH), column("force", found.force, FORCE)]
    for name, dimension in (("stiffness", STIFFNESS), *kinds):
        values, unit = getattr(found, name), practical(dimension, getattr(found, name))
        columns.append(Column(name.replace("_", " "), values, unit))
        columns.append(Column("standard error", getattr(found, f"{name}_error"), unit))
    return columns


def oliver_pharr_rows(found: OliverPharr) -> list[list[str]]:
    """The same as words, one row for each point."""
    columns = oliver_pharr_columns(found)
    rows = [[c.title for c in columns if c.name != "standard error"]]
    for i in range(len(found.depth)):
        cells = []
        for c, error in zip(columns, [*columns[1:], None], strict=True):
            value = float(c.unit.of(c.values[i]))
            if c.name == "standard error":
                continue
            if error is None or error.name != "standard error":
                cells.append(number(value))
            else:
                sd = float(error.unit.of(error.values[i]))
                cells.append(f"{digits(value, sd)} ± {digits(sd, sd)}")
        rows.append(cells)
    return rows


def _points(result: FitResult) -> list[Column]:
    data = result.data
    if isinstance(data, StiffnessDepth) and data.unloadings:
        return oliver_pharr_columns(_analysis(result))
    return [*_columns(data, result.fitted), column("residual/sd", result.residuals, RATIO)]


def _columns(data: Any, fitted: np.ndarray[Any, Any]) -> list[Column]:
    """Data and model."""
    x, y = QUANTITIES[data.x_name], QUANTITIES[data.y_name]
    unit = practical(y, data.y)
    return [column(data.x_name, data.x, x), Column(data.y_name, data.y, unit), Column("fit", fitted, unit)]
