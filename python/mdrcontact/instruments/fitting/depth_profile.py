# SPDX-License-Identifier: GPL-3.0-or-later
"""Modulus of a film at each depth of a dynamic measurement, and at zero depth."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..._boundary import call, native
from ..._units import LENGTH, practical
from ...errors import ArgumentTypeError, InvalidArgumentError
from ...panels import Band, Figure, Line, Panel, along
from ..records.segments import effective_points
from .data import StiffnessDepth
from .many import fit_many
from .oliver_pharr import OliverPharr, oliver_pharr
from .parameters import Free, Instrument, JointPrior
from .problem import make_problem
from .quantities import dimension_of, measured, words_of
from .result import FitResult, Interval

Array = NDArray[np.float64]

_FEWEST = 5


class DepthProfile(NamedTuple):
    """Modulus at each depth and at zero depth, from `modulus_at_depths`.

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(163e9, 0.22))
    >>> states = mdr.Contact(mdr.Paraboloid(1e-6), film).at_depth(np.linspace(10e-9, 60e-9, 8))
    >>> data = mdr.instruments.StiffnessDepth(states.depth, states.force, states.stiffness, relative_sd=0.01)
    >>> profile = mdr.instruments.modulus_at_depths(data, mdr.Paraboloid(1e-6), film, ["coating.E"])
    >>> print(f"{profile.at_zero / 1e9:.2f} {profile.modulus[-1] / 1e9:.2f}")
    72.00 72.00
    """

    name: str
    """name of the parameter, as "coating.E" """
    analysis: OliverPharr
    """depths, contact radii, reduced moduli and hardness, on the body with the modulus at zero depth"""
    modulus: Array
    """modulus at each point, NaN if it does not exist [modulus]"""
    standard_error: Array
    """standard error from the stiffness alone [modulus]"""
    common_error: Array
    """error from tip, thickness and other parameters with a prior, similar at neighbouring points [modulus]"""
    at_zero: float
    """value at zero depth of a straight line through the moduli [modulus]"""
    at_zero_error: float
    """standard error of this value: scatter with correlation, and common errors [modulus]"""
    interval: Interval
    """95 % interval of the modulus at zero depth [modulus]"""
    slope: float
    """slope of the line, 0 within its error for an elastic homogeneous film [modulus/length]"""
    slope_error: float
    """standard error of the slope [modulus/length]"""
    failures: dict[int, str]
    """reason why a point has no modulus or no common error, by its number; the line excludes these points"""

    @property
    def warnings(self) -> list[str]:
        """Warnings about the modulus at zero depth."""
        words = []
        for what, values in (("modulus", self.modulus), ("common error", self.modulus + self.common_error)):
            places = [i for i in self.failures if np.isnan(values[i]) and (what == "modulus" or np.isfinite(self.modulus[i]))]
            if places:
                words.append(f"{len(places)} of {len(values)} points have no {what}; the first: {self.failures[places[0]]}")
        if abs(self.slope) > 3.0 * self.slope_error:
            change = self.slope * float(np.nanmax(self.analysis.depth) - np.nanmin(self.analysis.depth))
            words.append(
                f"the modulus changes with depth, by {100.0 * change / self.at_zero:+.0f} % from the first to the last point: "
                "the film "
                "yields, piles up or cracks, or the tip, the contact point or the substrate are not as given. Fit the shallow "
                "part alone"
            )
        return words

    def summary(self) -> str:
        """Return the modulus at zero depth as one line of text, numbers taken as SI.

        Returns
        -------
        str
            The line.
        """
        unit = practical(dimension_of(self.name), [self.at_zero])
        low, high = (end / unit.factor for end in self.interval)
        return (
            f"{words_of(self.name)} at zero depth: {measured(self.name, self.at_zero, self.at_zero_error)}, "
            f"95 % interval {low:.4g} to {high:.4g} {unit.name}"
        )

    def to_dict(self) -> dict[str, Any]:
        """Return the results except the contact depths as plain Python values.

        Returns
        -------
        dict
            The results; None for numbers that are not finite.
        """

        def numbers(values: Array) -> list[float | None]:
            return [float(v) if math.isfinite(v) else None for v in values]

        return {
            "parameter": self.name,
            "unit": dimension_of(self.name).si,
            "at_zero": self.at_zero,
            "at_zero_error": self.at_zero_error,
            "interval": list(self.interval),
            "slope": self.slope,
            "slope_error": self.slope_error,
            "depth": numbers(self.analysis.depth),
            "radius": numbers(self.analysis.radius),
            "modulus": numbers(self.modulus),
            "standard_error": numbers(self.standard_error),
            "common_error": numbers(self.common_error),
            "warnings": self.warnings,
        }

    def plot(self, title: str = "") -> Figure:
        """Return the moduli against depth, and the line to zero depth, as a figure.

        The figure also shows the modulus that a homogeneous body would have. Numbers are taken as SI.

        Parameters
        ----------
        title : str, optional
            First line of the title.

        Returns
        -------
        Figure
            The figure.
        """
        found, finite = self.analysis, self.modulus[np.isfinite(self.modulus)]
        x, length = along("indentation depth", LENGTH, found.depth)
        y, unit = along("modulus", dimension_of(self.name), finite)
        order = np.argsort(found.depth)
        depth, modulus = length.of(found.depth[order]), self.modulus[order]
        common, ends = 1.96 * self.common_error[order], np.array([0.0, float(np.nanmax(found.depth))])
        half = np.array([self.interval.upper - self.at_zero])
        parts = (
            Band(depth, unit.of(modulus - common), unit.of(modulus + common), "common error, 95 %", 0),
            Line(depth, unit.of(found.reduced_modulus[order]), "reduced modulus E_r, film not separated", "grey", -1, "x"),
            Line(depth, unit.of(modulus), words_of(self.name), 0, -1, ".", error=1.96 * unit.of(self.standard_error[order])),
            Line(length.of(ends), unit.of(self.at_zero + self.slope * ends), "", 1, width=1.2),
            Line(np.zeros(1), unit.of(np.array([self.at_zero])), "at zero depth, 95 %", 1, -1, "o", error=unit.of(half)),
        )
        return Figure("\n".join([*([title] if title else []), self.summary()]), (Panel(x, y, parts),))


def modulus_at_depths(
    data: StiffnessDepth,
    indenter: Any,
    medium: Any,
    free: Mapping[str, Free | float | None] | Iterable[str],
    *,
    instrument: Instrument | None = None,
    known: Iterable[JointPrior] = (),
    progress: Callable[[int], Any] | None = None,
) -> DepthProfile:
    """Fit a modulus to each point of dynamic data, and extrapolate to zero depth.

    The data are also known as CSM data. At each point it is the modulus under which the exact contact has the measured stiffness.

    Parameters
    ----------
    data : StiffnessDepth
        At least 5 points, with standard deviations.
    indenter : Profile
        As in `fit`.
    medium : Medium
        As in `fit`.
    free : mapping or iterable of str
        As in `fit`. One parameter has no prior: it is fitted at each point. The others stay at their priors; the effect of their
        standard deviations is the common error.
    instrument : Instrument, optional
        As in `fit`.
    known : iterable of JointPrior, optional
        As in `fit`.
    progress : callable, optional
        Function of the number of completed points.

    Returns
    -------
    DepthProfile
        Moduli, and the modulus at zero depth.

    Raises
    ------
    ArgumentTypeError
        The data are not `StiffnessDepth`.
    InvalidArgumentError
        There are too few points, no standard deviations, or not exactly one parameter without a prior.

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(163e9, 0.22))
    >>> states = mdr.Contact(mdr.Paraboloid(1e-6), film).at_depth(np.linspace(10e-9, 60e-9, 8))
    >>> data = mdr.instruments.StiffnessDepth(states.depth, states.force, states.stiffness, relative_sd=0.01)
    >>> profile = mdr.instruments.modulus_at_depths(data, mdr.Paraboloid(1e-6), film, ["coating.E"])
    >>> print(profile.summary())
    film modulus E at zero depth: 72.00 ± 0.59 GPa, 95 % interval 64.55 to 79.45 GPa
    """
    if not isinstance(data, StiffnessDepth) or data.force is None:
        raise ArgumentTypeError(f"data = {data!r}: it must be StiffnessDepth(...)")
    if data.sd is None:
        raise InvalidArgumentError(
            "the data have no standard deviations, which one point alone cannot show: give sd or relative_sd"
        )
    if len(data) < _FEWEST:
        raise InvalidArgumentError(f"too few points: {len(data)}; at least {_FEWEST} are needed")
    joint = tuple(known)
    problem = make_problem(data, indenter, medium, free, instrument, known=joint)
    joined = {name for prior in joint for name in prior.names}
    wanted = [name for name, entry in problem.free.items() if entry.prior is None and name not in joined]
    if len(wanted) != 1:
        raise InvalidArgumentError(
            f"free: one parameter without a prior is found at each point; here are {', '.join(wanted) or 'none'}"
        )
    (name,) = wanted
    place = problem.names.index(name)
    values = problem.table[0].copy()
    for i, other in enumerate(problem.names):
        if other in problem.free and other != name and (problem.table[4, i] > 0.0 or other in joined):
            values[i] = problem.table[3, i]
    is_elastic = bool(problem.record["is_elastic"][0])
    points = [
        StiffnessDepth(*(v[i : i + 1] for v in (data.x, data.force, data.y)), sd=data.sd[i : i + 1], elastic=is_elastic)
        for i in range(len(data))
    ]

    failures: dict[int, str] = {}

    def moduli(at: Array, report: Callable[[int], Any] | None = None) -> Sequence[Any]:
        tip, body, tool = problem.pattern.at(at)
        found = fit_many(points, tip, body, {name: problem.free[name]}, instrument=tool, check_units=False, progress=report)
        for i, result in enumerate(found):
            if not isinstance(result, FitResult):
                failures.setdefault(i, str(result.error))
        return found

    found = moduli(values, progress)
    modulus = _modulus(found, name)
    error = np.array([r.standard_errors[name] if isinstance(r, FitResult) else math.nan for r in found])
    shifts = [_modulus(moduli(values + step), name) - modulus for step in _steps(problem, place)]
    common = np.sqrt(np.sum(np.square(shifts), axis=0)) if shifts else np.zeros_like(modulus)
    line = _line(data.x, modulus, error, shifts)
    values[place] = line[0]
    tip, body, tool = problem.pattern.at(values)
    return DepthProfile(name, oliver_pharr(data, tip, tool, medium=body), modulus, error, common, *line, failures)


def _modulus(found: Sequence[Any], name: str) -> Array:
    return np.array([r.estimates[name] if isinstance(r, FitResult) else math.nan for r in found])


def _steps(problem: Any, place: int) -> list[Array]:
    """Changes of the parameters, one standard deviation each, whose effects add up in squares."""
    steps = []
    for i in np.flatnonzero(problem.table[4] > 0.0):
        step = np.zeros(problem.table.shape[1])
        step[i] = problem.table[4, i]
        steps.append(step)
    if len(problem.weights):
        steps += list(np.linalg.pinv(problem.weights).T)
    for step in steps:
        step[place] = 0.0
    return steps


def _line(depth: Array, modulus: Array, error: Array, shifts: list[Array]) -> tuple[float, float, Interval, float, float]:
    """Modulus at zero depth with its standard error and interval, slope with its standard error."""
    good = np.isfinite(modulus) & (error > 0.0)
    for shift in shifts:
        good &= np.isfinite(shift)
    if good.sum() < _FEWEST:
        raise InvalidArgumentError(f"only {int(good.sum())} points have a modulus; at least {_FEWEST} are needed for a line")
    x, y, weight = depth[good], modulus[good], 1.0 / error[good]
    design = np.column_stack([np.ones_like(x), x])
    inverse = np.linalg.pinv(design * weight[:, None]) * weight
    coefficients = inverse @ y
    left = (y - design @ coefficients) * weight
    order = np.argsort(x)
    worth = effective_points(left[order])
    freedom = max(worth - 2.0, 1.0)
    # scatter larger than the standard deviations is believed, smaller is not
    noise = max(float(left @ left) / max(len(x) - 2.0, 1.0), 1.0) * len(x) / worth
    covariance = (inverse / weight) @ (inverse / weight).T * noise
    variance = float(covariance[0, 0]) + sum(float(inverse[0] @ shift[good]) ** 2 for shift in shifts)
    # common errors move the slope as well
    slope_variance = float(covariance[1, 1]) + sum(float(inverse[1] @ shift[good]) ** 2 for shift in shifts)
    half = call(native.fit_quantile, 0.95, freedom) * math.sqrt(variance)
    zero = float(coefficients[0])
    return zero, math.sqrt(variance), Interval(zero - half, zero + half), float(coefficients[1]), math.sqrt(slope_variance)
