# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact whose pressure is at most a hardness."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from .. import _layout
from .._boundary import FloatOrArray, Handle, evaluate, evaluate_all, native, number
from .._value import Value
from ..contact import Contact
from ..errors import ArgumentTypeError, InvalidArgumentError
from .imprint import Imprint

__all__ = ["CapState", "PressureCap", "truncated_hertz"]


@dataclass(frozen=True)
class CapState:
    """State under a pressure cap.

    Each number has the shape of the input.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(20e-6), mdr.Homogeneous(mdr.Elastic(70e9, 0.3)))
    >>> state = mdr.plastic.PressureCap(contact, 1.4e9).at_force(20e-3)
    >>> print(f"{state.radius:.4e} {state.residual_depth / state.depth:.3f} {state.pressure(0.0):.2e}")
    2.1329e-06 0.524 1.40e+09
    """

    _cap: PressureCap = field(repr=False, compare=False)
    depth: FloatOrArray
    """d [length]"""
    radius: FloatOrArray
    """a [length]"""
    force: FloatOrArray
    """F [modulus length^2]"""
    capped_radius: FloatOrArray
    """outermost radius at which p = H, 0 if there is none [length]"""
    residual_depth: FloatOrArray
    """residual displacement on the axis, the depth at which unloading ends the contact [length]"""
    recovered_work: FloatOrArray
    """work that unloading gives back [modulus length^3]"""
    error: FloatOrArray
    """relative error of force and depth of the numerical solution, from two resolutions [1]"""

    def _field(self, r: ArrayLike, column: int) -> FloatOrArray:
        if np.ndim(self.radius):
            raise InvalidArgumentError("a pressure needs one state. Give one radius, depth or force")
        handle, radius = self._cap._handle, float(self.radius)
        return evaluate_all("r", r, lambda points: native.cap_pressure(handle, radius, points))[column]

    def pressure(self, r: ArrayLike) -> FloatOrArray:
        """Return the pressure of one state.

        Parameters
        ----------
        r : array_like
            Distances from the axis, >= 0, any shape [length].

        Returns
        -------
        float or ndarray
            p, at most the hardness, in the shape of `r` [modulus].

        Raises
        ------
        InvalidArgumentError
            A distance is negative, or there are several states.
        """
        return self._field(r, 0)

    def residual(self, r: ArrayLike) -> FloatOrArray:
        """Return the displacement of the surface that stays without load, of one state.

        Parameters
        ----------
        r : array_like
            Distances from the axis, >= 0, any shape [length].

        Returns
        -------
        float or ndarray
            u_p, 0 where the pressure is below the hardness, in the shape of `r` [length].

        Raises
        ------
        InvalidArgumentError
            A distance is negative, or there are several states.
        """
        return self._field(r, 1)

    def imprint(self) -> Imprint:
        """Return the imprint that one state leaves.

        Its pressure has two terms, with the force, the radius and both depths of the state.

        Returns
        -------
        Imprint
            The imprint on the body of the contact.

        Raises
        ------
        InvalidArgumentError
            There are several states, or the pressure does not reach the hardness.
        DomainError
            The contact would end in a ring.
        """
        if np.ndim(self.radius):
            raise InvalidArgumentError("an imprint needs one state. Give one radius, depth or force")
        if self.capped_radius == 0.0:
            raise InvalidArgumentError("the pressure of this state is below the hardness: it leaves no imprint. Increase the load")
        depths = float(self.residual_depth), float(self.depth)
        return Imprint(self._cap.contact.medium, float(self.radius), float(self.force), *depths)


