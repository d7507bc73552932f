# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `stress`: stresses inside a coated body, where they are largest, and the load at first failure."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from .._units import FORCE, LENGTH, MODULUS, RATIO, Unit, practical, shown
from ..contact import Contact, State
from ..critical import Critical, Maximum, layers_of
from ..errors import InvalidArgumentError
from ..failure import Failure
from ..interior import Interior
from ..panels import Axis, Cells, Figure, Label, Line, Panel, Part, Rule, along
from ..problem import Problem, ProblemError
from ..problem.strength import Strengths
from ..progress import Progress
from .result import Array, Column, Mixed, Number, Result, Table, Words, column, shared, study

_POINTS = 121
_FARTHEST = 2.0
"""Largest distance of a map from the axis, in units of a."""
_PLACES = 301
"""Points along the surface and the interfaces, as far as 3 a."""


class Layer(NamedTuple):
    """The field on a grid in one layer, in the plane of sliding."""

    x: Array
    z: Array
    field: Interior


class Face(NamedTuple):
    """The field just above the surface or an interface, in the plane of sliding."""

    z: float
    x: Array
    """negative behind a sliding contact"""
    field: Interior


@dataclass(frozen=True, eq=False, kw_only=True)
class StressResult(Result):
    """Stresses inside a body. Tables: "maxima", "failures" if there are any, and "grid" with the maps."""

    problem: Problem
    state: State
    friction: float
    faces: tuple[float, ...]
    """depths of the surface and of the interfaces [m]"""
    critical: Critical
    failures: tuple[Failure, ...]
    maps: tuple[Layer, ...] = ()
    lines: tuple[Face, ...] = ()
    """the fields along `faces`"""

    def figure(self) -> Figure:
        """Return maps of von Mises stress and largest principal stress, and stresses along axis, surface and interfaces."""
        first, last = self.maps[0], self.maps[-1]
        height = float((last.z[-1] - first.z[0]) / (first.x[-1] - first.x[0])) + 0.35
        panels = (_map_panel(self, "von Mises stress"), _map_panel(self, "largest principal stress"))
        text = f"{self.title}\n{_state_words(self)}"
        return Figure(text, (*panels, _axis_panel(self), _faces_panel(self)), heights=(height, 1.0))


def _state_words(found: StressResult) -> str:
    text = ", ".join(
        f"{name} = {float(unit.of(value)):.4g} {unit.symbol}"
        for name, value, unit in (
            (name, value, practical(dimension, [float(value)]))
            for name, value, dimension in (("F", found.state.force, FORCE), ("a", found.state.radius, LENGTH))
        )
    )
    return f"{text}, sliding to the right with friction {found.friction:g}" if found.friction else text


def _map_panel(found: StressResult, what: str) -> Panel:
    """One quantity in the section, with contact, interfaces and the largest values."""
    is_tension = what.startswith("largest")
    values = [np.asarray(layer.field.principal[..., 0] if is_tension else layer.field.von_mises) for layer in found.maps]
    finite = np.concatenate([v[np.isfinite(v)] for v in values])
    # a singular edge must not use up all colours
    top = min(float(finite.max()), 3.0 * float(np.quantile(finite, 0.99)))
    unit, length = practical(MODULUS, [top]), practical(LENGTH, [found.maps[-1].z[-1]])
    end = float(unit.of(top))
    axis = Axis(what, unit.symbol, low=-end if is_tension else 0.0, high=end)
    count, a = len(found.maps), float(found.state.radius)
    dark = "black" if is_tension else "white"
    parts: list[Part] = [
        Cells(length.of(layer.x), length.of(layer.z), unit.of(value).T, axis, is_tension, bar=i == count - 1)
        for i, (layer, value) in enumerate(zip(found.maps, values, strict=True))
    ]
    parts += [Rule(float(length.of(z)), colour=dark, dash=0) for z in found.faces[1:] if z < found.maps[-1].z[-1]]
    parts += [
        Line(length.of(np.array([-a, a])), np.zeros(2), "", "black", width=5.0),
        *_marks(found, is_tension, length, unit, dark),
    ]
    x = Axis("x", length.symbol, low=float(length.of(found.maps[0].x[0])), high=float(length.of(found.maps[0].x[-1])))
    y = Axis("depth z", length.symbol, low=0.0, high=float(length.of(found.maps[-1].z[-1])))
    return Panel(x, y, tuple(parts), equal=True, downward=True)


