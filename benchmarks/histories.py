#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What viscoelastic bodies cost: histories, dynamic stiffness, fits; processor time.

Budgets (exit status 1 if one is missed): 1000 samples up and down on a homogeneous body of ten Prony terms 1 ms; a layered history
of 200 samples, marched to 1e-4, 0.5 s; the dynamic stiffness at another radius 20 elastic exact states, at a new frequency two
elastic media and 20 states; a fit of 2000 readings of approach and retraction with a power law on a rigid base 0.3 s, with the
thickness too and a start 20 % off in all; of a gel 200 times of a relaxation 5 ms, a new table 1 s, a fit of 2000 readings 0.5 s;
1000 samples of adhesion with a rate on a film 20 ms, the film's samples included.
Beside it the same homogeneous history by SciPy's adaptive quadrature of Ting's integrals, the root t1 by bisection. Prints a
section of tests/data/benchmarks.md.
"""

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before any library is loaded

import sys

import numpy as np
from compare import machine
from scipy import integrate, optimize
from stresses import fastest

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact import poroelastic

TERMS = [(0.1 * (i + 1), 1e-3 * 10.0 ** (0.5 * i)) for i in range(10)]
TIME = np.linspace(0.0, 2.0, 1001)
DEPTH = np.minimum(TIME, 2.0 - TIME)


def by_quadrature(t):
    """F(t) of a paraboloid with g = x^2 under the path, E* = 4 G(t), straightforward: F = 8 int G(t - u) a(u) d'(u) du."""
    G = np.array([g for g, _ in TERMS])
    rate = 1.0 / np.array([tau for _, tau in TERMS])

    def relaxation(age):
        return 0.3 + G @ np.exp(-rate * age)

    end = t
    if t > 1.0:

        def lost(t1):
            rising = integrate.quad(lambda u: relaxation(t - u), t1, 1.0, epsrel=1e-9)[0]
            return rising - integrate.quad(lambda u: relaxation(t - u), 1.0, t, epsrel=1e-9)[0]

        if lost(0.0) <= 0.0:
            return 0.0
        end = optimize.brentq(lost, 0.0, 1.0, xtol=1e-10)
    # u = y^2 takes the root out of a(u)
    return 8.0 * integrate.quad(lambda y: relaxation(t - y**2) * 2.0 * y**2, 0.0, np.sqrt(end), epsrel=1e-9, limit=200)[0]


