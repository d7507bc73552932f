# SPDX-License-Identifier: GPL-3.0-or-later
"""tamaas: with an odd number of points n along the first axis the wave (n - 1)/2 is taken for (n + 1)/2."""

import numpy as np
import tamaas as tm

tm.set_log_level(tm.LogLevel.error)
model = tm.Model(tm.model_type.basic_2d, [1.0, 1.0], [7, 7])
model.E, model.nu = 1.0, 0.0
model.solveNeumann()
waves = 1.0 / (np.pi * np.array(model.operators["Westergaard::neumann"]["influence"]).real[1:, 0])
print(f"found: {np.round(waves, 6)}; expected: {np.abs(np.fft.fftfreq(7, 1 / 7))[1:]}")
