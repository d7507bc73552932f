# SPDX-License-Identifier: GPL-3.0-or-later
"""Derivatives of a contact's force with respect to the constants of bodies and indenter.

At a given depth the line load q minimizes the energy, so that a change of the body's compliance C(k) changes F by what the old q
and the line load q1 of a flat punch of equal radius, of depth 1, determine (reciprocity):

    dF/dp = -1/(2 pi) int_0^inf P1(k) P(k) d(k C)/dp dk,   P(k) = 2 int_0^a q(x) cos(k x) dx

P1 likewise. d(k C)/dp tends to that of the top layer, whose part is 2 pi int_0^a q1 q dx by Parseval's theorem; the rest falls as
exp(-2 k h). No contact is solved again.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import InvalidArgumentError, NoConvergenceError
from .material import RIGID, SMOOTH, Elastic, TransverselyIsotropic
from .medium import Coated, Homogeneous, Layer, Layered
from .profile import FlatPunch, Paraboloid

Reals = NDArray[np.float64]
SMALLEST_LAYER = 1e-2
"""of the contact radius: thinner top layers take too many waves"""
TOLERANCE = 1e-10
_CENTRAL = ((1, 0.75), (-1, -0.75), (2, -0.15), (-2, 0.15), (3, 1 / 60), (-3, -1 / 60))
# next to a bound, as of Poisson's ratio
_BACKWARD = ((0, 49 / 20), (-1, -6.0), (-2, 7.5), (-3, -20 / 3), (-4, 3.75), (-5, -1.2), (-6, 1 / 6))

_MECHANICAL = {"E", "nu", "thickness", "prestress", "normal", "tangential", "C11", "C12", "C13", "C33", "C44"}
_MECHANICAL |= {"E_t", "E_z", "nu_t", "nu_tz", "G_z"}


def gradient(state: Any) -> dict[str, float]:
    """See `State.gradient`."""
    contact = state._owner
    surface_layer = _surface_layer(contact.medium)
    if contact.work_of_adhesion:
        raise InvalidArgumentError("work_of_adhesion: derivatives are known of contacts without adhesion")
    if any(np.ndim(value) for value in state._numbers()) or not state.radius > 0.0:
        raise InvalidArgumentError("state: it must be one state, with a contact radius > 0")
    thinnest = math.inf if surface_layer is None else surface_layer.thickness
    if thinnest < SMALLEST_LAYER * state.radius:
        raise InvalidArgumentError(
            f"state: its radius {state.radius:g} is above {1 / SMALLEST_LAYER:g} thicknesses of the top layer"
        )
    top = 25.0 / thinnest / (1.0 if surface_layer is None else _decay(surface_layer.material))
    x, q, q1 = _line_loads(state, top)
    k, weights = (np.zeros(0), np.zeros(0)) if surface_layer is None else _octaves(top, state.radius)
    waves = weights * _transform(x, q, k) * _transform(x, q1, k)
    surface = 1.0 if surface_layer is None else 16.0 * top
    all_k = np.append(k, surface)
    local = 2.0 * math.pi * float((q * q1 / x[1]).sum())

    def of(changed: Callable[[float], Any], value: float, steps: Any, step: float) -> float:
        c = sum(weight * all_k * changed(value + i * step).compliance(all_k) for i, weight in steps) / step
        return -(local * float(c[-1]) + float((waves * (c[:-1] - c[-1])).sum())) / (2.0 * math.pi)

    found = {}
    constants = contact.medium.parameters()
    for name, value in constants.items():
        if name.rpartition(".")[2] not in _MECHANICAL or value == 0.0:
            continue
        change = partial(_changed, contact.medium, name)
        found[name] = _first_allowed(partial(of, change, value), _steps(constants, name))
    if isinstance(contact.indenter, Paraboloid):
        # at a given radius depth and force are proportional to 1/R
        found["radius"] = (state.depth * state.stiffness - state.force) / contact.indenter.radius
    return found


def _surface_layer(medium: Any) -> Layer | None:
    """The layer at the surface; None of a half-space. Refuses media without derivatives."""
    if not isinstance(medium, (Homogeneous, Coated, Layered)):
        raise InvalidArgumentError(f"{type(medium).__name__}: derivatives are known of Homogeneous, Coated and Layered")
    if medium.surface is not None:
        raise InvalidArgumentError("surface: derivatives are known of bodies without tension or plate")
    model = getattr(medium, "model", "exact")
    if model != "exact":
        raise InvalidArgumentError(f"model = {model!r}: derivatives are known of the model 'exact'")
    layers = medium._stack()
    below = medium.material if isinstance(medium, Homogeneous) else medium.substrate
    bodies = [material for material, _ in layers] + ([] if below in (RIGID, SMOOTH) else [below])
    if not all(isinstance(material, (Elastic, TransverselyIsotropic)) for material in bodies):
        raise InvalidArgumentError("the materials must be elastic: Elastic or TransverselyIsotropic")
    return layers[0] if layers else None


def _decay(material: Any) -> float:
    """The slowest wave in a material decays as exp(-decay k z)."""
    if isinstance(material, Elastic):
        return 1.0
    C11, C13, C33, C44 = material.C11, material.C13, material.C33, material.C44
    squares = (C11 - C13**2 / C33) / C44 - 2.0 * C13 / C33
    product = math.sqrt(C11 / C33)
    total, apart = math.sqrt(squares + 2.0 * product), math.sqrt(max(squares - 2.0 * product, 0.0))
    return min(1.0, 2.0 * product / (total + apart))


def _changed(medium: Any, name: str, value: float) -> Any:
    return medium.with_parameters({name: value})


def _steps(constants: dict[str, float], name: str) -> list[tuple[Any, float]]:
    """Rules and steps of differences, the best one first; the others stay within the range of a constant."""
    body, dot, last = name.rpartition(".")
    step = 2e-3 * abs(constants[name])
    if last in ("nu", "nu_t"):
        step = 3e-3 if constants[name] < 0.49 else 2e-3
    elif last == "nu_tz":
        # it is smooth on the scale of its bound
        step = 2e-3 * min(1.0, math.sqrt(0.5 * constants[body + dot + "E_t"] / constants[body + dot + "E_z"]))
    elif last in ("C12", "C13"):
        step = 1e-3 * constants[body + dot + "C33"]
    return [(_CENTRAL, step), (_BACKWARD, step), (_BACKWARD, -step), (_CENTRAL, 1e-2 * step), (_BACKWARD, 1e-2 * step)]


def _first_allowed(of: Callable[[Any, float], float], rules: list[tuple[Any, float]]) -> float:
    """Derivative by the first rule whose values are all allowed."""
    for rule in rules[:-1]:
        try:
            return of(*rule)
        except InvalidArgumentError:
            continue
    return of(*rules[-1])


def _nodes(count: int, low: float, high: float) -> tuple[Reals, Reals]:
    """Gauss and Legendre's."""
    x, weights = np.polynomial.legendre.leggauss(count)
    return 0.5 * (high - low) * x + 0.5 * (high + low), 0.5 * (high - low) * weights


