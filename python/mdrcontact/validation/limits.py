# SPDX-License-Identifier: GPL-3.0-or-later
"""The map of validity: what is exact, what is a model, and what the library reports at its limits."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from .. import lateral
from .._warn import collected
from ..accuracy import accuracy_map
from ..conduction import INSULATING, Conduction, Conductor, LayeredConductor
from ..contact import Contact
from ..errors import MDRError
from ..friction import Friction
from ..law import ContactLaw
from ..material import RIGID, Elastic, PowerLawRheology, TransverselyIsotropic
from ..medium import SLIDING, Coated, Homogeneous, Layer, Layered, Medium, PowerLawGraded, Surface
from ..medium.models import MODELS
from ..poroelastic import Poroelastic
from ..poroelastic import history as gel_history
from ..profile import Cone, FlatPunch, Paraboloid
from ..sheared import ShearedContact
from ..wear import Wear

_SOFT, _HARD = Elastic(1.0, 0.3), Elastic(10.0, 0.3)
_FILM = Coated(_HARD, 1.0, _SOFT)
_RELAXING = Homogeneous(PowerLawRheology(1.0, 1.0, 0.2, 0.5))
_GEL = Poroelastic(1.0, 0.2, 1.0)
_SLIDING = Layered([Layer(_HARD, 1.0, interface=SLIDING)], _SOFT)
_BONDED = Coated(Elastic(1.0, 0.5), 1.0, RIGID, "dimitriadis")
_RATIOS, _RADII = np.geomspace(0.5, 2.0, 5), np.geomspace(0.1, 10.0, 9)
"""Moduli of film over base and a/h, between which the models' errors are given."""


def _ball() -> Contact:
    """A new one each time: a contact warns once."""
    return Contact(Paraboloid(1.0), Homogeneous(_SOFT))


def _sheared(medium: Medium, around: bool = False) -> ShearedContact:
    contact = Contact(Paraboloid(1.0), medium)
    return ShearedContact(Friction(contact, 0.3), contact.at_depth(0.1), around)


class Limit(NamedTuple):
    """A capability, what its numbers are, and a step beyond its end."""

    capability: str
    kind: str
    beyond: str
    step: Callable[[], Any]


