# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects in which every member is present once, drawn so that it matters: films of contrast 3, as thick as the contact is wide."""

from __future__ import annotations

import inspect
from dataclasses import dataclass
from typing import Any

import numpy as np

import mdrcontact as mdr
from mdrcontact import lateral
from mdrcontact.closed_forms import (
    adhesive_depth_scale,
    adhesive_radius_scale,
    coated_cone_force,
    coated_paraboloid_adhesive_depth,
    coated_paraboloid_force,
    reduced_adhesive_depth,
)
from mdrcontact.conduction import INSULATING, PERFECT, Conduction, Conductor, LayeredConductor, TabulatedConduction
from mdrcontact.plastic import Imprint, PlasticLaw, Yielding
from mdrcontact.poroelastic import Poroelastic
from mdrcontact.wear import Wear, wear_coefficient_from_scar, wear_coefficient_from_volume

from . import requests
from .tree import Call, Times, know, only_arguments

SLOW = {
    "half-space", "coated", "pairs", "axial", "rigid base", "engineered", "stack medium", "stack", "springs",
    "deciding springs", "pair", "stretched medium", "stretched", "stretched half-space", "deciding", "hay-crawford contact",
    "gao layers", "graded medium", "graded", "inside a graded body", "graded function medium", "weighted graded medium",
    "weighted graded", "power graded", "adhesion", "adhesion on a stack", "adhesion by a table", "cohesive zone",
    "adhesion on a stretched surface", "law of rheology", "speed", "rheology", "relaxing film", "relaxing base",
    "relaxing stack", "power-law film", "relaxing film under a punch", "adhesive history", "punch on a gel",
    "punch on a gel film", "friction on coating", "friction on springs", "friction on pair", "friction on weights",
    "wear on half-space", "wear on coating", "wear on springs", "wear of a coating on springs", "wear of a coating on stack",
    "wear of a coating", "wear of a coated tip", "law", "law with adhesion", "law with a range", "law with friction",
    "law with a conduction", "one conductor", "a moving source", "sources in time", "a spinning source", "two conductors",
    "two hot conductors", "elastic conductors", "coated conductor", "pair of conductors", "tabulated conduction", "Fibre",
    "shapes", "places of shapes", "voxels", "voxels beside", "lateral medium", "wear_coefficient_from_scar", "State.critical",
    "Contact.history", "Contact.creep", "Conduction.step", "Conduction.follow", "Conduction.friction_heat",
    "moving.friction_heat", "slide", "indentation_map",
    "Contact.pressure_in_time", "gel.compliance", "paraboloid on a gel", "poroelastic.history", "punch.pressure_in_time",
}  # fmt: skip
"""Scenes that take more than 0.06 s: ./runtests.sh walks them with --all alone."""


@dataclass(frozen=True)
class Scene:
    """An object, and the answers that it serves."""

    name: str
    object: Any
    answers: tuple[str, ...]
    only: tuple[str, ...] = ()
    """paths of the members that are changed here; none: all"""

    @property
    def quick(self) -> bool:
        """Whether it is walked by ./runtests.sh without --all."""
        return self.name not in SLOW


FILM, BASE, MIDDLE = mdr.Elastic(3.0, 0.25), mdr.Elastic(1.0, 0.35), mdr.Elastic(0.5, 0.2)
SPHERE = mdr.Sphere(4.0)
SOLID = mdr.Homogeneous(mdr.Elastic(1.0, 0.3))
COATED = mdr.Coated(FILM, 0.9, BASE)
GLUE = mdr.Interface(0.4, 5.0, 4.0)
STACK = mdr.Layered([mdr.Layer(FILM, 0.4, 0.05, GLUE), mdr.Layer(MIDDLE, 0.5, -0.02, mdr.Interface(0.2, 7.0, 3.0))], BASE)
PAIRS = mdr.Layered([(FILM, 0.4), (MIDDLE, 0.5)], BASE)
AXIAL = mdr.TransverselyIsotropic(3.4, 1.2, 1.0, 2.6, 0.8)
ENGINEERED = mdr.TransverselyIsotropic.from_engineering(1.0, 1.4, 0.3, 0.25, 0.5)

MEDIUM = ("modulus", "stiffness")
ALONG = ("tangential_modulus", "torsional_stiffness")
WAVES = (
    "compliance_normal", "compliance_shear", "compliance_twist", "compliance_coupling", "compliance_limits", "responses",
)  # fmt: skip
STATES = ("at_depth", "at_force", "at_radius")
FIELDS = ("pressure", "displacement", "line_load", "energy")
INSIDE = ("interior", "interior_sliding")


SPRUNG = mdr.Layered([mdr.Layer(FILM, 0.4, 0.0, GLUE), mdr.Layer(MIDDLE, 0.5, 0.0, mdr.Interface(0.2, 7.0, 3.0))], BASE)


