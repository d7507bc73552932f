# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers that others have printed, to the digits that they give, and whose error the difference is."""

from __future__ import annotations

import numpy as np

from ..contact import Contact
from ..material import RIGID, Elastic
from ..medium import Coated, Homogeneous
from ..poroelastic import Poroelastic
from ..profile import FlatPunch
from .check import Check, Comparison, comparison

_HAYES = {1.0: 3.609, 2.0: 9.069}
"""k (1 - nu)/(4 G a) of a flat punch on an incompressible layer that is bonded to a rigid base, by a/h."""


def hayes() -> Comparison:
    """The table by which cartilage is reduced, at nu = 1/2."""
    a = np.array(list(_HAYES))
    layer = Coated(Elastic(3.0, 0.5), 1.0, RIGID)
    return comparison("a/h", a, np.asarray(layer.stiffness(a)) * 0.5 / (4.0 * a), list(_HAYES.values()))


def lai_hu() -> Comparison:
    """The part of the force that relaxes, on a drained half-space under an impermeable flat punch, nu = 0."""
    tau = np.geomspace(1e-3, 10.0, 33)
    contact = Contact(FlatPunch(1.0), Homogeneous(Poroelastic(1.0, 0.0, 1.0)))
    root = tau**0.25
    there = 0.242 * np.exp(-3.13 * tau) + 0.536 * np.exp(-1.71 * root**2)
    there += -0.043 * np.exp(-12.8 * np.cbrt(tau)) + 0.266 * np.exp(-0.892 * root)
    # F_0 = 8 G a d, F_inf = F_0/(2 (1 - nu))
    here = (np.asarray(contact.relaxation(tau, drainage="indenter")) - 4.0) / 4.0
    return comparison("D t/a^2", tau, here, there, 1.0)


PUBLISHED = (
    Check("hayes", "flat punch on a bonded layer", "Hayes, Keer, Herrmann, Mockros 1972, table", 1e-2,
          "the table's: 0.3 and 0.9 % low, finite elements agree with the library to 0.006 %", hayes),
    Check("lai-hu", "poroelastic gel under a flat punch", "Lai, Hu 2017, fit of finite elements", 2e-3,
          "the fit's: four terms", lai_hu),
)  # fmt: skip
