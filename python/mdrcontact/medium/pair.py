# SPDX-License-Identifier: GPL-3.0-or-later
"""Two deformable bodies as one medium (theory/exact.md (5.1))."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from .._boundary import Handle, native
from ..errors import ArgumentTypeError
from ..material import RIGID, Elastic, TransverselyIsotropic, _Rigid
from .base import Medium
from .homogeneous import Homogeneous


@dataclass(frozen=True)
class Pair(Medium):
    """Two deformable bodies pressed together: a medium like any other.

    lower, upper : each a medium of one body (homogeneous, coated, layered, graded), an Elastic(E, nu) for a homogeneous one, or
        RIGID; not both rigid

    The indenter of a contact with it is the gap before contact, the sum of both shapes (`SumProfile`, `Paraboloid.between`); its
    depth is the approach of distant points of the two bodies. Bodies that are homogeneous or solved exactly (the default) add
    exactly. Otherwise moduli add in series, 1/E_eff = 1/E_eff,1 + 1/E_eff,2, which is 0 to 1 % too stiff, far less than approximate
    models err. Power-law graded bodies combine with their like of the same exponent only.
    """

    lower: Medium | _Rigid
    upper: Medium | _Rigid

    def __init__(self, lower: Medium | Elastic | _Rigid, upper: Medium | Elastic | _Rigid) -> None:
        bodies = _body("lower", lower), _body("upper", upper)
        handles = [_rigid() if body is RIGID else body._handle for body in bodies]
        created = native.medium_pair(handles[0], handles[1])
        self._own(created, lower=bodies[0], upper=bodies[1])

    def _bodies(self) -> list[Handle]:
        return [handle for body in (self.lower, self.upper) if isinstance(body, Medium) for handle in body._bodies()]

    def _stack(self) -> tuple[Any, ...]:
        return self.lower._stack() if isinstance(self.lower, Medium) else ()

    def _relaxes(self) -> bool:
        return any(body._relaxes() for body in (self.lower, self.upper) if isinstance(body, Medium))

    def _with_materials(
        self, layer: Callable[[Any], Any], substrate: Callable[[Any], Any], interface: Callable[[Any], Any] | None = None
    ) -> Pair:
        bodies: list[Any] = [self.lower, self.upper]
        return Pair(*(body if body is RIGID else body._with_materials(layer, substrate, interface) for body in bodies))

    def _tolerance(self) -> float:
        return max(body._tolerance() for body in (self.lower, self.upper) if isinstance(body, Medium))

    @property
    def model(self) -> str:
        """The model of the bodies: "exact", or that of the approximate one."""
        models = [getattr(body, "model", "exact") for body in (self.lower, self.upper)]
        return next((model for model in models if model != "exact"), "exact")

    def with_model(self, model: str, **options: Any) -> Pair:
        """The same bodies, those that are coated, layered or graded under another model."""
        bodies: list[Any] = [self.lower, self.upper]
        return Pair(*(body.with_model(model, **options) if hasattr(body, "with_model") else body for body in bodies))


def _rigid() -> Handle:
    """The medium of a rigid body."""
    body = Handle(native.body_rigid())
    return Handle(native.medium_new(body, None))


def _body(name: str, body: Any) -> Any:
    if isinstance(body, (Elastic, TransverselyIsotropic)):
        return Homogeneous(body)
    if body is RIGID or isinstance(body, Medium):
        return body
    raise ArgumentTypeError(f"{name} = {body!r} is not allowed: it must be a medium, an Elastic(E, nu) or RIGID")
