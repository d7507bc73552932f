# SPDX-License-Identifier: GPL-3.0-or-later
"""A fit as the library takes it: a problem of numbers, made from objects with names."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import _native
from .._boundary import check, number
from ..adhesion import RULES, code
from ..errors import ArgumentTypeError, InvalidArgumentError, MDRError
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
    codes: NDArray[np.int32]
    reals: NDArray[np.float64]
    objects: NDArray[np.int64]
    table: NDArray[np.float64]

    def columns(self) -> tuple[Any, ...]:
        """x, y and force; the library takes a force column even where it needs none."""
        force = self.data.x if self.data.force is None else self.data.force
        return self.data.x, self.data.y, force

    def sd(self) -> tuple[Any, int]:
        """Standard deviations, and whether there are any."""
        return (self.data.x, 0) if self.data.sd is None else (self.data.sd, 1)

    def leading(self) -> tuple[Any, ...]:
        """The arguments that every compiled function takes first."""
        return self.codes, self.reals, self.objects, self.table

    def changed(self, data: Data, priors: NDArray[np.float64] | None = None, start: NDArray[np.float64] | None = None) -> Problem:
        """The same problem with other data, priors and starting values: for simulations."""
        table = self.table.copy(order="F")
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
        try:
            *found, status = _native.fit_solve(*self.leading(), *self.columns(), *self.sd())
            check(status)
        except MDRError as refusal:
            raise type(refusal)(_named(str(refusal), self)) from None
        return found


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
    table = np.zeros((6, len(names)), order="F")
    table[0], table[1], table[2] = values, -math.inf, math.inf
    for i, name in enumerate(names):
        if name not in chosen:
            continue
        entry = chosen[name]
        start = values[i] if entry.start is None else entry.start
        table[:, i] = start, entry.lower, entry.upper, *(entry.prior or (0.0, 0.0)), 1.0
    problem_codes = [data.code, parts[0].code, parts[1].numbers.code, parts[1].model, parts[1].layers]
    problem_codes += [rule, loss_code, int(bool(sd_is_absolute)), max_iterations, int(bool(check_units))]
    if not len(data):
        raise InvalidArgumentError("too few points: there are none")
    return Problem(
        data,
        *parts,
        names,
        chosen,
        np.array(problem_codes, dtype=np.int32),
        np.array([number("loss_scale", loss_scale), *parts[1].options]),
        np.array([indenter._handle.address, medium._handle.address], dtype=np.int64),
        table,
    )


def _named(words: str, problem: Problem) -> str:
    """The library counts parameters and points; people know their names."""
    for i in range(len(problem.names), 0, -1):
        words = words.replace(f"entry {i} of parameters", problem.names[i - 1])
    words = words.replace(" of x ", f" of {problem.data.x_name} ").replace(" of y ", f" of {problem.data.y_name} ")
    words = words.replace("the same x,", f"the same {problem.data.x_name},")
    return words.replace("the same y,", f"the same {problem.data.y_name},")
