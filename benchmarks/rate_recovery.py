#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Do the intervals of `mdrcontact.instruments.fit_rate` hold what they promise?

Synthetic retractions of a soft cantilever from a homogeneous body at three speeds, with noise of 2 % of the pull-off force whose
neighbouring readings have the correlation 0.9; free are modulus, work of adhesion, v0 and n. How often lies the true value inside
the 95 % interval? The work's must do so in 91 to 98 % of 200 sets, else the exit status is 1.
Run: python benchmarks/rate_recovery.py [--sets 200] [--lag 0.9] [--noise 0.02]
"""

from __future__ import annotations

import numpy as np
from recovery import Count, autoregression, options

import mdrcontact as mdr
import mdrcontact.instruments as mdi

TRUTH = {"E": 1e6, "work": 0.05, "speed": 1e-6, "exponent": 0.4}
SPEEDS = (1e-7, 1e-6, 1e-5)
POINTS, SPRING, TIP = 120, 20.0, mdr.Paraboloid(20e-6)


def contact_of(E: float, **law: float) -> mdr.Contact:
    """A rubber half-space under a ball."""
    return mdr.Contact(TIP, mdr.Homogeneous(mdr.Elastic(E, 0.5)), adhesion=mdr.adhesion.RateAdhesion(**law))


def clean_curves() -> list[mdi.RateCurve]:
    """Without noise."""
    contact, start = contact_of(**TRUTH), 2e-6
    curves = []
    for speed in SPEEDS:
        end = mdr.adhesion.rate_history(
            contact, [0.0, 6e-6 / speed], position=[start, start - 6e-6], spring_stiffness=SPRING, start="rest"
        ).end
        time = np.linspace(0.0, 1.05 * end["lowest_time"], POINTS)
        position = start - speed * time
        force = mdr.adhesion.rate_history(contact, time, position=position, spring_stiffness=SPRING, start="rest").force
        curves.append(mdi.RateCurve(time, position, force, SPRING))
    return curves


def main() -> None:
    """Draws, fits, counts."""
    chosen, count = options(__doc__), Count(TRUTH)
    clean, random = clean_curves(), np.random.default_rng(36)
    guess = contact_of(E=0.8e6, work=0.06, speed=2e-6, exponent=0.5)
    for _ in range(chosen.sets):
        noisy = []
        for c in clean:
            noise = chosen.noise * abs(c.force.min()) * autoregression(random, chosen.lag, POINTS)
            noisy.append(mdi.RateCurve(c.time, c.position, c.force + noise, SPRING))
        found = mdi.fit_rate(noisy, guess, list(TRUTH))
        count.add(found.values, found.intervals)
    count.report("work")


if __name__ == "__main__":
    main()
