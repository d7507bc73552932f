# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of poroelastic gels: shear modulus, drained Poisson's ratio and diffusivity from data in time or under oscillation."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from ... import _scipy
from ...contact import Contact
from ...errors import ArgumentTypeError, InvalidArgumentError, NoConvergenceError
from ...poroelastic import DRAINAGES, Poroelastic, body_of, drainage_code, gel_of, is_poroelastic
from ...profile import FlatPunch, Paraboloid
from .time_data import DepthTime, DynamicStiffness, ForceTime

Array = NDArray[np.float64]
Model = Callable[[Array], Array]

__all__ = ["GelFit", "fit_gel", "compare_drainages"]

NAMES = ("shear_modulus", "nu", "diffusivity")
_LOWEST, _HIGHEST = 0.0, 0.499
"""Poisson's ratios between which one is sought."""
_END = 0.55
"""Answers of films change as 1/(1/2 - nu) does: polynomials of ln(_END - nu) follow them best."""
_AGREE = 5e-5
"""Of the largest reading: answers between the tables that are further from a table of their own are refused."""
_DECADES = np.linspace(-7.0, 5.0, 25)
"""Starts of the diffusivity, in powers of 10 of the squared contact radius over the duration."""
_MOST = 100
"""Readings that a start is sought with."""
_ROUNDS = 200
"""Of the search, at the most."""
_LOOSE = 0.5
"""A parameter whose standard error is larger, of its value or of Poisson's ratio's range, does not follow from the data."""
_TOGETHER = 0.95
"""Two parameters that are correlated more than this follow from the data together only."""
_STEP = 1e-5


@dataclass(frozen=True, eq=False)
class GelFit:
    """What was found; [0.95] stands for intervals of 95 %, of shear modulus and diffusivity in their logarithms."""

    medium: Any
    """the body with the parameters found"""
    drainage: str
    """under which they were found: it cannot be fitted"""
    values: Mapping[str, float]
    """the free parameters"""
    errors: Mapping[str, float]
    """their standard errors"""
    intervals: Mapping[str, tuple[float, float]]
    """of 95 %"""
    correlation: Array
    """of the free parameters, in the order of `values`"""
    fitted: Array
    """what the model says of each reading"""
    chi_square: float
    """sum of the squared residuals, in standard deviations where those are known, else in the unit of the data"""
    points: int
    """readings"""
    notes: tuple[str, ...]
    """what the data do not determine, and determine together only"""

    def summary(self) -> str:
        """All of it in words."""
        lines = [f"drainage {self.drainage!r}, {self.points} readings, sum of squares {self.chi_square:.5g}"]
        for name, value in self.values.items():
            low, high = self.intervals[name]
            lines.append(f"{name:14} {value:.6g}, standard error {self.errors[name]:.2g}, 95 %: {low:.5g} to {high:.5g}")
        return "\n".join([*lines, *self.notes])

    def to_dict(self) -> dict[str, Any]:
        """The numbers and notes as plain Python values."""
        parameters = {
            name: {"value": value, "standard_error": self.errors[name], "interval": list(self.intervals[name])}
            for name, value in self.values.items()
        }
        return {
            "drainage": self.drainage,
            "sum_of_squares": self.chi_square,
            "notes": list(self.notes),
            "parameters": parameters,
        }


