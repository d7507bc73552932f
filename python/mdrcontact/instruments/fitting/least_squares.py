# SPDX-License-Identifier: GPL-3.0-or-later
"""Least squares of any residuals, by SciPy: the parameters, their standard errors, intervals and correlation."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ... import _scipy
from ...errors import InvalidArgumentError, NoConvergenceError

Array = NDArray[np.float64]
Residuals = Callable[[Array], Array]

_INTERVAL = 1.96
"""Standard errors on each side in an interval of 95 %."""
_LOOSE = 0.5
"""A parameter whose standard error is larger, of its value or its width, does not follow from the data."""
_NONE = 1e-7
"""A parameter that moves the readings less than this part of what another does has no effect on them."""
_TOGETHER = 0.95
"""Two parameters that are correlated more than this follow from the data together only."""


class Coordinate(NamedTuple):
    """A free parameter in the search: by its logarithm, or in parts of a size."""

    name: str
    is_logarithm: bool = True
    size: float = 1.0
    width: float = 1.0
    """of its range, in the search"""
    limits: tuple[float, float] = (-math.inf, math.inf)
    """of its interval, without a logarithm"""

    def value(self, u: float) -> float:
        """The parameter at a place of the search."""
        return float(np.exp(u)) if self.is_logarithm else float(self.size * u)

    def error(self, u: float, sd: float) -> float:
        """Its standard error, from that in the search."""
        return sd * (self.value(u) if self.is_logarithm else self.size)

    def interval(self, u: float, reach: float) -> tuple[float, float]:
        """Interval of u minus and plus `reach`."""
        if self.is_logarithm:
            return self.value(u) * math.exp(-min(reach, 700.0)), self.value(u) * math.exp(min(reach, 700.0))
        return max(self.size * (u - reach), self.limits[0]), min(self.size * (u + reach), self.limits[1])


@dataclass(frozen=True, eq=False, kw_only=True)
class ParameterFit:
    """Result of a search. Intervals are of 95 %, for positive parameters in their logarithms."""

    values: Mapping[str, float]
    """estimates of the free parameters by name"""
    errors: Mapping[str, float]
    """standard errors by name"""
    intervals: Mapping[str, tuple[float, float]]
    """95 % intervals by name; of positive parameters in their logarithm"""
    correlation: Array
    """correlation of the free parameters, in the order of `values` [1]"""
    chi_square: float
    """sum of the squared residuals, in standard deviations if those are known"""
    points: int
    """number of readings"""
    notes: tuple[str, ...]
    """what the data do not determine, or determine only together"""

    def summary(self) -> str:
        """Return the result as text.

        Returns
        -------
        str
            Estimates, standard errors, intervals and notes.
        """
        lines = [self._head()]
        for name, value in self.values.items():
            low, high = self.intervals[name]
            lines.append(f"{name:16} {value:.6g}, standard error {self.errors[name]:.2g}, 95 %: {low:.5g} to {high:.5g}")
        return "\n".join([*lines, *self.notes])

    def to_dict(self) -> dict[str, Any]:
        """Return numbers and notes as plain Python values.

        Returns
        -------
        dict
            Sum of squares, notes and parameters; None for infinite numbers.
        """

        def plain(*numbers: float) -> list[float | None]:
            return [number if math.isfinite(number) else None for number in numbers]

        parameters = {
            name: {"value": value, "standard_error": plain(self.errors[name])[0], "interval": plain(*self.intervals[name])}
            for name, value in self.values.items()
        }
        return {"sum_of_squares": self.chi_square, "notes": list(self.notes), "parameters": parameters}

    def _head(self) -> str:
        return f"{self.points} readings, sum of squares {self.chi_square:.5g}"


class Estimate(NamedTuple):
    """Minimum of the sum of squares, and its uncertainty."""

    u: Array
    """place in the search"""
    residuals: Array
    spread: Array
    """standard errors of u"""
    correlation: Array

    def fields(self, coordinates: Sequence[Coordinate], reach: Array | None = None) -> dict[str, Any]:
        """Fields of a `ParameterFit`; reach: half of each interval in the search, where it is not that of many readings."""
        each = list(zip(coordinates, self.u, self.spread, strict=True))
        reaches = _INTERVAL * self.spread if reach is None else reach
        return {
            "values": {one.name: one.value(u) for one, u, _ in each},
            "errors": {one.name: one.error(u, float(sd)) for one, u, sd in each},
            "intervals": {one.name: one.interval(float(u), float(to)) for (one, u, _), to in zip(each, reaches, strict=True)},
            "correlation": self.correlation,
            "chi_square": float(self.residuals @ self.residuals),
            "points": len(self.residuals),
            "notes": tuple(self._notes(coordinates)),
        }

    def _notes(self, coordinates: Sequence[Coordinate]) -> Iterable[str]:
        """Combinations of parameters that the data do not determine."""
        for one, sd in zip(coordinates, self.spread, strict=True):
            if not sd <= _LOOSE * one.width:
                yield f"{one.name} does not follow from these data: fix it, or measure where it matters"
        for i, first in enumerate(coordinates):
            for j in range(i + 1, len(coordinates)):
                if abs(self.correlation[i, j]) > _TOGETHER:
                    both = f"{first.name} and {coordinates[j].name}"
                    yield f"{both} follow from these data together only: their correlation is {self.correlation[i, j]:.3f}"


def solve(residuals: Residuals, start: Array, *, is_absolute: bool = False, unit: float = 1.0, **options: Any) -> Estimate:
    """Where the sum of squares is least.

    residuals : in standard deviations if `is_absolute`; otherwise their size determines the standard deviations
    unit : of the residuals in the search
    options : of SciPy's `least_squares`
    """
    _scipy.require()
    from scipy.optimize import least_squares

    found = least_squares(lambda u: residuals(u) / unit, start, **options)
    if not found.success:
        raise NoConvergenceError("the fit did not come to rest: leave fewer parameters free, or start closer")
    return estimate(found.x, unit * found.fun, unit * found.jac, is_absolute=is_absolute)


def estimate(u: Array, residuals: Array, slopes: Array, *, is_absolute: bool = False) -> Estimate:
    """Estimate from residuals and their slopes at the least sum of squares."""
    covariance = np.asarray(np.linalg.pinv(slopes.T @ slopes, rcond=1e-14), np.float64)
    if not is_absolute:
        covariance = covariance * float(residuals @ residuals) / max(len(residuals) - len(u), 1)
    spread = np.sqrt(np.diag(covariance))
    correlation = covariance / np.maximum(np.outer(spread, spread), 1e-300)
    # the pseudo-inverse takes a parameter without effect on the readings as known
    effect = np.linalg.norm(slopes, axis=0)
    known = effect > _NONE * np.max(effect)
    correlation = np.where(np.outer(known, known), correlation, np.eye(len(u)))
    return Estimate(u, residuals, np.where(known, spread, math.inf), correlation)


def central_differences(residuals: Residuals, at: Array, moves: Array) -> Array:
    """Half the change of the residuals from one move down to one up: a column for each row of `moves`."""
    return np.array([0.5 * (residuals(at + move) - residuals(at - move)) for move in moves]).T


def names_of(free: Iterable[str], known: Sequence[str] = ()) -> tuple[str, ...]:
    """Names of free parameters, each once; of those that are known."""
    names = tuple(free)
    if isinstance(free, str) or not names or len(set(names)) != len(names) or (known and not set(names) <= set(known)):
        words = f"choose from {', '.join(map(repr, known))}, each once" if known else "give names, each once"
        raise InvalidArgumentError(f"free = {free!r}: {words}")
    return names
