# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a curve is worth its place in a mean."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ...errors import MDRError
from .contradictions import contradictions
from .misfit import LARGE, percent
from .result import FitResult

_MISFIT, _NOISE, _ERROR = 0.1, 0.5, 0.5
"""At which nothing is left of the rating: parts of the force, of the force, of the estimate."""
_LOUD, _VAGUE, _FEWEST, _HIDDEN = 0.2, 0.3, 10, 0.1
"""Limits of a usable curve: noise, standard error, readings in contact and a misfit that may be noise."""


class Rating(NamedTuple):
    """Rating of a fitted curve, from `rate`.

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> silica = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    >>> force = mdr.Contact(mdr.Paraboloid(10e-6), silica).at_depth(depth).force
    >>> result = mdr.instruments.fit(mdr.instruments.ForceDepth(depth, force, sd=1e-6), mdr.Paraboloid(10e-6), silica, ["E"])
    >>> rating = mdr.instruments.rate(result)
    >>> print(f"{rating.score:.1f} {rating.is_sound}")
    10.0 True
    """

    score: float
    """0 to 10; 10 for sharp numbers without misfit and noise"""
    reasons: tuple[str, ...]
    """reasons why the curve should not count in a mean"""

    @property
    def is_sound(self) -> bool:
        """True if there are no reasons against it."""
        return not self.reasons


def rate(result: FitResult) -> Rating:
    """Rate a fitted curve from 0 to 10.

    The score decreases proportionally to the misfit (0 at 10 % of the force), to the noise (0 at 50 %) and to the largest relative
    standard error (0 at 50 %). A curve is sound if the search has converged, the contact is elastic, the misfit is at most 5 %, the
    noise at most 20 % of the force, every standard error at most 30 % of its estimate, no estimate is at a bound, no film that
    began stiffer than its base has become softer, noise hides no misfit above 10 % of the force, and at least 10 readings are in
    contact.

    Parameters
    ----------
    result : FitResult
        A fit.

    Returns
    -------
    Rating
        Score and reasons.

    Raises
    ------
    AttributeError
        `result` is not a `FitResult`.

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> silica = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    >>> force = mdr.Contact(mdr.Paraboloid(10e-6), silica).at_depth(depth).force
    >>> result = mdr.instruments.fit(mdr.instruments.ForceDepth(depth, force, sd=1e-6), mdr.Paraboloid(10e-6), silica, ["E"])
    >>> print(f"{mdr.instruments.rate(result).score:.1f}")
    10.0
    """
    error = max((_relative(result, name) for name in result.names), default=0.0)
    misfit, noise = (v if math.isfinite(v) else 1.0 for v in (result.misfit.rms, result.misfit.noise))
    shares = ((misfit, _MISFIT), (noise, _NOISE), (error, _ERROR))
    score = 10.0 * float(np.prod([max(1.0 - share / end, 0.0) for share, end in shares])) if result.converged else 0.0
    return Rating(score, tuple(_reasons(result, noise, error)))


def _reasons(result: FitResult, noise: float, error: float) -> list[str]:
    words = []
    if not result.converged:
        words.append("not converged")
    if result.is_plastic:
        words.append(result.verdict)
    if result.departure > LARGE:
        words.append(f"misses by {percent(result.departure)}")
    if result.hidden > _HIDDEN:
        words.append(result.verdict)
    if noise > _LOUD:
        words.append(f"noise {percent(noise)}")
    if error > _VAGUE:
        words.append(f"error {percent(min(error, 9.99))} of the estimate")
    if any(result.at_bound.values()):
        words.append("at a bound")
    words += [f"{name} softer than its base" for name in contradictions(result)]
    touching = _touching(result)
    if touching < min(_FEWEST, len(result.data)):
        words.append(f"{touching} readings in contact")
    return words


def _touching(result: FitResult) -> int:
    try:
        return int(np.sum(result.problem.predict(result._values)[1] > 0.0))
    except MDRError:
        return len(result.data)


def _relative(result: FitResult, name: str) -> float:
    """The standard error as a part of the value; offsets and what has a prior are no measure of the curve."""
    if name.endswith(("offset", "nu", "exponent")) or name == "frame_compliance" or result.problem.free[name].prior is not None:
        return 0.0
    if bool(np.any(result.problem.weights[:, result.problem.names.index(name)] != 0.0)):
        return 0.0
    value, sd = result.estimates[name], result.standard_errors[name]
    return sd / abs(value) if value else math.inf