_EXACT = "exact, to the tolerance"
LIMITS: tuple[Limit, ...] = (
    Limit("any body", "linear elasticity", "Poisson's ratio 0.51", lambda: Elastic(1.0, 0.51)),
    Limit("any body", "linear elasticity", "d = 2 R", lambda: _ball().at_depth(2.0)),
    Limit("any body", "linear elasticity", "E0/E1 = 1e10", lambda: Contact(
        Paraboloid(1.0), Coated(Elastic(1e10, 0.3), 1.0, _SOFT)).at_radius(0.1)),
    Limit("indenters", "exact", "a punch, a = 2 of its radius", lambda: Contact(FlatPunch(1.0), _FILM).at_radius(2.0)),
    Limit("layers, model exact", _EXACT, "a/h = 2e4", lambda: Contact(Paraboloid(1e9), _FILM).at_radius(2e4)),
    Limit("layers, model exact", _EXACT, "tolerance 1e-13", lambda: Coated(_HARD, 1.0, _SOFT, tolerance=1e-13)),
    Limit("transversely isotropic layers", _EXACT, "C13 too large for a positive strain energy", lambda: TransverselyIsotropic(
        10.0, 2.0, 8.0, 10.0, 3.0)),
    Limit("transversely isotropic layers", _EXACT, "model gao", lambda: Coated(
        TransverselyIsotropic(10.0, 2.0, 3.0, 5.0, 3.0), 1.0, _SOFT, "gao")),
    Limit("interfaces", _EXACT, "a tangential load on a sliding layer", lambda: _sheared(_SLIDING).at_shift(0.01)),
    Limit("prestress", _EXACT, "compression beyond the wrinkling stress", lambda: Layered(
        [Layer(Elastic(1000.0, 0.3), 1.0, prestress=-20.0)], _SOFT)),
    Limit("surfaces with tension", "exact, to 1e-9", "compression without a plate", lambda: Contact(
        Paraboloid(1.0), Homogeneous(_SOFT, surface=Surface(tension=-1.0)))),
    Limit("surfaces with tension", "exact, to 1e-9", "partial slip", lambda: _sheared(
        Homogeneous(_SOFT, surface=Surface(tension=1.0))).at_shift(0.01)),
    Limit("power-law grading", "exact", "exponent 1", lambda: PowerLawGraded(1.0, 1.0, 1.0, 0.3)),
    Limit("dimitriadis, garcia", "model", "a/h = 1.5", lambda: Contact(Paraboloid(5.0), _BONDED).at_radius(1.5)),
    Limit("dimitriadis, garcia", "model", "a cone", lambda: Contact(Cone(0.3), _BONDED).at_radius(0.1)),
    Limit("finite-range adhesion", _EXACT, "a model of the medium", lambda: Contact(
        Paraboloid(1.0), _FILM.with_model("gao"), work_of_adhesion=1.0, cohesive_stress=1.0).at_radius(0.1)),
    Limit("adhesion", "exact", "a viscoelastic body", lambda: Contact(Paraboloid(1.0), _RELAXING, work_of_adhesion=1.0)),
    Limit("stresses inside", "exact, to ten digits", "power-law grading", lambda: Contact(
            Paraboloid(1.0), PowerLawGraded(1.0, 1.0, 0.5, 0.3)).at_radius(0.1).interior(0.0, 0.1)),
    Limit("partial slip", "exact mean around the axis", "power-law grading", lambda: _sheared(
        PowerLawGraded(1.0, 1.0, 0.5, 0.3)).at_shift(0.01)),
    Limit("torsion", "exact", "a coated body", lambda: _sheared(_FILM, around=True).at_shift(0.01)),
    Limit("histories of viscoelastic bodies", _EXACT, "an elastic state", lambda: Contact(
        Paraboloid(1.0), _RELAXING).at_depth(0.1)),
    Limit("histories of viscoelastic bodies", _EXACT, "a jump onto a power law", lambda: Contact(
        Paraboloid(1.0), _RELAXING).history([0.0, 1.0], depth=[0.1, 0.1])),
    Limit("gels", "exact at a constant radius", "a contact radius that changes", lambda: gel_history(
        Contact(Paraboloid(1.0), Homogeneous(_GEL)), [0.0, 1.0, 2.0], depth=[0.1, 0.1, 0.2], drainage="surface")),
    Limit("gels", "exact at a constant radius", "a film, a/h = 5", lambda: Contact(
        FlatPunch(5.0), Coated(_GEL, 1.0, RIGID)).relaxation(1.0, drainage="surface")),
    Limit("conduction", "exact, to 1e-11", "a/h = 2e4", lambda: Conduction(
        LayeredConductor(((Conductor(2.0), 1.0),), Conductor(1.0))).at_radius(2e4)),
    Limit("conduction", "exact, to 1e-11", "a film in the contact area, S R/a = 1e-7", lambda: Conduction(
        Conductor(1.0), film=1e-7).at_radius(1.0)),
    Limit("conduction", "exact, to 1e-11", "an insulating base without a sink", lambda: Conduction(
        LayeredConductor(((Conductor(2.0), 1.0),), INSULATING)).at_radius(1.0)),
    Limit("conduction in time", "to 1e-8", "D t/a^2 = 1e-6", lambda: Conduction(Conductor(1.0, None, 1.0)).step(1e-6, 1.0)),
    Limit("frictional heat", "exact for a prescribed flux", "a source with v a/D = 2000", lambda: Conduction(
        Conductor(1.0, None, 1.0)).friction_heat(_ball().at_radius(0.1), 0.3, 1.0, "moving", 2e4)),
    Limit("wear", "to the error that each state has", "a wear depth beyond a quarter of the coating", lambda: Wear(
        Contact(Paraboloid(1.0), _FILM), 1.0, body_coefficient=1.0).history(force=1.0, places="same").advance(10.0, force=1.0)),
    Limit("wear", "to the error that each state has", "adhesion", lambda: Wear(
        Contact(Paraboloid(1.0), _FILM, work_of_adhesion=1.0), 1.0).limit(_ball().at_radius(0.1), 0.05)),
    Limit("compiled laws", "to the tolerance, verified", "tolerance 1e-13", lambda: ContactLaw(_ball(), 0.1, tolerance=1e-13)),
    Limit("compiled laws", "to the tolerance, verified", "a depth beyond the largest", lambda: ContactLaw(_ball(), 0.1).force(0.2)),
    Limit("composites", "first order in the contrast", "tolerance 1e-11", lambda: lateral.Shapes(_SOFT, tolerance=1e-11)),
)  # fmt: skip
"""By capability; what is beyond is the library's own sentence, constants and all."""


def tables() -> list[tuple[str, list[list[str]]]]:
    """Titles and rows of the map."""
    return [("Errors of the approximate models", models()), ("Limits of validity", refusals())]


def models() -> list[list[str]]:
    """A row for each model: bodies, and its largest error of the force within a factor 2 of equal moduli."""
    found = accuracy_map(_RATIOS, _RADII)
    errors = dict(zip(found.models, (float(np.abs(error).max()) for error in found.force_error), strict=True))
    rows = [["model", "bodies", "largest error of F for moduli of film over base from 0.5 to 2 and a/h from 0.1 to 10"]]
    for name, model in MODELS.items():
        base = "rigid base only" if model.needs_rigid_base else "any base" if model.allows_rigid_base else "elastic base"
        more = [words for words, holds in (("several layers", model.layers), ("graded", model.graded)) if holds]
        error = "exact solution" if name == "exact" else f"{100.0 * errors[name]:.2g} %" if name in errors else "-"
        rows.append([name, ", ".join(["one film", *more, base]), error])
    return rows


def refusals() -> list[list[str]]:
    """Return a trial beyond each limit, and the message of the library: an error or a warning."""
    rows = [["capability", "accuracy", "beyond the limit", "message"]]
    for limit in LIMITS:
        rows.append([limit.capability, limit.kind, limit.beyond, _answer(limit.step)])
    return rows


def _answer(step: Callable[[], Any]) -> str:
    try:
        with collected() as caught:
            step()
    except MDRError as refusal:
        return " ".join(str(refusal).split())
    return f"a warning: {' '.join(caught[0].text.split())}" if caught else "it is computed"
