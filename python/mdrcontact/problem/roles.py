# SPDX-License-Identifier: GPL-3.0-or-later
"""What the columns of tables are: the dimension of each, and the names that instruments give it, in small letters."""

from __future__ import annotations

from collections.abc import Mapping

from .._units import AREA, FORCE, FREQUENCY, LENGTH, MODULUS, STIFFNESS, TIME, Dimension

ROLES: Mapping[str, tuple[Dimension, tuple[str, ...]]] = {
    "depth": (
        LENGTH,
        (
            *("depth", "d", "h", "displacement", "indentation", "indentation depth", "displacement into surface", "pd"),
            *("penetration depth", "penetration", "disp", "displ"),
        ),
    ),
    "force": (FORCE, ("force", "load", "f", "p", "load on sample", "fn", "normal force", "normal load")),
    "stiffness": (STIFFNESS, ("stiffness", "contact stiffness", "s", "k", "harmonic contact stiffness")),
    "radius": (LENGTH, ("radius", "contact radius", "a")),
    "area": (AREA, ("area", "contact area", "projected area", "projected contact area")),
    "modulus": (MODULUS, ("modulus", "effective modulus", "e_eff", "eeff", "er", "e_r", "reduced modulus")),
    "height": (LENGTH, ("height", "height (measured)", "height (piezo)", "piezo", "z", "zsensor")),
    "deflection": (LENGTH, ("deflection", "vdeflection", "vertical deflection", "defl")),
    "time": (TIME, ("time", "t", "time on sample", "elapsed time")),
    "omega": (FREQUENCY, ("omega", "angular frequency", "w", "frequency", "freq")),
    "storage": (STIFFNESS, ("storage", "storage stiffness", "dynamic stiffness", "k'", "k1")),
    "loss": (STIFFNESS, ("loss", "loss stiffness", "k''", "k2")),
}
