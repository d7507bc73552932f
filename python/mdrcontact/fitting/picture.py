# SPDX-License-Identifier: GPL-3.0-or-later
"""Data, fit and residuals as a figure."""

from __future__ import annotations

import io
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .._files import replace
from ..errors import MDRError
from .advice import contact_radii
from .data import ForceDepth, ModulusRadius, StiffnessDepth

if TYPE_CHECKING:
    from .result import FitResult

_BLUE, _RED, _GREY = "#0072B2", "#D55E00", "#707070"


def draw(result: FitResult, path: str | os.PathLike[str] | None) -> Any:
    """The figure; numbers are in the units of the problem."""
    try:
        from matplotlib.figure import Figure
    except ImportError as problem:
        raise MDRError('figures need matplotlib: pip install "mdrcontact[plot]"') from problem
    figure = Figure(figsize=(6.4, 5.6), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=[3, 1])
    data = result.data
    order = np.argsort(data.x, kind="stable")
    x = data.x[order]
    bars = None if data.sd is None else data.sd[order] * result.noise
    if bars is None or len(x) > 300:
        above.plot(x, data.y[order], ".", color=_GREY, markersize=3, label="data")
    else:
        above.errorbar(x, data.y[order], bars, fmt=".", color=_GREY, markersize=4, elinewidth=0.8, label="data")
    above.plot(x, result.fitted[order], color=_BLUE, label=_model(result))
    above.set_ylabel(data.y_name)
    lines = [f"{name} = {result.estimates[name]:.4g} ± {result.standard_errors[name]:.2g}" for name in result.names]
    if not result.converged:
        lines.append("not converged")
    above.set_title("\n".join(lines), fontsize=9, loc="left")
    above.legend(frameon=False)
    below.axhspan(-1.96, 1.96, color="#eeeeee")
    below.axhline(0.0, color=_BLUE, linewidth=1.0)
    below.plot(x, result.residuals[order], ".", color=_RED, markersize=3)
    below.set(xlabel=_x_label(data), ylabel="residual / sd")
    for axis in (above, below):
        axis.spines[["top", "right"]].set_visible(False)
    if path is not None:
        drawn = io.BytesIO()
        figure.savefig(drawn, format=Path(path).suffix.lower().removeprefix(".") or "png", dpi=160)
        replace(path, drawn.getvalue())
    return figure


def modulus_against_ratio(result: FitResult) -> tuple[Any, Any, Any]:
    """a, measured and fitted E_eff of stiffness-depth data, for figures."""
    if not isinstance(result.data, StiffnessDepth):
        raise MDRError("these are not stiffness-depth data")
    a = contact_radii(result)
    beta, frame = result.values["stiffness_factor"], result.values["frame_compliance"]
    measured = 1.0 / (2.0 * beta * a * (1.0 / result.data.y - frame) - 1.0 / result.values["indenter_modulus"])
    return a, measured, np.asarray(result.medium.modulus(a))


def _model(result: FitResult) -> str:
    model = getattr(result.medium, "model", None)
    return f"fit ({model})" if model else "fit"


def _x_label(data: Any) -> str:
    if isinstance(data, (ForceDepth, StiffnessDepth)):
        return "indentation depth"
    return "contact radius" if isinstance(data, ModulusRadius) else data.x_name
