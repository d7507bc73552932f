# SPDX-License-Identifier: GPL-3.0-or-later
"""The fit."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from ..._boundary import number
from ..._choices import code
from ...errors import CancelledError, InvalidArgumentError, MDRError
from .advice import advice
from .data import Data, ForceDepth
from .misfit import SMALL
from .parameters import Free, Instrument, JointPrior
from .problem import Problem, make_problem
from .result import FitResult
from .weighted import RULES, fit_weighted

_OTHER_STRESSES = ((1.0 / 3.0, False), (3.0, False), (1.0 / 9.0, False), (9.0, False), (0.6, True), (0.25, True), (1.5, True))
"""Times the stress that a search began with; or that of the best end, with the other parameters from there."""


def fit(
    data: Data,
    indenter: Any,
    medium: Any,
    free: Mapping[str, Free | float | None] | Iterable[str],
    *,
    instrument: Instrument | None = None,
    loss: str = "linear",
    loss_scale: float = 1.345,
    adhesion_rule: str = "automatic",
    sd_is_absolute: bool = True,
    max_iterations: int = 100,
    check_units: bool = True,
    known: Iterable[JointPrior] = (),
    contact_weight: float = 0.0,
    contact_weight_rule: str = "held",
) -> FitResult:
    """Finds the parameters under which indenter and medium explain the data best: nonlinear least squares of the same forward model
    that `Contact` computes, over GSL's trust region.

    data : ForceDepth(...), StiffnessDepth(...), ModulusRadius(...) or StiffnessRadius(...); of a viscoelastic medium
        ForceTime(...), DepthTime(...) or DynamicStiffness(...)
    indenter, medium : any of the library; their parameters are the fixed values, and the start of the free ones
    free : names of the free parameters, or a mapping from names to Free(start, lower=, upper=, prior=(value, sd)), a starting
        value or None. Names: those of `medium.parameters()`, as coating.E, thickness, substrate.E, alpha, layers[0].C44,
        layers[0].prestress, layers[0].interface.normal, E; indenter.radius, indenter.C0 of an AreaFunction, ...; work_of_adhesion,
        depth_offset, force_offset, frame_compliance, indenter_modulus, contact_depth_factor, area_factor
    instrument : Instrument(...): adhesion, offsets, frame compliance, the indenter's material
    loss : "linear"; "huber" or "cauchy" are robust against outliers beyond loss_scale standard deviations
    adhesion_rule : "automatic" (energy balance for the exact medium, the source's rule else), "paper" or "energy", which are for
        ForceDepth with adhesion
    sd_is_absolute : whether the standard deviations of the data are known, or their ratios only
    max_iterations : of one search, at least 1
    check_units : refuses data more than 300 times larger or smaller than the model at the start
    known : JointPrior(...) of several parameters together, as a tip's calibration gives them
    contact_weight : of ForceDepth: within this distance of first contact residuals count in proportion to their distance from it,
        for forces of other kinds act there; 0: all count alike [length]
    contact_weight_rule : "held": the weights are those at the contact point that is found, and stay while the residuals are made
        small; "moving": they follow the contact point while it is sought, so that it goes where it leaves large residuals out. That
        is the sum of squares of other programs, and between 0 and 60 % off "held" where other forces act at contact

    Bad data raise an exception; a search that does not converge returns its best point, and says so in `converged` and `warnings`.
    """
    options = (instrument, loss, loss_scale, adhesion_rule, sd_is_absolute, max_iterations, check_units, tuple(known))
    distance = number("contact_weight", contact_weight)
    if not 0.0 <= distance < math.inf:
        raise InvalidArgumentError(f"contact_weight = {contact_weight!r}: it must be at least 0 and finite")
    moves = bool(code("contact_weight_rule", contact_weight_rule, RULES))
    if distance > 0.0:
        if not isinstance(data, ForceDepth):
            raise InvalidArgumentError("contact_weight: it belongs to forces against depth")
        first = _fitted(make_problem(data, indenter, medium, free, *options))
        # weights beside standard deviations that are not known are their ratios
        absolute = bool(sd_is_absolute) and data.sd is not None
        options = (*options[:4], absolute, *options[5:])
        return fit_weighted(first, distance, moves, lambda part: make_problem(part, indenter, medium, free, *options), _fitted)
    return _fitted(make_problem(data, indenter, medium, free, *options))


def _fitted(problem: Problem) -> FitResult:
    """Under a cohesive stress the sum of squares has several minima: where the search ends in a poor one, it begins again from
    other stresses."""
    result = FitResult(problem, *problem.answer())
    if "cohesive_stress" in problem.free and _is_poor(result):
        column = problem.names.index("cohesive_stress")
        for factor, from_end in _OTHER_STRESSES:
            table = problem.table.copy()
            if from_end:
                table[0] = [result.values.get(name, start) for name, start in zip(problem.names, table[0], strict=True)]
            table[0, column] = np.clip(factor * table[0, column], table[1, column], table[2, column])
            other = _searched(problem._replace(table=table))
            if other is not None and _merit(other) > _merit(result):
                result = other
                if not _is_poor(result):
                    break
    result.warnings = advice(result)
    return result


def _searched(problem: Problem) -> FitResult | None:
    """None where the search does not even begin."""
    try:
        return FitResult(problem, *problem.answer())
    except CancelledError:
        raise
    except MDRError:
        return None


def _is_poor(result: FitResult) -> bool:
    return not result.converged or result.misfit.rms > SMALL


def _merit(result: FitResult) -> float:
    return result.log_likelihood - 0.5 * result.prior_chi_square
