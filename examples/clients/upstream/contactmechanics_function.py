# SPDX-License-Identifier: GPL-3.0-or-later
"""ContactMechanics: a compliance of one's own needs a private method.

Wanted: PeriodicFFTElasticHalfSpace(..., greens_function=callable(qx, qy)), called at the waves of the part of this process, k = 0
included.
"""

import ContactMechanics
import numpy as np


class Own(ContactMechanics.PeriodicFFTElasticHalfSpace):
    """The work that the argument would spare: waves, halved axis, parts of processes."""

    def _compute_greens_function(self):
        rows = zip(self.nb_grid_pts, self.fourier_locations, self.nb_fourier_grid_pts, self.physical_sizes, strict=True)
        axes = []
        for n, first, count, size in rows:
            index = np.arange(first, first + count)
            axes.append(2.0 * np.pi / size * np.minimum(index, n - index))
        return 1.0 / (1.0 + np.hypot(*np.meshgrid(*axes, indexing="ij")))


print(Own((8, 8), 1.0, (1.0, 1.0)).greens_function.shape)