def _elastic() -> list[Scene]:
    """Contacts without adhesion, and their media."""
    bodies = {"half-space": SOLID, "coated": COATED, "pairs": PAIRS, "axial": mdr.Coated(AXIAL, 0.9, ENGINEERED)}
    bodies["rigid base"] = mdr.Coated(FILM, 1.5, mdr.RIGID)
    bodies["engineered"] = mdr.Homogeneous(ENGINEERED)
    scenes = []
    for name, body in bodies.items():
        scenes.append(Scene(f"{name} medium", body, (*MEDIUM, *ALONG, *WAVES)))
        scenes.append(Scene(name, mdr.Contact(SPHERE, body), (*STATES, *FIELDS, *INSIDE)))
    # no stresses inside under a prestress
    scenes.append(Scene("stack medium", STACK, (*MEDIUM, "tangential_modulus", *WAVES, "wrinkling")))
    scenes.append(Scene("stack", mdr.Contact(SPHERE, STACK), (*STATES, "pressure", "displacement", "line_load")))
    scenes.append(Scene("springs", mdr.Contact(SPHERE, SPRUNG), (*FIELDS, *INSIDE)))
    scenes.append(Scene("deciding springs", mdr.Contact(SPHERE, SPRUNG), ("critical",), only=("medium.layers[0].interface",)))
    pair = mdr.Pair(COATED, mdr.Homogeneous(AXIAL))
    scenes.append(Scene("pair medium", pair, (*MEDIUM, *ALONG, *WAVES)))
    of_both = "displacement_of_bodies", "energy_of_bodies", "interior_upper"
    scenes.append(Scene("pair", mdr.Contact(SPHERE, pair), (*STATES, *FIELDS, *INSIDE, *of_both)))
    surface = mdr.Surface(0.3, 0.05, 0.6)
    for name, body in (("stretched", COATED.replace(surface=surface)), ("stretched half-space", SOLID.replace(surface=surface))):
        scenes.append(Scene(f"{name} medium", body, (*MEDIUM, "compliance_normal")))
        scenes.append(Scene(name, mdr.Contact(mdr.Paraboloid(4.0), body), (*STATES, "pressure", "displacement", "line_load")))
    scenes.append(Scene("stretched layers", PAIRS.replace(surface=surface), ("modulus", "compliance_normal"), only=("surface",)))
    plain = mdr.Contact(SPHERE, mdr.Coated(FILM, 0.9, BASE))
    scenes.append(
        Scene(
            "deciding",
            plain,
            ("critical", "first_failure", "gradient"),
            only=("indenter", "medium.coating", "medium.thickness", "medium.substrate"),
        )
    )
    blunt = mdr.FlatEndedParaboloid(0.6, 4.0)
    stiff = mdr.Contact(blunt, mdr.Coated(mdr.Elastic(100.0, 0.25), 0.3, BASE))
    scenes.append(Scene("not a single area", stiff, ("lowest_pressure",)))
    return scenes


def _models() -> list[Scene]:
    """Approximate models, with their options."""
    given: dict[str, dict[str, Any]] = {
        "gao": {"weight_nu": 0.2},
        "gao-series": {"weight_nu": "effective"},
        "gao-power": {"exponent": -0.4, "weight_nu": "substrate"},
        "doerner-nix": {"alpha": 0.9},
        "wave": {"wave_factor": 1.8},
        "mencik-exponential": {"alpha": 0.9},
        "mencik-reciprocal": {"alpha": 0.9},
        "bec": {},
        "perriot-barthel": {},
        "hay-crawford": {},
    }
    media = {name: mdr.Coated(FILM, 0.9, BASE, name, **options) for name, options in given.items()}
    rubber = mdr.Elastic(1.5, 0.5)
    media |= {name: mdr.Coated(rubber, 1.5, mdr.RIGID, name) for name in ("dimitriadis", "garcia")}
    scenes = [
        Scene(f"{name} {kind}", thing, answers)
        for name, medium in media.items()
        for kind, thing, answers in (
            ("medium", medium, MEDIUM),
            ("contact", mdr.Contact(mdr.Paraboloid(4.0), medium), (*STATES, "pressure", "line_load")),
        )
    ]
    layers = mdr.Layered([(FILM, 0.4), (MIDDLE, 0.5)], BASE, "gao-power", exponent=-0.4, weight_nu="effective")
    scenes.append(Scene("gao layers", mdr.Contact(SPHERE, layers), (*STATES, "pressure")))
    scenes.append(Scene("gao layers medium", layers, (*MEDIUM, "tangential_modulus")))
    inside = mdr.Contact(SPHERE, mdr.Coated(FILM, 0.9, BASE, "gao", weight_nu=0.2))
    scenes.append(Scene("gao inside", inside, ("energy", "displacement", "interior")))
    return scenes


