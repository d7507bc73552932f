# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact history`: a contact with a viscoelastic body along a path in time."""

from __future__ import annotations

import argparse
from typing import Any

import numpy as np

from .._units import ENERGY, FORCE, LENGTH, SPEED, TIME, shown
from ..contact import Contact
from ..history import AdhesiveHistory, History
from ..problem import ProblemError, load_with
from ..problem.history import HistoryPath
from ..rate_adhesion import RateHistory
from . import files, history_figure
from .table import as_csv, as_text, columns_of

_FEWEST = 60
"""Steps that a path is cut into at least."""

HELP = "a viscoelastic or poroelastic body along a path in time"
DESCRIPTION = """\
Computes a contact with a viscoelastic or poroelastic body along a path in time: depth, contact radius and force.

    mdrcontact example afm_on_gel > problem.toml
    mdrcontact history problem.toml
    mdrcontact history problem.toml --csv history.csv --plot history.png

A material of the problem file relaxes if it has, in place of E and nu,

    relaxed_shear_modulus = "1 MPa"             # a Prony series
    moduli = ["2 MPa", "0.5 MPa"]
    times = ["0.3 s", "3 s"]
    nu = 0.4                                    # or bulk_modulus = "2 GPa", elastic; viscosity = "1 kPa*s" in parallel

    modulus = "1 kPa"                           # or a power law: the shear modulus at that time
    time = "1 s"
    exponent = 0.2
    nu = 0.5

    shear_modulus = "10 kPa"                    # or a poroelastic gel, a half-space or a film with substrate = "rigid"
    nu = 0.2                                    # drained
    diffusivity = "1000 um^2/s"                 # or permeability = "100 nm^2" and viscosity = "1 mPa*s"

and one table takes the place of [compute]:

    [history]
    path = "ramp"               # step (hold_time), ramp (rise_time, hold_time, fall_time), triangle or sine, one half (duration)
    depth = "500 nm"            # the largest depth, or force, or radius
    rise_time = "1 s"
    hold_time = "5 s"
    fall_time = "1 s"
    points = 200

    drainage = "indenter"       # of a gel, without a default: surface (drained everywhere), sealed (nowhere) or indenter (sealed by
                                # it, drained beside it); a flat punch takes any path, a paraboloid a step of the radius

Of an elastic body whose adhesion depends on the speed of the contact's edge, G = work (1 + (v/speed)^exponent):

    [adhesion]
    work_of_adhesion = "50 mJ/m^2"
    speed = "1 um/s"
    exponent = 0.4
    closing_work = "30 mJ/m^2"  # or that of the opening edge; closing_speed, closing_exponent
    spring_stiffness = "20 N/m" # the depths of [history] are then those of the far end of a spring

    [history]
    path = "ramp"
    depth = "500 nm"
    rise_time = "1 s"
    fall_time = "10 s"
    retract_to = "-5 um"

or a path from a table with columns such as "time [s]" and "depth [nm]":

    [history]
    path = "file"
    file = "path.csv"
    control = "depth"           # or force, radius
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    files.add_problem(parser, "the whole path", "it has a table [history]")


def run(arguments: argparse.Namespace) -> None:
    """Computes, prints, writes."""
    files.check(arguments)
    problem, path = load_with(arguments.problem, "history")
    contact = problem.contact(in_time=True)
    spring = problem.adhesion and problem.adhesion.spring_stiffness
    if contact.adhesion is not None or contact.cohesive_stress > 0.0:
        found = follow_edge(contact, path, spring)
        history, cuts = History(found.time, found.depth, found.radius, found.force), 1
        closing = said(found)
    elif spring is not None:
        raise ProblemError(
            f"{problem.path}: [adhesion]: spring_stiffness is of a contact that it leads in time: give speed and exponent, "
            "or of a viscoelastic half-space its cohesive_stress"
        )
    else:
        history, cuts = follow(contact, path)
        closing = summary(history)
    table = columns_of(History(*(values[::cuts] for values in history)), "time", "depth", "radius", "force")
    print(f"{problem.title}\n")
    print(as_text(table, 12))
    print(f"\n{closing}")
    files.write(arguments, csv=lambda: as_csv(table), plot=lambda: history_figure.draw(problem, history))


def follow(contact: Contact, path: HistoryPath) -> tuple[History, int]:
    """The history, and how many of its steps are one of the path's: between few samples the force bends, and its work would be
    wrong."""
    cuts = max(1, -(-_FEWEST // max(1, len(path.time) - 1)))
    if path.drainage is not None or np.any(np.diff(path.time) <= 0.0) or (path.name != "depth" and np.any(path.values < 0.0)):
        cuts = 1  # refused, by the entry that the user knows
    samples = np.arange(len(path.time))
    places = np.arange((len(path.time) - 1) * cuts + 1) / cuts
    time, values = (np.interp(places, samples, column) for column in (path.time, path.values))
    prescribed: dict[str, Any] = {path.name: values}
    found = contact.history(time, **prescribed, progress=True, drainage=path.drainage)
    assert isinstance(found, History)
    return found, cuts


def follow_edge(contact: Contact, path: HistoryPath, spring: float | None) -> RateHistory | AdhesiveHistory:
    """The history where adhesion depends on speed, or has a range; led by depth, force or the far end of a spring."""
    name = "position" if spring is not None and path.name == "depth" else path.name
    prescribed: dict[str, Any] = {name: path.values}
    found = contact.history(path.time, **prescribed, spring_stiffness=spring, drainage=path.drainage)
    assert isinstance(found, (RateHistory, AdhesiveHistory))
    return found


def said(history: RateHistory | AdhesiveHistory) -> str:
    """Pull-off, the last rupture, and the energy lost at an edge."""
    end = history.end
    lines = [f"largest force: {shown(float(history.force.max()), FORCE)}"]
    lines.append(f"lowest force: {shown(end['lowest_force'], FORCE)} at {shown(end['lowest_time'], TIME)}, edge at "
                 f"{shown(end['lowest_speed'], SPEED)}")  # fmt: skip
    if end["ruptures"]:
        lines.append(f"the contact breaks at {shown(end['rupture_time'], TIME)}, depth {shown(end['rupture_depth'], LENGTH)}")
    if isinstance(history, RateHistory):
        lines.append(f"energy lost at the edge: {shown(float(history.dissipated[-1]), ENERGY)}")
    return "\n".join(lines)


def summary(history: History) -> str:
    """The largest force, when contact is lost, and the energy lost over a closed path."""
    largest = int(np.argmax(history.force))
    lines = [f"largest force: {shown(history.force[largest], FORCE)} at {shown(history.time[largest], TIME)}"]
    touching = np.flatnonzero(history.radius > 0.0)
    if touching.size and touching[-1] < len(history.radius) - 1 and history.depth[touching[-1]] > 0.0:
        lost = history.time[touching[-1] + 1]
        lines.append(f"contact is lost before {shown(lost, TIME)}, while the surface still comes back")
    if touching.size and history.radius[-1] == 0.0:
        lines.append(f"energy lost: {shown(history.work, ENERGY)}")
    return "\n".join(lines)
