# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact stress`: stresses inside a coated body, where they are largest, and the load at first failure."""

from __future__ import annotations

import argparse
import math
from typing import Any

import numpy as np

from .. import _progress
from .._text import aligned
from .._units import FORCE, LENGTH, MODULUS, RATIO, shown
from ..contact import Contact, State
from ..critical import Maximum, layers_of
from ..errors import InvalidArgumentError
from ..failure import Failure
from ..interior import Interior
from ..problem import Problem, ProblemError, load
from ..problem.strength import Strengths
from . import files
from .inside import Inside, interface_name, layer_map, layer_name
from .stress_figure import stress_figure
from .table import as_csv, column, number

HELP = "stresses inside a coated body, and the load at first failure"
DESCRIPTION = """\
Computes stresses and displacements inside the body for the largest depth, force or radius of the problem: the largest von Mises
stress, shear stress and tension in each layer and at each interface, and where they are.

    mdrcontact example tin_on_steel > problem.toml
    mdrcontact stress problem.toml
    mdrcontact stress problem.toml --plot stress.png --csv stress.csv
    mdrcontact stress problem.toml --friction 0.2          # the indenter slides

With a table [strength] in the problem file (lists from the surface down, the substrate last; "none" where no failure is looked for)
the loads are found at which the strengths are first reached:

    [strength]
    von_mises = ["14 GPa", "1.5 GPa"]   # von Mises stress of each layer
    tension = ["3 GPa", "none"]         # principal stress of each layer: cracks
    interface_shear = ["0.8 GPa"]       # of each interface
    interface_tension = ["0.5 GPa"]
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("problem", metavar="PROBLEM.toml", help="the problem file")
    parser.add_argument(
        "--friction", type=_friction, default=0.0, metavar="F", help="coefficient of friction of a sliding indenter"
    )
    files.add_options(parser, "displacements and stresses on a grid")


def run(arguments: argparse.Namespace) -> None:
    """Computes, prints, writes."""
    files.check(arguments)
    problem = load(arguments.problem)
    contact = problem.contact()
    state = problem.control.states(contact, slice(-1, None))[0]
    found = _inside(problem, contact, state, arguments.friction, bool(arguments.csv or arguments.plot))
    print(f"{problem.title}\n\n{_words(found)}")
    files.write(arguments, csv=lambda: _grid_csv(found), plot=lambda: stress_figure(problem, contact, found))


def _inside(problem: Problem, contact: Contact, state: State, friction: float, with_maps: bool) -> Inside:
    thicknesses, rigid = layers_of(contact.medium)
    faces = [0.0, *np.cumsum(thicknesses).tolist()]
    with _progress.waiting("largest stresses"):
        largest = state.critical(friction=friction)
    failures: tuple[Failure, ...] = ()
    unreached: list[str] = []
    if problem.strength is not None:
        with _progress.bar(len(problem.strength), "modes") as bar:
            failures = _failures(contact, problem.strength, friction, 3.0 * float(state.radius), bar)
        reached = {(failure.mode, failure.place) for failure in failures}
        unreached = [
            f"{mode}, {(interface_name if mode.startswith('interface') else layer_name)(faces, i)}, {shown(value, MODULUS)}"
            for mode, values in problem.strength.items()
            for i, value in enumerate(values)
            if value is not None and (mode, i) not in reached
        ]
    maps = []
    if with_maps:
        count = len(faces) - rigid
        maps = [layer_map(contact, state, friction, faces, i) for i in range(count)]
    return Inside(state, friction, faces, largest, failures, unreached, maps)


def _failures(contact: Contact, strengths: Strengths, friction: float, largest: float, bar: Any) -> tuple[Failure, ...]:
    found: list[Failure] = []
    for mode, values in strengths.items():
        if any(value is not None for value in values):
            try:
                found += contact.first_failure({mode: tuple(values)}, friction=friction, largest_radius=largest)
            except InvalidArgumentError as problem:
                raise ProblemError(f"[strength]: {problem}") from problem
        bar.update()
    if all(value is None for values in strengths.values() for value in values):
        raise ProblemError('[strength]: all strengths are "none"')
    return tuple(sorted(found, key=lambda failure: float(failure.state.force)))


def _words(found: Inside) -> str:
    """The state, the maxima and the failures."""
    state = found.state
    parts = [
        f"depth {shown(state.depth, LENGTH)}, contact radius {shown(state.radius, LENGTH)}, "
        f"force {shown(state.force, FORCE)}, mean pressure {shown(state.force / math.pi / state.radius**2, MODULUS)}"
        + (f", sliding with friction {found.friction:g}" if found.friction else "")
    ]
    rows = [["largest", "where", "value", "r/a", "z"]]
    for i, layer in enumerate(found.critical.layers):
        name = layer_name(found.faces, i)
        rows += [
            _row("von Mises stress", name, layer.von_mises, state),
            _row("shear stress (s1 - s3)/2", name, layer.tresca, state),
            _row("tension", name, layer.tension, state),
        ]
    rows.append(_row("tension", "free surface", found.critical.surface, state))
    for i, interface in enumerate(found.critical.interfaces):
        name = interface_name(found.faces, i)
        rows += [_row("shear stress", name, interface.shear, state), _row("tension s_zz", name, interface.tension, state)]
    parts.append(aligned(rows, left=2))
    energies = [layer.energy for layer in found.critical.layers]
    shares = ", ".join(f"{layer_name(found.faces, i)} {100.0 * e / sum(energies):.3g} %" for i, e in enumerate(energies))
    parts.append(f"elastic energy: {shares}")
    if found.failures:
        rows = [["failure", "where", "strength", "force", "depth", "a"]]
        rows += [
            [
                failure.mode,
                failure_place(found.faces, failure),
                shown(failure.strength, MODULUS),
                *(
                    ["at once", "", ""]
                    if failure.at_once
                    else [
                        shown(failure.state.force, FORCE),
                        shown(failure.state.depth, LENGTH),
                        shown(failure.state.radius, LENGTH),
                    ]
                ),
            ]
            for failure in found.failures
        ]
        parts.append("In the order in which they come as the load grows:\n\n" + aligned(rows, left=2))
    if found.unreached:
        farthest = shown(3.0 * float(state.radius), LENGTH)
        parts.append(f"Not reached up to a = {farthest}, singular edges apart: {'; '.join(found.unreached)}")
    return "\n\n".join(parts)


def failure_place(faces: list[float], failure: Failure) -> str:
    """Which layer or interface fails; a film that cracks from its surface beside the contact has a ring crack."""
    if failure.mode.startswith("interface"):
        return interface_name(faces, failure.place)
    name = layer_name(faces, failure.place)
    is_ring = failure.mode == "tension" and failure.at.z == 0.0 and failure.at.r >= float(failure.state.radius) * (1.0 - 1e-9)
    return f"{name}, ring crack" if is_ring else name


def _row(what: str, where: str, maximum: Maximum, state: State) -> list[str]:
    sign = -1.0 if maximum.angle else 1.0
    return [
        what,
        where,
        shown(maximum.value, MODULUS),
        number(sign * round(maximum.r / float(state.radius), 4)),
        shown(maximum.z, LENGTH),
    ]


def _grid_csv(found: Inside) -> bytes:
    parts = []
    for layer in found.maps:
        x, z = np.broadcast_arrays(layer.x[:, None], layer.z[None, :])
        stresses = [layer.field.von_mises, layer.field.tresca, layer.field.principal[..., 0]]
        parts.append(np.array([x, z, *layer.field, *stresses]).reshape(14, -1))
    values = np.concatenate(parts, axis=1)
    names = ["x", "z", *Interior._fields, "von Mises", "largest shear", "largest tension"]
    dimensions = [LENGTH] * 5 + [MODULUS] * 9
    layers = np.concatenate([np.full(part.shape[1], float(i + 1)) for i, part in enumerate(parts)])
    return as_csv(
        [column("layer", layers, RATIO)] + [column(name, v, d) for name, v, d in zip(names, values, dimensions, strict=True)]
    )


def _friction(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0.0 <= value < math.inf:
        raise argparse.ArgumentTypeError(f"{text!r} is not a coefficient of friction: it must be a number, at least 0")
    return value