def _young(z: float) -> float:
    return 1.0 + 2.0 * np.exp(-z)


def _poisson(z: float) -> float:
    return 0.35 - 0.1 * np.exp(-z)


def _effective(a: float) -> float:
    return 2.0 + 1.0 / (1.0 + a)


def _graded() -> list[Scene]:
    table = mdr.Graded([0.0, 0.6, 1.5], [3.0, 2.0, 1.0], [0.2, 0.3, 0.35])
    function = mdr.Graded(2.0, Times(_young), Times(_poisson))
    weighted = mdr.Graded([0.0, 0.6, 1.5], [3.0, 2.0, 1.0], [0.2, 0.3, 0.35], "gao-power", exponent=-0.4, weight_nu="effective")
    power = mdr.PowerLawGraded(1.2, 0.7, 0.3, 0.3)
    tabulated = mdr.TabulatedMedium([0.2, 0.7, 1.2, 4.0], [3.0, 2.5, 2.2, 2.0])
    called = mdr.CallableMedium(Times(_effective), 0.3, 1.2)
    return [
        Scene("graded medium", table, (*MEDIUM, *ALONG, *WAVES)),
        Scene("graded", mdr.Contact(SPHERE, table), (*STATES, "pressure", "displacement")),
        Scene("inside a graded body", mdr.Contact(SPHERE, table), ("interior",), only=("medium",)),
        Scene("graded function medium", function, MEDIUM),
        Scene("weighted graded medium", weighted, (*MEDIUM, "tangential_modulus")),
        Scene("weighted graded", mdr.Contact(SPHERE, weighted), (*STATES, "pressure")),
        Scene("power graded medium", power, (*MEDIUM, "compliance_normal")),
        Scene("power graded", mdr.Contact(SPHERE, power), (*STATES, "pressure", "displacement", "line_load")),
        Scene("tabulated medium", tabulated, MEDIUM),
        Scene("tabulated", mdr.Contact(SPHERE, tabulated), (*STATES, "pressure", "line_load")),
        Scene("called medium", called, (*MEDIUM, "modulus_at_ends")),
    ]


def _parabola(r: float) -> float:
    return r * r / 8.0


def _indenters() -> list[Scene]:
    """Every indenter on a coating."""
    r = [0.0, 0.3, 0.6, 1.0, 2.0]
    given = {
        "paraboloid": mdr.Paraboloid(4.0),
        "sphere": SPHERE,
        "cone": Call("Cone", mdr.Cone, inclination=20.0, degrees=True),
        "cone of half-angle": Call("Cone", mdr.Cone, half_angle=1.2, degrees=False),
        "cone in radian": mdr.Cone(0.3),
        "power": mdr.PowerLaw(3.0, 0.2),
        "punch": mdr.FlatPunch(0.8),
        "flat cone": Call("FlatEndedCone", mdr.FlatEndedCone, end_radius=0.3, inclination=20.0, degrees=True),
        "flat paraboloid": mdr.FlatEndedParaboloid(0.35, 4.0),
        "rounded cone": Call("RoundedCone", mdr.RoundedCone, blend_radius=0.3, inclination=20.0, degrees=True),
        "area function": mdr.AreaFunction([12.0, 0.9, 0.2], max_height=1.0, min_height=0.02),
        "table": mdr.TabulatedProfile(r, [x * x / 8.0 for x in r]),
        "mdr table": mdr.TabulatedMDRProfile(r, [x * x / 4.0 for x in r]),
        "function": mdr.CallableProfile(Times(_parabola), 2.0),
        "sum": mdr.Cone(0.1) + mdr.Paraboloid(5.0),
    }
    scenes = []
    for name, indenter in given.items():
        # a flat punch has no radius that determines a state
        states = STATES if name != "punch" else ("at_depth", "at_force")
        if name == "punch":
            scenes.append(Scene(name, indenter, ("profile_mdr",)))
        else:
            scenes.append(Scene(name, indenter, ("profile_height", "profile_mdr")))
        contact = Call("Contact", mdr.Contact, indenter=indenter, medium=COATED)
        if name in ("area function", "function"):
            scenes.append(Scene(f"end of the {name}", indenter, ("profile_end",), only=("max_height", "r_max")))
        scenes.append(Scene(f"{name} contact", contact, (*states, "pressure", "line_load"), only=("indenter",)))
    scenes.append(Scene("between", Call("Paraboloid.between", mdr.Paraboloid.between, upper_radius=3.0, lower_radius=9.0),
                        ("profile_height",)))  # fmt: skip
    return scenes


ADHESIVE = ("pull_off_force", "pull_off_depth", "loop_depth", "loop_force", "loop_spring")


