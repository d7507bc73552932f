# SPDX-License-Identifier: GPL-3.0-or-later
"""An indenter on a medium: its states from depth, force or radius, its cycles and histories (theory/paper.md (4.1), (4.2))."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _layout, failure, poroelastic
from ._boundary import ComplexOrArray, FloatOrArray, Handle, evaluate_all, native, number, record, row
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
from .state import State, state_of
from .time import History, dynamic_stiffness, history, refuse_drainage, step

__all__ = ["Contact", "State"]

Table = tuple[tuple[float, ...], tuple[float, ...]]


@dataclass(frozen=True)
class Contact(Value):
    """A frictionless contact of an indenter with a medium. It never changes and may be shared between threads.

    indenter : a profile: Sphere(...), Cone(...), ...
    medium : Coated(...), Homogeneous(...), ...
    work_of_adhesion : gamma >= 0 [modulus length], J/m^2 in SI units; 0 is the contact without adhesion
    cohesive_stress : sigma >= 0 [modulus]; adhesion with a range (Dugdale, Maugis): the surfaces pull on each other with sigma
        wherever they are less than work_of_adhesion/sigma apart, in a zone around the contact. 0: a range of nothing (JKR). On
        homogeneous bodies and under the model "exact", pairs included; on a viscoelastic half-space for
        `adhesion.adhesive_history` alone
    adhesion_rule : the edge opening, by which the springs at the edge are stretched when they let go
        "paper": sqrt(2 pi a gamma/E_eff), equation (28); "energy": sqrt(4 pi a gamma/k'(a)), the balance of energy;
        "automatic": energy for exact media, where it is exact, and the paper's rule for all others
    zeta : ratio d/g(a) of equation (9), the correction of the contact radius; None: 1, the source's approximation.
        Else a table (radii, values): at least 3 radii > 0 ascending [length], values > 0; or "exact": that of the same coated or
        layered body solved exactly, for radii up to 1000 thicknesses, so that E_eff is the only approximation left
    adhesion : a work of adhesion that depends on the speed of the edge, in place of work_of_adhesion: states are those of an edge
        at rest, and `adhesion.rate_history` follows it in time

    Arrays may be shared out among several threads, see `set_threads`.
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
    """what the user has read about it, which changes nothing that it answers"""

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
            raise ArgumentTypeError(f"indenter = {indenter!r} is not allowed: it must be an indenter profile")
        if not isinstance(medium, Medium):
            raise ArgumentTypeError(f"medium = {medium!r} is not allowed: it must be a medium")
        gamma = rate.work("work_of_adhesion", work_of_adhesion, adhesion)
        rule, sigma = code("adhesion_rule", adhesion_rule, RULES), number("cohesive_stress", cohesive_stress)
        if adhesion is not None and sigma != 0.0:
            raise InvalidArgumentError("cohesive_stress is not allowed beside adhesion=, whose edge has no range")
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
            raise InvalidArgumentError(
                "work_of_adhesion, cohesive_stress and zeta are not allowed on a gel: they belong to elastic contacts"
            )
        self._set(_handle=handle, indenter=indenter, medium=medium)
        self._set(work_of_adhesion=gamma, adhesion_rule=adhesion_rule, zeta=given, cohesive_stress=sigma)
        self._set(adhesion=adhesion, _rates=[])
        self._set(_doubts=StateWarnings(self), _reported=Reported())

    def at_depth(self, depth: ArrayLike, branch: str = "unloading") -> State:
        """The stable states at indentation depths d >= 0 [length], any shape; with adhesion down to the pull-off depth.

        branch : where an adhesive contact has several stable states, the one met on "loading" (the smallest contact, d >= 0) or
            kept on "unloading" (the largest)
        """
        return self._states("depth", _layout.DEPTH, depth, branch)

    def at_force(self, force: ArrayLike, branch: str = "unloading") -> State:
        """The stable states under normal forces F >= 0 [modulus length^2], any shape; with adhesion down to the pull-off force.

        branch : as in `at_depth`
        """
        return self._states("force", _layout.FORCE, force, branch)

    def at_radius(self, radius: ArrayLike) -> State:
        """The states of equilibrium at contact radii a >= 0 [length], any shape; with adhesion they may be unstable.

        A radius at a vertical wall (flat punch) determines no state.
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
        """The path in time of a contact with a viscoelastic body: one of depth, force and radius is prescribed.

        time : strictly ascending, one dimension [time]; before the first the bodies are apart and at rest
        depth, force, radius : one of them, as many values; linear in time in between, the first value is reached in a jump.
            Depths may be negative where the bodies are apart

        tolerance : where steps in time are taken, relative to the largest depth, radius and force, 1e-9 to 1e-2
        progress : True shows a bar on a terminal where the march takes more than two seconds; a `Progress` follows each round

        Bodies whose materials relax in proportion, each at a constant Poisson's ratio (a layer on a rigid base), and homogeneous
        ones follow from elastic curves to rounding: Lee and Radok (1960) while the contact grows, Ting (1966) after the largest
        depth. Any other body or path, as a contact that shrinks and grows again, is marched through time with the memory of all
        layers, under the model "exact" and unless a dashpot is in parallel at the surface.

        Gels follow a path by `mdrcontact.poroelastic.history`, contacts with `adhesion` by `mdrcontact.adhesion.rate_history`,
        those with a `cohesive_stress` by `mdrcontact.adhesion.adhesive_history`.
        """
        if self.adhesion is not None:
            raise InvalidArgumentError("adhesion is not allowed here: call mdrcontact.adhesion.rate_history(contact, ...)")
        if self.cohesive_stress > 0.0:
            raise InvalidArgumentError(
                "cohesive_stress is not allowed here: call mdrcontact.adhesion.adhesive_history(contact, ...)"
            )
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
        """The dynamic stiffness k* = k' + i k'' [modulus length] of a viscoelastic body at angular frequencies omega [1/time]:
        k' stores, k'' loses energy, pi k'' times the amplitude squared in each cycle, and k''/k' is tan delta.

        omega, radius, depth, force : of shapes that broadcast. The contact oscillates by little about one of them: a radius, or the
            state of the relaxed body at a depth or force, as after a long hold; none for a flat punch

        Exact for any materials, power laws included, under the model "exact"; under other models for materials that relax in
        proportion. Each new frequency of a layered body costs two kernels, further radii at the same one little.
        """
        if poroelastic.is_poroelastic(self.medium):
            if depth is not None or force is not None:
                raise ArgumentTypeError("depth and force are not allowed on a gel: give the contact radius, radius=")
            return poroelastic.dynamic_stiffness(self, omega, radius, drainage)  # type: ignore[arg-type]
        refuse_drainage(drainage)
        return dynamic_stiffness(self, omega, radius, depth, force)

    def relaxation(self, time: ArrayLike, radius: float | None = None, drainage: str | None = None) -> FloatOrArray:
        """Force per depth [modulus length] at times > 0 after a step of the depth, the contact radius being held: a flat punch,
        whose radius need not be given.

        drainage : of a gel, which takes time 0 too, and only of one: "surface", the whole surface drains, under the indenter too,
            which is porous; "sealed", no flux anywhere; "indenter", no flux under the indenter, drained beside it, on a half-space
            only. There is no default: it matters more than anything else
        """
        return self._step(_layout.RELAXATION, time, radius, drainage)

    def creep(self, time: ArrayLike, radius: float | None = None, drainage: str | None = None) -> FloatOrArray:
        """Depth per force [1/(modulus length)] at times > 0 after a step of the force. Arguments as of `relaxation`."""
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
        """Pressure [modulus] at 0 <= r < a, any shape, under an indenter that was pressed into a gel at once, a time before, its
        contact radius being held.

        kind : "total_pressure", what the indenter bears, or "pore_pressure", that of the fluid at the surface, on a half-space only
        time : since the step, D t/a^2 >= 1e-5 [time]
        depth : that of a flat punch's step [length]
        radius : the held contact radius of a Paraboloid, whose depth it determines [length]
        drainage : as of `relaxation`
        """
        return poroelastic.pressure(self, kind, r, time, depth, radius, drainage)

    def pull_off(self, control: str = "force") -> PullOff:
        """Where an adhesive contact breaks when it is drawn apart under a prescribed "force" or "depth".

        It is the global minimum over the whole branch; `.others` are the ends of the other stable segments. All 0 without
        adhesion. A contact that is still stable at the smallest radius of a tabulated medium raises DomainError.
        """
        return pull_offs(self, control)

    def loop(self, control: str, largest: float, points: int = 200, *, spring_stiffness: float | None = None) -> Loop:
        """A cycle of approach and retraction, with its jumps and the energy lost.

        control : what the machine prescribes: "force", "depth", or the far end of a "spring" such as an
            AFM cantilever
        largest : where the motion turns back, > 0 [length, or modulus length^2 under force control]
        points : points on each way, at least 2; jumps and their ends come on top
        spring_stiffness : > 0 [modulus length], for "spring" only
        """
        return loop(self, control, largest, points, spring_stiffness)

    def first_failure(
        self,
        strengths: Mapping[str, Sequence[float | None]],
        body: str = "lower",
        friction: float = 0.0,
        largest_radius: float | None = None,
    ) -> tuple[Failure, ...]:
        """The states at which given strengths are first reached as the load grows, the first one first.

        strengths : what the layers and interfaces bear [modulus], one number each from the surface down, None where no failure is
            looked for: "von_mises" (a yield stress) and "tension" (principal stress) of each layer, the half-space last;
            "interface_shear" and "interface_tension" of each interface
        largest_radius : how far to look [length]; default: 30 times the thickness of all layers, as far as the contact is defined

        A strength that is not reached, or only at the singular edge of a punch or an adhesive contact, has no entry; one that is
        reached at any load, as under a sharp tip, has that of the smallest contact looked at and `at_once`.
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
        """Warns of the state of a depth that the library reached without a state of Python's, whose doubts it returns."""
        with collected() as found, contextlib.suppress(MDRError):
            self._states("depth", _layout.DEPTH, depth, "unloading")
        self._reported.report(found)
        return found


def _table(zeta: Any) -> Table:
    """A user's pair (radii, values), checked for its form; the values are the library's business."""
    try:
        radii, values = zeta
    except (TypeError, ValueError) as problem:
        raise ArgumentTypeError(f'zeta = {zeta!r} is not allowed: it must be a pair (radii, values) or "exact"') from problem
    pair = row("radii of zeta", radii), row("values of zeta", values)
    if len(pair[0]) != len(pair[1]):
        raise InvalidArgumentError(f"radii and values of zeta must have the same length; it is {len(pair[0])} and {len(pair[1])}")
    return pair
