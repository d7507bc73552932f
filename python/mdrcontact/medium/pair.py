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
    """Two deformable bodies pressed together.

    Parameters
    ----------
    lower : Medium, Elastic, TransverselyIsotropic or RIGID
        A medium of one body, or a material for a homogeneous one.
    upper : Medium, Elastic, TransverselyIsotropic or RIGID
        The other body. At most one of the two is rigid.

    Raises
    ------
    ArgumentTypeError
        A body is of another type.
    InvalidArgumentError
        Both bodies are rigid, or power-law graded bodies differ in their exponent.

    Notes
    -----
    The indenter of a contact with a pair is the gap before contact, the sum of both shapes (`SumProfile`, `Paraboloid.between`).
    The depth is the approach of distant points of the two bodies. Homogeneous bodies and bodies under the model "exact" add
    exactly. Otherwise the moduli add in series, `1/E_eff = 1/E_eff,1 + 1/E_eff,2`, which is 0 to 1 % too stiff.

    Examples
    --------
    >>> steel = mdr.Elastic(210e9, 0.3)
    >>> contact = mdr.Contact(mdr.Paraboloid(5e-3), mdr.Pair(steel, steel))
    >>> print(f"{contact.at_force(10.0).radius:.4e}")
    6.8753e-05
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

    def _signs(self) -> list[float]:
        return [sign for body, sign in ((self.lower, 1.0), (self.upper, -1.0)) if isinstance(body, Medium) for _ in body._bodies()]

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
        """Name of the model of the bodies: "exact", or that of the approximate body."""
        models = [getattr(body, "model", "exact") for body in (self.lower, self.upper)]
        return next((model for model in models if model != "exact"), "exact")

    def with_model(self, model: str, **options: Any) -> Pair:
        """Return the same pair with its coated, layered and graded bodies under a model.

        Parameters
        ----------
        model : str
            Name of the model, as in `Coated`.
        **options
            Options of the model.

        Returns
        -------
        Pair
            The same bodies.

        Raises
        ------
        InvalidArgumentError
            The model or an option is unknown, or the model does not support a body.
        """
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
    raise ArgumentTypeError(f"{name} = {body!r}: it must be a medium, an Elastic(E, nu) or RIGID")