@dataclass(frozen=True)
class PressureCap(Value):
    """Contact whose pressure is at most a hardness, 0 <= p <= H, on any body.

    Where the pressure reaches the hardness the surface stays behind the elastic displacement by a residual one. The contact has one
    state for each radius.

    Parameters
    ----------
    contact : Contact
        Elastic contact without adhesion, of an indenter without a vertical wall, with a homogeneous or an exact medium.
    hardness : float
        H > 0, best measured at the same depth [modulus].

    Raises
    ------
    ArgumentTypeError
        `contact` is not a contact.
    InvalidArgumentError
        The hardness is not greater than 0, or the contact has adhesion, a vertical wall or zeta.

    Notes
    -----
    Errors by comparison with finite elements of paraboloids on half-spaces: a hardness that was measured at the depth gives the
    force within 3 % up to a E/(R Y) = 32; a hardness of 2.75 Y gives it within 16 %. Surfaces that pile up are outside any cap.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(20e-6), mdr.Homogeneous(mdr.Elastic(70e9, 0.3)))
    >>> cap = mdr.plastic.PressureCap(contact, 1.4e9)
    >>> state = cap.at_radius(2e-6)
    >>> print(f"{state.force:.4e} {contact.at_radius(2e-6).force:.4e}")
    1.7575e-02 4.1026e-02
    """

    contact: Contact
    hardness: float

    def __post_init__(self) -> None:
        if not isinstance(self.contact, Contact):
            raise ArgumentTypeError(f"contact = {self.contact!r}: it must be a Contact")
        self._set(hardness=number("hardness", self.hardness))
        self._set(_handle=Handle(native.cap_new(self.contact._handle, self.hardness)))

    def at_radius(self, radius: ArrayLike) -> CapState:
        """Return states of given contact radii.

        Parameters
        ----------
        radius : array_like
            a > 0, any shape [length].

        Returns
        -------
        CapState
            States in the shape of `radius`.

        Raises
        ------
        InvalidArgumentError
            A radius is not greater than 0.
        DomainError
            A radius is beyond the end of the indenter, or the contact is not a single disc.
        """
        return self._states("radius", _layout.RADIUS, radius)

    def at_depth(self, depth: ArrayLike) -> CapState:
        """Return states of given depths.

        Parameters
        ----------
        depth : array_like
            d > 0, any shape [length].

        Returns
        -------
        CapState
            States in the shape of `depth`.

        Raises
        ------
        InvalidArgumentError
            A depth is not greater than 0.
        DomainError
            A depth is beyond the end of the indenter, or the contact is not a single disc.
        UnreachableError
            A depth is so small that the elastic contact does not reach it.
        """
        return self._states("depth", _layout.DEPTH, depth)

    def at_force(self, force: ArrayLike) -> CapState:
        """Return states of given forces.

        Parameters
        ----------
        force : array_like
            F > 0, any shape [modulus length^2].

        Returns
        -------
        CapState
            States in the shape of `force`.

        Raises
        ------
        InvalidArgumentError
            A force is not greater than 0.
        DomainError
            A force exceeds what the hardness supports up to the end of the indenter, or the contact is not a single disc.
        UnreachableError
            A force is so small that the elastic contact does not reach it.
        """
        return self._states("force", _layout.FORCE, force)

    def _states(self, name: str, given: int, values: ArrayLike) -> CapState:
        return CapState(self, *evaluate_all(name, values, lambda flat: native.cap_states(self._handle, given, flat)))


def truncated_hertz(x: ArrayLike, radius: float, largest: float, hardness: float) -> FloatOrArray:
    """Return the line load of Hertz's pressure cut at a hardness.

    The pressure min(p0 sqrt(1 - r^2/a^2), H) is the model of Thornton (1997).

    Parameters
    ----------
    x : array_like
        Places, 0 <= x <= `radius`, any shape [length].
    radius : float
        a > 0 [length].
    largest : float
        p0 > 0, largest pressure of Hertz [modulus].
    hardness : float
        H > 0 [modulus].

    Returns
    -------
    float or ndarray
        Line load, in the shape of `x` [modulus length].

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    References
    ----------
    thornton-1997

    Examples
    --------
    >>> print(f"{mdr.plastic.truncated_hertz(0.4, 1.0, 2.0 / np.pi, 0.5):.6f}")
    0.786624
    """
    given = number("radius", radius), number("largest", largest), number("hardness", hardness)
    return evaluate("x", x, lambda places: native.truncated_hertz(*given, places))
