#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What stresses inside a film and its substrate cost: processor time, and the same in units of one atan + log of this run.

Budgets (exit status 1 if one is missed): a 100 x 100 grid of r and z at a/h = 1, all components, 30 ms; scattered points with
z >= 0.02 a, r <= 2 a 50 us each, nearer the surface 200 us; two threads 1.7 times as fast by the clock, on a machine without
other work.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before any library is loaded
# NumPy with libm, as the library has it, not with vectors of eight
os.environ.setdefault("NPY_DISABLE_CPU_FEATURES", "AVX512F AVX512CD AVX512_SKX AVX512_CLX AVX512_CNL AVX512_ICL AVX512_SPR")

import math
import sys
import time

import numpy as np

import mdrcontact as mdr


def fastest(action, clock=time.process_time, rounds=7):
    """Seconds for one call: the fastest round, since other work on the machine only adds."""
    best = math.inf
    for _ in range(rounds):
        start = clock()
        action()
        best = min(best, clock() - start)
    return best


def main():
    x = np.linspace(0.5, 20.0, 1_000_000)
    unit = fastest(lambda: np.arctan(x) + np.log(x)) / x.size
    print(f"one atan + log: {unit * 1e9:.1f} ns")
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(mdr.Elastic(450.0, 0.25), 1.0, mdr.Elastic(210.0, 0.3)))
    state = contact.at_radius(1.0)
    r, z = np.linspace(0.0, 2.0, 100)[:, None], np.linspace(0.02, 2.0, 100)[None, :]
    random = np.random.default_rng(1)
    points, depths = 2.0 * random.random(1000), 0.02 + 2.0 * random.random(1000)
    near = np.geomspace(1e-6, 0.02, 1000)
    late = []

    def report(what, seconds, budget):
        print(f"{what:32s} {seconds * 1e6:10.1f} us = {seconds / unit:8.0f} units, budget {budget * 1e6:.0f} us")
        if seconds > budget:
            late.append(what)

    report("grid of 100 x 100", fastest(lambda: contact.interior(r, z, state)), 30e-3)
    report("grid of 100 x 100, sliding", fastest(lambda: contact.interior(r, z, state, friction=0.2)), math.inf)
    report("scattered point, z >= 0.02 a", fastest(lambda: contact.interior(points, depths, state)) / 1000, 50e-6)
    report("scattered point, z < 0.02 a", fastest(lambda: contact.interior(points, near, state)) / 1000, 200e-6)
    one = fastest(lambda: contact.interior(r, z, state), time.perf_counter)
    mdr.set_threads(2)
    two = fastest(lambda: contact.interior(r, z, state), time.perf_counter)
    print(f"two threads: {one / two:.2f} times as fast")
    if one / two < 1.7:
        late.append("two threads")
    if late:
        sys.exit("over budget: " + ", ".join(late))


if __name__ == "__main__":
    main()
