# SPDX-License-Identifier: GPL-3.0-or-later
"""What objects answer, as numbers: each function takes an object and returns its answers by name, arrays or numbers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

import mdrcontact as mdr
from mdrcontact import lateral
from mdrcontact.state import NAMES

DEPTH, FORCE, RADIUS = 0.25, 0.5, 0.8
K = np.array([0.4, 1.3, 3.0])
Numbers = dict[str, Any]


@dataclass(frozen=True)
class Answer:
    """Numbers of one call."""

    name: str
    function: Callable[[Any], Numbers]
    tolerance: float
    covers: tuple[str, ...]
    """public methods that it calls"""


ANSWERS: dict[str, Answer] = {}


def answer(*covers: str, tolerance: float = 1e-9) -> Callable[[Callable[[Any], Numbers]], Callable[[Any], Numbers]]:
    """Registers an answer with the relative tolerance of its numbers."""

    def register(function: Callable[[Any], Numbers]) -> Callable[[Any], Numbers]:
        name = function.__name__.rstrip("_")
        assert name not in ANSWERS, name
        ANSWERS[name] = Answer(name, function, tolerance, covers)
        return function

    return register


def _columns(found: Any, *names: str) -> Numbers:
    return {name: getattr(found, name) for name in names}


# materials and conductors


@answer("Elastic.contact_modulus", "TransverselyIsotropic.contact_modulus")
def material_modulus(material: Any) -> Numbers:
    return {"": material.contact_modulus}


@answer("TransverselyIsotropic.tangential_modulus")
def material_tangential(material: Any) -> Numbers:
    return {"": material.tangential_modulus}


@answer("Viscoelastic.relaxation", "Viscoelastic.creep", "Viscoelastic.complex_modulus", "PowerLawRheology.relaxation",
        "PowerLawRheology.creep", "PowerLawRheology.complex_modulus")  # fmt: skip
def material_in_time(material: Any) -> Numbers:
    t = [0.3, 2.0]
    return {
        "relaxation": material.relaxation(t),
        "creep": material.creep(t),
        "complex_modulus": material.complex_modulus([0.5, 2.0]),
    }


@answer("Viscoelastic.glassy", "PowerLawRheology.glassy")
def material_glassy(material: Any) -> Numbers:
    return {"E": material.glassy.E, "nu": material.glassy.nu}


@answer("Viscoelastic.relaxed", "PowerLawRheology.relaxed")
def material_relaxed(material: Any) -> Numbers:
    return {"E": material.relaxed.E, "nu": material.relaxed.nu}


@answer("Poroelastic.longitudinal_modulus", "Poroelastic.undrained", "Poroelastic.drained")
def gel_moduli(gel: Any) -> Numbers:
    return {"longitudinal": gel.longitudinal_modulus, "undrained": gel.undrained.E, "drained": [gel.drained.E, gel.drained.nu]}


@answer("Poroelastic.from_permeability")
def diffusivity(gel: Any) -> Numbers:
    return {"": gel.diffusivity, "moduli": [gel.shear_modulus, gel.nu]}


# media


@answer("Medium.modulus")
def modulus(medium: Any) -> Numbers:
    return {"": medium.modulus([0.5, RADIUS])}


@answer("Medium.modulus")
def modulus_at_ends(medium: Any) -> Numbers:
    return {"": medium.modulus([0.31, 1.15])}


@answer("Medium.stiffness")
def stiffness(medium: Any) -> Numbers:
    return {"": medium.stiffness([0.5, RADIUS])}


@answer("Medium.tangential_modulus", "Medium.tangential_stiffness")
def tangential_modulus(medium: Any) -> Numbers:
    return {"": medium.tangential_modulus([0.5, RADIUS])}


@answer("Medium.torsional_stiffness")
def torsional_stiffness(medium: Any) -> Numbers:
    return {"": medium.torsional_stiffness([0.5, RADIUS])}


@answer("Medium.compliance")
def compliance_normal(medium: Any) -> Numbers:
    return {"": medium.compliance(K)}


@answer("Medium.compliance")
def compliance_shear(medium: Any) -> Numbers:
    return {"": medium.compliance(K, "shear")}


@answer("Medium.compliance")
def compliance_twist(medium: Any) -> Numbers:
    return {"": medium.compliance(K, "twist")}


@answer("Medium.compliance", "Medium.compliance_matrix")
def compliance_coupling(medium: Any) -> Numbers:
    return {"": medium.compliance(K, "coupling"), "matrix": medium.compliance_matrix(K)}


@answer("Medium.compliance")
def compliance_flux(medium: Any) -> Numbers:
    return {"": medium.compliance(K, "flux")}


@answer("Medium.compliance")
def compliance_flux_omega(medium: Any) -> Numbers:
    return {"": medium.compliance(K, "flux", omega=0.7)}


@answer("Medium.compliance", tolerance=1e-8)
def compliance_omega(medium: Any) -> Numbers:
    return {load: medium.compliance(K, load, omega=0.7) for load in ("normal", "shear", "twist", "coupling")}


@answer("Medium.compliance_limits")
def compliance_limits(medium: Any) -> Numbers:
    return medium.compliance_limits()._asdict()


@answer("Medium.point_response", "Medium.rectangle_response")
def responses(medium: Any) -> Numbers:
    return {"point": medium.point_response([0.4, 2.0]), "rectangle": medium.rectangle_response([0.1, 1.0], 0.3, (0.5, 0.8))}


@answer("Layered.wrinkling", tolerance=1e-8)
def wrinkling(medium: Any) -> Numbers:
    found = medium.wrinkling()
    return {"stress": found.stress, "wavelength": found.wavelength}


# profiles


@answer("Profile.height", "Profile.slope")
def profile_height(profile: Any) -> Numbers:
    r = [0.01, 0.4, 0.9]
    return {"height": profile.height(r), "slope": profile.slope(r)}


@answer("Profile.height")
def profile_end(profile: Any) -> Numbers:
    return {"": profile.height(1.95)}


@answer("Profile.mdr", "Profile.mdr_slope")
def profile_mdr(profile: Any) -> Numbers:
    x = [0.01, 0.4, 0.75]
    return {"g": profile.mdr(x), "slope": profile.mdr_slope(x)}


# states and their fields


@answer("Contact.at_depth")
def at_depth(contact: Any) -> Numbers:
    return _columns(contact.at_depth([0.1, DEPTH]), "radius", "force", "stiffness")


@answer("Contact.at_depth")
def at_depth_loading(contact: Any) -> Numbers:
    return _columns(contact.at_depth([0.1, DEPTH], branch="loading"), "radius", "force", "stiffness")


@answer("Contact.at_force")
def at_force(contact: Any) -> Numbers:
    return _columns(contact.at_force([0.2, FORCE]), "depth", "radius", "stiffness")


@answer("Contact.at_radius")
def at_radius(contact: Any) -> Numbers:
    return _columns(contact.at_radius([0.5, RADIUS]), "depth", "force", "stiffness")


@answer("Contact.at_depth")
def zone(contact: Any) -> Numbers:
    return {"radius": contact.at_depth(DEPTH).zone_radius}


@answer("Contact.at_depth")
def punch_depth(contact: Any) -> Numbers:
    return {"": contact.at_depth(DEPTH).punch_depth}


@answer("State.slope", tolerance=1e-7)
def state_slope(contact: Any) -> Numbers:
    return {"": contact.at_depth(DEPTH).slope}


@answer("State.pressure", tolerance=1e-8)
def pressure(contact: Any) -> Numbers:
    return {"": contact.at_depth(DEPTH).pressure([0.1, 0.3])}


@answer("State.displacement", tolerance=1e-8)
def displacement(contact: Any) -> Numbers:
    return {"": contact.at_depth(DEPTH).displacement([1.6, 2.5])}


@answer("State.displacement", tolerance=1e-8)
def displacement_of_bodies(contact: Any) -> Numbers:
    state = contact.at_depth(DEPTH)
    return {body: state.displacement([0.2, 1.6], body) for body in ("lower", "upper")}


@answer("State.line_load")
def line_load(contact: Any) -> Numbers:
    return {"": contact.at_depth(DEPTH).line_load([0.1, 0.3])}


@answer("State.energy", tolerance=1e-8)
def energy(contact: Any) -> Numbers:
    return {"": contact.at_depth(DEPTH).energy()}


@answer("State.energy", tolerance=1e-8)
def energy_of_bodies(contact: Any) -> Numbers:
    state = contact.at_depth(DEPTH)
    return {body: state.energy(body) for body in ("lower", "upper")}


@answer("State.lowest_pressure", tolerance=1e-6)
def lowest_pressure(contact: Any) -> Numbers:
    pressure, r = contact.at_depth(DEPTH).lowest_pressure()
    return {"pressure": pressure, "r": r}


_R, _Z = np.array([[0.3], [1.2]]), np.array([[0.35, 1.4]])


def _inside(state: Any, **how: Any) -> Numbers:
    found = state.interior(_R, _Z, **how)
    return {"displacement": [found.u_r, found.u_z], "stress": [found.s_rr, found.s_tt, found.s_zz, found.s_rz]}


@answer("State.interior", "Interior.von_mises", "Interior.tresca", "Interior.principal", tolerance=1e-7)
def interior(contact: Any) -> Numbers:
    return _inside(contact.at_depth(DEPTH))


@answer("State.interior", tolerance=1e-7)
def interior_upper(contact: Any) -> Numbers:
    return _inside(contact.at_depth(DEPTH), body="upper")


@answer("State.interior", tolerance=1e-7)
def interior_sliding(contact: Any) -> Numbers:
    found = contact.at_depth(DEPTH).interior(_R, _Z, friction=0.3, angle=0.6)
    return {"displacement": [found.u_r, found.u_t, found.u_z], "stress": list(found[3:])}


@answer("State.critical", tolerance=1e-6)
def critical(contact: Any) -> Numbers:
    found = contact.at_depth(DEPTH).critical(friction=0.2)
    numbers: Numbers = {"surface": found.surface.value}
    for i, layer in enumerate(found.layers):
        numbers[f"von_mises{i}"], numbers[f"tension{i}"] = layer.von_mises.value, layer.tension.value
        numbers[f"tresca{i}"], numbers[f"energy{i}"] = layer.tresca.value, layer.energy
    for i, interface in enumerate(found.interfaces):
        numbers[f"interface{i}"] = [interface.shear.value, interface.tension.value]
    return numbers


@answer("Contact.first_failure", tolerance=1e-6)
def first_failure(contact: Any) -> Numbers:
    layers = len(contact.medium._stack()) + (contact.medium.substrate not in (mdr.RIGID, mdr.SMOOTH))
    found = contact.first_failure({"von_mises": [0.1] + [None] * (layers - 1)}, largest_radius=2.0)
    return {"force": found[0].state.force if found else np.inf}


@answer("State.gradient", tolerance=1e-7)
def gradient(contact: Any) -> Numbers:
    return contact.at_depth(DEPTH).gradient()


# adhesion


@answer("Contact.pull_off", tolerance=1e-8)
def pull_off_force(contact: Any) -> Numbers:
    return _columns(contact.pull_off(), "depth", "radius", "force", "stiffness")


@answer("Contact.pull_off", tolerance=1e-8)
def pull_off_depth(contact: Any) -> Numbers:
    return _columns(contact.pull_off("depth"), "depth", "radius", "force")


@answer("Contact.loop", tolerance=1e-8)
def loop_depth(contact: Any) -> Numbers:
    found = contact.loop("depth", DEPTH, 5)
    return {"dissipated": found.dissipated_energy, "force": found.force[np.isfinite(found.force)]}


@answer("Contact.loop", tolerance=1e-8)
def loop_force(contact: Any) -> Numbers:
    found = contact.loop("force", FORCE, 5)
    return {"dissipated": found.dissipated_energy, "depth": found.depth}


@answer("Contact.loop", tolerance=1e-8)
def loop_spring(contact: Any) -> Numbers:
    found = contact.loop("spring", 0.4, 5, spring_stiffness=1.5)
    return {"dissipated": found.dissipated_energy, "force": found.force}


@answer("adhesion.rate_history", tolerance=1e-6)
def rate_history(contact: Any) -> Numbers:
    found = mdr.adhesion.rate_history(contact, [0.0, 1.0, 1.5, 2.0], depth=[-0.1, DEPTH, 0.05, -0.02])
    return {"force": found.force, "radius": found.radius, "dissipated": found.dissipated}


@answer("adhesion.rate_history", tolerance=1e-6)
def rate_history_force(contact: Any) -> Numbers:
    found = mdr.adhesion.rate_history(contact, [0.0, 1.0, 1.5, 2.0], force=[0.0, FORCE, 0.0, -0.2])
    return {"depth": found.depth, "radius": found.radius, "work": found.work}


@answer("adhesion.rate_history", tolerance=1e-6)
def rate_history_spring(contact: Any) -> Numbers:
    found = mdr.adhesion.rate_history(contact, [0.0, 1.0, 1.5, 2.0], position=[-0.1, 0.4, 0.0, -0.2], spring_stiffness=1.5)
    return {"force": found.force, "depth": found.depth}


@answer("RateAdhesion.at_speed", "RheologicalAdhesion.at_speed")
def at_speed(adhesion: Any) -> Numbers:
    return {"opening": adhesion.at_speed([1e-3, 0.2]), "closing": adhesion.at_speed([-1e-3, -0.2])}


# time


@answer("Contact.relaxation", tolerance=1e-7)
def relaxation(contact: Any) -> Numbers:
    return {"": contact.relaxation([0.4, 2.0], RADIUS)}


@answer("Contact.creep", tolerance=1e-7)
def creep(contact: Any) -> Numbers:
    return {"": contact.creep([0.4, 2.0], RADIUS)}


@answer("Contact.dynamic_stiffness", tolerance=1e-7)
def dynamic_radius(contact: Any) -> Numbers:
    return {"": contact.dynamic_stiffness([0.6, 3.0], radius=RADIUS)}


@answer("Contact.dynamic_stiffness", tolerance=1e-7)
def dynamic_depth(contact: Any) -> Numbers:
    return {"": contact.dynamic_stiffness([0.6, 3.0], depth=DEPTH)}


@answer("Contact.dynamic_stiffness", tolerance=1e-7)
def dynamic_force(contact: Any) -> Numbers:
    return {"": contact.dynamic_stiffness([0.6, 3.0], force=FORCE)}


@answer("Contact.relaxation", "Contact.creep", "Contact.dynamic_stiffness", tolerance=1e-7)
def punch_in_time(contact: Any) -> Numbers:
    return {"relaxation": contact.relaxation([0.4, 2.0]), "creep": contact.creep([0.4, 2.0]),
            "dynamic": contact.dynamic_stiffness([0.6])}  # fmt: skip


@answer("Contact.history", tolerance=3e-6)
def history_depth(contact: Any) -> Numbers:
    found = contact.history([0.1, 0.6, 1.0], depth=[0.0, DEPTH, 0.2], tolerance=3e-6)
    return {"force": found.force, "radius": found.radius[:2]}


@answer("Contact.history", tolerance=3e-6)
def history_force(contact: Any) -> Numbers:
    found = contact.history([0.1, 0.6, 1.0], force=[0.0, FORCE, FORCE], tolerance=3e-6)
    return {"depth": found.depth, "radius": found.radius}


@answer("Contact.history", tolerance=3e-6)
def history_radius(contact: Any) -> Numbers:
    found = contact.history([0.1, 0.6, 1.0], radius=[0.0, RADIUS, 0.9], tolerance=3e-6)
    return {"depth": found.depth, "force": found.force}


@answer("adhesion.adhesive_history", tolerance=1e-4)
def adhesive_history(contact: Any) -> Numbers:
    found = mdr.adhesion.adhesive_history(contact, [0.0, 1.0, 2.0], depth=[0.05, DEPTH, 0.15], tolerance=1e-4)
    return {"force": found.force, "radius": found.radius, "zone_radius": found.zone_radius, "work": found.end["work"]}


# friction: a contact, made with a coefficient


@answer("Friction.shear", "ShearedContact.at_shift")
def shear_at_shift(friction: Any) -> Numbers:
    state = friction.contact.at_depth(DEPTH)
    found = friction.shear(state).at_shift([0.01, 0.02])
    return _columns(found, "tangential_force", "stick_radius", "stiffness", "dissipated_energy")


@answer("Friction.shear", "ShearedContact.at_force")
def shear_at_force(friction: Any) -> Numbers:
    state = friction.contact.at_depth(DEPTH)
    found = friction.shear(state).at_force([0.03, 0.05])
    return _columns(found, "shift", "stick_radius", "stiffness", "dissipated_energy")


@answer("ShearedContact.traction", "ShearedContact.line_load", tolerance=1e-7)
def shear_fields(friction: Any) -> Numbers:
    sheared = friction.shear(friction.contact.at_depth(DEPTH))
    at = sheared.at_shift(0.01)
    return {"traction": sheared.traction([0.1, 0.4], at), "line_load": sheared.line_load([0.1, 0.4], at)}


@answer("ShearedContact.loop", "ShearedContact.cycle_energy", "ShearedContact.sliding_shift", "ShearedContact.sliding_force",
        tolerance=1e-8)  # fmt: skip
def shear_cycles(friction: Any) -> Numbers:
    sheared = friction.shear(friction.contact.at_depth(DEPTH))
    found = sheared.loop(0.01, points=5)
    return {"loop": found.tangential_force, "energy": sheared.cycle_energy(0.01), "loop_energy": found.dissipated_energy,
            "sliding_shift": sheared.sliding_shift, "sliding_force": sheared.sliding_force}  # fmt: skip


@answer("Friction.twist", tolerance=1e-8)
def twisted(friction: Any) -> Numbers:
    sheared = friction.twist(friction.contact.at_depth(DEPTH))
    found = sheared.at_shift([0.01, 0.05])
    numbers = _columns(found, "tangential_force", "stick_radius", "stiffness", "dissipated_energy")
    return {**numbers, "traction": sheared.traction([0.1, 0.4], found[1]), "sliding_force": sheared.sliding_force}


@answer("Friction.history", "FrictionHistory.advance", tolerance=1e-7)
def friction_history(friction: Any) -> Numbers:
    is_exact = isinstance(friction.contact.medium, mdr.Homogeneous)
    history = friction.history() if is_exact else friction.history(DEPTH, 12)
    found = history.advance(depth=[0.1, 0.2, DEPTH], shift=[0.05, -0.05, 0.0])
    return _columns(found, "tangential_force", "dissipated_energy")


@answer("FrictionHistory.advance", "FrictionHistory.copy", tolerance=1e-7)
def friction_history_force(friction: Any) -> Numbers:
    is_exact = isinstance(friction.contact.medium, mdr.Homogeneous)
    history = (friction.history() if is_exact else friction.history(0.5, 12)).copy()
    found = history.advance(force=[0.1, 0.2, 0.3], tangential_force=[0.03, -0.03, 0.05])
    return _columns(found, "shift", "dissipated_energy")


# imprints


def _imprint(imprint: Any, of_uniform: float) -> Numbers:
    """Unloading, and what the imprint says of itself."""
    half = imprint.contact().at_depth(0.5 * imprint.recovery)
    found = _columns(imprint, "recovery", "recovered_work", "residual_depth", "force", "radius")
    ratio = imprint.reverse_yield([of_uniform] * (1 if isinstance(imprint.body, mdr.Homogeneous) else 2)).ratio
    return {**found, "force_at_half": half.force, "radius_at_half": half.radius, "height": imprint.profile.height(0.4),
            "ratio": ratio, "terms": (imprint.uniform, imprint.hertz)}  # fmt: skip


@answer("Imprint.recovery", "Imprint.recovered_work", "Imprint.profile", "Imprint.reverse_yield", "Imprint.uniform",
        "Imprint.hertz", tolerance=1e-7)  # fmt: skip
def imprint_unloading(imprint: Any) -> Numbers:
    return _imprint(imprint, 0.05)


@answer("Imprint.contact", tolerance=1e-7)
def imprint_pull_off(imprint: Any) -> Numbers:
    return _columns(imprint.contact(1e-4).pull_off(), "force", "radius") | {"residual_depth": imprint.residual_depth}


@answer("Imprint.from_two_terms", tolerance=1e-7)
def imprint_of_two_terms(imprint: Any) -> Numbers:
    return _imprint(imprint, 0.05)


@answer("Imprint.from_pressure", "Imprint.misfit", tolerance=1e-7)
def imprint_of_pressure(imprint: Any) -> Numbers:
    return _columns(imprint, "recovery", "recovered_work", "residual_depth", "force", "misfit")


# wear


@answer("Wear.limit", "WornProfile.worn_depth", tolerance=1e-7)
def wear_limit(wear: Any) -> Numbers:
    found = wear.limit(wear.contact.at_depth(DEPTH), 0.5)
    return {"force": found.state.force, "stiffness": found.state.stiffness, "outer_radius": found.outer_radius,
            "volume": found.worn_volume, "profile": found.profile.height([0.2, 0.7]),
            "worn": found.profile.worn_depth([0.6, 0.7])}  # fmt: skip


@answer("Wear.limit", tolerance=1e-7)
def wear_limit_force(wear: Any) -> Numbers:
    found = wear.limit(wear.contact.at_depth(DEPTH), 0.5, "force")
    return {"depth": found.state.depth, "outer_radius": found.outer_radius, "volume": found.worn_volume}


_WORN = ("depth", "radius", "force", "pressure", "worn_depth", "worn_volume", "work")


@answer("Wear.advance", "WearHistory.profile", tolerance=1e-6)
def wear_at_depth(wear: Any) -> Numbers:
    found, profile = wear.advance([0.4], depth=DEPTH, intervals=16)
    return {**_columns(found, *(name for name in _WORN if name != "depth")), "profile": profile.height([0.2, 0.7])}


@answer("Wear.advance", tolerance=1e-6)
def wear_at_force(wear: Any) -> Numbers:
    found, _ = wear.advance([0.4], force=FORCE, intervals=16)
    return _columns(found, "depth", "radius", "pressure", "worn_depth", "worn_volume")


@answer("Wear.advance", tolerance=1e-6)
def wear_rings(wear: Any) -> Numbers:
    found, _ = wear.advance([0.4], depth=DEPTH, intervals=16, scheme="rings")
    return _columns(found, "radius", "force", "worn_depth", "worn_volume")


@answer("Wear.history", "WearHistory.advance", "WearHistory.pressure", "WearHistory.state", tolerance=1e-6)
def wear_same_places(wear: Any) -> Numbers:
    history = wear.history(depth=DEPTH, intervals=16, places="same")
    history.advance(0.4, depth=DEPTH)
    names = (*(name for name in _WORN if name != "depth"), "body_depth", "body_volume")
    return {**_columns(history.state, *names), "field": history.pressure([0.2, 0.4])}


@answer("Wear.bracket", tolerance=1e-6)
def wear_bracket(wear: Any) -> Numbers:
    first, last = wear.bracket([0.4], depth=DEPTH, intervals=16)
    return {"force": [first.force, last.force], "body_depth": [first.body_depth, last.body_depth]}


@answer("Wear.bracket", tolerance=1e-6)
def wear_bracket_force(wear: Any) -> Numbers:
    first, last = wear.bracket([0.4], force=FORCE, intervals=16)
    return {"depth": [first.depth, last.depth], "body_depth": [first.body_depth, last.body_depth]}


@answer("Wear.track", "Wear.passes_through", tolerance=1e-7)
def wear_track(wear: Any) -> Numbers:
    state = wear.contact.at_depth(DEPTH)
    return {"depth": wear.track([0.0, 0.4], state, 0.01), "passes": wear.passes_through(state, 0.001)}


@answer("Wear.running_in_length", tolerance=1e-7)
def wear_running_in(wear: Any) -> Numbers:
    return {name: wear.running_in_length(name) for name in ("force", "depth")}


# laws


@answer("ContactLaw.force", "ContactLaw.at_depth", tolerance=1e-6)
def law_at_depth(law: Any) -> Numbers:
    return {"F": law.force(0.2), **_columns(law.at_depth([0.1, 0.2]), "radius", "stiffness", "slope")}


@answer("ContactLaw.at_force", tolerance=1e-6)
def law_at_force(law: Any) -> Numbers:
    return _columns(law.at_force([0.1, 0.2]), "depth", "radius", "stiffness", "slope")


@answer("ContactLaw.energy", tolerance=1e-6)
def law_energy(law: Any) -> Numbers:
    return {"": law.energy([0.1, 0.2])}


@answer("ContactLaw.conductance", tolerance=1e-5)
def law_conductance(law: Any) -> Numbers:
    conductance, slope = law.conductance([0.1, 0.2])
    return {"": conductance, "slope": slope}


@answer("ContactLaw.depth_range", "ContactLaw.force_range", "ContactLaw.description", "ContactLaw.table",
        "ContactLaw.to_bytes", "ContactLaw.from_bytes", tolerance=1e-6)  # fmt: skip
def law_facts(law: Any) -> Numbers:
    law = type(law).from_bytes(law.to_bytes())
    return {"depths": law.depth_range, "forces": law.force_range, "description": law.description, "table": law.table()}


@answer("ContactLaw.at_depth", tolerance=1e-6)
def law_beyond(law: Any) -> Numbers:
    return _columns(law.at_depth([0.4]), "force", "radius", "stiffness")


@answer("ContactLaw.with_radius", tolerance=1e-7)
def law_with_radius(law: Any) -> Numbers:
    return {"": law.with_radius(3.0).force([0.1, 0.2])}


@answer("ContactLaw.buffer", "ContactLaw.arrays", tolerance=1e-6)
def law_buffer(law: Any) -> Numbers:
    return {"": law.arrays().buffer}


@answer("ContactLaw.advance", "ContactLaw.attempt", "ContactLaw.contacts", "ContactLaw.energies", tolerance=1e-6)
def law_shear(law: Any) -> Numbers:
    memory, found = law.contacts(1), []
    for shift, normal in ((0.01, 0.3), (0.03, 0.3), (0.0, 0.2)):
        shifts = np.array([shift]) if law.twists else np.array([[shift, 0.5 * shift]])
        law.attempt(memory, np.array([normal]), shifts)
        found.append(law.advance(memory, np.array([normal]), shifts).ravel())
    return {"": np.ravel(found), "energies": np.ravel(law.energies(memory))}


# laws of contacts that yield


@answer("PlasticLaw.advance", "PlasticLaw.try_", "PlasticLaw.contacts", "PlasticLaw.energies", tolerance=1e-6)
def plastic_steps(law: Any) -> Numbers:
    memory, found = law.contacts(1), []
    for depth in (0.008, 0.016, 0.0155):
        law.try_(memory, [depth])
        found += [*law.advance(memory, [depth]), *law.energies(memory, [depth])]
    return {"": np.ravel(found)}


@answer("PlasticLaw.loading", "FirstLoading.imprint", "PlasticLaw.restitution", tolerance=1e-6)
def plastic_loading(law: Any) -> Numbers:
    state = law.loading([1e-4, 0.016])
    left = {} if law.work_of_adhesion else _columns(law.loading(0.016).imprint(), "radius", "force", "recovery", "recovered_work")
    return {"": np.ravel(state), "e": law.restitution(1.0, [0.001, 0.003]), **left}


@answer("PlasticLaw.with_radius", tolerance=1e-6)
def plastic_with_radius(law: Any) -> Numbers:
    return {"": law.with_radius(3.0).loading(0.01).force}


@answer("PlasticLaw.from_table", tolerance=1e-6)
def plastic_table(law: Any) -> Numbers:
    """The law of points of this one's first loading, of which the first is that of yield."""
    depth = np.array([law.yield_depth, 0.005, 0.01, 0.016])
    state = law.loading(depth)
    table = type(law).from_table(depth, state.force, state.radius, state.residual_depth, law.modulus)
    return {"": np.ravel(table.loading([1e-4, 0.012]))}


