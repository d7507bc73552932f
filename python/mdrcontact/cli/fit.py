# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact fit`: film properties from measured curves."""

from __future__ import annotations

import argparse
import functools
import io
import json
from pathlib import Path
from typing import Any

import numpy as np
from tqdm import tqdm

from ..errors import MDRError
from ..fitting import FailedFit, FitResult, compare_models, fit, fit_many
from ..fitting.quantities import dimension_of, dimension_of_data
from ..problem import ProblemError
from ..problem.fit_file import FitFile, load_fit_file
from ..problem.units import RATIO, practical
from . import files
from .table import Column, aligned, as_csv, column, number

_DESCRIPTION = """\
Fits indenter, film, substrate and instrument to a measured curve, or to every curve of a folder, and gives intervals.

    mdrcontact fit curve.csv --problem problem.toml
    mdrcontact fit curve.csv --problem problem.toml --json fit.json --plot fit.png --csv points.csv
    mdrcontact fit curves/ --problem problem.toml --csv estimates.csv

The data are CSV or TSV with a header that names the columns and their units: "depth [nm]", "load (mN)", "h_nm", "S_N_per_m". The
problem file is that of `mdrcontact curve` with two more tables in place of [compute], and if needed [instrument]:

    [data]
    kind = "force-depth"            # stiffness-depth, modulus-radius, stiffness-radius
    force = "P_mN"                  # columns, where their names do not say it already
    relative_sd = 0.01              # or sd = "column"; without either it is estimated
    max_depth = "100 nm"            # fit a part of the curve

    [instrument]                    # all optional
    work_of_adhesion = "50 mJ/m^2"
    frame_compliance = "0.2 nm/mN"
    indenter = { E = "1070 GPa", nu = 0.07 }        # its own compliance, for stiffness and modulus data

    [fit.free]                      # or free = ["coating.E"] in [fit]
    "coating.E" = { lower = "1 GPa" }
    thickness = { prior = "500 nm", prior_sd = "10 nm" }
    depth_offset = {}

In a folder each .csv, .tsv and .txt file is a curve; one that cannot be fitted is reported and does not stop the others.
"""

_SUFFIXES = (".csv", ".tsv", ".txt")


