# SPDX-License-Identifier: GPL-3.0-or-later
"""The medium an indenter meets at one place of a structure."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._boundary import native, number, whole
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..medium import Medium
from .structure import Structure


@dataclass(frozen=True)
class LateralMedium(Medium):
    """E_eff(a, x, y) at fixed (x, y), equation (33), for Contact: F(d), a(d), pressure and adhesion as on any other medium.

    structure : Shapes, Voxels or Field
    x, y : place of the contact [length]
    smallest_radius, largest_radius : contact radii between which E_eff is sampled, evenly in ln a, and interpolated; below the
        smaller one it is taken as constant [length]
    points : number of samples, 3 to 1000000
    """

    _is_table = True

    structure: Structure
    x: float
    y: float
    smallest_radius: float
    largest_radius: float
    points: int = 33

    def __post_init__(self) -> None:
        structure, points = self.structure, self.points
        if not isinstance(structure, Structure):
            raise ArgumentTypeError(f"structure = {structure!r} is not allowed: it must be Shapes, Voxels or Field")
        place = number("x", self.x), number("y", self.y)
        first, last = number("smallest_radius", self.smallest_radius), number("largest_radius", self.largest_radius)
        if not 0.0 < first < last < np.inf:
            raise InvalidArgumentError(
                f"smallest_radius = {first!r}, largest_radius = {last!r} are not allowed: 0 < smallest < largest is needed"
            )
        a = np.geomspace(first, last, whole("points", points, 3, 1_000_000))
        created = native.medium_table(a, np.asarray(structure.modulus(*place, a)))
        self._own(created, x=place[0], y=place[1], smallest_radius=first, largest_radius=last)
