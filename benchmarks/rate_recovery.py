#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Do the intervals of `mdr.fit_rate` hold what they promise?

Synthetic retractions of a soft cantilever from a homogeneous body at three speeds, with noise of 2 % of the pull-off force whose
neighbouring readings have the correlation 0.9; free are modulus, work of adhesion, v0 and n. How often lies the true value inside
the 95 % interval? The work's must do so in 91 to 98 % of 200 sets, else the exit status is 1.
Run: python benchmarks/rate_recovery.py [--sets 200] [--lag 0.9] [--noise 0.02]
"""

from __future__ import annotations

import argparse
import sys
import warnings

import numpy as np

import mdrcontact as mdr

TRUTH = {"E": 1e6, "work": 0.05, "speed": 1e-6, "exponent": 0.4}
SPEEDS = (1e-7, 1e-6, 1e-5)
POINTS, SPRING, TIP = 120, 20.0, mdr.Paraboloid(20e-6)


def contact_of(E: float, **law: float) -> mdr.Contact:
    """A rubber half-space under a ball."""
    return mdr.Contact(TIP, mdr.Homogeneous(mdr.Elastic(E, 0.5)), adhesion=mdr.RateAdhesion(**law))


def clean_curves() -> list[mdr.RateCurve]:
    """Without noise."""
    contact, start = contact_of(**TRUTH), 2e-6
    curves = []
    for speed in SPEEDS:
        end = contact.history([0.0, 6e-6 / speed], position=[start, start - 6e-6], spring_stiffness=SPRING, start="rest").end
        time = np.linspace(0.0, 1.05 * end["lowest_time"], POINTS)
        position = start - speed * time
        force = contact.history(time, position=position, spring_stiffness=SPRING, start="rest").force
        curves.append(mdr.RateCurve(time, position, force, SPRING))
    return curves


def autoregression(random: np.random.Generator, lag: float, points: int = POINTS) -> np.ndarray:
    """Noise of variance 1 whose neighbours have the correlation `lag`."""
    noise = random.standard_normal(points)
    for i in range(1, points):
        noise[i] = lag * noise[i - 1] + np.sqrt(1.0 - lag**2) * noise[i]
    return noise


def main() -> None:
    """Draws, fits, counts."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sets", type=int, default=200)
    parser.add_argument("--lag", type=float, default=0.9)
    parser.add_argument("--noise", type=float, default=0.02)
    chosen = parser.parse_args()
    warnings.simplefilter("ignore", mdr.MDRWarning)
    clean, random = clean_curves(), np.random.default_rng(36)
    guess = contact_of(E=0.8e6, work=0.06, speed=2e-6, exponent=0.5)
    inside, ratios = dict.fromkeys(TRUTH, 0), []
    for _ in range(chosen.sets):
        noisy = [
            mdr.RateCurve(
                c.time, c.position, c.force + chosen.noise * abs(c.force.min()) * autoregression(random, chosen.lag), SPRING
            )
            for c in clean
        ]
        found = mdr.fit_rate(noisy, guess, list(TRUTH))
        for name, true in TRUTH.items():
            low, high = found.intervals[name]
            inside[name] += low <= true <= high
        ratios.append([found.values[name] / true for name, true in TRUTH.items()])
    for i, name in enumerate(TRUTH):
        middle, scatter = np.mean([row[i] for row in ratios]), np.std([row[i] for row in ratios])
        print(f"{name:10} inside {100.0 * inside[name] / chosen.sets:5.1f} %   found/true {middle:.4f} +- {scatter:.4f}")
    if not 0.91 <= inside["work"] / chosen.sets <= 0.98:
        sys.exit("the work's interval does not hold what it promises")


if __name__ == "__main__":
    main()
