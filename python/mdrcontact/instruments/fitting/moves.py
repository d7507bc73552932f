# SPDX-License-Identifier: GPL-3.0-or-later
"""Change of an estimate with the fitted range, the branch and the contact point."""

from __future__ import annotations

import copy
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ... import _layout
from ..._choices import nearest
from ..._parts import share
from ..._units import MODULUS, QUANTITIES, shown
from ...errors import InvalidArgumentError, MDRError
from ...panels import Figure, Line, Panel, along
from .data import Data, ForceDepth
from .parameters import Free
from .quantities import dimension_of, words_of
from .result import FitResult
from .solve import fit

_PARTS = (0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)
"""Ends of the fitted range, relative to the depth in contact."""
_FEWEST, _OF_BRANCH = 20, 0.2
_OPTIONS = ("loss", "loss_scale", "adhesion_rule", "sd_is_absolute", "max_iterations")


class Move(NamedTuple):
    """Estimate of a fit with another choice, from `find_moves`.

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 40)
    >>> silica = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    >>> force = mdr.Contact(mdr.Paraboloid(10e-6), silica).at_depth(depth).force
    >>> result = mdr.instruments.fit(mdr.instruments.ForceDepth(depth, force), mdr.Paraboloid(10e-6), silica, ["E"])
    >>> move = mdr.instruments.find_moves(result).ranges[0]
    >>> print(move.choice, f"{move.value / 1e9:.1f}")
    up to depth 40 nm 72.0
    """

    choice: str
    """the choice, as "up to 50 nm", "unused readings" or "contact point by piecewise" """
    end: float
    """end of the range [unit of x]"""
    value: float
    """the estimate, in the unit of the parameter"""
    standard_error: float
    """its standard error, in the unit of the parameter"""


class Moves(NamedTuple):
    """Estimates of a parameter with other choices than those of its fit.

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 40)
    >>> silica = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    >>> force = mdr.Contact(mdr.Paraboloid(10e-6), silica).at_depth(depth).force
    >>> result = mdr.instruments.fit(mdr.instruments.ForceDepth(depth, force), mdr.Paraboloid(10e-6), silica, ["E"])
    >>> moves = mdr.instruments.find_moves(result)
    >>> print(moves.name, len(moves.ranges), len(moves.branches))
    E 7 0
    """

    result: FitResult
    """the fit"""
    name: str
    """name of the parameter"""
    ranges: tuple[Move, ...]
    """fits up to 30, 40, ... 100 % of the largest depth or radius"""
    branches: tuple[Move, ...]
    """fits of each branch, or of the readings that were not used"""
    contact_points: tuple[Move, ...]
    """fits with the contact point of each estimator"""

    def summary(self) -> list[str]:
        """Return the changes as text.

        Returns
        -------
        list of str
            One line for each kind of choice.
        """
        value = self.result.estimates[self.name]
        words = {
            "the fitted range": self.ranges,
            "the branch": self.branches,
            "the contact point": self.contact_points,
        }
        lines = []
        for what, moves in words.items():
            changes = [100.0 * (move.value / value - 1.0) for move in moves]
            if changes:
                ends = " to ".join(f"{end:+g} %" for end in sorted({_rounded(min(changes)), _rounded(max(changes))}))
                lines.append(f"{words_of(self.name)} moves by {ends} with {what} ({', '.join(_named(moves))})")
        return lines

    def plot(self, title: str = "") -> Figure:
        """Return the estimate against the end of the fitted range as a figure.

        The figure also shows the estimates with the other choices. Numbers are taken as SI.

        Parameters
        ----------
        title : str, optional
            First line of the title.

        Returns
        -------
        Figure
            The figure.
        """
        data = self.result.data
        ends, values, errors = (np.array([getattr(m, name) for m in self.ranges]) for name in ("end", "value", "standard_error"))
        reach = ends if len(ends) else data.x
        x, along_x = along(f"end of the range: {data.x_name}", QUANTITIES[data.x_name], reach)
        y, unit = along(words_of(self.name), dimension_of(self.name), self._values())
        parts = [Line(along_x.of(ends), unit.of(values), "fitted up to there, 95 %", 0, 0, "o", error=1.96 * unit.of(errors))]
        whole = along_x.of(np.array([reach.min(), reach.max()]))
        for i, move in enumerate((*self.branches, *self.contact_points)):
            level = unit.of(np.full(2, move.value))
            parts.append(Line(whole, level, move.choice, 1 if move in self.branches else "grey", 1 + i % 2, width=1.2))
        lines = [*([title] if title else []), *(line.partition(" (")[0] for line in self.summary())]
        return Figure("\n".join(lines), (Panel(x, y, tuple(parts)),))

    def _values(self) -> list[float]:
        return [move.value for move in (*self.ranges, *self.branches, *self.contact_points)] or [self.result.estimates[self.name]]


