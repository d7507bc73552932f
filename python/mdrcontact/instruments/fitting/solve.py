# SPDX-License-Identifier: GPL-3.0-or-later
"""Fit of a contact to measured data by nonlinear least squares."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from ..._boundary import number
from ..._choices import code
from ...errors import CancelledError, InvalidArgumentError, MDRError
from ...plastic import YieldStress
from .advice import advice
from .data import Data, ForceDepth
from .misfit import SMALL
from .parameters import Free, Instrument, JointPrior
from .problem import Problem, make_problem
from .pyramid_fit import check_pyramid, fit_pyramid
from .result import FitResult
from .weighted import RULES, fit_weighted
from .yielding import first_yield, read_yield_stresses, refuse, reverse_yield

_OTHER_STRESSES = ((1.0 / 3.0, False), (3.0, False), (1.0 / 9.0, False), (9.0, False), (0.6, True), (0.25, True), (1.5, True))
"""Factors of the cohesive stress for further starts; True: of the best result, with its other parameters."""


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
    yield_stresses: Iterable[float | YieldStress | None] = (),
    pyramid_correction: bool = False,
) -> FitResult:
    """Fit parameters of indenter, medium and instrument to measured data.

    The fit is a nonlinear least-squares problem with the forward model of `Contact`.

    Parameters
    ----------
    data : ForceDepth, StiffnessDepth, ModulusRadius, StiffnessRadius, ForceTime, DepthTime or DynamicStiffness
        The measurement; the last three belong to viscoelastic media.
    indenter : Profile
        The indenter. Its numbers are the fixed values, and the starting values of free ones.
    medium : Medium
        The body. Its numbers are the fixed values, and the starting values of free ones.
    free : mapping or iterable of str
        Names of the free parameters, or a mapping from names to `Free`, a starting value or None. Names are those of
        `medium.parameters()`, as "coating.E", "thickness", "layers[0].C44"; "indenter.radius", "indenter.C0" and the like; and of
        the instrument "work_of_adhesion", "depth_offset", "force_offset", "frame_compliance", "indenter_modulus",
        "contact_depth_factor", "area_factor".
    instrument : Instrument, optional
        Adhesion, offsets, frame compliance and material of the indenter.
    loss : {"linear", "huber", "cauchy"}, optional
        The last two are robust against outliers beyond `loss_scale` standard deviations.
    loss_scale : float, optional
        Scale of a robust loss, > 0 [standard deviations].
    adhesion_rule : {"automatic", "paper", "energy"}, optional
        As in `Contact`; the last two need `ForceDepth` with adhesion.
    sd_is_absolute : bool, optional
        False if only the ratios of the standard deviations of the data are known.
    max_iterations : int, optional
        Largest number of iterations of one search, >= 1.
    check_units : bool, optional
        True rejects data more than 300 times larger or smaller than the model at the start.
    known : iterable of JointPrior, optional
        Joint priors of several parameters, as from the calibration of a tip.
    contact_weight : float, optional
        Of `ForceDepth`: within this distance of initial contact residuals are weighted proportionally to their distance from it,
        because other forces act there [length]. 0 weights all residuals equally.
    contact_weight_rule : {"held", "moving"}, optional
        "held": the weights belong to the contact point found and stay constant during the minimization. "moving": they follow the
        contact point during the search, which then moves to where it excludes large residuals. Other programs use that sum of
        squares; it differs by 0 to 60 % if other forces act at contact.
    yield_stresses : iterable of float, YieldStress or None, optional
        Yield stress of each layer from the surface down and of the body below, > 0; None for one that does not yield [modulus].
        `plastic.yield_stress_from_hardness` returns that of a hardness. Unloading curves and stiffnesses are then checked for
        unloading that yields again, R_Y > 2; curves of force against depth, for a contact that has yielded.
    pyramid_correction : bool, optional
        Of `ForceDepth` and `Berkovich`, `Vickers` or `CubeCorner` on one film: whether the forces are those of the pyramid instead
        of its equivalent cone, by the table of `pyramid_correction`. Readings outside its contact radii are left out. Data and
        fitted curve of the result are those of the cone at the same depths.

    Returns
    -------
    FitResult
        Estimates, uncertainties and quality of the fit. If the search does not converge, it is the best point found, with
        `converged` False and a warning.

    Raises
    ------
    InvalidArgumentError
        A name is unknown, a number is outside its range, the data do not determine anything, or the table of pyramids does not
        hold for the contact.
    ArgumentTypeError
        An object is of another type.
    DomainError
        R_Y exceeds 3, and the contact area is not measured: `area_factor` has no prior.

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> silica = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
    >>> noise = 1e-4 * np.random.default_rng(1).standard_normal(20)
    >>> data = mdr.instruments.ForceDepth(depth, silica.at_depth(depth).force + noise, sd=1e-4)
    >>> result = mdr.instruments.fit(data, mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(50e9, 0.17)), ["E"])
    >>> print(f"{result.estimates['E'] / 1e9:.2f} {result.standard_errors['E'] / 1e9:.2f}")
    71.89 0.35
    """
    options = (instrument, loss, loss_scale, adhesion_rule, sd_is_absolute, max_iterations, check_units, tuple(known))
    distance = number("contact_weight", contact_weight)
    if not 0.0 <= distance < math.inf:
        raise InvalidArgumentError(f"contact_weight = {contact_weight!r}: it must be at least 0 and finite")
    moves = bool(code("contact_weight_rule", contact_weight_rule, RULES))
    stresses = read_yield_stresses(yield_stresses, data, medium)
    if pyramid_correction:
        found = _of_pyramid(data, indenter, medium, free, options, distance)
    elif distance > 0.0:
        if not isinstance(data, ForceDepth):
            raise InvalidArgumentError("contact_weight: it belongs to forces against depth")
        first = _fitted(make_problem(data, indenter, medium, free, *options))
        # if the standard deviations are unknown, weights are their ratios
        absolute = bool(sd_is_absolute) and data.sd is not None
        options = (*options[:4], absolute, *options[5:])
        found = fit_weighted(first, distance, moves, lambda part: make_problem(part, indenter, medium, free, *options), _fitted)
    else:
        found = _fitted(make_problem(data, indenter, medium, free, *options))
    return _checked(found, stresses) if stresses else found


def _of_pyramid(data: Data, indenter: Any, medium: Any, free: Any, options: tuple[Any, ...], distance: float) -> FitResult:
    problem = make_problem(data, indenter, medium, free, *options)
    check_pyramid(data, indenter, medium, problem.free, problem.pattern.instrument, distance)
    first = FitResult(problem, *problem.answer())
    found = fit_pyramid(first, lambda part: make_problem(part, indenter, medium, free, *options))
    found.warnings = advice(found)
    return found


def _checked(result: FitResult, stresses: tuple[YieldStress, ...]) -> FitResult:
    """A result with what the yield stresses tell about it."""
    result.yield_ratio = first_yield(result, stresses)
    result.reverse_yield = reverse_yield(result, stresses)
    area = result.problem.free.get("area_factor")
    refuse(result.reverse_yield, area is not None and area.prior is not None)
    result.warnings = advice(result)
    return result


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
    """Result of a search; None if it cannot start."""
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
