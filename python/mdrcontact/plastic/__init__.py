# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that yield: imprints, laws of yielding contacts, pressure caps."""

from .imprint import Imprint, ImprintProfile, ReverseYield
from .law import FirstLoading, PlasticLaw, PlasticStep
from .yielding import Yielding, YieldStress, yield_stress_from_hardness

__all__ = [
    "FirstLoading", "Imprint", "ImprintProfile", "PlasticLaw", "PlasticStep", "ReverseYield", "YieldStress", "Yielding",
    "yield_stress_from_hardness",
]  # fmt: skip
