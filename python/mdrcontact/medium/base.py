# SPDX-License-Identifier: GPL-3.0-or-later
"""Base class of media."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache, partial
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _layout
from .._boundary import (
    ComplexOrArray,
    FloatOrArray,
    Handle,
    call,
    complex_of,
    evaluate,
    native,
    number,
    numbers,
    of_waves,
    together,
    words_of,
)
from .._choices import nearest
from .._parameters import WithParameters
from ..errors import InvalidArgumentError
from ..poroelastic import compliance as gel_compliance
from ..poroelastic import is_poroelastic
from .viscoelastic import is_viscoelastic

Self = TypeVar("Self", bound="Medium")

_LOADS_OF_MATRIX = ("normal", "coupling", "shear", "twist")
_LOADS = words_of(_layout.LOAD_NORMAL, _layout.LOAD_SHEAR, _layout.LOAD_TWIST, _layout.LOAD_COUPLING)


class ComplianceLimits(NamedTuple):
    """Limits of the compliance C(k) of a surface under a pressure.

    Near k = 0, `C = 2 long/k + rest`.
    """

    short: float | complex
    """k C/2 of short waves, 1/E0* of the surface; 0 under a surface with tension or a plate [1/modulus]."""
    long: float | complex
    """k C/2 of long waves, 1/E* of the base; 0 on a rigid base [1/modulus]."""
    rest: float | complex
    """C - 2 long/k at k = 0: what the layers add, C itself on a rigid base [length/modulus]."""


@lru_cache(maxsize=64)
def _response(body: Handle, tolerance: float) -> Handle:
    """Response in space of a body, which many points share."""
    return Handle(native.response_new(body, tolerance))


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

    def _signs(self) -> list[float]:
        """Signs of a traction on each of these bodies."""
        return [1.0]

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
        self, k: ArrayLike, load: str = "normal", omega: ArrayLike = 0.0, drainage: str | None = None
    ) -> FloatOrArray | ComplexOrArray:
        """Return the surface compliance C(k) at wavenumbers k.

        C(k) is the displacement of the surface per traction of a wave. Codes that solve contacts by Fourier transforms use it to
        include layers. The compliance of a pair is the sum over both bodies.

        Parameters
        ----------
        k : array_like
            Wavenumbers > 0, any shape; 0 also on a rigid base, where C is finite [1/length].
        load : {"normal", "shear", "twist", "coupling", "flux"}, optional
            "normal": a pressure, 2/(E* k) on a homogeneous body. "shear": a traction of one direction along the surface, averaged
            over the directions of the wave, (2 - nu)/(2 G k). "twist": a traction across the wave, 1/(G k). "coupling": normal
            displacement by a traction along the wave, (1 - 2 nu)/(2 G k). "flux": a current or heat flux, potential over flux, of
            materials with a conductor.
        omega : array_like, optional
            Angular frequencies of a viscoelastic or poroelastic medium, of either sign, 0 for the relaxed one [1/time]. Their shape
            broadcasts with that of `k`.
        drainage : {"surface", "sealed"}, optional
            Of a poroelastic medium, which has no default.

        Returns
        -------
        float, complex or ndarray
            C, in the shape of `k` and `omega` [length/modulus]; [length/conductance] for "flux". It is complex for relaxing media.

        Raises
        ------
        InvalidArgumentError
            The medium is given by its modulus alone or is rigid, the load is not available for it, or an argument is outside its
            range. Only "normal" is available for power-law graded bodies, gels, and surfaces with tension or a sheet.

        Notes
        -----
        C(k) belongs to the bodies and does not depend on the model by which the medium solves contacts. Under a traction along the
        wave it is twice that of "shear" minus that of "twist". Waves vary as exp(i k x), loads and displacements along x and into
        the body are positive, and time enters as exp(i omega t), so that C(-omega) is the complex conjugate of C(omega). A traction
        along the wave displaces the surface into the body by -i C, with the C of "coupling", and a pressure displaces it along the
        wave by i C. `compliance_matrix` contains these factors. The coupling of a pair is that of the lower body minus that of the
        upper one, because the tractions on them differ in sign.

        In arrays of 2000 and more wavenumbers, C of graded bodies and of more than four layers is interpolated in a table. Its
        relative error is 1e-11, checked between the nodes.
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
        signs = self._signs() if load == "coupling" else [1.0] * len(self._bodies())
        of_body = [of_waves(k, omega, partial(native.body_compliance, body, _LOADS[load])) for body in self._bodies()]
        real, imaginary = (
            sum(sign * part for sign, part in zip(signs, parts, strict=True)) for parts in zip(*of_body, strict=True)
        )
        return complex_of(real, imaginary) if self._relaxes() else real

    def compliance_matrix(self, k: ArrayLike, omega: ArrayLike = 0.0) -> NDArray[np.complex128]:
        """Return the compliance matrix of pressures and tractions along the wave.

        Parameters
        ----------
        k : array_like
            As of `compliance`.
        omega : array_like, optional
            As of `compliance` for a viscoelastic medium.

        Returns
        -------
        ndarray
            Displacements into the body and along the wave (second last axis) per pressure and per traction along the wave (last
            axis), in the shape of `k` and `omega` with two more axes of length 2 [length/modulus].

        Raises
        ------
        InvalidArgumentError
            As of `compliance` for "coupling".

        Notes
        -----
        With C of "coupling", the off-diagonal terms are -i C and i C, of waves exp(i k x). The matrix of an elastic medium is
        Hermitian. A traction across the wave only displaces the surface along itself, by C of "twist".

        Examples
        --------
        >>> print(np.round(mdr.Homogeneous(mdr.Elastic(2.6, 0.3)).compliance_matrix(1.0), 3))
        [[0.7+0.j  0. -0.2j]
         [0. +0.2j 0.7+0.j ]]
        """
        normal, coupling, shear, twist = (np.asarray(self.compliance(k, load, omega)) for load in _LOADS_OF_MATRIX)
        rows = [[normal, -1j * coupling], [1j * coupling, 2.0 * shear - twist]]
        return np.moveaxis(np.array(rows, np.complex128), (0, 1), (-2, -1))

    def compliance_limits(self, omega: float = 0.0) -> ComplianceLimits:
        """Return the limits of the compliance C(k) under a pressure.

        Parameters
        ----------
        omega : float, optional
            Angular frequency of a viscoelastic medium, of either sign, 0 for the relaxed one [1/time].

        Returns
        -------
        ComplianceLimits
            `short` and `long`, k C/2 of short and of long waves [1/modulus], and `rest`, C - 2 long/k at k = 0 [length/modulus].
            They are complex for relaxing media.

        Raises
        ------
        InvalidArgumentError
            The medium is given by its modulus alone, is graded by a power law, is rigid or poroelastic, or omega is not finite.

        Notes
        -----
        The limits of a pair are the sums over both bodies.

        Examples
        --------
        >>> film = mdr.Layered([(mdr.Elastic(2.0, 0.3), 1.0)], mdr.RIGID)
        >>> limits = film.compliance_limits()
        >>> print(round(limits.short, 6), limits.long, round(limits.rest, 6), round(film.compliance(0.0), 6))
        0.455 0.0 0.371429 0.371429
        """
        self._check_pores("compliance_limits")
        parts = [call(native.body_compliance_limits, body, number("omega", omega)) for body in self._bodies()]
        real, imaginary = np.sum(np.array(parts), axis=0)
        return ComplianceLimits(*(real + 1j * imaginary if self._relaxes() else real).tolist())

    def point_response(self, r: ArrayLike, tolerance: float = 1e-8) -> FloatOrArray:
        """Return the normal surface displacement under a unit point force.

        Parameters
        ----------
        r : array_like
            Distances from the force > 0, any shape [length].
        tolerance : float, optional
            Largest error of k C/2 over its largest value, > 0. The response is a sum of 60, 120 or 240 exponentials in the
            wavenumber, as the tolerance takes.

        Returns
        -------
        float or ndarray
            Displacement per force, in the shape of `r`; 1/(pi E* r) on a homogeneous body [1/(modulus length)].

        Raises
        ------
        InvalidArgumentError
            The medium is given by its modulus alone, is graded by a power law, is rigid or poroelastic, or a distance is not
            greater than 0.
        ConvergenceError
            The sum of exponentials misses the tolerance.

        Notes
        -----
        A viscoelastic medium has relaxed. The response of a pair is the sum over both bodies, the approach of their surfaces.

        Examples
        --------
        >>> film = mdr.Coated(mdr.Elastic(10.0, 0.3), 1.0, mdr.Elastic(1.0, 0.3))
        >>> print(np.round(film.point_response([0.1, 1.0, 10.0]), 6))
        [0.503216 0.2083   0.028892]
        """
        return sum(evaluate("r", r, partial(native.response_point, fit)) for fit in self._responses(tolerance))

    def rectangle_response(
        self, x: ArrayLike, y: ArrayLike, size: float | tuple[float, float], tolerance: float = 1e-8
    ) -> FloatOrArray:
        """Return the surface displacement under a unit pressure on a rectangle.

        It is normal to the surface, and the centre of the rectangle is the origin. Boundary-element codes on a domain without
        neighbours need the response of a pixel.

        Parameters
        ----------
        x, y : array_like
            Points, shapes that broadcast [length].
        size : float or tuple of float
            Width along x and height along y, or the side of a square, > 0 [length].
        tolerance : float, optional
            As of `point_response`.

        Returns
        -------
        float or ndarray
            Displacement per pressure, in the shape of x and y [length/modulus].

        Raises
        ------
        InvalidArgumentError
            As of `point_response`, or a side is not greater than 0.
        ConvergenceError
            The sum of exponentials misses the tolerance.

        Notes
        -----
        The displacement of each exponential is exact for every size of the rectangle.

        Examples
        --------
        >>> film = mdr.Coated(mdr.Elastic(10.0, 0.3), 1.0, mdr.Elastic(1.0, 0.3))
        >>> print(np.round(film.rectangle_response([0.0, 1.0], 0.0, 0.1), 6))
        [0.011999 0.002083]
        """
        points = together(x=x, y=y)
        sides = numbers("size", size)
        if sides.shape not in ((), (2,)):
            raise InvalidArgumentError(f"size = {size!r}: it must be a side, or a width and a height")
        width, height = np.broadcast_to(sides, 2).tolist()
        up = numbers("y", points[1]).ravel()

        def displacement(fit: Handle, along: Any) -> Any:
            return native.response_rectangle(fit, width, height, along, up if up.size else along)

        return sum(evaluate("x", points[0], partial(displacement, fit)) for fit in self._responses(tolerance))

    def response_error(self, tolerance: float = 1e-8) -> float:
        """Return the error of the fit behind `point_response` and `rectangle_response`.

        Parameters
        ----------
        tolerance : float, optional
            As of `point_response`.

        Returns
        -------
        float
            Largest error of k C/2 over its largest value, found between the wavenumbers of the fit and beyond them; of a pair the
            larger one of the two bodies. 0 for a half-space.

        Raises
        ------
        InvalidArgumentError
            As of `point_response`.
        ConvergenceError
            The sum of exponentials misses the tolerance.
        """
        return max(float(call(native.response_about, fit)[0]) for fit in self._responses(tolerance))

    def _responses(self, tolerance: float) -> list[Handle]:
        """Responses in space of its bodies, each made once."""
        self._check_pores("the response in space")
        return [_response(body, number("tolerance", tolerance)) for body in self._bodies()]

    def _check_pores(self, what: str) -> None:
        """Raise for a gel."""
        if is_poroelastic(self):
            raise InvalidArgumentError(f"{what} of a gel is not available. Use a body of its drained or undrained material")

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
