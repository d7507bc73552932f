# SPDX-License-Identifier: GPL-3.0-or-later
"""tamaas on a layered body: a ball presses on a polymer layer on a rigid base.

Checks: the depth under a force agrees with the library to 3e-4, the contact radius to a pixel. Units mm and MPa.
"""

import numpy as np
import tamaas as tm

import mdrcontact as mdr
from mdrcontact.interop.tamaas import layered_operator

SIZE, POINTS, RADIUS = 1.2, 128, 1.0
LAYER = mdr.Layered([(mdr.Elastic(1000.0, 0.3), 0.3)], mdr.RIGID)
tm.set_log_level(tm.LogLevel.error)

x = (np.arange(POINTS) - POINTS // 2) * SIZE / POINTS
ball = -(x[:, None] ** 2 + x**2) / (2.0 * RADIUS)
state = mdr.Contact(mdr.Paraboloid(RADIUS), LAYER).at_depth(0.05)

model = tm.Model(tm.model_type.basic_2d, [SIZE, SIZE], [POINTS, POINTS])
operator = layered_operator(model, LAYER)
solver = tm.PolonskyKeerRey(model, ball, 1e-10)
solver.setIntegralOperator("layered")
solver.solve(state.force / SIZE**2)

displacement = np.zeros_like(ball)
operator(np.array(model.traction), displacement)
touching = np.array(model.traction) > 0.0
depth, radius = float(np.mean((displacement - ball)[touching])), np.sqrt(np.count_nonzero(touching) / np.pi) * SIZE / POINTS
print(f"by tamaas d = {depth:.6f}, a = {radius:.3f} mm; in one dimension {state.depth:.6f}, {state.radius:.3f}")
print(f"largest deviation {abs(depth / state.depth - 1.0):.1e}")
assert abs(depth / state.depth - 1.0) < 3e-4 and abs(radius - state.radius) < SIZE / POINTS
