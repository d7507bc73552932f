# SPDX-License-Identifier: GPL-3.0-or-later
"""tamaas: PolonskyKeerRey registers its operator again, without a warning, and so undoes a change of its influence."""

import numpy as np
import tamaas as tm

tm.set_log_level(tm.LogLevel.error)
model = tm.Model(tm.model_type.basic_2d, [1.0, 1.0], [8, 8])
model.E, model.nu = 1.0, 0.3
tm.PolonskyKeerRey(model, np.zeros((8, 8)), 1e-12)
model.operators["westergaard_neumann"]["influence"][...] = 7.0
tm.PolonskyKeerRey(model, np.zeros((8, 8)), 1e-12)
print(f"found: {model.operators['westergaard_neumann']['influence'][1, 1].real:.4f}; expected: 7")
