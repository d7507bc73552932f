# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of conductors: a layer's conductivity, or an interface's resistance, from G along a load or from impedances (SciPy)."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..._boundary import number, numbers
from ..._choices import nearest
from ..._value import Value
from ...conduction import Conduction, Conductor, LayeredConductor
from ...conduction.contact import ANSWERS
from ...contact import Contact
from ...errors import ArgumentTypeError, InvalidArgumentError
from ...medium import Interface
from .least_squares import Coordinate, ParameterFit, names_of, solve

__all__ = ["ConductanceForce", "Impedance", "ConductionFit", "fit_conduction"]


@dataclass(frozen=True, eq=False)
class ConductanceForce(Value):
    """Measured conductances of a contact under normal forces.

    Parameters
    ----------
    force : array_like
        Forces > 0 [modulus length^2].
    conductance : array_like
        Conductances > 0, as many as forces [conductance].
    contact : Contact
        The contact with known elastic constants, which determines the contact radii.
    sd : float or array_like, optional
        Standard deviation of the conductances [conductance]. None: unknown and equal, relative to the readings.

    Raises
    ------
    InvalidArgumentError
        The two columns differ in length.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Sphere(1e-3), mdr.Homogeneous(mdr.Elastic(120e9, 0.34)))
    >>> data = mdr.instruments.ConductanceForce([0.1, 1.0], [1.3e-2, 2.8e-2], contact)
    >>> print(len(data.force))
    2
    """

    force: NDArray[np.float64]
    conductance: NDArray[np.float64]
    contact: Contact
    sd: Any = None

    def __post_init__(self) -> None:
        self._set(force=numbers("force", self.force), conductance=numbers("conductance", self.conductance))
        if self.force.shape != self.conductance.shape or self.force.ndim != 1:
            raise InvalidArgumentError("conductance: it must have one dimension and as many entries as force")

    def _readings(self) -> NDArray[np.float64]:
        return self.conductance

    def _model(self, conduction: Conduction) -> NDArray[np.float64]:
        states = self.contact.at_force(self.force)
        return np.asarray(conduction.at_radius(np.asarray(states.radius)).conductance)


@dataclass(frozen=True, eq=False)
class Impedance(Value):
    """Measured response of a contact area to oscillations.

    Parameters
    ----------
    omega : array_like
        Angular frequencies > 0 [1/time].
    values : array_like
        Complex responses, as many as frequencies.
    radius : float
        Radius of the contact area, or sqrt(w0^2 + w1^2) of Gaussian pump and probe, > 0 [length].
    answer : {"resistance", "conductance", "mean_potential", "centre_potential", "gaussian_potential"}, optional
        The response, as in `Conduction.admittance`.
    sd : float or array_like, optional
        Standard deviation of real and imaginary part. None: unknown and equal, relative to the readings.

    Raises
    ------
    InvalidArgumentError
        The two columns differ in length, or the response is unknown.

    Examples
    --------
    >>> conduction = mdr.conduction.Conduction(mdr.conduction.Conductor(150.0, capacity=1.6e6))
    >>> omega = np.array([1e5, 1e6])
    >>> data = mdr.instruments.Impedance(omega, conduction.impedance(omega, 1e-6), 1e-6)
    >>> print(data.answer, len(data.values))
    resistance 2
    """

    omega: NDArray[np.float64]
    values: NDArray[np.complex128]
    radius: float
    answer: str = "resistance"
    sd: Any = None

    def __post_init__(self) -> None:
        self._set(omega=numbers("omega", self.omega), values=np.asarray(self.values, complex), radius=number("radius", self.radius))
        if self.omega.shape != self.values.shape or self.omega.ndim != 1:
            raise InvalidArgumentError("values: it must have one dimension and as many entries as omega")
        if self.answer not in ANSWERS:
            raise InvalidArgumentError(f"answer = {self.answer!r}: {nearest(self.answer, ANSWERS)}")

    def _readings(self) -> NDArray[np.float64]:
        return np.concatenate([self.values.real, self.values.imag])

    def _model(self, conduction: Conduction) -> NDArray[np.float64]:
        found = np.asarray(conduction.admittance(self.omega, self.radius, self.answer))
        return np.concatenate([found.real, found.imag])


@dataclass(frozen=True, eq=False, kw_only=True)
class ConductionFit(ParameterFit):
    """Result of `fit_conduction`.

    If the standard deviations are unknown, the residuals are relative.

    Examples
    --------
    >>> gold, steel = mdr.conduction.Conductor(300.0), mdr.conduction.Conductor(15.0)
    >>> body = mdr.conduction.LayeredConductor([(gold, 1e-6)], steel)
    >>> contact = mdr.Contact(mdr.Sphere(1e-3), mdr.Homogeneous(mdr.Elastic(210e9, 0.3)))
    >>> force = np.array([1e-4, 1e-3, 1e-2])
    >>> radius = contact.at_force(force).radius
    >>> data = mdr.instruments.ConductanceForce(force, mdr.conduction.Conduction(body).at_radius(radius).conductance, contact)
    >>> start = mdr.conduction.Conduction(mdr.conduction.LayeredConductor([(mdr.conduction.Conductor(200.0), 1e-6)], steel))
    >>> found = mdr.instruments.fit_conduction(data, start, ["layer1.sigma"])
    >>> print(f"{found.values['layer1.sigma']:.1f}")
    300.0
    """

    conduction: Conduction
    """the conduction with the fitted parameters"""


