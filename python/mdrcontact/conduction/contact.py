# SPDX-License-Identifier: GPL-3.0-or-later
"""Conduction through a contact: steady, in time and with friction."""

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
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..interior import BODIES
from ..material import Conductor
from ..state import State
from .bodies import conduction_of, flux_compliance

ANSWERS = words_of(
    _layout.CONDUCTANCE, _layout.RESISTANCE, _layout.MEAN_POTENTIAL, _layout.CENTRE_POTENTIAL, _layout.GAUSSIAN_POTENTIAL
)
"""Responses of a contact area in time."""
MOTIONS = words_of(_layout.HEAT_SLIDING, _layout.HEAT_SPINNING, _layout.HEAT_MOVING)
"""Motions that make the heat of friction."""
SIDES: dict[str, int] = {"below": 1, "above": 0}
"""Sides of an interface."""
_LOW = 1e-6
"""Part of the hardness under which a rough joint is checked as it is made."""


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
    """Conductance along the loading of a contact, from `Conduction.along`.

    Each entry has the shape of the states.

    Examples
    --------
    >>> copper = mdr.Elastic(120e9, 0.34, conductor=mdr.conduction.Conductor(400.0))
    >>> body = mdr.Homogeneous(copper)
    >>> state = mdr.Contact(mdr.Sphere(1e-3), body).at_force(1.0)
    >>> found = mdr.conduction.Conduction(body).along(state)
    >>> print(f"{found.conductance:.4e} {found.by_force:.4e}")
    2.8289e-02 9.4287e-03
    """

    conductance: FloatOrArray
    """G, flux per potential [conductance]"""
    by_force: FloatOrArray
    """dG/dF [conductance/force]"""
    by_depth: FloatOrArray
    """dG/dd [conductance/length]"""


@dataclass(frozen=True)
class FrictionHeat:
    """Heat of friction and its temperatures, from `Conduction.friction_heat`.

    Temperatures are those above the far field. Each number has the shape of the states.

    Examples
    --------
    >>> steel = mdr.Elastic(210e9, 0.3, conductor=mdr.conduction.Conductor(45.0, capacity=3.6e6))
    >>> body = mdr.Homogeneous(steel)
    >>> state = mdr.Contact(mdr.Sphere(1e-3), body).at_force(1.0)
    >>> heat = mdr.conduction.Conduction(body).friction_heat(state, mu=0.3, speed=0.1)
    >>> print(f"{heat.total:.3f} {heat.centre:.3f} {heat.temperature(0.0, 10e-6):.3f}")
    0.030 16.878 8.028
    """

    total: FloatOrArray
    """Q, heat per time, mu F speed for a sliding contact [energy/time]"""
    share: FloatOrArray
    """part of the heat that the lower body takes, 1 without an upper body [1]"""
    centre: FloatOrArray
    """temperature rise at r = 0, accurate to 1e-8; of a moving source that of the lower body, as all below [temperature]"""
    flux_mean: FloatOrArray
    """mean temperature rise weighted with the heat flux [temperature]"""
    area_mean: FloatOrArray | None
    """mean temperature rise over the contact; None for a moving source [temperature]"""
    largest: FloatOrArray | None
    """largest temperature rise on the line of motion through the centre, of a moving source; else None [temperature]"""
    behind: FloatOrArray | None
    """distance of that point behind the centre [length]; else None"""
    _field: Any = field(repr=False, compare=False)

    def temperature(self, r: ArrayLike, z: ArrayLike, body: str = "lower", side: str = "below") -> FloatOrArray:
        """Return the temperature rise inside a body, of one state and a source at rest.

        At the surface near kinks of the indenter the error is at most 2e-3 of the largest value; `centre` is exact.

        Parameters
        ----------
        r : array_like
            Distances from the axis, >= 0 [length]. `r` and `z` broadcast.
        z : array_like
            Depths below the surface of the body, >= 0 [length].
        body : {"lower", "upper"}, optional
            The body.
        side : {"below", "above"}, optional
            Side of an interface with a resistance, if z is at one.

        Returns
        -------
        float or ndarray
            Temperature rise, in the broadcast shape.

        Raises
        ------
        InvalidArgumentError
            The source moves, or there are several states.
        """
        if self._field is None:
            raise InvalidArgumentError("the temperature of a moving source is not axisymmetric. Use centre and flux_mean")
        conduction, contact, rows, motion, strength = self._field
        if np.ndim(self.total):
            raise InvalidArgumentError("temperatures inside need one state. Give friction_heat one state")
        row = rows[0]
        which, below = code("body", body, BODIES), code("side", side, SIDES)

        def values(flat_r: Any, flat_z: Any) -> Any:
            handles = conduction._handle, contact._handle
            return native.conduction_heat_field(handles[0], handles[1], row, motion, strength, which, below, flat_r, flat_z)

        return _at_points(r, z, values)