@answer("PlasticLaw.buffer", "PlasticLaw.largest_depth", "PlasticLaw.tolerance", "PlasticLaw.largest_force",
        "PlasticLaw.yield_depth", "PlasticLaw.yield_force", "PlasticLaw.first_yield", "PlasticLaw.radius",
        "PlasticLaw.work_of_adhesion", tolerance=1e-6)  # fmt: skip
def plastic_facts(law: Any) -> Numbers:
    sizes = law.largest_depth, law.largest_force, law.yield_depth, law.yield_force, law.modulus, law.work_of_adhesion
    return {"": np.array([*sizes, law.tolerance, law.radius, law.first_yield or 0.0]), "buffer": law.buffer()}


# plastic models of first loading


def _loadings(model: Any) -> dict[str, Any]:
    """States below and above yield, by each of what may be given."""
    found = {"radius": model.at_radius([0.02, 0.05])}
    found["depth"] = model.at_depth(found["radius"].depth[1])
    found["force"] = model.at_force(found["radius"].force[1])
    return found


@answer("Overload.at_radius", "Overload.at_depth", "Overload.at_force", "Overload.points", "OverloadState.imprint",
        tolerance=1e-6)  # fmt: skip
def overload(rule: Any) -> Numbers:
    states = _loadings(rule)
    columns = {f"{given} {name}": getattr(state, name) for given, state in states.items() for name in ("depth", "radius", "force")}
    points = rule.points(states["radius"].depth)
    return {**columns, "imprint": states["depth"].imprint().residual_depth, "points": points.residual_depth}


