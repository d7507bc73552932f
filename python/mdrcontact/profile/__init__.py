# SPDX-License-Identifier: GPL-3.0-or-later
"""Indenter profiles."""

from .base import Profile, SumProfile
from .sampled import CallableProfile, TabulatedMDRProfile, TabulatedProfile
from .shapes import Cone, FlatEndedCone, FlatEndedParaboloid, FlatPunch, Paraboloid, PowerLaw, RoundedCone, Sphere
from .tips import AreaFunction, Berkovich, CubeCorner, Vickers

__all__ = [
    "Profile",
    "SumProfile",
    "Paraboloid",
    "Sphere",
    "Cone",
    "PowerLaw",
    "FlatPunch",
    "FlatEndedCone",
    "FlatEndedParaboloid",
    "RoundedCone",
    "Berkovich",
    "Vickers",
    "CubeCorner",
    "AreaFunction",
    "TabulatedProfile",
    "TabulatedMDRProfile",
    "CallableProfile",
]
