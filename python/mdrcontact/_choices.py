# SPDX-License-Identifier: GPL-3.0-or-later
"""Messages for wrong names, with the nearest right one."""

from __future__ import annotations

import difflib
import itertools
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from .errors import InvalidArgumentError

_SYNONYMS: Mapping[str, str] = {
    "thickness": "h t d thick film_thickness coating_thickness layer_thickness height",
    "nu": "poisson poissons_ratio poisson_ratio poissons v",
    "e": "young youngs youngs_modulus young_modulus elastic_modulus elasticity modulus y",
    "substrate": "base bulk support half_space halfspace",
    "coating": "film layer skin",
    "layer": "layers film coating",
    "material": "body bulk",
    "indenter": "tip probe punch",
    "medium": "sample specimen body",
    "radius": "r tip_radius curvature radius_of_curvature diameter",
    "half_angle": "angle semi_angle cone_angle opening_angle",
    "work_of_adhesion": "w gamma adhesion adhesion_energy surface_energy energy delta_gamma dupre",
    "shear_modulus": "g shear",
    "bulk_modulus": "k",
    "exponent": "n m power index",
    "coefficient": "mu friction_coefficient friction k",
    "depth": "h d displacement indentation penetration",
    "force": "p f load",
    "stiffness": "s k",
    "depths": "h d displacements indentations penetrations",
    "forces": "p f loads",
    "radii": "a contact_radius contact_radii radiuses",
    "spring_constant": "k cantilever_stiffness stiffness",
    "deflection_sensitivity": "sensitivity invols",
    "frame_compliance": "machine_compliance load_frame_compliance cf compliance",
    "indenter_material": "tip_material",
    "viscosity": "eta",
    "thermal_conductivity": "conductivity kappa lambda",
}
"""Other words of the field for a name; of several names all are offered."""


def nearest(wrong: str, right: Iterable[str]) -> str:
    """Return text for an error message: the nearest right name, or all names if none is near."""
    by_lower = {name.lower(): name for name in right}
    if not by_lower:
        return "there is none to choose from"
    meant = [by_lower[name] for name in dict.fromkeys(_meant(wrong)) if name in by_lower]
    if meant and wrong.lower() not in by_lower:
        return f"did you mean {' or '.join(map(repr, meant))}?"
    close = difflib.get_close_matches(wrong.lower(), by_lower, n=1, cutoff=0.5)
    if close:
        return f"did you mean {by_lower[close[0]]!r}?"
    return "choose from " + ", ".join(repr(name) for name in by_lower.values())


def suggestion(wrong: str, right: Iterable[str]) -> str:
    """Return the same as a sentence."""
    words = nearest(wrong, right)
    return f"{words[0].upper()}{words[1:]}" + "." * (not words.endswith("?"))


def _meant(wrong: str) -> Iterator[str]:
    """Names in small letters that a term of the field means, part by part of a name with dots."""
    parts = []
    for part in wrong.lower().replace("'", "").replace("-", "_").replace(" ", "_").split("."):
        parts.append([*(name for name, words in _SYNONYMS.items() if part in words.split()), part])
    return (".".join(chosen) for chosen in itertools.product(*parts))


def code(name: str, value: Any, codes: dict[str, int], *allowed: str) -> int:
    """Return the code of a name; the message for a wrong name has the nearest right one."""
    known = allowed or tuple(codes)
    if not isinstance(value, str) or value not in known:
        raise InvalidArgumentError(f"{name} = {value!r}: {nearest(str(value), known)}")
    return codes[value]
