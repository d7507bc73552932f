# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of retract curves at several speeds together: modulus, work of adhesion, and how it depends on the speed of the edge."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ... import _scipy
from ..._boundary import number, numbers
from ..._choices import nearest
from ..._units import FORCE, SPEED
from ..._value import Value
from ..._warn import collected, silence, texts_of, warn_all
from ...adhesion import rate_history
from ...contact import Contact
from ...errors import ArgumentTypeError, InvalidArgumentError, MDRError, NoConvergenceError
from ...panels import Figure, Line, Panel, along
from .least_squares import Coordinate, ParameterFit, central_differences, estimate, names_of, solve

__all__ = ["RateCurve", "RateFit", "fit_rate"]

_TOLERANCE = 1e-8
"""Tolerance of the histories in a fit."""
_STEP = 1e-4
"""Step of the logarithms of the parameters, for slopes."""
_OFFSETS = ("position_offset", "force_offset")
_FEWEST = 5
_RISEN = 0.85
"""Fraction of the lowest force after which readings are not fitted."""
_LAGS = np.concatenate([np.linspace(0.0, 0.9, 91), np.linspace(0.9025, 0.99, 36)])
"""Range of the search for the level of the noise."""


@dataclass(frozen=True, eq=False)
class RateCurve(Value):
    """Retraction curve for `fit_rate`.

    The readings go from rest in contact to beyond the lowest force. A rupture is a jump; readings after it are not fitted.

    Parameters
    ----------
    time : array_like
        Strictly ascending times, at least 5 [time].
    position : array_like
        Position of the far end of the spring, or the indentation depth without a spring [length].
    force : array_like
        Forces [modulus length^2].
    spring_stiffness : float, optional
        Stiffness of the cantilever or frame, > 0 [modulus length]. None: `position` is the indentation depth.

    Raises
    ------
    InvalidArgumentError
        The columns differ in length, are too short or not finite, or the times do not ascend.

    Examples
    --------
    >>> position, force = [0.0, -1e-7, -2e-7, -3e-7, -4e-7], [0.0, -1e-7, -2e-7, -1e-7, 0.0]
    >>> curve = mdr.instruments.RateCurve([0.0, 1.0, 2.0, 3.0, 4.0], position, force)
    >>> print(curve.count, f"{curve.speed:.1e}")
    5 1.0e-07
    """

    time: NDArray[np.float64]
    position: NDArray[np.float64]
    force: NDArray[np.float64]
    spring_stiffness: float | None = None

    def __init__(self, time: ArrayLike, position: ArrayLike, force: ArrayLike, spring_stiffness: float | None = None) -> None:
        columns = {"time": numbers("time", time), "position": numbers("position", position), "force": numbers("force", force)}
        sizes = {values.shape for values in columns.values()}
        if len(sizes) != 1 or columns["time"].ndim != 1 or columns["time"].size < _FEWEST:
            raise InvalidArgumentError(f"time, position and force must have the same length, at least {_FEWEST}, and one dimension")
        if not all(np.all(np.isfinite(values)) for values in columns.values()) or np.any(np.diff(columns["time"]) <= 0.0):
            raise InvalidArgumentError("time must be strictly ascending, and time, position and force finite")
        stiffness = None if spring_stiffness is None else number("spring_stiffness", spring_stiffness)
        self._set(**columns, spring_stiffness=stiffness)

    @property
    def count(self) -> int:
        """Number of fitted readings, which end shortly after the lowest force."""
        at = int(np.argmin(self.force))
        risen = np.flatnonzero(self.force[at:] > _RISEN * self.force[at])
        return max(at + (int(risen[0]) if risen.size else len(self.force) - at), _FEWEST)

    @property
    def speed(self) -> float:
        """Mean speed of the position, > 0 for a retraction [length/time]."""
        return float((self.position[0] - self.position[-1]) / (self.time[-1] - self.time[0]))


