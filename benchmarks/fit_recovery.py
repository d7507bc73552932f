# SPDX-License-Identifier: GPL-3.0-or-later
"""Do the intervals of `mdrcontact.instruments.fit` hold what they promise?

Synthetic force-depth curves of the exact layered medium with 1 % noise, 30 film/substrate systems, 200 repetitions of each:
how often lies the true value inside the 95 % interval? Free are the film's modulus and its thickness, the latter known
beforehand to 5 %. --lag 0.9 lets neighbouring readings share their noise; --area-sd 0.02 takes stiffness against radius instead,
with a tip whose area is off by 2 %, which is known beforehand.
Run: python benchmarks/fit_recovery.py [--repetitions 200] [--lag 0.9] [--area-sd 0.02] [--table FILE.md]
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before any library is loaded

import argparse
import itertools
import shlex
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
from recovery import autoregression
from tqdm import tqdm

import mdrcontact as mdr
import mdrcontact.instruments as mdi

THICKNESS = 500e-9
PRIOR = 0.05 * THICKNESS
NOISE = 0.01
POINTS = 60
SUBSTRATE = mdr.Elastic(150e9, 0.25)
RATIOS = (0.03, 0.2, 0.5, 2.0, 6.0)
"""film modulus over substrate modulus"""
REACHES = (0.5, 1.5, 4.0)
"""largest a/h of the curve"""
INDENTERS = (("sphere", mdr.Paraboloid(10e-6), 0.3), ("cone", mdr.Cone(0.34), 0.35))
"""name, shape, Poisson's ratio of the film it is pressed on"""


def study(
    system: tuple[float, float, tuple[str, mdr.Paraboloid, float]], repetitions: int, lag: float, area_sd: float, seed: int
) -> dict[str, float | str]:
    """Coverage and scatter in one system."""
    ratio, reach, (name, indenter, nu) = system
    film = mdr.Elastic(ratio * SUBSTRATE.E, nu)
    truth = {"coating.E": film.E, "thickness": THICKNESS}
    medium = mdr.Coated(film, THICKNESS, SUBSTRATE, "exact")
    contact = mdr.Contact(indenter, medium)
    deepest = float(contact.at_radius(reach * THICKNESS).depth)
    depth = np.linspace(deepest / POINTS, deepest, POINTS)
    force = np.asarray(contact.at_depth(depth).force)
    radius = np.linspace(reach * THICKNESS / POINTS, reach * THICKNESS, POINTS)
    stiffness = np.asarray(medium.stiffness(radius))
    random = np.random.default_rng(seed)
    # the search begins away from the truth
    start = medium.replace(coating=mdr.Elastic(1.5 * film.E, nu))
    inside = dict.fromkeys(truth, 0)
    normal_scores: list[float] = []
    errors: list[float] = []
    failed = 0
    for _ in range(repetitions):
        factor = 1.0 + NOISE * autoregression(random, lag, POINTS)
        free = {"coating.E": None, "thickness": mdi.Free(prior=(THICKNESS + PRIOR * random.standard_normal(), PRIOR))}
        data: mdi.ForceDepth | mdi.StiffnessRadius = mdi.ForceDepth(depth, force * factor, relative_sd=NOISE)
        if area_sd > 0.0:
            true_area = 1.0 + area_sd * random.standard_normal()
            data = mdi.StiffnessRadius(radius / np.sqrt(true_area), stiffness * factor, relative_sd=NOISE)
            free["area_factor"] = mdi.Free(prior=(1.0, area_sd))
        result = mdi.fit(data, indenter, start, free)
        failed += not result.converged
        for parameter, true in truth.items():
            lower, upper = result.interval(parameter, 0.95)
            inside[parameter] += lower <= true <= upper
        normal_scores.append((result.estimates["coating.E"] - film.E) / result.standard_errors["coating.E"])
        errors.append(result.standard_errors["coating.E"] / film.E)
    return {
        "indenter": name,
        "E0/E1": ratio,
        "a/h up to": reach,
        "coverage of E0": inside["coating.E"] / repetitions,
        "coverage of h": inside["thickness"] / repetitions,
        "standard error of E0": float(np.mean(errors)),
        "mean of (E0 - true)/se": float(np.mean(normal_scores)),
        "not converged": failed,
    }


def main() -> None:
    """Runs all systems and prints the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repetitions", type=int, default=200)
    parser.add_argument("--lag", type=float, default=0.0, help="correlation of neighbouring readings (0)")
    parser.add_argument("--area-sd", type=float, default=0.0, help="relative error of the tip's area (0)")
    parser.add_argument("--table", type=Path, help="write the table as Markdown")
    arguments = parser.parse_args()
    systems = list(itertools.product(RATIOS, REACHES, INDENTERS))
    began = time.perf_counter()
    with ThreadPoolExecutor() as pool:
        jobs = [
            pool.submit(study, system, arguments.repetitions, arguments.lag, arguments.area_sd, seed)
            for seed, system in enumerate(systems)
        ]
        rows = [job.result() for job in tqdm(jobs, unit="systems")]
    seconds = time.perf_counter() - began
    lines = ["| " + " | ".join(rows[0]) + " |", "|" + "---|" * len(rows[0])]
    for row in rows:
        cells = []
        for name, value in row.items():
            percent = name.startswith(("coverage", "standard"))
            cells.append(f"{100.0 * value:.1f} %" if percent else value if isinstance(value, str) else f"{value:.3g}")
        lines.append("| " + " | ".join(cells) + " |")
    of_modulus = [row["coverage of E0"] for row in rows]
    of_thickness = [row["coverage of h"] for row in rows]
    outside = sum(not 0.91 <= c <= 0.99 for c in of_modulus)
    outside_h = sum(not 0.91 <= c <= 0.99 for c in of_thickness)
    verdict = [
        f"{len(rows)} systems, {arguments.repetitions} repetitions of each, {POINTS} points, 1 % noise with lag-1 "
        f"correlation {arguments.lag:g}, thickness known to 5 %, area of the tip off by {100.0 * arguments.area_sd:g} %.",
        f"True E0 inside the 95 % interval: {100 * min(of_modulus):.1f} % to {100 * max(of_modulus):.1f} %, on average "
        f"{100 * np.mean(of_modulus):.1f} %; outside 91-99 %: {outside} of {len(rows)} systems.",
        f"True h inside: {100 * min(of_thickness):.1f} % to {100 * max(of_thickness):.1f} %, on average "
        f"{100 * np.mean(of_thickness):.1f} %; outside 91-99 %: {outside_h} of {len(rows)} systems.",
    ]
    text = "\n".join([*lines, "", *verdict])
    print(text)
    print(f"{len(rows) * arguments.repetitions / seconds:.0f} fits a second")
    if arguments.table:
        arguments.table.write_text(
            "# Coverage of the intervals of `mdrcontact.instruments.fit`\n\n"
            f"Made by `python benchmarks/fit_recovery.py {shlex.join(sys.argv[1:])}`.\n\n{text}\n",
            encoding="utf-8",
        )


if __name__ == "__main__":
    main()
