# SPDX-License-Identifier: GPL-3.0-or-later
"""The quantities of columns of tables, and their names in files of instruments, in lower case."""

from __future__ import annotations

from collections.abc import Mapping

from .._units import QUANTITIES, Dimension

# English, German, French, Spanish, Italian, and by their numbers Japanese and Chinese
_NAMES: Mapping[str, tuple[str, ...]] = {
    "depth": (
        *("depth", "d", "h", "displacement", "indentation", "indentation depth", "displacement into surface", "pd"),
        *("penetration depth", "penetration", "disp", "displ", "indent depth"),
        *("eindringtiefe", "tiefe", "eindringweg", "weg", "profondeur", "enfoncement", "profundidad", "profondit\xe0"),
        *("hmax", "h max", "max depth", "maximum depth", "max. depth"),
        *(
            "\u6df1\u3055",
            "\u62bc\u8fbc\u307f\u6df1\u3055",
            "\u5909\u4f4d",
            "\u6df1\u5ea6",
            "\u538b\u5165\u6df1\u5ea6",
            "\u4f4d\u79fb",
        ),
    ),
    "force": (
        *("force", "load", "f", "p", "load on sample", "fn", "normal force", "normal load", "indent load", "standard force"),
        *("kraft", "pr\xfcfkraft", "standardkraft", "last", "charge", "fuerza", "carga", "forza", "carico"),
        *("pmax", "fmax", "p max", "f max", "max load", "maximum load", "max. load", "max force", "maximum force"),
        *("\u8377\u91cd", "\u8bd5\u9a8c\u529b", "\u8a66\u9a13\u529b", "\u8f7d\u8377", "\u529b"),
    ),
    "stiffness": ("stiffness", "contact stiffness", "s", "k", "harmonic contact stiffness", "steifigkeit", "kontaktsteifigkeit"),
    "radius": ("radius", "contact radius", "a"),
    "area": ("area", "contact area", "projected area", "projected contact area", "ac", "a c", "a"),
    "modulus": ("modulus", "effective modulus", "e_eff", "eeff", "er", "e_r", "reduced modulus"),
    "height": (
        *("height", "height (measured)", "height (piezo)", "height (measured & smoothed)", "piezo", "z", "zsensor", "z sensor"),
        *("head height", "head height (measured)", "head height (measured & smoothed)", "height sensor", "ramp"),
    ),
    "deflection": ("deflection", "vdeflection", "vertical deflection", "defl"),
    "time": (
        *("time", "t", "time on sample", "elapsed time", "series time", "zeit", "pr\xfcfzeit", "temps", "tiempo", "tempo"),
        *("\u6642\u9593", "\u65f6\u95f4"),
    ),
    "omega": ("omega", "angular frequency", "w", "frequency", "freq"),
    "storage": ("storage", "storage stiffness", "dynamic stiffness", "k'", "k1"),
    "loss": ("loss", "loss stiffness", "k''", "k2"),
}
ROLES: Mapping[str, tuple[Dimension, tuple[str, ...]]] = {role: (QUANTITIES[role], names) for role, names in _NAMES.items()}
"""Dimension and names."""
