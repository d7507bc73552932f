# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that yield: imprints, laws of yielding contacts, pressure caps."""

from .cap import CapState, PressureCap, truncated_hertz
from .imprint import Imprint, ImprintProfile, ReverseYield
from .law import FirstLoading, PlasticLaw, PlasticStep
from .overload import LoadingPoints, Overload, OverloadState
from .yielding import Yielding, YieldStress, yield_stress_from_hardness

__all__ = [
    "CapState",
    "FirstLoading",
    "Imprint",
    "ImprintProfile",
    "LoadingPoints",
    "Overload",
    "OverloadState",
    "PlasticLaw",
    "PlasticStep",
    "PressureCap",
    "ReverseYield",
    "YieldStress",
    "Yielding",
    "truncated_hertz",
    "yield_stress_from_hardness",
]
