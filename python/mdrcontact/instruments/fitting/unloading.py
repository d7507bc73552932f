# SPDX-License-Identifier: GPL-3.0-or-later
"""Unloading curves: the contact stiffness at the beginning of unloading (Oliver and Pharr 1992)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..._units import LENGTH, shown
from ..._warn import silence
from ...contact import Contact
from ...errors import InvalidArgumentError, MDRError
from ...material import Elastic
from ...medium import Homogeneous
from ...profile import PowerLaw
from ..records.segments import Segment, curve, effective_points, find_segments
from .causes import by_cause
from .data import REVERSIBLE, ForceDepth, StiffnessDepth, UnloadingPoint
from .parameters import Free
from .solve import fit

Array = NDArray[np.float64]

UPPER_PART = (0.4, 0.98)
"""Part of an unloading curve that ISO 14577-1 fits, relative to the largest force."""
_FEWEST = 8
_BEGINS, _ZERO, _GAIN = (0.01, 0.05), 0.03, 0.01
"""Start of loading over the largest force, zero over the depth, and effect of drift on the work over their product."""
_EXPONENTS = 1.1, 2.0
"""The power of unloading curves of homogeneous bodies is between those of a punch and a cone."""
_VAGUE, _NONE, _STEEPEST = 0.03, 0.5, 4.0
"""Relative standard errors of the stiffness beyond which readings determine no power, or no stiffness; the largest power."""
_LEAST = 1e-12
"""Slope, in parts of the force over the depth."""
_SHARPEST = 0.3
"""Least exponent of the indenter whose force the curve follows: soft films on stiff bodies have powers of 2 to 4, a cone 2."""


def _unloading_point(h: Array, p: Array, largest: float, upper_part: tuple[float, float]) -> UnloadingPoint:
    """Stiffness at the largest force of one unloading curve."""
    low, high = upper_part
    if not largest > 0.0:
        raise InvalidArgumentError("the forces of the unloading curve are not positive: it has no upper part")
    h_part, p_part = _part(h, p, low * largest, high * largest)
    if len(h_part) < _FEWEST:
        raise InvalidArgumentError(
            f"too few points between {100 * low:g} and {100 * high:g} % of the largest force of the unloading curve: "
            f"{len(h_part)}; "
            f"at least {_FEWEST} are needed"
        )
    if float(np.polyfit(h_part, p_part, 1)[0]) <= 0.0:
        raise InvalidArgumentError(
            "the depth grows while the force falls: creep or drift is stronger than the unloading. Hold longer before "
            "unloading, or "
            "correct the drift"
        )
    law = _law(h_part, p_part, largest)
    return UnloadingPoint(
        law.depth,
        largest,
        law.stiffness,
        law.error,
        law.final,
        law.exponent,
        h_part,
        p_part,
        tuple(_doubts(law, low, high, h, p, largest)),
    )


def _part(h: Array, p: Array, low: float, high: float) -> tuple[Array, Array]:
    """The points between two forces, the first time that the curve passes them."""
    above = np.flatnonzero(p > high)
    start = int(above[-1]) + 1 if len(above) else 0
    below = np.flatnonzero(p[start:] < low)
    part = slice(start, start + int(below[0]) if len(below) else len(p))
    return h[part], p[part]


class _Law(NamedTuple):
    """Depth and stiffness at the largest force, its standard error, h_f and m."""

    depth: float
    stiffness: float
    error: float
    final: float
    exponent: float


def _law(h: Array, p: Array, largest: float) -> _Law:
    """A power law where the readings determine its power. Where they do not, its stiffness is too large in the mean, or there is
    none: there a parabola, whose stiffness is linear in the readings, and so without a bias from their noise."""
    parabola = _parabola(h, p, largest)
    if not parabola.error < _NONE * parabola.stiffness:
        raise InvalidArgumentError(
            f"the {len(h)} readings of an unloading curve do not determine a stiffness: it is too short, or too noisy"
        )
    if parabola.error > _VAGUE * parabola.stiffness:
        return parabola
    try:
        return _power_law(h, p, largest)
    except InvalidArgumentError:
        return parabola


def _parabola(h: Array, p: Array, largest: float) -> _Law:
    """Least squares of P = a + b h + c h^2, and the power law that has its slope and curvature at the largest force."""
    scale, lowest = float(np.ptp(h)), float(h.min())
    x, y = (h - lowest) / scale, p / largest
    design = np.column_stack([np.ones_like(x), x, x**2])
    inverse = np.linalg.pinv(design)
    a, b, c = inverse @ y
    # the largest force by the straight line, and one step of Newton from there: a parabola need not reach it
    line = np.polyfit(x, y, 1)
    top = float((1.0 - line[1]) / line[0])
    top += float((1.0 - a - b * top - c * top**2) / max(b + 2.0 * c * top, 0.5 * line[0]))
    row = np.array([0.0, 1.0, 2.0 * top]) @ inverse
    left = y - design @ (a, b, c)
    worth = effective_points(left[np.argsort(x)])
    noise = float(left @ left) / max(len(x) - design.shape[1], 1) * len(x) / worth
    slope, bend = float(b + 2.0 * c * top), float(2.0 * c)
    # m/(m - 1) = S^2/(P P''): a straight line where it does not bend upward
    part = min(max(bend / slope**2, 0.0), 1.0 - 1.0 / _STEEPEST) if slope > 0.0 else 0.0
    power = 1.0 / (1.0 - part)
    final = top - power / max(slope, _LEAST)
    unit = largest / scale
    error = math.sqrt(noise * float(row @ row))
    return _Law(lowest + scale * top, slope * unit, error * unit, lowest + scale * final, power)


@silence()
def _power_law(h: Array, p: Array, largest: float) -> _Law:
    """P = B (h - h_f)^m is the force of an indenter f = r^n, n = 1/(m - 1), on a homogeneous body (Pharr and Bolshakov 2002): the
    fit of that contact gives the covariance too."""
    scale = float(np.ptp(h))
    x, y = (h - h.min()) / scale, p / largest
    # the power 1.5 to begin with
    steepness, height = np.polyfit(x, np.maximum(y, 0.0) ** (1.0 / 1.5), 1)
    begins = min(-height / steepness, -0.01)
    body = Homogeneous(Elastic(1.0, 0.0))
    modulus = 1.0 / float(Contact(PowerLaw(2.0, 1.0), body).at_depth(1.0 - begins).force)
    found = fit(
        ForceDepth(x, y, branch="unloading"),
        PowerLaw(2.0, 1.0),
        body,
        {"E": modulus, "indenter.exponent": Free(lower=_SHARPEST, upper=30.0), "depth_offset": begins},
        check_units=False,
    )

    def top(values: Array) -> tuple[float, float]:
        """Depth and stiffness at the largest force."""
        by_name = dict(zip(found.names, values, strict=True))
        indenter = PowerLaw(by_name["indenter.exponent"], 1.0)
        state = Contact(indenter, Homogeneous(Elastic(by_name["E"], 0.0))).at_force(1.0)
        return float(state.depth) + by_name["depth_offset"], float(state.stiffness)

    best = np.array([found.estimates[name] for name in found.names])
    steps = 1e-3 * np.sqrt(np.diag(found.covariance))
    pairs = zip(np.diag(steps), steps, strict=True)
    try:
        gradient = [(top(best + step)[1] - top(best - step)[1]) / (2.0 * size) if size > 0.0 else 0.0 for step, size in pairs]
    except MDRError:
        raise InvalidArgumentError(
            f"the {len(h)} readings of an unloading curve do not determine a stiffness: it is too short, or too noisy"
        ) from None
    error = math.sqrt(max(float(np.array(gradient) @ found.covariance @ np.array(gradient)), 0.0))
    depth, stiffness = top(best)
    unit = largest / scale
    lowest = float(h.min())
    return _Law(
        lowest + scale * depth,
        stiffness * unit,
        error * unit,
        lowest + scale * found.estimates["depth_offset"],
        1.0 + 1.0 / found.estimates["indenter.exponent"],
    )


def _doubts(law: _Law, low: float, high: float, h: Array, p: Array, largest: float) -> list[str]:
    """Doubts about the stiffness."""
    words = []
    if not _EXPONENTS[0] < law.exponent < _EXPONENTS[1]:
        words.append(
            f"the unloading curve has the power {law.exponent:.3g}; those of homogeneous bodies lie between {_EXPONENTS[0]} and "
            f"{_EXPONENTS[1]}: check its upper part for creep, drift or a pop-out, unless the film is much softer than its base"
        )
    half = 0.5 * (low + high)
    h_half, p_half = _part(h, p, half * largest, high * largest)
    if len(h_half) < _FEWEST:
        return words
    try:
        upper = _law(h_half, p_half, largest)
    except MDRError:
        return words
    shift, spread = upper.stiffness / law.stiffness - 1.0, math.hypot(upper.error, law.error) / law.stiffness
    if abs(shift) > max(3.0 * spread, 0.01):
        words.append(
            f"the stiffness changes by {100.0 * shift:+.1f} % if only the part above {100.0 * half:.0f} % of the force is "
            "fitted, more "
            "than its standard error: creep or drift bends the curve"
        )
    return words


def _doubts_of_record(h: Array, p: Array, first: Segment) -> list[str]:
    """Whether depths begin at contact and the rows are in the order of measurement, if loading is in the record."""
    rise, deepest = float(np.ptp(p)), float(np.ptp(h))
    if first.kind == "unloading" and p[0] > p.min() + _BEGINS[1] * rise:
        return ["the record begins with unloading: its first reading is taken as the largest force of the test"]
    lift = p - p.min()
    if first.kind != "loading" or lift[0] > _BEGINS[0] * rise:
        return []
    words = []
    # loading is a power of the depth between 1 and 2: two points near its start bound the position of the start
    (h1, h2), (p1, p2) = (v[[int(np.argmax(lift > part * rise)) for part in _BEGINS]] for v in (h, lift))
    steepness = max(float(p2 / p1), 1.0 + 1e-9)
    low, high = (float(h1 - (h2 - h1) / (steepness ** (1.0 / power) - 1.0)) for power in (2.0, 1.0))
    if not low - _ZERO * deepest < 0.0 < high + _ZERO * deepest:
        words.append(
            f"contact begins at a depth between {shown(low, LENGTH)} and {shown(high, LENGTH)}, not at 0: contact depth and area "
            "are wrong by as much. Subtract it from the depths, or let the contact point be found"
        )
    # the work of loading is dissipated, or returned in part
    if float(0.5 * (p[1:] + p[:-1]) @ np.diff(h)) < -_GAIN * rise * deepest:
        words.append("unloading gives back more work than loading took: the rows seem to be in reverse order")
    return words


def _gives_back(h: Array, p: Array, segments: list[Segment]) -> bool:
    """Whether every unloading gives back the work of the loading before it, over the depths that both have."""
    ways: list[tuple[Array, Array]] = []
    found = False
    for part in segments:
        ways.append((h[part.points], p[part.points]))
        if part.kind != "unloading":
            continue
        loading = [way for way, of in zip(ways, segments, strict=False) if of.kind == "loading"]
        if not loading:
            return False
        low = max(float(ways[-1][0].min()), float(loading[-1][0].min()))
        x = np.linspace(low, min(float(ways[-1][0].max()), float(loading[-1][0].max())), 200)
        work, back = (
            float(np.interp(x, d[order], f[order]).sum()) for d, f in (loading[-1], ways[-1]) for order in [np.argsort(d)]
        )
        if not abs(back - work) < REVERSIBLE * work:
            return False
        found = True
    return found


class Unloading(StiffnessDepth):
    """Contact stiffness S = dP/dh at the beginning of unloading curves.

    Each curve is one point. S follows from a power law through the upper part of each curve. In a fit the points are
    `StiffnessDepth` data. `unloadings` are the results of each curve; `unused_unloadings` are the curves without a result, with the
    error.

    Parameters
    ----------
    depth : array_like
        Depths of one curve, or of a record with loading, holds and one or more unloadings, in the order of measurement [length].
    force : array_like
        Forces, as many [modulus length^2].
    upper_part : tuple of float, optional
        Lower and upper end of the fitted part, in units of the largest force of the curve, 0 < lower < upper <= 1 [1].
    elastic : bool, optional
        As in `StiffnessDepth`; None: True if the record includes loading, and unloading returns its work to 5 %.
    segments : sequence of Segment, optional
        Segments of the record, if the file marks them; None finds them with `segmentation`.

    Raises
    ------
    InvalidArgumentError
        No unloading curve can be used, or `upper_part` is outside its range.

    References
    ----------
    oliver-1992

    Examples
    --------
    >>> depth = np.concatenate([np.linspace(0.0, 100e-9, 60), np.linspace(100e-9, 60e-9, 60)])
    >>> force = 1e-3 * np.concatenate([np.linspace(0.0, 1.0, 60) ** 2, np.linspace(1.0, 0.0, 60) ** 1.5])
    >>> data = mdr.instruments.Unloading(depth, force)
    >>> print(data.found_and_used(), f"{data.y[0]:.4e}")
    ['1 unloadings, 1 used'] 3.7500e+04
    """

    def __init__(
        self,
        depth: ArrayLike,
        force: ArrayLike,
        *,
        upper_part: tuple[float, float] = UPPER_PART,
        elastic: bool | None = None,
        segments: Sequence[Segment] | None = None,
    ) -> None:
        h, p = curve(depth, force, fewest=_FEWEST)
        if not (len(upper_part) == 2 and 0.0 < upper_part[0] < upper_part[1] <= 1.0):
            raise InvalidArgumentError(f"upper_part = {upper_part!r}: it must be two numbers with 0 < lower < upper <= 1")
        parts = list(find_segments(h, p) if segments is None else segments)
        points: list[UnloadingPoint] = []
        self.unused_unloadings: list[tuple[Segment, str]] = []
        for i in unloading_parts(parts, p, upper_part[0]):
            try:
                points.append(_unloading_point(h[parts[i].points], p[parts[i].points], _largest(parts, i, p), upper_part))
            except InvalidArgumentError as problem:
                self.unused_unloadings.append((parts[i], str(problem)))
        if not points and len(self.unused_unloadings) == 1:
            raise InvalidArgumentError(self.unused_unloadings[0][1])
        if not points:
            why = f": {self.unused_unloadings[0][1]}" if self.unused_unloadings else ": the force does not fall from a large value"
            raise InvalidArgumentError(f"there is no unloading curve that can be used{why}")
        columns = zip(*((q.depth, q.force, q.stiffness) for q in points), strict=True)
        super().__init__(*map(list, columns), sd=[q.stiffness_error for q in points], elastic=elastic)
        self.seems_elastic = _gives_back(h, p, parts)
        self.unloadings = tuple(points)
        self.record = h, p
        several = [(f"unloading {i}", words) for i, q in enumerate(points, start=1) for words in q.warnings]
        self.warnings += [*_doubts_of_record(h, p, parts[0]), *(by_cause(several) if len(points) > 1 else points[0].warnings)]

    def found_and_used(self) -> list[str]:
        """Return how many unloading curves are found and used, with the reasons.

        Returns
        -------
        list of str
            One line for each fact.
        """
        count = len(self.unloadings)
        words = [f"{count + len(self.unused_unloadings)} unloadings, {count} used"]
        words += [f"unloading of readings {s.start}-{s.stop - 1} is not used: {why}" for s, why in self.unused_unloadings]
        return words


def unloading_parts(parts: Sequence[Segment], p: Array, least: float) -> list[int]:
    """Places of the segments that unload from where loading ended; what follows an unloading belongs to it, and a record that
    begins with little force begins with a lift-off."""
    found = []
    for i, part in enumerate(parts):
        before = next((s.kind for s in reversed(parts[:i]) if s.kind != "hold"), None)
        begins_high = p[part.points].max() >= p.min() + least * np.ptp(p)
        if part.kind == "unloading" and (before == "loading" or before is None and begins_high):
            found.append(i)
    return found


def _largest(parts: Sequence[Segment], i: int, p: Array) -> float:
    """The force from which a segment unloads: that of the hold before it, or the largest, which ends the loading before it."""
    held = i > 0 and parts[i - 1].kind == "hold"
    begin = max(parts[i].start - 1, 0)
    return float(np.median(p[parts[i - 1].points]) if held else p[begin : parts[i].stop].max())
