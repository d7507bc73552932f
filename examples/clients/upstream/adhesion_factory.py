# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesion: its import replaces `make_contact_system` of topographies, so that contacts without adhesion raise TypeError."""

import ContactMechanics
import numpy as np
from SurfaceTopography import Topography

topography = Topography(np.zeros((8, 8)), (1.0, 1.0))
substrate = ContactMechanics.FreeFFTElasticHalfSpace((8, 8), 1.0, (1.0, 1.0))
topography.make_contact_system(substrate=substrate)
import Adhesion.System  # noqa: E402, F401

try:
    topography.make_contact_system(substrate=substrate)
except TypeError as problem:
    print(f"found: {problem}; expected: the same system as before")
