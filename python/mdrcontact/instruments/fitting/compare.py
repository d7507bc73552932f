# SPDX-License-Identifier: GPL-3.0-or-later
"""Every medium model on the same data, ranked by an information criterion, with the bias each puts on the parameters."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

import numpy as np

from ... import medium as media
from ..._parts import share
from ..._text import aligned, html_table
from ...errors import ArgumentTypeError, MDRError
from ...material import RIGID
from ...medium.models import MODELS
from ...panels import Axis, Figure, Line, Panel, along
from .data import Data
from .misfit import percent
from .quantities import dimension_of, words_of
from .result import FitResult
from .solve import fit


class RankedModel(NamedTuple):
    """Fit under one model, with its rank, from `compare_models`.

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(165e9, 0.22))
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> force = mdr.Contact(mdr.Paraboloid(10e-6), film).at_depth(depth).force
    >>> data = mdr.instruments.ForceDepth(depth, force, relative_sd=0.01)
    >>> ranking = mdr.instruments.compare_models(data, mdr.Paraboloid(10e-6), film, ["coating.E"], models=["exact", "gao"])
    >>> print([(entry.model, entry.is_wrong) for entry in ranking.models])
    [('exact', False), ('gao', True)]
    """

    model: str
    """name of the model"""
    result: FitResult
    """fit under this model"""
    delta_aic: float
    """AIC minus the lowest one; above 10 the data do not support the model [1]"""
    weight: float
    """Akaike weight, the share of the model in the evidence [1]"""
    bias: dict[str, float]
    """relative deviation of each free parameter from that of the exact model; empty without it [1]"""
    error: float | None
    """largest error of E_eff at the contact radii of the data, against the exact solution of the body; None without it [1]"""

    @property
    def is_wrong(self) -> bool:
        """True if the error of E_eff exceeds 5 % at the contact radii of the data."""
        return self.error is not None and abs(self.error) > _WRONG


_WRONG = 0.05
"""A model whose E_eff has a larger error is wrong at these contacts, however well it fits."""
_CAUTION = (
    "A low AIC identifies the curve closest to the data, not the correct model: with its other parameters free a formula may "
    "mimic a "
    "blunt tip, a wrong contact point or pile-up. The error of E_eff is that of each model against the exact solution of the "
    "same body."
)


class ModelRanking(NamedTuple):
    """Models of a coated or layered body, best fit first, from `compare_models`.

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(165e9, 0.22))
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> force = mdr.Contact(mdr.Paraboloid(10e-6), film).at_depth(depth).force
    >>> data = mdr.instruments.ForceDepth(depth, force, relative_sd=0.01)
    >>> ranking = mdr.instruments.compare_models(data, mdr.Paraboloid(10e-6), film, ["coating.E"], models=["exact", "garcia"])
    >>> print([entry.model for entry in ranking.models], list(ranking.refused))
    ['exact'] ['garcia']
    """

    models: list[RankedModel]
    """fits by ascending AIC"""
    refused: dict[str, str]
    """reasons why other models cannot be fitted, by name"""

    def plot(self, title: str = "") -> Figure:
        """Return each parameter under each model, with its 95 % interval, as a figure.

        The models are in the order of their AIC. Numbers are taken as SI.

        Parameters
        ----------
        title : str, optional
            Title of the figure.

        Returns
        -------
        Figure
            The figure.
        """
        x = Axis("model, best AIC first", names=tuple(entry.model for entry in self.models))
        results = [entry.result for entry in self.models]
        wrong = np.array([entry.is_wrong for entry in self.models])
        panels = []
        for name in results[0].names:
            y, unit = along(words_of(name), dimension_of(name), [abs(one.estimates[name]) for one in results])
            values = unit.of(np.array([one.estimates[name] for one in results]))
            errors = 1.96 * unit.of(np.array([one.standard_errors[name] for one in results]))
            panels.append(Panel(x, y, tuple(_marked(values, errors, wrong))))
        return Figure(title or "Models", tuple(panels))

    def summary(self) -> str:
        """Return the ranking as a table.

        Returns
        -------
        str
            A row for each model.
        """
        refused = (f"refused: {model}: {words}" for model, words in self.refused.items())
        return "\n".join([aligned(self._rows()), *refused, _CAUTION])

    def _repr_html_(self) -> str:
        """The ranking in a notebook."""
        return html_table(self._rows())

    def _rows(self) -> list[list[str]]:
        """A row for each model, below the titles."""
        names = list(self.models[0].result.names) if self.models else []
        rows = [["model", "AIC - best", "BIC", "weight", "error of E_eff", *(f"{n} (bias)" for n in names)]]
        for entry in self.models:
            cells = []
            for name in names:
                bias = f" ({100.0 * entry.bias[name]:+.1f} %)" if name in entry.bias else ""
                cells.append(entry.result.as_text(name) + bias)
            note = "" if entry.result.converged else " (not converged)"
            error = "" if entry.error is None else f"{100.0 * entry.error:+.1f} %" + (" WRONG HERE" if entry.is_wrong else "")
            numbers = [f"{entry.delta_aic:.1f}", f"{entry.result.bic:.5g}", f"{entry.weight:.2g}"]
            rows.append([entry.model + note, *numbers, error, *cells])
        return rows


def _marked(values: Any, errors: Any, wrong: Any) -> Iterator[Line]:
    """Points with their intervals; in another colour where the model is wrong at these contacts."""
    at = np.arange(1.0, len(values) + 1.0)
    for keep, name, colour in ((~wrong, "", 0), (wrong, f"E_eff wrong by more than {percent(_WRONG)}", 1)):
        if keep.any():
            yield Line(at[keep], values[keep], name, colour, -1, "o", error=errors[keep])


def compare_models(
    data: Data, indenter: Any, medium: Any, free: Any, *, models: Iterable[str] | None = None, **options: Any
) -> ModelRanking:
    """Fit the same data under every model of a coated or layered medium.

    Parameters
    ----------
    data : ForceDepth, StiffnessDepth, ModulusRadius or StiffnessRadius
        As in `fit`.
    indenter : Profile
        As in `fit`.
    medium : Coated or Layered
        As in `fit`.
    free : mapping or iterable of str
        As in `fit`.
    models : iterable of str, optional
        Names of models; None is all that support the medium.
    **options
        Further arguments of `fit`.

    Returns
    -------
    ModelRanking
        The fits by ascending AIC. A low AIC does not show that a model is right; see `RankedModel.error`.

    Raises
    ------
    ArgumentTypeError
        The medium has one model only.
    MDRError
        No model can be fitted.

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(165e9, 0.22))
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> force = mdr.Contact(mdr.Paraboloid(10e-6), film).at_depth(depth).force
    >>> data = mdr.instruments.ForceDepth(depth, force, relative_sd=0.01)
    >>> ranking = mdr.instruments.compare_models(data, mdr.Paraboloid(10e-6), film, ["coating.E"], models=["exact", "gao"])
    >>> print(f"{ranking.models[1].bias['coating.E']:.3f}")
    -0.068
    """
    if not isinstance(medium, (media.Coated, media.Layered)):
        raise ArgumentTypeError(f"medium = {medium!r}: only coated and layered media have several models")
    chosen = list(models) if models is not None else _candidates(medium)

    def one(model: str) -> FitResult | str:
        try:
            same = medium if model == medium.model else medium.with_model(model)
            return fit(data, indenter, same, free, **options)
        except MDRError as problem:
            return str(problem)

    results = dict(zip(chosen, share(one, chosen), strict=True))
    found = {model: result for model, result in results.items() if not isinstance(result, str)}
    refused = {model: words for model, words in results.items() if isinstance(words, str)}
    if not found:
        raise MDRError("no model could be fitted: " + "; ".join(f"{model}: {words}" for model, words in refused.items()))
    lowest = min(result.aic for result in found.values())
    shares = {model: math.exp(-0.5 * (result.aic - lowest)) for model, result in found.items()}
    exact = found.get("exact")
    errors = {} if exact is None else _errors(exact, found)
    total = sum(shares.values())
    ranked = [
        RankedModel(model, result, result.aic - lowest, shares[model] / total, _bias(result, exact), errors.get(model))
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


def _errors(exact: FitResult, models: Iterable[str]) -> dict[str, float]:
    """The largest relative error of each model's E_eff for the body of the exact fit, at its contact radii."""
    try:
        radius = exact.problem.predict(exact._values)[1]
        radius = radius[radius > 0.0]
        if not len(radius):
            return {}
        a = np.geomspace(radius.min(), radius.max(), 20) if radius.max() > radius.min() else radius[:1]
        true = np.asarray(exact.medium.modulus(a))
    except MDRError:
        return {}
    errors = {}
    for model in models:
        try:
            deviation = np.asarray(exact.medium.with_model(model).modulus(a)) / true - 1.0
        except MDRError:
            continue
        errors[model] = float(deviation[np.argmax(np.abs(deviation))])
    return errors