def _marks(found: StressResult, is_tension: bool, length: Unit, unit: Unit, colour: str) -> Iterator[Label]:
    """The largest values that lie in the section."""
    places = [(layer_name(found.faces, i), part) for i, part in enumerate(found.critical.layers)]
    maxima = [(name, part.tension if is_tension else part.von_mises) for name, part in places]
    surface = found.critical.surface
    if is_tension and surface[1:] != found.critical.layers[0].tension[1:]:
        maxima.append(("surface", surface))
    for name, most in maxima:
        at = -most.r if most.angle else most.r
        inside = abs(at) <= found.maps[0].x[-1] and most.z <= found.maps[-1].z[-1]
        if inside and most.value > 0.0:
            text = f"{name} {float(unit.of(most.value)):.4g} {unit.symbol}"
            yield Label(float(length.of(at)), float(length.of(most.z)), text, colour)


def _axis_panel(found: StressResult) -> Panel:
    middle = len(found.maps[0].x) // 2
    fields = (("von Mises", "von_mises"), ("radial", "s_rr"), ("normal to the surface", "s_zz"))
    columns = [[np.asarray(getattr(layer.field, name))[middle] for layer in found.maps] for _, name in fields]
    largest = np.concatenate([v for column in columns for v in column])
    x, length = along("depth z on the axis", LENGTH, [found.maps[-1].z[-1]], low=0.0)
    y, unit = along("stress", MODULUS, largest[np.isfinite(largest)])
    lines = (
        Line(length.of(layer.z), unit.of(values), "" if j else words, i)
        for i, ((words, _), column) in enumerate(zip(fields, columns, strict=True))
        for j, (layer, values) in enumerate(zip(found.maps, column, strict=True))
    )
    rules = (Rule(float(length.of(z)), vertical=True) for z in found.faces[1:] if z < found.maps[-1].z[-1])
    return Panel(x, y, (*lines, *rules, Rule(0.0, dash=0)))


def _faces_panel(found: StressResult) -> Panel:
    a, place = float(found.state.radius), found.lines[0].x
    outside = np.abs(place) > a * (1.0 + 1e-6)
    lines = []
    for i, (z, _, field) in enumerate(found.lines):
        if z == 0.0:
            lines.append(("radial, free surface", np.where(outside, np.asarray(field.s_rr), np.nan)))
            continue
        name = interface_name(found.faces, i - 1)
        lines += [(f"shear, {name}", np.hypot(field.s_rz, field.s_tz)), (f"normal, {name}", np.asarray(field.s_zz))]
    x, length = along("x" if found.friction else "distance from the axis r", LENGTH, place)
    y, unit = along("stress", MODULUS, np.concatenate([v[np.isfinite(v)] for _, v in lines]))
    drawn = (Line(length.of(place), unit.of(values), name, i) for i, (name, values) in enumerate(lines))
    edges = (Rule(float(length.of(edge)), vertical=True, name="edge") for edge in ((-a, a) if found.friction else (a,)))
    return Panel(x, y, (*drawn, *edges, Rule(0.0, dash=0)))