def main():
    """Measures, prints, judges."""
    polymer = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Viscoelastic(0.3, TERMS, nu=0.5)))
    rows = [("homogeneous, 10 Prony terms, 1000 samples up and down", fastest(lambda: polymer.history(TIME, depth=DEPTH)), 1e-3)]
    chosen = [100, 400, 600, 700]
    error = max(abs(polymer.history(TIME, depth=DEPTH).force[i] / by_quadrature(TIME[i]) - 1.0) for i in chosen)
    each = fastest(lambda: [by_quadrature(TIME[i]) for i in chosen], rounds=3) / len(chosen)
    rows.append((f"the same by SciPy's quadrature, 1000 times one sample (differs by {error:.0e})", 1000.0 * each, None))

    film = mdr.Coated(mdr.Viscoelastic(1.0, [(2.0, 0.5)], nu=0.5), 1.0, mdr.Viscoelastic(0.6, [(0.4, 2.0)], nu=0.3))
    layered, path = mdr.Contact(mdr.Paraboloid(1.0), film), np.linspace(0.0, 2.0, 201)
    marched = fastest(lambda: layered.history(path, depth=0.8 * np.minimum(path, 2.0 - path), tolerance=1e-4), rounds=3)
    rows.append(("layers that do not relax proportionally, 200 samples, to 1e-4", marched, 0.5))

    coated, rate = mdr.Coated(mdr.Elastic(1.0, 0.5), 1.0, mdr.Elastic(100.0, 0.3)), mdr.adhesion.RateAdhesion(0.02, 1e-3, 0.33)
    turning = np.interp(np.linspace(0.0, 400.0, 1000), [0.0, 60.0, 80.0, 400.0], [-0.01, 0.05, 0.05, -0.6])
    pulled = fastest(
        lambda: mdr.adhesion.rate_history(mdr.Contact(mdr.Paraboloid(1.0), coated, adhesion=rate), np.arange(1000.0), depth=turning)
    )
    rows.append(("adhesion with a rate on a film, 1000 samples, approach to pull-off", pulled, 20e-3))

    elastic = mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(mdr.Elastic(3.0, 0.5), 1.0, mdr.Elastic(1.0, 0.3)))
    radii = np.linspace(0.5, 1.0, 101)
    state = fastest(lambda: elastic.at_radius(radii)) / radii.size
    new = fastest(lambda: layered.dynamic_stiffness(1.0, radius=radii[0]))
    another = (fastest(lambda: layered.dynamic_stiffness(1.0, radius=radii)) - new) / (radii.size - 1)
    rows.append((f"dynamic stiffness at a further radius ({another / state:.1f} elastic states)", another, 20.0 * state))
    media = fastest(lambda: [mdr.Coated(mdr.Elastic(3.0 + 0.1 * i, 0.5), 1.0, mdr.Elastic(1.0, 0.3)) for i in range(10)]) / 10.0
    rows.append((f"dynamic stiffness at a new frequency ({new / media:.1f} elastic media made)", new, 2.0 * media + 20.0 * state))

    time = np.linspace(0.0, 2.0, 2000)
    depth = np.minimum(time, 2.0 - time) * 1e-6 - 0.1e-6
    gel = mdr.Coated(mdr.PowerLawRheology(1e3, 1.0, 0.2, 0.5), 3e-6, mdr.RIGID)
    tip = mdr.Sphere(5e-6)
    force = mdr.Contact(tip, gel).history(time, depth=depth).force + 2e-11 * np.random.default_rng(1).standard_normal(time.size)
    data = mdi.ForceTime(time, depth + 0.1e-6, force)
    start = gel.replace(coating=mdr.PowerLawRheology(500.0, 1.0, 0.3, 0.5))
    given = {"instrument": mdi.Instrument(depth_offset=0.095e-6)}
    free = ["coating.modulus", "coating.exponent", "depth_offset"]
    result = mdi.fit(data, tip, start, free, **given)
    fitted = fastest(lambda: mdi.fit(data, tip, start, free, **given), rounds=3)
    rows.append((f"fit of 2000 readings, power law on a rigid base, {result.evaluations} evaluations", fitted, 0.3))
    start = gel.replace(coating=mdr.PowerLawRheology(1200.0, 1.0, 0.24, 0.5), thickness=3.6e-6)
    given = {"instrument": mdi.Instrument(depth_offset=0.12e-6)}
    wide = {**dict.fromkeys(free), "thickness": mdi.Free(prior=(3e-6, 0.1e-6))}
    result = mdi.fit(data, tip, start, wide, **given)
    fitted = fastest(lambda: mdi.fit(data, tip, start, wide, **given), rounds=3)
    rows.append((f"the same with the thickness, a prior on it, {result.evaluations} evaluations", fitted, 0.3))

    creeping = mdr.Homogeneous(mdr.Viscoelastic(0.5, [(4.5, 0.1)], nu=0.0))
    zoned = mdr.Contact(mdr.Paraboloid(1.0), creeping, work_of_adhesion=0.01, cohesive_stress=0.25)

    def drawn_off(speed):
        return fastest(
            lambda: mdr.adhesion.adhesive_history(zoned, [0.0, 1.0 / speed], depth=[0.32, -0.68], start="rest", tolerance=1e-4)
        )

    quick = drawn_off(1e-2)
    rows.append(("creeping half-space with a zone, drawn off at V tau/R = 1e-2", quick, None))
    rows.append(("the same at 1e-5, most of which is rest", drawn_off(1e-5), 15.0 * quick))
    rows += gels()
    print(f"## Viscoelastic bodies\n\n{machine()}\n\n| what | time | budget |\n|---|---|---|")
    for what, seconds, budget in rows:
        print(f"| {what} | {duration(seconds)} | {'' if budget is None else duration(budget)} |")
    return any(budget is not None and seconds > budget for _, seconds, budget in rows)


def gels():
    """Poroelastic gels: from the table, a new table, fits."""
    gel, tip = mdr.poroelastic.Poroelastic(28e3, 0.28, 3e-8), mdr.FlatPunch(1e-3)
    contact, time = mdr.Contact(tip, mdr.Homogeneous(gel)), np.append(0.0, np.geomspace(0.2, 2000.0, 1999))
    force = mdr.poroelastic.history(contact, time, depth=np.full(time.shape, 5e-5), drainage="indenter").force
    rows = [
        (
            "gel, 200 times of a relaxation from the table",
            fastest(lambda: contact.relaxation(time[::10], drainage="indenter")),
            5e-3,
        )
    ]

    def new(drainage):
        poroelastic.table.cache_clear()
        return contact.relaxation(1.0, drainage=drainage)

    rows += [
        (f'gel, a new table, "{name}"', fastest(lambda name=name: new(name), rounds=2), 1.0) for name in ("surface", "indenter")
    ]
    data = mdi.ForceTime(
        time, np.full(time.shape, 5e-5), force + 1e-5 * np.random.default_rng(1).standard_normal(time.size), sd=1e-5
    )
    names, start = ("shear_modulus", "diffusivity"), mdr.Homogeneous(gel.replace(shear_modulus=1e3, diffusivity=1e-9))
    for free in (names, (*names, "nu")):
        mdi.fit_gel(data, tip, start, free, drainage="indenter")  # makes the tables
        seconds = fastest(lambda free=free: mdi.fit_gel(data, tip, start, free, drainage="indenter"), rounds=2)
        rows.append((f"gel, fit of 2000 readings, {', '.join(free)}", seconds, 0.5))
    return rows


def duration(seconds):
    """A time in words."""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size or unit == "µs":
            break
    return f"{seconds / size:.3g} {unit}"


if __name__ == "__main__":
    sys.exit(main())
