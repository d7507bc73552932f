# SPDX-License-Identifier: GPL-3.0-or-later
"""The quantities of columns of tables, and their names in files of instruments, in lower case."""

from __future__ import annotations

from collections.abc import Mapping

from .._units import QUANTITIES, Dimension

_NAMES: Mapping[str, tuple[str, ...]] = {
    "depth": (
        *("depth", "d", "h", "displacement", "indentation", "indentation depth", "displacement into surface", "pd"),
        *("penetration depth", "penetration", "disp", "displ", "indent depth"),
        *("eindringtiefe", "tiefe", "eindringweg", "weg", "profondeur", "enfoncement", "profundidad", "profondit\xe0"),
    ),
    "force": (
        *("force", "load", "f", "p", "load on sample", "fn", "normal force", "normal load", "indent load", "standard force"),
        *("kraft", "pr\xfcfkraft", "standardkraft", "last", "charge", "fuerza", "carga", "forza", "carico"),
    ),
    "stiffness": ("stiffness", "contact stiffness", "s", "k", "harmonic contact stiffness", "steifigkeit", "kontaktsteifigkeit"),
    "radius": ("radius", "contact radius", "a"),
    "area": ("area", "contact area", "projected area", "projected contact area"),
    "modulus": ("modulus", "effective modulus", "e_eff", "eeff", "er", "e_r", "reduced modulus"),
    "height": (
        *("height", "height (measured)", "height (piezo)", "height (measured & smoothed)", "piezo", "z", "zsensor", "z sensor"),
        *("head height", "head height (measured)", "head height (measured & smoothed)", "height sensor", "ramp"),
    ),
    "deflection": ("deflection", "vdeflection", "vertical deflection", "defl"),
    "time": ("time", "t", "time on sample", "elapsed time", "series time", "zeit", "pr\xfcfzeit", "temps", "tiempo", "tempo"),
    "omega": ("omega", "angular frequency", "w", "frequency", "freq"),
    "storage": ("storage", "storage stiffness", "dynamic stiffness", "k'", "k1"),
    "loss": ("loss", "loss stiffness", "k''", "k2"),
}
ROLES: Mapping[str, tuple[Dimension, tuple[str, ...]]] = {role: (QUANTITIES[role], names) for role, names in _NAMES.items()}
"""Dimension and names."""
