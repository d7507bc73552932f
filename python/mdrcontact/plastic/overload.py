# SPDX-License-Identifier: GPL-3.0-or-later
"""First loading of coated bodies and of other profiles by the overload rule."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from .. import _layout
from .._boundary import FloatOrArray, Handle, evaluate_all, native, number, row
from .._value import Value
from .._warn import Caution, texts_of, warn_all
from ..contact import Contact
from ..errors import ArgumentTypeError, InvalidArgumentError, PlasticityWarning
from .imprint import Imprint

__all__ = ["LoadingPoints", "Overload", "OverloadState"]

_SMALL_SLOPE = 0.1
"""a/R of a sphere up to which geometry does not matter."""


class LoadingPoints(NamedTuple):
    """Points of a curve of first loading, from `Overload.points`.

    Examples
    --------
    >>> body = mdr.Homogeneous(mdr.Elastic(200e9, 0.3))
    >>> rule = mdr.plastic.Overload(mdr.Contact(mdr.Cone(0.035), body), [2e9])
    >>> points = rule.points([1e-8, 2e-8, 4e-8])
    >>> law = mdr.plastic.PlasticLaw.from_table(*points, modulus=200e9 / 0.91)
    >>> print(f"{law.loading(2e-8).force:.4e} {points.force[1]:.4e}")
    1.5156e-03 1.5156e-03
    """

    depth: FloatOrArray
    """d [length]"""
    force: FloatOrArray
    """F [modulus length^2]"""
    radius: FloatOrArray
    """a [length]"""
    residual_depth: FloatOrArray
    """depth that remains after unloading from the point [length]"""


@dataclass(frozen=True)
class OverloadState:
    """State of first loading by the overload rule.

    Each number has the shape of the input.

    Examples
    --------
    >>> film, base = mdr.Elastic(70e9, 0.3), mdr.Elastic(200e9, 0.3)
    >>> contact = mdr.Contact(mdr.Paraboloid(20e-6), mdr.Coated(film, 2e-6, base))
    >>> state = mdr.plastic.Overload(contact, [0.5e9, 5e9]).at_radius(1e-6)
    >>> print(f"{state.force:.4e} {state.depth:.4e} {state.force_error:.2f}")
    3.1924e-03 3.5743e-08 0.05
    """

    _rule: Overload = field(repr=False, compare=False)
    depth: FloatOrArray
    """d [length]"""
    radius: FloatOrArray
    """a [length]"""
    force: FloatOrArray
    """F [modulus length^2]"""
    load: FloatOrArray
    """Lambda = (3 pi/4) p/Y of the elastic contact at this radius; yield begins at 2.04 to 2.93 [1]"""
    uniform: FloatOrArray
    """uniform part of the pressure `uniform + hertz sqrt(1 - r^2/a^2)` [modulus]"""
    hertz: FloatOrArray
    """Hertz's part of the pressure [modulus]"""
    force_error: FloatOrArray
    """relative error of the force by comparison with finite elements; 0 before yield [1]"""
    depth_error: FloatOrArray
    """relative error of the depth by comparison with finite elements; 0 before yield [1]"""
    warnings: tuple[str, ...] = field(default=(), repr=False, compare=False)
    """warnings about these numbers; empty if there are none"""

    def imprint(self) -> Imprint:
        """Return the imprint that one state leaves.

        Returns
        -------
        Imprint
            The imprint on the body of the contact.

        Raises
        ------
        InvalidArgumentError
            There are several states, or nothing has yielded.
        DomainError
            The contact would end in a ring.
        """
        if np.ndim(self.radius):
            raise InvalidArgumentError("an imprint needs one state. Give one radius, depth or force")
        if self.force_error == 0.0:
            raise InvalidArgumentError("nothing has yielded in this state: it leaves no imprint. Increase the load")
        body = self._rule.contact.medium
        return Imprint.from_two_terms(body, float(self.radius), float(self.uniform), float(self.hertz), float(self.depth))


