# SPDX-License-Identifier: GPL-3.0-or-later
"""The cycles of shear that the command `friction` prints and draws."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from ..contact import State
from ..friction import Friction
from ..problem import Problem
from ..problem.friction import Sliding
from ..sheared import FrictionLoop, ShearState

_FROM, _TO, _COUNT = 0.01, 1.5, 12


class Cycles(NamedTuple):
    """The cycles of one normal state."""

    friction: Friction
    state: State
    sliding_shift: float
    turns: ShearState
    energies: np.ndarray[Any, np.dtype[np.float64]]
    loops: tuple[FrictionLoop, ...]


def cycles(problem: Problem, sliding: Sliding, *, with_loops: bool) -> Cycles:
    """The cycles of the amplitudes that the problem gives."""
    friction = Friction(problem.contact(), sliding.coefficient)
    state = problem.control.states(friction.contact, slice(-1, None))[0]
    sheared = friction.shear(state)
    limit = float(sheared.sliding_shift)
    amplitudes = np.array(sliding.amplitudes) if sliding.amplitudes else np.geomspace(_FROM, _TO, _COUNT) * limit
    turns = (sheared.at_shift if sliding.control == "shift" else sheared.at_force)(amplitudes)
    energies = 4.0 * np.asarray(turns.dissipated_energy)
    chosen = sorted({*range(len(amplitudes) - 1, -1, -max(1, len(amplitudes) // 4))})
    loops = tuple(sheared.loop(amplitudes[i], sliding.control) for i in chosen) if with_loops else ()
    return Cycles(friction, state, limit, turns, energies, loops)