def _adhesion() -> list[Scene]:
    """Contacts with adhesion, with and without a range, and with a work of adhesion that depends on speed."""
    states = (*STATES, "at_depth_loading", "punch_depth", "state_slope", "pressure", "displacement", "line_load")
    jkr = mdr.Contact(SPHERE, COATED, 0.02)
    layers = mdr.Contact(SPHERE, STACK, 0.02)
    table = ((0.2, 0.6, 1.0, 3.0), (0.95, 0.9, 0.87, 0.85))
    corrected = mdr.Contact(SPHERE, mdr.Coated(FILM, 0.9, BASE, "gao"), 0.02, "paper", zeta=table)
    range_ = mdr.Contact(SPHERE, COATED, 0.02, cohesive_stress=0.15)
    stretched = mdr.Contact(mdr.Paraboloid(4.0), COATED.replace(surface=mdr.Surface(0.3, 0.05, 0.6)), 0.02)
    law = mdr.adhesion.RateAdhesion(0.02, 0.1, 0.6, 0.012, 0.2, 0.5)
    relaxing = mdr.Viscoelastic(0.4, [(1.5, 0.4)], nu=0.45)
    rheological = mdr.adhesion.RheologicalAdhesion(relaxing, 0.02, 1.5)

    def contact(**given: Any) -> Call:
        return Call("Contact", mdr.Contact, indenter=SPHERE, **given)

    histories = ("rate_history", "rate_history_force", "rate_history_spring")
    return [
        Scene("adhesion", jkr, (*states, *ADHESIVE, "energy", "interior")),
        Scene("adhesion on a stack", layers, (*states, *ADHESIVE)),
        Scene("adhesion by a table", corrected, (*STATES, "pressure", "pull_off_force")),
        Scene("cohesive zone", range_, (*states, "zone", *ADHESIVE)),
        Scene("adhesion on a stretched surface", stretched, (*STATES, "pull_off_force", "pressure")),
        Scene("law of speed", law, ("at_speed",)),
        Scene("opening edge alone", mdr.adhesion.RateAdhesion(0.02, 0.1, 0.6), ("at_speed",)),
        Scene("law of rheology", rheological, ("at_speed",)),
        Scene("speed", contact(medium=COATED, adhesion=law), (*histories, "at_depth", "pull_off_force")),
        Scene("rheology", contact(medium=mdr.Homogeneous(relaxing.relaxed), adhesion=rheological), (histories[0], "at_depth"),
              only=("adhesion",)),
    ]  # fmt: skip


PRONY = mdr.Viscoelastic(0.5, [(1.0, 0.5), (0.6, 3.0)], nu=0.3)
BULKY = mdr.Viscoelastic(0.4, [(1.2, 1.0)], bulk_modulus=3.0)
DASHPOT = mdr.Viscoelastic(0.5, [(1.0, 0.7)], nu=0.3, viscosity=0.3)
POWER = mdr.PowerLawRheology(1.0, 0.8, 0.3, 0.35)
STEPS = ("relaxation", "creep", "dynamic_radius")
HISTORIES = ("history_depth", "history_force", "history_radius")


def _time() -> list[Scene]:
    """Bodies that relax."""
    layers = mdr.Layered(
        [mdr.Layer(BULKY, 0.4, 0.0, mdr.Interface(0.2, 5.0, 4.0)), mdr.Layer(MIDDLE, 0.5, 0.0, mdr.Interface(0.1, 7.0, 3.0))], BASE
    )
    given = {
        "relaxing half-space": mdr.Homogeneous(PRONY),
        "relaxing bulk": mdr.Homogeneous(BULKY),
        "relaxing film": mdr.Coated(PRONY, 0.9, BASE),
        "relaxing base": mdr.Coated(FILM, 0.9, BULKY),
        "relaxing stack": layers,
        "relaxing film on a rigid base": mdr.Coated(PRONY, 0.9, mdr.RIGID),
    }
    scenes = []
    for name, body in given.items():
        scenes.append(Scene(f"{name} medium", body, ("compliance_omega",)))
        scenes.append(Scene(name, mdr.Contact(SPHERE, body), (*STEPS, "dynamic_depth", "dynamic_force", *HISTORIES)))
    scenes += [
        Scene("power-law half-space", mdr.Contact(SPHERE, mdr.Homogeneous(POWER)), (*STEPS, "dynamic_depth", *HISTORIES)),
        Scene("power-law film", mdr.Contact(SPHERE, mdr.Coated(POWER, 0.9, BASE)), STEPS),
        Scene("relaxing film under a punch", mdr.Contact(mdr.FlatPunch(0.8), mdr.Coated(PRONY, 0.9, BASE)), ("punch_in_time",)),
        Scene("dashpot", mdr.Contact(SPHERE, mdr.Homogeneous(DASHPOT)), (*STEPS, "dynamic_depth", "dynamic_force")),
        Scene("weighted relaxing film", mdr.Contact(SPHERE, mdr.Coated(PRONY, 0.9, mdr.Viscoelastic(1.0, [(2.0, 0.5), (1.2, 3.0)],
              nu=0.35), "gao", weight_nu=0.2)), STEPS),
        Scene("adhesive history", mdr.Contact(SPHERE, mdr.Homogeneous(PRONY), 0.02, cohesive_stress=0.15), ("adhesive_history",)),
    ]  # fmt: skip
    for name, material in (("prony", PRONY), ("bulk", BULKY)):
        scenes.append(Scene(f"{name} material", material, ("material_in_time", "material_glassy", "material_relaxed")))
    scenes.append(Scene("dashpot material", DASHPOT, ("material_in_time", "material_relaxed")))
    scenes.append(Scene("power-law material", POWER, ("material_in_time",)))
    return scenes


