#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Do the intervals of `mdrcontact.instruments.fit` hold what they promise where adhesion has a range?

Synthetic retractions of a ball from a soft half-space whose adhesion is between JKR's and DMT's, with noise of 2 % of the pull-off
force whose neighbouring readings have the correlation 0.9; free are modulus, work of adhesion and cohesive stress. How often lies
the true value inside the 95 % interval? The work's must do so in 91 to 98 % of 200 sets, else the exit status is 1. Fits begin
from 0.75 of the true modulus, 1.2 of the work and 1.3 of the stress, from where one search alone ends at another minimum.
Run: python benchmarks/range_recovery.py [--sets 200] [--lag 0.9] [--noise 0.02]
"""

from __future__ import annotations

import numpy as np
from recovery import Count, autoregression, options

import mdrcontact as mdr
import mdrcontact.instruments as mdi

TRUTH = {"E": 2e6, "work_of_adhesion": 0.05, "cohesive_stress": 0.3e6}
BEGIN = {"E": 0.75, "work_of_adhesion": 1.2, "cohesive_stress": 1.3}
POINTS, TIP = 160, mdr.Paraboloid(2e-6)


def clean_curve() -> tuple[np.ndarray, np.ndarray]:
    """Depths and forces without noise, down to pull-off; attraction without contact ends with the jump."""
    contact = mdr.Contact(
        TIP,
        mdr.Homogeneous(mdr.Elastic(TRUTH["E"], 0.5)),
        work_of_adhesion=TRUTH["work_of_adhesion"],
        cohesive_stress=TRUTH["cohesive_stress"],
    )
    depth = np.linspace(contact.pull_off("depth").depth + 2e-9, 200e-9, POINTS)
    return depth, np.asarray(contact.at_depth(depth).force)


def main() -> None:
    """Draws, fits, counts."""
    chosen, count = options(__doc__), Count(TRUTH)
    depth, force = clean_curve()
    random, size = np.random.default_rng(36), chosen.noise * abs(force.min())
    begin = {name: BEGIN[name] * value for name, value in TRUTH.items()}
    start = mdi.Instrument(work_of_adhesion=begin["work_of_adhesion"], cohesive_stress=begin["cohesive_stress"])
    for _ in range(chosen.sets):
        data = mdi.ForceDepth(depth, force + size * autoregression(random, chosen.lag, POINTS), branch="unloading")
        found = mdi.fit(data, TIP, mdr.Homogeneous(mdr.Elastic(begin["E"], 0.5)), list(TRUTH), instrument=start)
        count.add(found.values, {name: found.interval(name) for name in TRUTH})
    count.report("work_of_adhesion")


if __name__ == "__main__":
    main()
