# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `many`: a body from many measured curves of a folder or a map."""

from __future__ import annotations

import functools
import hashlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .._text import number
from .._units import ENERGY, FORCE, LENGTH, RATIO, Unit, practical
from ..errors import MDRError
from ..instruments.files.curves import Curve
from ..instruments.files.fit_file import FitFile
from ..instruments.fitting import FailedFit, FitResult, FitResults, MeanOfTests, Rating, fit_many, mean_of_tests
from ..instruments.fitting.causes import by_cause
from ..instruments.fitting.data import Data
from ..instruments.fitting.many import WITHOUT_MODEL, by_curve, histogram, parameter
from ..instruments.fitting.misfit import percent
from ..instruments.fitting.quantities import digits, dimension_of, words_of
from ..panels import Axis, Cells, Figure, Line, Panel
from ..progress import Progress
from .result import Array, Column, Number, Result, Table, Words, in_words, study

_OFF_GRID = 0.25
"""Largest distance of a position from the grid, relative to its step."""
_WITHOUT_MODEL = {"jump-in": FORCE, "pull-off": FORCE, "last rupture": LENGTH, "energy lost": ENERGY}
"""Columns of the table from records, without a model."""


class Fitted(NamedTuple):
    """A curve that could be fitted."""

    curve: Curve
    fit: FitResult
    rating: Rating
    counts: bool
    """whether it is in the mean"""


@dataclass(frozen=True, eq=False, kw_only=True)
class FittedCurves(Result):
    """Fits of many curves. Tables: "curves" and "estimates" with a row for each, "spread" of those that count."""

    problem: FitFile
    curves: tuple[Curve, ...]
    results: FitResults
    """of each curve"""
    fitted: tuple[Fitted, ...]
    """the curves that could be fitted"""
    means: Mapping[str, MeanOfTests]
    """of the curves that count, by parameter"""
    doubts: tuple[str, ...]
    """one for each cause; `warnings` has them too"""

    @property
    def names(self) -> tuple[str, ...]:
        """The free parameters."""
        return self.fitted[0].fit.names

    def figure(self) -> Figure:
        """Return each parameter curve by curve, or place by place of a map, and its histogram."""
        names = tuple(name for name in self.names if name not in self.fitted[0].fit.data.also_free) or self.names
        grid = _grid(self.fitted)
        panels = (panel for name in names for panel in _parameter_panels(self.fitted, name, grid))
        return Figure(self.title, tuple(panels), columns=2)

    def to_dict(self) -> dict[str, Any]:
        """The fit of each curve, or the reason of its failure, as plain Python values."""
        return {
            curve.name: {
                **_place(curve),
                **(result.to_dict() if isinstance(result, FitResult) else {"error": str(result.error)}),
            }
            for curve, result in zip(self.curves, self.results, strict=True)
        }


class _Grid(NamedTuple):
    """The places of a map, as columns and rows from 0 on, and their positions."""

    columns: NDArray[np.int64]
    rows: NDArray[np.int64]
    x: Axis
    y: Axis
    x_values: Array
    y_values: Array


def _grid(fitted: Sequence[Fitted]) -> _Grid | None:
    """The map in which the curves lie; positions [um] where they are those of a grid along x and y, else columns and rows."""
    if len(fitted) <= 3 or any(one.curve.place is None for one in fitted):
        return None
    places = np.array([one.curve.place for one in fitted], dtype=int)
    if (np.ptp(places, axis=0) == 0).any():
        return None
    first = places.min(axis=0)
    steps = [np.arange(first[i], places[:, i].max() + 1.0) for i in range(2)]
    axes = [Axis("column", whole=True), Axis("row", whole=True)]
    scale = [_micrometres(fitted, places, i) for i in range(2)]
    if scale[0] is not None and scale[1] is not None:
        axes = [Axis("x", "\u00b5m"), Axis("y", "\u00b5m")]
        steps = [one[0] + one[1] * step for one, step in zip(scale, steps, strict=True) if one is not None]
    return _Grid(places[:, 0] - first[0], places[:, 1] - first[1], axes[0], axes[1], steps[0], steps[1])