def _gels() -> list[Scene]:
    gel = Poroelastic(1.0, 0.25, 0.4)
    punch, film = mdr.FlatPunch(0.8), mdr.Coated(gel, 0.9, mdr.RIGID)
    steps = ("gel_steps", "gel_dynamic", "gel_history")
    return [
        Scene("gel", gel, ("gel_moduli",)),
        Scene("gel from permeability", Call("Poroelastic.from_permeability", Poroelastic.from_permeability, shear_modulus=1.0,
              nu=0.25, permeability=0.1, viscosity=0.3), ("diffusivity",)),
        Scene("gel medium", mdr.Homogeneous(gel), ("gel_compliance",)),
        Scene("gel film medium", film, ("gel_compliance",)),
        Scene("punch on a gel", mdr.Contact(punch, mdr.Homogeneous(gel)), (*steps, "gel_pressure")),
        Scene("paraboloid on a gel", mdr.Contact(mdr.Paraboloid(4.0), mdr.Homogeneous(gel)), ("gel_history", "gel_pressure")),
        Scene("punch on a gel film", mdr.Contact(punch, film), steps),
    ]  # fmt: skip


SHEAR = ("shear_at_shift", "shear_at_force", "shear_fields", "shear_cycles")
RUBBED = ("friction_history", "friction_history_force")


def _friction() -> list[Scene]:
    contacts = {
        "half-space": SOLID,
        "coating": COATED,
        "springs": SPRUNG,
        "pair": mdr.Pair(COATED, mdr.Homogeneous(MIDDLE)),
        "weights": mdr.Coated(FILM, 0.9, BASE, "gao", weight_nu=0.2),
    }
    scenes = []
    for name, body in contacts.items():
        turned = ("twisted",) if name == "half-space" else ()
        turned += () if name == "weights" else RUBBED
        scenes.append(Scene(f"friction on {name}", mdr.Friction(mdr.Contact(SPHERE, body), 0.4), (*SHEAR, *turned)))
    return scenes


def _imprints() -> list[Scene]:
    scenes = []
    for name, body, recovery in (("half-space", SOLID, 0.039), ("coating", COATED, 0.024)):
        record = Imprint(body, 0.8, 0.05, 0.005, 0.005 + recovery)
        scenes.append(Scene(f"imprint on {name}", record, ("imprint_unloading", "imprint_pull_off")))
    terms = Call("from_two_terms", Imprint.from_two_terms, body=COATED, radius=0.8, uniform=0.02, hertz=0.01, depth=0.1)
    r, p = (0.0, 0.2, 0.4, 0.6, 0.7, 0.8), (0.03, 0.0297, 0.0287, 0.0266, 0.0248, 0.02)
    points = Call("from_pressure", Imprint.from_pressure, body=COATED, r=r, p=p, depth=0.1)
    scenes.append(Scene("imprint of two terms", terms, ("imprint_of_two_terms",)))
    scenes.append(Scene("imprint of a pressure", points, ("imprint_of_pressure",)))
    return scenes


def _wear() -> list[Scene]:
    worn = ("wear_limit", "wear_limit_force", "wear_at_depth", "wear_at_force", "wear_rings", "wear_same_places")
    scenes = []
    for name, body in (("half-space", SOLID), ("coating", COATED), ("springs", SPRUNG)):
        wear = Wear(mdr.Contact(SPHERE, body), 0.3, body_coefficient=0.1)
        scenes.append(Scene(f"wear on {name}", wear, (*worn, "wear_track")))
    bracket = Wear(mdr.Contact(SPHERE, COATED), 0.3, body_coefficient=0.1)
    for name, body in (("springs", SPRUNG), ("stack", STACK)):
        wear = Wear(mdr.Contact(SPHERE, body), 0.3, body_coefficient=0.1)
        scenes.append(Scene(f"wear of a coating on {name}", wear, ("wear_bracket", "wear_bracket_force"), only=("contact.medium",)))
    scenes.append(Scene("wear of a coating", bracket, ("wear_bracket", "wear_bracket_force")))
    layers = Wear(mdr.Contact(SPHERE, COATED), (0.4, 0.15), (0.01,), 0.1)
    scenes.append(Scene("wear of a coated tip", layers, ("wear_at_depth", "wear_rings")))
    punch = Wear(mdr.Contact(mdr.FlatPunch(0.8), COATED), 0.3)
    scenes.append(Scene("wear of a punch", punch, ("wear_running_in", "wear_rings")))
    return scenes


