# SPDX-License-Identifier: GPL-3.0-or-later
"""An indenter on a medium: states from depth, force or radius, and the fields of a state (theory 4)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from numpy.typing import ArrayLike

from . import _native
from ._boundary import FloatOrArray, Handle, evaluate, evaluate_all, number, row
from ._described import Described
from .errors import ArgumentTypeError, InvalidArgumentError
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
    """F, normal force, positive in compression [pressure length^2]"""
    stiffness: FloatOrArray
    """k = dF/dd = 2 a E_eff(a), contact stiffness [pressure length]"""


class Contact(Described):
    """A frictionless contact of an indenter with a medium. It never changes and may be shared between threads.

    indenter : a profile: Sphere(...), Cone(...), ...
    medium : Coated(...), Homogeneous(...), ...
    zeta : ratio d/g(a) of equation (9), the correction of the contact radius; None: 1, the source's approximation.
        Else a table (radii, values): at least 3 radii > 0 ascending [length], values > 0
    """

    indenter: Profile
    medium: Medium

    _handle: Handle

    def __init__(self, indenter: Profile, medium: Medium, *, zeta: tuple[ArrayLike, ArrayLike] | None = None) -> None:
        if not isinstance(indenter, Profile):
            raise ArgumentTypeError(f"indenter = {indenter!r} is not allowed: it must be an indenter profile")
        if not isinstance(medium, Medium):
            raise ArgumentTypeError(f"medium = {medium!r} is not allowed: it must be a medium")
        table = None if zeta is None else _zeta_table(zeta)
        # without zeta the table is one unused entry
        native_table = (0, [1.0], [1.0]) if table is None else (len(table[0]), *table)
        created = _native.contact_new(indenter._handle.address, medium._handle.address, *native_table)
        object.__setattr__(self, "_handle", Handle(created, _native.contact_free))
        self._describe(indenter=indenter, medium=medium, zeta=table)

    def at_depth(self, depth: ArrayLike) -> State:
        """The states at indentation depths d >= 0 [length], any shape."""
        return self._states(_native.contact_from_depth, "depth", depth)

    def at_force(self, force: ArrayLike) -> State:
        """The states under normal forces F >= 0 [pressure length^2], any shape."""
        return self._states(_native.contact_from_force, "force", force)

    def at_radius(self, radius: ArrayLike) -> State:
        """The states at contact radii a >= 0 [length], any shape. A radius at a vertical wall (flat punch) determines no state."""
        return self._states(_native.contact_from_radius, "radius", radius)

    def pressure(
        self, r: ArrayLike, radius: float | None = None, *, depth: float | None = None, force: float | None = None
    ) -> FloatOrArray:
        """Contact pressure p(r) [pressure], equation (6), at 0 <= r <= a, any shape; of the state given by radius, depth or force.

        Infinite where theory says so: at the edge of a flat punch, at the apex of a cone.
        """
        return self._field("pressure", "r", r, radius, depth, force)

    def displacement(
        self, r: ArrayLike, radius: float | None = None, *, depth: float | None = None, force: float | None = None
    ) -> FloatOrArray:
        """Surface displacement u(r) [length], positive into the medium, at r >= 0, any shape; of the state given by radius,
        depth or force. Inside the contact it is d - f(r), outside it is the free surface."""
        return self._field("displacement", "r", r, radius, depth, force)

    def line_load(
        self, x: ArrayLike, radius: float | None = None, *, depth: float | None = None, force: float | None = None
    ) -> FloatOrArray:
        """Line load q(x) [pressure length] of the one-dimensional springs, equations (5), (21), at 0 <= x <= a, any shape; of the
        state given by radius, depth or force."""
        return self._field("line_load", "x", x, radius, depth, force)

    def _states(self, function: Callable[..., Any], name: str, values: ArrayLike) -> State:
        return State(*evaluate_all(function, self._handle.address, name=name, values=values))

    def _field(
        self, field: str, name: str, points: ArrayLike, radius: float | None, depth: float | None, force: float | None
    ) -> FloatOrArray:
        if sum(value is not None for value in (radius, depth, force)) != 1:
            raise ArgumentTypeError(f"{field} needs one of radius, depth and force, and not more")
        if radius is not None:
            function, at = getattr(_native, f"contact_{field}"), number("radius", radius)
        else:
            function = getattr(_native, f"contact_{field}_at_depth")
            at = number("depth", depth) if force is None else number("depth", self.at_force(number("force", force)).depth)
        return evaluate(function, self._handle.address, at, name=name, values=points)


def _zeta_table(zeta: Any) -> tuple[tuple[float, ...], tuple[float, ...]]:
    try:
        radii, values = zeta
    except (TypeError, ValueError) as problem:
        raise ArgumentTypeError(f"zeta = {zeta!r} is not allowed: it must be a pair (radii, values)") from problem
    table = row("radii of zeta", radii), row("values of zeta", values)
    if len(table[0]) != len(table[1]):
        raise InvalidArgumentError(
            f"radii and values of zeta must have the same length; it is {len(table[0])} and {len(table[1])}"
        )
    return table
