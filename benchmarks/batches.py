# SPDX-License-Identifier: GPL-3.0-or-later
"""What a point of an array costs, and what two threads gain, for each kind of function: python batches.py prints a table.

As a module it gives the rows to compare.py."""

import time

import numpy as np

import mdrcontact as mdr
from mdrcontact.lateral import Ball, Shapes, density


def seconds(function, rounds=5, least=0.05):
    """Seconds a call takes: the best of some rounds of at least `least` seconds."""
    function()
    start = time.perf_counter()
    function()
    count = max(1, int(least / max(time.perf_counter() - start, 1e-9)))
    best = float("inf")
    for _ in range(rounds):
        start = time.perf_counter()
        for _ in range(count):
            function()
        best = min(best, (time.perf_counter() - start) / count)
    return best


def cases():
    """(what, points, function)."""
    coating, substrate = mdr.Elastic(2.0, 0.3), mdr.Elastic(1.0, 0.3)
    ball = mdr.Paraboloid(50.0)
    gao, exact = (mdr.Coated(coating, 1.0, substrate, model) for model in ("gao", "exact"))
    on_gao, on_exact, on_half_space = (mdr.Contact(ball, m) for m in (gao, exact, mdr.Homogeneous(substrate)))
    sticky = mdr.Contact(ball, gao, work_of_adhesion=1e-4)
    inclusion = Shapes(substrate, [Ball((0.0, 0.0, 1.0), 0.5, coating)])
    many, some, few = np.geomspace(1e-3, 1e3, 1_000_000), np.linspace(0.01, 1.0, 200), np.linspace(0.1, 2.0, 8)
    r = np.linspace(0.0, 0.99, 1000)
    depth, force = on_exact.at_radius(some).depth, on_exact.at_radius(some).force
    wide = np.linspace(0.5, 100.0, 40)
    wide_depth = on_exact.at_radius(wide).depth
    half_space_force = on_half_space.at_depth(many).force
    return [
        ("g of a paraboloid", many.size, lambda: ball.mdr(many)),
        ("weight I0", many.size, lambda: mdr.weights.weight_i0(many, 0.3)),
        ("closed form (24)", many.size, lambda: mdr.closed_forms.coated_paraboloid_force(many, 1.0, 3.0, 1.0, 0.5)),
        ("weights of a point, lateral", many.size, lambda: density(many, many, 0.3)),
        ("E_eff, Gao's weights", many.size, lambda: gao.modulus(many)),
        ("E_eff, exact film, a up to h", some.size, lambda: exact.modulus(some)),
        ("half-space, from depth", many.size, lambda: on_half_space.at_depth(many)),
        ("half-space, from force", many.size, lambda: on_half_space.at_force(half_space_force)),
        ("Gao film, from depth", some.size, lambda: on_gao.at_depth(depth)),
        ("Gao film, from force", some.size, lambda: on_gao.at_force(force)),
        ("Gao film with adhesion, from force", some.size, lambda: sticky.at_force(force)),
        ("exact film, a up to h, from radius", some.size, lambda: on_exact.at_radius(some)),
        ("exact film, a up to h, from depth", some.size, lambda: on_exact.at_depth(depth)),
        ("exact film, a up to h, from force", some.size, lambda: on_exact.at_force(force)),
        ("exact film, 2 depths", 2, lambda: on_exact.at_depth(depth[-2:])),
        ("exact film, a up to 100 h, from depth", wide.size, lambda: on_exact.at_depth(wide_depth)),
        ("pressure, Gao film", r.size, lambda: on_gao.at_radius(1.0).pressure(r)),
        ("pressure, exact film", r.size, lambda: on_exact.at_radius(1.0).pressure(r)),
        ("displacement, exact film", r.size, lambda: on_exact.at_radius(1.0).displacement(2.0 * r)),
        ("E_eff beside an inclusion", few.size, lambda: inclusion.modulus(few, 0.0, 1.0)),
    ]


def rows():
    """(what, points, nanoseconds a point on one thread, throughput of two threads against one)."""
    found = []
    for name, points, call in cases():
        taken = []
        for threads in (1, 2):
            mdr.set_threads(threads)
            taken.append(seconds(call))
        alone, shared = taken
        found.append((name, points, 1e9 * alone / points, alone / shared))
    return found


def table():
    """The rows as lines of Markdown."""
    lines = ["| what | points in a call from Python | a point, one thread | throughput of two threads |", "|---|---|---|---|"]
    for name, points, cost, gain in rows():
        text = f"{cost:.1f} ns" if cost < 1e3 else f"{1e-3 * cost:.1f} us" if cost < 1e6 else f"{1e-6 * cost:.1f} ms"
        lines.append(f"| {name} | {points} | {text} | {gain:.2f} |")
    return lines


if __name__ == "__main__":
    print("\n".join(table()))
