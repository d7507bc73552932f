# SPDX-License-Identifier: GPL-3.0-or-later
"""What the models of a medium say to one problem, and how far they are apart."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from .._units import FORCE, LENGTH, Dimension
from ..contact import Contact
from ..errors import MDRError
from ..material import RIGID, Elastic
from ..medium import Coated, Graded, Homogeneous, Layered, Medium, Pair
from ..medium.models import MODELS
from ..problem import Problem, ProblemError
from .solve import Array, Curve, progress, solve

NEARLY_RIGID = 1000.0
"""A substrate this many times stiffer than the coating is also tried as a rigid base, and marked as such."""


class Answer(NamedTuple):
    """What one model says."""

    model: str
    medium: Medium
    curve: Curve


def answers_of(problem: Problem) -> tuple[list[Answer], list[tuple[str, str]]]:
    """The answers of all models, and the words of those that refuse."""
    problem.check_elastic()
    names = candidates(problem.medium)
    if not names:
        kind = type(problem.medium).__name__
        raise ProblemError(f"there is nothing to compare: a {kind} medium has one model; use a coated, layered or graded one")
    answers, refusals = [], []
    with progress(len(names), problem.control) as bar:
        for label, model, base in names:
            try:
                medium = _under(problem.medium, model, base)
                answers.append(Answer(label, medium, solve(Contact(problem.indenter, medium), problem.control, bar)))
            except MDRError as refusal:
                refusals.append((label, str(refusal)))
    if not answers:
        raise MDRError("no model answers this problem: " + "; ".join(f"{model}: {words}" for model, words in refusals))
    return answers, refusals


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


def response_of(problem: Problem) -> tuple[str, Any, Dimension]:
    """What the models are compared by: the force, or the depth where the force is prescribed."""
    if problem.control.name == "force":
        return "depth", lambda curve: curve.depth, LENGTH
    return "force", lambda curve: curve.force, FORCE


def spread_text(values: Array) -> str:
    """How far the largest of some values is above the smallest."""
    ratio = float(values.max() / values.min())
    if ratio < 3.0:
        return f"{100.0 * (ratio - 1.0):.1f} %"
    return f"factor {ratio:.1f}" if ratio < 100.0 else f"factor {ratio:.0f}"


def reference(answers: Sequence[Answer], values: Array) -> tuple[str, Array]:
    """What the models are measured by: the exact one, without it their median; `values` has one row for each answer."""
    for answer, row in zip(answers, values, strict=True):
        if answer.model == "exact":
            return "exact", row
    median: Array = np.exp(np.median(np.log(values), axis=0))
    return "median of the models", median
