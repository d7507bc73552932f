# SPDX-License-Identifier: GPL-3.0-or-later
"""Do intervals and verdicts of `mdrcontact.instruments.fit` hold on 5 to 500 readings?

Force-depth curves of a sphere on 500 nm of oxide on silicon, noise of 2 % of the largest force, independent or correlated along the
curve (first-order autoregression). Free are the film's modulus and the depth at first contact. Intervals: how often those of 95 %
hold the true modulus, and their half length over 1.96 standard deviations of the estimates. Verdicts: of right and wrong models.
Run: python benchmarks/few_readings.py [--draws 2000] [--readings 5 6 8 ...] [--table FILE.md]
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before any library is loaded

import argparse
import collections
import sys
import warnings
from pathlib import Path

import numpy as np
from recovery import autoregression

import mdrcontact as mdr
import mdrcontact.instruments as mdi

READINGS = (5, 8, 12, 20, 50, 100, 500)
LAGS = (0.0, 0.5, 0.9)
NOISE = 0.02
OXIDE, SILICON, DIAMOND = mdr.Elastic(72e9, 0.17), mdr.Elastic(163e9, 0.22), mdr.Elastic(1141e9, 0.07)
BALL, THICKNESS, DEEPEST = mdr.Paraboloid(10e-6), 500e-9, 100e-9
FILM = mdr.Coated(OXIDE, THICKNESS, SILICON, "exact")
POLYMER, CARBON = mdr.Elastic(10e9, 0.35), mdr.Elastic(800e9, 0.2)
SOFT, HARD = mdr.Coated(POLYMER, THICKNESS, SILICON, "exact"), mdr.Coated(CARBON, THICKNESS, SILICON, "exact")
FREE = ("coating.E", "depth_offset")
VERDICTS = ("describes to", "describes", "cannot tell", "misses")


def curve(readings: int, medium: mdr.Medium = FILM) -> tuple[np.ndarray, np.ndarray]:
    """Depths and forces without noise."""
    depth = np.linspace(DEEPEST / readings, DEEPEST, readings)
    return depth, np.asarray(mdr.Contact(BALL, medium).at_depth(depth).force)


def fits(
    depth: np.ndarray, force: np.ndarray, medium: mdr.Medium, *, lag: float, known: bool, noise: float, draws: int, seed: int
) -> list[mdi.FitResult]:
    """Fits of simulated curves; those that fail are left out."""
    sd = noise * float(force.max())
    random = np.random.default_rng(seed)
    curves = [
        mdi.ForceDepth(depth, force + sd * autoregression(random, lag, len(depth)), sd=sd if known else None) for _ in range(draws)
    ]
    found = mdi.fit_many(curves, BALL, medium, FREE, check_units=False)
    return [one for one in found if isinstance(one, mdi.FitResult)]


def intervals(readings: int, lag: float, known: bool, draws: int, seed: int = 0) -> tuple[float, float]:
    """How often intervals of 95 % hold the film's modulus, and their mean half length over 1.96 standard deviations."""
    found = fits(*curve(readings), FILM, lag=lag, known=known, noise=NOISE, draws=draws, seed=seed)
    ends = np.array([one.interval("coating.E") for one in found])
    estimates = np.array([one.estimates["coating.E"] for one in found])
    inside = (ends[:, 0] <= OXIDE.E) & (ends[:, 1] >= OXIDE.E)
    return float(inside.mean()), float(np.mean(0.5 * np.ptp(ends, axis=1)) / (1.96 * estimates.std(ddof=1)))


def plastic(depth: np.ndarray, force: np.ndarray) -> np.ndarray:
    """Loading that yields from a third of the depth on: at a constant mean pressure, the force rises linearly."""
    yields = depth[-1] / 3.0
    at = float(np.interp(yields, depth, force))
    return np.where(depth < yields, force, at * (1.0 + 1.5 * (depth - yields) / yields))


