# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of poroelastic gels: shear modulus, drained Poisson's ratio and diffusivity from data in time or under oscillation."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import Any

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from ..._parts import share
from ...contact import Contact
from ...errors import ArgumentTypeError, InvalidArgumentError, NoConvergenceError
from ...panels import Figure
from ...poroelastic import DRAINAGES, Poroelastic, body_of, drainage_code, gel_of, history, is_poroelastic
from ...profile import FlatPunch, Paraboloid
from .least_squares import Coordinate, Estimate, ParameterFit, names_of, solve
from .picture import figure_of
from .quantities import measured, words_of
from .time_data import DepthTime, DynamicStiffness, ForceTime

Array = NDArray[np.float64]
Model = Callable[[Array], Array]

__all__ = ["GelFit", "fit_gel", "compare_drainages"]

NAMES = ("shear_modulus", "nu", "diffusivity")
_LOWEST, _HIGHEST = 0.0, 0.499
"""Range of the search for Poisson's ratio."""
_END = 0.55
"""Responses of films scale with 1/(1/2 - nu): polynomials of ln(_END - nu) interpolate them best."""
_AGREE = 5e-5
"""Largest error of an interpolated response, relative to the largest reading; a larger one raises an error."""
_DECADES = np.linspace(-7.0, 5.0, 25)
"""Starts of the diffusivity, in powers of 10 of the squared contact radius over the duration."""
_MOST = 100
"""Number of readings used in the search for starting values."""
_ROUNDS = 200
"""Largest number of rounds of the search."""
_STEP = 1e-5


@dataclass(frozen=True, eq=False, kw_only=True)
class GelFit(ParameterFit):
    """Result of `fit_gel`.

    Examples
    --------
    >>> gel = mdr.poroelastic.Poroelastic(shear_modulus=28e3, nu=0.28, diffusivity=3e-8)
    >>> contact = mdr.Contact(mdr.FlatPunch(1e-3), mdr.Homogeneous(gel))
    >>> time = np.linspace(0.0, 60.0, 30)
    >>> path = mdr.poroelastic.history(contact, time, depth=np.full(30, 5e-5), drainage="surface")
    >>> data = mdr.instruments.ForceTime(time, path.depth, path.force)
    >>> start = mdr.Homogeneous(gel.replace(shear_modulus=10e3, diffusivity=1e-8))
    >>> found = mdr.instruments.fit_gel(data, mdr.FlatPunch(1e-3), start, drainage="surface")
    >>> print(found.drainage, f"{found.values['shear_modulus']:.0f} {found.values['diffusivity']:.2e}")
    surface 28000 3.00e-08
    """

    medium: Any
    """the body with the fitted parameters"""
    drainage: str
    """the drainage of the fit, which is not a fit parameter"""
    data: ForceTime | DepthTime | DynamicStiffness
    """the readings"""
    fitted: Array
    """the model at each reading"""

    def plot(self, title: str = "") -> Figure:
        """Return data, fit and residuals as a figure.

        The residuals are in units of their standard deviation. Numbers are taken as SI.

        Parameters
        ----------
        title : str, optional
            First line of the title.

        Returns
        -------
        Figure
            The figure.
        """
        residuals = self.data.y - self.fitted
        sd = float(np.sqrt(residuals @ residuals / max(len(residuals) - len(self.values), 1)))
        lines = [title] if title else []
        lines += [f"{words_of(name)} = {measured(name, value, self.errors[name])}" for name, value in self.values.items()]
        lines.append(f"drainage {self.drainage!r}")
        return figure_of(self.data, 1.0, self.fitted, residuals / sd if sd > 0.0 else residuals, "fit", lines)

    def to_dict(self) -> dict[str, Any]:
        """Return numbers and notes as plain Python values.

        Returns
        -------
        dict
            Drainage, sum of squares, notes and parameters.
        """
        return {"drainage": self.drainage, **super().to_dict()}

    def _head(self) -> str:
        return f"drainage {self.drainage!r}, {super()._head()}"


