# SPDX-License-Identifier: GPL-3.0-or-later
"""Media."""

from .base import Medium
from .coated import Coated
from .graded import Graded, PowerLawGraded
from .homogeneous import Homogeneous
from .layer import SLIDING, Interface, Layer, Wrinkling
from .layered import Layered
from .pair import Pair
from .sampled import CallableMedium, TabulatedMedium
from .surface import Surface

__all__ = [
    "Medium",
    "Homogeneous",
    "Coated",
    "Layered",
    "Layer",
    "Wrinkling",
    "Interface",
    "SLIDING",
    "Graded",
    "PowerLawGraded",
    "TabulatedMedium",
    "CallableMedium",
    "Pair",
    "Surface",
]
