# SPDX-License-Identifier: GPL-3.0-or-later
"""An indenter on a medium: states from depth, force or radius, and the fields of a state (theory 4)."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _layout, _native, critical, failure, history, interior, poroelastic, rate_adhesion, sensitivity
from ._boundary import ComplexOrArray, FloatOrArray, Handle, address, call, evaluate, evaluate_all, number, record, row
from ._value import Value
from ._warn import warn
from .adhesion import BRANCHES, RULES, Loop, PullOff, code, loop, pull_offs
from .critical import Critical
from .errors import (
    ArgumentTypeError,
    InteriorAccuracyWarning,
    InvalidArgumentError,
    LargeStrainWarning,
    MDRError,
    NoConvergenceError,
    NotOneDiscWarning,
    ShortZoneWarning,
    UnitsWarning,
)
from .failure import Failure
from .history import AdhesiveHistory, History
from .interior import Interior
from .medium import Medium
from .profile import Paraboloid, Profile
from .rate_adhesion import RateAdhesion, RateHistory, RheologicalAdhesion

__all__ = ["Contact", "State"]

_NOTICEABLE = 1e-4
"""A negative pressure of this part of the mean pressure is more than the solver's error; of the depth, an overlap."""
_DEEPER = 1.2
"""States this much deeper than those looked at before are checked for doubts."""
_BEYOND = np.geomspace(1.1, 60.0, 30)
"""Radii, in contact radii, at which the surface beyond the contact is looked at."""

Table = tuple[tuple[float, ...], tuple[float, ...]]

_WARNINGS = {
    _layout.WARNING_SLOPE: LargeStrainWarning,
    _layout.WARNING_PRESSURE: LargeStrainWarning,
    _layout.WARNING_COMPRESSION: LargeStrainWarning,
    _layout.WARNING_CONTRAST: UnitsWarning,
    _layout.WARNING_SHORT_ZONE: ShortZoneWarning,
    _layout.WARNING_WETTING: LargeStrainWarning,
}
"""Doubts about a state, in the order of the library's sentences."""
_BODIES = {"lower": 0, "upper": 1}


class State(NamedTuple):
    """States of a contact; each entry has the shape of the input, or is a float."""

    depth: FloatOrArray
    """d, indentation depth, positive into the medium [length]"""
    radius: FloatOrArray
    """a, contact radius [length]"""
    force: FloatOrArray
    """F, normal force, positive in compression [modulus length^2]"""
    stiffness: FloatOrArray
    """k = dF/dd = 2 a E_eff(a), contact stiffness [modulus length]"""
    excess: FloatOrArray = 0.0
    """depth beyond that of the non-adhesive state of this radius [length]: 0 without adhesion, less than 0 with it, the whole depth
    under a flat punch"""
    zone_radius: FloatOrArray = 0.0
    """c, outer radius of the cohesive zone [length]: the bodies pull on each other where a < r < c; 0 without a cohesive stress.
    With radius 0 they attract each other without contact"""

    def one(self, index: Any) -> State:
        """One of several states, as the fields of a contact take it: `states.one(3)`, `states.one((0, 2))`."""
        return State(*(float(np.asarray(value)[index]) for value in self))