def fit_gel(
    data: ForceTime | DepthTime | DynamicStiffness,
    indenter: FlatPunch | Paraboloid,
    medium: Any,
    free: Iterable[str] = ("shear_modulus", "diffusivity"),
    *,
    drainage: str,
) -> GelFit:
    """Fit shear modulus, drained Poisson's ratio and diffusivity of a gel.

    Parameters
    ----------
    data : ForceTime, DepthTime or DynamicStiffness
        `ForceTime` or `DepthTime` of a flat punch along any path, whose first value is reached in a jump; `ForceTime` of a
        paraboloid that is pressed in suddenly and held at one depth; or `DynamicStiffness` at one radius.
    indenter : FlatPunch or Paraboloid
        The indenter.
    medium : Homogeneous or Coated
        A half-space of a `Poroelastic`, or a film of it on a RIGID base. Its numbers are the fixed values.
    free : iterable of str, optional
        Names out of "shear_modulus", "nu" and "diffusivity"; starting values are searched for. nu lies in 0 to 0.499 and needs nine
        tables, which take 1 to 4 seconds the first time.
    drainage : {"surface", "sealed", "indenter"}
        As in `Contact.relaxation`. It is not a fit parameter; see `compare_drainages`.

    Returns
    -------
    GelFit
        Estimates, uncertainties and notes.

    Raises
    ------
    ArgumentTypeError
        The body is not of a gel.
    InvalidArgumentError
        The data are of another kind, or a name or the drainage is unknown.

    References
    ----------
    hu-2010

    Examples
    --------
    >>> gel = mdr.poroelastic.Poroelastic(shear_modulus=28e3, nu=0.28, diffusivity=3e-8)
    >>> contact = mdr.Contact(mdr.FlatPunch(1e-3), mdr.Homogeneous(gel))
    >>> time = np.linspace(0.0, 60.0, 30)
    >>> path = mdr.poroelastic.history(contact, time, depth=np.full(30, 5e-5), drainage="surface")
    >>> data = mdr.instruments.ForceTime(time, path.depth, path.force)
    >>> start = mdr.Homogeneous(gel.replace(shear_modulus=10e3, diffusivity=1e-8))
    >>> found = mdr.instruments.fit_gel(data, mdr.FlatPunch(1e-3), start, drainage="surface")
    >>> print(f"{found.values['shear_modulus']:.0f}")
    28000
    """
    names = _names(free)
    if not is_poroelastic(medium):
        raise ArgumentTypeError(f"medium = {medium!r}: it must be a body of Poroelastic(...)")
    drainage_code(drainage)
    gel = gel_of(medium)
    answers = _Answers(data, indenter, medium, drainage)
    search = _Search(answers.between if "nu" in names else answers.of, data, names, gel)
    found = search.run(_time_scale(data, indenter))
    fields = found.fields(search.coordinates)
    gel = gel.replace(**fields["values"])
    if "nu" in names:
        _check_between_tables(answers, gel.nu, gel.diffusivity)
    if "nu" in names and not _LOWEST < gel.nu < _HIGHEST:
        fields["notes"] += (f"nu is at the end of its range, {gel.nu:.3g}: it has no interval",)
    fields["notes"] += ("the drainage is not a fit parameter: compare_drainages shows its effect on the estimates",)
    return GelFit(**fields, medium=body_of(medium, gel), drainage=drainage, data=data, fitted=search.model(found.u))


def compare_drainages(
    data: ForceTime | DepthTime | DynamicStiffness,
    indenter: FlatPunch | Paraboloid,
    medium: Any,
    free: Iterable[str] = ("shear_modulus", "diffusivity"),
) -> tuple[GelFit, ...]:
    """Fit a gel under each drainage, best fit first.

    Parameters
    ----------
    data : ForceTime, DepthTime or DynamicStiffness
        As in `fit_gel`.
    indenter : FlatPunch or Paraboloid
        As in `fit_gel`.
    medium : Homogeneous or Coated
        As in `fit_gel`.
    free : iterable of str, optional
        As in `fit_gel`.

    Returns
    -------
    tuple of GelFit
        The fits by ascending sum of squares; of a film without "indenter".

    Raises
    ------
    InvalidArgumentError
        As of `fit_gel`.

    Examples
    --------
    >>> gel = mdr.poroelastic.Poroelastic(shear_modulus=28e3, nu=0.28, diffusivity=3e-8)
    >>> contact = mdr.Contact(mdr.FlatPunch(1e-3), mdr.Homogeneous(gel))
    >>> time = np.linspace(0.0, 60.0, 30)
    >>> path = mdr.poroelastic.history(contact, time, depth=np.full(30, 5e-5), drainage="surface")
    >>> data = mdr.instruments.ForceTime(time, path.depth, path.force)
    >>> fits = mdr.instruments.compare_drainages(data, mdr.FlatPunch(1e-3), mdr.Homogeneous(gel))
    >>> print([fit.drainage for fit in fits])
    ['surface', 'sealed', 'indenter']
    """
    wanted = [name for name in DRAINAGES if name != "indenter" or not hasattr(medium, "thickness")]
    names = _names(free)
    fits = share(lambda name: fit_gel(data, indenter, medium, names, drainage=name), wanted)
    return tuple(sorted(fits, key=lambda fit: fit.chi_square))


