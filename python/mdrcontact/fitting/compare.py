# SPDX-License-Identifier: GPL-3.0-or-later
"""Every medium model on the same data, ranked by an information criterion, with the bias each puts on the parameters."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any, NamedTuple

from .. import medium as media
from ..errors import ArgumentTypeError, MDRError
from ..material import RIGID
from ..medium.models import MODELS
from .data import Data
from .result import FitResult
from .solve import fit


class RankedModel(NamedTuple):
    """One model's fit."""

    model: str
    result: FitResult
    delta_aic: float
    """AIC above the lowest one; over 10 the model has no support from the data"""
    weight: float
    """Akaike weight: the model's share of the evidence"""
    bias: dict[str, float]
    """relative deviation of each free parameter from that of the exact model; empty without it"""


class ModelRanking(NamedTuple):
    """The models, best first, and those that refused."""

    models: list[RankedModel]
    refused: dict[str, str]

    def summary(self) -> str:
        """The ranking as a table."""
        names = list(self.models[0].result.names) if self.models else []
        rows = [["model", "AIC - best", "BIC", "weight", *(f"{n} (bias)" for n in names)]]
        for entry in self.models:
            cells = []
            for name in names:
                bias = f" ({100.0 * entry.bias[name]:+.1f} %)" if name in entry.bias else ""
                cells.append(f"{entry.result.estimates[name]:.4g}{bias}")
            note = "" if entry.result.converged else " (not converged)"
            rows.append([entry.model + note, f"{entry.delta_aic:.1f}", f"{entry.result.bic:.5g}", f"{entry.weight:.2g}", *cells])
        widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
        lines = ["  ".join(cell.ljust(w) for cell, w in zip(row, widths, strict=True)).rstrip() for row in rows]
        return "\n".join(lines + [f"refused: {model}: {words}" for model, words in self.refused.items()])


def compare_models(
    data: Data, indenter: Any, medium: Any, free: Any, *, models: Iterable[str] | None = None, **options: Any
) -> ModelRanking:
    """Fits the same data under every model of a coated or layered medium; takes the arguments of `fit`.

    models : their names; default: all that know this medium
    """
    if not isinstance(medium, (media.Coated, media.Layered)):
        raise ArgumentTypeError(f"medium = {medium!r} is not allowed: only coated and layered media have several models")
    chosen = list(models) if models is not None else _candidates(medium)
    found: dict[str, FitResult] = {}
    refused: dict[str, str] = {}
    for model in chosen:
        try:
            same = medium if model == medium.model else medium.with_model(model)
            found[model] = fit(data, indenter, same, free, **options)
        except MDRError as problem:
            refused[model] = str(problem)
    if not found:
        raise MDRError("no model could be fitted: " + "; ".join(f"{model}: {words}" for model, words in refused.items()))
    lowest = min(result.aic for result in found.values())
    shares = {model: math.exp(-0.5 * (result.aic - lowest)) for model, result in found.items()}
    exact = found.get("exact")
    ranked = [
        RankedModel(model, result, result.aic - lowest, shares[model] / sum(shares.values()), _bias(result, exact))
        for model, result in found.items()
    ]
    return ModelRanking(sorted(ranked, key=lambda entry: entry.delta_aic), refused)


def _candidates(medium: Any) -> list[str]:
    if isinstance(medium, media.Layered):
        return [name for name, model in MODELS.items() if model.layers]
    if medium.substrate is RIGID:
        return [name for name, model in MODELS.items() if model.allows_rigid_base]
    return [name for name, model in MODELS.items() if not model.needs_rigid_base]


def _bias(result: FitResult, exact: FitResult | None) -> dict[str, float]:
    if exact is None:
        return {}
    return {n: result.estimates[n] / v - 1.0 for n, v in exact.estimates.items() if v and n in result.estimates}
