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
"""Noise, standard error, readings in contact and misfit that may be noise, beyond which a curve says too little."""


class Rating(NamedTuple):
    """From 0 to 10, and why the curve should not count."""

    score: float
    reasons: tuple[str, ...]

    @property
    def is_sound(self) -> bool:
        """Whether there is no doubt about it."""
        return not self.reasons


def rate(result: FitResult) -> Rating:
    """10 for a curve without misfit and noise whose numbers are sharp; less in proportion to misfit (none is left at 10 % of the
    force), noise (at 50 %) and the largest relative standard error (at 50 %). A curve is sound where the search has converged, the
    model lies within 5 % of the data, noise is less than 20 % of the force, no standard error is larger than 30 % of its estimate,
    no estimate lies at a bound, no film that began stiffer than its base has ended
    softer, noise hides no misfit of more than 10 % of the force, and 10 readings or more are in contact."""
    error = max((_relative(result, name) for name in result.names), default=0.0)
    misfit, noise = (v if math.isfinite(v) else 1.0 for v in (result.misfit.rms, result.misfit.noise))
    shares = ((misfit, _MISFIT), (noise, _NOISE), (error, _ERROR))
    score = 10.0 * float(np.prod([max(1.0 - share / end, 0.0) for share, end in shares])) if result.converged else 0.0
    return Rating(score, tuple(_reasons(result, noise, error)))


def _reasons(result: FitResult, noise: float, error: float) -> list[str]:
    words = []
    if not result.converged:
        words.append("not converged")
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