@answer("PlasticLaw.from_overload", tolerance=1e-6)
def coated_law(rule: Any) -> Numbers:
    """First loading, and unloading from a largest depth beyond yield."""
    depth = float(rule.at_radius(0.05).depth)
    law = mdr.plastic.PlasticLaw.from_overload(rule, depth)
    return {"": law.loading(0.8 * depth).force, "unloaded": law.try_(np.full((1, 1), depth), [0.95 * depth]).force}


@answer("PressureCap.at_radius", "PressureCap.at_depth", "PressureCap.at_force", "CapState.pressure", "CapState.residual",
        "CapState.imprint", tolerance=1e-5)  # fmt: skip
def pressure_cap(cap: Any) -> Numbers:
    states = _loadings(cap)
    columns = {f"{given} {name}": getattr(state, name) for given, state in states.items() for name in ("depth", "radius", "force")}
    state = states["depth"]
    left = state.imprint()
    columns |= {
        f"imprint {name}": getattr(left, name) for name in ("radius", "force", "residual_depth", "depth", "uniform", "hertz")
    }
    return {**columns, "pressure": state.pressure([0.0, 0.03]), "residual": state.residual([0.0, 0.03])}


# conduction


@answer("Conduction.at_radius")
def spot(conduction: Any) -> Numbers:
    return _columns(conduction.at_radius([0.5, RADIUS]), "conductance", "slope")