def fit_gel(
    data: ForceTime | DepthTime | DynamicStiffness,
    indenter: FlatPunch | Paraboloid,
    medium: Any,
    free: Iterable[str] = ("shear_modulus", "diffusivity"),
    *,
    drainage: str,
) -> GelFit:
    """Finds shear modulus, drained Poisson's ratio and diffusivity of a gel by least squares.

    data : ForceTime(...) or DepthTime(...) of a flat punch along any path from the first time on, which is reached in a jump;
        ForceTime of a paraboloid that is pressed in at once and held: one constant depth; DynamicStiffness(...) at one radius
    indenter : FlatPunch(...) or Paraboloid(...)
    medium : Homogeneous(Poroelastic(...)), or Coated(Poroelastic(...), h, RIGID): its numbers are those that are not free
    free : of "shear_modulus", "nu", "diffusivity"; a start is sought for all of them. nu from 0 to 0.499; it takes nine tables,
        some seconds the first time
    drainage : "surface", "sealed" or "indenter". It is no number and cannot be fitted: `compare_drainages` shows all three
    """
    names = _names(free)
    if not is_poroelastic(medium):
        raise ArgumentTypeError(f"medium = {medium!r} is not allowed: it must be a body of Poroelastic(...)")
    drainage_code(drainage)
    _scipy.require()
    gel = gel_of(medium)
    answers = partial(_shape, _case(data, indenter), data, indenter, medium, drainage)
    shape = partial(answers, gel.nu if "nu" not in names else None)
    weights = np.ones(len(data)) if data.sd is None else 1.0 / data.sd
    search = _Search(shape, data.y, weights, names, gel, _power(data))
    values, covariance, residuals = search.run(_time_scale(data, indenter))
    if "nu" in names:
        _check_between_tables(answers, *search.gel_at(values)[1:])
    if data.sd is None:
        covariance = covariance * float(residuals @ residuals) / max(len(data) - len(names), 1)
    return _result(search, data, medium, drainage, values, covariance, residuals)


def compare_drainages(
    data: ForceTime | DepthTime | DynamicStiffness,
    indenter: FlatPunch | Paraboloid,
    medium: Any,
    free: Iterable[str] = ("shear_modulus", "diffusivity"),
) -> tuple[GelFit, ...]:
    """The fits under each drainage, the one that is closest to the data first; of a film without "indenter"."""
    wanted = [name for name in DRAINAGES if name != "indenter" or not hasattr(medium, "thickness")]
    names = _names(free)
    return tuple(sorted((fit_gel(data, indenter, medium, names, drainage=name) for name in wanted), key=lambda fit: fit.chi_square))


def _names(free: Iterable[str]) -> tuple[str, ...]:
    names = tuple(free)
    if isinstance(free, str) or not names or set(names) - set(NAMES) or len(set(names)) != len(names):
        raise InvalidArgumentError(f"free = {free!r} is not allowed: choose from {', '.join(map(repr, NAMES))}, each once")
    return tuple(name for name in NAMES if name in names)


def _case(data: Any, indenter: Any) -> str:
    """What kind of answer the data are; refuses what is not solved."""
    if isinstance(data, DynamicStiffness):
        if data.given is None or not len(data) or not (data.given == data.given[0]).all():
            raise InvalidArgumentError("radius is not allowed: oscillations of gels are fitted at one contact radius")
        return "dynamic"
    if isinstance(indenter, FlatPunch) and isinstance(data, (ForceTime, DepthTime)):
        return "depth" if isinstance(data, ForceTime) else "force"
    held = np.zeros(1) if data.given is None or not len(data) else data.given
    if isinstance(indenter, Paraboloid) and isinstance(data, ForceTime) and held[0] > 0.0 and (held == held[0]).all():
        return "held"
    raise InvalidArgumentError(
        "these data are not fitted on a gel: a flat punch takes ForceTime and DepthTime along any path, a paraboloid ForceTime at "
        "one constant depth > 0, held from the first time on, and both DynamicStiffness; contacts that grow are not solved"
    )


def _power(data: Any) -> float:
    """Of the shear modulus in the data."""
    return -1.0 if isinstance(data, DepthTime) else 1.0


def _radius(data: Any, indenter: Any) -> float:
    if isinstance(indenter, FlatPunch) and not isinstance(data, DynamicStiffness):
        return float(indenter.radius)
    if isinstance(data, DynamicStiffness):
        return float(np.asarray(data.given)[0])
    return math.sqrt(float(indenter.radius) * float(data.given[0]))


def _time_scale(data: Any, indenter: Any) -> float:
    """A diffusivity with which a contact drains in the duration of the test, or a period."""
    a = _radius(data, indenter)
    duration = 1.0 / float(data.x.max()) if isinstance(data, DynamicStiffness) else float(np.ptp(data.x))
    if not duration > 0.0:
        raise InvalidArgumentError("time is not allowed: a fit needs readings at several times")
    return a**2 / duration


