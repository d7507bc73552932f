# SPDX-License-Identifier: GPL-3.0-or-later
"""A fit as the library takes it: a problem of numbers, made from objects with names."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import _layout, _native
from .._boundary import Refusal, address, number, outcome, record
from ..adhesion import RULES, code
from ..errors import ArgumentTypeError, InvalidArgumentError
from .data import Data
from .parameters import Free, Instrument, MediumNumbers, Numbers, of_indenter, of_instrument, of_medium, read_free

_LOSSES = {"linear": 0, "huber": 1, "cauchy": 2}


class Problem(NamedTuple):
    """Everything the library is told, and the way back to objects."""

    data: Data
    indenter: Numbers
    medium: MediumNumbers
    instrument: Numbers
    names: list[str]
    free: dict[str, Free]
    record: NDArray[Any]
    """`mdr_fit_problem`, without its parameters"""
    table: NDArray[np.float64]
    """(6, parameters): value, lower, upper, prior, standard deviation of the prior, is_free"""

    def call(self, function: Any, *further: Any) -> Any:
        """A compiled function of the problem, x, y, force and sd, and of what follows."""
        parameters = np.zeros(self.table.shape[1], _layout.fit_parameter)
        for member, values in zip(_layout.fit_parameter.names or (), self.table, strict=True):
            parameters[member] = values
        record = self.record.copy()
        record["parameter_count"], record["parameters"] = len(parameters), address(parameters)
        force, sd = (None if given is None else np.ascontiguousarray(given, float) for given in (self.data.force, self.data.sd))
        status, *results = outcome(function, address(record), self.data.x, self.data.y, address(force), address(sd), *further)
        if status:
            raise _named(Refusal(status), self).error()
        return results

    def changed(self, data: Data, priors: NDArray[np.float64] | None = None, start: NDArray[np.float64] | None = None) -> Problem:
        """The same problem with other data, priors and starting values: for simulations."""
        table = self.table.copy()
        if priors is not None:
            table[3] = priors
        if start is not None:
            table[0] = start
        return self._replace(data=data, table=table)

    def objects_at(self, values: NDArray[np.float64]) -> tuple[Any, Any, Any]:
        """Indenter, medium and instrument with these numbers."""
        i, m = len(self.indenter.values), len(self.medium.numbers.values)
        rows = [float(v) for v in values]
        return self.indenter.build(rows[:i]), self.medium.numbers.build(rows[i : i + m]), self.instrument.build(rows[i + m :])

    def answer(self) -> Any:
        """What the library finds: the arguments of a FitResult after the problem."""
        n, m = len(self.data.x), self.table.shape[1]
        found: list[NDArray[Any]] = [np.zeros(m), np.zeros((m, m)), np.zeros(m, np.intc), np.zeros(m), np.zeros(n), np.zeros(n)]
        summary = np.zeros(1, _layout.fit_summary)
        self.call(_native.fit_solve, *map(address, found), address(summary))
        return *found, summary[0]


def make_problem(
    data: Data,
    indenter: Any,
    medium: Any,
    free: Any,
    instrument: Instrument | None = None,
    loss: str = "linear",
    loss_scale: float = 1.345,
    adhesion_rule: str = "automatic",
    sd_is_absolute: bool = True,
    max_iterations: int = 100,
    check_units: bool = True,
) -> Problem:
    """Checks the arguments of `fit` and translates them."""
    if not isinstance(data, Data):
        raise ArgumentTypeError(f"data = {data!r} is not allowed: it must be ForceDepth(...), StiffnessDepth(...), ...")
    rule, loss_code = code("adhesion_rule", adhesion_rule, RULES), code("loss", loss, _LOSSES)
    if not isinstance(max_iterations, int) or max_iterations < 1:
        raise InvalidArgumentError(f"max_iterations = {max_iterations!r} is not allowed: it must be a whole number, at least 1")
    parts = of_indenter(indenter), of_medium(medium), of_instrument(instrument or Instrument())
    names = parts[0].names + parts[1].numbers.names + parts[2].names
    values = parts[0].values + parts[1].numbers.values + parts[2].values
    chosen = read_free(free, names)
    table = np.zeros((6, len(names)))
    table[0], table[1], table[2] = values, -math.inf, math.inf
    for i, name in enumerate(names):
        if name not in chosen:
            continue
        entry = chosen[name]
        start = values[i] if entry.start is None else entry.start
        table[:, i] = start, entry.lower, entry.upper, *(entry.prior or (0.0, 0.0)), 1.0
    if not len(data):
        raise InvalidArgumentError("too few points: there are none")
    problem = record(
        _layout.fit_problem,
        _native.fit_problem_init,
        data_kind=data.code,
        indenter=parts[0].code,
        profile=indenter._handle.address,
        medium=parts[1].numbers.code,
        medium_object=medium._handle.address,
        model=parts[1].model,
        layers=parts[1].layers,
        options=address(parts[1].options),
        adhesion_rule=rule,
        loss=loss_code,
        loss_scale=number("loss_scale", loss_scale),
        sd_is_absolute=bool(sd_is_absolute),
        max_iterations=max_iterations,
        check_units=bool(check_units),
    )
    return Problem(data, *parts, names, chosen, problem, table)


def _named(refusal: Refusal, problem: Problem) -> Refusal:
    """The library counts parameters and knows x and y; people know their names."""
    of_library, _, part = refusal.argument.partition(":")
    if of_library == "parameters" and refusal.entry:
        refusal.argument = problem.names[refusal.entry - 1] + (f":{part}" if part else "")
        refusal.entry = 0
    elif of_library in ("x", "y"):
        refusal.argument = problem.data.x_name if of_library == "x" else problem.data.y_name
    return refusal
