# SPDX-License-Identifier: GPL-3.0-or-later
"""From measured data to film properties with their uncertainty."""

from .compare import ModelRanking, RankedModel, compare_models
from .data import ForceDepth, ModulusRadius, StiffnessDepth, StiffnessRadius
from .many import FailedFit, fit_many
from .parameters import Free, Instrument, JointPrior
from .result import FitResult
from .solve import fit

__all__ = [
    "fit",
    "fit_many",
    "compare_models",
    "FitResult",
    "FailedFit",
    "ModelRanking",
    "RankedModel",
    "Free",
    "Instrument",
    "JointPrior",
    "ForceDepth",
    "StiffnessDepth",
    "ModulusRadius",
    "StiffnessRadius",
]
