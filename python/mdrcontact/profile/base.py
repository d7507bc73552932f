# SPDX-License-Identifier: GPL-3.0-or-later
"""Base class of indenter profiles."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from numpy.typing import ArrayLike

from .. import _layout
from .._boundary import FloatOrArray, Handle, evaluate, native
from .._parameters import WithParameters
from ..errors import ArgumentTypeError, InvalidArgumentError

__all__ = [
    "Profile",
    "SumProfile",
]


@dataclass(frozen=True)
class Profile(WithParameters):
    """Base class of rigid axisymmetric indenters.

    A profile is the height f(r) of the indenter above its lowest point, with f(0) = 0. Its one-dimensional profile g(x) follows
    from equation (3) of Popov (2014). Profiles add: `Cone(...) + Paraboloid(...)`. They are immutable and may be shared between
    threads.

    References
    ----------
    popov-2014, equation (3)

    Examples
    --------
    >>> tip = mdr.Paraboloid(10e-6)
    >>> isinstance(tip, mdr.Profile)
    True
    >>> print(f"{tip.height(1e-6):.2e} {tip.mdr(1e-6):.2e}")
    5.00e-08 1.00e-07
    """

    def _own(self, created: tuple[int, int], **values: Any) -> None:
        """Takes over what a compiled constructor returned, and the fields as they were understood."""
        self._set(_handle=Handle(created), **values)

    def height(self, r: ArrayLike) -> FloatOrArray:
        """Return the profile f(r).

        Parameters
        ----------
        r : array_like
            Radii >= 0, any shape [length].

        Returns
        -------
        float or ndarray
            f(r), in the shape of `r` [length].

        Raises
        ------
        InvalidArgumentError
            A radius is negative or not a number.
        DomainError
            The indenter has no surface at a radius.
        """
        return evaluate("r", r, lambda radii: native.profile_values(self._handle, _layout.HEIGHT, radii))

    def slope(self, r: ArrayLike) -> FloatOrArray:
        """Return the slope f'(r) of the profile.

        Parameters
        ----------
        r : array_like
            Radii >= 0, any shape [length].

        Returns
        -------
        float or ndarray
            f'(r), in the shape of `r` [1].

        Raises
        ------
        InvalidArgumentError
            A radius is negative or not a number.
        DomainError
            The indenter has no surface at a radius.
        """
        return evaluate("r", r, lambda radii: native.profile_values(self._handle, _layout.HEIGHT_SLOPE, radii))

    def mdr(self, x: ArrayLike) -> FloatOrArray:
        """Return the one-dimensional profile g(x), equation (3).

        Parameters
        ----------
        x : array_like
            Positions >= 0, any shape [length].

        Returns
        -------
        float or ndarray
            g(x), in the shape of `x` [length].

        Raises
        ------
        InvalidArgumentError
            A position is negative or not a number.
        DomainError
            The indenter has no surface at a position.
        """
        return evaluate("x", x, lambda points: native.profile_values(self._handle, _layout.G, points))

    def mdr_slope(self, x: ArrayLike) -> FloatOrArray:
        """Return the slope g'(x) of the one-dimensional profile.

        Parameters
        ----------
        x : array_like
            Positions >= 0, any shape [length].

        Returns
        -------
        float or ndarray
            g'(x), in the shape of `x` [1].

        Raises
        ------
        InvalidArgumentError
            A position is negative or not a number.
        DomainError
            The indenter has no surface at a position.
        """
        return evaluate("x", x, lambda points: native.profile_values(self._handle, _layout.G_SLOPE, points))

    def __add__(self, other: object) -> SumProfile:
        if not isinstance(other, Profile):
            return NotImplemented
        return SumProfile(_terms(self) + _terms(other))


@dataclass(frozen=True)
class SumProfile(Profile):
    """Sum of several profiles, `f(r) = f_1(r) + f_2(r) + ...`, made by `+`.

    Parameters
    ----------
    terms : sequence of Profile
        The profiles, at least one.

    Raises
    ------
    InvalidArgumentError
        `terms` is empty.
    ArgumentTypeError
        A term is not a profile.

    Examples
    --------
    >>> tip = mdr.Cone(0.1) + mdr.Paraboloid(10e-6)
    >>> print(type(tip).__name__, f"{tip.height(1e-6):.4e}")
    SumProfile 1.5033e-07
    """

    terms: tuple[Profile, ...]

    def __post_init__(self) -> None:
        terms = tuple(self.terms)
        if not terms:
            raise InvalidArgumentError("terms: it is empty")
        for term in terms:
            if not isinstance(term, Profile):
                raise ArgumentTypeError(f"terms: {term!r} is not an indenter profile")
        self._own(native.profile_sum([term._handle for term in terms]), terms=terms)


def _terms(profile: Profile) -> tuple[Profile, ...]:
    return profile.terms if isinstance(profile, SumProfile) else (profile,)
