# SPDX-License-Identifier: GPL-3.0-or-later
"""tamaas, a boundary-element code for half-spaces, made layered by one line: its influence becomes the compliance C(k) of the body.

A ball presses on a polymer layer of 0.3 mm that is bonded to a rigid base (periodic, 256 x 256 points, 4 mm). The layer keeps the
neighbours of the period apart, so that the depth is that of one contact, which the library solves in one dimension.

Checks: on a half-space the compliance is the code's own influence; on the layer the depths agree at two forces to 3e-4, and so do
the contact radii to a point of the grid. Units mm and MPa. E = 1 GPa, nu = 0.3.
"""

import numpy as np
import tamaas as tm

import mdrcontact as mdr

SIDE, POINTS, RADIUS = 4.0, 256, 1.0
POLYMER = mdr.Elastic(1000.0, 0.3)
LAYER = mdr.Layered([(POLYMER, 0.3)], mdr.RIGID)
tm.set_log_level(tm.LogLevel.error)


def wavenumbers():
    """Of the grid; the mean pressure, k = 0, compresses a layer on a rigid base as a very long wave does."""
    k = 2.0 * np.pi * np.fft.fftfreq(POINTS, SIDE / POINTS)
    k = np.hypot(k[:, None], k[None, : POINTS // 2 + 1])
    k[0, 0] = 1e-6 * k[0, 1]
    return k


def solver_of(medium):
    """The code's solver for a ball, with the compliance of a body."""
    model = tm.ModelFactory.createModel(tm.model_type.basic_2d, [SIDE, SIDE], [POINTS, POINTS])
    model.E, model.nu = POLYMER.E, POLYMER.nu
    x = (np.arange(POINTS) - POINTS // 2) * SIDE / POINTS
    ball = -(x[:, None] ** 2 + x**2) / (2.0 * RADIUS)
    solver = tm.PolonskyKeerRey(model, ball, 1e-12)
    influence = model.operators["westergaard_neumann"]["influence"]
    if medium is not None:
        influence[...] = medium.compliance(wavenumbers())
    return model, solver, influence, ball


own = solver_of(None)[2]
half_space = mdr.Homogeneous(POLYMER).compliance(wavenumbers())
largest = np.max(np.abs(own.real / half_space - 1.0).ravel()[1:])
print(f"half-space: the influence of the code and the compliance differ by {largest:.1e}")
assert largest < 1e-12

contact = mdr.Contact(mdr.Paraboloid(RADIUS), LAYER)
largest = 0.0
for depth in (0.05, 0.1):
    state = contact.at_depth(depth)
    model, solver, influence, ball = solver_of(LAYER)
    solver.solve(state.force / SIDE**2)
    displacement = np.fft.irfft2(influence.reshape(half_space.shape) * np.fft.rfft2(model.traction), s=ball.shape)
    touching = model.traction > 0.0
    found = float(np.mean((displacement - ball)[touching]))
    radius = np.sqrt(np.count_nonzero(touching) / np.pi) * SIDE / POINTS
    largest = max(largest, abs(found / depth - 1.0))
    print(f"F = {state.force:.4f} N: d = {found:.6f}, a = {radius:.3f} mm by tamaas; {depth}, {state.radius:.3f} in one dimension")
    assert abs(radius - state.radius) < SIDE / POINTS
print(f"largest deviation {largest:.1e}")
assert largest < 3e-4