@dataclass(frozen=True)
class RoughJoint(Value):
    """Rough surfaces that touch at plastic micro-contacts, with a gas between them.

    The area conductance is 1.25 k_s (m/sigma) (p/H)^0.95 + k_g/(Y + M). Here k_s is the harmonic mean of the conductivities of both
    surfaces, and the separation Y of the mean planes fulfils erfc(Y/(sqrt(2) sigma)) = 2 p/H.

    Parameters
    ----------
    roughness : float
        sigma > 0, root mean square of the heights of both surfaces together [length].
    slope : float
        m > 0, mean absolute slope of both surfaces together [1].
    hardness : float
        H > 0 of the softer surface [modulus].
    gas : float, optional
        Conductivity k_g of the gas, >= 0; 0 is a vacuum [conductance/length].
    jump : float, optional
        M >= 0, sum of the temperature jump lengths of both surfaces [length].

    Raises
    ------
    InvalidArgumentError
        A number is outside its range, or `jump` is given without a gas.

    Notes
    -----
    The power 0.95 approximates the theory for p/H from 1e-6 to 0.023.

    References
    ----------
    cooper-1969
    yovanovich-2005

    Examples
    --------
    >>> aluminium = mdr.Elastic(70e9, 0.33, conductor=mdr.conduction.Conductor(200.0))
    >>> body = mdr.Homogeneous(aluminium)
    >>> state = mdr.Contact(mdr.Sphere(1.0), body).at_force(100.0)
    >>> joint = mdr.conduction.RoughJoint(1e-6, 0.1, 3e9, gas=0.026, jump=4e-7)
    >>> conduction = mdr.conduction.Conduction(body, aluminium.conductor)
    >>> print(f"{conduction.joint_resistance(joint, state.pressure(0.0)):.3e}")
    1.945e-06
    >>> print(f"{conduction.rough(state, joint):.4f} of {conduction.at_radius(state.radius).conductance:.4f}")
    0.2623 of 0.3939
    """

    roughness: float
    slope: float
    hardness: float
    gas: float = 0.0
    jump: float = 0.0

    def __post_init__(self) -> None:
        numbers = self._numbers()
        handle = conduction_of(Conductor(1.0), None, 0.0, 0.0)
        call(native.conduction_joint_resistance, handle, *numbers, [_LOW * self.hardness])


