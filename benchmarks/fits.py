# SPDX-License-Identifier: GPL-3.0-or-later
"""What a fit costs.

A force-depth curve of 500 points, two free parameters: `fit` with the exact layered medium against a straightforward
`scipy.optimize.least_squares` whose forward model is the approximate medium, written with `scipy.integrate.quad`. Both fit the
film's modulus and thickness from the same start; under a paraboloid, where the contact radius follows from the depth in closed
form, and under a sphere, where it is the root of g(a) = d. Budget: 2 % of SciPy's time.

A folder of 256 such curves by the command line, without a picture. Budget: 10 s by the clock on two cores without other work.

Prints a section of tests/data/benchmarks.md, exit status 1 if a budget is missed: python fits.py >> tests/data/benchmarks.md.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before any library is loaded

import math
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq, least_squares

import mdrcontact as mdr
import mdrcontact.instruments as mdi

R, POINTS, CURVES = 10e-6, 500, 256
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


def curve() -> tuple[np.ndarray, mdr.Coated]:
    """Depths and the film that is fitted."""
    return np.linspace(0.2e-9, 100e-9, POINTS), mdr.Coated(FILM, H, SUBSTRATE, "exact")


def noisy(force: np.ndarray, seed: int) -> np.ndarray:
    """Forces with 1 % of noise."""
    return force * (1.0 + 0.01 * np.random.default_rng(seed).standard_normal(force.size))


def race(name: str, indenter: mdr.Profile, radius: Function, slope: Function) -> float:
    """Fits both ways, prints a row, returns the ratio."""
    depth, exact = curve()
    measured = noisy(np.asarray(mdr.Contact(indenter, exact).at_depth(depth).force), 1)
    start = exact.replace(coating=mdr.Elastic(START[0], FILM.nu), thickness=START[1])

    def residuals(p: np.ndarray) -> np.ndarray:
        model = np.array([force(p[0] * START[0], p[1] * START[1], d, radius, slope) for d in depth])
        return (measured - model) / (0.01 * measured)

    began = time.process_time()
    theirs = least_squares(residuals, [1.0, 1.0])
    seconds = time.process_time() - began
    data = mdi.ForceDepth(depth, measured, relative_sd=0.01)
    times = []
    for _ in range(9):
        began = time.process_time()
        ours = mdi.fit(data, indenter, start, ["coating.E", "thickness"])
        times.append(time.process_time() - began)
    took, ratio = float(np.median(times)), float(np.median(times)) / seconds
    found, modulus = theirs.x[0] * START[0], ours.estimates["coating.E"]
    print(f"| {name} | {1e3 * seconds:.0f} ms, {theirs.nfev} + {2 * theirs.njev} curves, E = {found / 1e9:.2f} GPa ", end="")
    print(f"| {1e3 * took:.1f} ms, {ours.evaluations} curves, E = {modulus / 1e9:.2f} GPa | {100 * ratio:.2f} % |")
    return ratio


def folder() -> float:
    """Seconds by the clock for 256 curves on the command line."""
    depth, exact = curve()
    truth = np.asarray(mdr.Contact(mdr.Sphere(R), exact).at_depth(depth).force)
    problem = (Path(__file__).parent.parent / "examples" / "fit" / "sphere_on_oxide.toml").read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as name:
        curves = Path(name) / "curves"
        curves.mkdir()
        (Path(name) / "problem.toml").write_text(problem, encoding="utf-8")
        for k in range(CURVES):
            rows = np.column_stack([1e9 * depth, 1e3 * noisy(truth, k)])
            np.savetxt(curves / f"{k:03d}.csv", rows, delimiter=",", header="depth [nm],load [mN]", comments="")
        began = time.perf_counter()
        command = [sys.executable, "-m", "mdrcontact", "fit", str(curves), "--problem", f"{name}/problem.toml"]
        out = subprocess.run([*command, "--csv", f"{name}/out.csv"], check=True, capture_output=True, text=True).stdout
    took = time.perf_counter() - began
    said = next(line for line in out.splitlines() if f" of {CURVES} " in line)
    print(f"\n{CURVES} curves of {POINTS} points in a folder, exact film, by `mdrcontact fit`: {took:.1f} s by the clock; it says")
    print(f'"{said.strip()}".')
    return took


def main() -> int:
    """Both indenters, then the folder."""
    print("\n## Fits\n\nMade by `benchmarks/fits.py`: one curve of 500 points, modulus and thickness free, processor time.\n")
    print("| indenter | SciPy, approximate medium | `fit`, exact medium | ratio, budget 2 % |\n|---|---|---|---|")
    ratios = [
        race("paraboloid", mdr.Paraboloid(R), paraboloid_radius, paraboloid_slope),
        race("sphere", mdr.Sphere(R), sphere_radius, sphere_slope),
    ]
    return 1 if (folder() > 10.0) | (max(ratios) > 0.02) else 0


if __name__ == "__main__":
    sys.exit(main())
