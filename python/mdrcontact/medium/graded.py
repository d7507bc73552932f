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
    """A body whose moduli depend on the depth z below the surface. Two ways to say how:

    z, E, nu tables : depths z[0] = 0, ascending [length], E(z) > 0 [modulus] and nu(z) there; linear in between, constant below.
        nu may be one number
    z a number, E and nu functions : E(z) and nu(z) on 0 < z <= that depth [length], constant below; nu may be a number. They are
        called while the object is made and never later; what they raise is raised to the caller. Peaks narrower than 0.5 % of
        the depth may be missed
    model : "exact" (default), "gao", "gao-series" or "gao-power"; options as for `Coated`
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
    """A half-space with E(z) = E0 (z/z0)^m and constant nu, solved exactly (Hess 2016).

    At the edge of a flat end, r = b, the pressure is infinite for m <= 0 and finite, with a cusp, for m > 0. Nearer to it than
    1e-6 b it loses digits: for m = -0.4 it is 5e-4 off at 1e-9 b and 2 % at 1e-12 b, for m = 0.2 2e-7 and 5e-6.

    E0 : modulus at the depth z0, > 0 [modulus]
    z0 : > 0 [length]
    exponent : m, -1 < m < 1
    nu : Poisson's ratio, -1 < nu <= 0.5
    """

    E0: float = field(metadata={"dimension": MODULUS})
    z0: float = field(metadata={"dimension": LENGTH})
    exponent: float = field(metadata={"dimension": RATIO})
    nu: float = field(metadata={"dimension": RATIO})

    def __post_init__(self) -> None:
        body = Handle(native.body_power_graded(*self._numbers()))
        self._own(native.medium_new(body, None), body)
