# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of contacts that yield: force over depth with one number of memory for each contact."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _layout
from .._boundary import (
    FloatOrArray,
    Handle,
    call,
    check_memory,
    evaluate,
    evaluate_all,
    native,
    not_zero,
    number,
    numbers,
    record,
    whole,
)
from .._warn import Caution, texts_of, warn_all
from ..errors import ArgumentTypeError, InvalidArgumentError, LargeStrainWarning
from ..material import Elastic
from ..medium.base import Medium
from ..medium.homogeneous import Homogeneous
from ..medium.pair import Pair
from ..profile.base import Profile
from .imprint import Imprint
from .overload import Overload
from .yielding import Yielding

Reals = NDArray[np.float64]

_STEEP = 0.1
"""a/R from which on geometry changes the law."""
_RATIOS, _LOSSES = (0.1, 0.2, 0.3), (1.6, 6.0, 13.0)
"""a/R, and by how much hardness falls there in per cent: Jackson and Green's fit of finite strains."""


_NO_STRAIN = np.zeros(1)


class PlasticStep(NamedTuple):
    """States of contacts after a step, from `PlasticLaw.advance`.

    Each entry is an array with one number for each contact.

    Examples
    --------
    >>> ball = mdr.plastic.Yielding(mdr.Elastic(210e9, 0.3), yield_stress=1e9)
    >>> law = mdr.plastic.PlasticLaw(mdr.Paraboloid(1e-3), ball, 6e-6)
    >>> step = law.advance(law.contacts(1), [5e-6])
    >>> print(f"{step.force[0]:.2f} {step.radius[0]:.3e}")
    63.70 8.939e-05
    """

    force: Reals
    """F, normal force, positive in compression [modulus length^2]"""
    stiffness: Reals
    """dF/dd along the path, which jumps at the largest depth of the contact [modulus length]"""
    radius: Reals
    """a, contact radius [length]"""


class _FirstLoadingNumbers(NamedTuple):
    """The numbers of a `FirstLoading`."""

    force: FloatOrArray
    """F, normal force [modulus length^2]"""
    radius: FloatOrArray
    """a, contact radius [length]"""
    residual_depth: FloatOrArray
    """depth at which the contact opens on unloading without adhesion [length]"""
    work: FloatOrArray
    """int F dd [modulus length^3]"""


class FirstLoading(_FirstLoadingNumbers):
    """States of first loading, from `PlasticLaw.loading`.

    Each entry has the shape of the input.

    Examples
    --------
    >>> ball = mdr.plastic.Yielding(mdr.Elastic(210e9, 0.3), yield_stress=1e9)
    >>> state = mdr.plastic.PlasticLaw(mdr.Paraboloid(1e-3), ball, 6e-6).loading(5e-6)
    >>> print(f"{state.force:.2f} {state.residual_depth:.3e}")
    63.70 3.075e-06
    """

    _law: PlasticLaw
    _depth: FloatOrArray

    def imprint(self) -> Imprint:
        """Return the imprint that one state leaves, as `Imprint.from_state` does.

        Returns
        -------
        Imprint
            The imprint on the body that yields, paired with the other one if that is not rigid.

        Raises
        ------
        InvalidArgumentError
            There are several states, nothing has yielded, or the law has adhesion or is that of a table.
        """
        if np.ndim(self.radius):
            raise InvalidArgumentError("an imprint needs one state. Give one depth")
        if not self.residual_depth:
            raise InvalidArgumentError("nothing has yielded in this state: it leaves no imprint. Increase the depth")
        if self._law.work_of_adhesion:
            raise InvalidArgumentError(
                f"work_of_adhesion = {self._law.work_of_adhesion:g}: the imprint is one of loading without adhesion. Take the "
                "state from a law without it, and give the work of adhesion to `Imprint.contact`"
            )
        sizes = (float(number) for number in (self.radius, self.force, self.residual_depth, self._depth))
        return Imprint(self._law._body(), *sizes)


