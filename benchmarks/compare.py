# SPDX-License-Identifier: GPL-3.0-or-later
"""Everything side by side in one run: python compare.py LAW_COST_PROGRAM FOLDER writes benchmarks.md and benchmarks.png there."""

import os
import platform
import subprocess
import sys
import time
from pathlib import Path

import batches
import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq

import mdrcontact as mdr

LIMIT = 60  # seconds that a boundary-element run may take
HERTZ = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.0)))


LAW_COSTS = {
    "inline": "compiled law, F inline (mdrcontact_law.h)",
    "inline_open": "the same, bodies that are apart",
    "inline_first_touch": "the same, the first bit of depth, below the compiled range: F and dF/dd by one root",
    "inline_with_slope": "F and dF/dd inline",
    "inline_with_slope_dependent": "the same, each call waiting for the last (latency)",
    "many_laws_with_slope": "the same, of 1000 laws at random",
    "scalar": "F, function of the library",
    "scalar_with_slope": "F and dF/dd, function of the library",
    "scalar_with_slope_dependent": "the same, each call waiting for the last (latency)",
    "state": "d, F, dF/dd, a, k and U of one state",
    "batch": "a point of an array, F",
    "batch_with_slope": "a point of an array, F and dF/dd",
    "batch_all": "a point of an array, F, dF/dd, a and k",
    "batch_plain": "a point of an array without AVX2, F",
    "batch_plain_with_slope": "a point of an array without AVX2, F and dF/dd",
    "batch_plain_all": "a point of an array without AVX2, F, dF/dd, a and k",
    "batch_of_one_with_slope": "an array of one point, F and dF/dd",
    "friction_step": "one step of a contact with friction by 8 sliders, T (mdr_law_advance)",
    "friction_step_with_tangent": "the same, with its derivatives",
    "friction_usual_rule": "k_t of the law times the increment, rescaled while F falls, cut off at mu F",
}


def seconds_each(function, least=0.2):
    """Seconds a call takes: the best of five rounds of at least `least` seconds together."""
    count = 1
    while True:
        start = time.perf_counter()
        for _ in range(count):
            function()
        spent = time.perf_counter() - start
        if spent > least / 5:
            break
        count *= 4
    best = spent / count
    for _ in range(4):
        start = time.perf_counter()
        for _ in range(count):
            function()
        best = min(best, (time.perf_counter() - start) / count)
    return best


def machine():
    """Processor and cores, as the system names them."""
    name = platform.machine()
    if Path("/proc/cpuinfo").exists():
        lines = [line for line in Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("model name")]
        name = lines[0].split(":")[1].strip() if lines else name
    return f"{name}, {os.cpu_count()} cores, {platform.system()}, Python {platform.python_version()}"


def law_rows(program):
    """What law_cost measures."""
    output = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    return {name: float(value) for name, value in (line.split() for line in output.splitlines())}


def scipy_force(depth):
    """The paper's rule for an incompressible coated paraboloid as one would write it with SciPy: a root, then a quadrature."""
    E0, E1, h, R = 4.0 * 3.0, 4.0, 1.0, 1.0
    a = brentq(lambda s: s * s / R - depth, 0.0, 100.0)

    def modulus(s):
        xi = h / s
        weight = 2 / np.pi * np.arctan(xi) + (0.0 - xi / (1 + xi**2)) / np.pi
        return E1 + (E0 - E1) * weight

    return quad(lambda s: 4 * s * s * modulus(s) / R, 0.0, a, epsrel=1e-10)[0]


def boundary_elements():
    """(code, points, seconds, error); None where a code does not run."""
    rows = []
    for code, sizes in (("tamaas", (64, 128, 256, 512)), ("ContactMechanics", (32, 64))):
        for points in sizes:
            command = [sys.executable, str(Path(__file__).with_name("boundary_elements.py")), code, str(points)]
            try:
                one_core = {**os.environ, "OMP_NUM_THREADS": "1"}
                run = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT, env=one_core)
                found = [float(part) for part in run.stdout.split()] if run.returncode == 0 else [None, None]
            except subprocess.TimeoutExpired:
                found = [None, None]
            rows.append((code, points, *found))
    return rows