def _rubbed_law(friction: mdr.Friction, **given: Any) -> mdr.ContactLaw:
    """The law of a contact with friction, which is one argument here: both would have to change together."""
    return mdr.ContactLaw(friction.contact, friction=friction, **given)


def _laws() -> list[Scene]:
    rows = ("law_at_depth", "law_at_force", "law_energy", "law_buffer", "law_facts")
    rest = {"smallest_depth": 1e-4, "tolerance": 1e-7, "continue_beyond": False, "description": "a law"}
    contact, solid = mdr.Contact(SPHERE, COATED), mdr.Contact(mdr.Paraboloid(4.0), SOLID)
    adhesive = {"largest_depth": 0.3, "tolerance": 1e-7}

    def law(**given: Any) -> Call:
        return Call("ContactLaw", mdr.ContactLaw, **given)

    return [
        Scene("law", law(contact=contact, largest_depth=0.3, **rest), rows),
        Scene("continued law", law(contact=mdr.Contact(mdr.Paraboloid(4.0), COATED), largest_depth=0.3, tolerance=1e-8,
              continue_beyond=True), ("law_beyond", "law_with_radius")),
        Scene("law with adhesion", law(contact=mdr.Contact(SPHERE, COATED, 0.02), **adhesive), rows),
        Scene("law with a range", law(contact=mdr.Contact(SPHERE, COATED, 0.02, cohesive_stress=0.15), **adhesive), rows),
        Scene("law with friction", Call("ContactLaw", _rubbed_law, friction=mdr.Friction(solid, 0.4), largest_depth=0.3, sliders=8,
              twist=False, tolerance=1e-7), ("law_shear",)),
        Scene("law with a shear strength", law(contact=solid, largest_depth=0.3, shear_strength=0.1, sliders=8, tolerance=1e-7),
              ("law_shear",)),
        Scene("law with a conduction", law(contact=solid, largest_depth=0.3, conduction=Conduction(
              LayeredConductor([(Conductor(0.3, 0.4), 0.5), mdr.Interface(0.3)], Conductor(1.0, 0.8))),
              tolerance=1e-5), ("law_conductance",)),
    ]  # fmt: skip


def _plastic_laws() -> list[Scene]:
    rising = Yielding(mdr.Elastic(1.0, 0.3), hardening=[(0.0, 2e-3), (0.01, 2.1e-3), (0.03, 2.2e-3)])
    flat = Yielding(mdr.Elastic(1.0, 0.3), yield_stress=2e-3)

    def law(**given: Any) -> Call:
        return Call("PlasticLaw", PlasticLaw, profile=mdr.Paraboloid(4.0), largest_depth=0.02, tolerance=1e-7, **given)

    rows = ("plastic_steps", "plastic_loading", "plastic_facts")
    return [
        Scene("plastic law", law(metal=flat, other=mdr.Elastic(3.0, 0.25)), (*rows, "plastic_with_radius", "plastic_table")),
        Scene("plastic law with hardening", law(metal=rising), (*rows, "plastic_table")),
        Scene("plastic law with adhesion", law(metal=flat, work_of_adhesion=3e-8), rows),
    ]


SPOTS = ("spot", "spot_fields", "conduction_compliance", "friction_heat", "along", "tabulated")
LATE = ("conduction_compliance_omega", "conduction_step", "conduction_follow", "admittance", "step_flux")


def _plastic_models() -> list[Scene]:
    film, base = mdr.Elastic(1.0, 0.3), mdr.Elastic(3.0, 0.2)
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Layered([(film, 0.06)], base))
    return [
        Scene("overload rule", mdr.plastic.Overload(contact, (6e-3, 0.05)), ("overload", "coated_law")),
        Scene(
            "overload of a half-space",
            mdr.plastic.Overload(mdr.Contact(mdr.Cone(0.05), mdr.Homogeneous(film)), (6e-3,)),
            ("overload",),
        ),
        Scene(
            "pressure cap",
            mdr.plastic.PressureCap(mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(film, 0.02, base)), 0.015),
            ("pressure_cap",),
            only=(
                "hardness",
                "contact.indenter",
                "contact.medium.coating",
                "contact.medium.thickness",
                "contact.medium.substrate.E",
            ),
        ),
    ]


