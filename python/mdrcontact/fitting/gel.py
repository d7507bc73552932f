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

from ..contact import Contact
from ..errors import ArgumentTypeError, InvalidArgumentError, NoConvergenceError
from ..poroelastic import DRAINAGES, Poroelastic, body_of, drainage_code, gel_of, is_poroelastic
from ..profile import FlatPunch, Paraboloid
from .time_data import DepthTime, DynamicStiffness, ForceTime

Array = NDArray[np.float64]
Model = Callable[[Array], Array]

__all__ = ["GelFit", "fit_gel", "compare_drainages"]

NAMES = ("shear_modulus", "nu", "diffusivity")
_LOWEST, _HIGHEST = 0.0, 0.499
"""Poisson's ratios between which one is sought."""
_NODES = 9
"""Of them there are tables; the answers between are interpolated, to 1e-6."""
_DECADES = np.linspace(-7.0, 5.0, 25)
"""Starts of the diffusivity, in powers of 10 of the squared contact radius over the duration."""
_MOST = 100
"""Readings that a start is sought with."""
_ROUNDS, _CHANGE = 200, 1e-6
"""Of the search, and the gain of a step, in mean squared residuals, that is none."""
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
    """what the data do not tell, and tell together only"""

    def summary(self) -> str:
        """All of it in words."""
        lines = [f"drainage {self.drainage!r}, {self.points} readings, sum of squares {self.chi_square:.5g}"]
        for name, value in self.values.items():
            low, high = self.intervals[name]
            lines.append(f"{name:14} {value:.6g}, standard error {self.errors[name]:.2g}, 95 %: {low:.5g} to {high:.5g}")
        return "\n".join([*lines, *self.notes])


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
    gel = gel_of(medium)
    shape = partial(_shape, _case(data, indenter), data, indenter, medium, drainage, gel.nu if "nu" not in names else None)
    weights = np.ones(len(data)) if data.sd is None else 1.0 / data.sd
    search = _Search(shape, data.y, weights, names, gel, _power(data))
    values, covariance, residuals = search.run(_time_scale(data, indenter))
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
    nodes = chebyshev.chebpts1(_NODES)
    ratios = _LOWEST + 0.5 * (_HIGHEST - _LOWEST) * (nodes + 1.0)
    rows = [_answer(case, data, indenter, medium, drainage, Poroelastic(1.0, float(r), diffusivity), part) for r in ratios]
    place = 2.0 * (nu - _LOWEST) / (_HIGHEST - _LOWEST) - 1.0
    return np.asarray(_weights(nodes, place) @ np.array(rows))


def _weights(nodes: Array, place: float) -> Array:
    """Of an interpolation, Lagrange's polynomials at one place."""
    weights = np.ones(len(nodes))
    for j, node in enumerate(nodes):
        others = np.delete(nodes, j)
        weights[j] = np.prod((place - others) / (node - others))
    return weights


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
    """Levenberg and Marquardt's search in ln G, nu and ln D."""

    def __init__(self, shape: Any, y: Array, weights: Array, names: tuple[str, ...], gel: Poroelastic, power: float) -> None:
        self.shape, self.y, self.weights, self.names, self.gel, self.power = shape, y, weights, names, gel, power
        self.are_ratios = bool((weights == 1.0).all())

    def gel_at(self, u: Array) -> tuple[float, float, float]:
        """G, nu and D."""
        own = dict(zip(self.names, u, strict=True))
        modulus = math.exp(own["shear_modulus"]) if "shear_modulus" in own else self.gel.shear_modulus
        diffusivity = math.exp(own["diffusivity"]) if "diffusivity" in own else self.gel.diffusivity
        return modulus, own.get("nu", self.gel.nu), diffusivity

    def model(self, u: Array, part: Any = slice(None)) -> Array:
        """The readings."""
        modulus, nu, diffusivity = self.gel_at(u)
        return np.asarray(modulus**self.power * self.shape(nu, diffusivity, part))

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

    def inside(self, u: Array) -> Array:
        """With a Poisson's ratio that is allowed."""
        if "nu" in self.names:
            place = self.names.index("nu")
            u[place] = min(max(u[place], _LOWEST), _HIGHEST)
        return u

    def jacobian(self, u: Array) -> Array:
        """By central differences."""
        columns = []
        for i in range(len(u)):
            ahead, behind = u.copy(), u.copy()
            ahead[i] += _STEP
            behind[i] -= _STEP
            ahead, behind = self.inside(ahead), self.inside(behind)
            columns.append(self.weights * (self.model(ahead) - self.model(behind)) / (ahead[i] - behind[i]))
        return np.array(columns).T

    def run(self, scale: float) -> tuple[Array, Array, Array]:
        """Where the sum of squares is least, the covariance there for unit errors, and the residuals."""
        u, damping = self.start(scale), 1e-3
        r = self.weights * (self.y - self.model(u))
        for _ in range(_ROUNDS):
            slope = self.jacobian(u)
            square = slope.T @ slope
            size = np.diag(square) + 1e-300
            while damping < 1e12:
                step = np.linalg.solve(square + damping * np.diag(size), slope.T @ r)
                tried = self.inside(u + np.clip(step, -2.0, 2.0))
                new = self.weights * (self.y - self.model(tried))
                if new @ new <= r @ r:
                    break
                damping *= 10.0
            else:
                break
            gain = float(r @ r - new @ new)
            expected = float(r @ r - np.sum((r - slope @ (tried - u)) ** 2))
            # where the model is wrong the residuals bend the sum of squares: long steps then swing about the minimum
            damping *= 0.1 if gain > 0.75 * expected else 1.0 if gain > 0.25 * expected else 10.0
            u, r = tried, new
            unit = float(r @ r) / len(r) if self.are_ratios else 1.0
            if gain <= _CHANGE * unit or float(r @ r) <= 1e-28 * float(np.sum((self.weights * self.y) ** 2)):
                break
        else:
            raise NoConvergenceError(f"the fit did not come to rest in {_ROUNDS} steps: leave fewer parameters free")
        slope = self.jacobian(u)
        return u, np.asarray(np.linalg.pinv(slope.T @ slope, rcond=1e-14), np.float64), r


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
    """What the data do not tell."""
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
