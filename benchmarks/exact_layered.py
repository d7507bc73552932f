#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the exact layered medium costs, in calls of scipy.integrate.quad on a smooth one-line integrand.

Both are timed in this run, on one core. Usage: exact_layered.py path/to/libmdrcontact.so
Budgets (exit status 1 if one is missed): making a coated medium 1000 calls; E_eff, d and F at one contact radius
10 calls at a/h = 1 and 1000 at a/h = 100.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before any library is loaded

import ctypes
import math
import sys
import time

from scipy.integrate import quad

EXACT = 11  # MDR_MODEL_EXACT
double = ctypes.c_double
pointer = ctypes.c_void_p


def fastest(action, repetitions, rounds=7):
    """Seconds for one call of `action`: the fastest round, since other work on the machine only adds."""
    best = math.inf
    for _ in range(rounds):
        start = time.perf_counter()
        for _ in range(repetitions):
            action()
        best = min(best, (time.perf_counter() - start) / repetitions)
    return best


def checked(status):
    if status != 0:
        raise RuntimeError(f"the library returned status {status}")


def main(path):
    library = ctypes.CDLL(path)
    library.mdr_medium_coated.argtypes = [double] * 5 + [ctypes.c_int, pointer, ctypes.POINTER(pointer)]
    library.mdr_profile_paraboloid.argtypes = [double, ctypes.POINTER(pointer)]
    library.mdr_contact_new.argtypes = [pointer, pointer, pointer, ctypes.POINTER(pointer)]
    library.mdr_contact_from_radius.argtypes = [pointer, ctypes.c_int] + [pointer] * 5

    unit = fastest(lambda: quad(lambda x: math.exp(-x) * math.cos(x), 0.0, 1.0), 2000)
    print(f"one call of quad: {unit * 1e6:.1f} us")
    profile = pointer()
    checked(library.mdr_profile_paraboloid(1.0, ctypes.byref(profile)))
    late = []

    def report(what, seconds, budget):
        ratio = seconds / unit
        print(f"{what:44s} {seconds * 1e6:9.1f} us = {ratio:7.1f} calls, budget {budget}")
        if ratio > budget:
            late.append(what)

    for ratio in (0.01, 0.1, 10.0, 100.0):
        medium, contact = pointer(), pointer()

        def make(out):
            checked(library.mdr_medium_coated(ratio, 0.3, 1.0, 1.0, 0.3, EXACT, None, ctypes.byref(out)))

        def make_and_free():
            out = pointer()
            make(out)
            library.mdr_medium_free(ctypes.byref(out))

        make(medium)
        checked(library.mdr_contact_new(profile, medium, None, ctypes.byref(contact)))
        report(f"E0/E1 = {ratio}: medium", fastest(make_and_free, 20), 1000)
        depth, radius, force, stiffness = double(), double(), double(), double()

        def solve(a):
            checked(
                library.mdr_contact_from_radius(
                    contact,
                    1,
                    ctypes.byref(a),
                    ctypes.byref(depth),
                    ctypes.byref(radius),
                    ctypes.byref(force),
                    ctypes.byref(stiffness),
                )
            )

        for a, budget, repetitions in ((1.0, 10, 1000), (100.0, 1000, 10)):
            report(f"E0/E1 = {ratio}: E_eff, d, F at a/h = {a:g}", fastest(lambda: solve(double(a)), repetitions), budget)
    return 1 if late else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
