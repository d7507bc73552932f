# SPDX-License-Identifier: GPL-3.0-or-later
"""Conduction of current or heat through a contact, and the heat of friction."""

from ..material import Conductor
from .bodies import INSULATING, PERFECT, LayeredConductor
from .contact import Conduction, ContactConductance, FrictionHeat, RoughJoint, Spot, TabulatedConduction

__all__ = [
    "Conductor",
    "LayeredConductor",
    "PERFECT",
    "INSULATING",
    "Conduction",
    "TabulatedConduction",
    "Spot",
    "FrictionHeat",
    "RoughJoint",
    "ContactConductance",
]