def _names(free: Iterable[str]) -> tuple[str, ...]:
    names = names_of(free, NAMES)
    return tuple(name for name in NAMES if name in names)


def _case(data: Any, indenter: Any) -> str:
    """The kind of response in the data; raises an error for a kind that is not supported."""
    if isinstance(data, DynamicStiffness):
        if data.given is None or not len(data) or not (data.given == data.given[0]).all():
            raise InvalidArgumentError("radius: oscillations of gels are fitted at one contact radius")
        return "dynamic"
    if isinstance(indenter, FlatPunch) and isinstance(data, (ForceTime, DepthTime)):
        return "depth" if isinstance(data, ForceTime) else "force"
    held = np.zeros(1) if data.given is None or not len(data) else data.given
    if isinstance(indenter, Paraboloid) and isinstance(data, ForceTime) and held[0] > 0.0 and (held == held[0]).all():
        return "held"
    raise InvalidArgumentError(
        "these data cannot be fitted on a gel. A flat punch takes ForceTime and DepthTime along any path, a paraboloid ForceTime "
        "at one constant depth > 0, held from the first time on. Both take DynamicStiffness. Growing contacts are not supported"
    )


def _radius(data: Any, indenter: Any) -> float:
    if isinstance(indenter, FlatPunch) and not isinstance(data, DynamicStiffness):
        return float(indenter.radius)
    if isinstance(data, DynamicStiffness):
        return float(np.asarray(data.given)[0])
    return math.sqrt(float(indenter.radius) * float(data.given[0]))


def _time_scale(data: Any, indenter: Any) -> float:
    """A diffusivity for which the drainage of the contact takes as long as the test, or a period."""
    a = _radius(data, indenter)
    duration = 1.0 / float(data.x.max()) if isinstance(data, DynamicStiffness) else float(np.ptp(data.x))
    if not duration > 0.0:
        raise InvalidArgumentError("time: a fit needs readings at several times")
    return a**2 / duration


class _Answers:
    """The readings of one fit under a shear modulus of 1."""

    def __init__(self, data: Any, indenter: Any, medium: Any, drainage: str) -> None:
        # searches vary one parameter at a time: most steps change neither the diffusivity nor the tables
        self.of = lru_cache(maxsize=4 * len(_TABLES))(partial(_answer, _case(data, indenter), data, indenter, medium, drainage))
        """from the table of a Poisson's ratio, at a diffusivity"""

    def between(self, nu: float, diffusivity: float) -> Array:
        """Readings interpolated between the tables."""
        # a table takes long when it is made, and is kept
        gather: Any = map if self.of.cache_info().misses else share
        values = [*gather(lambda ratio: self.of(ratio, diffusivity), _TABLES)]
        series = chebyshev.chebfit(_PLACES, np.array(values), len(_PLACES) - 1)
        return np.asarray(chebyshev.chebval(_place(nu), series))


def _place(nu: float) -> float:
    """Coordinate of a Poisson's ratio among the tables, -1 to 1."""
    return 2.0 * math.log((_END - nu) / (_END - _HIGHEST)) / math.log((_END - _LOWEST) / (_END - _HIGHEST)) - 1.0


_PLACES = chebyshev.chebpts1(9)
_TABLES = [_END - (_END - _HIGHEST) * ((_END - _LOWEST) / (_END - _HIGHEST)) ** (0.5 * (float(x) + 1.0)) for x in _PLACES]
"""Poisson's ratios of the tables; responses between them are interpolated."""