def _conduction() -> list[Scene]:
    conductors = [Conductor(3.0, 2.4, 1.5), Conductor(0.4, 0.6, 0.8), Conductor(1.0, 0.7, 1.2)]
    stack = LayeredConductor([(conductors[0], 0.4), mdr.Interface(0.4), (conductors[1], 0.5), mdr.Interface(0.3)], conductors[2])
    other = LayeredConductor([(Conductor(0.6, 0.8, 0.7), 0.6)], Conductor(2.0, 1.5, 1.1))
    film, base = (material.replace(conductor=one) for material, one in zip((FILM, BASE), conductors[::2], strict=True))
    elastic = mdr.Layered([(film, 0.4), (MIDDLE.replace(conductor=conductors[1]), 0.5)], base)
    joined = mdr.Layered([mdr.Layer(film, 0.4, 0.0, GLUE), mdr.Layer(MIDDLE.replace(conductor=conductors[1]), 0.5)], base)
    sinking = LayeredConductor([(conductors[0], 0.4), mdr.Interface(0.4), (conductors[1], 0.9)], INSULATING)
    return [
        Scene("one conductor", Conduction(stack), (*SPOTS, *LATE)),
        Scene("a moving source", Conduction(LayeredConductor([(conductors[0], 0.4)], conductors[1])),
              ("friction_heat_moving",)),
        Scene("sources in time", Conduction(conductors[0]), ("conduction_step_flux_answers",)),
        Scene("a spinning source", Conduction(conductors[0]), ("friction_heat_spinning",), only=("body",)),
        Scene("two conductors", Conduction(stack, other, 0.2), ("spot", "conduction_compliance", "spot_upper", "along")),
        Scene("two hot conductors", Conduction(stack, other), (*SPOTS, "spot_upper", "rough", "friction_heat_of_pair")),
        Scene("a sink", Conduction(sinking, sink=30.0), ("spot",)),
        Scene("a perfect base", Conduction(LayeredConductor([(conductors[0], 1.5)], PERFECT)), ("spot", "spot_fields")),
        Scene("elastic conductors", Conduction(elastic), (*SPOTS, *LATE)),
        Scene("elastic conductor", Conduction(mdr.Homogeneous(base)), SPOTS),
        Scene("coated conductor", Conduction(mdr.Coated(film, 0.9, base)), SPOTS),
        Scene("pair of conductors", Conduction(mdr.Pair(mdr.Coated(film, 0.9, base), mdr.Homogeneous(film))), SPOTS),
        Scene("elastic conductors with interfaces", Conduction(joined), ("spot", "conduction_compliance"),
              only=("body.layers[0]",)),
        Scene("conducting medium with interfaces", joined, ("compliance_flux",), only=("layers[0]",)),
        Scene("conducting medium", elastic, ("compliance_flux", "compliance_flux_omega")),
        Scene("conducting pair", mdr.Pair(mdr.Coated(film, 0.9, base), mdr.Homogeneous(film)), ("compliance_flux",)),
        Scene("rough joint", mdr.conduction.RoughJoint(0.1, 0.2, 5.0, 0.3, 0.2), ("joint", "joint_resistance")),
        Scene("conductors of a joint", Conduction(*conductors[:2], 0.2), ("joint_resistance_of_bodies",)),
        Scene("tabulated conduction", TabulatedConduction(stack, other, 0.2, None, 0.3, 1.0, 1e-8), ("spot",)),
    ]  # fmt: skip


def _fields(x: Any, y: Any, z: Any) -> Any:
    near = 1.0 / (1.0 + 0.25 * (x * x + y * y + z * z))
    return 1.0 + 8.0 * near, 0.3 + 0.1 * near


