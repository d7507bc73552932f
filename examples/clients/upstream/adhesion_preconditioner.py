# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesion: the preconditioner of the Fourier solvers takes contact_modulus instead of surface_stiffness.

It is |q| E*/2 of a half-space; a substrate has its own stiffness at each wave in surface_stiffness.
"""

import inspect

from Adhesion.System import Systems

source = inspect.getsource(Systems)
print("found:", next(line.strip() for line in source.splitlines() if "contact_modulus" in line))
print("expected: the array surface_stiffness of the substrate")
