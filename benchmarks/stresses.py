#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What stresses inside a film and its substrate cost: processor time, and the same in units of one atan + log of this run.

Budgets (exit status 1 if one is missed): a 100 x 100 grid of r and z at a/h = 1, all components, 30 ms; scattered points with
z >= 0.02 a, r <= 2 a 50 us each, nearer the surface 200 us; two threads 1.7 times as fast by the clock, on a machine without
other work.

Then tamaas beside it where it is installed, homogeneous body under Hertz's pressure: error over time. Prints a section of
tests/data/benchmarks.md: python stresses.py >> tests/data/benchmarks.md.
"""

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before any library is loaded
# NumPy with libm, as the library has it, not with vectors of eight
os.environ.setdefault("NPY_DISABLE_CPU_FEATURES", "AVX512F AVX512CD AVX512_SKX AVX512_CLX AVX512_CNL AVX512_ICL AVX512_SPR")

import math
import sys
import time

import numpy as np
from compare import machine

import mdrcontact as mdr


def fastest(action, clock=time.process_time, rounds=7):
    """Seconds for one call: the fastest round, since other work on the machine only adds."""
    best = math.inf
    for _ in range(rounds):
        start = clock()
        action()
        best = min(best, clock() - start)
    return best


def huber(r, z, nu):
    """Huber's stresses s_rr, s_tt, s_zz, s_rz under Hertz's pressure sqrt(1 - r^2), r >= 0, z > 0 (Ann. Phys. 14, 153, 1904)."""
    q = r**2 + z**2 - 1.0
    u = 0.5 * (q + np.sqrt(q**2 + 4.0 * z**2))
    root = np.sqrt(u)
    c = z / root
    # (1 - c^3)/r^2, on the axis its limit: c^2 = 1 - r^2/(1 + u) holds everywhere
    ring = (1.0 - 2.0 * nu) / 3.0 * (1.0 + c + c**2) / ((1.0 + c) * (1.0 + u))
    film, bend = (1.0 - nu) * u / (1.0 + u), (1.0 + nu) * root * np.arctan(1.0 / root)
    s_zz = -(c**3) * u / (u**2 + z**2)
    s_rr = ring - s_zz + c * (film + bend - 2.0)
    s_tt = -ring - c * (2.0 * nu + film - bend)
    return np.stack([s_rr, s_tt, s_zz, -r * z**2 / (u**2 + z**2) * root / (1.0 + u)])


def beside_tamaas(points, side, depths=9, nu=0.3):
    """(code, error, seconds) of tamaas and of this library at the same points x, y, z; the pressure is given to both.

    Error: the largest of s_rr, s_tt, s_zz, s_rz in units of the largest pressure, at r <= 2 a, 0.25 a <= z <= 2 a. tamaas is
    periodic: its box has the side given, in contact radii. Its six components are xx, yy, zz, sqrt(2) times xy, xz, yz.
    """
    import tamaas as tm

    tm.set_log_level(tm.LogLevel.error)
    tm.initialize(1)
    model = tm.ModelFactory.createModel(tm.model_type.volume_2d, [2.0, side, side], [depths, points, points])
    model.E, model.nu = 1.0, nu
    tm.ModelFactory.registerVolumeOperators(model)
    x = (np.arange(points) - points // 2) * side / points
    r, z = np.hypot(x[:, None], x[None, :]), np.linspace(0.0, 2.0, depths)
    model.traction[...] = 0.0
    model.traction[..., 2] = np.sqrt(np.maximum(0.0, 1.0 - r**2))
    strain, stress = np.zeros((depths, points, points, 6)), np.zeros((depths, points, points, 6))

    def elements():
        model.operators["boussinesq_gradient"](model.traction, strain)
        model.operators["hooke"](strain, stress)

    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(1.0, nu)))
    state = contact.at_radius(1.0)
    seconds = fastest(elements, rounds=3), fastest(lambda: state.interior(r.ravel(), z[:, None]), rounds=3)

    inside, below = r <= 2.0, z >= 0.25
    exact = huber(r[inside], z[below, None], nu)
    xx, yy, zz, xy, xz, yz = np.moveaxis(stress[below][:, inside], -1, 0)
    azimuth = np.arctan2(*np.meshgrid(x, x))[inside]  # of the point, x along the first axis
    cos, sin = np.cos(azimuth), np.sin(azimuth)
    normal = np.sqrt(2.0) * xy * cos * sin
    theirs = xx * cos**2 + yy * sin**2 + normal, xx * sin**2 + yy * cos**2 - normal, zz, (xz * cos + yz * sin) / np.sqrt(2.0)
    own = state.interior(r[inside], z[below, None])
    largest = state.pressure(0.0)
    ours = np.stack([own.s_rr, own.s_tt, own.s_zz, own.s_rz]) / largest
    errors = abs(np.stack(theirs) - exact).max(), abs(ours - exact).max()
    return list(zip(("tamaas", "mdrcontact"), errors, seconds, strict=True))


def main():
    x = np.linspace(0.5, 20.0, 1_000_000)
    unit = fastest(lambda: np.arctan(x) + np.log(x)) / x.size
    print("\n## Stresses inside\n\nMade by `benchmarks/stresses.py`, all in one run; processor time of one thread.\n")
    print(f"Machine: {machine()}; load average at the start {os.getloadavg()[0]:.1f}.")
    print(f"One atan + log of this run: {unit * 1e9:.1f} ns. Film and substrate at a/h = 1:\n")
    print("| what | us | units of atan + log | budget, us |\n|---|---|---|---|")
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(mdr.Elastic(450.0, 0.25), 1.0, mdr.Elastic(210.0, 0.3)))
    state = contact.at_radius(1.0)
    r, z = np.linspace(0.0, 2.0, 100)[:, None], np.linspace(0.02, 2.0, 100)[None, :]
    random = np.random.default_rng(1)
    points, depths = 2.0 * random.random(1000), 0.02 + 2.0 * random.random(1000)
    near = np.geomspace(1e-6, 0.02, 1000)
    late = []

    def report(what, seconds, budget):
        print(f"| {what} | {seconds * 1e6:.1f} | {seconds / unit:.0f} | {budget * 1e6:.0f} |".replace("inf", "-"))
        if seconds > budget:
            late.append(what)

    report("grid of 100 x 100", fastest(lambda: state.interior(r, z)), 30e-3)
    report("grid of 100 x 100, sliding", fastest(lambda: state.interior(r, z, friction=0.2)), math.inf)
    report("scattered point, z >= 0.02 a", fastest(lambda: state.interior(points, depths)) / 1000, 50e-6)
    report("scattered point, z < 0.02 a", fastest(lambda: state.interior(points, near)) / 1000, 200e-6)
    one = fastest(lambda: state.interior(r, z), time.perf_counter)
    mdr.set_threads(2)
    two = fastest(lambda: state.interior(r, z), time.perf_counter)
    print(f"\nTwo threads: {one / two:.2f} times as fast by the clock; budget 1.7, on a machine without other work.\n")
    if one / two < 1.7:
        late.append("two threads")
    mdr.set_threads(1)
    try:
        rows = [(n, side, row) for n, side in ((64, 8.0), (128, 12.0), (256, 16.0)) for row in beside_tamaas(n, side)]
    except ImportError:
        print("tamaas is not compared: it is not installed.")
    else:
        print("Homogeneous body, Hertz's pressure, nu = 0.3; all stresses at the same points by both. Error: the largest of s_rr,")
        print("s_tt, s_zz, s_rz against Huber's closed field in units of the largest pressure, at r <= 2 a, 0.25 a <= z <= 2 a.")
        print("tamaas takes any pressure and is periodic: its error is that of the grid and of the box.\n")
        print("| code | points | side of the box | error | seconds | us a point |\n|---|---|---|---|---|---|")
        for n, side, (code, error, seconds) in rows:
            each = seconds * 1e6 / (9 * n**2)
            print(f"| {code} | {n} x {n} x 9 | {side:.0f} a | {error:.1e} | {seconds:.3f} | {each:.2f} |")
    if late:
        sys.exit("over budget: " + ", ".join(late))


if __name__ == "__main__":
    main()
