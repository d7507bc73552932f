# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `compare`: one problem under every model that applies to its medium, and the spread between them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from .._units import FORCE, LENGTH, MODULUS, RATIO, Dimension, practical
from ..contact import Contact
from ..errors import CancelledError, MDRError
from ..material import RIGID, Elastic
from ..medium import Coated, Graded, Homogeneous, Layered, Medium, Pair
from ..medium.models import MODELS
from ..panels import Axis, Figure, Line, Panel, Rule, along, marked
from ..problem import Problem, ProblemError
from ..progress import Progress
from .result import Array, Column, Number, Result, Table, Words, study
from .states import Curve, columns, solve, thickness

_LINEAR = 20.0
"""Values that differ by more than this factor are drawn on a logarithmic axis."""
NEARLY_RIGID = 1000.0
"""A substrate this many times stiffer than the coating is also tried as a rigid base, and marked as such."""


class Answer(NamedTuple):
    """Result of one model."""

    model: str
    medium: Medium
    curve: Curve


@dataclass(frozen=True, eq=False, kw_only=True)
class CompareResult(Result):
    """Results of all models. Table: "states", those of all models below each other."""

    problem: Problem
    answers: tuple[Answer, ...]
    refusals: tuple[tuple[str, str], ...]
    """models that do not support the problem, and their messages"""
    response: str
    """compared quantity: "force", or "depth" if the force is prescribed"""
    dimension: Dimension
    """of the response"""
    values: Array
    """the response, a row for each result"""
    basis: str
    """reference of the models: "exact", or "median of the models" """
    base: Array
    """the response of the basis"""

    def figure(self) -> Figure:
        """Return response, effective modulus and deviation of all models."""
        return Figure(self.title, tuple(_panels(self)), columns=3)


def _panels(found: CompareResult) -> Iterator[Panel]:
    control = found.problem.control
    x, given = along(control.name, control.dimension, control.values)
    h = thickness(found.problem.medium)
    moduli = np.concatenate([answer.curve.modulus for answer in found.answers])
    radii = np.concatenate([answer.curve.radius for answer in found.answers])
    radius, length = along("contact radius a", LENGTH, radii)
    y, unit = along(f"{found.response}", found.dimension, found.values.ravel(), log=_is_wide(found.values[:, -1]))
    yield Panel(x, y, _lines(found, lambda i: given.of(control.values), lambda i: unit.of(found.values[i])))
    modulus, pascal = along("effective modulus E_eff", MODULUS, moduli, log=_is_wide(moduli))
    lines = _lines(
        found,
        lambda i: found.answers[i].curve.radius / h if h else length.of(found.answers[i].curve.radius),
        lambda i: pascal.of(found.answers[i].curve.modulus),
    )
    rule = (Rule(1.0, vertical=True, name="a = h"),) if h and radii.min() <= h <= radii.max() else ()
    yield Panel(Axis("a/h", log=True) if h else radius._replace(log=True), modulus, (*lines, *rule))
    deviation = found.values / found.base
    ratio = Axis(f"{found.response} / {found.basis}", log=_is_wide(deviation))
    lines = _lines(found, lambda i: given.of(control.values), lambda i: deviation[i])
    yield Panel(x, ratio, lines)


def _is_wide(values: Array) -> bool:
    return bool(values.min() > 0.0 and values.max() > _LINEAR * values.min())


