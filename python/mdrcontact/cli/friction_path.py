# SPDX-License-Identifier: GPL-3.0-or-later
"""The path of a contact with friction that the command `friction` prints and draws."""

from __future__ import annotations

import re
from typing import Any, NamedTuple

import numpy as np

from .. import _progress
from ..contact import State
from ..errors import InvalidArgumentError, MDRError, UnreachableError
from ..friction import Friction, FrictionHistory
from ..problem import Problem
from ..problem.friction import Sliding, SlidingPath
from ..sheared import ShearState

_RINGS = 100
"""Rings of the surface where springs interact."""


class LedPath(NamedTuple):
    """A contact led along a path: the states after each row."""

    friction: Friction
    state: State
    shear: ShearState
    rings: int
    """0: exact springs"""
    force_error: float
    """how far T is from that of half the rings, in units of the largest mu F"""
    energy_error: float
    """the same of the dissipated energy, in units of its end value"""


def lead(problem: Problem, sliding: Sliding, path: SlidingPath) -> LedPath:
    """The path of a problem; where it is computed by rings, once more with half of them."""
    friction = Friction(problem.contact(), sliding.coefficient)
    at: Any = friction.contact.at_depth if path.name == "depth" else friction.contact.at_force
    state: State = at(path.values)
    history = _exact(friction) if path.rings is None else None
    with _progress.bar(len(path.values) * (1 if history else 2), "steps") as bar:
        if history:
            return LedPath(friction, state, _along(path, state, history, bar), 0, 0.0, 0.0)
        rings, deepest = path.rings or _RINGS, float(np.max(state.depth))
        fine, coarse = (_along(path, state, friction.history(deepest, rings // part), bar) for part in (1, 2))
    unit = sliding.coefficient * float(np.max(state.force))
    force = float(np.max(np.abs(np.subtract(fine.tangential_force, coarse.tangential_force)))) / unit
    lost = np.asarray(fine.dissipated_energy)
    apart = float(np.max(np.abs(lost - np.asarray(coarse.dissipated_energy))))
    return LedPath(friction, state, fine, rings, force, apart / lost[-1] if lost[-1] > 0.0 else 0.0)


def _exact(friction: Friction) -> FrictionHistory | None:
    """A history in which every step is exact, None where springs interact."""
    try:
        return friction.history()
    except InvalidArgumentError:
        return None


def _along(path: SlidingPath, state: State, history: FrictionHistory, bar: Any) -> ShearState:
    """The tangential states after each row."""
    shears = []
    for row, (depth, along) in enumerate(zip(np.asarray(state.depth), path.along_values, strict=True), start=1):
        try:
            history.advance(**{"depth": depth, path.along: along})
        except MDRError as problem:
            # a row is the only entry of its step
            words = re.sub(r"^(entry \d+ of|entry \d+:) ", "", str(problem))
            if path.along == "tangential_force" and isinstance(problem, UnreachableError):
                words += "; lead a path with sliding by shifts"
            raise type(problem)(f"{path.file}, row {row} of the numbers: {words}") from problem
        shears.append(history.shear)
        bar.update()
    return ShearState._make(np.array(values) for values in zip(*shears, strict=True))
