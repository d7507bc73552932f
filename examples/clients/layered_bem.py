# SPDX-License-Identifier: GPL-3.0-or-later
"""ContactMechanics on a layered body: two balls press side by side on a polymer layer on a rigid base.

The layer bulges around each ball, below the other one, so that both need more force than one ball alone. Checks: the force of one
ball agrees with the library to 3e-4; what the second ball adds is the bulge times the contact stiffness, to first order. Units mm
and MPa.
"""

import numpy as np
from SurfaceTopography import Topography

import mdrcontact as mdr
from mdrcontact.interop.contactmechanics import FreeLayeredSubstrate

SIZE, POINTS, RADIUS, DEPTH = 1.6, 160, 1.0, 0.05
LAYER = mdr.Layered([(mdr.Elastic(1000.0, 0.3), 0.3)], mdr.RIGID)


def press(*places):
    """Force on balls at places along x."""
    x = (np.arange(POINTS) - POINTS // 2) * SIZE / POINTS
    heights = np.max([-((x[:, None] - at) ** 2 + x**2) / (2.0 * RADIUS) for at in places], axis=0)
    topography = Topography(heights, (SIZE, SIZE))
    substrate = FreeLayeredSubstrate(LAYER, (POINTS, POINTS), SIZE)
    system = topography.make_contact_system(substrate=substrate)
    system.minimize_proxy(offset=DEPTH, initial_forces=substrate.first_guess(topography, DEPTH), pentol=1e-8)
    return system.compute_normal_force()


one = mdr.Contact(mdr.Paraboloid(RADIUS), LAYER).at_depth(DEPTH)
found = press(0.0)
print(f"F = {found:.4f} N by boundary elements, {one.force:.4f} N in one dimension")
print(f"largest deviation {abs(found / one.force - 1.0):.1e}")
assert abs(found / one.force - 1.0) < 3e-4
two = press(-0.4, 0.4) / (2.0 * one.force) - 1.0
expected = -float(one.displacement(0.8)) * one.stiffness / one.force
print(f"two balls 0.8 mm apart: {100 * two:.2f} % more than twice the force of one, {100 * expected:.2f} % by the bulge")
assert abs(two - expected) < 0.25 * two
