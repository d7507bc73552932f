# SPDX-License-Identifier: GPL-3.0-or-later
"""Conduction of current or heat through a contact (docs/conduction.md): conductors, spots, their answers in time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _layout
from .._boundary import (
    ComplexOrArray,
    FloatOrArray,
    Handle,
    call,
    check,
    complex_values,
    evaluate,
    evaluate_all,
    native,
    not_zero,
    number,
    numbers,
    one_path,
    together,
    words_of,
)
from .._choices import code
from .._value import Value
from ..errors import InvalidArgumentError
from ..interior import BODIES
from ..state import State
from .bodies import conduction_of, flux_compliance

ANSWERS = words_of(
    _layout.CONDUCTANCE, _layout.RESISTANCE, _layout.MEAN_POTENTIAL, _layout.CENTRE_POTENTIAL, _layout.GAUSSIAN_POTENTIAL
)
"""What a spot answers in time."""
MOTIONS = words_of(_layout.HEAT_SLIDING, _layout.HEAT_SPINNING, _layout.HEAT_MOVING)
"""How the heat of friction is made."""
SIDES: dict[str, int] = {"below": 1, "above": 0}
"""Of an interface."""


def _at_points(r: ArrayLike, z: ArrayLike, function: Callable[..., Any]) -> FloatOrArray:
    """Values of a compiled function at points whose coordinates broadcast."""
    radii, depths = together(r=r, z=z)
    if not radii.size:
        return np.empty(radii.shape)
    status, values = function(*(np.ascontiguousarray(axis, float).ravel() for axis in (radii, depths)))
    check(status, single=not radii.shape)
    return values.reshape(radii.shape) if radii.shape else float(values[0])


def _rows(states: State) -> tuple[NDArray[np.float64], tuple[int, ...]]:
    """States as the library takes them, and their shape."""
    rows = states._rows()
    return np.ascontiguousarray(rows.reshape(-1, rows.shape[-1])), rows.shape[:-1]


class ContactConductance(NamedTuple):
    """Conductance along the loading of a contact; each entry has the shape of the states."""

    conductance: FloatOrArray
    """G, flux per potential [conductance]"""
    by_force: FloatOrArray
    """dG/dF [conductance/force]"""
    by_depth: FloatOrArray
    """dG/dd [conductance/length]"""


@dataclass(frozen=True)
class FrictionHeat:
    """The heat that friction makes in states of a contact, and its temperatures over those far away; each number has the shape
    of the states."""

    total: FloatOrArray
    """Q, heat per time"""
    share: FloatOrArray
    """part of it that the lower body takes: 1 without an upper one"""
    centre: FloatOrArray
    """temperature rise at r = 0, to 1e-8; for a moving source that of the lower body, as all below"""
    flux_mean: FloatOrArray
    """its mean weighted with the heat"""
    area_mean: FloatOrArray | None
    """its mean over the contact; None for a moving source"""
    largest: FloatOrArray | None
    """of a moving source: the largest rise on the line of motion through the centre; else None"""
    behind: FloatOrArray | None
    """how far behind the centre it is [length]; else None"""
    _field: Any = field(repr=False, compare=False)

    def temperature(self, r: ArrayLike, z: ArrayLike, body: str = "lower", side: str = "below") -> FloatOrArray:
        """Temperature rise in a body at r >= 0 and depth z >= 0 below its surface, of one state; not of a moving source. At the
        surface near kinks of the indenter it is within 2e-3 of the largest, `centre` is exact.

        side : "below" or "above", of an interface with a resistance; z lies at one to the rounding of a sum of thicknesses
        """
        if self._field is None:
            raise InvalidArgumentError("the temperature of a moving source is not axisymmetric: its centre and its mean are known")
        conduction, contact, rows, motion, strength = self._field
        if np.ndim(self.total):
            raise InvalidArgumentError("temperatures are those of one state: give friction_heat one of them")
        row = rows[0]
        which, below = code("body", body, BODIES), code("side", side, SIDES)

        def values(flat_r: Any, flat_z: Any) -> Any:
            handles = conduction._handle, contact._handle
            return native.conduction_heat_field(handles[0], handles[1], row, motion, strength, which, below, flat_r, flat_z)

        return _at_points(r, z, values)


@dataclass(frozen=True)
class Conduction(Value):
    """One conductor whose spot is held at a potential, or two that touch at a circular spot; no flux passes beside it.

    body, other : Conductor, LayeredConductor, or Homogeneous, Coated, Layered of materials with a conductor, whose interfaces
        have their resistances (a tension or sheet on it conducts nothing); potentials of each count from its own far field
    film : area resistance >= 0 in the spot itself [length^2/conductance]
    sink : radius at which the flux leaves a body on an INSULATING base, much larger than spots and layers; None: such a body
        answers in time alone; other bodies have none [length]
    """

    body: Any
    other: Any = None
    film: float = 0.0
    sink: float | None = None

    def __post_init__(self) -> None:
        film, sink = number("film", self.film), None if self.sink is None else number("sink", self.sink)
        self._set(_handle=conduction_of(self.body, self.other, film, sink or 0.0), film=film, sink=sink)

    def at_radius(self, radius: ArrayLike) -> Spot:
        """The steady spot of radius a > 0 [length], any shape: conductance and slope; its fields take one radius."""
        handle = self._handle
        conductance, slope = evaluate_all("radius", radius, lambda a: native.conduction_spot(handle, a))
        given = numbers("radius", radius) if np.ndim(radius) else number("radius", radius)
        return Spot(self, given, conductance, slope)

    def compliance(self, k: ArrayLike, omega: float = 0.0) -> FloatOrArray | ComplexOrArray:
        """C(k) [length/conductance]: potential over flux at the surface of a wave, at wavenumbers k > 0 [1/length], any shape; of
        two bodies the sum of both, without the film. It makes codes that solve conduction by Fourier transforms layered.

        omega : angular frequency >= 0, at which C is complex; 0: steady [1/time]
        """
        return flux_compliance(self._handle, k, omega)

    def tabulated(self, smallest: float, largest: float, tolerance: float = 1e-8) -> TabulatedConduction:
        """The same with a table of its conductance between two radii, compared with the solution between its nodes: a conductance
        then takes some hundred nanoseconds, for codes that integrate motion and have the radius from a `ContactLaw`.

        tolerance : relative, 1e-10 to 1e-2
        """
        return TabulatedConduction(self.body, self.other, self.film, self.sink, smallest, largest, tolerance)

    def along(self, states: State) -> ContactConductance:
        """Conductance of states of a contact, and how it grows with force and depth: G'(a)/F'(a), G'(a)/d'(a)."""
        rows, shape = _rows(states)
        status, *values = native.conduction_along(self._handle, states._owner._handle, rows)
        check(status, single=not shape)
        return ContactConductance(*(value.reshape(shape) if shape else float(value[0]) for value in values))

    def rough(self, state: State, kappa: float) -> float:
        """Steady conductance of one state between rough surfaces: area resistance kappa/p(r) in the spot, by the pressure of the
        state, in place of `film`. Right to 1e-9 under smooth indenters, else to 1e-6; refused with adhesion and where the edge
        carries a line force.

        kappa : > 0, as small as it may be, area resistance times pressure [modulus length^2/conductance]
        """
        contact = state._owner._handle
        return float(call(native.conduction_rough, self._handle, contact, state._row(), number("kappa", kappa)))

    def step_flux(self, r: ArrayLike, time: float, radius: float) -> FloatOrArray:
        """Flux density through a spot without a film at 0 <= r < a, a time after a step of its potential to 1."""
        given = _layout.FLUX, number("radius", radius), _layout.BODY_LOWER, 0, not_zero("time", time)
        return evaluate("r", r, lambda points: native.conduction_field(self._handle, *given, points, None))

    def friction_heat(
        self, states: State, mu: float, speed: float, motion: str = "sliding", source_speed: float | None = None
    ) -> FrictionHeat:
        """The heat of friction of states, any shape, q = mu speed p(r), and its temperatures. Refused where p is a tension, as
        with adhesion, and where the edge carries a line force, as under a plate: its temperature would be infinite.

        motion : "sliding", the source resting on both bodies, as in fretting or at low speeds; "spinning", q = mu speed r p(r),
            speed being the twist rate [1/time]: exact at any speed; "moving", the source moving over the lower body, at
            v a c/sigma <= 1000, and resting on the upper one. Of two bodies the share is then that of equal
            flux_mean, an approximation
        source_speed : speed of a moving source over the lower body; None: speed [length/time]
        """
        kind = code("motion", motion, MOTIONS)
        if source_speed is not None and motion != "moving":
            raise InvalidArgumentError(
                f"source_speed = {source_speed!r} is not allowed with motion = {motion!r}: the source rests. Leave it out"
            )
        strength = number("mu", mu) * number("speed", speed)
        over = strength and (number("speed", speed) if source_speed is None else number("source_speed", source_speed))
        rows, shape = _rows(states)
        contact = states._owner
        given = (self._handle, contact._handle, rows, kind, strength, over)
        status, values = native.conduction_heat(*given)
        check(status, single=not shape)
        columns = [values[:, i].reshape(shape) if shape else float(values[0, i]) for i in range(values.shape[1])]
        total, share, centre, flux_mean, area_mean, largest, behind = columns
        if motion == "moving":
            return FrictionHeat(total, share, centre, flux_mean, None, largest, behind, None)
        return FrictionHeat(total, share, centre, flux_mean, area_mean, None, None, (self, contact, rows, kind, strength))

    def step(self, time: ArrayLike, radius: float, answer: str = "conductance") -> FloatOrArray:
        """What follows a step at time 0, at times with D t/a^2 >= 1e-4 of the surface, any shape.

        answer : "conductance", flux per potential after a step of the potential of an equipotential spot; potential per flux
            after a step of flux: "resistance", of an equipotential spot; "mean_potential" or "centre_potential" under a uniform
            flux; "gaussian_potential", the mean over a Gaussian probe under a Gaussian pump with 1/e^2 radii w0 and w1,
            radius = sqrt(w0^2 + w1^2); these three are of the bodies, without the film
        """
        wanted, a = code("answer", answer, ANSWERS), number("radius", radius)
        return evaluate("time", time, lambda t: native.conduction_follow(self._handle, wanted, a, t, None))

    def follow(self, time: ArrayLike, given: ArrayLike, radius: float, answer: str = "conductance") -> NDArray[np.float64]:
        """What follows a history of potential, for the answer "conductance" (a flux), else of flux (a potential), that goes evenly
        from one value to the next.

        time : ascending, one dimension, apart as `step` takes times
        given : as many, the first is 0
        answer : as of `step`
        """
        wanted, a = code("answer", answer, ANSWERS), number("radius", radius)
        _, t, values = one_path(time, given=given)
        status, found = native.conduction_follow(self._handle, wanted, a, t, values)
        check(status)
        return np.asarray(found)

    def admittance(self, omega: ArrayLike, radius: float, answer: str = "conductance") -> ComplexOrArray:
        """The same answers to exp(i omega t), at angular frequencies omega >= 0 [1/time], 0: steady."""
        wanted, a = code("answer", answer, ANSWERS), number("radius", radius)
        return complex_values("omega", omega, lambda w: native.conduction_admittance(self._handle, wanted, a, w))

    def impedance(self, omega: ArrayLike, radius: float) -> ComplexOrArray:
        """Potential over flux of an equipotential spot at angular frequencies omega >= 0 [1/time]."""
        return self.admittance(omega, radius, "resistance")


@dataclass(frozen=True)
class TabulatedConduction(Conduction):
    """A conduction with a table of its conductance, made by `Conduction.tabulated`; beyond the table it is solved."""

    smallest: float = 0.0
    largest: float = 0.0
    tolerance: float = 1e-8

    def __post_init__(self) -> None:
        super().__post_init__()
        ends = [number(name, getattr(self, name)) for name in ("smallest", "largest", "tolerance")]
        self._set(_handle=Handle(native.conduction_tabulate(self._handle, *ends)))


@dataclass(frozen=True)
class Spot:
    """Steady spots of a conduction."""

    conduction: Conduction = field(repr=False)
    radius: FloatOrArray
    conductance: FloatOrArray
    """G, flux per potential [conductance]"""
    slope: FloatOrArray
    """dG/da [conductance/length]"""

    def flux(self, r: ArrayLike) -> FloatOrArray:
        """Flux density through the spot at potential 1, 0 <= r < a [conductance/length^2]; without a film infinite at the edge."""
        return self._field(_layout.FLUX, r, 0.0, "lower", "above")

    def potential(self, r: ArrayLike, z: ArrayLike, body: str = "lower", side: str = "below") -> FloatOrArray:
        """Potential of a body from its own far field, at total potential 1, r >= 0, depth z >= 0 below its surface [1].

        side : "below" or "above", of an interface with a resistance; z lies at one to the rounding of a sum of thicknesses
        """
        return self._field(_layout.POTENTIAL, r, z, body, side)

    def flux_inside(
        self, r: ArrayLike, z: ArrayLike, body: str = "lower", side: str = "below"
    ) -> tuple[FloatOrArray, FloatOrArray]:
        """Flux density into the body and away from the axis at total potential 1 [conductance/length^2]; of a PERFECT base what
        goes into it, 0 along it."""
        return (
            self._field(_layout.FLUX_Z, r, z, body, side),
            self._field(_layout.FLUX_R, r, z, body, side),
        )

    def _field(self, kind: int, r: ArrayLike, z: ArrayLike, body: str, side: str) -> FloatOrArray:
        radius = number("radius", self.radius)
        which, below = code("body", body, BODIES), code("side", side, SIDES)
        handle = self.conduction._handle

        def values(flat_r: Any, flat_z: Any) -> Any:
            return native.conduction_field(handle, kind, radius, which, below, 0.0, flat_r, flat_z)

        return _at_points(r, z, values)