@study
def stress(
    problem: Problem, *, friction: float = 0.0, maps: bool = False, lines: bool = False, progress: Progress | None = None
) -> StressResult:
    """Compute the largest stresses in a body and the loads at first failure.

    Parameters
    ----------
    problem : Problem
        The state is the last one of [compute]; loads at failure follow from the table [strength], if there is one.
    friction : float, optional
        Coefficient of friction of a sliding indenter, >= 0 [1].
    maps : bool, optional
        Compute displacements and stresses on a grid in each layer as well.
    lines : bool, optional
        Compute them along the surface and the interfaces as well.
    progress : Progress, optional
        Reports the modes of failure, and can stop the work.

    Returns
    -------
    StressResult
        `critical`, `failures`; notes "state", "energy", "failures", "unreached".

    Raises
    ------
    ProblemError
        A strength is wrong.
    MDRError
        The problem cannot be solved, or its body has no layers.

    Examples
    --------
    >>> from mdrcontact import problem, studies
    >>> ball = {"shape": "paraboloid", "radius": "10 um"}
    >>> glass = {"type": "homogeneous", "material": {"E": "72 GPa", "nu": 0.3}}
    >>> tables = {"indenter": ball, "medium": glass, "compute": {"max_force": "1 mN"}}
    >>> found = studies.stress(problem.read(tables))
    >>> print(found.tables["maxima"][0].values[0], found.numbers["von Mises stress, body"])
    von Mises stress 1.424 GPa
    """
    progress = progress or Progress()
    contact = problem.contact()
    state = problem.control.states(contact, slice(-1, None))[0]
    thicknesses, rigid = layers_of(contact.medium)
    faces = (0.0, *np.cumsum(thicknesses).tolist())
    progress.step(0, None, "largest stresses")
    largest = state.critical(friction=friction)
    failures = _failures(contact, problem.strength, friction, 3.0 * float(state.radius), progress) if problem.strength else ()
    maxima = _maxima(state, faces, largest)
    grids = tuple(_map(state, friction, faces, i) for i in range(len(faces) - rigid)) if maps else ()
    tables: dict[str, Table] = {"maxima": _maxima_table(maxima, state)}
    notes = {"state": _state_note(state, friction), "energy": _energy_note(faces, largest)}
    if failures:
        notes["failures"] = "In the order in which they come as the load grows:"
        tables["failures"] = _failures_table(faces, failures)
    if unreached := _unreached(problem.strength or {}, faces, failures):
        farthest = shown(3.0 * float(state.radius), LENGTH)
        notes["unreached"] = f"Not reached up to a = {farthest}, singular edges apart: {'; '.join(unreached)}"
    if grids:
        tables["grid"] = _grid(grids)
    return StressResult(
        title=problem.title,
        numbers={f"{what}, {where}": Number(maximum.value, MODULUS) for what, where, maximum in maxima},
        notes=notes,
        tables=tables,
        problem=problem,
        state=state,
        friction=friction,
        faces=faces,
        critical=largest,
        failures=failures,
        maps=grids,
        lines=tuple(_line(state, friction, z) for z in faces) if lines else (),
    )


def _failures(contact: Contact, strengths: Strengths, friction: float, largest: float, progress: Progress) -> tuple[Failure, ...]:
    def of_mode(strength: tuple[str, Any]) -> Iterable[Failure]:
        mode, values = strength
        if all(value is None for value in values):
            return ()
        try:
            return contact.first_failure({mode: tuple(values)}, friction=friction, largest_radius=largest)
        except InvalidArgumentError as problem:
            raise ProblemError(f"[strength]: {problem}") from problem

    found = [failure for part in shared(progress, of_mode, strengths.items(), "modes") for failure in part]
    if all(value is None for values in strengths.values() for value in values):
        raise ProblemError('[strength]: all strengths are "none"')
    return tuple(sorted(found, key=lambda failure: float(failure.state.force)))


def _unreached(strengths: Strengths, faces: tuple[float, ...], failures: tuple[Failure, ...]) -> list[str]:
    reached = {(failure.mode, failure.place) for failure in failures}
    return [
        f"{mode}, {(interface_name if mode.startswith('interface') else layer_name)(faces, i)}, {shown(value, MODULUS)}"
        for mode, values in strengths.items()
        for i, value in enumerate(values)
        if value is not None and (mode, i) not in reached
    ]


def _map(state: State, friction: float, faces: tuple[float, ...], i: int) -> Layer:
    """The field in a layer on the plane of sliding, as far as a map shows it; points where stresses are infinite are left out."""
    a, total = float(state.radius), faces[-1]
    deepest = max(1.6 * a, min(1.5 * total, total + 2.0 * a))
    top, bottom = faces[i], faces[i + 1] if i + 1 < len(faces) else deepest
    bottom = max(min(bottom, deepest), top)
    x = np.linspace(-_FARTHEST * a, _FARTHEST * a, 2 * _POINTS - 1)
    hair = 1e-9 * (a + top)
    z = np.linspace(top + (hair if top else 0.0), bottom - hair if i + 1 < len(faces) else bottom, _POINTS)
    z[0] = z[0] or 1e-3 * (z[1] - z[0])
    # x < 0 lies on the other side of the axis
    field = state.interior(
        np.abs(x)[:, None], z[None, :], side="above", friction=friction, angle=np.where(x < 0.0, math.pi, 0.0)[:, None]
    )
    return Layer(x, z, field)


def _line(state: State, friction: float, z: float) -> Face:
    """The field along the surface or an interface."""
    farthest = 3.0 * float(state.radius)
    x = np.linspace(-farthest if friction else 0.0, farthest, _PLACES)
    angle = np.where(x < 0.0, math.pi, 0.0)
    return Face(z, x, state.interior(np.abs(x), z, side="above", friction=friction, angle=angle))