def fit_conduction(data: Any, conduction: Conduction, free: Iterable[str]) -> ConductionFit:
    """Fit conductivities, capacities, thicknesses or resistances of conductors.

    It needs SciPy.

    Parameters
    ----------
    data : ConductanceForce, Impedance or sequence of these
        The measurements.
    conduction : Conduction
        The bodies. Free numbers must have starting values > 0.
    free : iterable of str
        Names of the lower body: "layer1.sigma", "layer1.along", "layer1.capacity", "layer1.thickness", "layer1.resistance" (of the
        interface below), and so on, "substrate.sigma"; and "film".

    Returns
    -------
    ConductionFit
        Estimates, uncertainties and notes.

    Raises
    ------
    InvalidArgumentError
        A name is unknown, or a starting value is not greater than 0.
    ArgumentTypeError
        The body is not a `Conductor` or a `LayeredConductor`.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Sphere(1e-3), mdr.Homogeneous(mdr.Elastic(120e9, 0.34)))
    >>> force = np.array([0.01, 0.1, 1.0])
    >>> G = mdr.conduction.Conduction(mdr.conduction.Conductor(400.0)).at_radius(contact.at_force(force).radius).conductance
    >>> data = mdr.instruments.ConductanceForce(force, G, contact)
    >>> start = mdr.conduction.Conduction(mdr.conduction.Conductor(100.0))
    >>> found = mdr.instruments.fit_conduction(data, start, ["substrate.sigma"])
    >>> print(f"{found.values['substrate.sigma']:.1f}")
    400.0
    """
    sets = [data] if isinstance(data, (ConductanceForce, Impedance)) else list(data)
    names = names_of(free)
    start = np.array([_number_of(conduction, name) for name in names])
    if not np.all(start > 0.0):
        raise InvalidArgumentError("a free number must start greater than 0: " + ", ".join(names))
    y = np.concatenate([part._readings() for part in sets])
    weight = np.concatenate([_weights(part) for part in sets])

    def residuals(u: NDArray[np.float64]) -> NDArray[np.float64]:
        tried = _with_numbers(conduction, names, np.exp(u))
        return np.asarray(weight * (np.concatenate([part._model(tried) for part in sets]) - y))

    found = solve(
        residuals, np.log(start), is_absolute=all(part.sd is not None for part in sets),
        method="lm" if len(y) >= len(names) else "trf", diff_step=1e-6, xtol=1e-12,
    )  # fmt: skip
    fields = found.fields([Coordinate(name) for name in names])
    return ConductionFit(**fields, conduction=_with_numbers(conduction, names, np.exp(found.u)))


def _weights(part: Any) -> NDArray[np.float64]:
    y = part._readings()
    if part.sd is None:
        return np.full(y.shape, 1.0 / float(np.sqrt(np.mean(y**2)))) if isinstance(part, Impedance) else 1.0 / y
    sd = np.broadcast_to(np.asarray(part.sd, float), (len(y),) if not np.ndim(part.sd) else np.shape(part.sd))
    return 1.0 / (np.concatenate([sd, sd]) if len(sd) != len(y) else sd)


def _body(conduction: Conduction) -> LayeredConductor:
    body = LayeredConductor((), conduction.body) if isinstance(conduction.body, Conductor) else conduction.body
    if not isinstance(body, LayeredConductor):
        raise ArgumentTypeError("body of the conduction: in a fit it must be a Conductor or a LayeredConductor")
    return body


def _place(body: LayeredConductor, name: str) -> tuple[int | None, str]:
    """Layer of a parameter, None for the substrate, and its name there."""
    part, _, key = name.partition(".")
    count = sum(not isinstance(layer, Interface) for layer in body.layers)
    layers = {f"layer{i + 1}": i for i in range(count)}
    keys = ("sigma", "along", "capacity")
    if part == "substrate" and key in keys and isinstance(body.substrate, Conductor):
        return None, key
    if part in layers and key in (*keys, "thickness", "resistance"):
        return layers[part], key
    known = [f"{p}.{k}" for p in (*layers, "substrate") for k in keys] + [
        f"{p}.{k}" for p in layers for k in ("thickness", "resistance")
    ]
    raise InvalidArgumentError(f"free = {name!r}: {nearest(name, [*known, 'film'])}")


def _parts(body: LayeredConductor) -> list[list[Any]]:
    """Conductor, thickness and the resistance below, of each layer."""
    parts: list[list[Any]] = []
    for layer in body.layers:
        if isinstance(layer, Interface):
            parts[-1][2] = layer.resistance
        else:
            parts.append([layer[0], layer[1], 0.0])
    return parts


def _number_of(conduction: Conduction, name: str) -> float:
    if name == "film":
        return float(conduction.film)
    body = _body(conduction)
    layer, key = _place(body, name)
    if layer is not None and key in ("thickness", "resistance"):
        return float(_parts(body)[layer][1 if key == "thickness" else 2])
    conductor: Any = body.substrate if layer is None else _parts(body)[layer][0]
    value = getattr(conductor, key)
    return float(conductor.sigma if value is None else value)


def _with_numbers(conduction: Conduction, names: tuple[str, ...], values: NDArray[np.float64]) -> Conduction:
    body = _body(conduction)
    parts, substrate, film = _parts(body), body.substrate, conduction.film
    for name, value in zip(names, map(float, values), strict=True):
        if name == "film":
            film = value
            continue
        layer, key = _place(body, name)
        if layer is None:
            substrate = substrate.replace(**{key: value})  # type: ignore[union-attr]
        elif key in ("thickness", "resistance"):
            parts[layer][1 if key == "thickness" else 2] = value
        else:
            parts[layer][0] = parts[layer][0].replace(**{key: value})
    stack: list[Any] = []
    for conductor, thickness, resistance in parts:
        stack += [(conductor, thickness)] + ([Interface(resistance)] if resistance else [])
    return conduction.replace(body=LayeredConductor(tuple(stack), substrate), film=film)