def _micrometres(fitted: Sequence[Fitted], places: NDArray[np.int64], i: int) -> tuple[float, float] | None:
    """Start and step of the positions along x or y, None where they are on no grid."""
    if any(one.curve.position is None for one in fitted):
        return None
    positions = 1e6 * np.array([one.curve.position for one in fitted], dtype=float)[:, i]
    step, start = np.polyfit(places[:, i], positions, 1)
    on_grid = step > 0.0 and np.abs(start + step * places[:, i] - positions).max() <= _OFF_GRID * step
    return (float(start), float(step)) if on_grid else None


def _parameter_panels(fitted: Sequence[Fitted], name: str, grid: _Grid | None) -> Iterator[Panel]:
    axis, values, errors = parameter([one.fit for one in fitted], name)
    counts = np.array([one.counts for one in fitted])
    chosen = values[counts] if counts.any() else values
    if grid is None:
        yield by_curve([one.curve.name for one in fitted], axis, values, errors, counts)
    else:
        yield _by_place(grid, axis, values, chosen, counts)
    yield histogram(axis, chosen)


def _by_place(grid: _Grid, axis: Axis, values: Array, chosen: Array, counts: NDArray[np.bool_]) -> Panel:
    """A map whose colour range ignores a few outliers; places without a fit are white."""
    cells = np.full((len(grid.y_values), len(grid.x_values)), np.nan)
    cells[grid.rows, grid.columns] = values
    low, high = np.percentile(chosen, [2.0, 98.0])
    parts: list[Cells | Line] = [Cells(grid.x_values, grid.y_values, cells, axis._replace(low=low, high=high), smooth=False)]
    if not counts.all():
        left_out = grid.x_values[grid.columns[~counts]], grid.y_values[grid.rows[~counts]]
        parts.append(Line(*left_out, "left out of the mean", 1, -1, "x"))
    return Panel(grid.x, grid.y, tuple(parts))


@study
def many(problem: FitFile, curves: Sequence[Curve], *, keep_all: bool = False, progress: Progress | None = None) -> FittedCurves:
    """Fit each of many curves, and average the sound fits.

    Parameters
    ----------
    problem : FitFile
        Indenter, medium, instrument and the free parameters, as `mdrcontact.instruments.load_fit_file` returns them.
    curves : sequence of Curve
        Curves that are read when they are fitted, as `problem.curves` finds them in a file.
    keep_all : bool, optional
        Include all fits in the mean, also those that `instruments.rate` does not consider sound.
    progress : Progress, optional
        Reports each curve, and can stop the work between two of them.

    Returns
    -------
    FittedCurves
        `fitted`, `results`, `means`; numbers "curves", "fitted", "in the mean", and each mean of tests by its parameter.

    Raises
    ------
    MDRError
        No curve could be fitted.

    Examples
    --------
    >>> import numpy as np
    >>> import mdrcontact as mdr
    >>> from mdrcontact import instruments, studies
    >>> from mdrcontact.instruments.files.curves import Curve
    >>> text = '''
    ... [indenter]
    ... shape = "paraboloid"
    ... radius = "10 um"
    ... [medium]
    ... type = "homogeneous"
    ... material = { E = "50 GPa", nu = 0.17 }
    ... [data]
    ... kind = "force-depth"
    ... [fit]
    ... free = ["E"]
    ... '''
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> def measured(young):
    ...     body = mdr.Homogeneous(mdr.Elastic(young, 0.17))
    ...     force = mdr.Contact(mdr.Paraboloid(10e-6), body).at_depth(depth).force
    ...     return instruments.ForceDepth(depth, force, sd=0.01 * force), ["made up"]
    >>> curves = [Curve(f"test {E:g}", lambda E=E: measured(E)) for E in (71e9, 72e9, 73e9)]
    >>> found = studies.many(instruments.fit_file_of_text(text), curves)
    >>> found.notes["fitted"]
    '3 of 3 curves fitted; 3 of 3 fits describe their data to 5 % or better'
    """
    progress, total = progress or Progress(), len(curves)
    progress.step(0, total, "curves")
    notes: dict[int, list[str]] = {}
    tasks = [functools.partial(_only_data, curve, i, notes) for i, curve in enumerate(curves)]
    results = fit_many(tasks, progress=lambda done: progress.step(done, total, "curves"), **problem.arguments)
    read = [curve for curve, one in zip(curves, results, strict=True) if isinstance(one, FitResult)]
    rated = zip(read, results.fitted, results.ratings, strict=True)
    fitted = [Fitted(curve, one, rating, keep_all or rating.is_sound) for curve, one, rating in rated]
    failed = [(c.name, f"not fitted: {r.error}") for c, r in zip(curves, results, strict=True) if isinstance(r, FailedFit)]
    if not fitted:
        raise MDRError(f"no curve could be fitted: {'; '.join(f'{name}: {words}' for name, words in failed[:3])}")
    names, counting = fitted[0].fit.names, [one.fit for one in fitted if one.counts]
    means = {name: mean for name in names if (mean := _mean(counting, name))}
    warned = [*_copies(fitted), *((one.curve.name, words) for one in fitted for words in one.fit.warnings), *failed]
    spread, striking = _spread(counting, names, means)
    doubts = (*striking, *by_cause(warned))
    tables: dict[str, Table] = {
        "curves": in_words(_rows(curves, results, fitted)),
        "estimates": _estimates(curves, results, notes),
    }
    if len(spread) > 1:
        tables["spread"] = in_words(spread)
    return FittedCurves(
        title=problem.title,
        numbers={
            "curves": Number(total, RATIO),
            "fitted": Number(len(fitted), RATIO),
            "in the mean": Number(len(counting), RATIO),
            **{name: Number(mean.value, dimension_of(name)) for name, mean in means.items()},
        },
        notes=_verdict(total, fitted),
        tables=tables,
        warnings=doubts,
        problem=problem,
        curves=tuple(curves),
        results=results,
        fitted=tuple(fitted),
        means=means,
        doubts=doubts,
    )


