# SPDX-License-Identifier: GPL-3.0-or-later
"""Tip and frame from indents into a known body."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .._warn import warn
from ..errors import InvalidArgumentError
from .causes import by_cause
from .data import StiffnessDepth
from .parameters import JointPrior
from .result import FitResult

_FEWEST_COMMON = 5


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
    # of few curves the scatter at one depth says little: its ratio to the stiffness is taken as the same along the curve
    scatter = np.sqrt(np.mean((np.std(stiffness, axis=0, ddof=1) / mean) ** 2))
    return StiffnessDepth(depth, np.mean(force, axis=0), mean, sd=np.maximum(scatter * mean / np.sqrt(len(curves)), 1e-6 * mean))


def as_prior(result: FitResult) -> JointPrior:
    """What a calibration has found, as what later fits know beforehand: `mdr.fit(..., known=[mdr.as_prior(calibration)])`. Where
    the data scatter more than their standard deviations say, the covariance is larger by chi-square over the degrees of freedom."""
    vague = [name for name in result.names if result.at_bound[name] or not result.standard_errors[name] > 0.0]
    if vague:
        raise InvalidArgumentError(f"{', '.join(vague)} has no standard error: fix it, and calibrate again")
    if not result.converged:
        warn("the calibration did not converge", UserWarning)
    values = tuple(result.estimates[name] for name in result.names)
    # what the tests do not agree in is not in their standard deviations (R. T. Birge, Phys. Rev. 40 (1932) 207)
    widening = result.reduced_chi_square if result.scatter > 0 else 1.0
    return JointPrior(result.names, values, tuple(map(tuple, (widening * result.covariance).tolist())))
