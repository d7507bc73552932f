# SPDX-License-Identifier: GPL-3.0-or-later
"""ContactMechanics: the constrained conjugate gradients do not leave a stationary first guess.

The displacements of the first guess are the overlap, which leaves no gap inside the contact: the gradient there is 0, and no step
is taken although the penetration is constant. Initial forces that are proportional to the overlap converge.
"""

import ContactMechanics
import numpy as np
from SurfaceTopography import Topography

POINTS, SIZE = 32, 2.6


class Stiff(ContactMechanics.PeriodicFFTElasticHalfSpace):
    """A stiff film on a soft base in a few words: short waves see a modulus of 10, long ones of 1."""

    def _compute_greens_function(self):
        own = super()._compute_greens_function()
        k = 2.0 / (self.contact_modulus * np.where(own == 0.0, 1.0, own))
        return own * (0.1 + 0.9 * np.exp(-2.0 * k))


x = (np.arange(POINTS) - 0.5 * (POINTS - 1)) * SIZE / POINTS
topography = Topography(-0.5 * (x[:, None] ** 2 + x**2), (SIZE, SIZE), periodic=True)
substrate = Stiff((POINTS, POINTS), 1.0, (SIZE, SIZE))
system = topography.make_contact_system(substrate=substrate)
result = system.minimize_proxy(offset=1.45, maxiter=500)
print(f"found: {result.message} (iterations {result.nit}, success {result.success})")
result = system.minimize_proxy(offset=1.45, initial_forces=-np.maximum(topography.heights() + 1.45, 0.0), maxiter=500)
print(f"expected, with initial forces: {result.message} (iterations {result.nit}, success {result.success})")