@dataclass(frozen=True)
class Contact(Value):
    """A frictionless contact of an indenter with a medium. It never changes and may be shared between threads.

    indenter : a profile: Sphere(...), Cone(...), ...
    medium : Coated(...), Homogeneous(...), ...
    work_of_adhesion : gamma >= 0 [modulus length], J/m^2 in SI units; 0 is the contact without adhesion
    cohesive_stress : sigma >= 0 [modulus]; adhesion with a range (Dugdale, Maugis): the surfaces pull on each other with sigma
        wherever they are less than work_of_adhesion/sigma apart, in a zone around the contact. 0: a range of nothing (JKR). On
        homogeneous bodies and under the model "exact", pairs included; on a viscoelastic half-space for its `history` alone
    adhesion_rule : the edge opening, by which the springs at the edge are stretched when they let go
        "paper": sqrt(2 pi a gamma/E_eff), equation (28); "energy": sqrt(4 pi a gamma/k'(a)), the balance of energy;
        "automatic": energy for exact media, where it is exact, and the paper's rule for all others
    zeta : ratio d/g(a) of equation (9), the correction of the contact radius; None: 1, the source's approximation.
        Else a table (radii, values): at least 3 radii > 0 ascending [length], values > 0; or "exact": that of the same coated or
        layered body solved exactly, for radii up to 1000 thicknesses, so that E_eff is the only approximation left
    adhesion : a work of adhesion that depends on the speed of the edge, in place of work_of_adhesion: states are those of an edge
        at rest, and `history` follows it in time

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
    _looked_at: set[int] | None = field(init=False, repr=False, compare=False)
    _warned: list[Any] = field(init=False, repr=False, compare=False)
    """up to which depth no state needs to be looked at, then the kinds of warnings that were given"""
    _compared: dict[tuple[str | float, ...], tuple[int, float | None]] = field(init=False, repr=False, compare=False)
    """of the last body and state looked into: points so far, and their deviation on the surface once it is known"""

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
        gamma = rate_adhesion.work("work_of_adhesion", work_of_adhesion, adhesion)
        rule, sigma = code("adhesion_rule", adhesion_rule, RULES), number("cohesive_stress", cohesive_stress)
        if adhesion is not None and sigma != 0.0:
            raise InvalidArgumentError("cohesive_stress is not allowed beside adhesion=, whose edge has no range")
        is_exact = isinstance(zeta, str) and zeta == "exact"
        given: Any = zeta if zeta is None or is_exact else _table(zeta)
        columns = [np.array(column) for column in (((), ()) if is_exact or given is None else given)]
        options = record(_layout.contact_options, work_of_adhesion=gamma, adhesion_rule=rule,
                         zeta_count=len(columns[0]), zeta_radius=address(columns[0]), zeta=address(columns[1]),
                         zeta_is_exact=int(is_exact), cohesive_stress=sigma)  # fmt: skip
        handle: Any = poroelastic.NoHandle()
        if not poroelastic.is_poroelastic(medium):
            created = _native.contact_new(indenter._handle.address, medium._handle.address, address(options))
            handle = Handle(created, _native.contact_free)
        elif gamma != 0.0 or sigma != 0.0 or given is not None:
            raise InvalidArgumentError(
                "work_of_adhesion, cohesive_stress and zeta are not allowed on a gel: they belong to elastic contacts"
            )
        self._set(_handle=handle, indenter=indenter, medium=medium)
        self._set(work_of_adhesion=gamma, adhesion_rule=adhesion_rule, zeta=given, cohesive_stress=sigma)
        self._set(adhesion=adhesion, _rates=[])
        may_bend = getattr(medium, "model", None) == "exact" or _has_plate(medium)
        may_open = gamma == 0.0 and may_bend and not isinstance(indenter, Paraboloid)
        self._set(_looked_at=set() if may_open else None, _warned=[-math.inf], _compared={})

    def at_depth(self, depth: ArrayLike, branch: str = "unloading") -> State:
        """The stable states at indentation depths d >= 0 [length], any shape; with adhesion down to the pull-off depth.

        branch : where an adhesive contact has several stable states, the one met on "loading" (the smallest contact, d >= 0) or
            kept on "unloading" (the largest)
        """
        return self._states("depth", _layout.GIVEN_DEPTH, depth, branch)

    def at_force(self, force: ArrayLike, branch: str = "unloading") -> State:
        """The stable states under normal forces F >= 0 [modulus length^2], any shape; with adhesion down to the pull-off force.

        branch : as in `at_depth`
        """
        return self._states("force", _layout.GIVEN_FORCE, force, branch)

    def at_radius(self, radius: ArrayLike) -> State:
        """The states of equilibrium at contact radii a >= 0 [length], any shape; with adhesion they may be unstable.

        A radius at a vertical wall (flat punch) determines no state.
        """
        return self._states("radius", _layout.GIVEN_RADIUS, radius, "unloading")

    def history(
        self,
        time: ArrayLike,
        *,
        depth: ArrayLike | None = None,
        force: ArrayLike | None = None,
        radius: ArrayLike | None = None,
        position: ArrayLike | None = None,
        spring_stiffness: float | None = None,
        start: str | Mapping[str, float] = "apart",
        tolerance: float | None = None,
        progress: bool = False,
        drainage: str | None = None,
    ) -> History | RateHistory | AdhesiveHistory:
        """The path in time of a contact with a viscoelastic or poroelastic body, or of one whose `adhesion` depends on speed: one
        of depth, force, radius and position is prescribed.

        time : strictly ascending, one dimension [time]; before the first the bodies are apart and at rest
        depth, force, radius : one of them, as many values; linear in time in between, the first value is reached in a jump.
            Depths may be negative where the bodies are apart

        tolerance : where steps in time are taken, relative to the largest depth, radius and force, 1e-9 to 1e-2, default 1e-5; with
            `adhesion` of ln(radius) in each step, 1e-12 to 1e-3, default 1e-9
        progress : show a bar on a terminal where the march takes more than two seconds

        Bodies whose materials relax in proportion, each at a constant Poisson's ratio (a layer on a rigid base), and homogeneous
        ones follow from elastic curves to rounding: Lee and Radok (1960) while the contact grows, Ting (1966) after the largest
        depth. Any other body or path, as a contact that shrinks and grows again, is marched through time with the memory of all
        layers, under the model "exact" and unless a dashpot is in parallel at the surface.

        drainage : of a gel, and only of one, see `relaxation`. A flat punch may follow any path of depth or force, exactly; tension
            is taken as it comes. A paraboloid is pressed in at once and held at one contact radius, `radius` a constant. Its true
            contact grows by up to 9 % and comes back: at "indenter" its force then differs by up to 0.05 of the part that relaxes

        With a `cohesive_stress` on a viscoelastic half-space the result is an `AdhesiveHistory`: each place of the surface
        remembers what it bore, and contact and zone move over it. position, spring_stiffness, and start "apart" or "rest" (relaxed)
        as below; tolerance of the force, relative to its largest, 1e-7 to 1e-2, default 1e-4. Layers are refused

        With `adhesion`, on an elastic body (of a viscoelastic one the relaxed moduli), the result is a `RateHistory`:

        position, spring_stiffness : the far end of a spring that presses the indenter, d + F/spring_stiffness [length], in place of
            depth or force, and its stiffness > 0 [modulus length]
        start : "apart" before the first time; "rest": in equilibrium with the first value, the largest stable one; or the `end` of
            a history that this one continues, whose last time and value are the first of this one. A dict with "radius" alone
            begins at that contact radius
        """
        if self.adhesion is not None:
            history.refuse_drainage(drainage)
            if radius is not None:
                raise ArgumentTypeError("radius is not allowed with adhesion=: it follows from position, depth or force")
            given = {"position": position, "depth": depth, "force": force}
            return rate_adhesion.history(self, time, given, spring_stiffness, start, tolerance, progress)
        if self.cohesive_stress > 0.0:
            history.refuse_drainage(drainage)
            if radius is not None:
                raise ArgumentTypeError("radius is not allowed with adhesion: it follows from position, depth or force")
            given = {"position": position, "depth": depth, "force": force}
            return history.adhesive_history(self._handle.address, time, given, spring_stiffness, start, tolerance, progress)
        if position is not None or spring_stiffness is not None or start != "apart":
            raise ArgumentTypeError("position, spring_stiffness and start belong to contacts with adhesion= or a cohesive_stress")
        tolerance = 1e-5 if tolerance is None else tolerance
        if poroelastic.is_poroelastic(self.medium):
            return History(*poroelastic.history(self, time, depth, force, radius, drainage))
        history.refuse_drainage(drainage)
        return history.history(self._handle.address, time, depth, force, radius, tolerance, progress)

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
        history.refuse_drainage(drainage)
        return history.dynamic_stiffness(self, omega, radius, depth, force)

    def relaxation(self, time: ArrayLike, radius: float | None = None, drainage: str | None = None) -> FloatOrArray:
        """Force per depth [modulus length] at times > 0 after a step of the depth, the contact radius being held: a flat punch,
        whose radius need not be given.

        drainage : of a gel, which takes time 0 too, and only of one: "surface", the whole surface drains, under the indenter too,
            which is porous; "sealed", no flux anywhere; "indenter", no flux under the indenter, drained beside it, on a half-space
            only. There is no default: it matters more than anything else
        """
        return history.step(self, _layout.STEP_RELAXATION, time, radius, drainage)

    def creep(self, time: ArrayLike, radius: float | None = None, drainage: str | None = None) -> FloatOrArray:
        """Depth per force [1/(modulus length)] at times > 0 after a step of the force. Arguments as of `relaxation`."""
        return history.step(self, _layout.STEP_CREEP, time, radius, drainage)

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

        kind : "total", what the indenter bears, or "pore", that of the fluid at the surface, on a half-space only
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

    def pressure(
        self,
        r: ArrayLike,
        state: State | None = None,
        *,
        depth: float | None = None,
        force: float | None = None,
        radius: float | None = None,
        branch: str = "unloading",
    ) -> FloatOrArray:
        """Contact pressure p(r) [modulus], equation (6), at 0 <= r <= a, any shape, of one state: one that `at_depth` and the like
        gave, or the one with this depth, force or radius.

        Infinite where theory says so: at the edge of a flat punch, at the apex of a cone; minus infinity at an adhesive edge.
        With a cohesive stress sigma r goes up to the zone's end c; p is finite at a and -sigma where a < r < c.
        branch : which state of that depth or force, as in `at_depth`
        """
        return self._field(_layout.FIELD_PRESSURE, "r", r, state, depth, force, radius, branch)

    def displacement(
        self,
        r: ArrayLike,
        state: State | None = None,
        *,
        depth: float | None = None,
        force: float | None = None,
        radius: float | None = None,
        branch: str = "unloading",
        body: str | None = None,
    ) -> FloatOrArray:
        """Surface displacement u(r) [length], positive into the medium, at r >= 0, any shape, of one state. Inside the contact it
        is d - f(r), outside it is the free surface, with the neck of an adhesive contact. Arguments as of `pressure`.

        body : of two deformable bodies (`Pair`) "lower" or "upper", each positive into its own body; None: their sum. u(0) of
            each is its part of the approach. Where the lower surface was flat, "lower" is the shape of the interface for r <= a
        """
        field = _layout.FIELD_DISPLACEMENT
        if body is not None:
            field = (_layout.FIELD_DISPLACEMENT_LOWER, _layout.FIELD_DISPLACEMENT_UPPER)[code("body", body, _BODIES)]
        return self._field(field, "r", r, state, depth, force, radius, branch)

    def elastic_energy(
        self,
        state: State | None = None,
        *,
        depth: float | None = None,
        force: float | None = None,
        radius: float | None = None,
        branch: str = "unloading",
        body: str | None = None,
    ) -> float:
        """Elastic energy [modulus length^3] of one state: the work of the force from first touch; with adhesion the energy
        gained by the surfaces, pi a^2 work_of_adhesion, comes on top. Arguments as of `displacement`; body=None: of both. With a
        cohesive stress the energy of the zone is int (sigma h - gamma) over it, h its gap."""
        energies = call(_native.contact_energy, self._handle.address, self._row(state, depth, force, radius, branch))
        return float(sum(energies) if body is None else energies[code("body", body, _BODIES)])

    def line_load(
        self,
        x: ArrayLike,
        state: State | None = None,
        *,
        depth: float | None = None,
        force: float | None = None,
        radius: float | None = None,
        branch: str = "unloading",
    ) -> FloatOrArray:
        """Line load q(x) [modulus length] of the one-dimensional springs, equations (5), (21), at 0 <= x <= a, or up to
        the end of a cohesive zone, any shape, of one state. Arguments as of `pressure`."""
        return self._field(_layout.FIELD_LINE_LOAD, "x", x, state, depth, force, radius, branch)

    def lowest_pressure(self, state: State) -> tuple[float, float]:
        """The smallest p(r) [modulus] of one state without adhesion, and its r [length]: 0, at the edge, where none is negative.
        Below 0 the contact is not one disc and its pressure not that of the true contact (see `NotOneDiscWarning`)."""
        pressure, r = call(_native.contact_lowest_pressure, self._handle.address, self._one(state))
        return float(pressure), float(r)

    def gradient(self, state: State) -> dict[str, float]:
        """dF/dp at the depth of one state, for the constants p of the bodies and R of a paraboloid: by reciprocity, exact, without
        solving a contact again; for fits, design and propagation of errors. At a given force the depth changes by -dF/dp/k.

        The names are those of `medium.parameters()`: "E", "nu" of a homogeneous body; "coating.E", "coating.C44", "thickness",
        "substrate.nu"; "layers[0].E", "layers[0].prestress", "layers[0].interface.normal" and so on, but for those that are 0; and
        "radius". Of homogeneous, coated and layered elastic bodies under the model "exact", without adhesion, up to contact radii
        of 100 thicknesses of the top layer; all else is refused (InvalidArgumentError), and indenters whose line load has kinks
        (NoConvergenceError).
        """
        return sensitivity.gradient(self, state)

    def warnings(self, state: State) -> tuple[str, ...]:
        """Doubts about the numbers of one state: slopes and strains that are not small, moduli in two units; empty where
        nothing does. States are looked at as they are made, and a `LargeStrainWarning` and a `UnitsWarning` are given once for each
        contact."""
        return tuple(self._cautions(state)[1])

    def interior(
        self,
        r: ArrayLike,
        z: ArrayLike,
        state: State,
        body: str = "lower",
        side: str = "below",
        friction: float = 0.0,
        angle: ArrayLike = 0.0,
    ) -> Interior:
        """Displacements and stresses inside a homogeneous, coated, layered or graded body.

        r, z : distance from the axis and depth into the body, >= 0 [length], any shapes that broadcast; grids of few distinct r and
            z, as r[:, None] and z[None, :], cost far less than as many scattered points
        state : one state of this contact, as `at_force` and the like give
        body : "lower", or "upper" of two deformable bodies
        side : at an interface s_rr, s_tt and s_rt jump: the values "below" it (larger z) or "above"
        friction : f >= 0; the contact slides with traction f p(r) in +x on the lower body and -f p(r) on the upper one, p being
            that of the contact without friction (Goodman); not with adhesion
        angle : azimuth of the points from +x [radian]

        Infinite where theory says so: on the surface at the edge of a flat punch or an adhesive contact, at the apex of a cone, at
        the edge of a flat end. Under an approximate model it is the field in the body under the model's own pressure, whose surface
        does not fit the indenter. Graded bodies take up to some seconds for each 64 depths.

        The field of a state is compared with the contact's pressure and displacement on the surface, once it was given at 1000
        points: an `InteriorAccuracyWarning` where it deviates by more than 1e-8 and 10 times the medium's tolerance, refused
        beyond 1e-3.
        """
        row = self._one(state)
        found = interior.interior(self._handle.address, r, z, row, body, side, friction, angle)
        self._compare(body, row, np.size(found.s_zz))
        return found

    def critical(self, state: State, body: str = "lower", friction: float = 0.0) -> Critical:
        """What decides whether a coating cracks, yields or peels: the largest stresses in each layer, at the surface outside the
        contact and at each interface, where they are, and the elastic energy of each layer. Arguments as of `interior`; with
        friction in the plane of sliding."""
        return critical.critical(self, state, body, friction)

    def first_failure(
        self,
        strengths: Mapping[str, Sequence[float | None]],
        body: str = "lower",
        friction: float = 0.0,
        largest_radius: float | None = None,
    ) -> tuple[Failure, ...]:
        """The states at which given strengths are first reached as the load grows, the first one first.

        strengths : what the layers and interfaces bear [modulus], one number each from the surface down, None where no failure is
            looked for: "yield" (von Mises stress) and "tension" (principal stress) of each layer, the half-space last;
            "interface shear" and "interface tension" of each interface
        largest_radius : how far to look [length]; default: 30 times the thickness of all layers, as far as the contact is defined

        A strength that is not reached, or only at the singular edge of a punch or an adhesive contact, has no entry; one that is
        reached at any load, as under a sharp tip, has that of the smallest contact looked at and `at_once`.
        """
        return failure.first_failure(self, strengths, body, friction, largest_radius)

    def _rate_handle(self, law: RateAdhesion | RheologicalAdhesion, largest: float) -> Handle:
        """The library's contact with a rate, up to at least a contact radius."""
        kept = self._rates
        if not kept or kept[-1][1] < largest:
            kept[:] = [(rate_adhesion.sampled(self._handle, law, largest), largest)]
        return kept[0][0]

    def _one(self, state: State | None) -> list[float]:
        """One state as the library takes it."""
        if not isinstance(state, State):
            raise ArgumentTypeError(f"state = {state!r} is not allowed: it must be a State; a radius is given as radius=...")
        return [number(f"{member} of the state", value) for member, value in zip(state._fields, state, strict=True)]

    def _states(self, name: str, given: int, values: ArrayLike, branch: str) -> State:
        states = self._solve(name, given, values, branch)
        depth = states.depth
        deepest = depth if isinstance(depth, float) else depth.max(initial=-math.inf)
        if deepest > self._warned[0]:
            self._warn_of(states)
        return states

    def _solve(self, name: str, given: int, values: ArrayLike, branch: str = "unloading") -> State:
        """States without a warning of large strains, as a search needs them."""
        chosen = code("branch", branch, BRANCHES)
        states = State(*evaluate_all(name, values, lambda v: _native.contact_states(self._handle.address, given, chosen, v)))
        if self._looked_at is not None:
            self._look_at(states)
        return states

    def _silent(self) -> Contact:
        """Itself, which gives no such warnings any more: a contact in units of its own, that no user sees."""
        self._warned[0] = math.inf
        return self

    def _warn_of(self, states: State) -> None:
        """Gives a warning of each kind that was not given yet, of the deepest of the states."""
        one = isinstance(states.depth, float)
        deepest = states if one else states.one(np.unravel_index(np.argmax(states.depth), np.shape(states.depth)))
        self._warned[0] = max(_DEEPER * float(deepest.depth), 0.0)
        codes, texts = self._cautions(deepest)
        for code_of, text in zip(codes, texts, strict=True):
            kind = _WARNINGS[code_of]
            if kind not in self._warned:
                self._warned.append(kind)
                warn(text, kind)

    def _warn_at(self, depth: float) -> None:
        """Looks at the state of a depth that the library reached without a state of Python's."""
        with contextlib.suppress(MDRError):
            self._states("depth", _layout.GIVEN_DEPTH, depth, "unloading")

    def _cautions(self, state: State) -> tuple[list[int], list[str]]:
        """Codes and texts of the doubts about one state."""
        buffer = np.zeros(1000, np.uint8)
        found = call(_native.contact_warnings, self._handle.address, self._one(state), address(buffer), buffer.size)
        return [code for code in _WARNINGS if found & code], bytes(buffer).rstrip(b"\0").decode().splitlines()

    def _compare(self, body: str, row: list[float], points: int) -> None:
        """Warns of a field inside that deviates from the surface of its contact, or refuses it."""
        key: tuple[str | float, ...] = (body, *row)
        so_far, deviation = self._compared.get(key, (0, None))
        if deviation is None:
            so_far += points
            if so_far >= interior.ENOUGH_POINTS:
                deviation = interior.deviation(self._handle.address, row, body)
            self._compared.clear()
            self._compared[key] = so_far, deviation
        if deviation is None or deviation <= max(interior.USUAL, interior.TOLERANCES * self.medium._tolerance()):
            return
        text = (
            f"displacements and stresses inside are off by about {deviation:.1e} of the depth and of the largest pressure: by that "
            "they differ on the surface from the displacement and the pressure of the contact"
        )
        if deviation > interior.WRONG:
            raise NoConvergenceError(text)
        if InteriorAccuracyWarning not in self._warned:
            self._warned.append(InteriorAccuracyWarning)
            warn(text, InteriorAccuracyWarning)

    def _look_at(self, states: State) -> None:
        """Warns where the contact is not one disc: looks at the largest of the states and at some smaller ones, at a radius of
        about the same size only once."""
        columns = np.array([np.ravel(column) for column in np.broadcast_arrays(*states)])
        order = np.argsort(columns[1])
        for place in order[[-1, len(order) // 2, len(order) // 4]] if len(order) else ():
            row = columns[:, place]
            size = round(4.0 * math.log2(row[1])) if row[1] > 0.0 else None
            if size is None or self._looked_at is None or size in self._looked_at:
                continue
            self._looked_at.add(size)
            fault = self._fault(State(*(float(value) for value in row)))
            if fault:
                self._set(_looked_at=None)
                off = (
                    "nor are depth and force: a plate does not follow a tip or a flank that no plate can take the shape of"
                    if _has_plate(self.medium)
                    else "F(d) is off by at most a few per cent where the coating is up to 200 times stiffer than the body"
                )
                warn(
                    f"this contact is not one disc: {fault} (contact radius {row[1]:.3g}). Its pressure is not that of the true "
                    f"contact; {off}",
                    NotOneDiscWarning,
                )
                return

    def _fault(self, state: State) -> str:
        """Where the one disc of a state pulls, or the surface beyond it passes through the indenter; empty if neither."""
        try:
            pressure, r = self.lowest_pressure(state)
            if pressure * math.pi * float(state.radius) ** 2 < -_NOTICEABLE * float(state.force):
                return f"without adhesion its pressure would be {pressure:.3g} at r = {r:.3g}"
            beyond = float(state.radius) * _BEYOND
            gap = np.asarray(self.displacement(beyond, state) - state.depth + self.indenter.height(beyond))
        except MDRError:
            return ""
        place = int(np.argmin(gap))
        if gap[place] >= -_NOTICEABLE * float(state.depth):
            return ""
        return f"the surface beyond it would pass through the indenter, by {-gap[place]:.3g} at r = {beyond[place]:.3g}"

    def _field(
        self,
        field: int,
        name: str,
        points: ArrayLike,
        state: State | None,
        depth: float | None,
        force: float | None,
        radius: float | None,
        branch: str,
    ) -> FloatOrArray:
        row = self._row(state, depth, force, radius, branch)
        return evaluate(name, points, lambda r: _native.contact_field(self._handle.address, field, row, r))

    def _row(self, state: State | None, depth: float | None, force: float | None, radius: float | None, branch: str) -> list[float]:
        """The numbers of the one state that is meant."""
        if sum(value is not None for value in (state, depth, force, radius)) != 1:
            raise ArgumentTypeError("a field or an energy needs one of state, depth, force and radius, and not more")
        if depth is not None:
            state = self.at_depth(number("depth", depth), branch)
        elif force is not None:
            state = self.at_force(number("force", force), branch)
        elif radius is not None:
            state = self.at_radius(number("radius", radius))
        return self._one(state)


def _has_plate(medium: Medium) -> bool:
    """Whether its surface carries a plate."""
    return getattr(getattr(medium, "surface", None), "bending", 0.0) > 0.0


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
