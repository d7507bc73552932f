# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact fit` on many curves: a folder, or a file with a map."""

from __future__ import annotations

import argparse
import csv
import functools
import hashlib
import io
from typing import Any

import numpy as np

from .. import _progress
from .._text import aligned, listed, number
from .._units import ENERGY, FORCE, LENGTH, practical
from ..errors import MDRError
from ..instruments.files.curves import Curve
from ..instruments.files.fit_file import FitFile
from ..instruments.fitting import FailedFit, FitResult, Rating, fit_many, mean_of_tests, rate, report
from ..instruments.fitting.causes import by_cause
from ..instruments.fitting.misfit import percent
from ..instruments.fitting.quantities import digits, dimension_of, words_of
from . import files, many_figure

_WITHOUT_MODEL = {"jump-in": FORCE, "pull-off": FORCE, "last rupture": LENGTH, "energy lost": ENERGY}
"""What records say without a model, in columns of the table."""
_MOST_ROWS = 300
"""On the screen."""

_Fitted = tuple[Curve, FitResult]


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
    print(listed(f"{len(curves)} curves in {arguments.data}; as in", _first_notes(curves)))
    tasks = [functools.partial(_only_data, curve) for curve in curves]
    with _progress.bar(len(curves), "curves") as bar:
        results = fit_many(tasks, progress=lambda done: bar.update(), **problem.arguments)
    fitted = [(curve, r) for curve, r in zip(curves, results, strict=True) if isinstance(r, FitResult)]
    failed = [(c.name, f"not fitted: {r.error}") for c, r in zip(curves, results, strict=True) if isinstance(r, FailedFit)]
    if not fitted:
        raise MDRError(f"no curve could be fitted: {'; '.join(f'{name}: {words}' for name, words in failed[:3])}")
    names = fitted[0][1].names
    ratings = {id(r): rate(r) for _, r in fitted}
    sound = [(curve, r) for curve, r in fitted if arguments.keep_all or ratings[id(r)].is_sound]
    verdict = _verdict(len(curves), fitted, sound, ratings)
    warned = by_cause([*_copies(fitted), *((curve.name, words) for curve, r in fitted for words in r.warnings), *failed])
    spread, warned_of_spread = _spread([r for _, r in sound], names)
    rows = _rows_of(curves, results, names, ratings)
    if len(rows) <= _MOST_ROWS:
        print(aligned(rows, left=1))
    print("\n" + "\n".join(verdict))
    for words in [*warned_of_spread, *warned]:
        print(f"warning: {words}")
    if spread:
        print(aligned(spread, left=1))

    def draw() -> Any:
        drawn = tuple(name for name in names if name not in fitted[0][1].data.also_free)
        return many_figure.overview(fitted, drawn or names, {id(r) for _, r in sound})

    def describe() -> str:
        blocks = [report.paragraph(words) for words in verdict]
        blocks += [report.table(spread)] if spread else []
        blocks += [report.picture(draw(), "estimates of all curves")]
        blocks += [report.items([*warned_of_spread, *warned], doubt=True), report.heading("Curves"), report.table(rows)]
        blocks += [report.heading("What was assumed, for the first curve"), report.assumptions(fitted[0][1])]
        return report.page(problem.title, blocks)

    files.write(
        arguments,
        csv=lambda: _estimates(curves, results, names, ratings),
        json=lambda: {
            curve.name: result.to_dict() if isinstance(result, FitResult) else {"error": str(result.error)}
            for curve, result in zip(curves, results, strict=True)
        },
        plot=draw,
        report=describe,
    )


def _verdict(count: int, fitted: list[_Fitted], sound: list[_Fitted], ratings: dict[int, Rating]) -> list[str]:
    """How many curves are described, and which do not count."""
    described = sum(r.describes_data is True and r.converged for _, r in fitted)
    unknown = sum(r.describes_data is None for _, r in fitted)
    line = f"{len(fitted)} of {count} curves fitted; {described} of {count} fits describe their data to 5 % or better"
    lines = [line + (f", {unknown} have too few points to say" if unknown else "")]
    kept = {id(r) for _, r in sound}
    out = [(curve.name, ", ".join(ratings[id(r)].reasons)) for curve, r in fitted if id(r) not in kept]
    if out:
        left_out = "1 curve is" if len(out) == 1 else f"{len(out)} curves are"
        lines.append(f"{left_out} left out of the mean (--keep-all keeps them): {'; '.join(by_cause(out))}")
    return lines


def _copies(fitted: list[_Fitted]) -> list[tuple[str, str]]:
    """Curves whose readings are those of another one."""
    first: dict[bytes, str] = {}
    words = []
    for curve, r in fitted:
        same = first.setdefault(hashlib.sha256(r.data.x.tobytes() + r.data.y.tobytes()).digest(), curve.name)
        if same != curve.name:
            words.append((curve.name, f"it holds the same readings as {same}, and counts twice"))
    return words


