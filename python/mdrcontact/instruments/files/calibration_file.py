# SPDX-License-Identifier: GPL-3.0-or-later
"""The file of a calibrated tip, which [indenter] reads."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ...problem import ProblemError
from ...problem.toml import keyed
from ...profile import AreaFunction
from ..fitting import FitResult
from ..fitting.calibration import as_prior, words_of_tests
from ..fitting.quantities import dimension_of

_UNIT = 1e-9
"""of the coefficients of area functions: nm"""


def calibration_text(result: FitResult, title: str, indenter: Mapping[str, Any], curves: Sequence[str]) -> str:
    """The file of a calibration. indenter : the table [indenter] of its problem file, whose fitted numbers are replaced."""
    prior = as_prior(result)
    foreign = [name for name in prior.names if not (name.startswith("indenter.") or name == "frame_compliance")]
    if foreign:
        raise ProblemError(
            f"[fit.free]: {foreign[0]!r} is no number of the tip or the frame: a calibration leaves the body as it is known"
        )
    lines = [
        "# Tip and frame, calibrated by mdrcontact",
        *(f"# {' '.join(words.split())}" for words in (title, f"curves: {', '.join(curves)}")),
    ]
    lines += [f"# warning: {words}" for words in [*result.warnings, *words_of_tests(result)]]
    lines += ["", "[indenter]"]
    numbers = _numbers(result)
    kept = {key: value for key, value in indenter.items() if not any(f"{key}_".startswith(f"{name}_") for name in numbers)}
    for key, value in {**kept, **numbers}.items():
        lines.append(keyed(key, value))
    sds = np.sqrt(np.diag(np.array(prior.covariance)))
    scale = np.outer(sds, sds)
    lines += ["", "[calibration]", f"names = {json.dumps(list(prior.names))}"]
    lines += [f"values = {json.dumps([_quantity(n, v) for n, v in zip(prior.names, prior.values, strict=True)])}"]
    lines += [f"sds = {json.dumps([_quantity(n, float(v)) for n, v in zip(prior.names, sds, strict=True)])}"]
    lines += [f"correlation = {json.dumps((np.array(prior.covariance) / scale).round(12).tolist())}"]
    return "\n".join(lines) + "\n"


def _numbers(result: FitResult) -> dict[str, Any]:
    """The keys of [indenter] that hold the numbers of the tip."""
    tip = result.indenter
    if isinstance(tip, AreaFunction):
        powers = [2.0 if i == 0 else 0.5 ** (i - 1) for i in range(len(tip.coefficients))]
        terms = [float(c) * _UNIT ** (power - 2.0) for c, power in zip(tip.coefficients, powers, strict=True)]
        return {"coefficients": terms, "length_unit": "nm", "max_height": f"{tip.max_height:.12g} m"}
    free = {name for name in result.names if name.startswith("indenter.")}
    found = {}
    for key, value in tip.parameters().items():
        name = f"indenter.{key}"
        if name in free:
            if not dimension_of(name).si:
                raise ProblemError(f"{name} cannot be written to a calibration")
            found[key] = _quantity(name, value)
    return found


def _quantity(name: str, value: float) -> Any:
    """A value with its unit, in full precision."""
    si = dimension_of(name).si
    return f"{value!r} {si}" if si else value
