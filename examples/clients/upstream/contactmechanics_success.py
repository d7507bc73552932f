# SPDX-License-Identifier: GPL-3.0-or-later
"""ContactMechanics: success after one iteration with depth 0 where a uniform pressure displaces nothing.

The first guess under a given force is a uniform pressure. If C(0) is about 0, as of an almost incompressible bonded layer, the
displacement by it does not change in the first iteration, which counts as convergence.
"""

import ContactMechanics
import numpy as np
from SurfaceTopography import Topography

POINTS, SIZE = 64, 8.0
x = (np.arange(POINTS) - POINTS // 2) * SIZE / POINTS
topography = Topography(-0.5 * (x[:, None] ** 2 + x**2), (SIZE, SIZE), periodic=True)
of_layer = {"thickness": 1.0, "poisson": 0.49999}
substrate = ContactMechanics.PeriodicFFTElasticHalfSpace((POINTS, POINTS), 1.0, (SIZE, SIZE), **of_layer)
system = topography.make_contact_system(substrate=substrate)
result = system.minimize_proxy(external_force=1.0)
print(
    f"found: success {result.success} after {result.nit} iteration, offset {result.offset}, spread of forces {np.ptp(result.jac)}"
)
guess = -np.maximum(topography.heights() + 0.1, 0.0)
result = system.minimize_proxy(external_force=1.0, initial_forces=guess)
print(f"expected, with initial forces: offset {result.offset:.4f} after {result.nit} iterations")
