# SPDX-License-Identifier: GPL-3.0-or-later
"""tamaas: the operator of a domain without neighbours is wrong after E of the model is set, to an equal value also."""

import numpy as np
import tamaas as tm

tm.set_log_level(tm.LogLevel.error)
model = tm.Model(tm.model_type.basic_2d, [1.0, 1.0], [8, 8])
model.E, model.nu = 1.0, 0.0
tm.ModelFactory.registerNonPeriodic(model, "free")
force, before, after = np.zeros((3, 8, 8))
force[0, 0] = 1.0
model.operators["free"](force, before)
model.E = 1.0
model.operators["free"](force, after)
print(f"found: {before[0, 0]:.4f}, then {after[0, 0]:.4f}; expected: {before[0, 0]:.4f} twice")