@dataclass(frozen=True, eq=False, kw_only=True)
class RateFit(ParameterFit):
    """Result of `fit_rate`; its intervals include the correlation of the noise.

    Examples
    --------
    >>> law = mdr.adhesion.RateAdhesion(work=0.05, speed=1e-6, exponent=0.5)
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(1e6, 0.5)), adhesion=law)
    >>> def pulled(duration):
    ...     time = np.linspace(0.0, duration, 40)
    ...     depth = np.linspace(0.5e-6, -1.5e-6, 40)
    ...     return mdr.instruments.RateCurve(time, depth, mdr.adhesion.rate_history(contact, time, depth=depth, start="rest").force)
    >>> start = contact.replace(adhesion=law.replace(work=0.04), work_of_adhesion=0.0)
    >>> found = mdr.instruments.fit_rate([pulled(10.0), pulled(1.0)], start, ["work"])
    >>> print(f"{found.values['work']:.4f}")
    0.0500
    """

    contact: Contact
    """the contact with the fitted parameters"""
    curves: tuple[RateCurve, ...]
    """the fitted curves"""
    fitted: tuple[NDArray[np.float64], ...]
    """forces of the model at the fitted readings of each curve [modulus length^2]"""
    lag: float
    """correlation of the noise of neighbouring readings [1]"""
    warnings: tuple[str, ...] = ()
    """warnings about the histories of the fit"""

    def summary(self) -> str:
        """Return the result as text.

        Returns
        -------
        str
            Estimates, standard errors, intervals, notes and warnings.
        """
        return "\n".join([super().summary(), *(f"warning: {words}" for words in self.warnings)])

    def _head(self) -> str:
        return f"{len(self.curves)} curves, correlation of neighbouring readings {self.lag:.2f}"

    def pull_off(self, speed: float, spring_stiffness: float | None = None, index: int = 0) -> float:
        """Return the lowest force of the model at another speed.

        Parameters
        ----------
        speed : float
            Speed of the retraction, > 0 [length/time].
        spring_stiffness : float, optional
            Stiffness of the spring [modulus length]; None is that of the curve.
        index : int, optional
            Number of the curve from whose first reading the retraction starts.

        Returns
        -------
        float
            Lowest force [modulus length^2].

        Raises
        ------
        NoConvergenceError
            The contact does not break.
        """
        curve, offset = self.curves[index], self.values.get("position_offset", 0.0)
        start = float(curve.position[0]) - offset
        reach = abs(start)
        for _ in range(30):
            path = [start, start - reach]
            end = _follow(self.contact, [0.0, reach / number("speed", speed)], path, spring_stiffness or curve.spring_stiffness).end
            if end["ruptures"]:
                return float(end["lowest_force"])
            reach *= 2.0
        raise NoConvergenceError(f"the contact does not break within {reach:.3g} of retraction")

    def plot(self, points: int = 25) -> Figure:
        """Return the pull-off force against the speed as a figure: readings and fit.

        Numbers are taken as SI.

        Parameters
        ----------
        points : int, optional
            Number of speeds of the curve of the fit.

        Returns
        -------
        Figure
            The figure.
        """
        speeds, offset = np.array([curve.speed for curve in self.curves]), self.values.get("force_offset", 0.0)
        read = np.array([offset - np.min(curve.force) for curve in self.curves])
        line = np.geomspace(0.3 * speeds.min(), 3.0 * speeds.max(), points)
        fitted = np.array([-self.pull_off(float(speed)) for speed in line])
        x, speed = along("retraction speed", SPEED, speeds, log=True)
        y, force = along("pull-off force", FORCE, read, log=True)
        parts = (
            Line(speed.of(line), force.of(fitted), "fit", 0),
            Line(speed.of(speeds), force.of(read), "readings", 1, -1, "o"),
        )
        return Figure("Pull-off force", (Panel(x, y, parts),))


