# SPDX-License-Identifier: GPL-3.0-or-later
"""Medium below an indenter at one position of a structure."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._boundary import native, number, whole
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..medium import Medium
from .structure import Structure


@dataclass(frozen=True)
class LateralMedium(Medium):
    """Medium with E_eff(a, x, y) of a structure at one position, equation (33).

    Parameters
    ----------
    structure : Shapes, Voxels or Field
        The structure.
    x : float
        Position of the contact [length].
    y : float
        Position of the contact [length].
    smallest_radius : float
        Smallest contact radius > 0 [length]. Below it E_eff is constant.
    largest_radius : float
        Largest contact radius > `smallest_radius` [length].
    points : int, optional
        Number of radii, evenly spaced in ln a, at which E_eff is sampled, 3 to 1000000.

    Raises
    ------
    ArgumentTypeError
        `structure` is not a structure.
    InvalidArgumentError
        A number is outside its range.

    References
    ----------
    popov-2014, equation (33)

    Examples
    --------
    >>> ball = mdr.lateral.Ball((0.0, 0.0, 8e-6), 5e-6, mdr.Elastic(70e9, 0.22))
    >>> composite = mdr.lateral.Shapes(mdr.Elastic(3e9, 0.35), [ball])
    >>> medium = mdr.lateral.LateralMedium(composite, 0.0, 0.0, 1e-8, 1e-4)
    >>> print(f"{mdr.Contact(mdr.Sphere(100e-6), medium).at_depth(100e-9).force:.4e}")
    6.3053e-03
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
            raise ArgumentTypeError(f"structure = {structure!r}: it must be Shapes, Voxels or Field")
        place = number("x", self.x), number("y", self.y)
        first, last = number("smallest_radius", self.smallest_radius), number("largest_radius", self.largest_radius)
        if not 0.0 < first < last < np.inf:
            raise InvalidArgumentError(f"smallest_radius = {first!r}, largest_radius = {last!r}: 0 < smallest < largest is needed")
        a = np.geomspace(first, last, whole("points", points, 3, 1_000_000))
        created = native.medium_table(a, np.asarray(structure.modulus(*place, a)))
        self._own(created, x=place[0], y=place[1], smallest_radius=first, largest_radius=last)