def _octaves(top: float, a: float) -> tuple[Reals, Reals]:
    """Nodes of waves up to the shortest, octave by octave: stiff films bend in waves far longer than they are thick."""
    ends = top * 0.5 ** np.arange(25)
    parts = [_nodes(24 + math.ceil((end - low) * a), low, end) for end, low in zip(ends, [*ends[1:], 0.0], strict=True)]
    return np.concatenate([part[0] for part in parts]), np.concatenate([part[1] for part in parts])


def _line_loads(state: Any, top: float) -> tuple[tuple[Reals, Reals], Reals, Reals]:
    """Nodes with one over their weights, q and q1 times weights; as many that F and k come out."""
    a = state.radius
    contact = state.contact
    small = type(contact)(FlatPunch(a), contact.medium).at_depth(1e-6 * a)
    waves = top * a if math.isfinite(top) else 0.0
    for count in (100, 200, 400, 800):
        x, weights = _nodes(count + math.ceil(waves), 0.0, a * (1.0 - 1e-13))
        q, q1 = weights * state.line_load(x), weights * small.line_load(x) / small.depth
        errors = 2.0 * q.sum() / state.force - 1.0, 2.0 * q1.sum() / state.stiffness - 1.0
        if max(map(abs, errors)) < TOLERANCE:
            return (x, weights), q, q1
    raise NoConvergenceError("the line load of this indenter is not smooth enough for derivatives of F")


def _transform(x: tuple[Reals, Reals], load: Reals, k: Reals) -> Reals:
    """2 int q cos(k x) dx at wavenumbers, some at a time."""
    parts = [2.0 * np.cos(np.outer(some, x[0])) @ load for some in np.array_split(k, 1 + k.size * x[0].size // 2_000_000)]
    return np.concatenate(parts)
