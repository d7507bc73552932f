# SPDX-License-Identifier: GPL-3.0-or-later
"""Result of a fit: estimates, their uncertainty, and its quality."""

from __future__ import annotations

import functools
import json
import math
import os
from collections.abc import Mapping, Sequence
from html import escape
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..._boundary import call, native, number, whole
from ..._choices import nearest
from ..._files import replace
from ..._parts import share
from ..._text import aligned, html_table
from ..._units import QUANTITIES, practical
from ...errors import InvalidArgumentError, MDRError
from ...panels import Figure
from ...threads import cores
from .contradictions import contradictions
from .data import ForceDepth, StiffnessDepth
from .indent import Indent, find_indent
from .misfit import LARGE, Misfit, measure_misfit, percent
from .picture import figure_of
from .problem import Problem
from .pyramids import PyramidCorrection
from .quantities import digits, dimension_of, measured, plain, probability, unit_of, words_of
from .report import blocks_of, estimates_of, page
from .scatter import compare_scatter
from .yielding import LayerYield, ratio_words

Array = NDArray[np.float64]

UNLIKELY = 1e-3
"""Random residuals with a smaller probability of their pattern are not believed to be random."""


_NUMBERS = (
    *("chi_square", "prior_chi_square", "degrees_of_freedom", "noise", "noise_is_known", "log_likelihood", "aic", "bic"),
    *("pattern_probability", "lag_correlation", "converged", "iterations", "evaluations", "warnings"),
)
"""Attributes that a dictionary of a result contains under their names."""
_SHOWS = 3.09
"""Standard errors beyond which a pattern is unlikely."""
_FEWEST_FREE = 2.0
"""Fewest degrees of freedom for which the residuals are evidence about the model."""
_ROUNDING = 1e-8
"""Accuracy of the model, relative to the largest reading."""


def _checked_level(level: float) -> float:
    level = number("level", level)
    if not 0.0 < level < 1.0:
        raise InvalidArgumentError(f"level = {level!r}: it must be between 0 and 1")
    return level


class Interval(NamedTuple):
    """Confidence interval; an end is infinite if the data do not limit it."""

    lower: float
    upper: float


