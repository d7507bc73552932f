# SPDX-License-Identifier: GPL-3.0-or-later
"""From one contact to many: what a coating does to a rough joint.

Three statements, by what they are worth. Exact: the compliance C(k), from which follow the lattice constant of a periodic array and
the pressure of full contact. Exact for each asperity: Greenwood and Williamson's sums over asperities, here of a compiled law. A
theory with an error of its own: Persson's mean gap, within 11 % of a solver in the plane up to a tenth of full contact on coatings
too; his contact area is 10 to 50 % too small there and is not shown.

The parameter study runs on Dask with one, two and four workers. E1* = 1 of the substrate, lengths in any unit.
"""

import math
import sys
import time
from collections.abc import Callable

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

NU, SQUARE_LATTICE, PERSSON = 0.3, -3.90026492, 0.45
"""Poisson's ratio; point loads on a square lattice against their mean; gamma of Persson 2008."""
DEVIATION, RADIUS = 1e-3, 1.0
"""Of the summits' heights, and their radius."""


def coated(ratio, thickness, surface_modulus):
    """A film with E0* and G0/G1 = ratio; homogeneous for ratio 1."""
    film = mdr.Elastic(surface_modulus * (1.0 - NU**2), NU)
    if ratio == 1.0:
        return mdr.Homogeneous(film)
    return mdr.Coated(film, thickness, mdr.Elastic(film.E / ratio, NU))


def gauss(count, start, end):
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return start + 0.5 * (end - start) * (nodes + 1.0), 0.5 * (end - start) * weights


def joint(law, separation, points=200, reach=9.0):
    """Of a unit of asperities whose summits are N(0, DEVIATION): pressure, area, stiffness, sum of radii
    (theory/rough.md (2.1)-(2.3))."""
    top = max(separation, 0.0) + reach * DEVIATION
    t, weights = gauss(points, 0.0, 1.0)
    z = separation + (top - separation) * t**2
    weights = 2.0 * (top - separation) * t * weights * np.exp(-0.5 * (z / DEVIATION) ** 2) / (math.sqrt(2.0 * math.pi) * DEVIATION)
    state = law.at_depth(z - separation)
    slope = np.asarray(state.slope)
    return np.array([weights @ state.force, weights @ (math.pi * state.radius**2), weights @ slope, weights @ state.radius])


def law_of(medium):
    largest = 10.0 * DEVIATION
    return mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(RADIUS), medium), largest, smallest_depth=1e-6 * largest, tolerance=1e-9)


def at_pressure(law, pressure):
    """The separation at which the asperities bear a pressure, and what the joint is there."""
    low, high = -0.5 * DEVIATION, 5.0 * DEVIATION
    for _ in range(60):
        middle = 0.5 * (low + high)
        if joint(law, middle)[0] > pressure:
            low = middle
        else:
            high = middle
    return middle, joint(law, middle)


def factors(ratio, thickness, separations=(1.0, 3.0)):
    """What a film of a thickness, in units of sqrt(R sd), makes of the bare joint at the same pressure: for each separation of the
    bare one area, separation in deviations, stiffness, sum of radii."""
    bare = law_of(coated(1.0, 1.0, 1.0))
    film = law_of(coated(ratio, thickness * math.sqrt(RADIUS * DEVIATION), ratio))
    rows = []
    for u in separations:
        before = joint(bare, u * DEVIATION)
        separation, after = at_pressure(film, before[0])
        rows.append((after[1] / before[1], separation / DEVIATION, after[2] / before[2], after[3] / before[3]))
    return rows


def lattice_constant(medium, surface_modulus, side):
    """c of D = d + c F, to first order in (a/L)^2: what the other asperities of a square array lift the one in the middle by
    (theory/rough.md (3.2))."""

    def excess(k):
        return medium.compliance(k) - 2.0 / (surface_modulus * k)

    c = SQUARE_LATTICE / (math.pi * surface_modulus * side)
    if isinstance(medium, mdr.Homogeneous):
        return c
    largest = 20.0 / medium.thickness
    rings = math.ceil(largest * side / (2.0 * math.pi))
    index = np.arange(-rings, rings + 1)
    k = 2.0 * math.pi / side * np.hypot(*np.meshgrid(index, index)).ravel()
    c += np.sum(excess(k[k > 0.0])) / side**2
    for start, end in zip(np.arange(40) * largest / 40, np.arange(1, 41) * largest / 40, strict=True):
        k, weights = gauss(16, start, end)
        c -= weights @ (excess(k) * k) / (2.0 * math.pi)
    return float(c)


