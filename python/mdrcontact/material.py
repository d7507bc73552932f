# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials: elastic ones, isotropic or with an axis, viscoelastic ones, the rigid one; and what they conduct with."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _layout
from ._boundary import ComplexOrArray, FloatOrArray, Handle, call, complex_values, evaluate, native, number, numbers, record
from ._parameters import WithParameters
from ._units import MODULUS, RATIO, TIME, VISCOSITY
from ._value import Named
from .errors import ArgumentTypeError, InvalidArgumentError


def check_rows(rows: NDArray[np.float64]) -> None:
    """Lets the library check layers: what lies on an insulating base without a sink costs nothing to make."""
    base = _layout.BASE_INSULATING
    Handle(native.conduction_new(rows, base, 0, None, base, 0.0, 0.0))


@dataclass(frozen=True)
class Conductor(WithParameters):
    """Material that conducts current or heat.

    Parameters
    ----------
    sigma : float
        Conductivity into the body, > 0 [conductance/length]; S/m or W/(m K) in SI units.
    along : float, optional
        Conductivity along the surface, > 0 [conductance/length]. None, the default, is that into the body.
    capacity : float, optional
        Heat capacity per volume, >= 0; J/(m^3 K) in SI units. 0, the default, has no transient.

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    Examples
    --------
    >>> copper = mdr.conduction.Conductor(400.0, capacity=3.4e6)
    >>> print(f"{mdr.conduction.Conduction(copper).at_radius(1e-6).conductance:.4e}")
    1.6000e-03
    """

    sigma: float
    along: float | None = None
    capacity: float = 0.0

    def __post_init__(self) -> None:
        self._set(sigma=number("sigma", self.sigma), capacity=number("capacity", self.capacity))
        if self.along is not None:
            self._set(along=number("along", self.along))
        check_rows(np.array([self._row(1.0)]))

    def _row(self, thickness: float = 0.0, resistance: float = 0.0) -> tuple[float, ...]:
        """Return a row of struct mdr_conductor."""
        return thickness, self.sigma, self.sigma if self.along is None else self.along, self.capacity, resistance


@dataclass(frozen=True)
class Elastic(WithParameters):
    """Isotropic elastic material.

    Parameters
    ----------
    E : float
        Young's modulus > 0 [modulus]; Pa with metres and newtons.
    nu : float
        Poisson's ratio, -1 < nu <= 0.5 [1].
    conductor : Conductor, optional
        What the material conducts heat or current with, so that one body serves a contact and its `Conduction`.

    Raises
    ------
    InvalidArgumentError
        E or nu is outside its range.
    ArgumentTypeError
        `conductor` is not a `Conductor`.

    Examples
    --------
    >>> oxide = mdr.Elastic(72e9, 0.17)
    >>> print(f"{oxide.contact_modulus:.4e}")
    7.4143e+10
    """

    E: float = field(metadata={"dimension": MODULUS})
    nu: float = field(metadata={"dimension": RATIO})
    conductor: Conductor | None = None

    def __post_init__(self) -> None:
        self._set(E=number("E", self.E), nu=number("nu", self.nu))
        if self.conductor is not None and not isinstance(self.conductor, Conductor):
            raise ArgumentTypeError(f"conductor = {self.conductor!r}: it must be a Conductor")
        # the library's half-space of this material checks E and nu, and computes E*
        self._set(_handle=_half_space(self))

    def __repr__(self) -> str:
        known = "" if self.conductor is None else f", conductor={self.conductor!r}"
        return f"Elastic(E={self.E!r}, nu={self.nu!r}{known})"

    @property
    def contact_modulus(self) -> float:
        """`E* = E/(1 - nu^2)`, equation (2) [modulus]."""
        return float(evaluate("a", 1.0, lambda radii: native.medium_values(self._handle, _layout.MODULUS, radii)))

    def _layer(self) -> dict[str, float]:
        """Members of struct mdr_layer."""
        return {"E": self.E, "nu": self.nu}