@answer("Spot.flux", "Spot.potential", "Spot.flux_inside", tolerance=1e-7)
def spot_fields(conduction: Any) -> Numbers:
    found, r, z = conduction.at_radius(RADIUS), [0.3, 1.0], [0.4, 1.3]
    along, away = found.flux_inside(r, z)
    return {"flux": found.flux([0.2, 0.5]), "potential": found.potential(r, z), "flux_inside": [along, away]}


@answer("Spot.potential", "Spot.flux_inside", tolerance=1e-7)
def spot_upper(conduction: Any) -> Numbers:
    found, r, z = conduction.at_radius(RADIUS), [0.3, 1.0], [0.4, 1.3]
    return {"potential": found.potential(r, z, "upper"), "flux_inside": list(found.flux_inside(r, z, "upper"))}


@answer("Conduction.compliance")
def conduction_compliance(conduction: Any) -> Numbers:
    return {"": conduction.compliance(K)}


@answer("Conduction.compliance")
def conduction_compliance_omega(conduction: Any) -> Numbers:
    return {"": conduction.compliance(K, 0.7)}


@answer("Conduction.step", tolerance=1e-6)
def conduction_step(conduction: Any) -> Numbers:
    return {name: conduction.step([0.4, 2.0], RADIUS, name) for name in ("conductance", "resistance")}