def _shape(
    case: str, data: Any, indenter: Any, medium: Any, drainage: str, fixed: float | None, nu: float, diffusivity: float, part: Any
) -> Array:
    """The readings of `part` under a shear modulus of 1: from the table of the given Poisson's ratio, or interpolated."""
    if fixed is not None:
        return _answer(case, data, indenter, medium, drainage, Poroelastic(1.0, fixed, diffusivity), part)
    rows = [_answer(case, data, indenter, medium, drainage, Poroelastic(1.0, ratio, diffusivity), part) for ratio in _TABLES]
    series = chebyshev.chebfit(_PLACES, np.array(rows), len(_PLACES) - 1)
    return np.asarray(chebyshev.chebval(_place(nu), series))


def _place(nu: float) -> float:
    """Of a Poisson's ratio among the tables, -1 to 1."""
    return 2.0 * math.log((_END - nu) / (_END - _HIGHEST)) / math.log((_END - _LOWEST) / (_END - _HIGHEST)) - 1.0


_PLACES = chebyshev.chebpts1(9)
_TABLES = [_END - (_END - _HIGHEST) * ((_END - _LOWEST) / (_END - _HIGHEST)) ** (0.5 * (float(x) + 1.0)) for x in _PLACES]
"""Poisson's ratios of which there are tables; the answers between are interpolated."""


def _check_between_tables(shape: Any, nu: float, diffusivity: float) -> None:
    """Refuses an interpolation that is not its source midway between the two tables around nu."""
    edges = np.array([_LOWEST, *_TABLES[::-1], _HIGHEST])
    i = min(max(int(np.searchsorted(edges, nu)), 1), len(edges) - 1)
    between = float(0.5 * (edges[i - 1] + edges[i]))
    exact = shape(between, between, diffusivity, slice(None))
    off = float(np.max(np.abs(shape(None, between, diffusivity, slice(None)) - exact)) / np.max(np.abs(exact)))
    if not off <= _AGREE:
        raise NoConvergenceError(
            f"the answers between the tables of {len(_TABLES)} Poisson's ratios are off by {off:.1e} at nu = {between:.3f}: more "
            f"than is allowed, {_AGREE:g}; fix nu"
        )


def _answer(case: str, data: Any, indenter: Any, medium: Any, drainage: str, gel: Poroelastic, part: Any) -> Array:
    contact = Contact(indenter, body_of(medium, gel))
    if case == "dynamic":
        k = np.asarray(contact.dynamic_stiffness(data.x[::2], radius=float(data.given[0]), drainage=drainage))
        return np.asarray(np.column_stack([k.real, k.imag]).ravel()[part])
    if case == "held":
        a = np.full(len(data), _radius(data, indenter))
        return np.asarray(contact.history(data.x, radius=a, drainage=drainage).force[part])
    path: dict[str, Any] = {case: data.given}
    found = contact.history(data.x, drainage=drainage, **path)
    return np.asarray((found.force if case == "depth" else found.depth)[part])


