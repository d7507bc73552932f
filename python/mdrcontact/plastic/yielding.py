# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials that yield, and yield stresses from hardnesses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from .._boundary import Handle, call, native, number, numbers
from .._value import Value
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..material import Elastic


@dataclass(frozen=True)
class Yielding(Value):
    """Isotropic material that yields by von Mises' criterion.

    Parameters
    ----------
    elastic : Elastic
        Its elasticity, with 0 <= nu <= 0.49.
    yield_stress : float, optional
        Y > 0 of perfect plasticity [modulus]. Give one of `yield_stress` and `hardening`.
    hardening : sequence of (float, float), optional
        Pairs of plastic strain >= 0 [1] and yield stress > 0 [modulus]. Strains rise; stresses do not fall, and rise less than
        proportionally to the strain. Y is linear between the points and constant below and above them.

    Raises
    ------
    ArgumentTypeError
        `elastic` is not an `Elastic`, or not exactly one of the others is given.
    InvalidArgumentError
        A number is outside its range.

    Notes
    -----
    A contact law takes Y at Tabor's strain 0.2 a/R. With linear hardening of 0.02 and 0.1 E that has errors of 0.1 and 1.9 % of the
    force and 1.5 and 4 % of the depth.

    References
    ----------
    tabor-1951

    Examples
    --------
    >>> steel = mdr.plastic.Yielding(mdr.Elastic(210e9, 0.3), yield_stress=1e9)
    >>> rising = mdr.plastic.Yielding(mdr.Elastic(210e9, 0.3), hardening=[(0.0, 0.4e9), (0.1, 0.6e9)])
    >>> for metal in steel, rising:
    ...     print(f"{mdr.plastic.PlasticLaw(mdr.Paraboloid(1e-3), metal, 2e-6).yield_depth:.2e}")
    1.21e-07
    1.95e-08
    """

    elastic: Elastic
    yield_stress: float | None = None
    hardening: tuple[tuple[float, float], ...] | None = None

    def __init__(
        self, elastic: Elastic, yield_stress: float | None = None, hardening: Sequence[tuple[float, float]] | None = None
    ) -> None:
        if not isinstance(elastic, Elastic):
            raise ArgumentTypeError(f"elastic = {elastic!r}: it must be an Elastic")
        if (yield_stress is None) == (hardening is None):
            raise ArgumentTypeError("yield_stress, hardening: give exactly one of the two")
        if hardening is None:
            assert yield_stress is not None
            points = np.array([[0.0, number("yield_stress", yield_stress)]])
            self._set(yield_stress=float(points[0, 1]), hardening=None)
        else:
            points = numbers("hardening", hardening)
            if not points.size:
                raise InvalidArgumentError("hardening: it is empty. Give at least one pair of strain and yield stress")
            if points.ndim != 2 or points.shape[1] != 2:
                raise ArgumentTypeError("hardening: it must be pairs of strain and yield stress")
            self._set(yield_stress=None, hardening=tuple((float(x), float(y)) for x, y in points))
        columns = np.ascontiguousarray(points.T)
        self._set(elastic=elastic, _handle=Handle(native.yielding_new(elastic.E, elastic.nu, columns[0], columns[1])))


class YieldStress(NamedTuple):
    """Yield stress from a hardness, from `yield_stress_from_hardness`.

    Fits take it in `yield_stresses`.

    Examples
    --------
    >>> found = mdr.plastic.yield_stress_from_hardness(mdr.Elastic(210e9, 0.3), 2.8e9)
    >>> print(f"{found.yield_stress:.2e} {found.error:.2f}")
    1.00e+09 0.08
    """

    yield_stress: float
    """Y [modulus]"""
    error: float
    """relative error of Y [1]"""


def yield_stress_from_hardness(elastic: Elastic, hardness: float, radius_ratio: float | None = None) -> YieldStress:
    """Estimate a yield stress from a hardness.

    The hardness is the mean pressure H = F/(pi a^2) of a spherical indentation.

    Parameters
    ----------
    elastic : Elastic
        Elasticity of the material, 0 <= nu <= 0.49.
    hardness : float
        H > 0 [modulus].
    radius_ratio : float, optional
        0 < a/R <= 0.3 of that indentation [1]: Y then follows from H = Y P(a E*/(R Y)). None: H = 2.8 Y, Tabor's rule.

    Returns
    -------
    YieldStress
        Y and its relative error. Without a/R that is 8 %, as P is 2.6 to 3.01 from a E*/(R Y) = 23 on. From a/R = 0.1 on it
        contains the fall of hardness by finite strains, 1.6, 6 and 13 % at 0.1, 0.2 and 0.3.

    Raises
    ------
    ArgumentTypeError
        `elastic` is not an `Elastic`.
    InvalidArgumentError
        A number is outside its range.
    DomainError
        Nothing yields under this hardness, a E*/(R Y) exceeds 250, or a/R exceeds 0.3.

    References
    ----------
    tabor-1951

    Examples
    --------
    >>> found = mdr.plastic.yield_stress_from_hardness(mdr.Elastic(210e9, 0.3), 2.4e9, radius_ratio=0.07)
    >>> print(f"{found.yield_stress:.3e} {found.error:.4f}")
    9.922e+08 0.0038
    """
    if not isinstance(elastic, Elastic):
        raise ArgumentTypeError(f"elastic = {elastic!r}: it must be an Elastic")
    ratio = 0.0 if radius_ratio is None else number("radius_ratio", radius_ratio)
    if radius_ratio is not None and ratio == 0.0:
        raise InvalidArgumentError("radius_ratio = 0.0: it must be greater than 0. Omit it if it is not known")
    call_result = call(native.yield_stress_from_hardness, elastic.E, elastic.nu, number("hardness", hardness), ratio)
    return YieldStress(*map(float, call_result))