@answer("Conduction.step", tolerance=1e-6)
def conduction_step_flux_answers(conduction: Any) -> Numbers:
    names = ("mean_potential", "centre_potential", "gaussian_potential")
    return {name: conduction.step([1.0], RADIUS, name) for name in names}


@answer("Conduction.follow", tolerance=1e-6)
def conduction_follow(conduction: Any) -> Numbers:
    return {"": conduction.follow([0.0, 0.5, 1.0], [0.0, 1.0, 0.5], RADIUS)[1:]}


@answer("Conduction.admittance", "Conduction.impedance", tolerance=1e-7)
def admittance(conduction: Any) -> Numbers:
    names = ("conductance", "mean_potential", "centre_potential", "gaussian_potential")
    found = {name: conduction.admittance([0.7], RADIUS, name) for name in names}
    return {**found, "impedance": conduction.impedance([0.7], RADIUS)}


@answer("Conduction.step_flux", tolerance=1e-6)
def step_flux(conduction: Any) -> Numbers:
    return {"": conduction.step_flux([0.1, 0.4], 0.5, RADIUS)}


_SAME_CONTACT = mdr.Contact(mdr.Sphere(4.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.3)))


@answer("Conduction.friction_heat", "FrictionHeat.temperature", tolerance=1e-6)
def friction_heat(conduction: Any) -> Numbers:
    found = conduction.friction_heat(_SAME_CONTACT.at_depth(DEPTH), 0.3, 1.5)
    return {"centre": found.centre, "flux_mean": found.flux_mean, "area_mean": found.area_mean,
            "field": found.temperature([0.2], [0.5])}  # fmt: skip


