# SPDX-License-Identifier: GPL-3.0-or-later
"""What every medium can do."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import Any, TypeVar

from numpy.typing import ArrayLike

from .. import _layout
from .._boundary import ComplexOrArray, FloatOrArray, Handle, complex_values, evaluate, native, number, numbers, words_of
from .._choices import nearest
from .._parameters import WithParameters
from ..errors import InvalidArgumentError
from ..poroelastic import compliance as gel_compliance
from ..poroelastic import is_poroelastic
from .viscoelastic import is_viscoelastic

Self = TypeVar("Self", bound="Medium")

_LOADS = words_of(_layout.LOAD_NORMAL, _layout.LOAD_SHEAR, _layout.LOAD_TWIST)


@dataclass(frozen=True, repr=False)
class Medium(WithParameters):
    """An elastic half-space: for a contact radius a it gives the effective contact modulus E_eff(a), equation (10).

    Lengths and moduli are in the units of the whole problem. A medium never changes and may be shared between threads.
    """

    _body: Handle | None = field(init=False, repr=False, compare=False)
    """of a medium that is one body under a model"""

    def _own(self, created: tuple[int, int], body: Handle | None = None, **values: Any) -> None:
        """Takes over what a compiled constructor returned, and the fields as they were understood."""
        self._set(_handle=Handle(created), _body=body, **values)

    def _bodies(self) -> list[Handle]:
        """Those whose compliances add; an exception where they are not known."""
        if self._body is None:
            raise InvalidArgumentError("this medium is known by its modulus alone: give E and nu of its layers")
        return [self._body]

    def _given(self) -> dict[str, Any]:
        """Without a surface that adds nothing."""
        return {name: value for name, value in super()._given().items() if name != "surface" or value is not None}

    def _stack(self) -> tuple[Any, ...]:
        """Each layer from the surface down as a `Layer`, whole: what unpacks it as (material, thickness) leaves out prestress and
        interface. Of a pair those of the lower body; of a gel a pair (material, thickness)."""
        return ()

    def _with_materials(
        self: Self, layer: Callable[[Any], Any], substrate: Callable[[Any], Any], interface: Callable[[Any], Any] | None = None
    ) -> Self:
        """The same body of other materials, by what makes them of that of a layer and of that below all layers; interfaces too,
        where that is given. All else stays: thickness, prestress, surface, model and options."""
        return self

    def _relaxes(self) -> bool:
        """Whether a material of it is viscoelastic."""
        return is_viscoelastic(self)

    def _with_thinner_coating(self: Self, lost: float) -> Self:
        """The same body with a first layer that is thinner by so much [length]; all else stays."""
        raise InvalidArgumentError(f"medium = {self!r} is not allowed: it must be Coated or Layered, with a coating to lose")

    def _tolerance(self) -> float:
        """The tolerance that was given for its solution, 0 where none was."""
        return 0.0

    def modulus(self, a: ArrayLike) -> FloatOrArray:
        """E_eff(a) [modulus] at contact radii a > 0 [length], any shape."""
        return evaluate("a", a, lambda radii: native.medium_values(self._handle, _layout.MODULUS, radii))

    def stiffness(self, a: ArrayLike) -> FloatOrArray:
        """k(a) = dF/dd = 2 a E_eff(a) [modulus length] at contact radii a > 0 [length], any shape."""
        return evaluate("a", a, lambda radii: native.medium_values(self._handle, _layout.STIFFNESS, radii))

    def tangential_modulus(self, a: ArrayLike) -> FloatOrArray:
        """G_t(a) = k_t(a)/(2 a) [modulus] at contact radii a > 0 [length], any shape: what takes E_eff's place where a contact that
        sticks all over is displaced along the surface. 4 G/(2 - nu) of a homogeneous body.

        Known for homogeneous media with E and nu, the model "exact" (but for the displacement that varies as cos 2 phi around the
        axis: low by at most 0.35 %), Gao's weights with those of a tangential load, and pairs of these. The kernel of a layered
        body is tabulated in each call: give all radii at once.
        """
        return evaluate("a", a, lambda radii: native.medium_values(self._handle, _layout.TANGENTIAL_MODULUS, radii))

    def compliance(
        self, k: ArrayLike, load: str = "normal", omega: float = 0.0, drainage: str | None = None
    ) -> FloatOrArray | ComplexOrArray:
        """C(k) [length/modulus], what the surface answers to a wave of load: displacement over traction at wavenumbers k > 0
        [1/length], any shape; of a pair the sum over both bodies. It makes codes that solve contacts by Fourier transforms layered.

        load : "normal": a pressure, 2/(E* k) of a homogeneous body; "shear": a traction of one direction along the surface, mean
            over the directions of the wave, (2 - nu)/(2 G k); "twist": a traction across the wave, 1/(G k). Under a traction along
            the wave it is twice that of "shear" less that of "twist"; "flux": of a current or heat, potential over flux, of
            materials with a conductor (`Conduction.compliance`) [length/conductance]
        omega : angular frequency at which a viscoelastic or poroelastic medium is taken, 0 for its relaxed one [1/time]; its C is
            complex
        drainage : of a poroelastic medium, under a normal load: "surface" or "sealed"

        The model by which the medium solves its contacts does not matter. Refused for media given by their modulus alone, of a
        power of the depth, and rigid ones.
        """
        if load == "flux":
            from ..conduction.bodies import conduction_of, flux_compliance

            return flux_compliance(conduction_of(self), k, omega)
        if load not in _LOADS:
            words = nearest(str(load), [*_LOADS, "flux"])
            raise InvalidArgumentError(f"load = {load!r} is not allowed: {words}")
        if is_poroelastic(self):
            if load != "normal":
                raise InvalidArgumentError(f"load = {load!r} is not allowed: of a gel the answer to a normal load is known")
            return gel_compliance(self, k, omega, drainage)
        if drainage is not None:
            raise InvalidArgumentError(f"drainage = {drainage!r} is not allowed: this medium has no pores")
        both = sum(
            complex_values("k", k, partial(native.body_compliance, body, _LOADS[load], number("omega", omega)))
            for body in self._bodies()
        )
        return both if self._relaxes() else both.real

    def torsional_stiffness(self, a: ArrayLike) -> FloatOrArray:
        """M/phi [modulus length^3] at contact radii a > 0 [length], any shape, of a contact that sticks all over and is twisted
        about its axis: 16 G a^3/3 of a homogeneous body. Known, exactly, for homogeneous media with E and nu, the model "exact" and
        pairs of these."""
        return evaluate("a", a, lambda radii: native.medium_values(self._handle, _layout.TORSIONAL_STIFFNESS, radii))

    def tangential_stiffness(self, a: ArrayLike) -> FloatOrArray:
        """k_t(a) = dT/ds = 2 a G_t(a) [modulus length] at contact radii a > 0 [length], any shape; see `tangential_modulus`."""
        return 2.0 * numbers("a", a) * self.tangential_modulus(a)
