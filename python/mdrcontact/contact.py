# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact of an indenter with a medium: states, cycles, histories (theory/paper.md (4.1), (4.2))."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout, failure, poroelastic
from ._boundary import ComplexOrArray, FloatOrArray, Handle, evaluate_all, native, number, record, row, whole
from ._choices import code
from ._state_warnings import Reported, StateWarnings
from ._value import Value
from ._warn import Caution, collected
from .adhesion import RateAdhesion, RheologicalAdhesion, rate
from .errors import ArgumentTypeError, InvalidArgumentError, MDRError
from .failure import Failure
from .loop import BRANCHES, RULES, Loop, PullOff, loop, pull_offs
from .medium import Medium
from .profile import Profile
from .progress import Progress
from .state import State, States, state_of
from .time import History, dynamic_stiffness, history, refuse_drainage, step

if TYPE_CHECKING:
    from .panels import Figure

__all__ = ["Contact", "State", "States"]

Table = tuple[tuple[float, ...], tuple[float, ...]]
_INSIDE = 1e-9
"""Distance of a curve from pull-off, as a part of its depths."""


@dataclass(frozen=True)
class Contact(Value):
    """Frictionless contact of an indenter with a medium.

    A contact is immutable and may be shared between threads. Calls with arrays can use several threads; see `set_threads`.

    Parameters
    ----------
    indenter : Profile
        The rigid indenter, as `Sphere`, or the gap between two deformable bodies.
    medium : Medium
        The body, as `Coated` or `Homogeneous`, or a `Pair`.
    work_of_adhesion : float, optional
        gamma >= 0 [modulus length], J/m^2 in SI units. 0, the default, is a contact without adhesion.
    adhesion_rule : {"automatic", "paper", "energy"}, optional
        Critical elongation dl at which the springs at the contact edge detach. "paper": `dl = sqrt(2 pi a gamma/E_eff)`, equation
        (28). "energy": `dl = sqrt(4 pi a gamma/k'(a))`, the energy balance. "automatic" uses the energy balance for exact media,
        where it is exact, and equation (28) for all others.
    zeta : tuple of array_like, "exact" or None, optional
        Ratio d/g(a) of equation (9), which corrects the contact radius. None, the default, is 1. A table (radii, values) has at
        least 3 ascending radii > 0 [length] and values > 0. "exact" is the ratio of the exact solution of this body,
        for radii up to 1000 thicknesses; E_eff is then the only approximation.
    cohesive_stress : float, optional
        sigma_0 >= 0 [modulus]. The surfaces attract each other with this stress wherever their gap is less than
        work_of_adhesion/cohesive_stress (Dugdale, Maugis). 0, the default, is the JKR limit. It is supported on homogeneous bodies
        and under the model "exact", pairs included; on a viscoelastic half-space only by `adhesion.adhesive_history`.
    adhesion : RateAdhesion or RheologicalAdhesion, optional
        A work of adhesion that depends on the speed of the contact edge, instead of `work_of_adhesion`. States are those of an edge
        at rest; `adhesion.rate_history` follows the edge in time.

    Raises
    ------
    ArgumentTypeError
        The indenter, the medium or the adhesion is of another type.
    InvalidArgumentError
        A number is outside its range, or the medium does not support an option.

    References
    ----------
    popov-2014, sections 2 to 5
    johnson-1971
    maugis-1992

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(165e9, 0.22))
    >>> contact = mdr.Contact(mdr.Sphere(10e-6), film)
    >>> states = contact.at_depth([20e-9, 50e-9])
    >>> print(np.round(states.force * 1e3, 4))
    [1.2635 5.6227]
    >>> rubber = mdr.Homogeneous(mdr.Elastic(1e6, 0.5))
    >>> sticky = mdr.Contact(mdr.Paraboloid(10e-6), rubber, work_of_adhesion=0.05)
    >>> print(f"{sticky.pull_off().force:.4e}")
    -2.3562e-06
    """

    indenter: Profile
    medium: Medium
    work_of_adhesion: float
    adhesion_rule: str
    zeta: Table | str | None
    cohesive_stress: float
    adhesion: RateAdhesion | RheologicalAdhesion | None
    _rates: list[tuple[Handle, float]] = field(init=False, repr=False, compare=False)
    """the library's contact with a rate and its largest radius, once there was a history"""
    _doubts: StateWarnings = field(init=False, repr=False, compare=False)
    _reported: Reported = field(init=False, repr=False, compare=False)
    """what the user has read about it, which changes no result"""

    def __init__(
        self,
        indenter: Profile,
        medium: Medium,
        work_of_adhesion: float = 0.0,
        adhesion_rule: str = "automatic",
        zeta: tuple[ArrayLike, ArrayLike] | str | None = None,
        cohesive_stress: float = 0.0,
        adhesion: RateAdhesion | RheologicalAdhesion | None = None,
    ) -> None:
        if not isinstance(indenter, Profile):
            raise ArgumentTypeError(f"indenter = {indenter!r}: it must be an indenter profile")
        if not isinstance(medium, Medium):
            raise ArgumentTypeError(f"medium = {medium!r}: it must be a medium")
        gamma = rate.work("work_of_adhesion", work_of_adhesion, adhesion)
        rule, sigma = code("adhesion_rule", adhesion_rule, RULES), number("cohesive_stress", cohesive_stress)
        if adhesion is not None and sigma != 0.0:
            raise InvalidArgumentError("cohesive_stress: it excludes adhesion=, which is a JKR limit. Omit one of them")
        is_exact = isinstance(zeta, str) and zeta == "exact"
        given: Any = zeta if zeta is None or is_exact else _table(zeta)
        columns = [np.array(column) for column in (((), ()) if is_exact or given is None else given)]
        options = record(_layout.contact_options, work_of_adhesion=gamma, adhesion_rule=rule,
                         zeta_count=len(columns[0]), zeta_radius=columns[0], zeta=columns[1],
                         zeta_is_exact=int(is_exact), cohesive_stress=sigma)  # fmt: skip
        handle: Any = poroelastic.NoElasticStates()
        if not poroelastic.is_poroelastic(medium):
            created = native.contact_new(indenter._handle, medium._handle, options)
            handle = Handle(created)
        elif gamma != 0.0 or sigma != 0.0 or given is not None:
            raise InvalidArgumentError("work_of_adhesion, cohesive_stress and zeta: they are not available on a gel. Omit them")
        self._set(_handle=handle, indenter=indenter, medium=medium)
        self._set(work_of_adhesion=gamma, adhesion_rule=adhesion_rule, zeta=given, cohesive_stress=sigma)
        self._set(adhesion=adhesion, _rates=[])
        self._set(_doubts=StateWarnings(self), _reported=Reported())

    @overload
    def at_depth(self, depth: float, branch: str = "unloading") -> State: ...
    @overload
    def at_depth(self, depth: Sequence[Any] | NDArray[Any], branch: str = "unloading") -> States: ...
    @overload
    def at_depth(self, depth: ArrayLike, branch: str = "unloading") -> State: ...

    def at_depth(self, depth: ArrayLike, branch: str = "unloading") -> State:
        """Return the stable states at given indentation depths.

        Parameters
        ----------
        depth : array_like
            Depths d >= 0, any shape [length]. With adhesion d may be negative down to the pull-off depth.
        branch : {"unloading", "loading"}, optional
            Which state an adhesive contact has if several are stable: the largest contact, kept on unloading, or the smallest,
            reached on loading (d >= 0).

        Returns
        -------
        State
            Depth, radius, force and stiffness, in the shape of `depth`.

        Raises
        ------
        UnreachableError
            No stable contact has the depth.
        InvalidArgumentError
            The depth is not finite, or the body relaxes and has no states.
        """
        return self._states("depth", _layout.DEPTH, depth, branch)

    def plot(self, largest_depth: float, points: int = 100) -> Figure:
        """Return force, contact radius and stiffness over depth as a figure.

        Numbers are taken as SI.

        Parameters
        ----------
        largest_depth : float
            End of the curve, > 0 [length]. With adhesion it begins at pull-off.
        points : int, optional
            Number of depths, at least 2.

        Returns
        -------
        Figure
            The figure.

        Raises
        ------
        InvalidArgumentError
            A number is outside its range.

        Examples
        --------
        >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
        >>> figure = contact.plot(100e-9)
        >>> print(figure.panels[0].y.title, len(figure.panels[0].parts[0].x))
        force F [mN] 100
        """
        from .panels import Figure, contacts

        end, count = number("largest_depth", largest_depth), whole("points", points, 2)
        if not end > 0.0:
            raise InvalidArgumentError(f"largest_depth = {largest_depth!r}: it must be positive")
        lowest = float(self.pull_off("depth").depth)
        begin = lowest + _INSIDE * (end - lowest) if lowest < 0.0 else end / count
        return Figure("Contact", tuple(contacts.over_depth(self.at_depth(np.linspace(begin, end, count)))), columns=3)

    @overload
    def at_force(self, force: float, branch: str = "unloading") -> State: ...
    @overload
    def at_force(self, force: Sequence[Any] | NDArray[Any], branch: str = "unloading") -> States: ...
    @overload
    def at_force(self, force: ArrayLike, branch: str = "unloading") -> State: ...

    def at_force(self, force: ArrayLike, branch: str = "unloading") -> State:
        """Return the stable states under given normal forces.

        Parameters
        ----------
        force : array_like
            Forces F >= 0, any shape [modulus length^2]. With adhesion F may be negative down to the pull-off force.
        branch : {"unloading", "loading"}, optional
            As in `at_depth`.

        Returns
        -------
        State
            Depth, radius, force and stiffness, in the shape of `force`.

        Raises
        ------
        UnreachableError
            No stable contact has the force.
        InvalidArgumentError
            The force is not finite, or the body relaxes and has no states.
        """
        return self._states("force", _layout.FORCE, force, branch)

    @overload
    def at_radius(self, radius: float) -> State: ...
    @overload
    def at_radius(self, radius: Sequence[Any] | NDArray[Any]) -> States: ...
    @overload
    def at_radius(self, radius: ArrayLike) -> State: ...

    def at_radius(self, radius: ArrayLike) -> State:
        """Return the equilibrium states at given contact radii.

        Parameters
        ----------
        radius : array_like
            Radii a >= 0, any shape [length].

        Returns
        -------
        State
            Depth, radius, force and stiffness, in the shape of `radius`. With adhesion they may be unstable.

        Raises
        ------
        UnreachableError
            The radius is that of a vertical wall (flat punch), which determines no depth.
        DomainError
            The radius lies beyond the indenter or the medium.
        """
        return self._states("radius", _layout.RADIUS, radius, "unloading")

    def history(
        self,
        time: ArrayLike,
        *,
        depth: ArrayLike | None = None,
        force: ArrayLike | None = None,
        radius: ArrayLike | None = None,
        tolerance: float = 1e-5,
        progress: bool | Progress = False,
    ) -> History:
        """Follow a contact with a viscoelastic body in time.

        Give one of `depth`, `force` and `radius`.

        Parameters
        ----------
        time : array_like
            Strictly ascending times, one dimension [time]. Before the first time the bodies are separated and at rest.
        depth : array_like, optional
            Depths at these times, linear in between [length]. The first value is reached in a jump. Depths may be negative while
            the bodies are separated.
        force : array_like, optional
            Normal forces at these times, as `depth` [modulus length^2].
        radius : array_like, optional
            Contact radii at these times, as `depth` [length].
        tolerance : float, optional
            Tolerance of the integration in time, relative to the largest depth, radius and force, 1e-9 to 1e-2.
        progress : bool or Progress, optional
            True shows a progress bar on a terminal if the work takes more than two seconds. A `Progress` follows each round.

        Returns
        -------
        History
            Time, depth, contact radius and force.

        Raises
        ------
        InvalidArgumentError
            The body is elastic, the contact has `adhesion` or a `cohesive_stress`, or the path is not valid.
        NoConvergenceError
            The integration does not reach its tolerance.

        Notes
        -----
        If all materials relax proportionally at constant Poisson's ratios, or the body is homogeneous, the history follows from
        elastic curves to machine precision: Lee and Radok (1960) while the contact grows, Ting (1966) after the largest depth. Any
        other body or path is integrated in time under the model "exact", unless a dashpot is in parallel at the surface. For gels
        use `poroelastic.history`, for contacts with `adhesion` use `adhesion.rate_history`, and with a `cohesive_stress` use
        `adhesion.adhesive_history`.

        References
        ----------
        lee-1960
        ting-1966
        """
        if self.adhesion is not None:
            raise InvalidArgumentError("adhesion: call mdrcontact.adhesion.rate_history(contact, ...)")
        if self.cohesive_stress > 0.0:
            raise InvalidArgumentError("cohesive_stress: call mdrcontact.adhesion.adhesive_history(contact, ...)")
        return history(self._handle, time, depth, force, radius, tolerance, progress)

    def dynamic_stiffness(
        self,
        omega: ArrayLike,
        *,
        radius: ArrayLike | None = None,
        depth: ArrayLike | None = None,
        force: ArrayLike | None = None,
        drainage: str | None = None,
    ) -> ComplexOrArray:
        """Return the dynamic stiffness `k* = k' + i k''` of a relaxing body.

        The contact oscillates with a small amplitude about a constant radius. `pi k''` times the amplitude squared is the energy
        lost in each cycle, and `k''/k'` is tan delta. Give at most one of `radius`, `depth` and `force`; a flat punch needs none.

        Parameters
        ----------
        omega : array_like
            Angular frequencies > 0 [1/time]. They broadcast with the other argument.
        radius : array_like, optional
            Contact radius [length].
        depth : array_like, optional
            Depth of the relaxed body, as after a long hold [length].
        force : array_like, optional
            Force on the relaxed body [modulus length^2].
        drainage : {"surface", "sealed", "indenter"}, optional
            Of a gel, which takes `radius` only; see `relaxation`.

        Returns
        -------
        complex or ndarray
            k*, in the broadcast shape [modulus length].

        Raises
        ------
        InvalidArgumentError
            The body is elastic, or the drainage of a gel is missing.
        ArgumentTypeError
            More than one of radius, depth and force is given.

        Notes
        -----
        The result is exact for any materials under the model "exact". Under other models the materials must relax proportionally.
        Each new frequency of a layered body costs two kernels; further radii at the same frequency cost little.
        """
        if poroelastic.is_poroelastic(self.medium):
            if depth is not None or force is not None:
                raise ArgumentTypeError("depth and force: they are not available on a gel. Give the contact radius, radius=")
            return poroelastic.dynamic_stiffness(self, omega, radius, drainage)  # type: ignore[arg-type]
        refuse_drainage(drainage)
        return dynamic_stiffness(self, omega, radius, depth, force)

    def relaxation(self, time: ArrayLike, radius: float | None = None, drainage: str | None = None) -> FloatOrArray:
        """Return force per depth after a step of the depth at constant contact radius.

        Parameters
        ----------
        time : array_like
            Times > 0 after the step, any shape [time]; 0 is possible on a gel.
        radius : float, optional
            The constant contact radius [length]. A flat punch needs none.
        drainage : {"surface", "sealed", "indenter"}, optional
            Of a gel, which has no default. "surface": the whole surface drains, also below the indenter, which is porous. "sealed":
            no flux anywhere. "indenter": no flux below the indenter and a drained surface outside, on a half-space only.

        Returns
        -------
        float or ndarray
            Force per depth, in the shape of `time` [modulus length].

        Raises
        ------
        InvalidArgumentError
            The body is elastic, or the drainage of a gel is missing.
        ArgumentTypeError
            The radius is missing, or a body without pores has a drainage.
        """
        return self._step(_layout.RELAXATION, time, radius, drainage)

    def creep(self, time: ArrayLike, radius: float | None = None, drainage: str | None = None) -> FloatOrArray:
        """Return depth per force after a step of the force at constant contact radius.

        Parameters
        ----------
        time : array_like
            As in `relaxation` [time].
        radius : float, optional
            As in `relaxation` [length].
        drainage : {"surface", "sealed", "indenter"}, optional
            As in `relaxation`.

        Returns
        -------
        float or ndarray
            Depth per force, in the shape of `time` [1/(modulus length)].

        Raises
        ------
        InvalidArgumentError
            As of `relaxation`.
        """
        return self._step(_layout.CREEP, time, radius, drainage)

    def pressure_in_time(
        self,
        kind: str,
        r: ArrayLike,
        time: float,
        *,
        depth: float | None = None,
        radius: float | None = None,
        drainage: str | None = None,
    ) -> FloatOrArray:
        """Return the pressure under an indenter that was pressed into a gel in a step.

        Parameters
        ----------
        kind : {"total_pressure", "pore_pressure"}
            The pressure on the indenter, or that of the fluid at the surface; the latter on a half-space only.
        r : array_like
            Radii, 0 <= r < a, any shape [length].
        time : float
            Time since the step, D t/a^2 >= 1e-5 [time].
        depth : float, optional
            Depth of the step of a flat punch [length].
        radius : float, optional
            Constant contact radius of a `Paraboloid`, which determines its depth [length].
        drainage : {"surface", "sealed", "indenter"}, optional
            As in `relaxation`.

        Returns
        -------
        float or ndarray
            Pressure, in the shape of `r` [modulus].

        Raises
        ------
        InvalidArgumentError
            The body is not a gel, or the indenter is neither a `FlatPunch` nor a `Paraboloid`.
        ArgumentTypeError
            The depth or radius is missing, or the wrong one is given.
        """
        return poroelastic.pressure(self, kind, r, time, depth, radius, drainage)

    def pull_off(self, control: str = "force") -> PullOff:
        """Return the state in which an adhesive contact breaks.

        Parameters
        ----------
        control : {"force", "depth"}, optional
            Quantity prescribed while the bodies are separated.

        Returns
        -------
        PullOff
            The global minimum over all stable states. All numbers are 0 without adhesion.

        Raises
        ------
        DomainError
            The contact is still stable at the smallest radius of a tabulated medium.
        """
        return pull_offs(self, control)

    def loop(self, control: str, largest: float, points: int = 200, *, spring_stiffness: float | None = None) -> Loop:
        """Return a cycle of approach and retraction, with its jumps and the energy lost.

        Parameters
        ----------
        control : {"force", "depth", "spring"}
            Prescribed quantity. "spring" prescribes the far end of a spring, as the base of an AFM cantilever.
        largest : float
            Largest prescribed value, at which the motion turns back, > 0 [length], [modulus length^2] for "force".
        points : int, optional
            Points on each way, >= 2. Jumps and their ends are additional points.
        spring_stiffness : float, optional
            Stiffness of the spring, > 0, for "spring" only [modulus length].

        Returns
        -------
        Loop
            The cycle.

        Raises
        ------
        ArgumentTypeError
            A spring stiffness is missing under control "spring", or given under another control.
        UnreachableError
            No contact has the largest value.
        """
        return loop(self, control, largest, points, spring_stiffness)

    def first_failure(
        self,
        strengths: Mapping[str, Sequence[float | None]],
        body: str = "lower",
        friction: float = 0.0,
        largest_radius: float | None = None,
    ) -> tuple[Failure, ...]:
        """Return the states at which given strengths are first reached as the load grows.

        Parameters
        ----------
        strengths : mapping
            Strengths by mode, each a list from top to bottom [modulus]; None omits a layer or interface. "von_mises" (yield stress)
            and "tension" (principal stress) have one number for each layer, the half-space last. "interface_shear" and
            "interface_tension" have one for each interface.
        body : {"lower", "upper"}, optional
            Body of a pair.
        friction : float, optional
            Coefficient of friction of a sliding contact, >= 0 [1].
        largest_radius : float, optional
            Largest contact radius of the search, > 0 [length]. The default is 30 times the thickness of all layers.

        Returns
        -------
        tuple of Failure
            The failures in the order in which they occur. A strength that is not reached, or only at the singular edge of a punch
            or an adhesive contact, has none.

        Raises
        ------
        InvalidArgumentError
            A mode is unknown, the number of strengths differs from the number of layers or interfaces, or the body has no layers
            and `largest_radius` is missing.
        ArgumentTypeError
            `strengths` is not a mapping of lists.

        Notes
        -----
        If a strength is reached at any load, as below a sharp tip, the failure is that of the smallest contact examined, with
        `at_once` set.
        """
        return failure.first_failure(self, strengths, body, friction, largest_radius)

    def _step(self, kind: int, time: ArrayLike, radius: float | None, drainage: str | None) -> FloatOrArray:
        if poroelastic.is_poroelastic(self.medium):
            return poroelastic.step(self, kind, time, radius, drainage)
        refuse_drainage(drainage)
        return step(self, kind, time, radius)

    def _rate_handle(self, law: RateAdhesion | RheologicalAdhesion, largest: float) -> Handle:
        """The library's contact with a rate, up to at least a contact radius."""
        for handle, reach in self._rates:
            if reach >= largest:
                return handle
        # another thread may keep one for a smaller radius meanwhile: this one is returned as it was made
        made = rate.sampled(self._handle, law, largest)
        self._rates[:] = [(made, largest)]
        return made

    def _states(self, name: str, given: int, values: ArrayLike, branch: str) -> State:
        states = self._solve(name, given, values, branch)
        self._reported.of(states)
        return states

    def _solve(self, name: str, given: int, values: ArrayLike, branch: str = "unloading") -> State:
        """States without a warning of large strains, as a search needs them."""
        chosen = code("branch", branch, BRANCHES)
        found = evaluate_all(name, values, lambda v: native.contact_states(self._handle, given, chosen, v))
        states = state_of(found, self)
        self._reported.one_disc(states)
        return states

    def _warn_at(self, depth: float) -> list[Caution]:
        """Report and return the warnings of the state at a depth that the library reached without a state of Python."""
        with collected() as found, contextlib.suppress(MDRError):
            self._states("depth", _layout.DEPTH, depth, "unloading")
        self._reported.report(found)
        return found


def _table(zeta: Any) -> Table:
    """Return a pair (radii, values) of the user, checked for its form; the library checks the values."""
    try:
        radii, values = zeta
    except (TypeError, ValueError) as problem:
        raise ArgumentTypeError(f'zeta = {zeta!r}: it must be a pair (radii, values) or "exact"') from problem
    pair = row("radii of zeta", radii), row("values of zeta", values)
    if len(pair[0]) != len(pair[1]):
        raise InvalidArgumentError(f"radii and values of zeta must have the same length; it is {len(pair[0])} and {len(pair[1])}")
    return pair