class PlasticLaw:
    """Law of a paraboloid on a half-space that yields, evaluated in nanoseconds.

    Each contact remembers its largest depth. A contact that has not yielded is elastic. On first loading the force is that of
    finite elements; unloading and reloading are elastic, with the imprint that the largest depth has left. The law is immutable
    and may be shared between threads.

    Parameters
    ----------
    profile : Profile
        A paraboloid; between two bodies that of their gap.
    metal : Yielding
        Material that yields.
    largest_depth : float
        Largest depth > 0, at which a <= 0.3 R and a E*/(R Y) <= 250 [length].
    other : Elastic or Yielding, optional
        The other body: one that does not yield, or one equal to `metal`. None: it is rigid.
    work_of_adhesion : float, optional
        gamma >= 0, which must not yield the body alone [modulus length].
    tolerance : float, optional
        Relative tolerance of F and a against the curve of first loading, 1e-11 to 1e-2.

    Raises
    ------
    ArgumentTypeError
        An object is of another type.
    InvalidArgumentError
        A number is outside its range, the profile is not a paraboloid, or two different bodies yield.
    DomainError
        The largest depth exceeds a limit above, or adhesion alone yields the body.

    Notes
    -----
    The law warns by `LargeStrainWarning` if a > 0.1 R at the largest depth. The error of F and d is 0.2 % against finite elements
    with a rigid partner or an equal one. With an elastic partner of the same modulus it is up to 4 % of F and 3 % of d from
    a E*/(R Y) = 8 on, with one four times as stiff 0.5 and 1.2 %. Damping is added by the program that moves the bodies, from
    `stiffness`.

    Adhesion acts at the edge, as in the contact of Johnson, Kendall and Roberts, which the law is up to yield. On first loading
    beyond yield the edge condition is superposed, a model; on unloading it is exact for the imprint.

    Viscoelastic bodies, shear while plastic flow grows, and other profiles are not supported. `from_table` takes a measured or
    computed curve instead.

    References
    ----------
    tabor-1951
    johnson-1971

    Examples
    --------
    >>> ball = mdr.plastic.Yielding(mdr.Elastic(210e9, 0.3), yield_stress=1e9)
    >>> law = mdr.plastic.PlasticLaw(mdr.Paraboloid(1e-3), ball, 6e-6)
    >>> memory = law.contacts(2)
    >>> loaded = law.advance(memory, [5e-6, 5.5e-6])
    >>> print(np.round(law.advance(memory, [4.6e-6, 4.6e-6]).force, 2))
    [47.29 33.52]
    >>> print(f"{law.restitution(1e-5, 0.5):.3f}")
    0.851
    """

    __slots__ = ("_facts", "_handle", "_source", "warnings")

    warnings: tuple[str, ...]
    """warnings about the law at the largest depth"""

    def __init__(
        self,
        profile: Profile,
        metal: Yielding,
        largest_depth: float,
        *,
        other: Elastic | Yielding | None = None,
        work_of_adhesion: float = 0.0,
        tolerance: float = 1e-9,
    ) -> None:
        if not isinstance(profile, Profile):
            raise ArgumentTypeError(f"profile = {profile!r}: it must be a Profile")
        if not isinstance(metal, Yielding):
            raise ArgumentTypeError(f"metal = {metal!r}: it must be a Yielding")
        options = _options(work_of_adhesion, tolerance, other)
        depth = number("largest_depth", largest_depth)
        self._own(native.plastic_law_new(profile._handle, metal._handle, depth, options))
        given = {"other": other, "work_of_adhesion": self.work_of_adhesion, "tolerance": self.tolerance}
        self._source: tuple[Any, ...] = ("materials", profile, metal, depth, given)
        self._look()

    @classmethod
    def from_table(
        cls,
        depth: ArrayLike,
        force: ArrayLike,
        radius: ArrayLike,
        residual_depth: ArrayLike,
        modulus: ArrayLike,
        *,
        work_of_adhesion: float = 0.0,
        tolerance: float = 1e-9,
    ) -> PlasticLaw:
        """Return the law of a measured or computed curve of first loading.

        Between the points cubics rise. Unloading is that of an imprint of two terms on a half-space, whose modulus may vary with
        the largest depth: k/(2 a) of coated bodies, with the stiffness k at the beginning of unloading.

        Parameters
        ----------
        depth : array_like
            At least three depths > 0, rising; up to the first one the contact is elastic [length].
        force : array_like
            Forces > 0, rising [modulus length^2].
        radius : array_like
            Contact radii > 0, rising [length].
        residual_depth : array_like
            Depths that remain after an unloading from each point, 0 of an elastic one [length].
        modulus : array_like
            E* > 0, with which the contact unloads from each point, or one for all [modulus].
        work_of_adhesion : float, optional
            As of `PlasticLaw`; 0 if the modulus varies [modulus length].
        tolerance : float, optional
            As of `PlasticLaw`.

        Returns
        -------
        PlasticLaw
            The law, up to the last depth.

        Raises
        ------
        ArgumentTypeError
            An array has not one dimension.
        InvalidArgumentError
            A number is outside its range.
        DomainError
            No imprint of two terms with this force and radius has this residual depth.

        Examples
        --------
        >>> law = mdr.plastic.PlasticLaw.from_table(
        ...     [1e-9, 4e-9, 9e-9], [1e-6, 6e-6, 15e-6], [3e-8, 7e-8, 11e-8], [0.0, 1.3e-9, 4.5e-9], modulus=20e9
        ... )
        >>> print(f"{law.loading(4e-9).force:.3e}")
        6.000e-06
        """
        columns = [numbers(name, values) for name, values in _columns(depth, force, radius, residual_depth)]
        for (name, _), column in zip(_columns(*columns), columns, strict=True):
            if column.ndim != 1 or column.shape != columns[0].shape or not column.size:
                raise ArgumentTypeError(f"{name} of shape {column.shape}: the arrays must have one dimension and equal lengths")
        moduli = numbers("modulus", modulus)
        if moduli.ndim == 0:
            moduli = np.full(columns[0].shape, float(moduli))
        if moduli.shape != columns[0].shape:
            raise ArgumentTypeError(f"modulus of shape {moduli.shape}: it must be a number, or one for each point")
        law = cls.__new__(cls)
        options = _options(work_of_adhesion, tolerance, None)
        d, F, a, left = columns
        law._own(native.plastic_law_from_points(d, F, a, left, moduli, options))
        given = {"work_of_adhesion": law.work_of_adhesion, "tolerance": law.tolerance}
        law._source = ("table", *(tuple(column.tolist()) for column in (*columns, moduli)), given)
        law.warnings = ()
        return law

    @classmethod
    def from_overload(cls, rule: Overload, largest_depth: float, *, tolerance: float = 1e-9) -> PlasticLaw:
        """Return the law of a coated grain, by the overload rule.

        Up to first yield the contact is the elastic one of the rule, first loading is that of the rule. Unloading gives back the
        work of the imprint on the coated body, in the form of a half-space.

        Parameters
        ----------
        rule : Overload
            The rule of a paraboloid, or of another indenter with an elastic range.
        largest_depth : float
            Largest depth > 0, at which the surface has yielded [length].
        tolerance : float, optional
            As of `PlasticLaw`.

        Returns
        -------
        PlasticLaw
            The law, without adhesion.

        Raises
        ------
        ArgumentTypeError
            `rule` is not an `Overload`.
        InvalidArgumentError
            A number is outside its range.
        DomainError
            The rule does not hold up to this depth, as on hard or stiff films on soft bodies, or nothing yields.

        Notes
        -----
        On soft films, with bodies 0.5 to 20 times as stiff, the force on unloading is within 1.1 % of the largest one of that of
        the imprint on the coated body, and the contact radius within 17 %. The error of the rule is added. The restitution is that
        of the imprint (theory/plastic.md (9.7)).

        Examples
        --------
        >>> film, base = mdr.Elastic(70e9, 0.3), mdr.Elastic(200e9, 0.3)
        >>> contact = mdr.Contact(mdr.Paraboloid(20e-6), mdr.Coated(film, 2e-6, base))
        >>> law = mdr.plastic.PlasticLaw.from_overload(mdr.plastic.Overload(contact, [0.5e9, 5e9]), 50e-9)
        >>> memory = law.contacts(1)
        >>> print(np.round(1e3 * np.ravel([law.advance(memory, [d]).force for d in (50e-9, 45e-9)]), 3))
        [5.064 3.744]
        """
        if not isinstance(rule, Overload):
            raise ArgumentTypeError(f"rule = {rule!r}: it must be an Overload")
        law = cls.__new__(cls)
        depth = number("largest_depth", largest_depth)
        law._own(native.plastic_law_from_overload(rule._handle, depth, _options(0.0, tolerance, None)))
        law._source = ("overload", rule, depth, {"tolerance": law.tolerance})
        law.warnings = ()
        return law

    def with_radius(self, radius: float) -> PlasticLaw:
        """Return the law of the same bodies under a paraboloid of another radius.

        Depths and radii are proportional to R, forces to R^2: grains of many sizes share one law.

        Parameters
        ----------
        radius : float
            R > 0 [length].

        Returns
        -------
        PlasticLaw
            The law, up to a largest depth proportional to R.

        Raises
        ------
        InvalidArgumentError
            The radius is outside its range, the law has adhesion, or it is that of a table.
        """
        law = PlasticLaw.__new__(PlasticLaw)
        first = self._source[1] if self._source[0] == "scaled" else self
        law._own(native.plastic_law_with_radius(first._handle, number("radius", radius)))
        law._source = ("scaled", first, law.radius)
        law.warnings = self.warnings
        return law

    def _own(self, created: tuple[int, int]) -> None:
        self._handle = Handle(created)
        facts = record(_layout.plastic_law_facts)
        call(native.plastic_law_about, self._handle, facts)
        self._facts = facts[0]

    def _look(self) -> None:
        """Warns where strains are not small."""
        ratio = float(self._facts["largest_radius"]) / self.radius
        found = []
        if ratio > _STEEP:
            loss = float(np.interp(ratio, _RATIOS, _LOSSES))
            text = (
                f"the contact radius reaches {ratio:.3g} R at the largest depth: the law holds for small strains. There its mean "
                f"pressure is about {loss:.2g} % too large (Jackson and Green's fit)"
            )
            found.append(Caution(text, LargeStrainWarning))
        warn_all(found)
        self.warnings = texts_of(found)

    @property
    def yield_depth(self) -> float:
        """Depth of first yield [length]."""
        return float(self._facts["yield_depth"])

    @property
    def yield_force(self) -> float:
        """Force at first yield [modulus length^2]."""
        return float(self._facts["yield_force"])

    @property
    def first_yield(self) -> float | None:
        """a E*/(R Y) at first yield [1]; None in a law of a table or an overload rule."""
        return float(self._facts["first_yield"]) or None

    @property
    def largest_depth(self) -> float:
        """End of the range [length]."""
        return float(self._facts["largest_depth"])

    @property
    def largest_force(self) -> float:
        """Force of first loading at the largest depth [modulus length^2]."""
        return float(self._facts["largest_force"])

    @property
    def radius(self) -> float:
        """R of the paraboloid [length]; 0 in a law of a table or an overload rule."""
        return float(self._facts["radius"])

    @property
    def modulus(self) -> float:
        """E* of the contact, of a coated body at the largest depth [modulus]."""
        return float(self._facts["modulus"])

    @property
    def work_of_adhesion(self) -> float:
        """Work of adhesion [modulus length]."""
        return float(self._facts["work_of_adhesion"])

    @property
    def tolerance(self) -> float:
        """Relative tolerance of the law [1]."""
        return float(self._facts["tolerance"])

    @property
    def error(self) -> float:
        """Largest relative error of the polynomials against the curve [1]."""
        return float(self._facts["error"])

    @property
    def memory_size(self) -> int:
        """Length of the memory of one contact: 1, with adhesion 2."""
        return int(self._facts["memory_size"])

    def contacts(self, count: int) -> Reals:
        """Return the memory of contacts that have not been loaded.

        Parameters
        ----------
        count : int
            Number of contacts, >= 0.

        Returns
        -------
        ndarray
            Zeros of shape (count, `memory_size`). Store and read them as numbers. The first one is the largest depth; with adhesion
            it is negative while the contact is closed, and the second one is the energy that jumps have lost. Set a row to 0 to
            reset that contact.
        """
        return np.zeros((whole("count", count, 0), self.memory_size))

    def advance(self, memory: Reals, depth: ArrayLike) -> PlasticStep:
        """Advance all contacts to new depths, and change their memory.

        Parameters
        ----------
        memory : ndarray
            The memory from `contacts`.
        depth : array_like
            (n) depths at the end of the step, up to the largest one [length].

        Returns
        -------
        PlasticStep
            Forces, stiffnesses and radii; 0 for separated bodies.

        Raises
        ------
        ArgumentTypeError
            A shape is wrong, or the memory is not from `contacts`.
        InvalidArgumentError
            A depth is not finite, or the memory is not one of this law. After an error it is unchanged.
        DomainError
            A depth exceeds the range.
        """
        return self._step(memory, depth, False)

    def try_(self, memory: Reals, depth: ArrayLike) -> PlasticStep:
        """Return what `advance` would return, without changing the memory.

        Use it for Newton's method and for steps that may be rejected.

        Parameters
        ----------
        memory : ndarray
            As in `advance`.
        depth : array_like
            As in `advance` [length].

        Returns
        -------
        PlasticStep
            As of `advance`.

        Raises
        ------
        ArgumentTypeError
            As of `advance`.
        InvalidArgumentError
            As of `advance`.
        DomainError
            As of `advance`.
        """
        return self._step(memory, depth, True)

    def _step(self, memory: Reals, depth: ArrayLike, is_trial: bool) -> PlasticStep:
        depths = self._depths(memory, depth)
        if not depths.size:
            return PlasticStep(np.zeros(0), np.zeros(0), np.zeros(0))
        return PlasticStep(*call(native.plastic_law_advance, self._handle, depths, is_trial, memory))

    def energies(self, memory: Reals, depth: ArrayLike) -> tuple[Reals, Reals]:
        """Return the stored and the dissipated energy of all contacts.

        Their sum is the work int F dd since the first step. The dissipated energy never decreases.

        Parameters
        ----------
        memory : ndarray
            The memory from `contacts`.
        depth : array_like
            (n) depths of the contacts [length].

        Returns
        -------
        tuple of ndarray
            (n) energies that the contacts give back, with adhesion less that of their surfaces; and (n) energies that plastic flow
            and jumps have taken since the first step [modulus length^3].

        Raises
        ------
        ArgumentTypeError
            As of `advance`.
        InvalidArgumentError
            As of `advance`.
        DomainError
            As of `advance`.
        """
        depths = self._depths(memory, depth)
        if not depths.size:
            return np.zeros(0), np.zeros(0)
        stored, dissipated = call(native.plastic_law_energies, self._handle, depths, memory)
        return stored, dissipated

    def _depths(self, memory: Reals, depth: ArrayLike) -> Reals:
        check_memory(memory, self.memory_size, "PlasticLaw.contacts")
        depths = numbers("depth", depth)
        if depths.shape != (len(memory),):
            raise ArgumentTypeError(f"depth of shape {depths.shape}: it must be ({len(memory)},)")
        return depths

    def loading(self, depth: ArrayLike) -> FirstLoading:
        """Return states of first loading.

        Parameters
        ----------
        depth : array_like
            Depths up to the largest one, any shape [length].

        Returns
        -------
        FirstLoading
            The states, in the shape of `depth`.

        Raises
        ------
        InvalidArgumentError
            A depth is not finite.
        DomainError
            A depth exceeds the range.
        """
        found = FirstLoading(*evaluate_all("depth", depth, lambda d: native.plastic_law_loading(self._handle, d)))
        found._law, found._depth = self, np.array(depth, dtype=float) if np.ndim(depth) else float(np.asarray(depth))
        return found

    def _body(self) -> Medium:
        """What yields, and what presses it."""
        kind, *source = (self._source[1] if self._source[0] == "scaled" else self)._source
        if kind == "table":
            raise InvalidArgumentError(
                "the body of a law of a table is not known. Create Imprint(body, radius, force, residual_depth, depth)"
            )
        if kind == "overload":
            body: Medium = source[0].contact.medium
            return body
        _, metal, _, options = source
        other = options["other"]
        if other is None:
            return Homogeneous(metal.elastic)
        return Pair(metal.elastic, other.elastic if isinstance(other, Yielding) else other)

    def restitution(self, mass: float, speed: ArrayLike) -> FloatOrArray:
        """Return coefficients of restitution of impacts without waves.

        Parameters
        ----------
        mass : float
            Reduced mass m > 0; m V^2 has the unit of energies.
        speed : array_like
            Speeds V > 0 at initial contact, any shape.

        Returns
        -------
        float or ndarray
            Coefficients of restitution, in the shape of `speed` [1]; with adhesion 0 if the bodies stick.

        Raises
        ------
        InvalidArgumentError
            A number is not greater than 0.
        DomainError
            An impact goes beyond the largest depth.

        References
        ----------
        johnson-1985
        """
        m = number("mass", mass)
        return evaluate("speed", speed, lambda V: native.plastic_law_restitution(self._handle, m, V))

    def buffer(self) -> Reals:
        """Return all numbers of the law, for the inline functions of C.

        Returns
        -------
        ndarray
            The numbers that `mdrcontact_plastic_law.h` evaluates.
        """
        size = int(self._facts["buffer_size"])
        numbers_of_law = np.zeros(size)
        call(native.plastic_law_buffer, self._handle, size, numbers_of_law)
        return numbers_of_law

    def __reduce__(self) -> tuple[Any, ...]:
        return _remade, self._source

    def __eq__(self, other: object) -> bool:
        return isinstance(other, PlasticLaw) and np.array_equal(self.buffer(), other.buffer())

    def __hash__(self) -> int:
        return hash(self.buffer().tobytes())

    def __repr__(self) -> str:
        kind = self._source[0]
        if kind == "table":
            made = f"a table of {len(self._source[1])} points"
        elif kind == "overload":
            made = repr(self._source[1])
        elif kind == "scaled":
            made = f"{self._source[1]._source[2]!r} under R = {self.radius:g}"
        else:
            made = f"{self._source[2]!r} under {self._source[1]!r}"
            if self._source[4]["other"] is not None:
                made = f"{made} with {self._source[4]['other']!r}"
        if self.work_of_adhesion:
            made = f"{made} with adhesion {self.work_of_adhesion:g}"
        return f"<PlasticLaw of {made} up to depth {self.largest_depth:g}>"


