# SPDX-License-Identifier: GPL-3.0-or-later
"""A fit as the library takes it: a problem with its parameters, made from objects with names."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ... import _layout
from ..._boundary import Refusal, native, not_zero, outcome, record, whole, words_of
from ..._choices import code
from ..._units import dimensions
from ...errors import ArgumentTypeError, InvalidArgumentError
from ...loop import RULES
from ...medium.viscoelastic import is_viscoelastic
from .data import Data, ForceDepth, ModulusRadius, StiffnessDepth, StiffnessRadius
from .parameters import Free, Instrument, JointPrior, Pattern, handles_of, pattern_of, read_free, read_known
from .time_data import DepthTime, DynamicStiffness, ForceTime

_OF_CONTACT_DEPTH = ("contact_depth_factor", "contact_depth_scale")
_IN_TIME = (ForceTime, DepthTime, DynamicStiffness)
_OFFSETS, _CONTACT = ("depth_offset", "force_offset"), ("stiffness_factor", "area_factor")
_SEEN: Mapping[type[Data], tuple[str, ...]] = {
    ForceDepth: ("work_of_adhesion", "cohesive_stress", *_OFFSETS, "frame_compliance"),
    StiffnessDepth: (*_OFFSETS, "frame_compliance", *_OF_CONTACT_DEPTH, *_CONTACT),
    ModulusRadius: ("area_factor",),
    StiffnessRadius: ("frame_compliance", *_CONTACT),
    ForceTime: _OFFSETS,
    DepthTime: _OFFSETS,
    DynamicStiffness: ("frame_compliance", *_CONTACT),
}
"""The numbers of the instrument that each kind of data depends on; all of elastic bodies depend on its indenter."""
_BY_THE_LIBRARY = ("work_of_adhesion", "frame_compliance")
"""Numbers for which the library itself raises an error with viscoelastic bodies."""
LOSSES = words_of(_layout.FIT_LINEAR, _layout.FIT_HUBER, _layout.FIT_CAUCHY)


class Problem(NamedTuple):
    """Everything the library is given, and the way back to objects."""

    data: Data
    pattern: Pattern
    free: dict[str, Free]
    record: NDArray[Any]
    """`mdr_fit_problem`, without its parameters"""
    table: NDArray[np.float64]
    """(6, parameters): value, lower, upper, prior, standard deviation of the prior, is_free"""
    weights: NDArray[np.float64]
    """(joint priors, parameters)"""
    given: tuple[Any, ...]
    """the arguments of `make_problem` after the data, from which another process makes it anew"""

    def __reduce__(self) -> tuple[Any, ...]:
        return _made_again, (self.data, self.given, self.table)

    def call(self, function: Any, *further: Any, with_sd: bool = True) -> Any:
        """A compiled function of the problem, x, y, given, sd where it takes them, and of what follows."""
        parameters = np.zeros(self.table.shape[1], _layout.fit_parameter)
        for member, values in zip((_layout.fit_parameter.names or ())[: len(self.table)], self.table, strict=True):
            parameters[member] = values
        record = self.record.copy()
        record["parameter_count"], record["parameters"] = len(parameters), parameters
        weights = np.ascontiguousarray(self.weights)
        record["prior_count"], record["prior_weights"] = len(weights), weights
        record["branch"] = self.data.branch
        given, sd = (None if column is None else np.ascontiguousarray(column, float) for column in (self.data.given, self.data.sd))
        errors = (sd,) if with_sd else ()
        status, *results = outcome(function, record, self.data.x, self.data.y, given, *errors, *further)
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

    @property
    def names(self) -> list[str]:
        return self.pattern.names

    def predict(self, values: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Predicted readings for given parameters, and the contact radii, 0 out of contact."""
        radius = np.zeros(len(self.data.x))
        (fitted,) = self.changed(self.data, start=values).call(native.fit_predict, radius, with_sd=False)
        return np.asarray(fitted), radius

    def answer(self) -> Any:
        """Solution of the library: the arguments of a FitResult after the problem."""
        n, m = len(self.data.x), self.table.shape[1]
        numbers, points = [np.zeros(m) for _ in range(3)], [np.zeros(n) for _ in range(2)]
        found: list[NDArray[Any]] = [numbers[0], np.zeros((m, m)), numbers[1], np.zeros(m, np.intc), numbers[2], *points]
        summary = record(_layout.fit_summary)
        self.call(native.fit_solve, *found, summary)
        return *found, summary[0]