class FitResult:
    """Result of `fit`.

    Attributes, by the names of parameters unless stated otherwise: `estimates` (free parameters), `values` (all),
    `standard_errors`, `widening` (factor of the standard error for correlated residuals), `at_bound` (-1, 0, 1); `names` of the
    free parameters; `covariance` and `correlation`, in their order; `indenter`, `medium`, `instrument` with the best values;
    `fitted`, the model at the data; `residuals`, (data - model) in standard deviations of the model; `noise`, factor of the
    standard deviations of the data (1 if they are known), or their standard deviation if none is given; `chi_square`,
    `prior_chi_square`, `degrees_of_freedom`, `log_likelihood`; `pattern_probability`, that random residuals follow each other as
    smoothly (Durbin and Watson 1950; from 50 points on Bartels 1982); `lag_correlation` of neighbouring residuals, which covariance
    and intervals include (Cheang and Reinsel 2000); `converged`, `iterations`, `evaluations`, `warnings`. With yield stresses:
    `yield_ratio`, largest von Mises stress of the elastic contact over the yield stress, of forces against depth; `reverse_yield`,
    R_Y of each layer, of stiffnesses. With `pyramid_correction`: its ratios at the largest contact radius; None without.

    Parameters
    ----------
    problem, values, covariance, widening, at_bound, weakest_direction, fitted, residuals, summary
        What the search returned; `fit` makes the object.

    Raises
    ------
    KeyError
        `summary` is incomplete.

    References
    ----------
    bartels-1982
    cheang-2000
    durbin-1950
    zellner-1964

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> silica = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    >>> force = mdr.Contact(mdr.Paraboloid(10e-6), silica).at_depth(depth).force
    >>> noise = 1e-4 * np.random.default_rng(1).standard_normal(20)
    >>> data = mdr.instruments.ForceDepth(depth, force + noise, sd=1e-4)
    >>> result = mdr.instruments.fit(data, mdr.Paraboloid(10e-6), silica, ["E"])
    >>> print(result.as_text("E"), result.verdict, result.converged)
    71.89 ± 0.35 GPa describes True
    >>> interval = result.interval("E")
    >>> print(f"{interval.lower / 1e9:.2f} {interval.upper / 1e9:.2f}")
    71.21 72.57
    """

    def __init__(
        self,
        problem: Problem,
        values: Array,
        covariance: Array,
        widening: Array,
        at_bound: NDArray[np.int32],
        weakest_direction: Array,
        fitted: Array,
        residuals: Array,
        summary: Any,
    ) -> None:
        self.problem = problem
        self.data = problem.data
        places = [i for i, name in enumerate(problem.names) if name in problem.free]
        self.names = tuple(problem.names[i] for i in places)
        self.values = {name: float(value) for name, value in zip(problem.names, values, strict=True) if name}
        self.estimates = {name: self.values[name] for name in self.names}
        self.covariance: Array = np.asarray(covariance)[np.ix_(places, places)]
        errors = np.sqrt(np.diag(self.covariance))
        self.standard_errors: dict[str, float] = dict(zip(self.names, errors.tolist(), strict=True))
        self.widening = {name: float(widening[i]) for name, i in zip(self.names, places, strict=True)}
        self.at_bound = {name: int(at_bound[i]) for name, i in zip(self.names, places, strict=True)}
        self.weakest_direction = {name: float(weakest_direction[i]) for name, i in zip(self.names, places, strict=True)}
        self.indenter, self.medium, self.instrument = problem.pattern.at(values)
        self.fitted: Array = np.asarray(fitted)
        self.converged = bool(summary["converged"])
        self.iterations, self.evaluations = int(summary["iterations"]), int(summary["evaluations"])
        self.chi_square, self.prior_chi_square = float(summary["chi_square"]), float(summary["prior_chi_square"])
        self.degrees_of_freedom, self.noise = float(summary["degrees_of_freedom"]), float(summary["noise"])
        self.log_likelihood, self.pattern_probability = float(summary["log_likelihood"]), float(summary["pattern_probability"])
        self.weakest, self.lag_correlation = float(summary["weakest"]), float(summary["lag_correlation"])
        self.residuals: Array = np.asarray(residuals)
        self.warnings: list[str] = []
        self.yield_ratio = 0.0
        self.reverse_yield: tuple[LayerYield, ...] = ()
        self.pyramid_correction: PyramidCorrection | None = None
        self._values = np.asarray(values)

    @functools.cached_property
    def misfit(self) -> Misfit:
        """Departure of the model from the data."""
        offset = {"force": "force_offset", "depth": "depth_offset"}.get(self.data.y_name, "")
        return measure_misfit(self.data, self.fitted, self.values.get(offset, 0.0))

    @functools.cached_property
    def indent(self) -> Indent | None:
        """Losses of work and depth, from loading to unloading, of a plastic contact.

        It is None if the record has one of the two alone, if the body springs back, or if it adheres.
        """
        if not isinstance(self.data, ForceDepth):
            return None
        return find_indent(self.data, self.values["depth_offset"], self.values["force_offset"])

    @property
    def is_plastic(self) -> bool:
        """True if unloading, or yield stresses, show that the contact is not elastic."""
        return self.yield_ratio > 1.0 or (self.indent is not None and self.indent.is_within)

    @property
    def noise_is_known(self) -> bool:
        """True if the standard deviations of the data are given as absolute ones."""
        return self.data.sd is not None and not self.problem.record["sd_is_relative"][0]

    @property
    def correlation(self) -> Array:
        """Correlation of the free parameters, 0 for one at its bound [1]."""
        errors = np.array([self.standard_errors[name] for name in self.names])
        scale = np.where(errors > 0.0, errors, 1.0)
        return np.asarray(self.covariance / np.outer(scale, scale))

    @property
    def aic(self) -> float:
        """Akaike's information criterion, corrected for few points [1]."""
        n, k = self._counts()
        return -2.0 * self.log_likelihood + 2.0 * k + 2.0 * k * (k + 1) / max(n - k - 1, 1)

    @property
    def bic(self) -> float:
        """Bayesian (Schwarz) information criterion [1]."""
        n, k = self._counts()
        return -2.0 * self.log_likelihood + k * math.log(n)

    def _counts(self) -> tuple[int, int]:
        return len(self.data), len(self.names) + (0 if self.noise_is_known else 1)

    def interval(
        self, name: str, level: float = 0.95, method: str = "normal", *, draws: int = 200, seed: int | None = None
    ) -> Interval:
        """Return the confidence interval of one free parameter.

        Parameters
        ----------
        name : str
            Name of the parameter.
        level : float, optional
            Level, 0 < level < 1 [1].
        method : {"normal", "profile", "monte-carlo"}, optional
            "normal": from the standard error. "profile": the range in which chi-square, minimized over the other parameters,
            increases by at most its quantile. "monte-carlo": quantiles of the fits of simulated data.
        draws : int, optional
            Number of simulated data sets, >= 2.
        seed : int, optional
            Seed of their random numbers.

        Returns
        -------
        Interval
            Lower and upper end, in the unit of the parameter.

        Raises
        ------
        InvalidArgumentError
            The name or the method is unknown, or the level is outside its range.
        """
        if name not in self.names:
            raise InvalidArgumentError(f"{name!r} is not a free parameter: {nearest(str(name), self.names)}")
        level = _checked_level(level)
        if method == "normal":
            # the widening of a standard error allows for correlated residuals: their number counts once
            reach = call(native.fit_quantile, level, math.inf if self.noise_is_known else self.degrees_of_freedom)
            half = reach * self.standard_errors[name]
            return Interval(self.estimates[name] - half, self.estimates[name] + half)
        if method == "profile":
            problem = self.problem.changed(self.data, start=self._values)
            place = self.problem.names.index(name)
            lower, upper = problem.call(native.fit_interval, place, level)
            return Interval(float(lower), float(upper))
        if method == "monte-carlo":
            return self.simulated_intervals(level, draws=draws, seed=seed)[name]
        known = ("normal", "profile", "monte-carlo")
        raise InvalidArgumentError(f"method = {method!r}: {nearest(str(method), known)}")

    def simulated_intervals(self, level: float = 0.95, *, draws: int = 200, seed: int | None = None) -> dict[str, Interval]:
        """Return the intervals of all free parameters from one simulation.

        They equal `interval` with method "monte-carlo" and the same seed, which repeats the simulation for each parameter.

        Parameters
        ----------
        level : float, optional
            Level, 0 < level < 1 [1].
        draws : int, optional
            Number of simulated data sets, >= 2.
        seed : int, optional
            Seed of their random numbers.

        Returns
        -------
        dict of str to Interval
            Lower and upper end, in the unit of the parameter, by its name.

        Raises
        ------
        InvalidArgumentError
            The level is outside its range.
        MDRError
            Fewer than 90 % of the data sets can be fitted.
        """
        level = _checked_level(level)
        ends = [0.5 * (1.0 - level), 0.5 * (1.0 + level)]
        found = self.simulate(draws, seed)
        return {name: Interval(*map(float, np.quantile(found[:, i], ends))) for i, name in enumerate(self.names)}

    def simulate(self, draws: int = 200, seed: int | None = None) -> Array:
        """Return estimates from simulated data: the fitted curve plus noise.

        Priors are drawn about their estimates, an unknown size of the noise from its distribution. Failed simulations are omitted.

        Parameters
        ----------
        draws : int, optional
            Number of data sets, >= 2.
        seed : int, optional
            Seed of the random numbers.

        Returns
        -------
        ndarray
            Estimates, (draws, parameters).

        Raises
        ------
        MDRError
            Fewer than 90 % of the data sets can be fitted.
        """
        random = np.random.default_rng(seed)
        sd = self.noise * (np.ones_like(self.fitted) if self.data.sd is None else self.data.sd)
        freedom = self.degrees_of_freedom
        errors = self.problem.table[4]
        # joint priors: W (p - value) is drawn with variance 1
        weights = self.problem.weights
        back = np.linalg.pinv(weights) if len(weights) else np.zeros((len(errors), 0))
        joint = np.abs(weights).sum(axis=0) > 0.0
        trials = [
            self.problem.changed(
                # noise that is estimated from few residuals may be larger
                self.data.with_y(
                    self.fitted
                    + sd * self._noise(random) * (1.0 if self.noise_is_known else math.sqrt(freedom / random.chisquare(freedom)))
                ),
                priors=self._values
                + np.where(joint, back @ random.standard_normal(len(weights)), errors * random.standard_normal(errors.shape)),
                start=self._values,
            )
            for _ in range(whole("draws", draws, 2))
        ]

        def one(problem: Problem) -> list[float] | None:
            try:
                values = problem.answer()[0]
            except MDRError:
                return None
            return [float(values[problem.names.index(name)]) for name in self.names]

        rows = [row for row in share(one, trials, threads=cores()) if row is not None]
        if len(rows) < 0.9 * draws:
            raise MDRError(f"only {len(rows)} of {draws} simulated data sets could be fitted: there is no interval from them")
        return np.array(rows)

    def _noise(self, random: np.random.Generator) -> Array:
        """Noise of variance 1 with the correlation that the residuals have along the curve."""
        white = random.standard_normal(len(self.data))
        rho = self.lag_correlation
        noise = np.empty_like(white)
        before = white[0]
        for i, one in enumerate(white):
            before = one if i == 0 else rho * before + math.sqrt(1.0 - rho**2) * one
            noise[i] = before
        along = np.empty_like(noise)
        along[self.data.order()] = noise
        return along

    def summary(self, level: float = 0.95, method: str = "normal", intervals: Mapping[str, Interval] = MappingProxyType({})) -> str:
        """Return estimates, intervals, quality of the fit and warnings as text.

        The numbers of the problem are taken as SI.

        Parameters
        ----------
        level : float, optional
            Level of the intervals, 0 < level < 1 [1].
        method : {"normal", "profile", "monte-carlo"}, optional
            Method that found `intervals`.
        intervals : mapping of str to Interval, optional
            Intervals at this level, by parameter; those of the covariance are computed.

        Returns
        -------
        str
            Several lines.
        """
        how = "" if method == "normal" else f" ({method})"
        rows = [["", "estimate ± standard error", f"{100.0 * level:g} % interval{how}", ""]]
        for name in self.names:
            ends = self.interval_as_text(name, level, intervals.get(name))
            rows.append([f"{words_of(name)} ({name})", self.as_text(name), ends, "; ".join(self.doubts(name))])
        lines = [f"Fit of {len(self.data)} points: " + ("converged" if self.converged else "NOT CONVERGED, best point found")]
        lines[0] += f" after {self.iterations} iterations"
        lines.append(aligned(rows))
        if len(self.data) > 2:
            lines.append(f"the model {self.misfit_words()}")
        dof = self.degrees_of_freedom
        if self.noise_is_known and dof >= 1.0:
            lines.append(
                f"chi-square {plain(self.chi_square)} for {plain(dof)} degrees of freedom: ratio {plain(self.reduced_chi_square)}"
            )
        elif self.data.sd is None and not self.noise_is_known:
            unit = practical(QUANTITIES[self.data.y_name], [self.noise])
            size = "no more than rounding" if self.is_without_noise else f"{plain(self.noise / unit.factor)} {unit.symbol}"
            lines.append(f"noise, estimated from the residuals: {size}")
        elif not self.noise_is_known:
            lines.append(f"standard deviations of the data, estimated: {plain(self.noise)} times the given ones")
        lines += self.contact_depth_words()
        if self.reverse_yield:
            ratios = ", ".join(f"layer {one.layer} {ratio_words(one)}" for one in self.reverse_yield)
            lines.append(f"reverse yield ratio R_Y: {ratios}; unloading is elastic up to 2")
        if self.pyramid_correction is not None:
            ratio, error = (100.0 * one for one in self.pyramid_correction[:2])
            lines.append(f"pyramid_correction: largest force {ratio - 100.0:+.1f} ± {error:.1f} % against the equivalent cone")
        if self.prior_chi_square > 0.0:
            lines.append(f"chi-square of the priors {plain(self.prior_chi_square)}")
        if len(self.data) > 2:
            lines.append(
                f"residuals in order along the curve: correlation of neighbours {self.lag_correlation:.2f}, random with "
                f"{probability(self.pattern_probability)}; AIC {plain(self.aic)}, BIC {plain(self.bic)}"
            )
        correlation = self.correlation
        for i, one in enumerate(self.names):
            for j in range(i):
                lines.append(f"correlation of {one} and {self.names[j]}: {correlation[i, j]:+.4f}")
        return "\n".join(lines + [f"warning: {words}" for words in self.warnings])

    def contact_depth_words(self) -> list[str]:
        """Return how deep the surface sinks in, for contact depths from depth and force.

        Returns
        -------
        list of str
            One sentence, or none.
        """
        data, tool = self.data, self.instrument
        if not isinstance(data, StiffnessDepth) or data.force is None:
            return []
        try:
            radius = self.problem.predict(self._values)[1]
        except MDRError:
            return []
        load = data.force - tool.force_offset
        depth = data.x - tool.depth_offset - tool.frame_compliance * load
        height = np.asarray(self.indenter.height(radius / math.sqrt(tool.area_factor))) / tool.contact_depth_scale
        sigma = (depth - height) / (load * (1.0 / data.y - tool.frame_compliance))
        is_elastic = bool(self.problem.record["is_elastic"][0])
        under = (
            "the indenter itself, an elastic contact"
            if is_elastic
            else f"the indent, {tool.contact_depth_factor:.3g} on a half-space"
        )
        low, high = f"{sigma.min():.3g}", f"{sigma.max():.3g}"
        return [f"the surface sinks in by {low if low == high else f'{low} to {high}'} P/S under {under}"]

    def as_text(self, name: str) -> str:
        """Return an estimate with its standard error and unit as text.

        Parameters
        ----------
        name : str
            Name of the parameter.

        Returns
        -------
        str
            The text; it states if there is no standard error or if the data do not determine the parameter.
        """
        value, error = self.estimates[name], self.standard_errors[name]
        if name in contradictions(self):
            return "refused"
        if self.at_bound[name]:
            unit = unit_of(name, value)
            return f"{value / unit.factor:.4g} {unit.symbol}".rstrip() + ", no standard error"
        # an offset may well be 0, but not be vaguer than the whole curve is long
        reach = {"depth_offset": self.data.x, "force_offset": self.data.y}.get(name)
        largest = abs(value) if reach is None else float(np.ptp(reach))
        if error > largest and name != "frame_compliance":
            return "not determined"
        return measured(name, value, error)

    def interval_as_text(self, name: str, level: float = 0.95, given: Interval | None = None) -> str:
        """Return the interval of an estimate as text, in the unit of the estimate.

        Parameters
        ----------
        name : str
            Name of the parameter.
        level : float, optional
            Level, 0 < level < 1 [1].
        given : Interval, optional
            Another interval of the estimate.

        Returns
        -------
        str
            The text; "-" for an estimate that is rejected.
        """
        if name in contradictions(self):
            return "-"
        error = self.standard_errors[name]
        unit = unit_of(name, max(abs(self.estimates[name]), error))
        ends = " to ".join(digits(end / unit.factor, error / unit.factor) for end in given or self.interval(name, level))
        return f"{ends} {unit.symbol}".rstrip()

    def doubts(self, name: str) -> list[str]:
        """Return the warnings about an estimate.

        Parameters
        ----------
        name : str
            Name of the parameter.

        Returns
        -------
        list of str
            A few words for each.
        """
        words = [f"it would be {measured(name, self.estimates[name], self.standard_errors[name])}, softer than its base"]
        words = words if name in contradictions(self) else []
        if not self.converged:
            words.append("not converged")
        if self.at_bound[name]:
            return [*words, self.bound_words(name)]
        if self.widening[name] > 1.3:
            words.append(f"error widened {self.widening[name]:.2g} times for correlated residuals")
        if 0.0 < self.hidden < math.inf:
            words.append(self.hidden_words())
        if self.is_plastic:
            words.append("THE CONTACT IS PLASTIC" + ("" if self.yield_ratio > 1.0 else " OR VISCOUS") + ", THE MODEL ELASTIC")
        if self.departure > LARGE and not self.hidden:
            words.append(f"THE MODEL MISSES THE DATA BY {percent(self.departure)}")
        if self.scatter < 0:
            words.append(f"errors given are {self.excess_words()} the scatter")
        return words

    def bound_words(self, name: str) -> str:
        """Return at which bound an estimate is, as text.

        Parameters
        ----------
        name : str
            Name of the parameter.

        Returns
        -------
        str
            A given bound, or the end of the range of the search.
        """
        side, entry = self.at_bound[name], self.problem.free[name]
        end = "upper" if side > 0 else "lower"
        if math.isfinite(entry.upper if side > 0 else entry.lower):
            return f"at its {end} bound"
        if entry.prior is not None:
            return "20 standard deviations from its prior: the data contradict it"
        if name.startswith("indenter.C"):
            return "at 0, below which there is no tip next to its apex: leave this term out"
        return f"at the {end} end of its range: the data do not limit it, or its starting value was too far away"

    @property
    def is_random(self) -> bool | None:
        """True if the residuals are random and not too large.

        It is None if neither can be shown. Residuals well within the given standard deviations, or of rounding, support the model,
        with any pattern.
        """
        if self.scatter != 0:
            return self.scatter < 0
        if self.pattern_probability < UNLIKELY:
            return self.is_without_noise
        return True if self.degrees_of_freedom >= _FEWEST_FREE else None

    @property
    def departure(self) -> float:
        """Systematic departure of the model, root mean square over the largest force [1].

        It is 0 if the residuals may be random.
        """
        if self.is_random is not False:
            return 0.0
        # a scatter beyond the standard deviations is also a departure
        return self.misfit.whole if self.scatter > 0 else self.misfit.rms

    @property
    def hidden(self) -> float:
        """Largest misfit that the residuals would not show, over the largest force [1].

        It is infinite with less than two degrees of freedom, and 0 if it is at most 5 % or the noise is known.
        """
        if self.is_random is None:
            return math.inf
        if self.departure or self.noise_is_known or self.is_without_noise:
            return 0.0
        # a smooth part of the variance lowers the ratio of Durbin and Watson by so much of 2, whose standard error is 2/sqrt(n)
        share = min(_SHOWS / math.sqrt(len(self.data)), 1.0)
        # parameters take a part of the residuals away
        size = self.misfit.whole * math.sqrt(share * len(self.data) / self.degrees_of_freedom)
        return size if size > LARGE else 0.0

    @property
    def describes_data(self) -> bool | None:
        """True if the departure is at most 5 %.

        It is None if the points are too few to distinguish a larger one from noise, and False if the contact is plastic.
        """
        return False if self.is_plastic else None if self.hidden else self.departure <= LARGE

    @property
    def verdict(self) -> str:
        """Verdict as text.

        It is "describes", "describes to 2 %", "misses by 12 %", "plastic or viscous, 57 % of the depth stays" or the like.
        """
        if self.yield_ratio > 1.0:
            return f"plastic, the stress is {self.yield_ratio:.2g} times the yield stress"
        if self.indent is not None and self.is_plastic:
            return f"plastic or viscous, {percent(self.indent.share)} of the depth stays"
        if self.is_random is None:
            return "too few points"
        if self.hidden:
            return f"cannot tell {percent(self.hidden)} from noise"
        if self.departure == 0.0:
            return "describes"
        return f"describes to {percent(self.departure)}" if self.departure <= LARGE else f"misses by {percent(self.departure)}"

    def misfit_words(self) -> str:
        """Return the verdict with its numbers as text.

        Returns
        -------
        str
            One sentence.
        """
        if not self.is_plastic:
            return self.misfit_of_readings()
        if self.indent is None:
            return (
                f"is elastic but the contact is plastic: the von Mises stress would be {self.yield_ratio:.2g} times the yield "
                f"stress; of the readings alone it {self.misfit_of_readings()}"
            )
        back, stays = percent(self.indent.returned), percent(self.indent.share)
        return (
            f"is elastic but the contact is plastic or viscous: unloading gives back {back} of the work of loading, and {stays} of "
            f"the depth stays; of the fitted readings alone it {self.misfit_of_readings()}"
        )

    def misfit_of_readings(self) -> str:
        """Return how well the model describes the fitted readings alone, as text.

        Returns
        -------
        str
            One sentence.
        """
        data, found = self.data, self.misfit
        unit = practical(QUANTITIES[data.x_name], data.x)
        place = f"{data.x_name} {found.at / unit.factor:.3g} {unit.symbol}"
        rest = f"largest {percent(found.largest)} at {place}, noise {percent(found.noise)}"
        size = f"{percent(self.departure or found.rms)} of the {data.y_name} ({rest})"
        if self.hidden:
            return f"may miss the data: {self.hidden_words()} ({rest})"
        if self.departure > LARGE:
            return f"misses the data by {size}"
        return f"describes the data to {size}" if self.departure else f"describes the data: misfit {size}"

    def hidden_words(self) -> str:
        """Return what so few readings cannot distinguish, as text.

        Returns
        -------
        str
            One sentence; empty if `hidden` is 0.
        """
        if not self.hidden:
            return ""
        readings = "1 reading" if len(self.data) == 1 else f"{len(self.data)} readings"
        if not math.isfinite(self.hidden):
            return f"{readings} cannot show whether the model is right"
        return f"{readings} cannot tell a misfit of {percent(self.hidden)} from noise"

    @property
    def scatter(self) -> int:
        """1 if the data scatter more than their standard deviations, -1 if less, else 0.

        It is also 0 if the standard deviations are unknown or the points are too few.
        """
        return compare_scatter(self.chi_square, self.degrees_of_freedom) if self.noise_is_known else 0

    @property
    def excess_of_errors(self) -> float:
        """Ratio of the given standard deviations to those of the data about the fit [1].

        It is infinite for a fit through all points and NaN with less than one degree of freedom.
        """
        ratio = self.reduced_chi_square
        return math.sqrt(1.0 / ratio) if ratio > 0.0 else math.inf if ratio == 0.0 else math.nan

    def excess_words(self) -> str:
        """Return `excess_of_errors` as text.

        Returns
        -------
        str
            The factor.
        """
        return f"{self.excess_of_errors:.3g} times" if math.isfinite(self.excess_of_errors) else "infinitely many times"

    @property
    def reduced_chi_square(self) -> float:
        """Chi-square over the degrees of freedom; NaN with less than one of them [1]."""
        return self.chi_square / self.degrees_of_freedom if self.degrees_of_freedom >= 1.0 else math.nan

    @property
    def is_without_noise(self) -> bool:
        """True if the residuals are at most the rounding of data and model."""
        rest = float(np.sqrt(np.mean((self.data.y - self.fitted) ** 2)))
        return rest <= _ROUNDING * float(np.max(np.abs(self.data.y)))

    def plot(self, title: str = "") -> Figure:
        """Return data, fit and residuals as a figure.

        The numbers of the problem are taken as SI.

        Parameters
        ----------
        title : str, optional
            First line of the title.

        Returns
        -------
        Figure
            The figure.
        """
        lines = [title] if title else []
        lines += [f"{words_of(name)} = {self.as_text(name)}" for name in self.names]
        if len(self.data) > 2:
            lines.append(self.misfit_words().partition(" (")[0])
        # what widens an error is in the error
        doubts = sorted({words for name in self.names for words in self.doubts(name) if "widened" not in words})
        model = getattr(self.medium, "model", None)
        label = f"fit ({model})" if model else "fit"
        is_found = "depth_offset" in self.names and self.data.x_name == "depth"
        contact = self.values["depth_offset"] if is_found or self.data.contact_points else None
        return figure_of(self.data, self.noise, self.fitted, self.residuals, label, lines, doubts, contact)

    def to_dict(self, level: float = 0.95) -> dict[str, Any]:
        """Return all results except the objects as plain Python values.

        Parameters
        ----------
        level : float, optional
            Level of the intervals, 0 < level < 1 [1].

        Returns
        -------
        dict
            The results; None for numbers that are not finite.
        """
        parameters = {
            name: {
                "words": words_of(name),
                "unit": dimension_of(name).si,
                "value": self.estimates[name],
                "standard_error": self.standard_errors[name],
                "interval": list(self.interval(name, level)),
                "at_bound": self.at_bound[name],
                "widening": self.widening[name],
                "doubts": self.doubts(name),
            }
            for name in self.names
        }
        found = {
            "parameters": parameters,
            "level": level,
            "fixed": {
                name: {"value": value, "unit": dimension_of(name).si}
                for name, value in self.values.items()
                if name not in self.names
            },
            "covariance": self.covariance.tolist(),
            "correlation": self.correlation.tolist(),
            "points": len(self.data),
            "describes_data": self.describes_data,
            "verdict": self.verdict,
            "misfit": self.misfit._asdict(),
            "indent": self.indent._asdict() if self.indent else None,
            "yield_ratio": self.yield_ratio,
            "reverse_yield": [one._asdict() for one in self.reverse_yield],
            "pyramid_correction": self.pyramid_correction._asdict() if self.pyramid_correction else None,
            **{name: getattr(self, name) for name in _NUMBERS},
            "indenter": repr(self.indenter),
            "medium": repr(self.medium),
            "instrument": repr(self.instrument),
        }
        return _as_json(found)  # type: ignore[no-any-return]

    def report(self, path: str | os.PathLike[str] | None = None, notes: Sequence[str] = (), title: str = "Fit") -> str:
        """Return a report as one HTML file, readable without a network.

        It has estimates, figure, warnings, assumptions and versions.

        Parameters
        ----------
        path : str or path-like, optional
            File for the report.
        notes : sequence of str, optional
            Further notes on the data, one line each.
        title : str, optional
            Title of the report.

        Returns
        -------
        str
            The HTML text.
        """
        text = page(title, blocks_of(self, notes))
        if path is not None:
            replace(path, text.encode())
        return text

    def to_json(self, path: str | os.PathLike[str] | None = None, level: float = 0.95) -> str:
        """Return `to_dict` as JSON text.

        Parameters
        ----------
        path : str or path-like, optional
            File for the text.
        level : float, optional
            Level of the intervals, 0 < level < 1 [1].

        Returns
        -------
        str
            The text.
        """
        text = json.dumps(self.to_dict(level), indent=2, allow_nan=False) + "\n"
        if path is not None:
            replace(path, text.encode())
        return text

    def _repr_html_(self) -> str:
        """Verdict and estimates in a notebook."""
        return f"<p>{escape(self.verdict)}</p>{html_table(estimates_of(self))}"

    def __repr__(self) -> str:
        inside = ", ".join(f"{name}={self.estimates[name]:.6g}+-{self.standard_errors[name]:.2g}" for name in self.names)
        return f"<FitResult: {inside}{'' if self.converged else ', not converged'}>"


def _as_json(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _as_json(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [_as_json(entry) for entry in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
