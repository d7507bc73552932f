# SPDX-License-Identifier: GPL-3.0-or-later
"""The fit."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from .advice import advice
from .data import Data
from .parameters import Free, Instrument, JointPrior
from .problem import make_problem
from .result import FitResult


def fit(
    data: Data,
    indenter: Any,
    medium: Any,
    free: Mapping[str, Free | float | None] | Iterable[str],
    *,
    instrument: Instrument | None = None,
    loss: str = "linear",
    loss_scale: float = 1.345,
    adhesion_rule: str = "automatic",
    sd_is_absolute: bool = True,
    max_iterations: int = 100,
    check_units: bool = True,
    known: Iterable[JointPrior] = (),
) -> FitResult:
    """Finds the parameters under which indenter and medium explain the data best: nonlinear least squares of the same forward model
    that `Contact` computes, over GSL's trust region.

    data : ForceDepth(...), StiffnessDepth(...), ModulusRadius(...) or StiffnessRadius(...); of a viscoelastic medium
        ForceTime(...), DepthTime(...) or DynamicStiffness(...)
    indenter, medium : any of the library; their parameters are the fixed values, and the start of the free ones
    free : names of the free parameters, or a mapping from names to Free(start, lower=, upper=, prior=(value, sd)), a starting
        value or None. Names: indenter.radius, ...; coating.E, coating.nu, thickness, substrate.E, substrate.nu, alpha;
        layers[0].E, ...; E, nu; indenter.C0, ... of an AreaFunction; of viscoelastic materials
        relaxed_shear_modulus, terms[0].modulus, terms[0].time, ..., viscosity, bulk_modulus or modulus, exponent, with coating.,
        layers[0]. or substrate. before them; work_of_adhesion, depth_offset, force_offset,
        frame_compliance, indenter_modulus, contact_depth_factor, area_factor
    instrument : Instrument(...): adhesion, offsets, frame compliance, the indenter's material
    loss : "linear"; "huber" or "cauchy" are robust against outliers beyond loss_scale standard deviations
    adhesion_rule : "automatic" (energy balance for the exact medium, the source's rule else), "paper" or "energy"
    sd_is_absolute : whether the standard deviations of the data are known, or their ratios only
    max_iterations : of one search, at least 1
    check_units : refuses data more than 300 times larger or smaller than the model at the start
    known : JointPrior(...) of several parameters together, as a tip's calibration gives them

    Bad data raise an exception; a search that does not converge returns its best point, and says so in `converged` and `warnings`.
    """
    problem = make_problem(
        data,
        indenter,
        medium,
        free,
        instrument,
        loss,
        loss_scale,
        adhesion_rule,
        sd_is_absolute,
        max_iterations,
        check_units,
        known,
    )
    result = FitResult(problem, *problem.answer())
    result.warnings = advice(result)
    return result
