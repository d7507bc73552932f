# SPDX-License-Identifier: GPL-3.0-or-later
"""The same bodies in other units."""

from __future__ import annotations

from typing import Any

import mdrcontact as mdr


def in_units(what: Any, s: float, t: float = 1.0) -> Any:
    """`what` with all its lengths times s and all its moduli times t."""
    match what:
        case mdr.SumProfile(terms=terms):
            return mdr.SumProfile(tuple(in_units(term, s) for term in terms))
        case mdr.Pair(lower=lower, upper=upper):
            return mdr.Pair(in_units(lower, s, t), in_units(upper, s, t))
        case mdr.PowerLaw(exponent=n, coefficient=c):
            return mdr.PowerLaw(n, c * s ** (1.0 - n))
        case mdr.AreaFunction(coefficients=c, max_height=high, min_height=low):
            powers = [2.0 if k == 0 else 0.5 ** (k - 1) for k in range(len(c))]
            terms = [v * s ** (2.0 - n) for v, n in zip(c, powers, strict=True)]
            return mdr.AreaFunction(terms, max_height=high * s, min_height=low * s)
        case mdr.Layered(layers=layers, substrate=base):
            return what.replace(layers=[(in_units(m, s, t), h * s) for m, h in layers], substrate=in_units(base, s, t))
        case mdr.Surface(tension=tension, bending=bending, stretching=stretching):
            return mdr.Surface(tension * s * t, bending * s**3 * t, stretching * s * t)
    if what is mdr.RIGID or what is None:
        return what
    changes = {name: _times(getattr(what, name), s, t, unit) for name, unit in _UNITS[type(what)].items()}
    return what.replace(**changes) if changes else what


_UNITS: dict[type, dict[str, str]] = {
    mdr.Elastic: {"E": "t"},
    mdr.Paraboloid: {"radius": "s"},
    mdr.Sphere: {"radius": "s"},
    mdr.FlatPunch: {"radius": "s"},
    mdr.Cone: {},
    mdr.Berkovich: {},
    mdr.Vickers: {},
    mdr.CubeCorner: {},
    mdr.RoundedCone: {"blend_radius": "s"},
    mdr.FlatEndedCone: {"end_radius": "s"},
    mdr.FlatEndedParaboloid: {"end_radius": "s", "radius": "s"},
    mdr.Homogeneous: {"material": "body", "surface": "body"},
    mdr.Coated: {"coating": "body", "thickness": "s", "substrate": "body", "surface": "body"},
    mdr.Graded: {"z": "s", "E": "t"},
    mdr.PowerLawGraded: {"E0": "t", "z0": "s"},
    mdr.TabulatedMedium: {"a": "s", "moduli": "t"},
}
"""Of each argument that has a unit: length, modulus, or a body itself."""


def _times(value: Any, s: float, t: float, unit: str) -> Any:
    if unit == "body":
        return in_units(value, s, t)
    factor = s if unit == "s" else t
    return [v * factor for v in value] if isinstance(value, tuple) else value * factor
