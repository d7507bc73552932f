# SPDX-License-Identifier: GPL-3.0-or-later
"""Imprint of a plastic contact: the profile that its unloading is an elastic contact of."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike

from .. import _layout
from .._boundary import Handle, call, native, number, numbers, record
from .._value import Value
from .._warn import Caution, Warned, silence, texts_of, warn_all
from ..contact import Contact
from ..errors import ArgumentTypeError, InvalidArgumentError, PlasticityWarning
from ..medium.base import Medium
from ..profile.base import Profile

__all__ = ["Imprint", "ImprintProfile", "ReverseYield"]

_ELASTIC, _SMALL = 2.0, 2.5
"""R_Y up to which reversed flow on unloading does not show, and up to which it is small."""


class _ReverseYieldNumbers(NamedTuple):
    """The numbers of a `ReverseYield`."""

    ratio: float
    """R_Y, largest von Mises stress over yield stress of all layers [1]"""
    layer: int
    """the layer where it is, 0 the first from the surface"""


class ReverseYield(_ReverseYieldNumbers, Warned):
    """Ratio that tells whether unloading is elastic, from `Imprint.reverse_yield`.

    Examples
    --------
    >>> body = mdr.Homogeneous(mdr.Elastic(200e9, 0.3))
    >>> imprint = mdr.plastic.Imprint.from_two_terms(body, 1e-5, 1.7e9, 0.8e9)
    >>> ratio, layer = imprint.reverse_yield(1e9)
    >>> print(f"{ratio:.2f} {layer}")
    1.62 0
    """


class _HasImprint(Protocol):
    """A state that knows what it leaves."""

    def imprint(self) -> Imprint: ...


@dataclass(frozen=True)
class Imprint(Value):
    """Imprint of a plastic contact, from radius, force and depths.

    While nothing yields, unloading and reloading are those of an elastic contact of another profile on the same body. The pressure
    at the largest load is assumed to have two terms, `uniform + hertz sqrt(1 - r^2/A^2)`. Force and recovery determine them.

    Parameters
    ----------
    body : Medium
        Homogeneous or exact medium.
    radius : float
        A > 0, contact radius at the largest load [length].
    force : float
        F > 0 at the largest load [modulus length^2].
    residual_depth : float
        Depth at which unloading ends the contact, `0 <= residual_depth < depth` [length].
    depth : float
        Depth at the largest load, from initial contact [length].

    Raises
    ------
    ArgumentTypeError
        `body` is not a medium.
    InvalidArgumentError
        A number is outside its range, the medium has an effective modulus, or no pressure of two terms has these numbers.
    DomainError
        The contact would end in a ring.
    NoConvergenceError
        Force or work exceeds the range of double precision.

    Notes
    -----
    A uniform part below 0 by less than 0.5 % of F/A, as from a measured residual depth near yield, is taken as 0 with a
    `PlasticityWarning`.

    The error of the force on unloading, against finite elements, is 0.2 % to 1.3 % of the largest force for a paraboloid on
    half-spaces, up to 1.9 % on soft films, and 3.7 % where R_Y is 2.4 (theory/plastic.md (2.4)).

    References
    ----------
    bolshakov-1998
    mesarovic-2000

    Examples
    --------
    >>> body = mdr.Homogeneous(mdr.Elastic(200e9, 0.3))
    >>> imprint = mdr.plastic.Imprint(body, radius=1e-5, force=0.7, residual_depth=6e-7, depth=8e-7)
    >>> contact = imprint.contact()
    >>> state = contact.at_force([0.35, 0.7])
    >>> print(state.depth + imprint.residual_depth)
    [7.18326409e-07 8.00000000e-07]
    """

    body: Medium
    radius: float
    force: float
    residual_depth: float
    depth: float
    _form: tuple[str, dict[str, Any]] = field(init=False, repr=False, hash=False)
    """which class method made it, "" for none, and its arguments"""
    warnings: tuple[str, ...] = field(init=False, repr=False, compare=False, default=())
    """warnings about these numbers; empty if there are none"""
    _recovered_work: float = field(init=False, repr=False, compare=False)
    _uniform: float = field(init=False, repr=False, compare=False)
    _hertz: float = field(init=False, repr=False, compare=False)
    _misfit: float = field(init=False, repr=False, compare=False)

    def __init__(self, body: Medium, radius: float, force: float, residual_depth: float, depth: float) -> None:
        given = {
            "body": body,
            "radius": number("radius", radius),
            "force": number("force", force),
            "residual_depth": number("residual_depth", residual_depth),
            "depth": number("depth", depth),
        }
        self._make("", native.imprint_new, given)
        if self.misfit > 0.0:
            text = (
                f"residual_depth = {self.residual_depth:g}: force and depths need a uniform part of the pressure of "
                f"-{100 * self.misfit:.2g} % of F/A. It is taken as 0, Hertz's unloading"
            )
            found = [Caution(text, PlasticityWarning)]
            self._set(warnings=texts_of(found))
            warn_all(found)

    def _make(self, form: str, constructor: Callable[..., Any], given: dict[str, Any]) -> None:
        """Makes the imprint from its arguments, and reads its properties."""
        body, *values = given.values()
        if not isinstance(body, Medium):
            raise ArgumentTypeError(f"body = {body!r}: it must be a medium such as Homogeneous or Coated")
        self._set(_handle=Handle(constructor(body._handle, *values)), body=body, _form=(form, given))
        facts = record(_layout.imprint_facts)
        call(native.imprint_about, self._handle, facts)
        self._set(**{name: float(facts[0][name]) for name in ("radius", "force", "residual_depth", "depth")})
        self._set(**{f"_{name}": float(facts[0][name]) for name in ("recovered_work", "uniform", "hertz", "misfit")})

    @classmethod
    def _made(cls, form: str, constructor: Callable[..., Any], given: dict[str, Any]) -> Imprint:
        made = cls.__new__(cls)
        made._make(form, constructor, given)
        return made

    def _given(self) -> dict[str, Any]:
        return dict(self._form[1])

    def _maker(self) -> Callable[..., Imprint]:
        form = self._form[0]
        maker: Callable[..., Imprint] = getattr(type(self), form) if form else type(self)
        return maker

    def __repr__(self) -> str:
        form = self._form[0]
        arguments = ", ".join(f"{name}={value!r}" for name, value in self._given().items())
        return f"{type(self).__name__}{'.' if form else ''}{form}({arguments})"

    def __reduce__(self) -> tuple[Any, ...]:
        return partial(_remade, self._maker(), **self._given()), ()

    def replace(self, **changes: Any) -> Imprint:
        """Return a new imprint with some arguments changed.

        Parameters
        ----------
        **changes
            Arguments by name, as in `imprint.replace(force=0.5)`.

        Returns
        -------
        Imprint
            The new imprint.
        """
        return self._maker()(**{**self._given(), **changes})

    @classmethod
    def from_two_terms(cls, body: Medium, radius: float, uniform: float, hertz: float, depth: float = 0.0) -> Imprint:
        """Create the imprint of the pressure `uniform + hertz sqrt(1 - r^2/A^2)`.

        Parameters
        ----------
        body : Medium
            Homogeneous or exact medium.
        radius : float
            A > 0, contact radius at the largest load [length].
        uniform : float
            Uniform part of the pressure, >= 0 [modulus].
        hertz : float
            Hertz's part of the pressure, > -(2/pi) uniform [modulus].
        depth : float, optional
            Depth at the largest load [length]. By default depths count from there.

        Returns
        -------
        Imprint
            The imprint of this pressure.

        Raises
        ------
        ArgumentTypeError
            `body` is not a medium.
        InvalidArgumentError
            A number is outside its range, or the medium has an effective modulus.
        DomainError
            The contact would end in a ring.
        NoConvergenceError
            Force or work exceeds the range of double precision.

        Examples
        --------
        >>> body = mdr.Homogeneous(mdr.Elastic(200e9, 0.3))
        >>> imprint = mdr.plastic.Imprint.from_two_terms(body, 1e-5, 1.7e9, 0.8e9)
        >>> print(f"{imprint.force:.4f} {imprint.recovery:.4e} {imprint.recovered_work:.4e}")
        0.7016 2.1188e-07 6.1800e-08
        """
        given = {
            "body": body,
            "radius": number("radius", radius),
            "uniform": number("uniform", uniform),
            "hertz": number("hertz", hertz),
            "depth": number("depth", depth),
        }
        return cls._made("from_two_terms", native.imprint_two_terms, given)

    @classmethod
    def from_pressure(cls, body: Medium, r: ArrayLike, p: ArrayLike, depth: float = 0.0) -> Imprint:
        """Create the imprint of a pressure known at points.

        It may be that of finite elements. It is represented by a polynomial of degree 1 to 8 in `sqrt(1 - r^2/A^2)`, by least
        squares. `misfit` is its largest difference at the points.

        Parameters
        ----------
        body : Medium
            Homogeneous or exact medium.
        r : array_like
            Ascending radii >= 0, at least 4; the last one is A, the contact radius [length].
        p : array_like
            Pressure >= 0 at the largest load, in the shape of `r` [modulus].
        depth : float, optional
            Depth at the largest load [length]. By default depths count from there.

        Returns
        -------
        Imprint
            The imprint of this pressure.

        Raises
        ------
        ArgumentTypeError
            `body` is not a medium.
        InvalidArgumentError
            The points do not ascend, a pressure is negative, the polynomial misses the pressure by more than 5 % of its maximum, or
            the medium has an effective modulus.
        DomainError
            The contact would end in a ring.
        NoConvergenceError
            Force or work exceeds the range of double precision.

        Notes
        -----
        With pressures of 32 elements, or with noise of 0.2 %, force and depth of the unloading are accurate to 0.2 %. Give the
        pressure at A by the elements inside: a 0 of the node there lowers the force by 0.5 %.

        Examples
        --------
        >>> body = mdr.Homogeneous(mdr.Elastic(200e9, 0.3))
        >>> r = np.linspace(0.0, 1e-5, 41)
        >>> imprint = mdr.plastic.Imprint.from_pressure(body, r, 1.7e9 + 0.8e9 * np.sqrt(1.0 - (r / 1e-5) ** 2))
        >>> print(f"{imprint.force:.4f} {imprint.recovery:.4e} {imprint.misfit < 1e-12}")
        0.7016 2.1188e-07 True
        """
        radii, pressures = numbers("r", r).ravel(), numbers("p", p).ravel()
        if radii.size != pressures.size:
            raise InvalidArgumentError(f"r has {radii.size} and p {pressures.size} entries: give one pressure for each radius")
        given = {"body": body, "r": tuple(radii.tolist()), "p": tuple(pressures.tolist()), "depth": number("depth", depth)}
        return cls._made("from_pressure", native.imprint_from_pressure, given)

    @staticmethod
    def from_state(state: _HasImprint) -> Imprint:
        """Create the imprint that a state of a plastic law or of a pressure cap leaves.

        Parameters
        ----------
        state : state of a plastic law or of a pressure cap
            The state at the largest load.

        Returns
        -------
        Imprint
            The imprint of this state.

        Raises
        ------
        ArgumentTypeError
            The state leaves no imprint.
        """
        if not callable(getattr(state, "imprint", None)):
            raise ArgumentTypeError(f"state = {state!r}: it must be a state of a plastic law or of a pressure cap")
        return state.imprint()

    @property
    def recovery(self) -> float:
        """Elastic recovery, `depth - residual_depth` [length]."""
        return self.depth - self.residual_depth

    @property
    def recovered_work(self) -> float:
        """Work that unloading from the largest load gives back [modulus length^3]."""
        return self._recovered_work

    @property
    def uniform(self) -> float:
        """Uniform part of a pressure of two terms, otherwise 0 [modulus]."""
        return self._uniform

    @property
    def hertz(self) -> float:
        """Hertz's part of a pressure of two terms, otherwise 0 [modulus]."""
        return self._hertz

    @property
    def misfit(self) -> float:
        """Deviation of the pressure from the given numbers, 0 if they determine it [1].

        It is the part of F/A that a uniform part of 0 misses, or the largest difference from a given pressure relative to its
        maximum.
        """
        return self._misfit

    @property
    def profile(self) -> ImprintProfile:
        """Indenter whose elastic contact is the unloading.

        Its depths count from the residual depth.
        """
        return ImprintProfile(self)

    def contact(self, work_of_adhesion: float = 0.0) -> Contact:
        """Return the elastic contact of the imprint.

        It is unloading, reloading and everything else while nothing yields.

        Parameters
        ----------
        work_of_adhesion : float, optional
            gamma >= 0 [modulus length]. The edge then rests at the radius of the largest load until adhesion detaches it.

        Returns
        -------
        Contact
            The contact up to the largest load. Its depths are those of the imprint less `residual_depth`.

        Raises
        ------
        InvalidArgumentError
            `work_of_adhesion` is negative.

        Examples
        --------
        >>> body = mdr.Homogeneous(mdr.Elastic(200e9, 0.3))
        >>> imprint = mdr.plastic.Imprint.from_two_terms(body, 1e-6, 6e9, 0.0)
        >>> print(f"{imprint.contact(work_of_adhesion=1.0).pull_off().force:.4e}")
        -1.6869e-04
        """
        return Contact(self.profile, self.body, work_of_adhesion=work_of_adhesion)

    def reverse_yield(self, yield_stresses: ArrayLike) -> ReverseYield:
        """Return R_Y, which tells whether unloading is elastic.

        R_Y is the largest ratio over the layers of two stresses: the von Mises stress of the elastic body under the pressure at
        the largest load, and the yield stress. Below 1.7 unloading is elastic.

        Parameters
        ----------
        yield_stresses : float or array_like
            Yield stress > 0 of each layer top to bottom and of the half-space; infinite for one that does not yield [modulus].

        Returns
        -------
        ReverseYield
            R_Y and its layer.

        Raises
        ------
        InvalidArgumentError
            A yield stress is not greater than 0, or their number is not that of the layers.
        DomainError
            R_Y exceeds 3: unloading yields again and the imprint does not hold.

        Notes
        -----
        Above 2 a `PlasticityWarning` states the error of the force on unloading, 0.02 % to 2.5 % of the largest one.
        """
        values = np.atleast_1d(numbers("yield_stresses", yield_stresses))
        if not values.size:
            raise InvalidArgumentError("yield_stresses: it is empty. Give one for each layer and for the half-space")
        ratio, layer = call(native.imprint_reverse_yield, self._handle, values)
        found = []
        if ratio > _ELASTIC:
            size = "0.02 % to 0.5 %" if ratio <= _SMALL else "0.5 % to 2.5 %"
            text = (
                f"R_Y = {ratio:.3g} in layer {layer}: unloading yields again. Finite elements show an error of {size} of the "
                "largest force"
            )
            found.append(Caution(text, PlasticityWarning))
        warn_all(found)
        return ReverseYield(ratio, layer)._carrying(found)


@silence()
def _remade(maker: Callable[..., Imprint], **given: Any) -> Imprint:
    """A copy: the user has read its warning."""
    return maker(**given)


@dataclass(frozen=True)
class ImprintProfile(Profile):
    """Indenter whose elastic contact is the unloading of an imprint.

    `Imprint.profile` returns it. It ends at the contact radius of the largest load, where its slope is infinite unless the
    pressure is 0 there.

    Parameters
    ----------
    imprint : Imprint
        The imprint.

    Raises
    ------
    ArgumentTypeError
        `imprint` is not an `Imprint`.

    Examples
    --------
    >>> imprint = mdr.plastic.Imprint.from_two_terms(mdr.Homogeneous(mdr.Elastic(200e9, 0.3)), 1e-5, 1.7e9, 0.8e9)
    >>> print(f"{imprint.profile.mdr(1e-5):.4e} {imprint.recovery:.4e}")
    2.1188e-07 2.1188e-07
    """

    _is_table = True

    imprint: Imprint

    def __init__(self, imprint: Imprint) -> None:
        if not isinstance(imprint, Imprint):
            raise ArgumentTypeError(f"imprint = {imprint!r}: it must be an Imprint")
        self._own(native.imprint_profile(imprint._handle), imprint=imprint)
