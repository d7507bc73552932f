# SPDX-License-Identifier: GPL-3.0-or-later
"""What a fit says: estimates, their uncertainty, and whether to believe them."""

from __future__ import annotations

import json
import math
import os
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import _native
from .._boundary import number
from .._choices import nearest
from .._files import replace
from ..errors import InvalidArgumentError, MDRError
from .picture import draw
from .problem import Problem

Array = NDArray[np.float64]


class Interval(NamedTuple):
    """A confidence interval; an end is infinite where the data set none."""

    lower: float
    upper: float


class FitResult:
    """The result of `fit`.

    estimates : best values of the free parameters by name; values: of all parameters
    standard_errors : by name, from the covariance
    covariance, correlation : arrays, in the order of `names`
    indenter, medium, instrument : the objects with the best values, for further computing
    fitted, residuals : the model at the data, and (data - model) in its standard deviations; the error of a reading counts once
        where the model is computed from it too (contact depths, frame compliance)
    noise : factor of the standard deviations of the data: 1 if they are known, else estimated; without `sd` the standard deviation
    chi_square, degrees_of_freedom, log_likelihood, aic, bic, runs_probability
    converged, iterations, evaluations, warnings
    """

    def __init__(
        self,
        problem: Problem,
        values: Array,
        covariance: Array,
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
        self.standard_errors = {name: math.sqrt(self.covariance[i, i]) for i, name in enumerate(self.names)}
        self.at_bound = {name: int(at_bound[i]) for name, i in zip(self.names, places, strict=True)}
        self.weakest_direction = {name: float(weakest_direction[i]) for name, i in zip(self.names, places, strict=True)}
        self.indenter, self.medium, self.instrument = problem.objects_at(values)
        self.fitted: Array = np.asarray(fitted)
        self.converged = bool(summary["converged"])
        self.iterations, self.evaluations = int(summary["iterations"]), int(summary["evaluations"])
        self.chi_square, self.prior_chi_square = float(summary["chi_square"]), float(summary["prior_chi_square"])
        self.degrees_of_freedom, self.noise = float(summary["degrees_of_freedom"]), float(summary["noise"])
        self.log_likelihood, self.runs_probability = float(summary["log_likelihood"]), float(summary["runs_probability"])
        self.weakest = float(summary["weakest"])
        self.residuals: Array = np.asarray(residuals)
        self.warnings: list[str] = []
        self._values = np.asarray(values)

    @property
    def noise_is_known(self) -> bool:
        """Whether the standard deviations of the data were given as absolute ones."""
        return self.data.sd is not None and bool(self.problem.record["sd_is_absolute"][0])

    @property
    def correlation(self) -> Array:
        """Correlation of the free parameters; 0 for one at its bound."""
        errors = np.array([self.standard_errors[name] for name in self.names])
        scale = np.where(errors > 0.0, errors, 1.0)
        return np.asarray(self.covariance / np.outer(scale, scale))

    @property
    def aic(self) -> float:
        """Akaike's information criterion, corrected for few points."""
        n, k = self._counts()
        return -2.0 * self.log_likelihood + 2.0 * k + 2.0 * k * (k + 1) / max(n - k - 1, 1)

    @property
    def bic(self) -> float:
        """Bayesian (Schwarz) information criterion."""
        n, k = self._counts()
        return -2.0 * self.log_likelihood + k * math.log(n)

    def _counts(self) -> tuple[int, int]:
        return len(self.data), len(self.names) + (0 if self.noise_is_known else 1)

    def interval(
        self, name: str, level: float = 0.95, method: str = "normal", *, draws: int = 200, seed: int | None = None
    ) -> Interval:
        """The confidence interval of one free parameter.

        method : "normal" from the standard error; "profile": as far as the parameter can be moved, all others following, before
            chi-square rises by its quantile; "monte-carlo": quantiles of fits of `draws` simulated data sets (`seed`)
        """
        if name not in self.names:
            raise InvalidArgumentError(f"{name!r} is not a free parameter: {nearest(str(name), self.names)}")
        level = number("level", level)
        if not 0.0 < level < 1.0:
            raise InvalidArgumentError(f"level = {level!r} is not allowed: it must be between 0 and 1")
        if method == "normal":
            reach = _quantile(0.5 * (1.0 + level), None if self.noise_is_known else self.degrees_of_freedom)
            half = reach * self.standard_errors[name]
            return Interval(self.estimates[name] - half, self.estimates[name] + half)
        if method == "profile":
            problem = self.problem.changed(self.data, start=self._values)
            place = self.problem.names.index(name)
            lower, upper = problem.call(_native.fit_interval, place, level)
            return Interval(float(lower), float(upper))
        if method == "monte-carlo":
            values = self.simulate(draws, seed)[:, self.names.index(name)]
            lower, upper = np.quantile(values, [0.5 * (1.0 - level), 0.5 * (1.0 + level)])
            return Interval(float(lower), float(upper))
        known = ("normal", "profile", "monte-carlo")
        raise InvalidArgumentError(f"method = {method!r} is not allowed: {nearest(str(method), known)}")

    def simulate(self, draws: int = 200, seed: int | None = None) -> Array:
        """Estimates from simulated data: the fitted curve plus noise, and priors drawn about their estimates; (draws, parameters).
        Simulations that fail are left out."""
        if not isinstance(draws, int) or draws < 2:
            raise InvalidArgumentError(f"draws = {draws!r} is not allowed: it must be a whole number, at least 2")
        random = np.random.default_rng(seed)
        sd = self.noise * (np.ones_like(self.fitted) if self.data.sd is None else self.data.sd)
        errors = self.problem.table[4]
        trials = [
            self.problem.changed(
                self.data.with_y(self.fitted + sd * random.standard_normal(sd.shape)),
                priors=self._values + errors * random.standard_normal(errors.shape),
                start=self._values,
            )
            for _ in range(draws)
        ]

        def one(problem: Problem) -> list[float] | None:
            try:
                values = problem.answer()[0]
            except MDRError:
                return None
            return [float(values[problem.names.index(name)]) for name in self.names]

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            rows = [row for row in pool.map(one, trials) if row is not None]
        if len(rows) < 0.9 * draws:
            raise MDRError(f"only {len(rows)} of {draws} simulated data sets could be fitted: there is no interval from them")
        return np.array(rows)

    def summary(self, level: float = 0.95) -> str:
        """Table of estimates, quality of the fit, correlations, warnings."""
        percent = f"{100.0 * level:g} %"
        rows = [["parameter", "estimate", "standard error", f"{percent} interval", ""]]
        for name in self.names:
            lower, upper = self.interval(name, level)
            value, error = self.estimates[name], self.standard_errors[name]
            relative = f"{100.0 * error / abs(value):.2g} %" if value else ""
            bound = {-1: "at its lower bound", 1: "at its upper bound"}.get(self.at_bound[name], relative)
            rows.append([name, f"{value:.6g}", f"{error:.2g}", f"{lower:.6g} to {upper:.6g}", bound])
        widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
        lines = [f"Fit of {len(self.data)} points: " + ("converged" if self.converged else "NOT CONVERGED, best point found")]
        lines[0] += f" after {self.iterations} iterations"
        lines += ["  ".join(cell.ljust(w) for cell, w in zip(row, widths, strict=True)).rstrip() for row in rows]
        dof = self.degrees_of_freedom
        if self.noise_is_known:
            lines.append(f"chi-square {self.chi_square:.4g} for {dof:.4g} degrees of freedom: ratio {self.chi_square / dof:.3g}")
        elif self.data.sd is None:
            lines.append(f"noise, estimated from the residuals: {self.noise:.3g} ({dof:.4g} degrees of freedom)")
        else:
            lines.append(f"standard deviations of the data, estimated: {self.noise:.3g} times the given ones")
        if self.prior_chi_square > 0.0:
            lines.append(f"chi-square of the priors {self.prior_chi_square:.3g}")
        lines.append(f"AIC {self.aic:.5g}, BIC {self.bic:.5g}; test of runs of the residuals: p = {self.runs_probability:.2g}")
        correlation = self.correlation
        for i, one in enumerate(self.names):
            for j in range(i):
                lines.append(f"correlation of {one} and {self.names[j]}: {correlation[i, j]:+.4f}")
        return "\n".join(lines + [f"warning: {words}" for words in self.warnings])

    def plot(self, path: str | os.PathLike[str] | None = None) -> Any:
        """Data, fit and residuals as a matplotlib figure; written to `path` (.png, .pdf, .svg) if one is given."""
        title = [f"{name} = {self.estimates[name]:.4g} ± {self.standard_errors[name]:.2g}" for name in self.names]
        if not self.converged:
            title.append("not converged")
        model = getattr(self.medium, "model", None)
        label = f"fit ({model})" if model else "fit"
        return draw(self.data, self.noise, self.fitted, self.residuals, label, title, path)

    def to_dict(self, level: float = 0.95) -> dict[str, Any]:
        """Everything but the objects, as plain Python values; numbers that are not finite become None."""
        parameters = {
            name: {
                "value": self.estimates[name],
                "standard_error": self.standard_errors[name],
                "interval": list(self.interval(name, level)),
                "at_bound": self.at_bound[name],
            }
            for name in self.names
        }
        found = {
            "parameters": parameters,
            "level": level,
            "fixed": {name: value for name, value in self.values.items() if name not in self.names},
            "covariance": self.covariance.tolist(),
            "correlation": self.correlation.tolist(),
            "points": len(self.data),
            "chi_square": self.chi_square,
            "prior_chi_square": self.prior_chi_square,
            "degrees_of_freedom": self.degrees_of_freedom,
            "noise": self.noise,
            "noise_is_known": self.noise_is_known,
            "log_likelihood": self.log_likelihood,
            "aic": self.aic,
            "bic": self.bic,
            "runs_probability": self.runs_probability,
            "converged": self.converged,
            "iterations": self.iterations,
            "evaluations": self.evaluations,
            "warnings": self.warnings,
            "indenter": repr(self.indenter),
            "medium": repr(self.medium),
            "instrument": repr(self.instrument),
        }
        return _plain(found)  # type: ignore[no-any-return]

    def to_json(self, path: str | os.PathLike[str] | None = None, level: float = 0.95) -> str:
        """`to_dict` as JSON text; written to `path` if one is given."""
        text = json.dumps(self.to_dict(level), indent=2, allow_nan=False) + "\n"
        if path is not None:
            replace(path, text.encode())
        return text

    def __repr__(self) -> str:
        inside = ", ".join(f"{name}={self.estimates[name]:.6g}+-{self.standard_errors[name]:.2g}" for name in self.names)
        return f"<FitResult: {inside}{'' if self.converged else ', not converged'}>"


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [_plain(entry) for entry in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def _quantile(probability: float, degrees_of_freedom: float | None) -> float:
    """Quantile of the normal distribution, or of Student's (Hill's expansion, good to 1e-3 from 3 degrees on)."""
    from statistics import NormalDist

    z = NormalDist().inv_cdf(probability)
    if degrees_of_freedom is None:
        return z
    v = max(degrees_of_freedom, 1.0)
    terms = (
        (z**3 + z) / 4.0,
        (5 * z**5 + 16 * z**3 + 3 * z) / 96.0,
        (3 * z**7 + 19 * z**5 + 17 * z**3 - 15 * z) / 384.0,
        (79 * z**9 + 776 * z**7 + 1482 * z**5 - 1920 * z**3 - 945 * z) / 92160.0,
    )
    return z + sum(term / v**k for k, term in enumerate(terms, start=1))