def persson(compliance: Callable, pressure, hurst=0.8, first=4.0, last=32.0, points=400):
    """Variance of the pressure of full contact, contact area and mean gap of a self-affine surface of mean square slope 1
    (theory/rough.md (4.1), (4.4))."""
    x, weights = gauss(points, math.log(first), math.log(last))
    q = np.exp(x)
    spectrum = q ** (-2.0 * (1.0 + hurst))
    spectrum /= 2.0 * math.pi * np.sum(weights * q**4 * spectrum)
    density = 2.0 * math.pi * q**2 * spectrum / compliance(q) ** 2
    # the integral from `first` to each point, by the same rule on a part of the range
    inner, inner_weights = gauss(60, 0.0, 1.0)
    variance = np.empty(points)
    for i, end in enumerate(x):
        part = np.exp(x[0] + math.log(first) - x[0] + (end - math.log(first)) * inner)
        scale = spectrum[0] * q[0] ** (2.0 * (1.0 + hurst))
        variance[i] = (end - math.log(first)) * np.sum(
            inner_weights * 2.0 * math.pi * part**2 * scale * part ** (-2.0 * (1.0 + hurst)) / compliance(part) ** 2
        )
    total = float(np.sum(weights * density))
    y = pressure / np.sqrt(variance)
    gap = np.sum(weights * math.pi * q**2 * spectrum / compliance(q) * tail(y) / np.sqrt(variance))
    return total, math.erf(pressure / math.sqrt(2.0 * total)), float(gap)


def tail(y):
    """int_y^inf (gamma + 3 (1 - gamma) erf(t/sqrt(2))^2) sqrt(2/pi) exp(-t^2/2)/t dt."""
    s, weights = gauss(200, 0.0, 1.0)
    result = np.zeros_like(y)
    erf = np.vectorize(math.erf)
    for i, start in enumerate(y):
        if start > 12.0:
            continue
        # t = start (12/start)^s
        t = start * (12.0 / start) ** s
        value = (PERSSON + 3.0 * (1.0 - PERSSON) * erf(t / math.sqrt(2.0)) ** 2) * math.sqrt(2.0 / math.pi) * np.exp(-0.5 * t**2)
        result[i] = np.sum(weights * value) * math.log(12.0 / start)
    return result


def study(workers, cases):
    """The factors of all cases, by so many processes of Dask; seconds."""
    import dask

    began = time.perf_counter()
    tasks = [dask.delayed(factors)(*case) for case in cases]
    if workers == 1:
        found = dask.compute(*tasks, scheduler="synchronous")
    else:
        found = dask.compute(*tasks, scheduler="processes", num_workers=workers)
    return found, time.perf_counter() - began


def main():
    """Prints the tables and draws how a film changes a joint."""
    print("film on a body, at the pressure of the bare joint at u/sd = 1 and 3: area, u/sd, stiffness, sum of radii")
    cases = [(ratio, h) for ratio in (10.0, 0.1) for h in (0.1, 0.3, 1.0, 3.0)]
    runs = [study(workers, cases) for workers in (1, 2, 4)]
    assert all(np.array_equal(runs[0][0], run[0]) for run in runs[1:])
    for (ratio, h), rows in zip(cases, runs[0][0], strict=True):
        words = "   ".join(" ".join(f"{value:6.3f}" for value in row) for row in rows)
        print(f"G0/G1 = {ratio:4.1f}, h/sqrt(R sd) = {h:3.1f}: {words}")
    print("workers, seconds: " + ", ".join(f"{n}: {seconds:.1f}" for n, (_, seconds) in zip((1, 2, 4), runs, strict=True)))
    print("\nsquare array of paraboloids, a = 0.5: shift of the depth c F/d at L/a = 8 and 4")
    for name, ratio in (("homogeneous", 1.0), ("film 10:1, h = a", 10.0), ("film 1:10, h = a", 0.1)):
        medium = coated(ratio, 0.5, 1.0)
        state = mdr.Contact(mdr.Paraboloid(1.0), medium).at_radius(0.5)
        shifts = [lattice_constant(medium, 1.0, side) * state.force / state.depth for side in (4.0, 2.0)]
        print(f"{name}: {shifts[0]:.3f}, {shifts[1]:.3f}")
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    h = [case[1] for case in cases[:4]]
    for start, name in ((0, "stiff film, 10:1"), (4, "soft film, 1:10")):
        rows = np.array([found[0] for found in runs[0][0][start : start + 4]])
        left.loglog(h, rows[:, 0], "o-", label=f"area, {name}")
        left.loglog(h, rows[:, 2], "s--", label=f"stiffness, {name}")
        left.loglog(h, rows[:, 3], "^:", label=f"conductance, {name}")
    left.set(xlabel="film thickness h/sqrt(R sd)", ylabel="factor at the same pressure")
    left.set_ylim(0.05, 10.0)
    left.legend(fontsize=7, ncols=2, loc="lower center")
    for name, ratio in (("homogeneous", 1.0), ("film 10:1", 10.0), ("film 1:10", 0.1)):
        medium = coated(ratio, 0.1, 1.0)
        root = math.sqrt(persson(medium.compliance, 1.0)[0])
        parts = np.geomspace(0.02, 0.3, 8)
        right.semilogy(parts, [persson(medium.compliance, part * root)[2] for part in parts], label=name)
    right.set(xlabel="pressure, relative to that of full contact", ylabel="mean gap (Persson; error at most 11 %)")
    right.set_yticks([0.02, 0.05, 0.1, 0.2], ["0.02", "0.05", "0.1", "0.2"])
    right.yaxis.minorticks_off()
    right.legend(fontsize=7)
    figure.savefig("rough_joint.png", dpi=120)
    print("\nwritten: rough_joint.png")


if __name__ == "__main__":
    sys.exit(main())
