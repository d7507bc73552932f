# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact fit`: film properties from measured curves."""

from __future__ import annotations

import argparse
import csv
import functools
import io
import json
from pathlib import Path
from typing import Any

import numpy as np
from tqdm import tqdm

from ..errors import MDRError
from ..fitting import FailedFit, FitResult, compare_models, fit, fit_many
from ..fitting.quantities import dimension_of, dimension_of_data, measured, words_of
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

The data are tables as instruments write them: text (UTF-8, UTF-16, Latin-1; tabs, semicolons, commas or spaces; decimal point or
comma) or .xlsx. A line names the columns and their units, as in "depth [nm]", "load (mN)", "h_nm", "S_N_per_m", or a row of units
follows it; lines before it are passed over. What a table does not say, [data] does: columns = ["depth [nm]", "load [mN]"] without a
header, units = { Depth = "nm" }, skip = 3 lines, sheet = "Test 1". What was understood is printed.

The problem file is that of `mdrcontact curve` with two more tables in place of [compute], and if needed [instrument]:

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

In a folder each .csv, .tsv, .txt, .dat and .xlsx file is a curve; one that cannot be fitted is a row with its reason.
"""

_SUFFIXES = (".csv", ".tsv", ".txt", ".dat", ".xlsx", ".xlsm")
_MOST_WARNINGS, _MOST_NAMES = 10, 40
"""On the screen, and under a picture."""


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
    if not good:
        failures = [(path, r) for path, r in zip(paths, results, strict=True) if isinstance(r, FailedFit)]
        reasons = "; ".join(f"{path.name}: {r.error}" for path, r in failures[:3])
        raise MDRError(f"no curve could be fitted: {reasons}")
    names = good[0][1].names
    print(aligned(_rows_of(paths, results, names), left=1))
    for path, result in zip(paths, results, strict=True):
        if isinstance(result, FailedFit):
            print(f"not fitted: {path.name}: {result.error}")
    described = sum(r.describes_data is not False and r.converged for _, r in good)
    print(f"\n{len(good)} of {len(paths)} curves fitted; {described} of {len(paths)} fits describe their data")
    warned = [(path, words) for path, r in good for words in r.warnings]
    for path, words in warned[:_MOST_WARNINGS]:
        print(f"warning: {path.name}: {words}")
    if len(warned) > _MOST_WARNINGS:
        print(f"and {len(warned) - _MOST_WARNINGS} more warnings: --json and --csv have them all")
    rows = [["between the curves", "median", "mean", "scatter", "median standard error", "scatter/error"]]
    for name in names:
        unit = practical(dimension_of(name), [abs(r.estimates[name]) for _, r in good])
        v = np.array([r.estimates[name] for _, r in good]) / unit.factor
        errors = np.array([r.standard_errors[name] for _, r in good]) / unit.factor
        scatter, error = float(v.std(ddof=1)) if len(v) > 1 else float("nan"), float(np.median(errors))
        title = f"{words_of(name)} [{unit.name}]" if unit.name else words_of(name)
        ratio = f"{scatter / error:.2g}" if error > 0.0 and np.isfinite(scatter) else "-"
        rows.append([title, *(number(float(x)) for x in (np.median(v), v.mean(), scatter, error)), ratio])
        if error > 0.0 and scatter > 2.0 * error:
            print(f"warning: {words_of(name)} scatters {ratio} times its errors: the curves differ, or errors are missing")
    print(aligned(rows, left=1))
    _write_folder(arguments, paths, results, good, names)


def _rows_of(paths: list[Path], results: list[Any], names: tuple[str, ...]) -> list[list[str]]:
    """One row for each file, failures too."""
    rows = [["file", *(words_of(name) for name in names), "chi-square/dof", "random with p", "describes its data"]]
    for path, result in zip(paths, results, strict=True):
        if isinstance(result, FailedFit):
            rows.append([path.name, *(len(names) * ["-"]), "-", "-", "not fitted"])
            continue
        told = [measured(name, result.estimates[name], result.standard_errors[name]) for name in names]
        ratio = f"{result.chi_square / result.degrees_of_freedom:.3g}" if result.noise_is_known else "-"
        verdict = {True: "yes", False: "NO", None: "too few points"}[result.describes_data]
        rows.append(
            [path.name, *told, ratio, f"{result.pattern_probability:.2g}", verdict if result.converged else "not converged"]
        )
    return rows


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
        contents[arguments.csv] = _estimates(paths, results, names)
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


def _estimates(paths: list[Path], results: list[Any], names: tuple[str, ...]) -> bytes:
    """A CSV file with one row for each curve; a failure is a row with its reason."""
    good = [r for r in results if isinstance(r, FitResult)]
    units = {name: practical(dimension_of(name), [abs(r.estimates[name]) for r in good]) for name in names}
    titles = [f"{t}{name} [{units[name].name}]".replace(" []", "") for name in names for t in ("", "standard error of ")]
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["file", *titles, "converged", "describes its data", "chi-square/dof", "pattern p", "warnings"])
    for path, r in zip(paths, results, strict=True):
        if isinstance(r, FailedFit):
            writer.writerow([path.name, *(len(titles) + 4) * [""], f"not fitted: {r.error}"])
            continue
        values = [float(v) / units[n].factor for n in names for v in (r.estimates[n], r.standard_errors[n])]
        ratio = repr(r.chi_square / r.degrees_of_freedom) if r.noise_is_known else ""
        marks = [int(r.converged), "" if r.describes_data is None else int(r.describes_data)]
        writer.writerow([path.name, *map(repr, values), *marks, ratio, repr(r.pattern_probability), "; ".join(r.warnings)])
    return text.getvalue().encode()


def _overview(good: list[tuple[Path, FitResult]], names: tuple[str, ...], form: str) -> bytes:
    """Each parameter curve by curve, and its histogram."""
    from matplotlib.figure import Figure

    height = max(2.4, 0.25 * len(good) if len(good) <= _MOST_NAMES else 4.0)
    figure = Figure(figsize=(9.0, height * len(names) + 0.6), layout="constrained")
    axes = np.atleast_2d(figure.subplots(len(names), 2, width_ratios=[3, 1], sharey="row"))
    for (each, histogram), name in zip(axes, names, strict=True):
        unit = practical(dimension_of(name), [abs(r.estimates[name]) for _, r in good])
        v = np.array([r.estimates[name] / unit.factor for _, r in good])
        places = np.arange(1, len(v) + 1)
        for describes, colour, label in ((True, "#0072B2", "describes its data"), (False, "#D55E00", "does not")):
            keep = np.array([(r.describes_data is not False and r.converged) == describes for _, r in good])
            if keep.any():
                errors = [1.96 * r.standard_errors[name] / unit.factor for (_, r), k in zip(good, keep, strict=True) if k]
                each.errorbar(places[keep], v[keep], errors, fmt=".", color=colour, elinewidth=0.8, label=label)
        each.set_ylabel(f"{words_of(name)} [{unit.symbol}]" if unit.name else words_of(name))
        if len(v) <= _MOST_NAMES:
            each.set_xticks(places, [path.name for path, _ in good], rotation=90, fontsize=7)
        else:
            each.set_xlabel("curve")
        histogram.hist(v, bins="auto" if len(v) > 1 else 1, orientation="horizontal", color="#0072B2", alpha=0.6)
        histogram.set_xlabel("curves")
        for axis in (each, histogram):
            axis.spines[["top", "right"]].set_visible(False)
    axes[0][0].legend(frameon=False, fontsize=8)
    return _rendered(figure, form)