def fit_rate(curves: Sequence[RateCurve], contact: Contact, free: Iterable[str] = ("work", "speed", "exponent")) -> RateFit:
    """Fit a modulus and a rate-dependent work of adhesion to retraction curves.

    All curves, at several speeds, are fitted together. The noise of neighbouring readings may be correlated; the fit estimates and
    removes this correlation. It needs SciPy.

    Parameters
    ----------
    curves : sequence of RateCurve
        Curves from rest in contact. One speed alone does not determine both `speed` and `work`.
    contact : Contact
        Contact with `adhesion`. Its numbers are the starting values, and the fixed values of other parameters.
    free : iterable of str, optional
        Numbers of the adhesion ("work", "speed", "exponent"; "work", "cohesive_stress" of a rheology), "E" of a homogeneous body,
        "coating.E" and "substrate.E" of a coated one, and "position_offset" and "force_offset", which are subtracted from the
        readings.

    Returns
    -------
    RateFit
        Estimates, uncertainties and notes.

    Raises
    ------
    ArgumentTypeError
        The curves or the contact are of another type, or the contact has no `adhesion`.
    InvalidArgumentError
        A name is unknown.

    References
    ----------
    patterson-1971

    Examples
    --------
    >>> law = mdr.adhesion.RateAdhesion(work=0.05, speed=1e-6, exponent=0.5)
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(1e6, 0.5)), adhesion=law)
    >>> time, depth = np.linspace(0.0, 10.0, 40), np.linspace(0.5e-6, -1.5e-6, 40)
    >>> force = mdr.adhesion.rate_history(contact, time, depth=depth, start="rest").force
    >>> start = contact.replace(adhesion=law.replace(work=0.04), work_of_adhesion=0.0)
    >>> found = mdr.instruments.fit_rate([mdr.instruments.RateCurve(time, depth, force)], start, ["work"])
    >>> print(f"{found.values['work']:.4f}")
    0.0500
    """
    _scipy.require()
    from scipy.stats import t as student

    problem = _Problem(tuple(curves), contact, names_of(free))
    u = problem.start()
    lag = 0.0
    with silence():
        for _ in range(3):
            residuals, slopes = partial(problem.residuals, lag=lag), partial(problem.slopes, lag=lag)
            u = solve(residuals, u, jac=slopes, method="lm", xtol=1e-8, ftol=1e-10).u
            lag, before = problem.lag(u), lag
            if abs(lag - before) < 0.02:
                break
        found = estimate(u, problem.residuals(u, lag), problem.slopes(u, lag))
    # readings whose noise is correlated show its size as fewer free ones would
    freedom = len(found.residuals) * (1.0 - lag) / (1.0 + lag) - len(u)
    fields = found.fields(problem.coordinates, student.ppf(0.975, max(freedom, 1.0)) * found.spread)
    with collected() as doubts:
        fitted = tuple(problem.forces(u))
    warn_all(doubts)
    best = problem.contact_at(fields["values"])
    return RateFit(**fields, contact=best, curves=problem.curves, fitted=fitted, lag=lag, warnings=texts_of(doubts))