def exact_scaling():
    """Seconds of one exact contact state over a/h, and over the number of layers."""
    radius_rows, layer_rows = [], []
    film = mdr.Coated(mdr.Elastic(2.0, 0.3), 1.0, mdr.Elastic(1.0, 0.3), "exact")
    contact = mdr.Contact(mdr.Paraboloid(1.0), film)
    for a in (0.1, 1.0, 10.0, 100.0):
        radius_rows.append((a, seconds_each(lambda a=a: contact.at_radius(a))))
    for count in (1, 2, 4, 8, 16):
        layers = [(mdr.Elastic(2.0 + i % 2, 0.3), 1.0 / count) for i in range(count)]
        stack = mdr.Layered(layers, mdr.Elastic(1.0, 0.3), "exact")
        made = seconds_each(lambda layers=layers: mdr.Layered(layers, mdr.Elastic(1.0, 0.3), "exact"))
        contact_of_stack = mdr.Contact(mdr.Paraboloid(1.0), stack)
        layer_rows.append((count, made, seconds_each(lambda c=contact_of_stack: c.at_radius(1.0))))
    return radius_rows, layer_rows


def exact_curve():
    """Seconds of a curve F(d) of 200 points on an exact film, up to a = h: from radii, by a law made for it, from depths."""
    contact = mdr.Contact(mdr.Paraboloid(50.0), mdr.Coated(mdr.Elastic(2.0, 0.3), 1.0, mdr.Elastic(1.0, 0.3), "exact"))
    radius = np.linspace(0.005, 1.0, 200)
    depth = np.linspace(1.0, 200.0, 200) * float(contact.at_radius(1.0).depth) / 200.0

    def by_law():
        mdr.ContactLaw(contact, depth[-1], smallest_depth=depth[0]).force(depth)

    return [
        ("200 contact radii", seconds_each(lambda: contact.at_radius(radius))),
        ("a law made for the curve, 200 depths", seconds_each(by_law)),
        ("200 depths, one by one", seconds_each(lambda: contact.at_depth(depth))),
    ]


def batch_scaling():
    """Nanoseconds of a point of a law in Python, over the number of points and of threads."""
    law = mdr.ContactLaw(HERTZ, 1.0)
    rows = []
    for points in (1, 10, 100, 1000, 10_000, 100_000, 1_000_000):
        depth = np.geomspace(1e-4, 1.0, points) if points > 1 else np.array([0.5])
        row = [points]
        for threads in (1, 2):
            mdr.set_threads(threads)
            row.append(1e9 * seconds_each(lambda d=depth: law.force(d)) / points)
        mdr.set_threads(1)
        rows.append(row)
    return rows


