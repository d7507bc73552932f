# SPDX-License-Identifier: GPL-3.0-or-later
"""The map of validity: what is exact, what is a model, and what the library itself says it does not do."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from ..accuracy import accuracy_map
from ..contact import Contact
from ..errors import MDRError
from ..friction import Friction
from ..material import RIGID, Elastic, PowerLawRheology
from ..medium import Coated, Homogeneous, PowerLawGraded
from ..medium.models import MODELS
from ..poroelastic import Poroelastic
from ..profile import Cone, FlatPunch, Paraboloid

_SOFT, _HARD = Elastic(1.0, 0.3), Elastic(10.0, 0.3)
_FILM = Coated(_HARD, 1.0, _SOFT)
_RATIOS, _RADII = np.geomspace(0.5, 2.0, 5), np.geomspace(0.1, 10.0, 9)
"""Moduli of film over base and a/h, between which the models' errors are given."""


def models() -> list[list[str]]:
    """A row for each model: bodies, and its largest error of the force within a factor 2 of equal moduli."""
    found = accuracy_map(_RATIOS, _RADII)
    errors = dict(zip(found.models, (float(np.abs(error).max()) for error in found.force_error), strict=True))
    rows = [["model", "bodies", "largest error of F, film over base 0.5 to 2, a/h 0.1 to 10"]]
    for name, model in MODELS.items():
        base = "rigid base only" if model.needs_rigid_base else "any base" if model.allows_rigid_base else "elastic base"
        more = [words for words, holds in (("several layers", model.layers), ("graded", model.graded)) if holds]
        error = "the equations' own solution" if name == "exact" else f"{100.0 * errors[name]:.2g} %" if name in errors else "-"
        rows.append([name, ", ".join(["one film", *more, base]), error])
    return rows


def _refusals() -> list[tuple[str, Callable[[], Any]]]:
    relaxing = Homogeneous(PowerLawRheology(1.0, 1.0, 0.2, 0.5))
    gel = Contact(Paraboloid(1.0), Homogeneous(Poroelastic(1.0, 0.2, 1.0)))
    bonded = Coated(Elastic(1.0, 0.5), 1.0, RIGID, "dimitriadis")
    return [
        ("Poisson's ratio", lambda: Elastic(1.0, 0.51)),
        ("dimitriadis, contacts wider than the layer", lambda: Contact(Paraboloid(5.0), bonded).at_radius(1.5)),
        ("dimitriadis, other indenters", lambda: Contact(Cone(0.3), bonded).at_radius(0.1)),
        ("adhesion with a range, models", lambda: Contact(
            Paraboloid(1.0), _FILM.with_model("gao"), work_of_adhesion=1.0, cohesive_stress=1.0).at_radius(0.1)),
        ("adhesion of viscoelastic bodies", lambda: Contact(Paraboloid(1.0), relaxing, work_of_adhesion=1.0)),
        ("states of viscoelastic bodies", lambda: Contact(Paraboloid(1.0), relaxing).at_depth(0.1)),
        ("a jump onto a power law", lambda: Contact(Paraboloid(1.0), relaxing).history([0.0, 1.0], depth=[0.1, 0.1])),
        ("gels whose contact moves", lambda: gel.history([0.0, 1.0, 2.0], depth=[0.1, 0.1, 0.2], drainage="surface")),
        ("partial slip, power-law grading", lambda: Friction(
            Contact(Paraboloid(1.0), PowerLawGraded(1.0, 1.0, 0.5, 0.3)), 0.3).at_shift(0.01, depth=0.1)),
        ("depths beyond the end of an indenter", lambda: Contact(FlatPunch(1.0), _FILM).at_radius(2.0)),
    ]  # fmt: skip


def refusals() -> list[list[str]]:
    """What is tried beyond the limits, and the library's own sentence."""
    rows = [["beyond", "what the library says"]]
    for name, attempt in _refusals():
        try:
            attempt()
        except MDRError as refusal:
            rows.append([name, " ".join(str(refusal).split())])
        else:
            rows.append([name, "it is computed"])
    return rows
