# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments of methods: calls whose arguments are members."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

import mdrcontact as mdr
from mdrcontact import lateral
from mdrcontact.conduction import Conduction, Conductor, LayeredConductor

from .tree import Call

FILM, BASE, MIDDLE = mdr.Elastic(3.0, 0.25), mdr.Elastic(1.0, 0.35), mdr.Elastic(0.5, 0.2)
SPHERE = mdr.Sphere(4.0)
SOLID = mdr.Contact(SPHERE, mdr.Homogeneous(mdr.Elastic(1.0, 0.3)))
COATED = mdr.Contact(SPHERE, mdr.Coated(FILM, 0.9, BASE))
PAIR = mdr.Contact(SPHERE, mdr.Pair(mdr.Coated(FILM, 0.9, BASE), mdr.Coated(MIDDLE, 0.9, BASE)))
STICKY = mdr.Contact(SPHERE, mdr.Coated(FILM, 0.9, BASE), 0.02)
SPEEDY = mdr.Contact(SPHERE, mdr.Coated(FILM, 0.9, BASE), adhesion=mdr.adhesion.RateAdhesion(0.02, 0.1, 0.6))
RELAXING = mdr.Contact(SPHERE, mdr.Coated(mdr.Viscoelastic(0.5, [(1.0, 0.5)], nu=0.3), 0.9, BASE))
GEL = mdr.Contact(mdr.Paraboloid(4.0), mdr.Homogeneous(mdr.poroelastic.Poroelastic(1.0, 0.25, 0.4)))
PUNCH = mdr.Contact(mdr.FlatPunch(0.8), mdr.Homogeneous(mdr.poroelastic.Poroelastic(1.0, 0.25, 0.4)))
RUBBED = mdr.Friction(SOLID, 0.4)
WORN = mdr.wear.Wear(COATED, 0.3, body_coefficient=0.1)
CONDUCTORS = Conductor(3.0, 2.4, 1.5), Conductor(0.4, 0.6, 0.8), Conductor(1.0, 0.7, 1.2)
JOINED = LayeredConductor([(CONDUCTORS[0], 0.5), mdr.Interface(0.4), (CONDUCTORS[1], 0.6)], CONDUCTORS[2])
CONDUCTION = Conduction(JOINED)
TWO = Conduction(JOINED, LayeredConductor([(CONDUCTORS[1], 0.5), mdr.Interface(0.7)], CONDUCTORS[2]))


def _state(contact: mdr.Contact) -> mdr.State:
    return contact.at_depth(0.25)


def _moved(friction: mdr.Friction, largest_depth: float | None, rings: int | None, **path: Any) -> Any:
    return mdr.FrictionHistory(friction, largest_depth, rings).advance(**path)


def _slid(**given: Any) -> Any:
    where = {name: given[name] for name in ("force", "depth")}
    history = WORN.history(**given)
    return history.advance(0.3, **where)._replace(error=0.0)


def _heat(**given: Any) -> Any:
    found = CONDUCTION.friction_heat(_state(SOLID), **given)
    return {name: np.nan_to_num(np.array(getattr(found, name), float)) for name in ("total", "centre", "flux_mean", "largest")}


def _slide(**given: Any) -> Any:
    ball = lateral.Shapes(BASE, (lateral.Ball((0.2, 0.1, 0.6), 0.45, FILM),), tolerance=1e-4)
    return lateral.slide(ball, SPHERE, np.linspace(-1.0, 1.0, 6), **given)


def _voxels() -> lateral.Voxels:
    labels = (np.arange(4 * 6 * 6).reshape(4, 6, 6) % 5 == 0).astype(np.int32)
    return lateral.Voxels(labels, (BASE, FILM), 0.4)


