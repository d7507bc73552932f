# SPDX-License-Identifier: GPL-3.0-or-later
"""A boundary-element code for half-spaces made layered by one line: its Green's function becomes the compliance C(k) of the body.

A ball presses on a polymer layer of 0.3 mm that is bonded to a rigid base (ContactMechanics, periodic, 256 x 256 points, 4 mm).
The layer keeps the neighbours of the period apart, so that the force is that of one contact, which the library solves in one
dimension. Then two balls at once, 0.8 mm apart: the layer bulges around each, under the other, and both press on more.

Checks: the forces agree at two depths to 3e-4; what the second ball adds is the bulge times the contact stiffness, to first order.
Units mm and MPa. E = 1 GPa, nu = 0.3.
"""

import numpy as np
from ContactMechanics import PeriodicFFTElasticHalfSpace
from ContactMechanics.Factory import make_system
from SurfaceTopography import Topography

import mdrcontact as mdr

SIDE, POINTS, RADIUS = 4.0, 256, 1.0
LAYER = mdr.Layered([(mdr.Elastic(1000.0, 0.3), 0.3)], mdr.RIGID)


def layered(medium):
    """The code's substrate with the compliance of the body at the wavenumbers of its grid."""
    substrate = PeriodicFFTElasticHalfSpace((POINTS, POINTS), 1.0, (SIDE, SIDE))
    k = 2.0 * np.pi * np.fft.fftfreq(POINTS, SIDE / POINTS)
    k = np.hypot(*np.meshgrid(k[: POINTS // 2 + 1], k, indexing="ij"))
    k[0, 0] = 1e-6 * k[1, 0]  # the mean pressure compresses a layer on a rigid base
    substrate.greens_function = np.asfortranarray(medium.compliance(k))
    substrate.surface_stiffness = 1.0 / substrate.greens_function
    return substrate


def balls(*places):
    """Heights of paraboloids along x."""
    x = (np.arange(POINTS) - POINTS // 2) * SIDE / POINTS
    return np.max([-((x[:, None] - at) ** 2 + x**2) / (2.0 * RADIUS) for at in places], axis=0)


def press(surface, depth):
    """The force at a depth of the apexes."""
    topography = Topography(surface, (SIDE, SIDE))
    system = make_system(interaction="hardwall", substrate=layered(LAYER), surface=topography)
    system.minimize_proxy(offset=depth, pentol=1e-8)
    return system.compute_normal_force()


contact = mdr.Contact(mdr.Paraboloid(RADIUS), LAYER)
largest = 0.0
for depth in (0.05, 0.1):
    found, expected = press(balls(0.0), depth), contact.at_depth(depth).force
    largest = max(largest, abs(found / expected - 1.0))
    print(f"depth {depth} mm: F = {found:.4f} N by boundary elements, {expected:.4f} N in one dimension")
print(f"largest deviation {largest:.1e}")
assert largest < 3e-4
one = contact.at_depth(0.05)
bulge = -float(contact.at_depth(one.depth).displacement(0.8))
two = press(balls(-0.4, 0.4), one.depth) / (2.0 * one.force) - 1.0
expected = bulge * one.stiffness / one.force
print(f"two balls 0.8 mm apart: {100 * two:.2f} % more than twice the force of one, {100 * expected:.2f} % by the bulge")
assert abs(two - expected) < 0.25 * two
