# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of many curves over all cores: force-volume maps, series of indents."""

from __future__ import annotations

import functools
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple, overload

import numpy as np
from numpy.typing import NDArray

from ..._boundary import thread_count
from ..._files import replace
from ..._parts import share
from ..._text import html_table
from ...errors import ArgumentTypeError, InvalidArgumentError, MDRError
from ...panels import Axis, Bars, Figure, Line, Panel, along
from ...threads import cores
from . import report
from .between import MeanOfTests, mean_of_tests
from .data import Data
from .quantities import dimension_of, measured, words_of
from .rating import Rating, rate
from .result import FitResult
from .solve import fit

Array = NDArray[np.float64]

_MOST_NAMES = 40
"""Curves whose names are written below the figure."""
_SHOWN = 20
"""Curves in a table of a notebook."""
WITHOUT_MODEL = ("jump-in", "pull-off", "last rupture", "energy lost")
"""Numbers from records, without a model."""


class FailedFit(NamedTuple):
    """Curve that could not be fitted, from `fit_many`.

    Examples
    --------
    >>> def damaged():
    ...     return mdr.instruments.ForceDepth([1e-9, 2e-9], [1e-3, float("nan")])
    >>> body = mdr.Homogeneous(mdr.Elastic(50e9, 0.17))
    >>> (failed,) = mdr.instruments.fit_many([damaged], mdr.Paraboloid(10e-6), body, ["E"], threads=1)
    >>> print(failed.position, failed.converged, type(failed.error).__name__)
    0 False InvalidArgumentError
    """

    position: int
    """number of the curve, from 0"""
    error: MDRError
    """the exception"""

    converged: bool = False
    """always False, as of a `FitResult` that did not converge"""