@dataclass(frozen=True)
class Conduction(Value):
    """Conduction through a circular contact area into one body, or between two.

    One body is held at a potential over the area; two bodies touch there. No flux passes outside the area. The flux is a current or
    heat.

    Parameters
    ----------
    body : Conductor, LayeredConductor, Homogeneous, Coated, Layered or Pair
        The body. Elastic bodies need materials with a conductor; their interfaces have their resistances. A tension or sheet on the
        surface conducts nothing. The potential counts from the far field of the body.
    other : Conductor, LayeredConductor, Homogeneous, Coated or Layered, optional
        The other body; a `Pair` already has two.
    film : float, optional
        Area resistance of a film in the contact area, >= 0 [length^2/conductance].
    sink : float, optional
        Radius at which the flux leaves a body on an INSULATING base, much larger than contact areas and layers [length]. None: such
        a body has transients only. Other bodies have no sink.

    Raises
    ------
    ArgumentTypeError
        A body does not conduct, or a pair is given with `other`.
    InvalidArgumentError
        A number is outside its range.

    References
    ----------
    holm-1967
    carslaw-1959
    barber-2003

    Examples
    --------
    >>> copper, steel = mdr.conduction.Conductor(400.0), mdr.conduction.Conductor(45.0)
    >>> conduction = mdr.conduction.Conduction(copper, steel)
    >>> print(f"{conduction.at_radius(1e-6).conductance:.4e} {4e-6 / (1 / 400.0 + 1 / 45.0):.4e}")
    1.6180e-04 1.6180e-04
    >>> sheet = mdr.conduction.LayeredConductor([(copper, 1e-6)], mdr.conduction.INSULATING)
    >>> print(f"{mdr.conduction.Conduction(sheet, sink=1e-3).at_radius(1e-6).conductance:.4e}")
    3.3449e-04
    """

    body: Any
    other: Any = None
    film: float = 0.0
    sink: float | None = None

    def __post_init__(self) -> None:
        film, sink = number("film", self.film), None if self.sink is None else number("sink", self.sink)
        self._set(_handle=conduction_of(self.body, self.other, film, sink or 0.0), film=film, sink=sink)

    def at_radius(self, radius: ArrayLike) -> Spot:
        """Return the steady contact area of a given radius.

        Parameters
        ----------
        radius : array_like
            a > 0, any shape [length].

        Returns
        -------
        Spot
            Conductance and its slope, in the shape of `radius`, and fields of one radius.

        Raises
        ------
        InvalidArgumentError
            A radius is not greater than 0, or a body on an INSULATING base has no sink.
        """
        handle = self._handle
        conductance, slope = evaluate_all("radius", radius, lambda a: native.conduction_spot(handle, a))
        given = numbers("radius", radius) if np.ndim(radius) else number("radius", radius)
        return Spot(self, given, conductance, slope)

    def compliance(self, k: ArrayLike, omega: ArrayLike = 0.0) -> FloatOrArray | ComplexOrArray:
        """Return the compliance C(k), potential per flux of a wave on the surface.

        Codes that solve conduction by Fourier transforms use it to include layers. It is the sum over both bodies, without the
        film.

        Parameters
        ----------
        k : array_like
            Wavenumbers > 0, any shape [1/length].
        omega : array_like, optional
            Angular frequencies of either sign, in a shape that broadcasts with `k` [1/time]; 0 is the steady state.

        Returns
        -------
        float, complex or ndarray
            C, in the shape of `k` and `omega` [length/conductance]; complex unless all frequencies are 0. C(-omega) is the complex
            conjugate of C(omega).

        Raises
        ------
        InvalidArgumentError
            A wavenumber is not greater than 0, or a frequency is not finite.
        """
        return flux_compliance(self._handle, k, omega)

    def tabulated(self, smallest: float, largest: float, tolerance: float = 1e-8) -> TabulatedConduction:
        """Return the same conduction with a table of its conductance.

        A conductance then takes a few hundred nanoseconds, for codes that integrate motion with a `ContactLaw`. The table is
        compared with the solution between its nodes.

        Parameters
        ----------
        smallest : float
            Smallest radius of the table, > 0 [length].
        largest : float
            Largest radius of the table, > `smallest` [length].
        tolerance : float, optional
            Relative tolerance, 1e-10 to 1e-2 [1].

        Returns
        -------
        TabulatedConduction
            The conduction.

        Raises
        ------
        InvalidArgumentError
            A number is outside its range.
        """
        return TabulatedConduction(self.body, self.other, self.film, self.sink, smallest, largest, tolerance)

    def along(self, states: State) -> ContactConductance:
        """Return the conductance of states, and its derivatives by force and depth.

        Parameters
        ----------
        states : State
            States of a contact.

        Returns
        -------
        ContactConductance
            G, dG/dF = G'(a)/F'(a) and dG/dd = G'(a)/d'(a), in the shape of the states.

        Raises
        ------
        ArgumentTypeError
            The states have no contact.
        """
        rows, shape = _rows(states)
        status, *values = native.conduction_along(self._handle, states._owner._handle, rows)
        check(status, single=not shape)
        return ContactConductance(*(value.reshape(shape) if shape else float(value[0]) for value in values))

    def rough(self, state: State, joint: RoughJoint | float) -> float:
        """Return the steady conductance of one state between rough surfaces.

        The area resistance in the contact area follows the pressure of the state and replaces `film`. The error of the solution is
        1e-9 under smooth indenters and 1e-6 under others.

        Parameters
        ----------
        state : State
            One state of a contact without adhesion, whose edge carries no line force.
        joint : RoughJoint or float
            Rough surfaces with plastic micro-contacts; or kappa > 0, the product of area resistance and pressure [modulus
            length^2/conductance].

        Returns
        -------
        float
            Conductance [conductance].

        Raises
        ------
        InvalidArgumentError
            `joint` is not greater than 0.
        DomainError
            The pressure is not greater than 0 everywhere, as with adhesion, or reaches half of the hardness of the joint, or the
            edge carries a line force.

        References
        ----------
        cooper-1969
        yovanovich-2005
        """
        contact, row = state._owner._handle, state._row()
        if isinstance(joint, RoughJoint):
            return float(call(native.conduction_joint, self._handle, contact, row, *joint._numbers()))
        return float(call(native.conduction_rough, self._handle, contact, row, number("joint", joint)))

    def joint_resistance(self, joint: RoughJoint, pressure: ArrayLike) -> FloatOrArray:
        """Return the area resistance between rough surfaces under a pressure.

        Parameters
        ----------
        joint : RoughJoint
            The rough surfaces.
        pressure : array_like
            Pressures > 0, less than half of the hardness, any shape [modulus].

        Returns
        -------
        float or ndarray
            Area resistance, in the shape of `pressure` [length^2/conductance].

        Raises
        ------
        InvalidArgumentError
            A pressure is not greater than 0.
        DomainError
            A pressure reaches half of the hardness.
        """
        if not isinstance(joint, RoughJoint):
            raise ArgumentTypeError(f"joint = {joint!r}: it must be a RoughJoint")
        roughness, slope, hardness, gas, jump = joint._numbers()
        given = self._handle, roughness, slope, hardness, gas, jump
        return evaluate("pressure", pressure, lambda p: native.conduction_joint_resistance(*given, p))

    def step_flux(self, r: ArrayLike, time: float, radius: float) -> FloatOrArray:
        """Return the flux density after a step of the potential to 1, without a film.

        Parameters
        ----------
        r : array_like
            Radii, 0 <= r < a, any shape [length].
        time : float
            Time since the step, > 0 [time].
        radius : float
            a > 0 [length].

        Returns
        -------
        float or ndarray
            Flux density, in the shape of `r` [conductance/length^2].

        Raises
        ------
        InvalidArgumentError
            The time or the radius is not greater than 0, or there is a film.
        """
        given = _layout.FLUX, number("radius", radius), _layout.BODY_LOWER, 0, not_zero("time", time)
        return evaluate("r", r, lambda points: native.conduction_field(self._handle, *given, points, None))

    def friction_heat(
        self, states: State, mu: float, speed: float, motion: str = "sliding", source_speed: float | None = None
    ) -> FrictionHeat:
        """Return the heat of friction of states, and its temperatures.

        Parameters
        ----------
        states : State
            States of a contact without tension, any shape.
        mu : float
            Coefficient of friction, >= 0 [1].
        speed : float
            Sliding speed [length/time], or for "spinning" the twist rate [1/time].
        motion : {"sliding", "spinning", "moving"}, optional
            "sliding": q = mu speed p(r), the source rests on both bodies, as in fretting or at low speeds. "spinning": q = mu speed
            r p(r), exact at any speed. "moving": the source moves over the lower body, v a c/sigma <= 1000, and rests on the upper
            one.
        source_speed : float, optional
            Speed of a moving source over the lower body; None is `speed` [length/time].

        Returns
        -------
        FrictionHeat
            Heat and temperatures. Of a moving source on two bodies the share is that of equal `flux_mean`, an approximation.

        Raises
        ------
        InvalidArgumentError
            The pressure is a tension, as with adhesion, or the edge carries a line force, as under a plate; or `source_speed` is
            given for a source at rest.

        References
        ----------
        jaeger-1942
        tian-1994
        carslaw-1959
        """
        kind = code("motion", motion, MOTIONS)
        if source_speed is not None and motion != "moving":
            raise InvalidArgumentError(f"source_speed = {source_speed!r}: with motion = {motion!r} the source is at rest. Omit it")
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
        """Return the response to a step at time 0.

        Parameters
        ----------
        time : array_like
            Times with D t/a^2 >= 1e-4 of the surface, any shape [time].
        radius : float
            a > 0 [length].
        answer : {"conductance", "resistance", "mean_potential", "centre_potential", "gaussian_potential"}, optional
            "conductance": flux per potential after a step of the potential of an equipotential contact area. The others are
            potential per flux after a step of the flux. "resistance": of an equipotential area. "mean_potential",
            "centre_potential": under a uniform flux. "gaussian_potential": mean over a Gaussian probe under a Gaussian pump with
            1/e^2 radii w0 and w1, radius = sqrt(w0^2 + w1^2). The last three exclude the film.

        Returns
        -------
        float or ndarray
            Response, in the shape of `time` [conductance] or [1/conductance].

        Raises
        ------
        InvalidArgumentError
            The response is unknown.
        DomainError
            A time is too small.
        """
        wanted, a = code("answer", answer, ANSWERS), number("radius", radius)
        return evaluate("time", time, lambda t: native.conduction_follow(self._handle, wanted, a, t, None))

    def follow(self, time: ArrayLike, given: ArrayLike, radius: float, answer: str = "conductance") -> NDArray[np.float64]:
        """Return the response to a history that is linear between given values.

        Parameters
        ----------
        time : array_like
            Ascending times, one dimension [time].
        given : array_like
            Potentials at these times for "conductance", else fluxes; the first is 0.
        radius : float
            a > 0 [length].
        answer : str, optional
            As in `step`.

        Returns
        -------
        ndarray
            Fluxes for "conductance", else potentials.

        Raises
        ------
        InvalidArgumentError
            The times do not ascend, the first value is not 0, or the response is unknown.
        """
        wanted, a = code("answer", answer, ANSWERS), number("radius", radius)
        _, t, values = one_path(time, given=given)
        status, found = native.conduction_follow(self._handle, wanted, a, t, values)
        check(status)
        return np.asarray(found)

    def admittance(self, omega: ArrayLike, radius: float, answer: str = "conductance") -> ComplexOrArray:
        """Return the responses of `step` to exp(i omega t).

        Parameters
        ----------
        omega : array_like
            Angular frequencies >= 0, any shape [1/time]; 0 is the steady state.
        radius : float
            a > 0 [length].
        answer : str, optional
            As in `step`.

        Returns
        -------
        complex or ndarray
            Response, in the shape of `omega`.

        Raises
        ------
        InvalidArgumentError
            A frequency is negative, or the response is unknown.
        """
        wanted, a = code("answer", answer, ANSWERS), number("radius", radius)
        return complex_values("omega", omega, lambda w: native.conduction_admittance(self._handle, wanted, a, w))

    def impedance(self, omega: ArrayLike, radius: float) -> ComplexOrArray:
        """Return the impedance, potential per flux, of an equipotential contact area.

        Parameters
        ----------
        omega : array_like
            Angular frequencies >= 0, any shape [1/time].
        radius : float
            a > 0 [length].

        Returns
        -------
        complex or ndarray
            Impedance, in the shape of `omega` [1/conductance].

        Raises
        ------
        InvalidArgumentError
            A frequency is negative.
        """
        return self.admittance(omega, radius, "resistance")


