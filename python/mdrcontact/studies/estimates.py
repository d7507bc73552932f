# SPDX-License-Identifier: GPL-3.0-or-later
"""The estimates of a fit as numbers, which several studies show."""

from __future__ import annotations

from ..instruments.fitting import FitResult
from ..instruments.fitting.quantities import dimension_of
from .result import Number


def estimates(fit: FitResult) -> dict[str, Number]:
    """Each estimate and its standard error."""
    numbers = {}
    for name in fit.names:
        numbers[name] = Number(fit.estimates[name], dimension_of(name))
        numbers[f"standard error of {name}"] = Number(fit.standard_errors[name], dimension_of(name))
    return numbers