def _check_time(data: Data, medium: Any) -> None:
    """Data in time belong to viscoelastic bodies, and to them alone."""
    in_time = isinstance(data, _IN_TIME)
    if is_viscoelastic(medium) and not in_time:
        raise InvalidArgumentError(
            f"data = {type(data).__name__}(...): the body is viscoelastic; its data are ForceTime, DepthTime or "
            'DynamicStiffness, in problem files the kinds "force-time", "depth-time" and "dynamic-stiffness"'
        )
    if in_time and not is_viscoelastic(medium):
        raise InvalidArgumentError(
            f"data = {type(data).__name__}(...): the body is elastic and does not depend on time; begin with a "
            "Viscoelastic or a PowerLawRheology, or take the forces against depth"
        )


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
    known: Iterable[JointPrior] = (),
) -> Problem:
    """Checks the arguments of `fit` and translates them."""
    if not isinstance(data, Data):
        raise ArgumentTypeError(f"data = {data!r}: it must be ForceDepth(...), StiffnessDepth(...), ...")
    _check_time(data, medium)
    instrument, known = instrument or Instrument(), tuple(known)
    rule, loss_code = code("adhesion_rule", adhesion_rule, RULES), code("loss", loss, LOSSES)
    pattern = pattern_of(indenter, medium, instrument)
    names, values = pattern.names, pattern.values
    chosen = read_free(free, names)
    for name in data.also_free:
        chosen.setdefault(name, Free())
    given = (indenter, medium, dict(chosen), instrument, loss, loss_scale, adhesion_rule, sd_is_absolute, max_iterations,
             check_units, known)  # fmt: skip
    weights = read_known(known, names, chosen)
    _check_seen(data, pattern.instrument, chosen)
    _check_adhesion(data, pattern.instrument, chosen, adhesion_rule)
    is_elastic = _is_elastic(data, pattern.instrument, chosen)
    table = np.zeros((6, len(names)))
    table[0], table[1], table[2] = values, -math.inf, math.inf
    for i, name in enumerate(names):
        if name not in chosen:
            continue
        entry = chosen[name]
        start = values[i] if entry.start is None else entry.start
        table[:, i] = start, entry.lower, entry.upper, *(entry.prior or (0.0, 0.0)), 1.0
    for prior in known:
        for name, value in zip(prior.names, prior.values, strict=True):
            table[3, names.index(name)] = value
    if not len(data):
        raise InvalidArgumentError("too few points: 0. A fit needs at least one")
    problem = record(
        _layout.fit_problem,
        data_kind=data.code,
        **handles_of(indenter, medium),
        adhesion_rule=rule,
        loss=loss_code,
        loss_scale=not_zero("loss_scale", loss_scale),
        sd_is_relative=not sd_is_absolute,
        max_iterations=whole("max_iterations", max_iterations, 1),
        any_units=not check_units,
        is_elastic=is_elastic,
    )
    return Problem(data, pattern, chosen, problem, table, weights, given)


def _set_or_free(name: str, instrument: Instrument, free: Mapping[str, Free]) -> bool:
    """Whether a number of the instrument is free, or another than that of an instrument that reads what is."""
    return name in free or getattr(instrument, name) != getattr(Instrument(), name)


def _check_seen(data: Data, instrument: Instrument, free: Mapping[str, Free]) -> None:
    """Raise an error for numbers of the instrument that these data do not depend on and that would be ignored."""
    seen = next(names for kind, names in _SEEN.items() if isinstance(data, kind))
    in_time = isinstance(data, _IN_TIME)
    for name in dimensions(Instrument):
        if name in seen or not _set_or_free(name, instrument, free) or in_time and name in _BY_THE_LIBRARY and name not in free:
            continue
        given = f"free parameter {name!r}" if name in free else f"{name} = {getattr(instrument, name)!r}"
        known = ", ".join(n for n in dimensions(Instrument) if n in seen)
        raise InvalidArgumentError(f"{given}: {type(data).__name__} data do not depend on it, but on {known}. Omit it")


def _check_adhesion(data: Data, instrument: Instrument, free: Mapping[str, Free], rule: str) -> None:
    """Raise an error for range or rule of adhesion if there is no adhesion."""
    adheres = isinstance(data, ForceDepth) and _set_or_free("work_of_adhesion", instrument, free)
    has_range = _set_or_free("cohesive_stress", instrument, free)
    if has_range and not adheres:
        raise InvalidArgumentError(
            "cohesive_stress: it needs a work_of_adhesion, because the range of adhesion is work_of_adhesion/cohesive_stress. "
            "Give it, or make it free"
        )
    if has_range and rule == "paper":
        raise InvalidArgumentError("cohesive_stress: adhesion_rule = 'paper' has no cohesive zone. Use 'energy'")
    if rule != "automatic" and not adheres:
        raise InvalidArgumentError(
            f"adhesion_rule = {rule!r}: it needs adhesion. Omit it, or fit ForceDepth data with a work_of_adhesion"
        )


def _made_again(data: Data, given: tuple[Any, ...], table: NDArray[np.float64]) -> Problem:
    """A problem from another process: the handles in its record are those of objects that are made here."""
    return make_problem(data, *given)._replace(table=table)


def _is_elastic(data: Data, instrument: Instrument, free: Mapping[str, Free]) -> bool:
    """Whether the surface sinks in as under the indenter itself: as the data state, or as found if the contact depth is default."""
    if not isinstance(data, StiffnessDepth):
        return False
    changed = [name for name in _OF_CONTACT_DEPTH if _set_or_free(name, instrument, free)]
    if data.elastic is None:
        return data.seems_elastic and not changed
    if data.elastic and changed:
        raise InvalidArgumentError(f"{changed[0]}: with elastic = True the sink-in follows from the indenter. Omit one of them")
    return data.elastic


def _missing_offset(refusal: Refusal, problem: Problem) -> str:
    """Remedy if a search lost a parameter on the way, for a curve that may begin before contact."""
    begun = problem.table[0, refusal.entry - 1] > 0.0
    lost = "do not depend on it" in refusal.text or begun and "must begin above 0" in refusal.text
    is_curve = isinstance(problem.data, (ForceDepth, ForceTime, DepthTime))
    if not (lost and is_curve) or _set_or_free("depth_offset", problem.pattern.instrument, problem.free):
        return ""
    return "; if contact does not begin at depth 0, let depth_offset be free"


def _named(refusal: Refusal, problem: Problem) -> Refusal:
    """Translate an error of the library: it numbers parameters and calls data x and y, while users know names."""
    of_library, _, part = refusal.argument.partition(":")
    if of_library == "parameters" and refusal.entry:
        refusal.text += _missing_offset(refusal, problem)
        refusal.argument = problem.names[refusal.entry - 1] + (f":{part}" if part else "")
        refusal.entry = 0
    elif of_library in ("x", "y", "given"):
        refusal.argument = getattr(problem.data, f"{of_library}_name")
    return refusal