def requests() -> list[Call]:
    """A call of each method that has arguments, with as many of them as it takes."""

    def call(label: str, function: Callable[..., Any], **arguments: Any) -> Call:
        return Call(label, function, **arguments)

    pair, coated = _state(PAIR), _state(COATED)
    at = {"r": 0.4, "z": 0.9, "side": "below"}
    times, path = (0.0, 1.0, 2.0), (-0.1, 0.25, 0.05)
    sheared = RUBBED.shear(_state(SOLID))
    law = mdr.ContactLaw(COATED, 0.3, tolerance=1e-7)
    sticky = mdr.ContactLaw(STICKY, 0.3, tolerance=1e-7)
    return [
        call("Contact.at_depth", STICKY.at_depth, depth=-0.02, branch="unloading"),
        call("Contact.at_force", STICKY.at_force, force=-0.05, branch="unloading"),
        call("State.displacement", pair.displacement, r=0.4, body="lower"),
        call("State.energy", pair.energy, body="lower"),
        call("State.interior", pair.interior, body="lower", friction=0.3, angle=0.4, **at),
        call("State.critical", lambda **how: coated.critical(**how).layers[0].von_mises.value, body="lower", friction=0.2),
        call("Contact.pull_off", STICKY.pull_off, control="force"),
        call("Contact.loop", STICKY.loop, control="spring", largest=0.4, points=5, spring_stiffness=1.5),
        call("Contact.history", RELAXING.history, time=times, depth=(0.0, 0.25, 0.3), force=None, radius=None),
        call("adhesion.rate_history", mdr.adhesion.rate_history, contact=SPEEDY, time=times, position=path,
            spring_stiffness=1.5, start="apart"),
        call("Contact.dynamic_stiffness", RELAXING.dynamic_stiffness, omega=0.7, radius=0.8, depth=None, force=None),
        call("Contact.relaxation", RELAXING.relaxation, time=0.7, radius=0.8, drainage=None),
        call("Contact.creep", GEL.creep, time=0.7, radius=0.8, drainage="surface"),
        call("Contact.pressure_in_time", GEL.pressure_in_time, kind="pore_pressure", r=0.3, time=0.2, radius=0.8, depth=None,
            drainage="sealed"),
        call("punch.pressure_in_time", PUNCH.pressure_in_time, kind="total_pressure", r=0.3, time=0.2, depth=0.02,
            drainage="sealed"),
        call("poroelastic.history", mdr.poroelastic.history, contact=PUNCH, time=(0.1, 0.5, 0.9),
            depth=(0.01, 0.02, 0.02), drainage="surface"),
        call("Medium.compliance", COATED.medium.compliance, k=1.2, load="shear", omega=0.0, drainage=None),
        call("relaxing.compliance", RELAXING.medium.compliance, k=1.2, load="shear", omega=0.8, drainage=None),
        call("gel.compliance", GEL.medium.compliance, k=1.2, load="normal", omega=0.8, drainage="surface"),
        call("Medium.compliance_matrix", RELAXING.medium.compliance_matrix, k=1.2, omega=0.8),
        call("Medium.compliance_limits", RELAXING.medium.compliance_limits, omega=0.8),
        call("Medium.point_response", COATED.medium.point_response, r=0.4, tolerance=1e-6),
        call("Medium.rectangle_response", COATED.medium.rectangle_response, x=0.4, y=0.3, size=(0.2, 0.5), tolerance=1e-6),
        call("Medium.response_error", COATED.medium.response_error, tolerance=1e-6),
        call("Layered.wrinkling", mdr.Layered([(FILM, 0.4), (MIDDLE, 0.5), (FILM, 0.3)], MIDDLE).wrinkling, layer=0),
        call("ShearedContact.loop", sheared.loop, amplitude=0.02, control="shift", points=7),
        call("ShearedContact.cycle_energy", sheared.cycle_energy, amplitude=0.02, control="shift"),
        call("FrictionHistory", _moved, friction=mdr.Friction(COATED, 0.4), largest_depth=0.25, rings=12, depth=(0.1, 0.2, 0.25),
            force=None, shift=(0.05, -0.05, 0.01), tangential_force=None),
        call("Wear.limit", lambda **how: WORN.limit(_state(COATED), **how).state, stick_radius=0.5, constant="depth"),
        call("Wear.track", lambda **how: WORN.track(0.3, _state(COATED), **how), passes=0.01),
        call("Wear.passes_through", lambda **how: WORN.passes_through(_state(COATED), **how), depth=0.001),
        call("WearHistory", _slid, force=None, depth=0.25, intervals=16, places="same", scheme="disc"),
        call("Conduction.compliance", CONDUCTION.compliance, k=1.2, omega=0.6),
        call("Conduction.rough", lambda **how: CONDUCTION.rough(_state(SOLID), **how), joint=0.3),
        call("Conduction.step", CONDUCTION.step, time=0.5, radius=0.8, answer="conductance"),
        call("Conduction.follow", CONDUCTION.follow, time=(0.0, 0.4, 0.8), given=(0.0, 1.0, 0.4), radius=0.8, answer="conductance"),
        call("Conduction.admittance", CONDUCTION.admittance, omega=0.6, radius=0.8, answer="conductance"),
        call("Conduction.step_flux", CONDUCTION.step_flux, r=0.3, time=0.5, radius=0.8),
        call("Conduction.friction_heat", _heat, mu=0.3, speed=1.5, motion="sliding", source_speed=None),
        call("moving.friction_heat", _heat, mu=0.3, speed=1.5, motion="moving", source_speed=1.2),
        call("Spot.potential", TWO.at_radius(0.8).potential, body="lower", **{**at, "z": 0.5}),
        call("Spot.flux_inside", TWO.at_radius(0.8).flux_inside, body="lower", r=0.4, z=0.6),
        call("FrictionHeat.temperature", TWO.friction_heat(_state(SOLID), 0.3, 1.5).temperature, body="lower", **{**at, "z": 0.5}),
        call("ContactLaw.table", law.table, form="csv", error=1e-3, branch="unloading", length=1.0, touch=None, area=None),
        call("sticky.table", sticky.table, form="csv", error=1e-3, branch="unloading", length=1.0, touch=None, area=None),
        call("lammps.table", law.table, form="lammps", error=1e-3, branch="unloading", length=1.0, touch=0.5, area=None),
        call("overclosure.table", law.table, form="overclosure", error=1e-3, branch="unloading", length=1.0, touch=None, area=0.7),
        call("ContactLaw.force", sticky.force, depth=-0.02, branch="unloading"),
        call("ContactLaw.energy", sticky.energy, depth=-0.02, branch="unloading"),
        call("slide", _slide, y=0.2, depth=0.2, force=None, periodic=False, points=9),
        call("indentation_map", lambda **how: lateral.indentation_map(_voxels(), SPHERE, **how), depth=0.2, nodes=4),
        call("weight_beyond", lateral.weight_beyond, a=0.8, distance=0.9, depth=1.5, nu=0.3),
    ]  # fmt: skip