@dataclass(frozen=True)
class TabulatedConduction(Conduction):
    """Conduction with a table of its conductance, from `Conduction.tabulated`.

    Outside the table the conductance is solved.

    Parameters
    ----------
    body, other, film, sink
        As in `Conduction`.
    smallest : float
        Smallest radius of the table, > 0 [length].
    largest : float
        Largest radius of the table, > `smallest` [length].
    tolerance : float
        Relative tolerance, 1e-10 to 1e-2 [1].

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    Examples
    --------
    >>> gold, steel = mdr.conduction.Conductor(300.0), mdr.conduction.Conductor(15.0)
    >>> plated = mdr.conduction.Conduction(mdr.conduction.LayeredConductor([(gold, 1e-6)], steel))
    >>> table = plated.tabulated(1e-7, 1e-5)
    >>> print(f"{table.at_radius(1e-6).conductance:.6e} {plated.at_radius(1e-6).conductance:.6e}")
    4.978188e-04 4.978188e-04
    """

    smallest: float = 0.0
    largest: float = 0.0
    tolerance: float = 1e-8

    def __post_init__(self) -> None:
        super().__post_init__()
        ends = [number(name, getattr(self, name)) for name in ("smallest", "largest", "tolerance")]
        self._set(_handle=Handle(native.conduction_tabulate(self._handle, *ends)))