def add(subparsers: Any) -> None:
    """Adds the command to the command line."""
    parser = subparsers.add_parser(
        "fit",
        help="film properties from measured curves, with intervals",
        description=_DESCRIPTION,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("data", type=Path, metavar="DATA", help="a CSV or TSV file, or a folder of them")
    parser.add_argument("--problem", type=Path, required=True, metavar="PROBLEM.toml", help="indenter, medium, data and fit")
    files.add_options(parser, "points and residuals, or for a folder the estimates")
    parser.add_argument("--json", type=Path, metavar="FILE.json", help="write everything about the result as JSON")
    parser.add_argument("--compare", action="store_true", help="fit under every medium model as well, and rank them")
    parser.add_argument(
        "--interval",
        choices=("normal", "profile", "monte-carlo"),
        default="normal",
        help="how intervals are found (default: normal, from the standard error)",
    )
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> None:
    """Fits, prints, writes."""
    files.check(arguments.csv, arguments.plot, arguments.json, overwrite=arguments.overwrite)
    if arguments.plot:
        from . import figures

        figures.require(arguments.plot)
    problem = load_fit_file(arguments.problem)
    print(f"{problem.title}\n")
    if arguments.data.is_dir():
        _run_folder(arguments, problem)
    else:
        _run_one(arguments, problem)


def _run_one(arguments: argparse.Namespace, problem: FitFile) -> None:
    data, notes = problem.read_data(arguments.data)
    print("\n".join([str(arguments.data), *(f"  {note}" for note in notes)]))
    print(f"  indenter: {problem.indenter!r}\n  medium: {problem.medium!r}\n")
    result = fit(data, problem.indenter, problem.medium, problem.free, instrument=problem.instrument, **problem.options)
    print(result.summary())
    intervals = {}
    if arguments.interval != "normal":
        with tqdm(total=len(result.names), unit="intervals", delay=2.0, disable=None, leave=False) as bar:
            for name in result.names:
                intervals[name] = result.interval(name, method=arguments.interval, seed=0)
                bar.update()
        for name, (lower, upper) in intervals.items():
            print(f"{arguments.interval} 95 % interval of {name}: {number(lower)} to {number(upper)}")
    if arguments.compare:
        ranking = compare_models(
            data, problem.indenter, problem.medium, problem.free, instrument=problem.instrument, **problem.options
        )
        print(f"\n{ranking.summary()}")
    results: dict[Path, bytes] = {}
    if arguments.csv:
        results[arguments.csv] = as_csv(_points(result))
    if arguments.json:
        found = result.to_dict()
        found["file"] = str(arguments.data)
        for name, ends in intervals.items():
            found["parameters"][name][f"{arguments.interval}_interval"] = [v if np.isfinite(v) else None for v in ends]
        results[arguments.json] = (json.dumps(found, indent=2, allow_nan=False) + "\n").encode()
    if arguments.plot:
        results[arguments.plot] = _rendered(result.plot(), files.figure_format(arguments.plot))
    if results:
        print()
        files.write(results, arguments.overwrite)


def _points(result: FitResult) -> list[Column]:
    data = result.data
    x, y = dimension_of_data(data.x_name), dimension_of_data(data.y_name)
    unit = practical(y, data.y)
    return [
        column(data.x_name, data.x, x),
        Column(data.y_name, data.y, unit),
        Column("fit", result.fitted, unit),
        column("residual/sd", result.residuals, RATIO),
    ]


def _rendered(figure: Any, form: str) -> bytes:
    buffer = io.BytesIO()
    figure.savefig(buffer, format=form, dpi=160)
    return buffer.getvalue()


def _run_folder(arguments: argparse.Namespace, problem: FitFile) -> None:
    paths = sorted(p for p in arguments.data.iterdir() if p.suffix.lower() in _SUFFIXES and p.is_file())
    if not paths:
        raise ProblemError(f"{arguments.data}: there is no file that ends in {', '.join(_SUFFIXES)}")
    _, notes = _first_readable(problem, paths)
    print("\n".join([f"{len(paths)} curves in {arguments.data}; columns as in", *(f"  {note}" for note in notes)]))
    tasks = [functools.partial(_only_data, problem, path) for path in paths]
    with tqdm(total=len(paths), unit="curves", delay=2.0, disable=None, leave=False) as bar:
        results = fit_many(
            tasks,
            problem.indenter,
            problem.medium,
            problem.free,
            instrument=problem.instrument,
            progress=lambda done: bar.update(),
            **problem.options,
        )
    good = [(path, r) for path, r in zip(paths, results, strict=True) if isinstance(r, FitResult)]
    for path, result in zip(paths, results, strict=True):
        if isinstance(result, FailedFit):
            print(f"not fitted: {path.name}: {result.error}")
        elif not result.converged:
            print(f"not converged: {path.name}")
    if not good:
        raise MDRError("no curve could be fitted")
    names = good[0][1].names
    print(f"\n{len(good)} of {len(paths)} curves fitted")
    rows = [["parameter", "median", "mean", "scatter", "median standard error"]]
    for name in names:
        unit = practical(dimension_of(name), [abs(r.estimates[name]) for _, r in good])
        v = np.array([r.estimates[name] for _, r in good]) / unit.factor
        errors = np.array([r.standard_errors[name] for _, r in good]) / unit.factor
        scatter = float(v.std(ddof=1)) if len(v) > 1 else float("nan")
        title = f"{name} [{unit.name}]" if unit.name else name
        rows.append([title, *(number(float(x)) for x in (np.median(v), v.mean(), scatter, np.median(errors)))])
    print(aligned(rows, left=1))
    _write_folder(arguments, paths, results, good, names)


def _first_readable(problem: FitFile, paths: list[Path]) -> tuple[Any, list[str]]:
    refusal: MDRError | None = None
    for path in paths:
        try:
            return problem.read_data(path)
        except MDRError as problem_of_file:
            refusal = refusal or problem_of_file
    assert refusal is not None
    raise refusal


def _only_data(problem: FitFile, path: Path) -> Any:
    return problem.read_data(path)[0]


def _write_folder(
    arguments: argparse.Namespace, paths: list[Path], results: list[Any], good: list[tuple[Path, FitResult]], names: tuple[str, ...]
) -> None:
    contents: dict[Path, bytes] = {}
    if arguments.csv:
        table = []
        for name in names:
            unit = practical(dimension_of(name), [abs(r.estimates[name]) for _, r in good])
            table.append(Column(name, np.array([r.estimates[name] for _, r in good]), unit))
            table.append(Column(f"standard error of {name}", np.array([r.standard_errors[name] for _, r in good]), unit))
        table.append(column("converged", np.array([float(r.converged) for _, r in good]), RATIO))
        contents[arguments.csv] = as_csv(table, ("file", [path.name for path, _ in good]))
    if arguments.json:
        found = {
            path.name: result.to_dict() if isinstance(result, FitResult) else {"error": str(result.error)}
            for path, result in zip(paths, results, strict=True)
        }
        contents[arguments.json] = (json.dumps(found, indent=2, allow_nan=False) + "\n").encode()
    if arguments.plot:
        contents[arguments.plot] = _overview(good, names, files.figure_format(arguments.plot))
    if contents:
        print()
        files.write(contents, arguments.overwrite)


def _overview(good: list[tuple[Path, FitResult]], names: tuple[str, ...], form: str) -> bytes:
    """Each parameter over the number of the curve."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(6.4, 2.2 * len(names) + 0.6), layout="constrained")
    axes = np.atleast_1d(figure.subplots(len(names), 1, sharex=True))
    for axis, name in zip(axes, names, strict=True):
        unit = practical(dimension_of(name), [abs(r.estimates[name]) for _, r in good])
        v = [r.estimates[name] / unit.factor for _, r in good]
        errors = [1.96 * r.standard_errors[name] / unit.factor for _, r in good]
        axis.errorbar(range(1, len(v) + 1), v, errors, fmt=".", color="#0072B2", elinewidth=0.8)
        axis.set_ylabel(f"{name} [{unit.symbol}]" if unit.name else name)
        axis.spines[["top", "right"]].set_visible(False)
    axes[-1].set_xlabel("curve")
    return _rendered(figure, form)