def layer_name(faces: tuple[float, ...], i: int) -> str:
    """Return the name of a layer."""
    if i == len(faces) - 1:
        return "substrate" if i else "body"
    return "film" if len(faces) == 2 else f"layer {i + 1}"


def interface_name(faces: tuple[float, ...], i: int) -> str:
    """Return the name of an interface."""
    return "interface" if len(faces) == 2 else f"interface {i + 1}"


def _state_note(state: State, friction: float) -> str:
    return (
        f"depth {shown(state.depth, LENGTH)}, contact radius {shown(state.radius, LENGTH)}, "
        f"force {shown(state.force, FORCE)}, mean pressure {shown(state.force / math.pi / state.radius**2, MODULUS)}"
        + (f", sliding with friction {friction:g}" if friction else "")
    )


def _energy_note(faces: tuple[float, ...], critical: Critical) -> str:
    energies = [layer.energy for layer in critical.layers]
    shares = ", ".join(f"{layer_name(faces, i)} {100.0 * e / sum(energies):.3g} %" for i, e in enumerate(energies))
    return f"elastic energy: {shares}"


def _maxima(state: State, faces: tuple[float, ...], critical: Critical) -> list[tuple[str, str, Maximum]]:
    """Return the largest stresses with body, value and position."""
    found = []
    for i, layer in enumerate(critical.layers):
        name = layer_name(faces, i)
        found += [
            ("von Mises stress", name, layer.von_mises),
            ("shear stress (s1 - s3)/2", name, layer.tresca),
            ("tension", name, layer.tension),
        ]
    found.append(("tension", "free surface", critical.surface))
    for i, interface in enumerate(critical.interfaces):
        name = interface_name(faces, i)
        found += [("shear stress", name, interface.shear), ("tension s_zz", name, interface.tension)]
    return found


def _maxima_table(maxima: list[tuple[str, str, Maximum]], state: State) -> Table:
    places = [(-1.0 if one.angle else 1.0) * round(one.r / float(state.radius), 4) for _, _, one in maxima]
    return [
        Words("largest", [what for what, _, _ in maxima]),
        Words("where", [where for _, where, _ in maxima]),
        Mixed("value", [one.value for _, _, one in maxima], MODULUS),
        column("r/a", places, RATIO),
        Mixed("z", [one.z for _, _, one in maxima], LENGTH),
    ]


def _failures_table(faces: tuple[float, ...], failures: tuple[Failure, ...]) -> Table:
    at_once = [i for i, failure in enumerate(failures) if failure.at_once]
    states = [failure.state for failure in failures]
    return [
        Words("failure", [failure.mode for failure in failures]),
        Words("where", [_failure_place(faces, failure) for failure in failures]),
        Mixed("strength", [failure.strength for failure in failures], MODULUS),
        Mixed("force", [float(state.force) for state in states], FORCE, dict.fromkeys(at_once, "at once")),
        Mixed("depth", [float(state.depth) for state in states], LENGTH, dict.fromkeys(at_once, "")),
        Mixed("a", [float(state.radius) for state in states], LENGTH, dict.fromkeys(at_once, "")),
    ]


def _failure_place(faces: tuple[float, ...], failure: Failure) -> str:
    """Return the name of what fails; a film that cracks at its surface outside the contact has a ring crack."""
    if failure.mode.startswith("interface"):
        return interface_name(faces, failure.place)
    name = layer_name(faces, failure.place)
    is_ring = failure.mode == "tension" and failure.at.z == 0.0 and failure.at.r >= float(failure.state.radius) * (1.0 - 1e-9)
    return f"{name}, ring crack" if is_ring else name


def _grid(maps: tuple[Layer, ...]) -> list[Column]:
    """The maps of all layers below each other."""
    parts = []
    for layer in maps:
        x, z = np.broadcast_arrays(layer.x[:, None], layer.z[None, :])
        stresses = [layer.field.von_mises, layer.field.tresca, layer.field.principal[..., 0]]
        parts.append(np.array([x, z, *layer.field, *stresses]).reshape(14, -1))
    values = np.concatenate(parts, axis=1)
    names = ["x", "z", *Interior._fields, "von Mises", "largest shear", "largest tension"]
    dimensions = [LENGTH] * 5 + [MODULUS] * 9
    layers = np.concatenate([np.full(part.shape[1], float(i + 1)) for i, part in enumerate(parts)])
    return [column("layer", layers, RATIO), *(column(name, v, d) for name, v, d in zip(names, values, dimensions, strict=True))]
