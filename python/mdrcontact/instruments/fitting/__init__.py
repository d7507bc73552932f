# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of measured data, with uncertainties."""

from .between import MeanOfTests, mean_of_tests
from .calibration import as_prior
from .compare import ModelRanking, RankedModel, compare_models
from .composite_hardness import CompositeHardness, HardnessForm, composite_hardness
from .conduction import ConductanceForce, ConductionFit, Impedance, fit_conduction
from .data import ForceDepth, ModulusRadius, StiffnessDepth, StiffnessRadius, UnloadingPoint
from .depth_profile import DepthProfile, modulus_at_depths
from .gel import GelFit, compare_drainages, fit_gel
from .indent import Indent
from .many import FailedFit, FitResults, fit_many
from .misfit import Misfit
from .moves import Move, Moves, find_moves
from .oliver_pharr import OliverPharr, oliver_pharr
from .parameters import Free, Instrument, JointPrior
from .pyramids import PyramidCorrection, pyramid_correction
from .rate_curves import RateCurve, RateFit, fit_rate
from .rating import Rating, rate
from .result import FitResult
from .solve import fit
from .time_data import DepthTime, DynamicStiffness, ForceTime
from .unloading import Unloading
from .yielding import LayerYield

__all__ = [
    "fit",
    "fit_many",
    "fit_gel",
    "compare_drainages",
    "fit_rate",
    "RateCurve",
    "RateFit",
    "GelFit",
    "fit_conduction",
    "ConductanceForce",
    "Impedance",
    "ConductionFit",
    "compare_models",
    "FitResult",
    "FailedFit",
    "FitResults",
    "ModelRanking",
    "RankedModel",
    "Free",
    "Instrument",
    "JointPrior",
    "ForceDepth",
    "StiffnessDepth",
    "ModulusRadius",
    "StiffnessRadius",
    "ForceTime",
    "DepthTime",
    "DynamicStiffness",
    "as_prior",
    "modulus_at_depths",
    "DepthProfile",
    "pyramid_correction",
    "PyramidCorrection",
    "composite_hardness",
    "CompositeHardness",
    "HardnessForm",
    "Misfit",
    "Indent",
    "LayerYield",
    "find_moves",
    "Move",
    "Moves",
    "mean_of_tests",
    "MeanOfTests",
    "rate",
    "Rating",
    "oliver_pharr",
    "OliverPharr",
    "Unloading",
    "UnloadingPoint",
]
