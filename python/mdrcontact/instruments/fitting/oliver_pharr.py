# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact depth, area, reduced modulus and hardness after Oliver and Pharr, with standard errors."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..._boundary import number
from ...errors import ArgumentTypeError, InvalidArgumentError
from ...material import Elastic
from ...medium import Homogeneous
from .data import StiffnessDepth
from .parameters import Instrument
from .parameters import has_homogeneous_indenter as is_paired
from .problem import make_problem

Array = NDArray[np.float64]


class OliverPharr(NamedTuple):
    """One number for each point; `..._error` are standard errors, which share the errors of stiffness and tip."""

    depth: Array
    force: Array
    stiffness: Array
    """of the contact, freed of the frame"""
    stiffness_error: Array
    contact_depth: Array
    contact_depth_error: Array
    radius: Array
    """of contact, sqrt(A/pi)"""
    area: Array
    area_error: Array
    reduced_modulus: Array
    """E_r = S/(2 beta a), that of sample and indenter in series"""
    reduced_modulus_error: Array
    hardness: Array
    """P/A"""
    hardness_error: Array


def oliver_pharr(
    data: StiffnessDepth,
    indenter: Any,
    instrument: Instrument | None = None,
    *,
    area_sd: float = 0.0,
    medium: Any = None,
) -> OliverPharr:
    """h_c = h - sigma P/S, A = pi a^2 of the tip at height h_c, E_r = S/(2 beta a) and H = P/A (Oliver and Pharr 1992, 2004).

    data : StiffnessDepth (CSM) or Unloading; without standard deviations the errors are those of the tip alone
    indenter : the tip, best an AreaFunction
    instrument : epsilon (contact_depth_factor), beta (stiffness_factor), contact_depth_scale, frame_compliance, offsets,
        area_factor
    area_sd : relative standard deviation of the tip's area [1]
    medium : the body, best the one that a fit has found: sigma is that of its exact contact. None: a half-space, sigma = epsilon
    """
    if not isinstance(data, StiffnessDepth):
        raise ArgumentTypeError(f"data = {data!r}: it must be StiffnessDepth(...) or Unloading(...)")
    tip_sd = number("area_sd", area_sd)
    if not 0.0 <= tip_sd < 1.0:
        raise InvalidArgumentError(f"area_sd = {area_sd!r}: it must be at least 0 and less than 1")
    given = instrument or Instrument()
    body = Homogeneous(Elastic(1.0, 0.0)) if medium is None else medium
    problem = make_problem(data, indenter, body, ["area_factor"], replace(given, indenter=None) if is_paired(body) else given)
    assert data.force is not None
    load = data.force - given.force_offset

    def evaluate(measured: Array) -> tuple[Array, Array, Array, Array, Array]:
        """Contact stiffness, contact depth, radius, reduced modulus, hardness."""
        _, a = problem.changed(data.with_y(measured)).predict(problem.table[0])
        compliance = 1.0 / measured - given.frame_compliance
        height = np.asarray(indenter.height(a / math.sqrt(given.area_factor)))
        return 1.0 / compliance, height, a, 1.0 / (2.0 * given.stiffness_factor * a * compliance), load / (math.pi * a**2)

    stiffness, height, a, modulus, hardness = evaluate(data.y)
    sd = np.zeros_like(data.y) if data.sd is None else data.sd
    # far smaller steps lose digits, larger ones leave the range of the tip
    step = 1e-4 * data.y
    slopes = [(up - down) / (2.0 * step) for up, down in zip(evaluate(data.y + step), evaluate(data.y - step), strict=True)]
    of_stiffness, of_height, of_radius, of_modulus, of_hardness = (np.abs(slope) * sd for slope in slopes)
    area = math.pi * a**2
    return OliverPharr(
        data.x,
        data.force,
        stiffness,
        of_stiffness,
        height,
        of_height,
        a,
        area,
        np.hypot(2.0 * math.pi * a * of_radius, tip_sd * area),
        modulus,
        np.hypot(of_modulus, 0.5 * tip_sd * modulus),
        hardness,
        np.hypot(of_hardness, tip_sd * hardness),
    )
