# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact conduction`: heat or current through a contact along its loading."""

from __future__ import annotations

import argparse

import numpy as np

from .._units import CONDUCTANCE, LENGTH, TEMPERATURE, THERMAL_CONDUCTANCE, Unit, shown
from ..conduction import Conduction
from ..contact import State
from ..problem import load_with
from ..problem.conduction import THERMAL, Conducting
from . import conduction_figure, files
from .table import Column, as_csv, as_text, column, columns_of

HELP = "heat or current through a contact along its loading"
DESCRIPTION = """\
Computes the conductance of a contact along a load curve, and the temperatures that friction makes there.

    mdrcontact example tin_on_copper > problem.toml
    mdrcontact conduction problem.toml
    mdrcontact conduction problem.toml --csv conductance.csv --plot conductance.png

Each material of the problem file has, beside E and nu, a conductivity,

    electrical_conductivity = "59.6 MS/m"       # or thermal_conductivity = "400 W/(m*K)"; ..._along the surface if it differs

and one more table says what is conducted:

    [conduction]
    kind = "electrical"                         # or "thermal"
    film = "1e-12 ohm*m^2"                      # resistance in the spot itself; thermal_film = "1e-8 m^2*K/W"
    interfaces = ["0 ohm*m^2"]                  # resistance below each layer, from the surface down; thermal_interfaces
    friction_coefficient = 0.2                  # thermal: the heat of friction, both bodies at rest under its source
    speed = "1 mm/s"

A deformable indenter needs a conductivity, too; a rigid one holds the spot at one potential, and takes no heat of friction.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    files.add_problem(parser, "all rows of the table", "it has a table [conduction]")


def run(arguments: argparse.Namespace) -> None:
    """Computes, prints, writes."""
    files.check(arguments)
    problem, given = load_with(arguments.problem, "conduction")
    contact, conduction = problem.contact(), given.conduction(problem.medium)
    states = problem.control.states(contact)
    table = columns(conduction, given, states)
    print(f"{problem.title}\n")
    print(as_text(table, 12))
    print(f"\n{summary(conduction, given, states)}")
    files.write(arguments, csv=lambda: as_csv(table), plot=lambda: conduction_figure.draw(problem, conduction, states))


def columns(conduction: Conduction, given: Conducting, states: State) -> list[Column]:
    """What the tables show."""
    found = conduction.along(states)
    dimension = THERMAL_CONDUCTANCE if given.kind == THERMAL else CONDUCTANCE
    table = [
        *columns_of(states, "depth", "radius", "force"),
        column("conductance", np.asarray(found.conductance), dimension),
        Column("dlnG/dlnF", np.asarray(found.by_force) * np.asarray(states.force) / np.asarray(found.conductance), Unit("", 1.0)),
    ]
    if given.heat is not None:
        mu, speed = given.heat
        heat = conduction.friction_heat(states, mu, speed)
        table.append(column("centre", np.asarray(heat.centre), TEMPERATURE))
        table.append(column("mean", np.asarray(heat.flux_mean), TEMPERATURE))
        table.append(Column("share", np.asarray(heat.share), Unit("", 1.0)))
    return table


def summary(conduction: Conduction, given: Conducting, states: State) -> str:
    """The last conductance, and that without the film in the spot."""
    radius = float(np.asarray(states.radius)[-1])
    dimension = THERMAL_CONDUCTANCE if given.kind == THERMAL else CONDUCTANCE
    value = float(np.asarray(conduction.at_radius(radius).conductance))
    words = f"conductance at a = {shown(radius, LENGTH)}: {shown(value, dimension)}"
    if conduction.film:
        bare = float(np.asarray(conduction.replace(film=0.0).at_radius(radius).conductance))
        words += f"; without the film in the spot {shown(bare, dimension)}"
    return words
