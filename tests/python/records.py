# SPDX-License-Identifier: GPL-3.0-or-later
"""Records of instruments, made up with known numbers in them."""

from __future__ import annotations

import numpy as np

import mdrcontact as mdr

HARDNESS, REDUCED, EPSILON, C0 = 9e9, 70e9, 0.75, 24.5


def sink_in(body, a):
    """(d - f(a)) k/F at the edge of a contact of a paraboloid with a body, from the contact itself: 0.75 on a half-space."""
    state = mdr.Contact(mdr.Paraboloid(1.0), body).at_radius(a)
    return (np.asarray(state.depth) - 0.5 * np.asarray(a) ** 2) * state.stiffness / np.asarray(state.force)


def indentation(
    force=10e-3, *, c1=0.0, frame=0.0, noise=2e-6, drift=0.0, creep=2e-9, power=1.4, seed=0, points=(300, 100, 200, 80, 20)
):
    """Loading, hold, unloading to 10 % of the force, hold and the rest, 0.1 s apart: time, depth, force, and what is true. Its
    unloading is P = B (h - h_f)^power with Oliver and Pharr's contact depth under a tip A = 24.5 h_c^2 + c1 h_c."""
    area = force / HARDNESS
    stiffness = 2.0 * np.sqrt(area / np.pi) * REDUCED
    contact_depth = (np.sqrt(c1**2 + 4.0 * C0 * area) - c1) / (2.0 * C0)
    deepest = contact_depth + EPSILON * force / stiffness
    final = deepest - power * force / stiffness

    def unloading(p):
        return final + (deepest - final) * (p / force) ** (1.0 / power)

    loads = [force * np.linspace(0.0, 1.0, points[0]), np.full(points[1], force), force * np.linspace(1.0, 0.1, points[2])]
    loads += [np.full(points[3], 0.1 * force), force * np.linspace(0.1, 0.0, points[4])]
    held = creep * np.log1p(10.0 * np.linspace(0.0, 1.0, points[1])) / np.log(11.0)
    depths = [(deepest - creep) * np.sqrt(loads[0] / force), deepest - creep + held, *map(unloading, loads[2:])]
    random = np.random.default_rng(seed)
    p, h = np.concatenate(loads), np.concatenate(depths)
    time = 0.1 * np.arange(len(p))
    h = h + frame * p + drift * time + 0.05e-9 * random.standard_normal(len(p))
    truth = {"stiffness": stiffness, "contact_depth": contact_depth, "area": area, "depth": deepest, "final_depth": final}
    return time, h, p + noise * random.standard_normal(len(p)), truth


def wandering(*, seed=11, sd=0.15e-9, servo=0.0, times=(5, 10, 5, 30, 1)):
    """Loading, hold, unloading to 10 %, thermal hold and the rest of a record at 200 Hz, whose depth wanders (first-order noise of
    0.3 s) and drifts by 50 pm/s, and whose force wanders by `servo`: time, depth, force."""
    random, rate, top, stiffness, deepest, power = np.random.default_rng(seed), 200.0, 1e-3, 60e3, 90e-9, 1.4
    counts = [int(rate * time) for time in times]
    levels = [(0.0, 1.0), (1.0, 1.0), (1.0, 0.1), (0.1, 0.1), (0.1, 0.0)]
    p = np.concatenate([top * np.linspace(a, b, n, endpoint=False) for (a, b), n in zip(levels, counts, strict=True)])
    creep = 2e-9 * (1.0 - np.exp(-np.arange(counts[1]) / rate / 3.0))
    final = deepest + creep[-1] - power * top / stiffness
    unloading = final + power * top / stiffness * (p[counts[0] + counts[1] :] / top) ** (1.0 / power)
    h = np.concatenate([deepest * np.sqrt(p[: counts[0]] / top), deepest + creep, unloading])

    def wander():
        decay = np.exp(-1.0 / rate / 0.3)
        steps = np.sqrt(1.0 - decay**2) * random.standard_normal(p.size)
        found = np.zeros(p.size)
        for i in range(1, p.size):
            found[i] = decay * found[i - 1] + steps[i]
        return found

    time = np.arange(p.size) / rate
    h = h + sd * wander() + 50e-12 * time
    if servo:
        moved = servo * wander()
        p, h = p + moved, h + moved / stiffness
    return time, h, p + 20e-9 * random.standard_normal(p.size)