class _Search:
    """The least squares in ln G, nu and ln D, by SciPy's trust regions."""

    def __init__(self, shape: Any, y: Array, weights: Array, names: tuple[str, ...], gel: Poroelastic, power: float) -> None:
        self.shape, self.y, self.weights, self.names, self.gel, self.power = shape, y, weights, names, gel, power

    def gel_at(self, u: Array) -> tuple[float, float, float]:
        """G, nu and D."""
        own = dict(zip(self.names, u, strict=True))
        modulus = math.exp(own["shear_modulus"]) if "shear_modulus" in own else self.gel.shear_modulus
        diffusivity = math.exp(own["diffusivity"]) if "diffusivity" in own else self.gel.diffusivity
        return modulus, own.get("nu", self.gel.nu), diffusivity

    def model(self, u: Array) -> Array:
        """The readings."""
        modulus, nu, diffusivity = self.gel_at(u)
        return np.asarray(modulus**self.power * self.shape(nu, diffusivity, slice(None)))

    def start(self, scale: float) -> Array:
        """The best of a grid, with the shear modulus that fits it best."""
        ratios = (0.15, 0.4) if "nu" in self.names else (self.gel.nu,)
        diffusivities = scale * 10.0**_DECADES if "diffusivity" in self.names else [self.gel.diffusivity]
        part = np.unique(np.linspace(0, len(self.y) - 1, min(_MOST, len(self.y))).astype(int))
        y, w = self.y[part] * self.weights[part], self.weights[part]
        best, least = np.zeros(0), math.inf
        for nu in ratios:
            for diffusivity in diffusivities:
                shape = w * self.shape(nu, float(diffusivity), part)
                factor = self.gel.shear_modulus**self.power
                if "shear_modulus" in self.names:
                    factor = max(float(shape @ y) / float(shape @ shape), 1e-300)
                off = float(np.sum((factor * shape - y) ** 2))
                if off < least:
                    own = {"shear_modulus": math.log(factor) / self.power, "nu": nu, "diffusivity": math.log(diffusivity)}
                    best, least = np.array([own[name] for name in self.names]), off
        return best

    def run(self, scale: float) -> tuple[Array, Array, Array]:
        """Where the sum of squares is least, the covariance there for unit errors, and the residuals."""
        from scipy.optimize import least_squares

        low = [_LOWEST if name == "nu" else -math.inf for name in self.names]
        high = [_HIGHEST if name == "nu" else math.inf for name in self.names]
        unit = float(np.sqrt(np.mean((self.weights * self.y) ** 2))) or 1.0
        found = least_squares(
            lambda u: self.weights * (self.y - self.model(u)) / unit,
            self.start(scale), "3-point", (low, high), x_scale=1.0, diff_step=_STEP, max_nfev=_ROUNDS,
        )  # fmt: skip
        if not found.success:
            raise NoConvergenceError(f"the fit did not come to rest in {_ROUNDS} steps: leave fewer parameters free")
        slope = unit * found.jac
        return found.x, np.asarray(np.linalg.pinv(slope.T @ slope, rcond=1e-14), np.float64), unit * found.fun


def _result(search: _Search, data: Any, medium: Any, drainage: str, u: Array, covariance: Array, residuals: Array) -> GelFit:
    modulus, nu, diffusivity = search.gel_at(u)
    gel = Poroelastic(modulus, nu, diffusivity)
    spread = np.sqrt(np.diag(covariance))
    values, errors, intervals = {}, {}, {}
    for name, at, sd in zip(search.names, u, spread, strict=True):
        reach = 1.96 * float(sd)
        values[name] = getattr(gel, name)
        if name == "nu":
            errors[name] = float(sd)
            intervals[name] = (max(float(at) - reach, -1.0), min(float(at) + reach, 0.5))
        else:
            errors[name] = values[name] * float(sd)
            intervals[name] = (values[name] * math.exp(-min(reach, 700.0)), values[name] * math.exp(min(reach, 700.0)))
    correlation = covariance / np.maximum(np.outer(spread, spread), 1e-300)
    notes = _notes(search.names, u, spread, correlation)
    square = float(residuals @ residuals)
    return GelFit(body_of(medium, gel), drainage, values, errors, intervals, correlation, search.model(u), square, len(data), notes)


def _notes(names: tuple[str, ...], u: Array, spread: Array, correlation: Array) -> tuple[str, ...]:
    """What the data do not determine."""
    notes = []
    for name, at, sd in zip(names, u, spread, strict=True):
        if not sd <= _LOOSE * (_HIGHEST - _LOWEST if name == "nu" else 1.0):
            notes.append(f"{name} does not follow from these data: fix it, or measure where it matters")
        elif name == "nu" and not _LOWEST < at < _HIGHEST:
            notes.append(f"nu is at the end of its range, {at:.3g}: its interval is none")
    for i, first in enumerate(names):
        for j in range(i + 1, len(names)):
            if abs(correlation[i, j]) > _TOGETHER:
                notes.append(
                    f"{first} and {names[j]} follow from these data together only: their correlation is {correlation[i, j]:.3f}"
                )
    notes.append("the drainage is no parameter: compare_drainages shows how far the numbers move with it")
    return tuple(notes)