def _lines(found: CompareResult, x: Callable[[int], Array], y: Callable[[int], Array]) -> tuple[Line, ...]:
    """A line for each model; the exact one in black and wide."""
    names = [answer.model for answer in found.answers]
    return tuple(
        Line(x(i), y(i), name, "black", 0, marked(y(i)), 2.6)
        if name == "exact"
        else Line(x(i), y(i), name, i % 6, i // 6 % 3, marked(y(i), "os^"[i // 6 % 3]))
        for i, name in enumerate(names)
    )


@study
def compare(problem: Problem, *, progress: Progress | None = None) -> CompareResult:
    """Compute one problem under every model that supports its medium.

    Parameters
    ----------
    problem : Problem
        A problem with a coated, layered or graded medium; its adhesion is neglected.
    progress : Progress, optional
        Reports the states of all models, and can stop the work.

    Returns
    -------
    CompareResult
        `answers`, `refusals`; number "spread", the largest response over the smallest at the last state.

    Raises
    ------
    ProblemError
        The medium has one model only.
    MDRError
        No model solves the problem.

    Examples
    --------
    >>> from mdrcontact import problem, studies
    >>> oxide = {"E": "72 GPa", "nu": 0.17, "thickness": "500 nm"}
    >>> film = {"type": "coated", "model": "exact", "coating": oxide, "substrate": {"E": "163 GPa", "nu": 0.22}}
    >>> ball = {"shape": "sphere", "radius": "10 um"}
    >>> found = studies.compare(problem.read({"indenter": ball, "medium": film, "compute": {"depths": ["50 nm"]}}))
    >>> print(found.response, found.basis, found.numbers["spread"])
    force exact 1.73
    """
    progress = progress or Progress()
    problem.check_elastic()
    names = candidates(problem.medium)
    if not names:
        kind = type(problem.medium).__name__
        raise ProblemError(f"a {kind} medium has one model. Use a coated, layered or graded medium")
    answers, refusals = [], []
    total, done = len(names) * len(problem.control.values), 0

    def step(part: int) -> None:
        progress.step(done + part, total, "states")

    step(0)
    for label, model, base in names:
        try:
            medium = _under(problem.medium, model, base)
            answers.append(Answer(label, medium, solve(Contact(problem.indenter, medium), problem.control, step)))
            done += len(problem.control.values)
        except CancelledError:
            raise
        except MDRError as refusal:
            refusals.append((label, str(refusal)))
    if not answers:
        raise MDRError("no model solves this problem: " + "; ".join(f"{model}: {words}" for model, words in refusals))
    by_depth = problem.control.name == "force"
    values = np.array([a.curve.depth if by_depth else a.curve.force for a in answers])
    basis, base_values = _reference(answers, values)
    notes = {"adhesion": "The models are compared without adhesion."} if problem.adhesion else {}
    return CompareResult(
        title=problem.title,
        numbers={"spread": Number(float(values[:, -1].max() / values[:, -1].min()), RATIO)},
        notes={**notes, **{f"left out: {model}": words for model, words in refusals}},
        tables={"states": _below_each_other(answers)},
        problem=problem,
        answers=tuple(answers),
        refusals=tuple(refusals),
        response="depth" if by_depth else "force",
        dimension=LENGTH if by_depth else FORCE,
        values=values,
        basis=basis,
        base=base_values,
    )


def candidates(medium: object) -> list[tuple[str, str, object]]:
    """(label, model, substrate) of every model worth a comparison; substrate None leaves it as it is."""
    if isinstance(medium, Pair):
        same = all(candidates(body) for body in (medium.lower, medium.upper) if not isinstance(body, Homogeneous))
        return candidates(medium.lower) if same else []
    if getattr(medium, "surface", None) is not None and isinstance(medium, (Coated, Layered)):
        return [("exact", "exact", None)]
    if isinstance(medium, (Layered, Graded)):
        return [(name, name, None) for name, model in MODELS.items() if model.layers]
    if not isinstance(medium, Coated):
        return []
    coating: Any = medium.coating
    if not isinstance(medium.substrate, Elastic):
        return [(name, name, None) for name, model in MODELS.items() if model.needs_rigid_base or name == "exact"]
    found: list[tuple[str, str, object]] = [(name, name, None) for name, m in MODELS.items() if not m.needs_rigid_base]
    if medium.substrate.contact_modulus >= NEARLY_RIGID * coating.contact_modulus:
        found += [(f"{name} (rigid base)", name, RIGID) for name, model in MODELS.items() if model.needs_rigid_base]
    return found


def _under(medium: Any, model: str, base: Any) -> Medium:
    if isinstance(medium, Pair):
        upper = medium.upper if isinstance(medium.upper, Homogeneous) else _under(medium.upper, model, None)
        return Pair(_under(medium.lower, model, base), upper)
    if model == medium.model and base is None:
        return medium  # type: ignore[no-any-return]
    if base is None:
        return medium.with_model(model)  # type: ignore[no-any-return]
    return Coated(medium.coating, medium.thickness, base, model)


def _reference(answers: Sequence[Answer], values: Array) -> tuple[str, Array]:
    """Return the reference of the models: the exact one, or their median; `values` has one row for each result."""
    for answer, row in zip(answers, values, strict=True):
        if answer.model == "exact":
            return "exact", row
    median: Array = np.exp(np.median(np.log(values), axis=0))
    return "median of the models", median


def _below_each_other(answers: Sequence[Answer]) -> Table:
    """The tables of all models in one, in common units."""
    tables = [columns(answer.curve, answer.medium) for answer in answers]
    stacked: list[Column | Words] = [Words("model", [a.model for a in answers for _ in a.curve.depth])]
    dimensions = {"depth": LENGTH, "radius": LENGTH, "force": FORCE}
    for parts in zip(*tables, strict=True):
        values, first = np.concatenate([part.values for part in parts]), parts[0]
        unit = practical(dimensions[first.name], values) if first.name in dimensions else first.unit
        stacked.append(Column(first.name, values, unit))
    return stacked