@answer("Conduction.friction_heat", tolerance=1e-6)
def friction_heat_of_pair(conduction: Any) -> Numbers:
    found = conduction.friction_heat(_SAME_CONTACT.at_depth(DEPTH), 0.3, 1.5)
    return {"share": found.share, "upper": found.temperature([0.2], [0.5], "upper")}


@answer("Conduction.friction_heat", tolerance=1e-6)
def friction_heat_moving(conduction: Any) -> Numbers:
    found = conduction.friction_heat(_SAME_CONTACT.at_depth(DEPTH), 0.3, 1.5, "moving")
    return {"centre": found.centre, "flux_mean": found.flux_mean, "largest": found.largest, "behind": found.behind}


@answer("Conduction.friction_heat", tolerance=1e-6)
def friction_heat_spinning(conduction: Any) -> Numbers:
    found = conduction.friction_heat(_SAME_CONTACT.at_depth(DEPTH), 0.3, 1.5, "spinning")
    return {"flux_mean": found.flux_mean, "area_mean": found.area_mean}


@answer("Conduction.rough", tolerance=1e-7)
def rough(conduction: Any) -> Numbers:
    return {"": conduction.rough(_SAME_CONTACT.at_depth(DEPTH), 0.1)}


_JOINED = mdr.conduction.Conduction(mdr.conduction.Conductor(2.0), mdr.conduction.Conductor(3.0))


