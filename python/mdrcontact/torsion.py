# SPDX-License-Identifier: GPL-3.0-or-later
"""A contact under Coulomb's law of friction that is twisted about its axis at constant normal force (theory 10)."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout, _native
from ._boundary import FloatOrArray
from ._partial_slip import Given, PartialSlip, Rubbing, draw_loop
from .contact import Contact, State
from .errors import ArgumentTypeError

__all__ = ["Torsion", "TorsionLoop", "TorsionalState"]


class TorsionalState(NamedTuple):
    """Torsional states; each entry has the shape of the input, or is a number."""

    twist: FloatOrArray
    """phi, angle of the indenter about the axis [radian]"""
    torque: FloatOrArray
    """M, of the sign of phi [modulus length^3]"""
    stick_radius: FloatOrArray
    """c, radius of the disc of stick, 0 where the contact slides [length]"""
    stiffness: FloatOrArray
    """dM/dphi, that of a contact of radius c that sticks all over [modulus length^3]"""
    dissipated_energy: FloatOrArray
    """energy dissipated since phi = 0 [modulus length^3]"""
    sliding: bool | NDArray[np.bool_]
    """whether the disc of stick is smaller than 1e-6 a, which no torque distinguishes from 0"""


class TorsionLoop(NamedTuple):
    """A cycle between +amplitude and -amplitude at constant normal force."""

    twist: NDArray[np.float64]
    """phi, from +amplitude to -amplitude and back in equal steps [radian]"""
    torque: NDArray[np.float64]
    """M [modulus length^3]"""
    dissipated_energy: float
    """energy dissipated in the cycle, the area of the loop [modulus length^3]"""
    turn: TorsionalState
    """the state at +amplitude when it is reached for the first time; slip is outside its stick radius"""

    def plot(self, axes: Any = None, **look: Any) -> Any:
        """Draws M against phi with matplotlib on `axes` (None makes a new figure); `look` is passed on. Returns the axes."""
        return draw_loop(self.twist, self.torque, ("twist phi", "torque M"), axes, look)


_SLIP = PartialSlip[TorsionalState](
    "torsional",
    TorsionalState,
    {"twist": _layout.GIVEN_TWIST, "torque": _layout.GIVEN_TORQUE},
    {"twist": "twist", "torque": "torque"},
    (_native.torsion_states, _native.torsion_sliding, _native.torsion_loop, _native.torsion_field),
)


class Torsion:
    """Torsion with friction, Lubkin's problem: `friction.torsion`. A contact is pressed first and twisted then; an annulus slips,
    the disc around the axis sticks at any twist, ever smaller, and the torque approaches `sliding_torque`.

    friction : the `Friction` of a contact on a homogeneous medium with E and nu, or on a pair of them

    Exact: torsion changes neither the pressure nor anything around the axis. The normal state is a `State` of the contact, or the
    one with this force, depth or radius; arrays broadcast with the other arguments.
    """

    __slots__ = ("friction",)

    def __init__(self, friction: Rubbing) -> None:
        if not isinstance(getattr(friction, "contact", None), Contact):
            raise ArgumentTypeError(f"friction = {friction!r} is not allowed: it must be a Friction")
        self.friction = friction

    def at_twist(
        self, twist: ArrayLike, state: State | None = None, *, force: Given = None, depth: Given = None, radius: Given = None
    ) -> TorsionalState:
        """The states after a twist phi of the indenter about the axis [radian], of either sign, any shape."""
        return _SLIP.states(self.friction, "twist", twist, (state, force, depth, radius))

    def at_torque(
        self, torque: ArrayLike, state: State | None = None, *, force: Given = None, depth: Given = None, radius: Given = None
    ) -> TorsionalState:
        """The states under a torque M [modulus length^3], |M| < `sliding_torque`, any shape."""
        return _SLIP.states(self.friction, "torque", torque, (state, force, depth, radius))

    def sliding_torque(
        self, state: State | None = None, *, force: Given = None, depth: Given = None, radius: Given = None
    ) -> FloatOrArray:
        """The torque that a growing twist approaches, coefficient int r p dA: (3 pi/16) coefficient F a under a paraboloid
        [modulus length^3]."""
        return _SLIP.sliding(self.friction, (state, force, depth, radius))

    def loop(
        self,
        amplitude: float,
        control: str = "twist",
        points: int = 201,
        state: State | None = None,
        *,
        force: float | None = None,
        depth: float | None = None,
        radius: float | None = None,
    ) -> TorsionLoop:
        """The loop of a cycle between +amplitude and -amplitude (Masing's rule, which is exact here).

        amplitude : > 0, of the "twist" [radian] or the "torque" [modulus length^3] as `control` says
        points : at least 3; from +amplitude to -amplitude and back
        """
        return TorsionLoop(*_SLIP.loop(self.friction, control, amplitude, points, (state, force, depth, radius)))

    def traction(
        self,
        r: ArrayLike,
        twisted: TorsionalState,
        state: State | None = None,
        *,
        force: float | None = None,
        depth: float | None = None,
        radius: float | None = None,
    ) -> FloatOrArray:
        """Shear traction tau(r) [modulus] around the axis at 0 <= r <= a, any shape.

        twisted : one torsional state of this normal state, as `at_twist` gives
        """
        return _SLIP.field(self.friction, _layout.FIELD_TRACTION, ("r", r), ("twisted", twisted), (state, force, depth, radius))

    def line_load(
        self,
        x: ArrayLike,
        twisted: TorsionalState,
        state: State | None = None,
        *,
        force: float | None = None,
        depth: float | None = None,
        radius: float | None = None,
    ) -> FloatOrArray:
        """Line load q(x) = 2 x int_x^a tau dr/sqrt(r^2 - x^2) [modulus length], 0 <= x <= a, any shape; arguments as of
        `traction`. The torque is 4 int_0^a x q dx."""
        return _SLIP.field(
            self.friction, _layout.FIELD_TANGENTIAL_LINE_LOAD, ("x", x), ("twisted", twisted), (state, force, depth, radius)
        )

    def __repr__(self) -> str:
        return f"{self.friction!r}.torsion"
