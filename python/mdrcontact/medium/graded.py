# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies whose moduli change with depth (theory/paper.md (3.6), (3.15))."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .._boundary import Handle, native, number, row
from .._callback import Callback
from .._units import LENGTH, MODULUS, RATIO
from ..errors import InvalidArgumentError
from .base import Medium
from .models import UnderModel, settings

DepthFunction = Callable[[float], float]


@dataclass(frozen=True, repr=False)
class Graded(UnderModel):
    """Half-space whose moduli depend on the depth z below the surface.

    Parameters
    ----------
    z : array_like or float
        Depths of a table, ascending from z[0] = 0 [length]; or, with functions, the depth below which the moduli are constant, > 0
        [length].
    E : array_like or callable
        Young's moduli > 0 at the depths, linear in between and constant below; or a function E(z) on 0 < z <= depth [modulus].
    nu : array_like or callable
        Poisson's ratios, -1 < nu <= 0.5, one number for all depths, a table or a function nu(z) [1].
    model : {"exact", "gao", "gao-series", "gao-power"}, optional
        How E_eff(a) is computed; options as in `Coated`.
    **options
        Options of the model, as in `Coated`.

    Raises
    ------
    InvalidArgumentError
        The tables differ in length, do not ascend, or a number is outside its range.
    CallbackError
        A function returns NaN, infinity or no number. An exception that it raises is passed on unchanged.

    Notes
    -----
    Functions are called while the object is made and never later. Peaks narrower than 0.5 % of the depth may be missed.

    References
    ----------
    popov-2014, section 3

    Examples
    --------
    >>> hardened = mdr.Graded([0.0, 50e-6, 200e-6], [260e9, 240e9, 210e9], 0.3, "gao-series")
    >>> smooth = mdr.Graded(200e-6, lambda z: 210e9 + 50e9 * np.exp(-z / 60e-6), 0.3, "gao-series")
    >>> print(f"{hardened.modulus(50e-6):.4e} {smooth.modulus(50e-6):.4e}")
    2.5783e+11 2.5236e+11
    """

    z: tuple[float, ...] | float = field(metadata={"dimension": LENGTH})
    E: tuple[float, ...] | float | DepthFunction = field(metadata={"dimension": MODULUS})
    nu: tuple[float, ...] | float | DepthFunction = field(metadata={"dimension": RATIO})
    model: str
    options: tuple[tuple[str, float | str], ...]

    def __init__(
        self,
        z: ArrayLike,
        E: ArrayLike | DepthFunction,
        nu: ArrayLike | DepthFunction,
        model: str = "exact",
        **options: float | str,
    ) -> None:
        chosen = settings(model, options, graded=True)
        if callable(E) or callable(nu):
            body, arguments = _from_functions(z, E, nu)
        else:
            body, arguments = _from_tables(z, E, nu)
        self._own_with(body, chosen, **arguments, model=model)

    def _constants(self) -> dict[str, Any]:
        constants = super()._constants()
        return constants if isinstance(self.E, tuple) and isinstance(self.nu, tuple) else {}


def _from_functions(z: Any, E: Any, nu: Any) -> tuple[Handle, dict[str, Any]]:
    depth = number("z", z)
    E, nu = (value if callable(value) else number(name, value) for name, value in (("E", E), ("nu", nu)))
    calls = [Callback(name, value if callable(value) else _Constant(value)) for name, value in (("E", E), ("nu", nu))]
    created = native.body_graded_function(calls[0].entry, calls[1].entry, None, depth)
    for call in calls:
        call.reraise()
    return Handle(created), {"z": depth, "E": E, "nu": nu}


def _from_tables(z: Any, E: Any, nu: Any) -> tuple[Handle, dict[str, Any]]:
    depths, moduli = row("z", z), row("E", E)
    ratios = (number("nu", nu),) * len(depths) if np.ndim(nu) == 0 else row("nu", nu)
    if not len(depths) == len(moduli) == len(ratios):
        raise InvalidArgumentError(f"z, E and nu must have the same length; it is {len(depths)}, {len(moduli)} and {len(ratios)}")
    return Handle(native.body_graded(depths, moduli, ratios)), {"z": depths, "E": moduli, "nu": ratios}


class _Constant:
    def __init__(self, value: float) -> None:
        self._value = value

    def __call__(self, z: float) -> float:
        return self._value


@dataclass(frozen=True)
class PowerLawGraded(Medium):
    """Half-space with `E(z) = E0 (z/z0)^m` and constant nu, solved exactly.

    Parameters
    ----------
    E0 : float
        Young's modulus at the depth z0, > 0 [modulus].
    z0 : float
        Reference depth > 0 [length].
    exponent : float
        m, -1 < m < 1 [1]. The surface is soft for m > 0 and stiff for m < 0.
    nu : float
        Poisson's ratio, -1 < nu <= 0.5 [1].

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    Notes
    -----
    At the edge of a flat end, r = b, the pressure is infinite for m <= 0 and finite with a cusp for m > 0. Closer to the edge than
    1e-6 b it loses digits: for m = -0.4 the error is 5e-4 at 1e-9 b and 2 % at 1e-12 b; for m = 0.2 it is 2e-7 and 5e-6.

    References
    ----------
    hess-2016

    Examples
    --------
    >>> soil = mdr.PowerLawGraded(E0=50e6, z0=1.0, exponent=0.5, nu=0.3)
    >>> print(f"{mdr.Contact(mdr.Sphere(2.0), soil).at_depth(0.01).force:.4e}")
    3.4409e+04
    """

    E0: float = field(metadata={"dimension": MODULUS})
    z0: float = field(metadata={"dimension": LENGTH})
    exponent: float = field(metadata={"dimension": RATIO})
    nu: float = field(metadata={"dimension": RATIO})

    def __post_init__(self) -> None:
        body = Handle(native.body_power_graded(*self._numbers()))
        self._own(native.medium_new(body, None), body)