def _spread(good: list[FitResult], names: tuple[str, ...]) -> tuple[list[list[str]], list[str]]:
    """Mean and scatter of the curves, and what is striking in them."""
    if len(good) < 2:
        return [], []
    titles = ["mean of tests", "mean", "95 % interval", "median", "scatter", "of it errors", "of it between tests", "shared errors"]
    rows, words = [titles], []
    for name in names:
        unit = practical(dimension_of(name), [abs(r.estimates[name]) for r in good])
        v = np.array([r.estimates[name] for r in good]) / unit.factor
        error = float(np.median([r.standard_errors[name] for r in good])) / unit.factor
        scatter = float(v.std(ddof=1))
        title = f"{words_of(name)} [{unit.name}]" if unit.name else words_of(name)
        try:
            mean = mean_of_tests(good, name)
        except MDRError:
            rows.append(
                [title, number(float(v.mean())), "-", number(float(np.median(v))), number(scatter), number(error), "-", "-"]
            )
            continue
        value, low, high, between, common = (x / unit.factor for x in (mean.value, *mean.interval, mean.between, mean.common))
        half = 0.5 * (high - low)
        ends = f"{digits(low, half)} to {digits(high, half)}"
        middle = number(float(np.median(v)))
        rows.append([title, digits(value, half), ends, middle, *(f"{x:.2g}" for x in (scatter, error, between, common))])
        # where contact begins in a record is no property of the body
        if error > 0.0 and scatter > 2.0 * error and not name.endswith("offset"):
            words.append(
                f"{words_of(name)} scatters {scatter / error:.2g} times its errors: the curves differ, which is in the interval of "
                "the mean, or errors are missing"
            )
    return rows, words


def _rows_of(curves: list[Curve], results: list[Any], names: tuple[str, ...], ratings: dict[int, Rating]) -> list[list[str]]:
    """One row for each file, failures too."""
    rows = [["file", *(words_of(name) for name in names), "chi-square/dof", "misfit", "noise", "rating", "verdict"]]
    for curve, result in zip(curves, results, strict=True):
        if isinstance(result, FailedFit):
            rows.append([curve.name, *(len(names) * ["-"]), "-", "-", "-", "-", "not fitted"])
            continue
        found = [result.as_text(name) for name in names]
        can_say = result.describes_data is not None
        ratio = f"{result.reduced_chi_square:.3g}" if result.noise_is_known and can_say else "-"
        sizes = [percent(size) for size in (result.misfit.rms, result.misfit.noise)]
        rating = ratings[id(result)]
        left_out = "" if rating.is_sound else ", left out"
        words = result.verdict if result.converged else "not converged"
        rows.append([curve.name, *found, ratio, *sizes, f"{rating.score:.1f}", words + left_out])
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


def _estimates(curves: list[Curve], results: list[Any], names: tuple[str, ...], ratings: dict[int, Rating]) -> bytes:
    """A CSV file with one row for each curve; a failure is a row with its reason."""
    good = [r for r in results if isinstance(r, FitResult)]
    units = {name: practical(dimension_of(name), [abs(r.estimates[name]) for r in good]) for name in names}
    titles = [f"{t}{name} [{units[name].name}]".replace(" []", "") for name in names for t in ("", "standard error of ")]
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    pulls = {
        name: practical(dimension, [abs(r.data.pulls[name]) for r in good if name in r.data.pulls])
        for name, dimension in _WITHOUT_MODEL.items()
        if any(name in r.data.pulls for r in good)
    }
    titles += [f"{name} [{unit.name}]" for name, unit in pulls.items()]
    found = ["converged", "verdict", "misfit", "noise", "rating", "sound", "chi-square/dof", "pattern p", "warnings"]
    writer.writerow(["file", *titles, *found])
    for curve, r in zip(curves, results, strict=True):
        if isinstance(r, FailedFit):
            writer.writerow([curve.name, *(len(titles) + len(found) - 1) * [""], f"not fitted: {r.error}"])
            continue
        values = [float(v) / units[n].factor for n in names for v in (r.estimates[n], r.standard_errors[n])]
        forces = [repr(r.data.pulls[name] / unit.factor) if name in r.data.pulls else "" for name, unit in pulls.items()]
        ratio = repr(r.reduced_chi_square) if r.noise_is_known and r.degrees_of_freedom >= 1.0 else ""
        rating = ratings[id(r)]
        marks = [int(r.converged), r.verdict, repr(r.misfit.rms), repr(r.misfit.noise), f"{rating.score:.2f}", int(rating.is_sound)]
        words = "; ".join([*rating.reasons, *r.warnings])
        writer.writerow([curve.name, *map(repr, values), *forces, *marks, ratio, repr(r.pattern_probability), words])
    return text.getvalue().encode()