@dataclass(frozen=True)
class TransverselyIsotropic(WithParameters):
    """Elastic material that is isotropic in the plane of the surface.

    The axis z is the normal of the surface. Examples are hexagonal crystals with the axis c along z (ZnO, GaN, graphite), columnar
    films, bone and fibre mats.

    Parameters
    ----------
    C11, C12, C13, C33, C44 : float, optional
        Stiffnesses; 3 is the axis z [modulus]. Every strain must cost energy: C11 > |C12|, C33 > 0, C44 > 0,
        2 C13^2 < C33 (C11 + C12).
    engineering : tuple of float, optional
        E_t, E_z, nu_t, nu_tz, G_z instead of the stiffnesses; see `from_engineering`. The stiffnesses are then computed and are
        infinite for an incompressible material.

    Raises
    ------
    InvalidArgumentError
        A strain would cost no energy, or both forms are given.

    References
    ----------
    elliott-1948
    delafargue-2004

    Examples
    --------
    >>> gallium_nitride = mdr.TransverselyIsotropic(390e9, 145e9, 106e9, 398e9, 105e9)
    >>> print(f"{gallium_nitride.contact_modulus:.4e} {mdr.CRYSTALS['GaN'].material.contact_modulus:.4e}")
    3.3045e+11 3.3045e+11
    """

    C11: float = field(default=0.0, metadata={"dimension": MODULUS})
    C12: float = field(default=0.0, metadata={"dimension": MODULUS})
    C13: float = field(default=0.0, metadata={"dimension": MODULUS})
    C33: float = field(default=0.0, metadata={"dimension": MODULUS})
    C44: float = field(default=0.0, metadata={"dimension": MODULUS})
    engineering: tuple[float, float, float, float, float] | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        if self.engineering is None:
            self._set(**{name: number(name, getattr(self, name)) for name in _STIFFNESSES})
        else:
            beside = [name for name in _STIFFNESSES if number(name, getattr(self, name)) != 0.0]
            if beside:
                raise InvalidArgumentError(f"{beside[0]}: it follows from engineering. Give one of the two")
            given = tuple(number(name, value) for name, value in zip(_ENGINEERING, self.engineering, strict=True))
            self._set(engineering=given)
        # the library's half-space of this material checks the numbers, and computes E*
        self._set(_handle=_half_space(self))
        if self.engineering is not None:
            self._set(**_stiffnesses(*self.engineering))

    @classmethod
    def from_engineering(cls, E_t: float, E_z: float, nu_t: float, nu_tz: float, G_z: float) -> TransverselyIsotropic:
        """Return the material given by its engineering constants.

        Parameters
        ----------
        E_t : float
            Young's modulus in the plane, > 0 [modulus].
        E_z : float
            Young's modulus along z, > 0 [modulus].
        nu_t : float
            Poisson's ratio in the plane, -1 < nu_t < 1 [1].
        nu_tz : float
            Minus the strain along z over the strain along t under a stress along t in the plane [1]; 2 nu_tz^2 E_z/E_t <= 1 - nu_t.
        G_z : float
            Shear modulus of planes that contain z, > 0 [modulus].

        Returns
        -------
        TransverselyIsotropic
            The material.

        Raises
        ------
        InvalidArgumentError
            A constant is outside its range.
        """
        return cls(engineering=(E_t, E_z, nu_t, nu_tz, G_z))

    def __repr__(self) -> str:
        if self.engineering is not None:
            given = ", ".join(f"{name}={value!r}" for name, value in zip(_ENGINEERING, self.engineering, strict=True))
            return f"TransverselyIsotropic.from_engineering({given})"
        return f"TransverselyIsotropic({', '.join(f'{name}={getattr(self, name)!r}' for name in _STIFFNESSES)})"

    def _given(self) -> dict[str, Any]:
        if self.engineering is not None:
            return {"engineering": self.engineering}
        return {name: getattr(self, name) for name in _STIFFNESSES}

    def _constants(self) -> dict[str, Any]:
        return self._given() if self.engineering is None else dict(zip(_ENGINEERING, self.engineering, strict=True))

    def _rebuilt(self, constants: dict[str, Any]) -> TransverselyIsotropic:
        make = TransverselyIsotropic if self.engineering is None else TransverselyIsotropic.from_engineering
        return make(**constants)

    @property
    def contact_modulus(self) -> float:
        """E* of a half-space of the material, Delafargue and Ulm (2004) [modulus]."""
        return float(evaluate("a", 1.0, lambda radii: native.medium_values(self._handle, _layout.MODULUS, radii)))

    @property
    def tangential_modulus(self) -> float:
        """`G_0*`, with the tangential stiffness `2 a G_0*` without slip [modulus]."""
        quantity = _layout.TANGENTIAL_MODULUS
        return float(evaluate("a", 1.0, lambda radii: native.medium_values(self._handle, quantity, radii)))

    def _layer(self) -> dict[str, float]:
        """Members of struct mdr_layer."""
        if self.engineering is not None:
            return dict(zip(_ENGINEERING_MEMBERS, self.engineering, strict=True))
        return {name: getattr(self, name) for name in _STIFFNESSES}


