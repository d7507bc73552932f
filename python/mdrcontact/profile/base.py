# SPDX-License-Identifier: GPL-3.0-or-later
"""What every indenter profile can do."""

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
    """A rigid axisymmetric indenter: its profile f(r), f(0) = 0, and its one-dimensional profile g(x), equation (3).

    Lengths are in the unit of length of the whole problem. Profiles add: `Cone(...) + Paraboloid(...)`. They never change and may
    be shared between threads.
    """

    def _own(self, created: tuple[int, int], **values: Any) -> None:
        """Takes over what a compiled constructor returned, and the fields as they were understood."""
        self._set(_handle=Handle(created), **values)

    def height(self, r: ArrayLike) -> FloatOrArray:
        """f(r) [length] at radii r >= 0 [length], any shape."""
        return evaluate("r", r, lambda radii: native.profile_values(self._handle, _layout.HEIGHT, radii))

    def slope(self, r: ArrayLike) -> FloatOrArray:
        """f'(r) [1] at radii r >= 0 [length], any shape."""
        return evaluate("r", r, lambda radii: native.profile_values(self._handle, _layout.HEIGHT_SLOPE, radii))

    def mdr(self, x: ArrayLike) -> FloatOrArray:
        """g(x) [length], equation (3), at positions x >= 0 [length], any shape."""
        return evaluate("x", x, lambda points: native.profile_values(self._handle, _layout.G, points))

    def mdr_slope(self, x: ArrayLike) -> FloatOrArray:
        """g'(x) [1] at positions x >= 0 [length], any shape."""
        return evaluate("x", x, lambda points: native.profile_values(self._handle, _layout.G_SLOPE, points))

    def __add__(self, other: object) -> SumProfile:
        if not isinstance(other, Profile):
            return NotImplemented
        return SumProfile(_terms(self) + _terms(other))


@dataclass(frozen=True)
class SumProfile(Profile):
    """The sum of profiles, f(r) = f_1(r) + f_2(r) + ...; made by `+`."""

    terms: tuple[Profile, ...]

    def __post_init__(self) -> None:
        terms = tuple(self.terms)
        if not terms:
            raise InvalidArgumentError("terms is not allowed: it is empty")
        for term in terms:
            if not isinstance(term, Profile):
                raise ArgumentTypeError(f"terms is not allowed: {term!r} is not an indenter profile")
        self._own(native.profile_sum([term._handle for term in terms]), terms=terms)


def _terms(profile: Profile) -> tuple[Profile, ...]:
    return profile.terms if isinstance(profile, SumProfile) else (profile,)