def _place(curve: Curve) -> dict[str, Any]:
    """Number and place of a curve, as its file has them, SI units; nothing where it has none."""
    known: dict[str, Any] = {"number": curve.number}
    for names, pair in ((("x", "y"), curve.position), (("column", "row"), curve.place)):
        known |= dict(zip(names, pair or (), strict=False))
    return {"place": known} if curve.position or curve.place else {}


def _places(curves: Sequence[Curve]) -> list[Column | Words]:
    """Columns for number and place of each curve, where files have places."""
    found = [_place(curve).get("place", {}) for curve in curves]
    columns: list[Column | Words] = []
    for name in ("number", "x", "y", "column", "row"):
        values = [one.get(name) for one in found]
        if name in ("x", "y") and any(value is not None for value in values):
            missing = {i: "" for i, value in enumerate(values) if value is None}
            numbers = np.array([np.nan if value is None else value for value in values])
            columns.append(Column(name, numbers, Unit("um", 1e-6), missing))
        elif any(value is not None for value in values):
            columns.append(Words(name, ["" if value is None else f"{value:g}" for value in values]))
    return columns


def _only_data(curve: Curve, i: int, notes: dict[int, list[str]]) -> Data:
    data, notes[i] = curve.read()
    return data


def _verdict(count: int, fitted: Sequence[Fitted]) -> dict[str, str]:
    """Return how many fits describe their data, and which do not count."""
    described = sum(one.fit.describes_data is True and one.fit.converged for one in fitted)
    unknown = sum(one.fit.describes_data is None for one in fitted)
    line = f"{len(fitted)} of {count} curves fitted; {described} of {count} fits describe their data to 5 % or better"
    notes = {"fitted": line + (f", {unknown} cannot tell a misfit from noise" if unknown else "")}
    out = [(one.curve.name, ", ".join(one.rating.reasons)) for one in fitted if not one.counts]
    if out:
        left_out = "1 curve is" if len(out) == 1 else f"{len(out)} curves are"
        notes["left out"] = f"{left_out} left out of the mean (--keep-all keeps them): {'; '.join(by_cause(out))}"
    return notes


def _copies(fitted: Iterable[Fitted]) -> list[tuple[str, str]]:
    """Curves whose readings are those of another one."""
    first: dict[bytes, str] = {}
    words = []
    for curve, r, *_ in fitted:
        same = first.setdefault(hashlib.sha256(r.data.x.tobytes() + r.data.y.tobytes()).digest(), curve.name)
        if same != curve.name:
            words.append((curve.name, f"it holds the same readings as {same}, and counts twice"))
    return words


def _mean(counting: Sequence[FitResult], name: str) -> MeanOfTests | None:
    """The mean of tests; None where it has no standard error."""
    try:
        return mean_of_tests(counting, name)
    except MDRError:
        return None


