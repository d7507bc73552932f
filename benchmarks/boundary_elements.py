# SPDX-License-Identifier: GPL-3.0-or-later
"""Hertz's contact by boundary-element codes: python boundary_elements.py CODE POINTS prints seconds and relative error of F(d)."""

import sys
import time

import numpy as np

MODULUS, RADIUS, DEPTH = 1.0, 1.0, 0.01
FORCE = 4.0 / 3.0 * MODULUS * np.sqrt(RADIUS) * DEPTH**1.5
SIDE = 4.0 * np.sqrt(RADIUS * DEPTH)


def tamaas(points: int) -> tuple[float, float]:
    """Polonsky and Keer's conjugate gradients at given force, non-periodic; the depth's error times 3/2 is the force's."""
    import tamaas as tm

    tm.set_log_level(tm.LogLevel.error)
    start = time.perf_counter()
    model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [SIDE, SIDE], [points, points])
    model.E, model.nu = MODULUS, 0.0
    tm.ModelFactory.registerNonPeriodic(model, "dcfft")
    x = (np.arange(points) + 0.5) * SIDE / points - SIDE / 2
    surface = -(x[:, None] ** 2 + x[None, :] ** 2) / (2 * RADIUS)
    solver = tm.PolonskyKeerRey(model, surface, 1e-6)
    solver.setIntegralOperator("dcfft")
    solver.solve(FORCE / SIDE**2)
    displacement = np.zeros((points, points))
    model.operators["dcfft"](model.traction, displacement)
    seconds = time.perf_counter() - start
    depth = (displacement - surface)[model.traction > 0].mean()
    return seconds, 1.5 * abs(depth / DEPTH - 1)


def contactmechanics(points: int) -> tuple[float, float]:
    """Constrained conjugate gradients at given depth, non-periodic."""
    from ContactMechanics import FreeFFTElasticHalfSpace
    from ContactMechanics.Factory import make_system
    from SurfaceTopography import make_sphere

    start = time.perf_counter()
    substrate = FreeFFTElasticHalfSpace((points, points), MODULUS, (SIDE, SIDE))
    surface = make_sphere(RADIUS, (points, points), (SIDE, SIDE), kind="paraboloid")
    system = make_system(interaction="hardwall", substrate=substrate, surface=surface)
    system.minimize_proxy(offset=DEPTH, pentol=1e-8)
    force = system.compute_normal_force()
    return time.perf_counter() - start, abs(force / FORCE - 1)


if __name__ == "__main__":
    print(*{"tamaas": tamaas, "ContactMechanics": contactmechanics}[sys.argv[1]](int(sys.argv[2])))