def models(readings: int) -> dict[str, tuple[type[mdi.ForceDepth | mdi.ModulusRadius], np.ndarray, np.ndarray, mdr.Medium]]:
    """Kind of data, x, y and the medium whose coating.E is fitted to them."""
    depth, force = curve(readings)
    radius = np.geomspace(0.1, 4.0, readings) * THICKNESS
    modulus = np.asarray(SOFT.modulus(radius))
    series = 1.0 / (1.0 / np.asarray(HARD.modulus(radius)) + 1.0 / DIAMOND.contact_modulus)
    return {
        "right model": (mdi.ModulusRadius, radius, modulus, SOFT),
        "film and base swapped": (mdi.ModulusRadius, radius, modulus, mdr.Coated(SILICON, THICKNESS, POLYMER, "exact")),
        "film forgotten": (mdi.ModulusRadius, radius, modulus, mdr.Coated(POLYMER, 100.0 * THICKNESS, SILICON, "exact")),
        "diamond forgotten": (mdi.ModulusRadius, radius, series, HARD),
        "right model, forces": (mdi.ForceDepth, depth, force, FILM),
        "plastic loading": (mdi.ForceDepth, depth, plastic(depth, force), FILM),
        "baseline of 10 %": (mdi.ForceDepth, depth, force + 0.1 * float(force.max()), FILM),
    }


def verdicts(readings: int, name: str, noise: float, draws: int, seed: int = 0) -> dict[str, float]:
    """Shares of the verdicts under a model, noise of forces in parts of the largest, of moduli in parts of each."""
    kind, x, y, medium = models(readings)[name]
    random = np.random.default_rng(seed)
    size = noise * (y if kind is mdi.ModulusRadius else float(y.max()))
    curves = [kind(x, np.abs(y + size * random.standard_normal(len(x)))) for _ in range(draws)]
    found = mdi.fit_many(curves, BALL, medium, ["coating.E"], check_units=False)
    good = [one for one in found if isinstance(one, mdi.FitResult)]
    counts = collections.Counter(next(v for v in VERDICTS if one.verdict.startswith(v)) for one in good)
    return {verdict: counts[verdict] / len(good) for verdict in VERDICTS}


def coverage_table(readings: list[int], draws: int) -> list[str]:
    """Coverage [%] and length of intervals, a row for each number of readings."""
    cells = [(known, lag) for known in (True, False) for lag in LAGS]
    titles = [f"sd {'known' if known else 'unknown'}, {f'correlation {lag:g}' if lag else 'independent'}" for known, lag in cells]
    lines = ["| readings | " + " | ".join(titles) + " |", "|---|" + len(cells) * "---|"]
    for count in readings:
        found = [intervals(count, lag, known, draws) for known, lag in cells]
        lines.append(f"| {count} | " + " | ".join(f"{100.0 * share:.1f}, {length:.2f}" for share, length in found) + " |")
        print(lines[-1], flush=True)
    return lines


def verdict_table(readings: list[int], draws: int) -> list[str]:
    """Shares [%] of "misses" or "describes to", and of "cannot tell", at two sizes of noise."""
    noises = (0.01, 0.05, 0.2)
    titles = [f"{count} readings, noise {100.0 * noise:g} %" for noise in noises for count in readings]
    lines = ["| model | " + " | ".join(titles) + " |", "|---|" + len(titles) * "---|"]
    for name in models(readings[0]):
        found = [verdicts(count, name, noise, draws) for noise in noises for count in readings]
        cells = [f"{100.0 * (one['misses'] + one['describes to']):.0f}, {100.0 * one['cannot tell']:.0f}" for one in found]
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
        print(lines[-1], flush=True)
    return lines


def main() -> None:
    """Both tables."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--draws", type=int, default=2000)
    parser.add_argument("--readings", type=int, nargs="+", default=list(READINGS))
    parser.add_argument("--table", type=Path)
    arguments = parser.parse_args()
    warnings.simplefilter("ignore", mdr.MDRWarning)
    lines = [
        "# Intervals and verdicts of few readings",
        "",
        f"`python {' '.join(sys.argv)}`",
        "",
        "How often intervals of 95 % hold the film's modulus [%], and their mean half length over 1.96 standard deviations of the",
        f"estimates; {arguments.draws} curves a cell:",
        "",
        *coverage_table(arguments.readings, arguments.draws),
        "",
        'Shares [%] of curves whose verdict is "misses" or "describes to", and of those with "cannot tell":',
        "",
        *verdict_table([5, 8, 20, 100], arguments.draws // 20),
    ]
    if arguments.table:
        arguments.table.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