def _half_space(material: Elastic | TransverselyIsotropic) -> Handle:
    """The medium of a half-space."""
    body = Handle(native.body_layered(0, None, record(_layout.layer, **material._layer()), None))
    return Handle(native.medium_new(body, None))


_STIFFNESSES = ("C11", "C12", "C13", "C33", "C44")
_ENGINEERING = {"E_t": MODULUS, "E_z": MODULUS, "nu_t": RATIO, "nu_tz": RATIO, "G_z": MODULUS}
_ENGINEERING_MEMBERS = ("E", "E_z", "nu", "nu_tz", "G_z")


def _stiffnesses(E_t: float, E_z: float, nu_t: float, nu_tz: float, G_z: float) -> dict[str, float]:
    in_plane, shear = E_t / (1.0 - nu_t**2), E_t / (2.0 * (1.0 + nu_t))
    rest = 1.0 - nu_t - 2.0 * nu_tz**2 * E_z / E_t
    C33 = E_z * (1.0 - nu_t) / rest if rest > 0.0 else math.inf
    C13 = C33 * nu_tz / (1.0 - nu_t) if nu_tz else 0.0
    C11 = in_plane + (C13 * nu_tz / (1.0 - nu_t) if nu_tz else 0.0)
    return {"C11": C11, "C12": C11 - 2.0 * shear, "C13": C13, "C33": C33, "C44": G_z}


class _Rheology(WithParameters):
    """Base of viscoelastic materials."""

    def relaxation(self, t: ArrayLike) -> FloatOrArray:
        """Return the shear relaxation modulus G(t).

        Parameters
        ----------
        t : array_like
            Times >= 0, any shape [time]. G(0) is the glassy modulus. A dashpot contributes nothing at t > 0.

        Returns
        -------
        float or ndarray
            G, in the shape of `t` [modulus].

        Raises
        ------
        InvalidArgumentError
            t = 0 for a power law or a dashpot, whose G(0) is infinite.
        """
        return evaluate("t", t, lambda values: self._values(_layout.RELAXATION, values))

    def creep(self, t: ArrayLike) -> FloatOrArray:
        """Return the shear creep compliance J(t), the strain under a unit stress.

        Parameters
        ----------
        t : array_like
            Times >= 0, any shape [time].

        Returns
        -------
        float or ndarray
            J, in the shape of `t` [1/modulus]; J(0) = 0 for power laws and dashpots.

        Raises
        ------
        InvalidArgumentError
            A time is negative.
        """
        return evaluate("t", t, lambda values: self._values(_layout.CREEP, values))

    def complex_modulus(self, omega: ArrayLike) -> ComplexOrArray:
        """Return the complex shear modulus.

        Parameters
        ----------
        omega : array_like
            Angular frequencies > 0, any shape [1/time].

        Returns
        -------
        complex or ndarray
            Storage modulus (real part) and loss modulus (imaginary part), in the shape of `omega` [modulus].

        Raises
        ------
        InvalidArgumentError
            A frequency is not finite and greater than 0.
        """
        modulus = _layout.COMPLEX_MODULUS
        return complex_values("omega", omega, lambda values: native.material_values(self._handle, modulus, values))

    def _values(self, quantity: int, t: NDArray[np.float64]) -> tuple[int, NDArray[np.float64]]:
        status, values, _ = native.material_values(self._handle, quantity, t)
        return status, values

    @property
    def glassy(self) -> Elastic:
        """Elastic material of a sudden load.

        Power laws and dashpots have none and raise `InvalidArgumentError`.
        """
        return Elastic(*call(native.material_limit, self._handle, _layout.LIMIT_GLASSY))

    @property
    def relaxed(self) -> Elastic:
        """Elastic material of a load that has lasted.

        A material that flows without end has none and raises `InvalidArgumentError`.
        """
        return Elastic(*call(native.material_limit, self._handle, _layout.LIMIT_RELAXED))

    def _layer(self) -> dict[str, Handle]:
        """Members of struct mdr_layer."""
        return {"material": self._handle}