class _Problem:
    """Residuals over the parameters: logarithms of what is positive, offsets in parts of the readings' size."""

    def __init__(self, curves: tuple[RateCurve, ...], contact: Contact, names: tuple[str, ...]) -> None:
        if not curves or not all(isinstance(curve, RateCurve) for curve in curves):
            raise ArgumentTypeError("curves: it must be a list of RateCurve")
        if contact.adhesion is None:
            raise ArgumentTypeError("contact: it must have adhesion=, the start of the fit")
        self.curves, self.contact, self.names = curves, contact, names
        sizes = {"position_offset": float(max(np.ptp(c.position) for c in curves)),
                 "force_offset": float(max(np.ptp(c.force) for c in curves))}  # fmt: skip
        self.coordinates = [Coordinate(name, name not in _OFFSETS, sizes.get(name, 1.0)) for name in names]
        known = (*_numbers(contact), *_OFFSETS)
        for name in names:
            if name not in known:
                raise InvalidArgumentError(f"free = {name!r}: {nearest(name, known)}")

    def start(self) -> NDArray[np.float64]:
        """The parameters of the contact."""
        given = _numbers(self.contact)
        return np.array([0.0 if name in _OFFSETS else np.log(given[name]) for name in self.names])

    def values(self, u: NDArray[np.float64]) -> dict[str, float]:
        """The parameters."""
        return {one.name: one.value(x) for one, x in zip(self.coordinates, u, strict=True)}

    def contact_at(self, values: Mapping[str, float]) -> Contact:
        """The contact with other numbers."""
        return _with_numbers(self.contact, {name: value for name, value in values.items() if name not in _OFFSETS})

    def forces(self, u: NDArray[np.float64]) -> list[NDArray[np.float64]]:
        """Forces of the model, with their offset."""
        values = self.values(u)
        contact, offset = self.contact_at(values), values.get("position_offset", 0.0)
        found = []
        for curve in self.curves:
            part = slice(0, curve.count)
            path = _follow(contact, curve.time[part], curve.position[part] - offset, curve.spring_stiffness)
            found.append(path.force + values.get("force_offset", 0.0))
        return found

    def misfits(self, u: NDArray[np.float64]) -> list[NDArray[np.float64]]:
        """Readings less model, in parts of the lowest force of each curve."""
        pairs = zip(self.curves, self.forces(u), strict=True)
        return [(curve.force[: curve.count] - force) / abs(np.min(curve.force)) for curve, force in pairs]

    def residuals(self, u: NDArray[np.float64], lag: float) -> NDArray[np.float64]:
        """Misfits without what they have from their neighbours; far off where the model has no such contact."""
        try:
            misfits = self.misfits(u)
        except MDRError:
            return np.full(sum(curve.count for curve in self.curves), 10.0)
        return np.concatenate([_whitened(misfit, lag) for misfit in misfits])

    def slopes(self, u: NDArray[np.float64], lag: float) -> NDArray[np.float64]:
        """Slopes by central differences."""
        return central_differences(partial(self.residuals, lag=lag), u, _STEP * np.eye(len(u))) / _STEP

    def lag(self, u: NDArray[np.float64]) -> float:
        """Correlation of neighbouring misfits, by restricted likelihood: what the parameters take out of the misfits is allowed
        for (Patterson and Thompson, Biometrika 58 (1971) 545)."""
        misfits = self.misfits(u)
        ends = np.cumsum([len(m) for m in misfits])[:-1]
        slopes = np.split(self.slopes(u, 0.0), ends)
        return float(min(_LAGS, key=lambda lag: _unlikelihood(misfits, slopes, lag)))


def _unlikelihood(misfits: list[NDArray[np.float64]], slopes: list[NDArray[np.float64]], lag: float) -> float:
    """Minus twice the logarithm of the restricted likelihood of a lag."""
    r = np.concatenate([_whitened(misfit, lag) for misfit in misfits])
    X = np.concatenate([_whitened(slope, lag) for slope in slopes])
    q, triangle = np.linalg.qr(X)
    left = float(r @ r) - float(np.sum((q.T @ r) ** 2))
    spread = (len(r) - len(misfits)) * np.log(1.0 - lag**2)
    size = 2.0 * np.sum(np.log(np.abs(np.diag(triangle)) + 1e-300))
    return float(spread + size + (len(r) - X.shape[1]) * np.log(max(left, 1e-300)))


def _whitened(misfit: NDArray[np.float64], lag: float) -> NDArray[np.float64]:
    return np.concatenate([misfit[:1], (misfit[1:] - lag * misfit[:-1]) / np.sqrt(1.0 - lag**2)])


def _follow(contact: Contact, time: ArrayLike, position: ArrayLike, stiffness: float | None) -> Any:
    """Follow a contact from rest."""
    if stiffness is None:
        return rate_history(contact, time, depth=position, start="rest", tolerance=_TOLERANCE)
    return rate_history(contact, time, position=position, spring_stiffness=stiffness, start="rest", tolerance=_TOLERANCE)


def _moduli(contact: Contact) -> dict[str, float]:
    """The moduli of the medium, by the names of its parameters."""
    return {name: value for name, value in contact.medium.parameters().items() if name.split(".")[-1] == "E"}


def _numbers(contact: Contact) -> dict[str, float]:
    """Parameters that can be free, and their values."""
    law = contact.adhesion
    given = {} if law is None else law._given()
    return {**{name: value for name, value in given.items() if isinstance(value, float)}, **_moduli(contact)}


def _with_numbers(contact: Contact, values: Mapping[str, float]) -> Contact:
    """The contact with some of them changed."""
    moduli = {name: values[name] for name in _moduli(contact) if name in values}
    law: Any = contact.adhesion
    law = law.replace(**{name: value for name, value in values.items() if name not in moduli})
    return contact.replace(medium=contact.medium.with_parameters(moduli), adhesion=law, work_of_adhesion=0.0)
