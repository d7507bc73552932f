# SPDX-License-Identifier: GPL-3.0-or-later
"""An indenter on a medium: states from depth, force or radius, and the fields of a state (theory 4)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

from numpy.typing import ArrayLike

from . import _native, _zeta, adhesion
from ._boundary import FloatOrArray, Handle, evaluate, evaluate_all, number, thread_count
from ._value import Value
from .adhesion import BRANCHES, RULES, Loop, PullOff
from .errors import ArgumentTypeError, UnreachableError
from .medium import Medium
from .profile import Profile

__all__ = ["Contact", "State"]


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


@dataclass(frozen=True)
class Contact(Value):
    """A frictionless contact of an indenter with a medium. It never changes and may be shared between threads.

    indenter : a profile: Sphere(...), Cone(...), ...
    medium : Coated(...), Homogeneous(...), ...
    work_of_adhesion : gamma >= 0 [modulus length], J/m^2 in SI units; 0 is the contact without adhesion
    adhesion_rule : how far the springs at the edge hang
        "paper": sqrt(2 pi a gamma/E_eff), equation (28); "energy": sqrt(4 pi a gamma/k'(a)), the balance of energy;
        "automatic": energy for exact media, where it is exact, and the paper's rule for all others
    zeta : ratio d/g(a) of equation (9), the correction of the contact radius; None: 1, the source's approximation.
        Else a table (radii, values): at least 3 radii > 0 ascending [length], values > 0; or "exact": that of the same coated or
        layered body solved exactly, for radii up to 1000 thicknesses, so that E_eff is the only approximation left

    Whatever takes arrays takes `threads`, here and everywhere in the package: how many threads share the work, 0 for as
    many as OpenMP offers. Arrays too small to gain stay on one; the numbers are the same to the last bit for any of them.
    """

    indenter: Profile
    medium: Medium
    work_of_adhesion: float
    adhesion_rule: str
    zeta: _zeta.Table | str | None

    def __init__(
        self,
        indenter: Profile,
        medium: Medium,
        work_of_adhesion: float = 0.0,
        adhesion_rule: str = "automatic",
        zeta: tuple[ArrayLike, ArrayLike] | str | None = None,
    ) -> None:
        if not isinstance(indenter, Profile):
            raise ArgumentTypeError(f"indenter = {indenter!r} is not allowed: it must be an indenter profile")
        if not isinstance(medium, Medium):
            raise ArgumentTypeError(f"medium = {medium!r} is not allowed: it must be a medium")
        gamma, rule = number("work_of_adhesion", work_of_adhesion), adhesion.code("adhesion_rule", adhesion_rule, RULES)
        given: Any = zeta if zeta is None or isinstance(zeta, str) and zeta == "exact" else _zeta.table(zeta)
        table = _zeta.exact(indenter, medium, Contact) if isinstance(given, str) else given
        # without zeta the table is one unused entry
        native_table = (0, [1.0], [1.0]) if table is None else (len(table[0]), *table)
        created = _native.contact_new(indenter._handle.address, medium._handle.address, *native_table, gamma, rule)
        self._set(_handle=Handle(created, _native.contact_free), indenter=indenter, medium=medium)
        self._set(work_of_adhesion=gamma, adhesion_rule=adhesion_rule, zeta=given)

    def at_depth(self, depth: ArrayLike, branch: str = "unloading", *, threads: int = 1) -> State:
        """The stable states at indentation depths d >= 0 [length], any shape; with adhesion down to the pull-off depth.

        branch : where an adhesive contact has several stable states, the one met on "loading" (the smallest contact, d >= 0) or
            kept on "unloading" (the largest)
        """
        return self._states(_native.contact_from_depth, threads, "depth", depth, adhesion.code("branch", branch, BRANCHES))

    def at_force(self, force: ArrayLike, branch: str = "unloading", *, threads: int = 1) -> State:
        """The stable states under normal forces F >= 0 [modulus length^2], any shape; with adhesion down to the pull-off force.

        branch : as in `at_depth`
        """
        return self._states(_native.contact_from_force, threads, "force", force, adhesion.code("branch", branch, BRANCHES))

    def at_radius(self, radius: ArrayLike, *, threads: int = 1) -> State:
        """The states of equilibrium at contact radii a >= 0 [length], any shape; with adhesion they may be unstable.

        A radius at a vertical wall (flat punch) determines no state.
        """
        return self._states(_native.contact_from_radius, threads, "radius", radius)

    def pull_off(self, control: str = "force") -> PullOff:
        """Where an adhesive contact breaks when it is drawn apart under a prescribed "force" or "displacement" (the depth d).

        It is the global minimum over the whole branch; `.others` are the ends of the other stable stretches. All 0 without
        adhesion. A contact that is still stable at the smallest radius of a tabulated medium raises DomainError.
        """
        return adhesion.pull_offs(self, control)

    def loop(self, control: str, largest: float, points: int = 200, *, spring_stiffness: float | None = None) -> Loop:
        """A cycle of approach and retraction, with its jumps and the energy lost.

        control : what the machine prescribes: "force", "displacement" (the depth d), or the far end of a "spring" such as an
            AFM cantilever
        largest : where the motion turns back, > 0 [length, or modulus length^2 under force control]
        points : points on each way, at least 2; jumps and their ends come on top
        spring_stiffness : > 0 [modulus length], for "spring" only
        """
        return adhesion.loop(self, control, largest, points, spring_stiffness)

    def pressure(
        self,
        r: ArrayLike,
        radius: float | None = None,
        *,
        depth: float | None = None,
        force: float | None = None,
        branch: str = "unloading",
        threads: int = 1,
    ) -> FloatOrArray:
        """Contact pressure p(r) [modulus], equation (6), at 0 <= r <= a, any shape; of the state given by radius, depth or force.

        Infinite where theory says so: at the edge of a flat punch, at the apex of a cone; minus infinity at an adhesive edge.
        branch : which state of that depth or force, as in `at_depth`
        """
        return self._field("pressure", "r", r, radius, depth, force, branch, threads)

    def displacement(
        self,
        r: ArrayLike,
        radius: float | None = None,
        *,
        depth: float | None = None,
        force: float | None = None,
        branch: str = "unloading",
        threads: int = 1,
    ) -> FloatOrArray:
        """Surface displacement u(r) [length], positive into the medium, at r >= 0, any shape; of the state given by radius,
        depth or force. Inside the contact it is d - f(r), outside it is the free surface, with the neck of an adhesive contact.

        branch : as in `pressure`
        """
        return self._field("displacement", "r", r, radius, depth, force, branch, threads)

    def line_load(
        self,
        x: ArrayLike,
        radius: float | None = None,
        *,
        depth: float | None = None,
        force: float | None = None,
        branch: str = "unloading",
        threads: int = 1,
    ) -> FloatOrArray:
        """Line load q(x) [modulus length] of the one-dimensional springs, equations (5), (21), at 0 <= x <= a, any shape; of the
        state given by radius, depth or force.

        branch : as in `pressure`
        """
        return self._field("line_load", "x", x, radius, depth, force, branch, threads)

    def _states(self, function: Callable[..., Any], threads: int, name: str, values: ArrayLike, *branch: int) -> State:
        return State(*evaluate_all(function, thread_count(threads), self._handle.address, *branch, name=name, values=values))

    def _field(
        self,
        field: str,
        name: str,
        points: ArrayLike,
        radius: float | None,
        depth: float | None,
        force: float | None,
        branch: str,
        threads: int,
    ) -> FloatOrArray:
        if sum(value is not None for value in (radius, depth, force)) != 1:
            raise ArgumentTypeError(f"{field} needs one of radius, depth and force, and not more")
        if force is not None:
            state = self.at_force(number("force", force), branch)
            radius, depth = self._by_radius_or_depth(state)
        elif depth is not None and (self.work_of_adhesion > 0.0 or branch != "unloading"):
            radius, depth = self._by_radius_or_depth(self.at_depth(number("depth", depth), branch))
        if depth is not None:
            function, at = getattr(_native, f"contact_{field}_at_depth"), number("depth", depth)
        else:
            function, at = getattr(_native, f"contact_{field}"), number("radius", radius)
        return evaluate(function, thread_count(threads), self._handle.address, at, name=name, values=points)

    def _by_radius_or_depth(self, state: State) -> tuple[float | None, float | None]:
        """What determines a state: its depth where the largest contact of this depth is meant, else its radius."""
        depth, radius = float(state.depth), float(state.radius)
        if self.work_of_adhesion > 0.0:
            try:
                kept = float(self.at_depth(depth).radius)
            except UnreachableError:
                return radius, None
            if abs(kept - radius) > 1e-6 * radius:
                return radius, None
        return None, depth