@dataclass(frozen=True)
class Viscoelastic(_Rheology):
    """Linear viscoelastic material with a Prony series.

    The shear modulus relaxes as `G(t) = relaxed_shear_modulus + sum g_i exp(-t/tau_i)`. Give exactly one of `nu` and
    `bulk_modulus`.

    Parameters
    ----------
    relaxed_shear_modulus : float
        G(infinity) >= 0 [modulus]; 0 is a material that flows without end.
    terms : iterable of (float, float)
        Moduli g_i > 0 [modulus] and relaxation times tau_i > 0 [time]; may be empty.
    nu : float, optional
        Constant Poisson's ratio, -1 < nu <= 0.5 [1].
    bulk_modulus : float, optional
        Elastic bulk modulus K > 0 [modulus]. Poisson's ratio then increases as the shear modulus relaxes, as in polymers.
    viscosity : float, optional
        Viscosity of a parallel dashpot, >= 0, with `nu` only [modulus time]. Without terms it makes a Kelvin-Voigt material.

    Raises
    ------
    InvalidArgumentError
        Neither or both of `nu` and `bulk_modulus` are given, or a number is outside its range.

    References
    ----------
    findley-1976

    Examples
    --------
    >>> polymer = mdr.Viscoelastic(1e6, [(9e6, 1.0)], nu=0.5)
    >>> print(f"{polymer.relaxation(1.0):.4e} {polymer.glassy.E:.4e} {polymer.relaxed.E:.4e}")
    4.3109e+06 3.0000e+07 3.0000e+06
    """

    relaxed_shear_modulus: float = field(metadata={"dimension": MODULUS})
    terms: tuple[tuple[float, float], ...]
    nu: float | None = field(metadata={"dimension": RATIO})
    bulk_modulus: float | None = field(metadata={"dimension": MODULUS})
    viscosity: float = field(metadata={"dimension": VISCOSITY})

    def __init__(
        self,
        relaxed_shear_modulus: float,
        terms: Iterable[tuple[float, float]],
        nu: float | None = None,
        bulk_modulus: float | None = None,
        viscosity: float = 0.0,
    ) -> None:
        if (nu is None) == (bulk_modulus is None):
            raise InvalidArgumentError("give either nu or bulk_modulus")
        ratio = 0.0 if nu is None else number("nu", nu)
        bulk = 0.0 if bulk_modulus is None else number("bulk_modulus", bulk_modulus)
        if bulk_modulus is not None and bulk == 0.0:
            raise InvalidArgumentError("bulk_modulus = 0.0: it must be greater than 0")
        pairs = _pairs("terms", terms)
        moduli, times = (np.ascontiguousarray(pairs[:, i]) for i in (0, 1))
        relaxed, dashpot = number("relaxed_shear_modulus", relaxed_shear_modulus), number("viscosity", viscosity)
        created = native.material_viscoelastic(relaxed, len(pairs), moduli, times, dashpot, ratio, bulk)
        self._set(_handle=Handle(created), relaxed_shear_modulus=relaxed, viscosity=dashpot)
        self._set(terms=tuple((g, tau) for g, tau in pairs.tolist()), nu=None if nu is None else ratio)
        self._set(bulk_modulus=None if bulk_modulus is None else bulk)

    def _constants(self) -> dict[str, Any]:
        given = self._given()
        terms = {f"terms[{i}].{name}": term[j] for i, term in enumerate(given.pop("terms")) for j, name in enumerate(_TERM)}
        relaxed = {"relaxed_shear_modulus": given.pop("relaxed_shear_modulus")}
        viscosity = {"viscosity": given.pop("viscosity")}
        return {**relaxed, **terms, **viscosity, **given}

    def _rebuilt(self, constants: dict[str, Any]) -> Viscoelastic:
        terms = [tuple(constants.pop(f"terms[{i}].{name}") for name in _TERM) for i in range(len(self.terms))]
        return self.replace(terms=terms, **constants)

    @classmethod
    def from_fractions(
        cls,
        instant_modulus: float,
        rows: Iterable[Iterable[float]],
        nu: float,
        *,
        modulus: str = "young",
        elastic_bulk: bool = True,
    ) -> Viscoelastic:
        """Return the material of a Prony table in the form of finite-element programs.

        Parameters
        ----------
        instant_modulus : float
            Modulus of a sudden load, > 0 [modulus]: Young's modulus, or the shear modulus with modulus="shear".
        rows : iterable
            Rows (g_i, tau_i) or (g_i, k_i, tau_i): fractions of the instant shear and bulk modulus that relax [1], and times
            [time]. All k_i must be 0 (elastic bulk) or equal g_i (constant Poisson's ratio).
        nu : float
            Poisson's ratio of a sudden load, -1 < nu <= 0.5 [1].
        modulus : {"young", "shear"}, optional
            What `instant_modulus` is.
        elastic_bulk : bool, optional
            For rows without k_i: True, the default, if the bulk modulus does not relax; False if it relaxes as the shear modulus.

        Returns
        -------
        Viscoelastic
            The material.

        Raises
        ------
        InvalidArgumentError
            The table is empty or ragged, its fractions add to more than 1, or a number is outside its range.
        """
        given = [row if isinstance(row, Iterable) else () for row in (rows if isinstance(rows, Iterable) else ())]
        table = [[number("rows", value) for value in row] for row in given]
        if not table or {len(row) for row in table} not in ({2}, {3}):
            raise InvalidArgumentError("rows: it must hold rows (g, tau), or rows (g, k, tau)")
        fractions, times = np.array([row[0] for row in table]), np.array([row[-1] for row in table])
        if len(table[0]) == 3:
            bulk_fractions = np.array([row[1] for row in table])
            elastic_bulk = not bulk_fractions.any()
            if not elastic_bulk and not np.allclose(bulk_fractions, fractions, rtol=1e-9, atol=0.0):
                raise InvalidArgumentError("the fractions k: they must all be 0, or all equal the fractions g")
        if fractions.sum() > 1.0 + 1e-12:
            raise InvalidArgumentError(f"the fractions g: their sum {fractions.sum():.7g} is greater than 1")
        stiff, ratio = number("instant_modulus", instant_modulus), number("nu", nu)
        if modulus not in ("young", "shear"):
            raise InvalidArgumentError(f"modulus = {modulus!r}: it must be 'young' or 'shear'")
        instant = Elastic(stiff if modulus == "young" else 2.0 * stiff * (1.0 + ratio), ratio)  # checks both
        shear = stiff if modulus == "shear" else 0.5 * instant.E / (1.0 + ratio)
        relaxed = max(shear * (1.0 - fractions.sum()), 0.0)
        terms = list(zip(shear * fractions, times, strict=True))
        if elastic_bulk and ratio < 0.5:
            return cls(relaxed, terms, bulk_modulus=instant.E / (3.0 * (1.0 - 2.0 * ratio)))
        return cls(relaxed, terms, nu=ratio)

    @classmethod
    def from_prony_text(
        cls, text: str, instant_modulus: float, nu: float, *, modulus: str = "young", elastic_bulk: bool = True
    ) -> Viscoelastic:
        """Return the material of a Prony table given as text.

        Parameters
        ----------
        text : str
            Lines "g, k, tau" or "g, tau", separated by commas or blanks, or lines "TBDATA,1,g,tau,g,tau" of a shear modulus.
            Comments (*, #, !) and lines of words are ignored.
        instant_modulus : float
            As in `from_fractions` [modulus].
        nu : float
            As in `from_fractions` [1].
        modulus : {"young", "shear"}, optional
            As in `from_fractions`.
        elastic_bulk : bool, optional
            As in `from_fractions`.

        Returns
        -------
        Viscoelastic
            The material.

        Raises
        ------
        InvalidArgumentError
            No line contains numbers, or the table is one of a bulk modulus.
        """
        rows: list[list[float]] = []
        listed = []
        for line in text.splitlines():
            words = re.split("[#!]", line.upper())[0].replace(",", " ").split()
            if words[:2] == ["TB", "PRONY"] and "BULK" in words:
                raise InvalidArgumentError("the table of a bulk modulus: give that of the shear modulus alone")
            data = words[:1] == ["TBDATA"]
            try:
                row = [float(word.replace("D", "E")) for word in (words[2:] if data else words)]
            except ValueError:
                continue
            if data:
                listed += row
            elif row:
                rows.append(row)
        rows += [listed[i : i + 2] for i in range(0, len(listed), 2)]
        if not rows:
            raise InvalidArgumentError("the text: no line of it holds numbers g, tau or g, k, tau alone")
        return cls.from_fractions(instant_modulus, rows, nu, modulus=modulus, elastic_bulk=elastic_bulk)


