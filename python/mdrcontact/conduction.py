# SPDX-License-Identifier: GPL-3.0-or-later
"""Conduction of current or heat through a contact (docs/conduction.md): conductors, spots, their answers in time."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout, _native
from ._boundary import (
    ComplexOrArray,
    FloatOrArray,
    Handle,
    address,
    check,
    complex_values,
    evaluate,
    evaluate_all,
    number,
    numbers,
    together,
)
from ._value import Value
from .adhesion import code
from .errors import ArgumentTypeError, InvalidArgumentError
from .interior import BODIES

__all__ = ["Conductor", "Interface", "LayeredConductor", "Conduction", "Spot", "PERFECT", "INSULATING"]

ANSWERS: dict[str, int] = {
    "conductance": _layout.CONDUCTION_CONDUCTANCE,
    "resistance": _layout.CONDUCTION_RESISTANCE,
    "mean": _layout.CONDUCTION_MEAN,
    "centre": _layout.CONDUCTION_CENTRE,
    "gaussian": _layout.CONDUCTION_GAUSSIAN,
}
"""What a spot answers in time."""


class _Base:
    """What layers lie on where it is no half-space."""

    def __init__(self, name: str, number: int) -> None:
        self._name, self._code = name, number

    def __repr__(self) -> str:
        return self._name

    def __reduce__(self) -> str:
        return self._name


PERFECT: Final = _Base("PERFECT", _layout.BASE_PERFECT)
"""A perfect conductor at potential 0 below all layers."""
INSULATING: Final = _Base("INSULATING", _layout.BASE_INSULATING)
"""No flux below all layers: a body that answers in time, and with a sink in a steady state."""


def _check(rows: NDArray[np.float64]) -> None:
    """Lets the library check layers: what lies on an insulating base without a sink costs nothing to make."""
    base = _layout.BASE_INSULATING
    Handle(_native.conduction_new(rows, base, 0, 0, base, 0.0, 0.0), _native.conduction_free)


@dataclass(frozen=True)
class Conductor(Value):
    """A material that conducts current or heat; a body of it alone is a half-space.

    sigma : conductivity > 0 into the body, S/m or W/(m K) [conductance/length]
    along : conductivity > 0 along the surface; None: sigma
    capacity : heat capacity >= 0 per volume, J/(m^3 K); 0: it follows at once
    """

    sigma: float
    along: float | None = None
    capacity: float = 0.0
    _handle: Any = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        self._set(sigma=number("sigma", self.sigma), capacity=number("capacity", self.capacity), _handle=None)
        if self.along is not None:
            self._set(along=number("along", self.along))
        _check(np.array([self._row(1.0)]))

    def _row(self, thickness: float = 0.0, resistance: float = 0.0) -> tuple[float, ...]:
        """Of struct mdr_conductor."""
        return thickness, self.sigma, self.sigma if self.along is None else self.along, self.capacity, resistance


@dataclass(frozen=True)
class Interface(Value):
    """What lies between two layers.

    resistance : area resistance >= 0: Kapitza resistance, an oxide [length^2/conductance]
    """

    resistance: float
    _handle: Any = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        self._set(resistance=number("resistance", self.resistance), _handle=None)
        _check(np.array([(1.0, 1.0, 1.0, 0.0, self.resistance)]))


@dataclass(frozen=True)
class LayeredConductor(Value):
    """A body of layers that conduct.

    layers : from the surface down, (Conductor, thickness > 0), with Interface(resistance) between two, or above the substrate
    substrate : Conductor, PERFECT or INSULATING
    """

    layers: tuple[Any, ...]
    substrate: Conductor | _Base
    _handle: Any = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        self._set(layers=tuple(layer if isinstance(layer, Interface) else tuple(layer) for layer in self.layers), _handle=None)
        rows, base = self._rows()
        if base == _layout.BASE_HALF_SPACE:
            rows[-1, 0] = 1.0
        _check(rows)

    def _rows(self) -> tuple[NDArray[np.float64], int]:
        """Rows of struct mdr_conductor, and the base."""
        rows: list[list[float]] = []
        for layer in self.layers:
            if isinstance(layer, Interface):
                if not rows or rows[-1][4]:
                    raise InvalidArgumentError("an Interface is not allowed there: it lies below a layer, one at most")
                rows[-1][4] = layer.resistance
            elif len(layer) == 2 and isinstance(layer[0], Conductor):
                rows.append(list(layer[0]._row(number("thickness", layer[1]))))
            else:
                raise ArgumentTypeError(f"{layer!r} is not allowed: it must be (Conductor, thickness) or an Interface")
        if isinstance(self.substrate, Conductor):
            rows.append(list(self.substrate._row()))
            return np.array(rows), _layout.BASE_HALF_SPACE
        if not isinstance(self.substrate, _Base):
            raise ArgumentTypeError(f"substrate = {self.substrate!r} is not allowed: it must be a Conductor, PERFECT or INSULATING")
        return np.array(rows).reshape(-1, 5), self.substrate._code


def _conductor(material: Any) -> Conductor:
    """What a material of an elastic body conducts with."""
    found = material if isinstance(material, Conductor) else getattr(material, "conductor", None)
    if not isinstance(found, Conductor):
        raise ArgumentTypeError(f"{material!r} has no conductivity: give Elastic(E, nu, conductor=Conductor(...))")
    return found


def _body(body: Any) -> LayeredConductor:
    """A conductor, a stack of them, or the conductors of an elastic body."""
    if isinstance(body, LayeredConductor):
        return body
    if isinstance(body, Conductor):
        return LayeredConductor((), body)
    if hasattr(body, "material"):
        return LayeredConductor((), _conductor(body.material))
    if hasattr(body, "coating"):
        return LayeredConductor(((_conductor(body.coating), body.thickness),), _conductor(body.substrate))
    if hasattr(body, "layers"):
        return LayeredConductor(tuple((_conductor(m), h) for m, h in body.layers), _conductor(body.substrate))
    raise ArgumentTypeError(f"{body!r} is not allowed: it must be a Conductor, a LayeredConductor or an elastic body of materials "
                            "with conductors")  # fmt: skip


@dataclass(frozen=True)
class Conduction(Value):
    """One conductor whose spot is held at a potential, or two that touch at a circular spot; no flux passes beside it.

    body, other : Conductor, LayeredConductor, or Homogeneous, Coated, Layered of materials with a conductor; potentials of each
        count from its own far field
    film : area resistance >= 0 in the spot itself [length^2/conductance]
    sink : radius at which the flux leaves a body on an INSULATING base, much larger than spots and layers; None: such a body
        answers in time alone [length]
    """

    body: Any
    other: Any = None
    film: float = 0.0
    sink: float | None = None

    def __post_init__(self) -> None:
        film, sink = number("film", self.film), None if self.sink is None else number("sink", self.sink)
        lower, lower_base = _body(self.body)._rows()
        upper, upper_base = (None, 0) if self.other is None else _body(self.other)._rows()
        count = 0 if upper is None else len(upper)
        created = _native.conduction_new(lower, lower_base, count, address(upper), upper_base, film, sink or 0.0)
        self._set(_handle=Handle(created, _native.conduction_free), film=film, sink=sink)

    def at_radius(self, radius: ArrayLike) -> Spot:
        """The steady spot of radius a > 0 [length], any shape: conductance and slope; its fields take one radius."""
        handle = self._handle.address
        conductance, slope = evaluate_all("radius", radius, lambda a: _native.conduction_spot(handle, a))
        given = numbers("radius", radius) if np.ndim(radius) else number("radius", radius)
        return Spot(self, given, conductance, slope)

    def step(self, time: ArrayLike, radius: float, answer: str = "conductance") -> FloatOrArray:
        """What follows a step at time 0, at times with D t/a^2 >= 1e-4 of the surface, any shape.

        answer : "conductance", flux per potential after a step of the potential of an equipotential spot; potential per flux
            after a step of flux: "resistance", of an equipotential spot; "mean" or "centre" under a uniform flux; "gaussian", the
            mean over a Gaussian probe under a Gaussian pump with 1/e^2 radii w0 and w1, radius = sqrt(w0^2 + w1^2)
        """
        wanted, a = code("answer", answer, ANSWERS), number("radius", radius)
        return evaluate("time", time, lambda t: _native.conduction_step(self._handle.address, wanted, a, t))

    def admittance(self, omega: ArrayLike, radius: float, answer: str = "conductance") -> ComplexOrArray:
        """The same answers to exp(i omega t), at angular frequencies omega >= 0 [1/time], 0: steady."""
        wanted, a = code("answer", answer, ANSWERS), number("radius", radius)
        return complex_values("omega", omega, lambda w: _native.conduction_admittance(self._handle.address, wanted, a, w))

    def impedance(self, omega: ArrayLike, radius: float) -> ComplexOrArray:
        """Potential over flux of an equipotential spot at angular frequencies omega >= 0 [1/time]."""
        return self.admittance(omega, radius, "resistance")


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
        return self._field(_layout.CONDUCTION_FLUX, r, 0.0, "lower", "above")

    def potential(self, r: ArrayLike, z: ArrayLike, body: str = "lower", side: str = "below") -> FloatOrArray:
        """Potential of a body from its own far field, at total potential 1, r >= 0, depth z >= 0 below its surface [1].

        side : "below" or "above", of an interface with a resistance
        """
        return self._field(_layout.CONDUCTION_POTENTIAL, r, z, body, side)

    def flux_inside(
        self, r: ArrayLike, z: ArrayLike, body: str = "lower", side: str = "below"
    ) -> tuple[FloatOrArray, FloatOrArray]:
        """Flux density into the body and away from the axis at total potential 1 [conductance/length^2]."""
        return (
            self._field(_layout.CONDUCTION_FLUX_Z, r, z, body, side),
            self._field(_layout.CONDUCTION_FLUX_R, r, z, body, side),
        )

    def _field(self, kind: int, r: ArrayLike, z: ArrayLike, body: str, side: str) -> FloatOrArray:
        radius = number("radius", self.radius)
        which, below = code("body", body, BODIES), code("side", side, {"below": 1, "above": 0})
        radii, depths = together(r=r, z=z)
        flat = np.ascontiguousarray(radii, float).ravel(), np.ascontiguousarray(depths, float).ravel()
        if not radii.size:
            return np.empty(radii.shape)
        handle = self.conduction._handle.address
        status, values = _native.conduction_field(handle, kind, radius, which, below, flat[0], address(flat[1]))
        check(status, single=not radii.shape)
        return values.reshape(radii.shape) if radii.shape else float(values[0])
