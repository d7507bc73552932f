# SPDX-License-Identifier: GPL-3.0-or-later
"""The cycles of shear that the command `friction` prints and draws."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from ..contact import State
from ..friction import Friction, FrictionLoop, TangentialState
from ..problem import Problem
from ..problem.friction import Sliding

_FROM, _TO, _COUNT = 0.01, 1.5, 12


class Cycles(NamedTuple):
    """The cycles of one normal state."""

    friction: Friction
    state: State
    sliding_shift: float
    turns: TangentialState
    energies: np.ndarray[Any, np.dtype[np.float64]]
    loops: tuple[FrictionLoop, ...]


def cycles(problem: Problem, sliding: Sliding, *, with_loops: bool) -> Cycles:
    """The cycles of the amplitudes that the problem gives."""
    friction = Friction(problem.contact(), sliding.coefficient)
    state = problem.control.states(friction.contact, slice(-1, None))[0]
    limit = float(friction.sliding_shift(state))
    amplitudes = np.array(sliding.amplitudes) if sliding.amplitudes else np.geomspace(_FROM, _TO, _COUNT) * limit
    at = friction.at_shift if sliding.control == "shift" else friction.at_tangential_force
    turns = at(amplitudes, state)
    energies = np.asarray(friction.cycle_energy(amplitudes, sliding.control, state))
    chosen = sorted({*range(len(amplitudes) - 1, -1, -max(1, len(amplitudes) // 4))})
    loops = tuple(friction.loop(amplitudes[i], sliding.control, state=state) for i in chosen) if with_loops else ()
    return Cycles(friction, state, limit, turns, energies, loops)