def _lateral() -> list[Scene]:
    soft, hard = mdr.Elastic(0.5, 0.4), mdr.Elastic(3.0, 0.2)
    shapes = (
        lateral.Layer(0.4, 1.0, hard),
        lateral.HalfSpace((0.4, 0.5, 0.3), (1.0, 0.7, 0.5), soft),
        lateral.Fibre((-0.7, 0.6, 0.6), (0.6, 1.0, -0.5), 0.45, mdr.Elastic(3.0, 0.45)),
        lateral.Pillar(0.4, -0.4, 0.5, 0.2, 0.9, soft),
        lateral.Box((-0.6, 0.5), (-0.5, 0.6), (0.3, 0.9), hard),
        lateral.Ball((0.4, 0.5, 0.5), 0.45, hard),
    )
    how = {"reference_nu": 0.3, "tolerance": 1e-6, "exponent": 0.4}
    scenes = [
        Scene(type(shape).__name__, lateral.Shapes(BASE, (shape,), **how), ("structure_modulus",), only=("shapes",))
        for shape in shapes
        if not isinstance(shape, lateral.Fibre)
    ]
    fibre = lateral.Shapes(BASE, (shapes[2],), **{**how, "tolerance": 1e-5})
    scenes.append(Scene("Fibre", fibre, ("fibre_modulus",), only=("shapes",)))
    ball = lateral.Shapes(BASE, (shapes[-1],), **how)
    scenes.append(Scene("shapes", ball, ("structure_modulus", "structure_bounds")))
    scenes.append(
        Scene("shapes without a reference", ball.replace(reference_nu=None), ("structure_modulus",), only=("reference_nu",))
    )
    scenes.append(Scene("places of shapes", lateral.Shapes(BASE, shapes), ("structure_materials",), only=("background", "shapes")))
    labels = (np.arange(4 * 6 * 6).reshape(4, 6, 6) % 5 == 0).astype(np.int32)
    how = {"phases": (BASE, hard), "spacing": (0.4, 0.5, 0.6), "origin": (-1.2, -1.6), "reference_nu": 0.3, "exponent": 0.4}
    periodic = mdr.lateral.Voxels(labels, beside="periodic", below=soft, images=1, **how)
    beside = mdr.lateral.Voxels(labels, beside=soft, below=hard, **how)
    voxels = ("voxel_modulus", "voxel_map")
    return [
        *scenes,
        Scene("voxels", periodic, voxels),
        Scene("voxels beside", beside, voxels),
        Scene("places of voxels", periodic, ("voxel_centres",), only=("spacing[1]", "spacing[2]", "origin")),
        Scene("shares of voxels", periodic, ("voxel_shares",), only=("labels",)),
        Scene("field", lateral.Field(Times(_fields), 0.25, tolerance=1e-6, exponent=0.4), ("structure_modulus",)),
        Scene("lateral medium", lateral.LateralMedium(periodic, 0.1, 0.2, 0.4, 1.5, 9), MEDIUM),
    ]


def _functions() -> list[Scene]:
    """Functions of numbers, whose arguments are members."""
    a, coating = (0.5, 0.9), {"coating_shear": 1.2, "substrate_shear": 0.4, "thickness": 0.8}
    alone = {"radius": 2.0, "substrate_shear": 0.4, "work_of_adhesion": 0.02}
    contact = mdr.Contact(mdr.Paraboloid(4.0), SOLID)
    calls = [
        Call("coated_paraboloid_force", coated_paraboloid_force, a=a, radius=2.0, **coating),
        Call("coated_cone_force", coated_cone_force, a=a, inclination=0.3, **coating),
        Call(
            "coated_paraboloid_adhesive_depth",
            coated_paraboloid_adhesive_depth,
            a=a,
            radius=2.0,
            work_of_adhesion=0.02,
            **coating,
        ),
        Call("adhesive_radius_scale", adhesive_radius_scale, **alone),
        Call("adhesive_depth_scale", adhesive_depth_scale, **alone),
        Call("reduced_adhesive_depth", reduced_adhesive_depth, reduced_radius=a, shear_ratio=3.0, reduced_thickness=0.7),
        *(
            Call(name, weight, **{next(iter(inspect.signature(weight).parameters)): a}, nu=0.3)
            for name in ("weight_i0", "weight_i0_tangential", "weight_j0", "weight_j0_tangential", "weight_phi")
            for weight in [getattr(mdr.weights, name)]
        ),
        Call("density", lateral.density, rho=0.6, z=0.5, nu=0.3),
        Call("cell_weights", lateral.cell_weights, a=0.8, x=(-0.5, 0.1, 0.6), y=(-0.4, 0.3), z_top=0.2, z_bottom=0.9, nu=0.3),
        Call("wear_coefficient_from_volume", wear_coefficient_from_volume, volume=(0.1, 0.25), sliding=(1.0, 2.0), force=2.0),
        Call("wear_coefficient_from_scar", wear_coefficient_from_scar, contact=contact, radius=(1.0,), sliding=(2.0,), force=0.3),
    ]
    return [Scene(call.label, call, ("returned",)) for call in calls]


def _requests() -> list[Scene]:
    know(requests.CHOICES, requests.PRESENT)
    return [Scene(call.label, call, ("returned",), only=only_arguments(call)) for call in requests.requests()]


def all_scenes() -> list[Scene]:
    """Every scene."""
    return [
        Scene("material", AXIAL, ("material_modulus", "material_tangential")),
        Scene("engineered material", ENGINEERED, ("material_modulus", "material_tangential")),
        Scene("isotropic material", FILM, ("material_modulus",)),
        *_elastic(), *_models(), *_graded(), *_indenters(), *_adhesion(), *_time(), *_gels(), *_friction(), *_wear(), *_laws(),
        *_imprints(), *_plastic_laws(), *_plastic_models(), *_conduction(), *_lateral(), *_functions(), *_requests(),
    ]  # fmt: skip