@dataclass(frozen=True)
class Spot:
    """Steady contact area through which flux passes, from `Conduction.at_radius`.

    Parameters
    ----------
    conduction : Conduction
        The bodies.
    radius : float or ndarray
        a, radius of the contact area [length].

    Raises
    ------
    ArgumentTypeError
        Fields are requested of several radii.

    Examples
    --------
    >>> copper = mdr.conduction.Conduction(mdr.conduction.Conductor(400.0))
    >>> spot = copper.at_radius(1e-6)
    >>> print(f"{spot.conductance:.3e} {spot.potential(0.0, 1e-6):.4f}")
    1.600e-03 0.5000
    """

    conduction: Conduction = field(repr=False)
    radius: FloatOrArray
    conductance: FloatOrArray
    """G, flux per potential [conductance]"""
    slope: FloatOrArray
    """dG/da [conductance/length]"""

    def flux(self, r: ArrayLike) -> FloatOrArray:
        """Return the flux density through the contact area at potential 1.

        Parameters
        ----------
        r : array_like
            Radii, 0 <= r < a, any shape [length].

        Returns
        -------
        float or ndarray
            Flux density, in the shape of `r` [conductance/length^2]; infinite at the edge without a film.

        Raises
        ------
        DomainError
            A radius is not smaller than a.
        """
        return self._field(_layout.FLUX, r, 0.0, "lower", "above")

    def potential(self, r: ArrayLike, z: ArrayLike, body: str = "lower", side: str = "below") -> FloatOrArray:
        """Return the potential inside a body at total potential 1.

        Parameters
        ----------
        r : array_like
            Distances from the axis, >= 0 [length]. `r` and `z` broadcast.
        z : array_like
            Depths below the surface of the body, >= 0 [length].
        body : {"lower", "upper"}, optional
            The body; its potential counts from its own far field.
        side : {"below", "above"}, optional
            Side of an interface with a resistance, if z is at one.

        Returns
        -------
        float or ndarray
            Potential, in the broadcast shape [1].

        Raises
        ------
        InvalidArgumentError
            A coordinate is negative, or the body does not exist.
        """
        return self._field(_layout.POTENTIAL, r, z, body, side)

    def flux_inside(
        self, r: ArrayLike, z: ArrayLike, body: str = "lower", side: str = "below"
    ) -> tuple[FloatOrArray, FloatOrArray]:
        """Return the flux density inside a body at total potential 1.

        Parameters
        ----------
        r : array_like
            As in `potential` [length].
        z : array_like
            As in `potential` [length].
        body : {"lower", "upper"}, optional
            As in `potential`.
        side : {"below", "above"}, optional
            As in `potential`.

        Returns
        -------
        tuple
            Flux density into the body and away from the axis, in the broadcast shape [conductance/length^2]. In a PERFECT base they
            are what enters it, and 0.

        Raises
        ------
        InvalidArgumentError
            A coordinate is negative, or the body does not exist.
        """
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