_TERM = ("modulus", "time")


@dataclass(frozen=True)
class PowerLawRheology(_Rheology):
    """Material whose shear modulus relaxes as a power law of time.

    The shear modulus is `G(t) = modulus (t/time)^(-exponent)`, as of cells, gels and soft glasses.

    Parameters
    ----------
    modulus : float
        G at `time`, > 0 [modulus].
    time : float
        Reference time > 0 [time].
    exponent : float
        Exponent, > 0 (elastic limit) and < 1 (viscous limit) [1].
    nu : float
        Constant Poisson's ratio, -1 < nu <= 0.5 [1].

    Raises
    ------
    InvalidArgumentError
        A number is outside its range.

    Examples
    --------
    >>> cell = mdr.PowerLawRheology(modulus=1e3, time=1.0, exponent=0.2, nu=0.5)
    >>> print(f"{cell.relaxation(10.0):.2f}")
    630.96
    """

    modulus: float = field(metadata={"dimension": MODULUS})
    time: float = field(metadata={"dimension": TIME})
    exponent: float = field(metadata={"dimension": RATIO})
    nu: float = field(metadata={"dimension": RATIO})

    def __post_init__(self) -> None:
        self._set(_handle=Handle(native.material_power_law(*self._numbers())))


Material = Elastic | TransverselyIsotropic | Viscoelastic | PowerLawRheology
"""Materials of a body."""


def material(name: str, value: object) -> Any:
    """`value` if it is a material; an exception if it is anything else."""
    if not isinstance(value, Material):
        words = "it must be an Elastic(E, nu), a TransverselyIsotropic(...), a Viscoelastic(...) or a PowerLawRheology(...)"
        raise ArgumentTypeError(f"{name} = {value!r}: {words}")
    return value


def _pairs(name: str, values: Iterable[tuple[float, float]]) -> NDArray[np.float64]:
    array = numbers(name, list(values)) if isinstance(values, Iterable) else np.empty(1)
    if isinstance(values, Iterable) and not array.size:
        return np.empty((0, 2))
    if array.ndim != 2 or array.shape[1] != 2:
        raise ArgumentTypeError(f"{name}: it must be a list of pairs (modulus, time)")
    return array


class _Rigid(Named):
    """The type of `RIGID` and `SMOOTH`."""


RIGID = _Rigid("RIGID")
"""A rigid base under a layer: for the models "exact", "dimitriadis" and "garcia"."""
SMOOTH = _Rigid("SMOOTH")
"""A rigid base without friction under a layer, for the model "exact": the same as RIGID below a sliding interface."""
