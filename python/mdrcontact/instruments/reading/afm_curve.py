# SPDX-License-Identifier: GPL-3.0-or-later
"""One force curve of an atomic force microscope, from any file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...errors import FileError
from ..records import Segment

Array = NDArray[np.float64]


class MissingSettings(FileError):
    """The file does not state the constants of the cantilever's deflection."""


class AfmCurve(NamedTuple):
    """One force curve, SI units."""

    height: Array
    """of the piezo, growing into the sample"""
    force: Array
    time: Array | None
    spring_constant: float | None
    place: tuple[float, float] | None
    """column and row in a map, or None"""
    segments: tuple[Segment, ...] | None
    """as the file has them; None where it does not separate them"""
    notes: tuple[str, ...]
    position: tuple[float, float] | None = None
    """x and y in a map [m]"""
    is_in_time: bool = False
    """whether it is a creep or relaxation test"""
    number: int = 1
    """number of the curve in the file, from 1"""


class Phase(NamedTuple):
    """One part of a curve in the order of measurement."""

    kind: str
    """"loading", "hold" or "unloading\""""
    height: Array
    deflection: Array
    """in the unit of its file"""


class Lever(NamedTuple):
    """Properties of the cantilever, from the file or the problem file."""

    spring_constant: float | None
    """[N/m]"""
    sensitivity: float | None
    """[m/V]"""

    def replaced(self, spring_constant: float | None, sensitivity: float | None) -> Lever:
        """Constants replaced by those of a problem file."""
        return Lever(spring_constant or self.spring_constant, sensitivity or self.sensitivity)

    def force_per(self, unit: str) -> float:
        """The force of one unit of deflection, "V" or "m"; `MissingSettings` where something is not known."""
        if self.spring_constant is None or unit == "V" and self.sensitivity is None:
            needs = "spring_constant and deflection_sensitivity" if unit == "V" else "spring_constant"
            raise MissingSettings(f"the file does not give them: give [instrument] {needs}")
        return self.spring_constant * (self.sensitivity if unit == "V" and self.sensitivity else 1.0)


def joined(phases: Sequence[Phase]) -> tuple[Array, Array, tuple[Segment, ...]]:
    """Height, deflection and segments of a whole curve."""
    segments, begin = [], 0
    for phase in phases:
        segments.append(Segment(phase.kind, begin, begin + len(phase.height)))
        begin += len(phase.height)
    height, deflection = (np.concatenate([phase[i] for phase in phases]) for i in (1, 2))
    return height, deflection, tuple(segments)