def _rounded(change: float) -> float:
    """Two figures, no more than one behind the point; never -0."""
    return float(f"{round(change, 1):.2g}") + 0.0


def _named(moves: tuple[Move, ...]) -> list[str]:
    return [moves[0].choice, moves[-1].choice] if len(moves) > 2 else [move.choice for move in moves]


def find_moves(result: FitResult, name: str | None = None) -> Moves:
    """Repeat a fit with other ranges, branches and contact points.

    Parameters
    ----------
    result : FitResult
        Fit of elastic data; data in time have no range to choose.
    name : str, optional
        Name of the parameter; None is the first modulus without a prior.

    Returns
    -------
    Moves
        Estimates with each choice.

    Raises
    ------
    InvalidArgumentError
        The parameter is not free.

    Examples
    --------
    >>> depth = np.linspace(10e-9, 100e-9, 40)
    >>> film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(165e9, 0.22))
    >>> force = mdr.Contact(mdr.Paraboloid(10e-6), film).at_depth(depth).force
    >>> body = mdr.Homogeneous(mdr.Elastic(72e9, 0.17))
    >>> result = mdr.instruments.fit(mdr.instruments.ForceDepth(depth, force), mdr.Paraboloid(10e-6), body, ["E"])
    >>> print(mdr.instruments.find_moves(result).summary()[0])
    modulus E moves by -10 % to +0 % with the fitted range (up to depth 40 nm, up to depth 100 nm)
    """
    if name is not None and name not in result.names:
        raise InvalidArgumentError(f"{name!r} is not a free parameter: {nearest(str(name), result.names)}")
    chosen = name or next(
        (n for n in result.names if dimension_of(n) is MODULUS and not result.problem.free[n].prior), result.names[0]
    )
    if result.data.code > _layout.FIT_STIFFNESS_RADIUS or len(result.data) < _FEWEST:
        return Moves(result, chosen, (), (), ())
    kinds = [[*_ranges(result)], [*_branches(result)], [*_contact_points(result)]]
    moves = iter(share(lambda choice: _moved(result, chosen, *choice), [choice for kind in kinds for choice in kind]))
    return Moves(result, chosen, *(tuple(move for _ in kind if (move := next(moves)) is not None) for kind in kinds))


_Choice = tuple[str, float, Data, dict[str, float]]
"""Description, end of the range, data, fixed parameters."""


def _moved(result: FitResult, name: str, words: str, end: float, data: Data, held: dict[str, float]) -> Move | None:
    """The estimate with another choice; None if there is no such fit."""
    problem = result.problem
    values = [held.get(n, float(v)) for n, v in zip(problem.names, result._values, strict=True)]
    tip, body, tool = problem.pattern.at(np.array(values))
    free = {n: Free(None, lower=e.lower, upper=e.upper, prior=e.prior) for n, e in problem.free.items() if n not in held}
    options = dict(zip(_OPTIONS, problem.given[4:9], strict=True))
    data.also_free = ()
    try:
        found = fit(data, tip, body, free, instrument=tool, check_units=False, known=problem.given[10], **options)
    except MDRError:
        return None
    return Move(words, end, found.estimates[name], found.standard_errors[name]) if found.converged else None


def _part(data: Data, keep: NDArray[np.bool_]) -> Data:
    """Data with some of the points."""
    part = copy.copy(data)
    for column in ("x", "y", "given", "sd", "branch"):
        values = getattr(data, column)
        setattr(part, column, None if values is None else values[keep])
    part.warnings = []
    return part


def _ranges(result: FitResult) -> Iterator[_Choice]:
    data = result.data
    begin = result.values["depth_offset"] if data.x_name == "depth" else 0.0
    deepest, dimension = float(data.x.max()), QUANTITIES[data.x_name]
    for part in _PARTS:
        end = begin + part * (deepest - begin)
        keep = data.x <= end
        if np.sum(keep & (data.x > begin)) >= _FEWEST // 2:
            yield f"up to {data.x_name} {shown(end, dimension, 3)}", end, _part(data, keep), {}


def _branches(result: FitResult) -> Iterator[_Choice]:
    data = result.data
    if not isinstance(data, ForceDepth):
        return
    end = float(data.x.max())
    if data.branch is not None and len(np.unique(data.branch)) > 1:
        for words in ("loading", "unloading"):
            yield f"{words} alone", end, data.on(words), {}
    elif data.unused is not None:
        depth, force = data.unused[0], data.unused[1]
        if len(depth) > max(_FEWEST, _OF_BRANCH * len(data)):
            yield "the readings that are not used", end, ForceDepth(depth, force, branch="unloading"), {}


def _contact_points(result: FitResult) -> Iterator[_Choice]:
    if "depth_offset" not in result.names:
        return
    for estimator, at in result.data.contact_points.items():
        yield f"contact point by {estimator}", float(result.data.x.max()), copy.copy(result.data), {"depth_offset": at}