_BODIES, _SIDES, _BRANCHES = ("lower", "upper"), ("below", "above"), ("unloading", "loading")
_ANSWERS = ("conductance", "resistance", "mean_potential", "centre_potential", "gaussian_potential")
_DRAINAGES = ("surface", "sealed", "indenter")
CHOICES: dict[str, tuple[Any, ...]] = {
    "Contact.at_depth.branch": _BRANCHES,
    "Contact.at_force.branch": _BRANCHES,
    "State.displacement.body": _BODIES,
    "State.energy.body": _BODIES,
    "State.interior.body": _BODIES,
    "State.interior.side": _SIDES,
    "State.critical.body": _BODIES,
    "Contact.pull_off.control": ("force", "depth"),
    "Contact.loop.control": ("force", "depth", "spring"),
    "adhesion.rate_history.start": ("apart", "rest"),
    "Contact.creep.drainage": _DRAINAGES,
    "Contact.pressure_in_time.kind": ("pore_pressure", "total_pressure"),
    "Contact.pressure_in_time.drainage": _DRAINAGES,
    "punch.pressure_in_time.kind": ("pore_pressure", "total_pressure"),
    "punch.pressure_in_time.drainage": _DRAINAGES,
    "poroelastic.history.drainage": _DRAINAGES,
    "Medium.compliance.load": ("normal", "shear", "twist", "coupling", "flux"),
    "relaxing.compliance.load": ("normal", "shear", "twist", "coupling", "flux"),
    "gel.compliance.load": ("normal", "shear", "twist", "coupling", "flux"),
    "gel.compliance.drainage": _DRAINAGES,
    "ShearedContact.loop.control": ("shift", "force"),
    "ShearedContact.cycle_energy.control": ("shift", "force"),
    "Wear.limit.constant": ("depth", "force"),
    "WearHistory.places": ("fresh", "same"),
    "WearHistory.scheme": ("disc", "rings"),
    "Conduction.step.answer": _ANSWERS,
    "Conduction.follow.answer": _ANSWERS,
    "Conduction.admittance.answer": _ANSWERS,
    "Conduction.friction_heat.motion": ("sliding", "spinning", "moving"),
    "moving.friction_heat.motion": ("sliding", "spinning", "moving"),
    "Spot.potential.body": _BODIES,
    "Spot.potential.side": _SIDES,
    "Spot.flux_inside.body": _BODIES,
    "FrictionHeat.temperature.body": _BODIES,
    "FrictionHeat.temperature.side": _SIDES,
    **{
        f"{name}.table.form": ("csv", "lammps", "spring", "overclosure")
        for name in ("ContactLaw", "sticky", "lammps", "overclosure")
    },
    **{f"{name}.table.branch": _BRANCHES for name in ("ContactLaw", "sticky", "lammps", "overclosure")},
    "ContactLaw.force.branch": _BRANCHES,
    "ContactLaw.energy.branch": _BRANCHES,
}
"""Words of arguments."""

PRESENT: dict[str, tuple[Any, ...]] = {
    "Yielding.hardening": (((0.0, 2e-3), (0.02, 2.3e-3)),),
    "Yielding.yield_stress": (2.1e-3,),
    "PlasticLaw.other": (mdr.Elastic(3.0, 0.25),),
    "Contact.history.force": ((0.0, 0.2, 0.3),),
    "Contact.history.radius": ((0.0, 0.5, 0.6),),
    "Contact.dynamic_stiffness.depth": (0.2,),
    "Contact.dynamic_stiffness.force": (0.3,),
    "Contact.pressure_in_time.depth": (0.02,),
    "FrictionHistory.force": ((0.1, 0.2, 0.3),),
    "FrictionHistory.tangential_force": ((0.01, 0.0, 0.01),),
    "WearHistory.force": (0.3,),
    "Conduction.friction_heat.source_speed": (0.9,),
    "slide.force": (0.3,),
    **{f"{name}.drainage": ("surface",) for name in ("Contact.relaxation", "Medium.compliance", "relaxing.compliance")},
    **{f"{name}.table.touch": (0.4,) for name in ("ContactLaw", "sticky", "overclosure")},
    **{f"{name}.table.area": (0.4,) for name in ("ContactLaw", "sticky", "lammps")},
    "Medium.compliance.omega": (0.8,),
}
"""What absent arguments become."""