def picture(path, elements, hertz, radius_rows, points_rows):
    """Error over time for Hertz's contact; time over a/h; time over points."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 3, figsize=(12, 3.6), layout="constrained")
    for code in dict.fromkeys(row[0] for row in elements):
        found = [row for row in elements if row[0] == code and row[2]]
        axes[0].loglog([row[2] for row in found], [row[3] for row in found], "o-", label=code)
    for name, seconds, error in hertz:
        axes[0].loglog([seconds], [max(error, 1e-16)], "s", label=name)
    axes[0].set(xlabel="seconds for one F(d)", ylabel="relative error", title="Hertz's contact")
    axes[0].legend(fontsize=8)
    axes[1].loglog(*zip(*radius_rows, strict=True), "o-")
    axes[1].set(xlabel="a/h", ylabel="seconds", title="One exact state of a film")
    for column, label in ((1, "1 thread"), (2, "2 threads")):
        axes[2].loglog([row[0] for row in points_rows], [row[column] for row in points_rows], "o-", label=label)
    axes[2].set(xlabel="points in a call from Python", ylabel="ns per point", title="Compiled law")
    axes[2].legend(fontsize=8)
    figure.savefig(path, dpi=120)


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    cost = law_rows(program)
    depth, exact = 0.01, 4.0 / 3.0 * 0.01**1.5
    law = mdr.ContactLaw(HERTZ, 0.1)
    hertz = [
        ("contact, from Python", seconds_each(lambda: HERTZ.at_depth(depth)), abs(HERTZ.at_depth(depth).force / exact - 1)),
        ("compiled law, from Python", seconds_each(lambda: law.force(depth)), abs(law.force(depth) / exact - 1)),
    ]
    hertz.append(("compiled law, in C", 1e-9 * cost["scalar_ratio"] * cost["atan_plus_log_ns"], hertz[1][2]))
    coated = mdr.Contact(mdr.Paraboloid(1.0), mdr.Coated(mdr.Elastic(9.0, 0.5), 1.0, mdr.Elastic(3.0, 0.5), "gao"))
    curve = np.linspace(0.01, 4.0, 200)
    direct = seconds_each(lambda: coated.at_depth(curve)) / curve.size
    straightforward = seconds_each(lambda: [scipy_force(d) for d in curve[::20]]) / 10
    agreement = max(abs(scipy_force(d) / coated.at_depth(d).force - 1) for d in curve[::20])
    coated_law, many = mdr.ContactLaw(coated, 4.0), np.linspace(0.01, 4.0, 1000)
    compiled = seconds_each(lambda: coated_law.force(many)) / many.size
    elements = boundary_elements()
    radius_rows, layer_rows = exact_scaling()
    points_rows = batch_scaling()
    curve_rows = exact_curve()
    solve_128 = next((row[2] for row in elements if row[:2] == ("tamaas", 128)), None)

    text = [
        "# Benchmarks",
        "",
        "Made by `benchmarks/run.sh`, all in one run.",
        "",
    ]
    text += [f"Machine: {machine()}.", "", "## One force", ""]
    text += ["| what | cost in units of one libm atan + one log |", "|---|---|"]
    text += [f"| atan + log | 1 ({cost['atan_plus_log_ns']:.1f} ns) |"]
    text += [f"| {words} | {cost[f'{name}_ratio']:.2f} |" for name, words in LAW_COSTS.items()]
    text += [f"| contact with the paper's weights, from depth | {cost['direct_solve_ratio']:.0f} |"]
    text += [f"| contact, exact film, from depth | {cost['exact_solve_ratio']:.0f} |", ""]
    text += [f"Law of an exact film over four decades of depth: {cost['exact_solutions']:.0f} exact solutions,"]
    text += [f"{1e3 * cost['build_seconds']:.2g} ms; error found on verification {cost['verified_error']:.0e}."]
    text += [f"Error at a million random depths against the closed form (24): {cost['error_at_1e6_random_depths']:.0e}."]
    text += [f"Two threads against one: {cost['two_threads_speedup']:.2f} times the throughput.", "", "## Hertz's F(d)", ""]
    text += ["| code | grid | seconds | relative error |", "|---|---|---|---|"]
    text += [f"| mdrcontact, {name} | - | {seconds:.1e} | {error:.0e} |" for name, seconds, error in hertz]
    for code, points, seconds, error in elements:
        found = f"{seconds:.2f} | {error:.1e}" if seconds else f"no result within {LIMIT} s, or not installed | -"
        text += [f"| {code} | {points} x {points} | {found} |"]
    if not aspher_runs():
        text += ["", "aspher is not compared: its package did not install on this machine."]
    text += ["", "## A curve F(d) of an exact film, 200 points up to a = h", ""]
    text += ["| from | seconds | in units of one 128 x 128 solve of tamaas for a homogeneous body |", "|---|---|---|"]
    for name, seconds in curve_rows:
        text += [f"| {name} | {seconds:.1e} | {seconds / solve_128:.3f} |" if solve_128 else f"| {name} | {seconds:.1e} | - |"]
    text += ["", "## Against SciPy", ""]
    text += ["The paper's rule for a coated paraboloid, as brentq and quad with relative tolerance 1e-10, takes"]
    text += [f"{1e6 * straightforward:.0f} us a force; the contact of this library {direct / straightforward:.2f} times that,"]
    text += [f"its compiled law {compiled / straightforward:.1e} times that. SciPy and contact agree to {agreement:.0e}."]
    text += ["", "## Scaling", "", "| a/h | seconds, exact state |", "|---|---|"]
    text += [f"| {a:g} | {seconds:.1e} |" for a, seconds in radius_rows]
    text += ["", "| layers | seconds to make the medium | seconds, exact state at a/h = 1 |", "|---|---|---|"]
    text += [f"| {count} | {made:.1e} | {seconds:.1e} |" for count, made, seconds in layer_rows]
    text += ["", "| points in a call from Python | ns a point, 1 thread | 2 threads |", "|---|---|---|"]
    text += [f"| {points} | {one:.1f} | {two:.1f} |" for points, one, two in points_rows]
    text += ["", "## Arrays", ""]
    text += ["What a point of an array costs, and what a second thread gains. Results are the same to the last bit.", ""]
    text += batches.table()
    text += [""]
    (folder / "benchmarks.md").write_text("\n".join(text))
    picture(folder / "benchmarks.png", elements, hertz, radius_rows, points_rows)


def aspher_runs():
    """Whether aspher can be imported."""
    return subprocess.run([sys.executable, "-c", "import aspher"], capture_output=True).returncode == 0


if __name__ == "__main__":
    main()