def _columns(depth: Any, force: Any, radius: Any, residual_depth: Any) -> tuple[tuple[str, Any], ...]:
    return ("depth", depth), ("force", force), ("radius", radius), ("residual_depth", residual_depth)


def _options(work_of_adhesion: float, tolerance: float, other: Elastic | Yielding | None) -> Any:
    """Struct mdr_plastic_law_options."""
    members: dict[str, Any] = {
        "work_of_adhesion": number("work_of_adhesion", work_of_adhesion),
        "tolerance": not_zero("tolerance", tolerance),
    }
    if isinstance(other, Elastic):
        members["other"] = Handle(native.yielding_new(other.E, other.nu, _NO_STRAIN, None))
    elif isinstance(other, Yielding):
        members["other"] = other._handle
    elif other is not None:
        raise ArgumentTypeError(f"other = {other!r}: it must be an Elastic or a Yielding, or None")
    return record(_layout.plastic_law_options, **members)


def _remade(kind: str, *given: Any) -> PlasticLaw:
    """A copy that is pickled: the law is made anew."""
    if kind == "scaled":
        law, radius = given
        return law.with_radius(radius)  # type: ignore[no-any-return]
    *arguments, options = given
    if kind == "table":
        return PlasticLaw.from_table(*arguments, **options)
    if kind == "overload":
        return PlasticLaw.from_overload(*arguments, **options)
    return PlasticLaw(*arguments, **options)