@answer("Conduction.rough", tolerance=1e-6)
def joint(rough_joint: Any) -> Numbers:
    return {"": _JOINED.rough(_SAME_CONTACT.at_depth(DEPTH), rough_joint)}


@answer("Conduction.joint_resistance")
def joint_resistance(rough_joint: Any) -> Numbers:
    return {"": _JOINED.joint_resistance(rough_joint, [0.1, 0.4])}


@answer("Conduction.joint_resistance")
def joint_resistance_of_bodies(conduction: Any) -> Numbers:
    return {"": conduction.joint_resistance(mdr.conduction.RoughJoint(0.1, 0.2, 5.0, 0.3, 0.2), [0.1, 0.4])}


@answer("Conduction.along", tolerance=1e-6)
def along(conduction: Any) -> Numbers:
    return _columns(conduction.along(_SAME_CONTACT.at_depth([0.1, DEPTH])), "conductance", "by_force", "by_depth")


@answer("Conduction.tabulated", tolerance=1e-7)
def tabulated(conduction: Any) -> Numbers:
    return _columns(conduction.tabulated(0.3, 1.0).at_radius([0.5, RADIUS]), "conductance", "slope")


# gels


def _held(contact: Any) -> dict[str, float]:
    """The contact radius that is held; a flat punch has its own."""
    return {} if isinstance(contact.indenter, mdr.FlatPunch) else {"radius": RADIUS}


