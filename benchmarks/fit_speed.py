# SPDX-License-Identifier: GPL-3.0-or-later
"""One force-depth curve of 500 points, two free parameters: `mdr.fit` with the exact layered medium against a straightforward
`scipy.optimize.least_squares` whose forward model is the approximate medium, written with `scipy.integrate.quad`.

Both fit the film's modulus and thickness from the same start; under a paraboloid, where the contact radius follows from the depth
in closed form, and under a sphere, where it is the root of g(a) = d. Run: python benchmarks/fit_speed.py
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before any library is loaded

import math
import time
from collections.abc import Callable

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq, least_squares

import mdrcontact as mdr

R, POINTS = 10e-6, 500
FILM, SUBSTRATE = mdr.Elastic(72e9, 0.17), mdr.Elastic(163e9, 0.22)
H = 500e-9
START = (60e9, 450e-9)
Function = Callable[[float], float]


def i0(xi: float, nu: float) -> float:
    """Gao's weight of the shear modulus."""
    logarithm = math.log((1.0 + xi**2) / xi**2)
    bracket = (1.0 - 2.0 * nu) * xi * logarithm - xi / (1.0 + xi**2)
    return 2.0 / math.pi * math.atan(xi) + bracket / (2.0 * math.pi * (1.0 - nu))


def i1(xi: float) -> float:
    """Gao's weight of Poisson's ratio."""
    return 2.0 / math.pi * math.atan(xi) + xi / math.pi * math.log((1.0 + xi**2) / xi**2)


def paraboloid_radius(depth: float) -> float:
    """a from d = g(a) = a^2/R."""
    return math.sqrt(R * depth)


def paraboloid_slope(s: float) -> float:
    """g'(s)."""
    return 2.0 * s / R


def sphere_radius(depth: float) -> float:
    """a from d = g(a) = (a/2) ln((R + a)/(R - a))."""
    return float(brentq(lambda a: 0.5 * a * math.log((R + a) / (R - a)) - depth, 0.0, 0.9 * R))


def sphere_slope(s: float) -> float:
    """g'(s)."""
    return 0.5 * math.log((R + s) / (R - s)) + s * R / (R**2 - s**2)


def force(E0: float, h: float, depth: float, radius: Function, slope: Function) -> float:
    """F = int_0^a 2 s E_eff(s) g'(s) ds."""
    G0, G1 = E0 / (2.0 * (1.0 + FILM.nu)), SUBSTRATE.E / (2.0 * (1.0 + SUBSTRATE.nu))

    def integrand(s: float) -> float:
        nu = SUBSTRATE.nu + (FILM.nu - SUBSTRATE.nu) * i1(h / s)
        G = G1 + (G0 - G1) * i0(h / s, FILM.nu)
        return 2.0 * s * 2.0 * G / (1.0 - nu) * slope(s)

    return float(quad(integrand, 0.0, radius(depth))[0])


def race(name: str, indenter: mdr.Profile, radius: Function, slope: Function) -> None:
    """Fits both ways and prints the ratio."""
    depth = np.linspace(0.2e-9, 100e-9, POINTS)
    exact = mdr.Coated(FILM, H, SUBSTRATE, "exact")
    noise = 1.0 + 0.01 * np.random.default_rng(1).standard_normal(POINTS)
    measured = np.asarray(mdr.Contact(indenter, exact).at_depth(depth).force) * noise
    start = exact.replace(coating=mdr.Elastic(START[0], FILM.nu), thickness=START[1])

    def residuals(p: np.ndarray) -> np.ndarray:
        model = np.array([force(p[0] * START[0], p[1] * START[1], d, radius, slope) for d in depth])
        return (measured - model) / (0.01 * measured)

    began = time.process_time()
    theirs = least_squares(residuals, [1.0, 1.0])
    seconds = time.process_time() - began
    data = mdr.ForceDepth(depth, measured, relative_sd=0.01)
    times = []
    for _ in range(9):
        began = time.process_time()
        ours = mdr.fit(data, indenter, start, ["coating.E", "thickness"])
        times.append(time.process_time() - began)
    print(f"{name}")
    print(f"  SciPy, approximate medium: {1e3 * seconds:.0f} ms, {theirs.nfev} residual and {theirs.njev} Jacobian evaluations")
    print(f"    E0 = {theirs.x[0] * START[0] / 1e9:.2f} GPa, h = {theirs.x[1] * START[1] * 1e9:.1f} nm")
    print(f"  mdr.fit, exact medium: {1e3 * np.median(times):.1f} ms (median of 9), {ours.evaluations} evaluations")
    print(f"    {ours!r}")
    print(f"  ratio {100.0 * float(np.median(times)) / seconds:.2f} % of processor time")


def main() -> None:
    """Both indenters."""
    race("paraboloid", mdr.Paraboloid(R), paraboloid_radius, paraboloid_slope)
    race("sphere", mdr.Sphere(R), sphere_radius, sphere_slope)


if __name__ == "__main__":
    main()
