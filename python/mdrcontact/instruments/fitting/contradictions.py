# SPDX-License-Identifier: GPL-3.0-or-later
"""Estimates that contradict what the fit began with: they are no film moduli."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from ... import medium as media
from ...material import Elastic

_SOFTER = 1.5
"""A film this much softer than its base contradicts one that was taken as stiffer."""


def contradictions(result: Any) -> list[str]:
    """Free film moduli that began above the modulus below them and ended below it."""
    medium, problem = result.medium, result.problem
    if not isinstance(medium, (media.Coated, media.Layered)):
        return []
    coated = isinstance(medium, media.Coated)
    films = [("coating.E" if coated else f"layers[{i}].E", material) for i, (material, _) in enumerate(medium._stack())]
    stack, names = [*films, ("", medium.substrate)], []
    for (name, material), (_, below) in pairwise(stack):
        if name not in result.names or problem.free[name].prior is not None:
            continue
        if not (isinstance(material, Elastic) and isinstance(below, Elastic)):
            continue
        began = float(problem.table[0, problem.names.index(name)])
        if began > below.E > _SOFTER * material.E and result.interval(name).upper < below.E:
            names.append(name)
    return names
