# SPDX-License-Identifier: GPL-3.0-or-later
"""The mean of several tests and its interval: errors of each test, scatter between tests, and what all tests share."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..._boundary import call, native
from ...errors import InvalidArgumentError
from .result import FitResult, Interval

Array = NDArray[np.float64]

_ROUNDS = 100
_LEAST = 1e-9
"""Smallest standard error relative to the mean; a smaller one is rounding."""


class MeanOfTests(NamedTuple):
    """Mean of a parameter over several tests, from `mean_of_tests`.

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> def fitted(E):
    ...     contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(E, 0.17)))
    ...     data = mdr.instruments.ForceDepth(depth, contact.at_depth(depth).force, sd=1e-6)
    ...     return mdr.instruments.fit(data, mdr.Paraboloid(10e-6), contact.medium, ["E"])
    >>> mean = mdr.instruments.mean_of_tests([fitted(E) for E in (70e9, 72e9, 74e9)], "E")
    >>> print(f"{mean.value / 1e9:.2f} {mean.between / 1e9:.2f}")
    72.00 2.00
    """

    name: str
    """name of the parameter"""
    value: float
    """mean, in the unit of the parameter"""
    standard_error: float
    """standard error of the mean"""
    interval: Interval
    """interval of the mean, 95 % or the given level"""
    between: float
    """standard deviation of the true values of the tests"""
    common: float
    """standard error from parameters with a prior, which all tests share, as tip or thickness"""
    tests: int
    """number of tests"""


def mean_of_tests(results: Sequence[FitResult], name: str, level: float = 0.95) -> MeanOfTests:
    """Average a fitted parameter over tests that differ by more than their errors.

    Parameters
    ----------
    results : sequence of FitResult
        At least two fits with the parameter free and a standard error.
    name : str
        Name of the parameter, as "E".
    level : float, optional
        Level of the interval, 0 < level < 1 [1].

    Returns
    -------
    MeanOfTests
        Mean, standard error and interval.

    Raises
    ------
    InvalidArgumentError
        Fewer than two fits have a standard error of the parameter.

    Notes
    -----
    The tests are a random effect. The variance between tests is that of Paule and Mandel (1982). The interval has Student's
    quantile and the variance of Hartung and Knapp (2001), and is at least as wide as the errors of the tests alone. Parameters with
    a prior are equal in all tests: their error is not averaged, and is added.

    References
    ----------
    paule-1982
    hartung-2001

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> def fitted(E):
    ...     contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(E, 0.17)))
    ...     data = mdr.instruments.ForceDepth(depth, contact.at_depth(depth).force, sd=1e-6)
    ...     return mdr.instruments.fit(data, mdr.Paraboloid(10e-6), contact.medium, ["E"])
    >>> mean = mdr.instruments.mean_of_tests([fitted(E) for E in (70e9, 72e9, 74e9)], "E")
    >>> print(f"{mean.interval.lower / 1e9:.1f} {mean.interval.upper / 1e9:.1f}")
    67.0 77.0
    """
    sound = [r for r in results if name in r.names and r.standard_errors[name] > 0.0 and math.isfinite(r.standard_errors[name])]
    if len(sound) < 2:
        raise InvalidArgumentError(f"only {len(sound)} tests have a standard error of {name!r}: the mean of tests needs two")
    values = np.array([r.estimates[name] for r in sound])
    responses = [_response(r, name) for r in sound]
    precision = _prior_precision(sound[0])
    spread = np.linalg.pinv(precision)
    shared = np.array([max(float(g @ spread @ g), 0.0) for g in responses])
    least = (_LEAST * float(np.abs(values).max())) ** 2
    own = np.maximum(np.array([r.standard_errors[name] ** 2 for r in sound]) - shared, least)
    between = _paule_mandel(values, own)
    weight = 1.0 / (own + between)
    weight /= weight.sum()
    mean = float(weight @ values)
    freedom = len(values) - 1.0
    variance = float(weight @ (values - mean) ** 2) / freedom
    together = np.tensordot(weight, np.array(responses), 1)
    common = max(float(together @ spread @ together), 0.0)
    # errors of the tests that happen to agree are no smaller than they are
    half = max(
        _quantile(level, freedom) * math.sqrt(variance), _quantile(level, math.inf) * math.sqrt(1.0 / float(np.sum(1.0 / own)))
    )
    half = math.hypot(half, _quantile(level, math.inf) * math.sqrt(common))
    error = math.sqrt(max(variance, 1.0 / float(np.sum(1.0 / own))) + common)
    return MeanOfTests(name, mean, error, Interval(mean - half, mean + half), math.sqrt(between), math.sqrt(common), len(values))


def _quantile(level: float, freedom: float) -> float:
    return float(call(native.fit_quantile, level, freedom))


def _paule_mandel(values: Array, own: Array) -> float:
    """The variance between tests under which their scatter is what it should be; 0 where their errors explain it."""

    def excess(between: float) -> float:
        weight = 1.0 / (own + between)
        mean = weight @ values / weight.sum()
        return float(weight @ (values - mean) ** 2) - (len(values) - 1.0)

    if excess(0.0) <= 0.0:
        return 0.0
    low, high = 0.0, float(np.var(values, ddof=1))
    while excess(high) > 0.0:
        low, high = high, 2.0 * high
    for _ in range(_ROUNDS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) > 0.0 else (low, middle)
    return 0.5 * (low + high)


def _prior_precision(result: FitResult) -> Array:
    """Inverse covariance of what was known beforehand, over the free parameters; rows of 0 for what was not."""
    problem = result.problem
    places = [problem.names.index(name) for name in result.names]
    sds = problem.table[4, places]
    alone = np.array([1.0 / sd**2 if sd > 0.0 else 0.0 for sd in sds])
    weights = problem.weights[:, places]
    return np.asarray(np.diag(alone) + weights.T @ weights)


def _response(result: FitResult, name: str) -> Array:
    """The derivative of the estimate with respect to each prior."""
    return np.asarray((result.covariance @ _prior_precision(result))[result.names.index(name)])