@answer("Contact.relaxation", "Contact.creep", tolerance=1e-6)
def gel_steps(contact: Any) -> Numbers:
    how: dict[str, Any] = {"drainage": "surface", **_held(contact)}
    return {"relaxation": contact.relaxation([0.1, 0.5], **how), "creep": contact.creep([0.1, 0.5], **how)}


@answer("Contact.dynamic_stiffness", tolerance=1e-6)
def gel_dynamic(contact: Any) -> Numbers:
    return {"": contact.dynamic_stiffness([0.5, 3.0], drainage="sealed", **_held(contact))}


@answer("poroelastic.history", tolerance=1e-6)
def gel_history(contact: Any) -> Numbers:
    t = [0.1, 0.4, 0.6]
    if isinstance(contact.indenter, mdr.FlatPunch):
        return {"force": mdr.poroelastic.history(contact, t, depth=[0.01, 0.02, 0.02], drainage="surface").force}
    found = mdr.poroelastic.history(contact, t, radius=[RADIUS] * 3, drainage="surface")
    return {"force": found.force, "depth": found.depth}


@answer("Contact.pressure_in_time", tolerance=1e-5)
def gel_pressure(contact: Any) -> Numbers:
    how = {"depth": 0.02} if isinstance(contact.indenter, mdr.FlatPunch) else {"radius": RADIUS}
    return {"": contact.pressure_in_time("total_pressure", [0.2, 0.4], 0.3, drainage="surface", **how)}


@answer("Medium.compliance", tolerance=1e-7)
def gel_compliance(medium: Any) -> Numbers:
    return {word: medium.compliance(K, omega=0.7, drainage=word) for word in ("surface", "sealed")}


# lateral structures


@answer("Structure.modulus", tolerance=1e-6)
def structure_modulus(structure: Any) -> Numbers:
    return {"": structure.modulus(0.1, 0.2, RADIUS)}


@answer("Structure.modulus", tolerance=1e-5)
def fibre_modulus(structure: Any) -> Numbers:
    return structure_modulus(structure)


@answer("Structure.bounds", tolerance=1e-6)
def structure_bounds(structure: Any) -> Numbers:
    found = structure.bounds(0.1, 0.2, RADIUS)
    return {"lower": found.lower, "upper": found.upper}


@answer("Structure.modulus", tolerance=1e-8)
def voxel_modulus(structure: Any) -> Numbers:
    return {"": structure.modulus([0.1, 0.6], [0.2, -0.3], [0.5, RADIUS])}


@answer("Structure.materials")
def structure_materials(structure: Any) -> Numbers:
    x, y, z = np.random.default_rng(1).uniform([[-1.5], [-1.5], [0.0]], 1.5, (3, 20_000))
    E, nu = structure.materials(x, y, z)
    return {"E": E, "nu": nu}


@answer("Voxels.centres")
def voxel_centres(voxels: Any) -> Numbers:
    return {"": np.concatenate(voxels.centres())}


@answer("Voxels.slice_shares")
def voxel_shares(voxels: Any) -> Numbers:
    return {"": voxels.slice_shares()}


@answer(tolerance=1e-8)
def voxel_map(voxels: Any) -> Numbers:
    return {"": lateral.effective_map(voxels, [0.5, RADIUS], threads=1)}


# what a call returns


@answer(tolerance=1e-8)
def returned(found: Any) -> Numbers:
    """Numbers, a state, or a tuple of named numbers."""
    if isinstance(found, mdr.State):
        return {name: getattr(found, name) for name in NAMES}
    if hasattr(found, "_asdict"):
        return {name: value for name, value in found._asdict().items() if _is_number(value) and not np.isnan(value).any()}
    if isinstance(found, dict):
        return dict(found)
    if isinstance(found, tuple):
        return {str(i): value for i, value in enumerate(found) if _is_number(value)}
    return {"": found}


def _is_number(value: Any) -> bool:
    return np.asarray(value).dtype.kind in "iufc"