@dataclass(frozen=True)
class Overload(Value):
    """First loading of coated bodies, cones and paraboloids by the overload rule.

    The rule is a model, for indenters between a cone and a paraboloid. The mean pressure p of the elastic contact at the same
    radius gives `Lambda = (3 pi/4) p/Y`, with Y of the surface. Lambda then determines force and depth as for a paraboloid on a
    half-space.

    Parameters
    ----------
    contact : Contact
        Elastic contact of a rigid indenter without adhesion, with a homogeneous or an exact medium. Poisson's ratio of the surface
        is from 0 to 0.49.
    yield_stresses : sequence of float
        Y of each material, top to bottom, > 0; `math.inf` where a material below the surface does not yield [modulus].

    Raises
    ------
    ArgumentTypeError
        `contact` is not a contact.
    InvalidArgumentError
        The number of yield stresses is not that of the materials, one is not greater than 0, a film does not yield, the contact has
        adhesion, or the indenter has a flat end.

    Notes
    -----
    States raise an error where the rule does not hold: a > 2 thicknesses of the surface layer, a material below it that yields,
    Lambda > 250, a/R > 0.3 of a sphere, other indenters, and a mean elastic pressure that falls with the radius.

    A `PlasticityWarning` gives the error if a/R of a sphere exceeds 0.1, or a exceeds the thickness of the surface layer.

    By comparison with finite elements the errors of force and depth are 0.2 % for paraboloids on half-spaces, 1.5 % and 2 % for
    cones, 5 % and 1 % (cones 7 %) on films up to a = h, and 9 % and 14 % up to a = 2 h.

    Examples
    --------
    >>> film, base = mdr.Elastic(70e9, 0.3), mdr.Elastic(200e9, 0.3)
    >>> contact = mdr.Contact(mdr.Paraboloid(20e-6), mdr.Coated(film, 2e-6, base))
    >>> rule = mdr.plastic.Overload(contact, [0.5e9, 5e9])
    >>> state = rule.at_depth(50e-9)
    >>> print(f"{state.radius:.4e} {state.force:.4e} {contact.at_depth(50e-9).force:.4e}")
    1.2233e-06 5.0636e-03 6.8574e-03
    """

    contact: Contact
    yield_stresses: Sequence[float]

    def __post_init__(self) -> None:
        if not isinstance(self.contact, Contact):
            raise ArgumentTypeError(f"contact = {self.contact!r}: it must be a Contact")
        values = self.yield_stresses
        if np.ndim(values) != 1 or not len(values):
            raise ArgumentTypeError(f"yield_stresses = {values!r}: it must be a sequence of a number for each material")
        self._set(yield_stresses=tuple(number("yield_stresses", value) for value in values))
        self._set(_handle=Handle(native.overload_new(self.contact._handle, self.yield_stresses)))

    def at_radius(self, radius: ArrayLike) -> OverloadState:
        """Return states of given contact radii.

        Parameters
        ----------
        radius : array_like
            a > 0, any shape [length].

        Returns
        -------
        OverloadState
            States in the shape of `radius`.

        Raises
        ------
        InvalidArgumentError
            A radius is not greater than 0, or the indenter is blunter than a paraboloid or sharper than a cone there.
        DomainError
            The rule does not hold at a radius.
        """
        return self._states("radius", _layout.RADIUS, radius)

    def at_depth(self, depth: ArrayLike) -> OverloadState:
        """Return states of given depths.

        Parameters
        ----------
        depth : array_like
            d > 0, any shape [length].

        Returns
        -------
        OverloadState
            States in the shape of `depth`.

        Raises
        ------
        InvalidArgumentError
            A depth is not greater than 0, or the indenter is blunter than a paraboloid or sharper than a cone there.
        DomainError
            The rule does not hold at a depth.
        UnreachableError
            A depth is one that the elastic contact does not reach.
        """
        return self._states("depth", _layout.DEPTH, depth)

    def at_force(self, force: ArrayLike) -> OverloadState:
        """Return states of given forces.

        Parameters
        ----------
        force : array_like
            F > 0, any shape [modulus length^2].

        Returns
        -------
        OverloadState
            States in the shape of `force`.

        Raises
        ------
        InvalidArgumentError
            A force is not greater than 0, or the indenter is blunter than a paraboloid or sharper than a cone there.
        DomainError
            The rule does not hold at a force.
        UnreachableError
            A force is one that the elastic contact does not reach.
        """
        return self._states("force", _layout.FORCE, force)

    def points(self, depth: ArrayLike) -> LoadingPoints:
        """Return points of first loading for `PlasticLaw.from_table`.

        That law unloads as on a half-space. `PlasticLaw.from_overload` is the law of a coated body.

        Parameters
        ----------
        depth : array_like
            d > 0, one dimension [length].

        Returns
        -------
        LoadingPoints
            Depth, force, radius and residual depth; the latter is 0 where nothing has yielded.

        Raises
        ------
        InvalidArgumentError
            A depth is not greater than 0.
        DomainError
            The rule does not hold at a depth, or a contact would end in a ring.
        """
        state = self.at_depth(row("depth", depth))
        body = self.contact.medium
        columns = (np.ravel(values) for values in (state.radius, state.uniform, state.hertz, state.depth, state.force_error))
        left = [
            Imprint.from_two_terms(body, a, uniform, hertz, d).residual_depth if error > 0.0 else 0.0
            for a, uniform, hertz, d, error in zip(*columns, strict=True)
        ]
        return LoadingPoints(state.depth, state.force, state.radius, np.array(left))

    def _states(self, name: str, given: int, values: ArrayLike) -> OverloadState:
        columns = evaluate_all(name, values, lambda flat: native.overload_states(self._handle, given, flat))
        depth, radius, force, load, uniform, hertz, force_error, depth_error = columns
        state = OverloadState(self, depth, radius, force, load, uniform, hertz, force_error, depth_error)
        found = self._doubts(state)
        warn_all(found)
        return replace(state, warnings=texts_of(found))

    def _doubts(self, state: OverloadState) -> list[Caution]:
        """Warnings of a large a/R and of a contact wider than the film."""
        found: list[Caution] = []
        yielded = np.asarray(state.force_error) > 0.0
        if not np.any(yielded):
            return found
        largest = float(np.max(np.where(yielded, state.radius, 0.0)))
        profile = self.contact.indenter
        slope = largest / profile.radius if hasattr(profile, "radius") else 0.0
        if slope > _SMALL_SLOPE:
            text = (
                f"a/R = {slope:.3g}: beyond 0.1 the hardness of spheres falls, here by {145.0 * slope**2:.2g} %, which the rule "
                "leaves out. Reduce the load"
            )
            found.append(Caution(text, PlasticityWarning))
        if np.any(np.asarray(state.depth_error) > 0.1):
            text = (
                f"a = {largest:g} exceeds the thickness of the film: the film piles up, and force and depth have errors of 9 % and "
                "14 %. Reduce the load"
            )
            found.append(Caution(text, PlasticityWarning))
        return found
