# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact depth, area, reduced modulus and hardness after Oliver and Pharr, with standard errors."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..._boundary import number
from ..._units import LENGTH, MODULUS
from ...errors import ArgumentTypeError, InvalidArgumentError
from ...material import Elastic
from ...medium import Homogeneous
from ...panels import Figure, Line, Panel, along
from .data import StiffnessDepth
from .parameters import Instrument
from .parameters import has_homogeneous_indenter as is_paired
from .problem import make_problem

Array = NDArray[np.float64]


class OliverPharr(NamedTuple):
    """Contact depth, area, reduced modulus and hardness of each point.

    `oliver_pharr` returns it. Standard errors of one point share the errors of stiffness and tip.

    Examples
    --------
    >>> depth = np.concatenate([np.linspace(0.0, 100e-9, 60), np.linspace(100e-9, 60e-9, 60)])
    >>> force = 1e-3 * np.concatenate([np.linspace(0.0, 1.0, 60) ** 2, np.linspace(1.0, 0.0, 60) ** 1.5])
    >>> found = mdr.instruments.oliver_pharr(mdr.instruments.Unloading(depth, force), mdr.Berkovich())
    >>> print(f"{found.contact_depth[0] * 1e9:.2f} {found.hardness[0] / 1e9:.2f}")
    80.00 6.38
    """

    depth: Array
    """h [length]"""
    force: Array
    """P [modulus length^2]"""
    stiffness: Array
    """S of the contact, without the frame [modulus length]"""
    stiffness_error: Array
    """standard error of S [modulus length]"""
    contact_depth: Array
    """h_c [length]"""
    contact_depth_error: Array
    """standard error of h_c [length]"""
    radius: Array
    """contact radius, sqrt(A/pi) [length]"""
    area: Array
    """A, projected contact area [length^2]"""
    area_error: Array
    """standard error of A [length^2]"""
    reduced_modulus: Array
    """E_r = S/(2 beta a), of sample and indenter in series [modulus]"""
    reduced_modulus_error: Array
    """standard error of E_r [modulus]"""
    hardness: Array
    """H = P/A [modulus]"""
    hardness_error: Array
    """standard error of H [modulus]"""

    def plot(self, title: str = "") -> Figure:
        """Return reduced modulus and hardness over depth as a figure.

        Bars are 95 % intervals. Numbers are taken as SI.

        Parameters
        ----------
        title : str, optional
            Title of the figure.

        Returns
        -------
        Figure
            The figure.
        """
        x, length = along("indentation depth", LENGTH, self.depth, low=0.0)
        panels = []
        for name, field in (("reduced modulus E_r", "reduced_modulus"), ("hardness H", "hardness")):
            values, errors = getattr(self, field), getattr(self, f"{field}_error")
            y, unit = along(name, MODULUS, values, low=0.0)
            panels.append(
                Panel(x, y, (Line(length.of(self.depth), unit.of(values), "", 0, -1, "o", error=1.96 * unit.of(errors)),))
            )
        return Figure(title or "After Oliver and Pharr", tuple(panels))


def oliver_pharr(
    data: StiffnessDepth,
    indenter: Any,
    instrument: Instrument | None = None,
    *,
    area_sd: float = 0.0,
    medium: Any = None,
) -> OliverPharr:
    """Compute contact depth, area, reduced modulus and hardness.

    The formulas are h_c = h - sigma P/S, A = pi a^2 of the tip at the height h_c, E_r = S/(2 beta a) and H = P/A.

    Parameters
    ----------
    data : StiffnessDepth
        Dynamic data, or an `Unloading`. Without standard deviations the errors are those of the tip alone.
    indenter : Profile
        The tip, as an `AreaFunction`.
    instrument : Instrument, optional
        epsilon (`contact_depth_factor`), beta (`stiffness_factor`), `contact_depth_scale`, `frame_compliance`, offsets,
        `area_factor`.
    area_sd : float, optional
        Relative standard deviation of the area of the tip, 0 <= area_sd < 1 [1].
    medium : Medium, optional
        The body, as from a fit: sigma is that of its exact contact. None is a half-space with sigma = epsilon.

    Returns
    -------
    OliverPharr
        One number for each point.

    Raises
    ------
    ArgumentTypeError
        The data are not `StiffnessDepth`.
    InvalidArgumentError
        `area_sd` is outside its range.

    References
    ----------
    oliver-1992
    oliver-2004

    Examples
    --------
    >>> depth = np.concatenate([np.linspace(0.0, 100e-9, 60), np.linspace(100e-9, 60e-9, 60)])
    >>> force = 1e-3 * np.concatenate([np.linspace(0.0, 1.0, 60) ** 2, np.linspace(1.0, 0.0, 60) ** 1.5])
    >>> found = mdr.instruments.oliver_pharr(mdr.instruments.Unloading(depth, force), mdr.Berkovich(), area_sd=0.02)
    >>> print(f"{found.reduced_modulus[0] / 1e9:.1f}")
    83.9
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