def _check_between_tables(answers: _Answers, nu: float, diffusivity: float) -> None:
    """Raise an error if the interpolation is inaccurate midway between the two tables around nu."""
    edges = np.array([_LOWEST, *_TABLES[::-1], _HIGHEST])
    i = min(max(int(np.searchsorted(edges, nu)), 1), len(edges) - 1)
    between = float(0.5 * (edges[i - 1] + edges[i]))
    exact = answers.of(between, diffusivity)
    off = float(np.max(np.abs(answers.between(between, diffusivity) - exact)) / np.max(np.abs(exact)))
    if not off <= _AGREE:
        raise NoConvergenceError(
            f"the responses between the tables of {len(_TABLES)} Poisson's ratios have an error of {off:.1e} at nu = "
            f"{between:.3f}, which exceeds {_AGREE:g}. Fix nu"
        )


def _answer(case: str, data: Any, indenter: Any, medium: Any, drainage: str, nu: float, diffusivity: float) -> Array:
    contact = Contact(indenter, body_of(medium, Poroelastic(1.0, nu, diffusivity)))
    if case == "dynamic":
        k = np.asarray(contact.dynamic_stiffness(data.x[::2], radius=float(data.given[0]), drainage=drainage))
        return np.asarray(np.column_stack([k.real, k.imag]).ravel())
    if case == "held":
        a = np.full(len(data), _radius(data, indenter))
        return np.asarray(history(contact, data.x, radius=a, drainage=drainage).force)
    path: dict[str, Any] = {case: data.given}
    found = history(contact, data.x, drainage=drainage, **path)
    return np.asarray(found.force if case == "depth" else found.depth)


class _Search:
    """The least squares in ln G, nu and ln D, by SciPy's trust regions."""

    def __init__(self, shape: Any, data: Any, names: tuple[str, ...], gel: Poroelastic) -> None:
        self.shape, self.data, self.names, self.gel = shape, data, names, gel
        self.y, self.weights = data.y, np.ones(len(data)) if data.sd is None else 1.0 / data.sd
        self.power = -1.0 if isinstance(data, DepthTime) else 1.0
        """of the shear modulus in the data"""
        nu = Coordinate("nu", False, width=_HIGHEST - _LOWEST, limits=(-1.0, 0.5))
        self.coordinates = [nu if name == "nu" else Coordinate(name) for name in names]

    def gel_at(self, u: Array) -> tuple[float, float, float]:
        """G, nu and D."""
        own = dict(zip(self.names, u, strict=True))
        modulus = math.exp(own["shear_modulus"]) if "shear_modulus" in own else self.gel.shear_modulus
        diffusivity = math.exp(own["diffusivity"]) if "diffusivity" in own else self.gel.diffusivity
        return modulus, own.get("nu", self.gel.nu), diffusivity

    def model(self, u: Array) -> Array:
        """The readings."""
        modulus, nu, diffusivity = self.gel_at(u)
        return np.asarray(modulus**self.power * self.shape(nu, diffusivity))

    def start(self, scale: float) -> Array:
        """The best of a grid, with the shear modulus that fits it best."""
        ratios = (0.15, 0.4) if "nu" in self.names else (self.gel.nu,)
        diffusivities = scale * 10.0**_DECADES if "diffusivity" in self.names else [self.gel.diffusivity]
        part = np.unique(np.linspace(0, len(self.y) - 1, min(_MOST, len(self.y))).astype(int))
        y, w = self.y[part] * self.weights[part], self.weights[part]
        best, least = np.zeros(0), math.inf
        for diffusivity in diffusivities:
            for nu in ratios:
                shape = w * self.shape(nu, float(diffusivity))[part]
                factor = self.gel.shear_modulus**self.power
                if "shear_modulus" in self.names:
                    factor = max(float(shape @ y) / float(shape @ shape), 1e-300)
                off = float(np.sum((factor * shape - y) ** 2))
                if off < least:
                    own = {"shear_modulus": math.log(factor) / self.power, "nu": nu, "diffusivity": math.log(diffusivity)}
                    best, least = np.array([own[name] for name in self.names]), off
        return best

    def run(self, scale: float) -> Estimate:
        """Return the estimate at the least sum of squares."""
        low = [_LOWEST if name == "nu" else -math.inf for name in self.names]
        high = [_HIGHEST if name == "nu" else math.inf for name in self.names]
        return solve(
            lambda u: self.weights * (self.y - self.model(u)), self.start(scale), is_absolute=self.data.sd is not None,
            unit=float(np.sqrt(np.mean((self.weights * self.y) ** 2))) or 1.0, jac="3-point", bounds=(low, high), x_scale=1.0,
            diff_step=_STEP, max_nfev=_ROUNDS,
        )  # fmt: skip
