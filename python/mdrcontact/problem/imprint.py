# SPDX-License-Identifier: GPL-3.0-or-later
"""The table [imprint] of a problem file: a plastic contact at its largest load."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from .._units import FORCE, LENGTH, MODULUS
from .compute import Control
from .field import NOT_NEGATIVE, POSITIVE, Field, Table
from .section import Section

if TYPE_CHECKING:
    from ..medium import Medium
    from ..plastic import Imprint

_MEASURED, _PRESSURE = {"force": ()}, {"uniform": ()}
_POINTS = 100
KNOWN = Table(
    "the contact at its largest load, measured, or the two terms of its pressure; it unloads to [compute], or to force 0",
    (
        Field("radius", "contact radius", LENGTH, range=POSITIVE),
        Field("force", "force", FORCE, range=POSITIVE),
        Field("depth", "depth from initial contact", LENGTH, range=NOT_NEGATIVE, when=_MEASURED),
        Field("residual_depth", "depth that unloading leaves, less than depth", LENGTH, range=NOT_NEGATIVE, when=_MEASURED),
        Field("uniform", "pressure that is the same over the contact area", MODULUS, range=NOT_NEGATIVE),
        Field("hertz", "factor of the pressure that falls to the edge, sqrt(1 - r^2/radius^2)", MODULUS, when=_PRESSURE),
        Field("depth", "depth from initial contact", LENGTH, 0.0, range=NOT_NEGATIVE, when=_PRESSURE),
    ),
    "docs/plastic.md",
    one_of=(("force", "uniform"),),
)


class Imprinted(NamedTuple):
    """A plastic contact at its largest load; SI units."""

    radius: float
    depth: float
    force: float
    residual_depth: float | None
    """None: the pressure is given"""
    uniform: float = 0.0
    hertz: float = 0.0

    def imprint(self, body: Medium) -> Imprint:
        """Return the imprint in a body."""
        from ..plastic import Imprint

        if self.residual_depth is None:
            return Imprint.from_two_terms(body, self.radius, self.uniform, self.hertz, self.depth)
        return Imprint(body, radius=self.radius, force=self.force, residual_depth=self.residual_depth, depth=self.depth)


def unloading(force: float) -> Control:
    """Return the forces of unloading from a largest force if [compute] does not prescribe them."""
    return Control("force", np.linspace(force / _POINTS, force, _POINTS))


def read_imprint(section: Section) -> Imprinted:
    """Return the contents of [imprint]."""
    starts = [key for key in KNOWN.one_of[0] if key in section]
    if len(starts) != 1:
        rule = f"it needs exactly one of force and uniform; it has {' and '.join(starts) if starts else 'none'}"
        remedy = 'Write it as in force = "1 mN", with depth and residual_depth, or as in uniform = "2 GPa", with hertz'
        raise section.error(starts[1] if starts else "force", rule, remedy, shows=False)
    (start,) = starts
    section.only([one.name for one in KNOWN.fields if start in one.when or one.name in ("radius", start)], start)
    radius = section.value("radius")
    if start == "force":
        return Imprinted(radius, section.quantity("depth"), section.value("force"), section.value("residual_depth"))
    uniform, hertz = section.value("uniform"), section.value("hertz")
    force = math.pi * radius**2 * (uniform + 2.0 / 3.0 * hertz)
    if not 0.0 < force < math.inf:
        raise section.error("hertz", f"the force of both pressures is {force:.3g} N: it must be greater than 0 and finite")
    return Imprinted(radius, section.quantity("depth", 0.0), force, None, uniform, hertz)
