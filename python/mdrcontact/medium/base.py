# SPDX-License-Identifier: GPL-3.0-or-later
"""Base class of media."""

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
    """Base class of media: one or two bodies that an indenter presses on.

    A medium gives the effective contact modulus E_eff(a) at a contact radius a, equation (10) of Popov (2014). It is a half-space,
    a stack of layers on a half-space or on a rigid base, a pair of such bodies, or a relaxing body. Media are immutable and may be
    shared between threads.

    References
    ----------
    popov-2014, equation (10)

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(445e9, 0.25), 2e-6, mdr.Elastic(210e9, 0.30))
    >>> isinstance(film, mdr.Medium)
    True
    >>> print(f"{film.modulus(2e-6):.4e} {film.stiffness(2e-6):.4e}")
    3.0273e+11 1.2109e+06
    """

    _body: Handle | None = field(init=False, repr=False, compare=False)
    """of a medium that is one body under a model"""

    def _own(self, created: tuple[int, int], body: Handle | None = None, **values: Any) -> None:
        """Takes over what a compiled constructor returned, and the fields as they were understood."""
        self._set(_handle=Handle(created), _body=body, **values)

    def _bodies(self) -> list[Handle]:
        """Bodies whose compliances add; raises if they are not available."""
        if self._body is None:
            raise InvalidArgumentError("this medium has only an effective modulus. Use one with E and nu of its layers")
        return [self._body]

    def _given(self) -> dict[str, Any]:
        """Without a surface that adds nothing."""
        return {name: value for name, value in super()._given().items() if name != "surface" or value is not None}

    def _stack(self) -> tuple[Any, ...]:
        """Each layer from top to bottom as a complete `Layer`: what unpacks it as (material, thickness) leaves out prestress and
        interface. Of a pair those of the lower body; of a gel a pair (material, thickness)."""
        return ()

    def _with_materials(
        self: Self, layer: Callable[[Any], Any], substrate: Callable[[Any], Any], interface: Callable[[Any], Any] | None = None
    ) -> Self:
        """Return the same body of other materials, by functions of the material of a layer and of the substrate; interfaces also,
        where that is given. The rest does not change: thickness, prestress, surface, model and options."""
        return self

    def _relaxes(self) -> bool:
        """Return whether one of its materials is viscoelastic."""
        return is_viscoelastic(self)

    def _with_thinner_coating(self: Self, lost: float) -> Self:
        """Return the same body with a first layer that is thinner by `lost` [length]."""
        raise InvalidArgumentError(f"medium = {self!r}: it must be Coated or Layered, with a coating to lose")

    def _tolerance(self) -> float:
        """Return the given tolerance of its solution, 0 if there is none."""
        return 0.0

    def modulus(self, a: ArrayLike) -> FloatOrArray:
        """Return the effective contact modulus E_eff(a).

        Parameters
        ----------
        a : array_like
            Contact radii > 0, any shape [length].

        Returns
        -------
        float or ndarray
            E_eff, in the shape of `a` [modulus].

        Raises
        ------
        InvalidArgumentError
            A radius is not finite and greater than 0.
        DomainError
            The model or table does not hold at a radius.
        """
        return evaluate("a", a, lambda radii: native.medium_values(self._handle, _layout.MODULUS, radii))

    def stiffness(self, a: ArrayLike) -> FloatOrArray:
        """Return the contact stiffness `k(a) = 2 a E_eff(a)`, dF/dd at constant radius.

        Parameters
        ----------
        a : array_like
            Contact radii > 0, any shape [length].

        Returns
        -------
        float or ndarray
            k, in the shape of `a` [modulus length].

        Raises
        ------
        InvalidArgumentError
            A radius is not finite and greater than 0.
        DomainError
            The model or table does not hold at a radius.
        """
        return evaluate("a", a, lambda radii: native.medium_values(self._handle, _layout.STIFFNESS, radii))

    def tangential_modulus(self, a: ArrayLike) -> FloatOrArray:
        """Return the tangential contact modulus `G_t(a) = k_t(a)/(2 a)`.

        It replaces E_eff if a contact without slip is displaced along the surface. On a homogeneous body it is 4 G/(2 - nu).

        Parameters
        ----------
        a : array_like
            Contact radii > 0, any shape [length]. Give all radii in one call: each call tabulates the kernel of a layered body.

        Returns
        -------
        float or ndarray
            G_t, in the shape of `a` [modulus].

        Raises
        ------
        InvalidArgumentError
            The tangential stiffness of the medium is not known, or a radius is not finite and greater than 0.

        Notes
        -----
        It is known for homogeneous media with E and nu, for the model "exact", for Gao's models ("gao", "gao-series", "gao-power")
        with their weights for a tangential load, and for pairs of these. The exact solution neglects the displacement that varies
        as cos 2 phi around the axis; its result is low by at most 0.35 %.
        """
        return evaluate("a", a, lambda radii: native.medium_values(self._handle, _layout.TANGENTIAL_MODULUS, radii))

    def compliance(
        self, k: ArrayLike, load: str = "normal", omega: float = 0.0, drainage: str | None = None
    ) -> FloatOrArray | ComplexOrArray:
        """Return the surface compliance C(k) at wavenumbers k.

        C(k) is the displacement of the surface per traction of a wave. Codes that solve contacts by Fourier transforms use it to
        include layers. The compliance of a pair is the sum over both bodies.

        Parameters
        ----------
        k : array_like
            Wavenumbers > 0, any shape [1/length].
        load : {"normal", "shear", "twist", "flux"}, optional
            "normal": a pressure, 2/(E* k) on a homogeneous body. "shear": a traction of one direction along the surface, averaged
            over the directions of the wave, (2 - nu)/(2 G k). "twist": a traction across the wave, 1/(G k). "flux": a current or
            heat flux, potential over flux, of materials with a conductor.
        omega : float, optional
            Angular frequency of a viscoelastic or poroelastic medium, 0 for the relaxed one [1/time].
        drainage : {"surface", "sealed"}, optional
            Of a poroelastic medium, which has no default.

        Returns
        -------
        float, complex or ndarray
            C, in the shape of `k` [length/modulus]; [length/conductance] for "flux". It is complex for relaxing media.

        Raises
        ------
        InvalidArgumentError
            The medium is given by its modulus alone, is graded by a power law or is rigid, or an argument is outside its range.

        Notes
        -----
        C(k) belongs to the bodies and does not depend on the model by which the medium solves contacts. Under a traction along the
        wave it is twice that of "shear" minus that of "twist".
        """
        if load == "flux":
            from ..conduction.bodies import conduction_of, flux_compliance

            return flux_compliance(conduction_of(self), k, omega)
        if load not in _LOADS:
            words = nearest(str(load), [*_LOADS, "flux"])
            raise InvalidArgumentError(f"load = {load!r}: {words}")
        if is_poroelastic(self):
            if load != "normal":
                raise InvalidArgumentError(f"load = {load!r}: of a gel the answer to a normal load is known")
            return gel_compliance(self, k, omega, drainage)
        if drainage is not None:
            raise InvalidArgumentError(f"drainage = {drainage!r}: this medium has no pores")
        both = sum(
            complex_values("k", k, partial(native.body_compliance, body, _LOADS[load], number("omega", omega)))
            for body in self._bodies()
        )
        return both if self._relaxes() else both.real

    def torsional_stiffness(self, a: ArrayLike) -> FloatOrArray:
        """Return the torsional stiffness M/phi of a contact without slip.

        Parameters
        ----------
        a : array_like
            Contact radii > 0, any shape [length].

        Returns
        -------
        float or ndarray
            M/phi, in the shape of `a` [modulus length^3]; 16 G a^3/3 on a homogeneous body.

        Raises
        ------
        InvalidArgumentError
            The medium is not homogeneous with E and nu, not solved by the model "exact", and not a pair of these.
        """
        return evaluate("a", a, lambda radii: native.medium_values(self._handle, _layout.TORSIONAL_STIFFNESS, radii))

    def tangential_stiffness(self, a: ArrayLike) -> FloatOrArray:
        """Return the tangential stiffness `k_t(a) = 2 a G_t(a)` without slip.

        Parameters
        ----------
        a : array_like
            Contact radii > 0, any shape [length].

        Returns
        -------
        float or ndarray
            k_t, in the shape of `a` [modulus length].

        Raises
        ------
        InvalidArgumentError
            As of `tangential_modulus`.
        """
        return 2.0 * numbers("a", a) * self.tangential_modulus(a)
