# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `fit`: a body, tip or instrument from one measured curve."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .._units import AREA, FORCE, LENGTH, MODULUS, QUANTITIES, RATIO, STIFFNESS, practical
from ..errors import InvalidArgumentError, MDRError
from ..instruments import fitting
from ..instruments.files.fit_file import FitFile
from ..instruments.fitting import FitResult, GelFit, ModelRanking, Moves, OliverPharr, StiffnessDepth
from ..instruments.fitting.data import Data
from ..instruments.fitting.quantities import dimension_of, words_of
from ..instruments.fitting.result import Interval
from ..panels import Figure
from ..progress import Progress
from .estimates import estimates
from .result import Array, Column, Number, Result, column, shared, study


@dataclass(frozen=True, eq=False, kw_only=True)
class FittedCurve(Result):
    """A fit of one curve. Table: "points", of unloading curves after Oliver and Pharr."""

    problem: FitFile
    fit: Any
    """`FitResult`, of a gel `GelFit`"""
    analysis: OliverPharr | None = None
    """contact depth and area on the body that was found, of unloading curves"""
    moves: Moves | None = None
    """change of a modulus with other choices"""
    interval: str = "normal"
    """how `intervals` were found"""
    intervals: Mapping[str, Interval] = field(default_factory=dict)
    """of 95 %, where they do not follow from the standard errors"""
    ranking: ModelRanking | None = None
    """every medium model on the same data"""
    drainages: tuple[GelFit, ...] = ()
    """of a gel, the fits under each drainage"""
    refusal: MDRError | None = None
    """why there are no intervals, or no other models"""

    def figure(self) -> Figure:
        """Return data, fit and residuals; of unloading curves the test with its stiffnesses."""
        found: Figure = self.fit.plot(self.title)
        return found

    def to_dict(self) -> dict[str, Any]:
        """The fit and its intervals as plain Python values."""
        found: dict[str, Any] = self.fit.to_dict()
        for name, ends in self.intervals.items():
            found["parameters"][name][f"{self.interval}_interval"] = [v if math.isfinite(v) else None for v in ends]
        if self.moves:
            found["ranges"] = [move._asdict() for move in self.moves.ranges]
        return found


@study
def fit(
    problem: FitFile,
    data: Data,
    *,
    moves: bool = False,
    interval: str = "normal",
    compare: bool = False,
    progress: Progress | None = None,
) -> FittedCurve:
    """Fit a body, a tip or an instrument to one measured curve.

    Parameters
    ----------
    problem : FitFile
        Indenter, medium, instrument and the free parameters, as `mdrcontact.instruments.load_fit_file` returns them.
    data : Data
        The measurement, as `problem.read_data` reads it from a file, in SI units.
    moves : bool, optional
        Also fit other ranges, branches and contact points.
    interval : str, optional
        Method of the intervals: "normal", "profile" or "monte-carlo".
    compare : bool, optional
        Fit under every medium model, or drainage of a gel, as well.
    progress : Progress, optional
        Reports the intervals, and can stop the work.

    Returns
    -------
    FittedCurve
        `fit`, table "points"; numbers: each estimate, and "standard error of" it; note "fit", its summary.

    Raises
    ------
    InvalidArgumentError
        Moves or other intervals of a gel.
    MDRError
        The data cannot be fitted.

    Examples
    --------
    >>> import numpy as np
    >>> import mdrcontact as mdr
    >>> from mdrcontact import instruments, studies
    >>> text = '''
    ... [indenter]
    ... shape = "paraboloid"
    ... radius = "10 um"
    ... [medium]
    ... type = "homogeneous"
    ... material = { E = "50 GPa", nu = 0.17 }
    ... [data]
    ... kind = "force-depth"
    ... [fit]
    ... free = ["E"]
    ... '''
    >>> depth = np.linspace(10e-9, 100e-9, 20)
    >>> silica = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
    >>> data = instruments.ForceDepth(depth, silica.at_depth(depth).force)
    >>> found = studies.fit(instruments.fit_file_of_text(text), data)
    >>> print(found.numbers["E"])
    72 GPa
    """
    progress = progress or Progress()
    progress.step(0, None, "fit")
    if problem.drainage is not None:
        if interval != "normal":
            raise InvalidArgumentError(f"interval = {interval!r}: a gel has intervals from its standard errors alone")
        if moves:
            raise InvalidArgumentError("moves = True: a gel is fitted to its whole curve alone")
        return _of_gel(problem, data, problem.drainage, compare, progress)
    found = fitting.fit(data, **problem.arguments)
    analysis = None
    if isinstance(data, StiffnessDepth) and data.unloadings:
        analysis = fitting.oliver_pharr(data, found.indenter, found.instrument, medium=found.medium)
    notes = {"fit": found.summary()}
    moved, intervals, ranking, refusal = None, dict[str, Interval](), None, None
    if moves:
        progress.step(0, None, "other choices")
        moved = fitting.find_moves(found)
        notes |= {"moves": "\n".join(moved.summary())} if moved.summary() else {}
    try:
        intervals = _intervals(found, interval, progress)
        notes["fit"] = found.summary(method=interval, intervals=intervals)
        if compare:
            progress.step(0, None, "models")
            ranking = fitting.compare_models(data, **problem.arguments)
            notes["models"] = ranking.summary()
    except MDRError as words:
        refusal = words
    # a stop within one of these fits may have been taken for its failure
    progress.step(0, None, "end")
    return FittedCurve(
        title=problem.title,
        numbers=estimates(found),
        notes=notes,
        tables={"points": _points(found) if analysis is None else _analysed(analysis), **_ranges(moved)},
        warnings=tuple(found.warnings),
        problem=problem,
        fit=found,
        analysis=analysis,
        moves=moved,
        interval=interval,
        intervals=intervals,
        ranking=ranking,
        refusal=refusal,
    )


