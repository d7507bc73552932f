# SPDX-License-Identifier: GPL-3.0-or-later
"""Tip and frame from indents into a known body."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..._warn import warn
from ...errors import InvalidArgumentError
from .causes import by_cause
from .data import StiffnessDepth
from .parameters import JointPrior
from .result import FitResult

_FEWEST_COMMON = 5
_APART = 2.0
"""Tests differ as wholes where their mean square is so many times that of their readings."""


def together(curves: Sequence[StiffnessDepth]) -> StiffnessDepth:
    """Several tests as one set of data: unloading curves point by point, CSM curves as their mean with its standard error, at the
    depths of the first that all of them reach."""
    if not curves:
        raise InvalidArgumentError("there are no curves")
    if len(curves) == 1:
        return curves[0]
    if all(curve.unloadings for curve in curves):
        columns = [np.concatenate([getattr(c, name) for c in curves]) for name in ("x", "force", "y", "sd")]
        # by depth: one test after the other they would look like a curve that goes back
        depth, force, stiffness, sd = (values[np.argsort(columns[0])] for values in columns)
        data = StiffnessDepth(depth, force, stiffness, sd=sd)
        data.seems_elastic = all(curve.seems_elastic for curve in curves)
        data.tests = np.repeat(np.arange(len(curves)), [len(c.x) for c in curves])[np.argsort(columns[0])]
    elif any(curve.unloadings for curve in curves):
        raise InvalidArgumentError("unloading curves and CSM curves cannot be calibrated together: take one kind")
    else:
        data = _mean(curves)
    said = {curve.elastic for curve in curves}
    if len(said) > 1:
        raise InvalidArgumentError("elastic is not the same for all curves: take one kind")
    (data.elastic,) = said
    data.warnings += by_cause((f"test {i}", words) for i, curve in enumerate(curves, start=1) for words in curve.warnings)
    return data


def _mean(curves: Sequence[StiffnessDepth]) -> StiffnessDepth:
    low, high = max(c.x.min() for c in curves), min(c.x.max() for c in curves)
    depth = np.sort(curves[0].x)
    depth = depth[(depth >= low) & (depth <= high)]
    if len(depth) < _FEWEST_COMMON:
        raise InvalidArgumentError(f"the curves have only {len(depth)} depths in common; at least {_FEWEST_COMMON} are needed")
    force, stiffness = [], []
    for c in curves:
        assert c.force is not None
        order = np.argsort(c.x)
        force.append(np.interp(depth, c.x[order], c.force[order]))
        stiffness.append(np.interp(depth, c.x[order], c.y[order]))
    mean = np.mean(stiffness, axis=0)
    # few curves do not determine the scatter at one depth: its ratio to the stiffness is taken as constant along the curve
    scatter = np.sqrt(np.mean((np.std(stiffness, axis=0, ddof=1) / mean) ** 2))
    return StiffnessDepth(depth, np.mean(force, axis=0), mean, sd=np.maximum(scatter * mean / np.sqrt(len(curves)), 1e-6 * mean))


def as_prior(result: FitResult) -> JointPrior:
    """Return the result of a calibration as a joint prior for later fits.

    Use it as `fit(..., known=[as_prior(calibration)])`.

    Parameters
    ----------
    result : FitResult
        A calibration whose free parameters all have a standard error.

    Returns
    -------
    JointPrior
        Values and covariance. If the data scatter more than their standard deviations, the covariance is multiplied by chi-square
        over the degrees of freedom; of several tests that differ systematically by that of the tests.

    Raises
    ------
    InvalidArgumentError
        A parameter has no standard error.

    References
    ----------
    birge-1932

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> silica = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    >>> force = mdr.Contact(mdr.Paraboloid(10e-6), silica).at_depth(depth).force
    >>> data = mdr.instruments.ForceDepth(depth, force, sd=1e-6)
    >>> calibration = mdr.instruments.fit(data, mdr.Paraboloid(9e-6), silica, ["indenter.radius"])
    >>> prior = mdr.instruments.as_prior(calibration)
    >>> print(prior.names, f"{prior.values[0]:.3e}")
    ('indenter.radius',) 1.000e-05
    """
    vague = [name for name in result.names if result.at_bound[name] or not result.standard_errors[name] > 0.0]
    if vague:
        raise InvalidArgumentError(f"{', '.join(vague)} has no standard error: fix it, and calibrate again")
    if not result.converged:
        warn("the calibration did not converge", UserWarning)
    values = tuple(result.estimates[name] for name in result.names)
    # what the tests do not agree in is not in their standard deviations (R. T. Birge, Phys. Rev. 40 (1932) 207)
    widening = max(result.reduced_chi_square, _of_tests(result)) if result.scatter > 0 else 1.0
    return JointPrior(result.names, values, tuple(map(tuple, (widening * result.covariance).tolist())))


def _of_tests(result: FitResult) -> float:
    """Mean square of what each test as a whole is off, in its standard deviations; 0 of a single test. The readings of a test are
    off together by drift, first contact or temperature, and are then worth one (Liang, Zeger, Biometrika 73 (1986) 13)."""
    tests = result.data.tests
    if tests is None:
        return 0.0
    sums = np.bincount(tests, result.residuals) / np.sqrt(np.bincount(tests))
    return float(np.sum(sums**2) / (len(sums) - 1))


def words_of_tests(result: FitResult) -> list[str]:
    """The systematic difference between the tests of a calibration, where that is more than their readings scatter."""
    tests = result.data.tests
    if tests is None or not _of_tests(result) > _APART * max(result.reduced_chi_square, 1.0):
        return []
    off = np.bincount(tests, result.data.y / result.fitted - 1.0) / np.bincount(tests)
    return [
        f"the tests differ as wholes by {100.0 * np.std(off, ddof=1):.2g} % of the stiffness at a depth (standard deviation): so "
        "will the modulus of a single test with this tip, beyond its interval; take the mean of several tests"
    ]
