# SPDX-License-Identifier: GPL-3.0-or-later
"""A fit's result as text."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .result import FitResult


def summary(result: FitResult, level: float) -> str:
    """Table of estimates, quality of the fit, correlations, warnings."""
    percent = f"{100.0 * level:g} %"
    rows = [["parameter", "estimate", "standard error", f"{percent} interval", ""]]
    for name in result.names:
        lower, upper = result.interval(name, level)
        value, error = result.estimates[name], result.standard_errors[name]
        relative = f"{100.0 * error / abs(value):.2g} %" if value else ""
        bound = {-1: "at its lower bound", 1: "at its upper bound"}.get(result.at_bound[name], relative)
        rows.append([name, f"{value:.6g}", f"{error:.2g}", f"{lower:.6g} to {upper:.6g}", bound])
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    lines = [f"Fit of {len(result.data)} points: " + ("converged" if result.converged else "NOT CONVERGED, best point found")]
    lines[0] += f" after {result.iterations} iterations"
    lines += ["  ".join(cell.ljust(w) for cell, w in zip(row, widths, strict=True)).rstrip() for row in rows]
    dof = result.degrees_of_freedom
    if result.noise_is_known:
        lines.append(f"chi-square {result.chi_square:.4g} for {dof:.4g} degrees of freedom: ratio {result.chi_square / dof:.3g}")
    elif result.data.sd is None:
        lines.append(f"noise, estimated from the residuals: {result.noise:.3g} ({dof:.4g} degrees of freedom)")
    else:
        lines.append(f"standard deviations of the data, estimated: {result.noise:.3g} times the given ones")
    if result.prior_chi_square > 0.0:
        lines.append(f"chi-square of the priors {result.prior_chi_square:.3g}")
    lines.append(f"AIC {result.aic:.5g}, BIC {result.bic:.5g}; test of runs of the residuals: p = {result.runs_probability:.2g}")
    correlation = result.correlation
    for i, one in enumerate(result.names):
        for j in range(i):
            lines.append(f"correlation of {one} and {result.names[j]}: {correlation[i, j]:+.4f}")
    return "\n".join(lines + [f"warning: {words}" for words in result.warnings])