def _spread(
    counting: Sequence[FitResult], names: Sequence[str], means: Mapping[str, MeanOfTests]
) -> tuple[list[list[str]], list[str]]:
    """Mean and scatter of the curves that count, and what is striking in them."""
    titles = ["mean of tests", "mean", "95 % interval", "median", "scatter", "of it errors", "of it between tests", "shared errors"]
    rows, words = [titles], []
    for name in names if len(counting) > 1 else ():
        unit = practical(dimension_of(name), [abs(r.estimates[name]) for r in counting])
        v = np.array([r.estimates[name] for r in counting]) / unit.factor
        error = float(np.median([r.standard_errors[name] for r in counting])) / unit.factor
        scatter, middle = float(v.std(ddof=1)), number(float(np.median(v)))
        title = f"{words_of(name)} [{unit.name}]" if unit.name else words_of(name)
        if name not in means:
            rows.append([title, number(float(v.mean())), "-", middle, number(scatter), number(error), "-", "-"])
            continue
        mean = means[name]
        value, low, high, between, common = (x / unit.factor for x in (mean.value, *mean.interval, mean.between, mean.common))
        half = 0.5 * (high - low)
        ends = f"{digits(low, half)} to {digits(high, half)}"
        rows.append([title, digits(value, half), ends, middle, *(f"{x:.2g}" for x in (scatter, error, between, common))])
        # the position of first contact in a record is not a property of the body
        if error > 0.0 and scatter > 2.0 * error and not name.endswith("offset"):
            words.append(
                f"{words_of(name)} scatters {scatter / error:.2g} times its errors: the curves differ, which is in the interval of "
                "the mean, or errors are missing"
            )
    return rows, words


def _rows(curves: Sequence[Curve], results: Sequence[FitResult | FailedFit], fitted: Sequence[Fitted]) -> list[list[str]]:
    """One row for each curve, failures too, below the titles."""
    names, rest = fitted[0].fit.names, iter(fitted)
    rows = [["file", *(words_of(name) for name in names), "chi-square/dof", "misfit", "noise", "rating", "verdict"]]
    for curve, result in zip(curves, results, strict=True):
        if isinstance(result, FailedFit):
            rows.append([curve.name, *(len(names) * ["-"]), "-", "-", "-", "-", "not fitted"])
            continue
        rating = next(rest).rating
        found = [result.as_text(name) for name in names]
        can_say = result.describes_data is not None
        ratio = f"{result.reduced_chi_square:.3g}" if result.noise_is_known and can_say else "-"
        sizes = [percent(size) for size in (result.misfit.rms, result.misfit.noise)]
        left_out = "" if rating.is_sound else ", left out"
        words = result.verdict if result.converged else "not converged"
        rows.append([curve.name, *found, ratio, *sizes, f"{rating.score:.1f}", words + left_out])
    return rows


def _estimates(curves: Sequence[Curve], results: FitResults, notes: Mapping[int, Sequence[str]]) -> Table:
    """Estimates, marks and settings of each curve; a failure is a row with its error."""
    missing = {i: "" for i, result in enumerate(results) if isinstance(result, FailedFit)}
    columns: list[Column | Words] = [Words("file", [curve.name for curve in curves]), *_places(curves)]
    table = results.table()
    for title, values in table.items():
        name = title.removeprefix("standard error of ").removeprefix("fixed ")
        if title in WITHOUT_MODEL:
            absent = {int(i): "" for i in np.flatnonzero(np.isnan(values))}
            columns.append(Column(title, values, practical(_WITHOUT_MODEL[title], np.abs(values[~np.isnan(values)])), absent))
        elif title != name or name in results.names:
            given = table.get(name, values)
            unit = practical(dimension_of(name), np.abs(given[~np.isnan(given)]))
            columns.append(Column(title, values, unit, missing))
        elif title != "curve":
            columns.append(Words(title, [_mark(title, value, i in missing) for i, value in enumerate(values)]))
    return [*columns, Words("read", ["; ".join(notes.get(i, ())) for i in range(len(curves))])]


def _mark(title: str, value: Any, is_missing: bool) -> str:
    """A remark on a fit in addition to its estimates."""
    if isinstance(value, str):
        return value
    if is_missing or np.isnan(value):
        return ""
    if title == "rating":
        return f"{value:.2f}"
    return str(int(value)) if isinstance(value, bool) else repr(float(value))
