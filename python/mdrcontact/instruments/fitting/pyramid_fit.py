# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of forces of a pyramid on a film: the readings become those of the equivalent cone, with the ratios of the fitted body."""

from __future__ import annotations

import copy
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import InvalidArgumentError
from .data import Data, ForceDepth
from .least_squares import central_differences
from .parameters import Instrument
from .problem import Problem, make_problem
from .pyramids import A_OVER_H, check_range, film_of, pyramid_correction, ratios, shape_of
from .result import FitResult

Array = NDArray[np.float64]

_ROUNDS, _FEW, _EQUAL = 40, 4, 1e-7
"""Largest numbers of fits, for results and for warnings; change of the ratios that ends them."""
_STEP = 1e-4
"""Step of derivatives, relative to the parameter or its standard error."""


def check_pyramid(data: Data, indenter: Any, medium: Any, free: Mapping[str, Any], instrument: Instrument, distance: float) -> None:
    """Raise an error where the table of pyramids does not hold."""
    name = "pyramid_correction = True"
    if not isinstance(data, ForceDepth):
        raise InvalidArgumentError(f"{name}: it belongs to forces against depth. Omit it")
    if instrument.work_of_adhesion or "work_of_adhesion" in free:
        raise InvalidArgumentError(f"{name}: the table of pyramids holds without adhesion. Omit one of them")
    if instrument.indenter is not None or "indenter_modulus" in free:
        raise InvalidArgumentError(f"{name}: the table of pyramids holds for a rigid indenter. Omit its material")
    if distance > 0.0:
        raise InvalidArgumentError(f"{name}: it does not go with contact_weight. Omit one of them")
    shape_of(indenter)
    film_of(medium)


def fit_pyramid(first: FitResult, make: Callable[[Data], Problem]) -> FitResult:
    """first : the fit of all readings as of a cone; make : problem of given data"""
    result, change = _repeated(first, _covered(first), make, _ROUNDS)
    result.converged = result.converged and change <= _EQUAL
    radius = result.problem.predict(result._values)[1]
    film = film_of(result.medium)
    widest = float(np.clip(np.max(radius) / film.thickness, *A_OVER_H))
    check_range(film, widest)
    _with_slope(result)
    result.pyramid_correction = pyramid_correction(result.indenter, result.medium, widest)
    return result


def corrected(result: FitResult) -> FitResult:
    """Estimates under the pyramid, of a fit as of a cone: after some rounds, without errors that include the slope of the ratio."""
    found, _ = _repeated(result, _covered(result), lambda part: make_problem(part, *result.problem.given), _FEW)
    check_range(film_of(found.medium))
    return found


def _repeated(first: FitResult, data: Data, make: Callable[[Data], Problem], rounds: int) -> tuple[FitResult, float]:
    """Fits until the ratios are those of the fitted body, and their last change."""
    problem, result, change = make(data), first, np.inf
    factor = np.ones(len(data))
    for _ in range(rounds):
        before, factor = factor, _ratio(problem, _values(problem, result))[1]
        change = float(np.max(np.abs(factor - before)))
        if change <= _EQUAL:
            break
        problem = make(_of_cone(data, factor, result.values))
        problem = problem.changed(problem.data, start=_values(problem, result))
        result = FitResult(problem, *problem.answer())
    return result, change


def _values(problem: Problem, result: FitResult) -> Array:
    """The values found, in the order of a problem."""
    return np.array([result.values.get(name, value) for name, value in zip(problem.names, problem.table[0], strict=True)])


def _ratio(problem: Problem, values: Array) -> tuple[Array, Array]:
    """Force of the cone, and ratio of forces, at each reading; 1 out of contact."""
    force, radius = problem.predict(values)
    indenter, medium, _ = problem.pattern.at(values)
    film = film_of(medium)
    factor, touches = np.ones(len(radius)), radius > 0.0
    factor[touches] = ratios(shape_of(indenter), film, radius[touches] / film.thickness)[:, 0]
    return force, factor


def _covered(result: FitResult) -> Data:
    """The readings without contact, and those at contact radii of the table."""
    radius = result.problem.predict(result._values)[1] / film_of(result.medium).thickness
    low, high = A_OVER_H
    keep = (radius == 0.0) | ((radius >= low) & (radius <= high))
    data = copy.copy(result.data)
    if keep.all():
        return data
    if not np.any(keep & (radius > 0.0)):
        raise InvalidArgumentError(
            f"pyramid_correction = True: a/h of the readings is {radius[radius > 0.0].min():.3g} to {radius.max():.3g}, and the "
            f"table of pyramids holds from {low:g} to {high:g}. Omit it"
        )
    data.x, data.y = data.x[keep], data.y[keep]
    data.sd, data.branch, data.tests = (None if one is None else one[keep] for one in (data.sd, data.branch, data.tests))
    words = (
        f"{int(np.sum(~keep))} of {len(keep)} readings are left out: the table of pyramids holds for a/h from {low:g} to {high:g}"
    )
    data.warnings = [*data.warnings, words]
    return data


def _of_cone(data: Data, factor: Array, values: Mapping[str, float]) -> Data:
    """The readings that the equivalent cone would give at the same depths."""
    part = copy.copy(data)
    zero = values["force_offset"]
    part.y = zero + (data.y - zero) / factor
    # the frame yields under the force of the pyramid
    part.x = data.x - values["frame_compliance"] * (data.y - part.y)
    part.sd = None if data.sd is None else data.sd / factor
    if data.unused is not None:
        order = np.argsort(data.x)
        x, y, *others = data.unused
        part.unused = (x, zero + (y - zero) / np.interp(x, data.x[order], factor[order]), *others)
    return part


def _with_slope(result: FitResult) -> None:
    """Let the errors include that the ratio changes with the parameters."""
    if not result.noise > 0.0:
        return
    problem, values = result.problem, result._values
    places = [problem.names.index(name) for name in result.names]
    sizes = [_STEP * (abs(values[i]) or result.standard_errors[name] or 1.0) for i, name in zip(places, result.names, strict=True)]
    moves = np.zeros((len(places), len(values)))
    moves[range(len(places)), places] = sizes
    force, _ = _ratio(problem, values)
    slope = central_differences(lambda at: _ratio(problem, at)[0], values, moves)
    change = (force - result.values["force_offset"])[:, None] * central_differences(
        lambda at: np.log(_ratio(problem, at)[1]), values, moves
    )
    sd = result.noise * (1.0 if result.data.sd is None else result.data.sd) * np.ones(len(force))
    scaled = result.covariance / np.outer(sizes, sizes)
    # the estimates follow from the readings by the covariance of independent noise
    wide = np.array([result.widening[name] for name in result.names])
    turn = np.linalg.inv(np.eye(len(places)) + scaled / np.outer(wide, wide) @ (slope / sd[:, None] ** 2).T @ change)
    result.covariance = turn @ scaled @ turn.T * np.outer(sizes, sizes)
    errors = np.sqrt(np.diag(result.covariance)).tolist()
    result.standard_errors = dict(zip(result.names, errors, strict=True))