class FitResults(Sequence["FitResult | FailedFit"]):
    """Sequence of the fits of many curves, from `fit_many`.

    A fit counts in means and histograms if `rate` considers it sound.

    Parameters
    ----------
    results : iterable of FitResult or FailedFit
        One result for each curve, in their order.

    Raises
    ------
    ArgumentTypeError
        A result is of another type.

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> def measured(E):
    ...     contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(E, 0.17)))
    ...     return mdr.instruments.ForceDepth(depth, contact.at_depth(depth).force, sd=1e-6)
    >>> body = mdr.Homogeneous(mdr.Elastic(50e9, 0.17))
    >>> found = mdr.instruments.fit_many([measured(E) for E in (70e9, 72e9, 74e9)], mdr.Paraboloid(10e-6), body, ["E"])
    >>> print(found, f"{found.mean('E').value / 1e9:.2f}", np.round(found.table()["E"] / 1e9, 2))
    <FitResults: 3 curves, 3 fitted, 3 sound> 72.00 [70. 72. 74.]
    """

    def __init__(self, results: Iterable[FitResult | FailedFit]) -> None:
        self._results = tuple(results)
        for one in self._results:
            if not isinstance(one, FitResult | FailedFit):
                raise ArgumentTypeError(f"results: they must be FitResult or FailedFit, not {type(one).__name__}. Use fit_many.")

    @overload
    def __getitem__(self, index: int) -> FitResult | FailedFit: ...
    @overload
    def __getitem__(self, index: slice) -> FitResults: ...
    def __getitem__(self, index: int | slice) -> FitResult | FailedFit | FitResults:
        return FitResults(self._results[index]) if isinstance(index, slice) else self._results[index]

    def __len__(self) -> int:
        return len(self._results)

    def __repr__(self) -> str:
        return f"<FitResults: {len(self)} curves, {len(self.fitted)} fitted, {sum(one.is_sound for one in self.ratings)} sound>"

    def _repr_html_(self) -> str:
        """The estimates in a notebook."""
        more = f"<p>{_SHOWN} of {len(self)} curves</p>" if len(self) > _SHOWN else ""
        return html_table(self[:_SHOWN]._rows()) + more

    @functools.cached_property
    def fitted(self) -> tuple[FitResult, ...]:
        """The curves that could be fitted."""
        return tuple(one for one in self if isinstance(one, FitResult))

    @property
    def failed(self) -> tuple[FailedFit, ...]:
        """The curves that could not be fitted, with their errors."""
        return tuple(one for one in self if isinstance(one, FailedFit))

    @functools.cached_property
    def _rated(self) -> tuple[Rating | None, ...]:
        """The rating of each curve; None of a failure."""
        return tuple(rate(one) if isinstance(one, FitResult) else None for one in self)

    @property
    def ratings(self) -> tuple[Rating, ...]:
        """The rating of each fit in `fitted`."""
        return tuple(one for one in self._rated if one is not None)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the free parameters; empty if no curve could be fitted."""
        return self.fitted[0].names if self.fitted else ()

    def mean(self, name: str, level: float = 0.95, *, keep_all: bool = False) -> MeanOfTests:
        """Return the mean of a parameter over the sound fits, as `mean_of_tests`.

        Parameters
        ----------
        name : str
            Name of the parameter, as "E".
        level : float, optional
            Level of the interval, 0 < level < 1 [1].
        keep_all : bool, optional
            Include all fits, also those that are not sound.

        Returns
        -------
        MeanOfTests
            Mean, standard error and interval.

        Raises
        ------
        InvalidArgumentError
            Fewer than two fits have a standard error of the parameter.
        """
        return mean_of_tests([one for one, counts in zip(self.fitted, self._counts(keep_all), strict=True) if counts], name, level)

    def table(self) -> dict[str, Any]:
        """Return a row for each curve as named columns, failures included.

        Returns
        -------
        dict
            Columns of one length, as `pandas.DataFrame` takes them, in SI units: estimates and standard errors, NaN of a failure;
            numbers of the records without a model; verdict and rating; "warnings", with the reason why a curve is not sound or not
            fitted; and the settings of the fit: "model", "indenter" and each fixed number.
        """
        found: dict[str, Any] = {"curve": np.arange(len(self))}
        for name in self.names:
            found[name] = self._numbers(lambda one: one.estimates, name)
            found[f"standard error of {name}"] = self._numbers(lambda one: one.standard_errors, name)
        for name in WITHOUT_MODEL:
            if any(name in one.data.pulls for one in self.fitted):
                found[name] = self._numbers(lambda one: one.data.pulls, name)
        found["converged"] = [one.converged for one in self]
        found["verdict"] = [one.verdict if isinstance(one, FitResult) else "" for one in self]
        found |= {name: self._numbers(_sizes, name) for name in ("misfit", "noise")}
        found["rating"] = np.array([np.nan if one is None else one.score for one in self._rated])
        found["sound"] = [one is not None and one.is_sound for one in self._rated]
        found |= {name: self._numbers(_tests, name) for name in ("chi-square/dof", "pattern p")}
        found["warnings"] = [_remarks(one, rating) for one, rating in zip(self, self._rated, strict=True)]
        return {**found, **self._settings()}

    def plot(self, title: str = "") -> Figure:
        """Return each parameter curve by curve, and its histogram, as a figure.

        Numbers are taken as SI.

        Parameters
        ----------
        title : str, optional
            Title of the figure.

        Returns
        -------
        Figure
            The figure.

        Raises
        ------
        InvalidArgumentError
            No curve could be fitted.
        """
        if not self.fitted:
            raise InvalidArgumentError("no curve could be fitted: there is nothing to draw. Read the errors in `failed`.")
        places = [str(i) for i, one in enumerate(self) if isinstance(one, FitResult)]
        counts = np.array(self._counts(False))
        panels = []
        for name in self.names:
            axis, values, errors = parameter(self.fitted, name)
            panels += [by_curve(places, axis, values, errors, counts), histogram(axis, values[counts] if counts.any() else values)]
        return Figure(title or f"{len(self)} curves", tuple(panels))

    def report(self, path: str | os.PathLike[str] | None = None, title: str = "Fits of many curves") -> str:
        """Return a report as one HTML file, readable without a network.

        It has means, figure, a row for each curve with the reason if it does not count, and the assumptions of the first fit.

        Parameters
        ----------
        path : str or path-like, optional
            File for the report.
        title : str, optional
            Title of the report.

        Returns
        -------
        str
            The HTML text.

        Raises
        ------
        InvalidArgumentError
            No curve could be fitted.
        """
        figure, sound = self.plot(title), sum(one.is_sound for one in self.ratings)
        blocks = [report.paragraph(f"{len(self.fitted)} of {len(self)} curves fitted; {sound} of them count in the means.")]
        if sound > 1:
            means = [self.mean(name) for name in self.names]
            rows = [[words_of(one.name), measured(one.name, one.value, one.standard_error)] for one in means]
            blocks.append(html_table([["mean of tests", "value"], *rows]))
        blocks += [report.picture(figure, "estimates of all curves"), report.heading("Curves"), html_table(self._rows())]
        blocks += [report.heading("What was assumed, for the first curve"), report.assumptions(self.fitted[0])]
        text = report.page(title, blocks)
        if path is not None:
            replace(path, text.encode())
        return text

    def _counts(self, keep_all: bool) -> list[bool]:
        return [keep_all or one.is_sound for one in self.ratings]

    def _numbers(self, of: Callable[[FitResult], Mapping[str, float]], name: str) -> Array:
        return np.array([of(one).get(name, np.nan) if isinstance(one, FitResult) else np.nan for one in self])

    def _settings(self) -> dict[str, Any]:
        """What every fit takes as given: its model, indenter and fixed numbers."""
        if not self.fitted:
            return {}
        first = self.fitted[0]
        fixed = [name for name, value in first.values.items() if name not in first.names and np.isfinite(value)]
        model = getattr(first.medium, "model", type(first.medium).__name__.lower())
        found: dict[str, Any] = {"model": [model] * len(self), "indenter": [type(first.indenter).__name__] * len(self)}
        return found | {f"fixed {name}": self._numbers(lambda one: one.values, name) for name in fixed}

    def _rows(self) -> list[list[str]]:
        """A row for each curve, below the titles."""
        rows = [["curve", *map(words_of, self.names), "verdict", "remarks"]]
        for i, (one, rating) in enumerate(zip(self, self._rated, strict=True)):
            if isinstance(one, FailedFit):
                rows.append([str(i), *["-"] * len(self.names), "not fitted", str(one.error)])
            else:
                rows.append([str(i), *map(one.as_text, self.names), one.verdict, _remarks(one, rating)])
        return rows


def _sizes(one: FitResult) -> dict[str, float]:
    return {"misfit": one.misfit.rms, "noise": one.misfit.noise}


def _tests(one: FitResult) -> dict[str, float]:
    """Tests of the residuals; chi-square needs known standard deviations."""
    return {"chi-square/dof": one.reduced_chi_square if one.noise_is_known else np.nan, "pattern p": one.pattern_probability}


def _remarks(one: FitResult | FailedFit, rating: Rating | None) -> str:
    """Reasons why a curve does not count, and warnings."""
    if isinstance(one, FailedFit):
        return f"not fitted: {one.error}"
    return "; ".join([*(rating.reasons if rating else ()), *one.warnings])


def parameter(fitted: Sequence[FitResult], name: str) -> tuple[Axis, Array, Array]:
    """Return the axis of a parameter, and in its unit the estimates and half of their 95 % intervals."""
    axis, unit = along(words_of(name), dimension_of(name), [abs(one.estimates[name]) for one in fitted])
    values = np.array([one.estimates[name] for one in fitted])
    errors = np.array([one.standard_errors[name] for one in fitted])
    return axis, unit.of(values), 1.96 * unit.of(errors)


def histogram(axis: Axis, values: Array) -> Panel:
    """Return the counts of the values of a parameter."""
    numbers, edges = np.histogram(values, "rice")
    return Panel(axis, Axis("curves", whole=True), (Bars(edges, numbers.astype(float)),))


def by_curve(names: Sequence[str], axis: Axis, values: Array, errors: Array, counts: NDArray[np.bool_]) -> Panel:
    """Return a parameter curve by curve; those that do not count have another colour."""
    places = np.arange(1.0, len(values) + 1.0)
    parts = tuple(
        Line(places[keep], values[keep], name, colour, -1, "o", error=errors[keep])
        for keep, colour, name in ((counts, 0, "in the mean"), (~counts, 1, "left out of the mean"))
        if keep.any()
    )
    named = tuple(names) if len(names) <= _MOST_NAMES else ()
    low, high = _ends(values[counts] if counts.any() else values, errors[counts] if counts.any() else errors)
    return Panel(Axis("curve", whole=True, names=named), axis._replace(low=low, high=high), parts)


def _ends(values: Array, errors: Array) -> tuple[float, float]:
    """Limits in which one estimate that is not determined does not take the whole height."""
    low, high = np.percentile(values, [5.0, 95.0])
    room = 4.0 * max(high - low, float(np.median(errors)), 1e-3 * abs(high))
    ends = max(float((values - errors).min()), low - room), min(float((values + errors).max()), high + room)
    return ends[0] - 0.05 * (ends[1] - ends[0]), ends[1] + 0.05 * (ends[1] - ends[0])


def fit_many(
    curves: Iterable[Data | Callable[[], Data]],
    indenter: Any,
    medium: Any,
    free: Any,
    *,
    threads: int = 0,
    progress: Callable[[int], Any] | None = None,
    **options: Any,
) -> FitResults:
    """Fit each of many curves independently, in several threads.

    A curve that cannot be fitted becomes a `FailedFit` and does not stop the others.

    Parameters
    ----------
    curves : iterable
        Data as for `fit`, or functions that return them; an error in such a function is one failure.
    indenter : Profile
        As in `fit`.
    medium : Medium
        As in `fit`.
    free : mapping or iterable of str
        As in `fit`.
    threads : int, optional
        Number of threads >= 1, or 0 for one per core.
    progress : callable, optional
        Function of the number of completed curves, called after each.
    **options
        Further arguments of `fit`.

    Returns
    -------
    FitResults
        A sequence with one `FitResult` or `FailedFit` for each curve, in their order; it has means, a table, a figure and a report.

    Raises
    ------
    InvalidArgumentError
        `threads` is negative.

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> def measured(E):
    ...     contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(E, 0.17)))
    ...     return mdr.instruments.ForceDepth(depth, contact.at_depth(depth).force, sd=1e-6)
    >>> body = mdr.Homogeneous(mdr.Elastic(50e9, 0.17))
    >>> results = mdr.instruments.fit_many([measured(70e9), measured(72e9)], mdr.Paraboloid(10e-6), body, ["E"])
    >>> print([f"{result.estimates['E'] / 1e9:.1f}" for result in results])
    ['70.0', '72.0']
    """
    tasks = list(curves)
    if thread_count(threads) < 0:
        raise InvalidArgumentError(f"threads = {threads!r}: it must be at least 1, or 0 for one per core")

    def one(index: int) -> FitResult | FailedFit:
        try:
            task = tasks[index]
            return fit(task if isinstance(task, Data) else task(), indenter, medium, free, **options)
        except MDRError as problem:
            return FailedFit(index, problem)

    follow = {} if progress is None else {"done": progress}
    return FitResults(share(one, range(len(tasks)), threads=threads or cores(), **follow))
