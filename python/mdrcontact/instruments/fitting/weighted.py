# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of forces against depth in which readings next to first contact count less."""

from __future__ import annotations

import copy
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ...errors import InvalidArgumentError
from .data import Data
from .least_squares import central_differences
from .problem import Problem
from .result import FitResult

Array = NDArray[np.float64]

RULES = {"held": 0, "moving": 1}
_ROUNDS, _LEAST = 4, 1e-2
"""Rounds of fits with fixed weights, and the least weight of a residual."""
_STEP, _GROWTH, _ENOUGH, _MOST = 0.01, 1.5, 1e-6, 40
"""Search for the contact point, in units of the distance: first step, growth, last step, largest number of steps."""
_GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)


def fit_weighted(
    first: FitResult, distance: float, moves: bool, make: Callable[[Data], Problem], solve: Callable[[Problem], FitResult]
) -> FitResult:
    """first : the fit without weights; make : problem of given data; solve : fit of a problem"""
    search = _Weighted(first.data, distance, make, solve)
    # where contact begins is known after a fit only
    result = first
    for _ in range(_ROUNDS):
        result = search.free(result)
    if moves and "depth_offset" in result.names:
        result = search.moving(result)
    return result


class _Weighted:
    """The fits of one set of data under weights of any contact point."""

    def __init__(self, data: Data, distance: float, make: Callable[[Data], Problem], solve: Callable[[Problem], FitResult]) -> None:
        self.data, self.distance, self.make, self.solve = data, distance, make, solve
        self.sd = np.ones(len(data.x)) if data.sd is None else data.sd

    def problem(self, contact: float, start: FitResult) -> Problem:
        """Under the weights of a contact point."""
        part = copy.copy(self.data)
        part.sd = np.asarray(self.sd / self.weights(contact))
        problem = self.make(part)
        return problem.changed(part, start=_begin(problem, start))

    def weights(self, contact: float) -> Array:
        """Weights of the residuals."""
        return np.asarray(np.clip(np.abs(self.data.x - contact) / self.distance, _LEAST, 1.0))

    def free(self, before: FitResult) -> FitResult:
        """Under the weights of the contact point that was found before."""
        return self.solve(self.problem(before.values["depth_offset"], before))

    def at(self, contact: float, before: FitResult) -> tuple[float, FitResult]:
        """The sum of squares at a contact point, the other parameters free."""
        problem = self.problem(contact, before)
        i = problem.names.index("depth_offset")
        table = problem.table.copy()
        table[0, i], table[5, i] = contact, 0.0
        free = {name: one for name, one in problem.free.items() if name != "depth_offset"}
        found = self.solve(problem._replace(table=table, free=free))
        return float(np.sum(((self.data.y - found.fitted) * self.weights(contact) / self.sd) ** 2)), found

    def moving(self, begin: FitResult) -> FitResult:
        """The nearest minimum of the sum of squares whose weights follow the contact point."""
        contact = self.lowest(begin.values["depth_offset"], begin)
        _, found = self.at(contact, begin)
        return self.freed(found)

    def lowest(self, contact: float, begin: FitResult) -> float:
        """Downhill until it rises, then by golden sections."""

        def height(x: float) -> float:
            return self.at(x, begin)[0]

        step = _STEP * self.distance
        here = height(contact)
        if height(contact + step) > here:
            step = -step
        behind, x = contact - step, contact + step
        for _ in range(_MOST):
            y = height(x)
            if y >= here:
                break
            step *= _GROWTH
            behind, contact, here, x = contact, x, y, x + step
        else:
            raise InvalidArgumentError("contact_weight_rule = 'moving': the contact point leaves the curve")
        low, high = sorted((behind, x))
        left, right = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
        at_left, at_right = height(left), height(right)
        while high - low > _ENOUGH * self.distance:
            if at_left < at_right:
                high, right, at_right = right, left, at_left
                left = high - _GOLDEN * (high - low)
                at_left = height(left)
            else:
                low, left, at_left = left, right, at_right
                right = low + _GOLDEN * (high - low)
                at_right = height(right)
        return 0.5 * (low + high)

    def freed(self, found: FitResult) -> FitResult:
        """The same estimates, with errors that also include the change of the contact point and its weights."""
        problem = self.problem(found.values["depth_offset"], found)
        _, _, widening, bounds, direction, *_, summary = problem.answer()
        values = _begin(problem, found)
        places = [i for i, name in enumerate(problem.names) if name in problem.free]
        offset = problem.names.index("depth_offset")

        def residuals(at: Array) -> Array:
            return (self.data.y - problem.predict(at)[0]) * self.weights(at[offset]) / self.sd

        # by the size of each parameter, which are of different dimensions
        steps = [1e-4 * (self.distance if i == offset else max(abs(values[i]), 1e-3 * float(np.ptp(self.data.y)))) for i in places]
        moves = np.zeros((len(places), len(values)))
        moves[range(len(places)), places] = steps
        rest, jacobian = residuals(values), central_differences(residuals, values, moves)
        spread = float(rest @ rest) / max(len(rest) - len(places), 1) if self.data.sd is None else 1.0
        covariance = np.zeros((len(values), len(values)))
        scale = np.array([widening[i] * step for i, step in zip(places, steps, strict=True)])
        covariance[np.ix_(places, places)] = spread * np.outer(scale, scale) * np.linalg.pinv(jacobian.T @ jacobian)
        fitted = problem.predict(values)[0]
        summary = summary.copy()
        result = FitResult(problem, values, covariance, widening, bounds, direction, fitted, rest / np.sqrt(spread), summary)
        result.warnings = found.warnings
        return result


def _begin(problem: Problem, result: FitResult) -> Array:
    """The values found, from which the search continues."""
    return np.array([result.values.get(name, value) for name, value in zip(problem.names, problem.table[0], strict=True)])