def _of_gel(problem: FitFile, data: Any, drainage: str, compare: bool, progress: Progress) -> FittedCurve:
    found = fitting.fit_gel(data, problem.indenter, problem.medium, [*problem.free], drainage=drainage)
    notes = {"fit": found.summary()}
    others: tuple[GelFit, ...] = ()
    refusal = None
    if compare:
        progress.step(0, None, "drainages")
        try:
            others = fitting.compare_drainages(data, problem.indenter, problem.medium, [*problem.free])
            notes["models"] = "\n\n".join(other.summary() for other in others)
        except MDRError as words:
            refusal = words
    progress.step(0, None, "end")
    errors = {f"standard error of {name}": Number(value, dimension_of(name)) for name, value in found.errors.items()}
    return FittedCurve(
        title=problem.title,
        numbers={**{name: Number(value, dimension_of(name)) for name, value in found.values.items()}, **errors},
        notes=notes,
        tables={"points": _beside(data, found.fitted)},
        warnings=found.notes,
        problem=problem,
        fit=found,
        drainages=others,
        refusal=refusal,
    )


def _intervals(found: FitResult, method: str, progress: Progress) -> dict[str, Interval]:
    """Intervals that do not follow from the standard errors."""
    if method == "normal":
        return {}
    if method == "monte-carlo":
        progress.step(0, 1, "intervals")
        return found.simulated_intervals(seed=0)
    ends = shared(progress, lambda name: found.interval(name, method=method), found.names, "intervals")
    return dict(zip(found.names, ends, strict=True))


def _ranges(moves: Moves | None) -> dict[str, list[Column]]:
    """The estimate against the end of the range that is fitted: that of a modulus against the depth."""
    if moves is None or not moves.ranges:
        return {}
    ends, values, errors = (np.array([getattr(move, key) for move in moves.ranges]) for key in ("end", "value", "standard_error"))
    x, unit = moves.result.data.x_name, practical(dimension_of(moves.name), values)
    columns = [column(f"end of the {x}", ends, QUANTITIES[x]), Column(words_of(moves.name), values, unit)]
    return {"ranges": [*columns, Column("standard error", errors, unit)]}


def _points(found: FitResult) -> list[Column]:
    return [*_beside(found.data, found.fitted), column("residual/sd", found.residuals, RATIO)]


def _beside(data: Any, fitted: Array) -> list[Column]:
    """Data and model."""
    unit = practical(QUANTITIES[data.y_name], data.y)
    x = column(data.x_name, data.x, QUANTITIES[data.x_name])
    return [x, Column(data.y_name, data.y, unit), Column("fit", fitted, unit)]


def _analysed(found: OliverPharr) -> list[Column]:
    """Numbers after Oliver and Pharr, those that have a standard error with it behind them."""
    columns = [column("depth", found.depth, LENGTH), column("force", found.force, FORCE)]
    kinds = (("contact_depth", LENGTH), ("area", AREA), ("reduced_modulus", MODULUS), ("hardness", MODULUS))
    for name, dimension in (("stiffness", STIFFNESS), *kinds):
        values, unit = getattr(found, name), practical(dimension, getattr(found, name))
        columns.append(Column(name.replace("_", " "), values, unit))
        columns.append(Column("standard error", getattr(found, f"{name}_error"), unit))
    return columns
