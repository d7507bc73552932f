# SPDX-License-Identifier: GPL-3.0-or-later
"""From the record of an instrument to depth and force of a contact, as described by [data] of a problem file."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..._units import ENERGY, FORCE, LENGTH, SPEED, shown
from ...errors import MDRError
from ...problem.section import ProblemError, Section
from ..records import (
    PopIn,
    Segment,
    depth_from_height,
    drift_rate,
    find_baseline,
    find_contact_point,
    find_pop_in,
    find_strays,
    segmentation,
    without_drift,
)
from ..records.contact_point import FEWEST, METHODS, SOURCES, deflection_sign, height_sign
from ..records.pull import Parting, Pull, find_parting, find_pull
from ..records.segments import joined

Array = NDArray[np.float64]

_LITTLE = 0.01
"""Fraction of the force below which a tilt of the baseline is not reported."""
_MANY_LOST = 0.1
_PASSES = 3
"""Single readings hide behind others that stray further."""


class Cantilever(NamedTuple):
    """Constants that convert a deflection into lengths and forces; None where the file does not state them."""

    deflection_sensitivity: float | None = None
    """[m/V]"""
    spring_constant: float | None = None
    """[N/m]"""


@dataclass
class Record:
    """One curve in the order of measurement, SI units: force against depth, or against the height of the piezo, with what was
    done."""

    depth: Array | None
    force: Array
    height: Array | None
    time: Array | None
    notes: list[str]
    """notes on how the record was interpreted"""
    warnings: list[str] = field(default_factory=list)
    """warnings about it"""
    sd: Array | None = None
    sign: int | None = None
    """of the height, 1 if it grows into the sample; None: to be found"""
    contact_points: dict[str, float] = field(default_factory=dict)
    """depth of first contact by each estimator, from the zero that is used"""
    pulls: dict[str, Pull] = field(default_factory=dict)
    """"jump-in" and "pull-off", where the record has them"""
    parting: Parting | None = None
    """where it has a pull-off and both branches"""
    also_free: tuple[str, ...] = ()
    """offsets that the fit finds, whether it names them or not"""
    segments: Sequence[Segment] | None = None
    """as the file states them; None: determined from the readings"""
    unused: list[tuple[Array, Array]] = field(default_factory=list)
    """depths and forces that are not used"""
    contact: int = 0
    """the reading at which contact begins"""
    readings: int = 0
    """in the file"""

    def __post_init__(self) -> None:
        self.readings = len(self.force)

    def keep(self, chosen: NDArray[np.bool_]) -> None:
        """Leaves out all other points."""
        if self.depth is not None:
            self.unused.append((self.depth[~chosen], self.force[~chosen]))
        for name in ("depth", "force", "height", "time", "sd"):
            values = getattr(self, name)
            if values is not None:
                setattr(self, name, values[chosen])
        if self.segments is not None:
            before = np.concatenate([[0], np.cumsum(chosen)])
            kept = (s._replace(start=int(before[s.start]), stop=int(before[s.stop])) for s in self.segments)
            self.segments = joined(s for s in kept if s.stop > s.start)

    def leave_out_strays(self) -> None:
        """Leaves out single readings of a height and its force that lie far from both neighbours: a piezo moves without steps."""
        place = np.arange(len(self.force))
        for _ in range(_PASSES if self.depth is None else 0):
            found = {what: find_strays(getattr(self, what), ends=True) for what in ("height", "force")}
            for what, strays in found.items():
                if len(strays):
                    at = ", ".join(str(place[i]) for i in strays[:5]) + (" and others" if len(strays) > 5 else "")
                    words = "lie far from both neighbours and are left out"
                    self.warnings.append(f"{len(strays)} of {self.readings} readings of the {what} {words}: {at}")
            kept = ~np.isin(np.arange(len(place)), np.concatenate([*found.values()]))
            if kept.all():
                return
            place = place[kept]
            self.keep(kept)

    def turn_deflection(self) -> None:
        """Gives a deflection, or its force, that falls as the tip is pressed the other sign; `sign` is that of a known file."""
        if self.depth is None and self.height is not None and self.sign is None and deflection_sign(self.height, self.force) < 0:
            self.force = -self.force
            self.notes.append("the deflection falls as the tip is pressed into the sample: its sign is turned")

    def parts(self) -> tuple[Sequence[Segment], str]:
        """The segments, and their source."""
        if self.segments is not None:
            return self.segments, "segments as the file has them"
        along = self.depth
        if along is None:
            assert self.height is not None
            along = (self.sign or height_sign(self.height, self.force)) * self.height
        found = segmentation(along, self.force)
        noise = f"noise {shown(found.noise[0], LENGTH, 3)} and {shown(found.noise[1], FORCE, 3)}"
        if found.unsure:
            begins = ", ".join(str(found.segments[i].start) for i in found.unsure[:5])
            noise += f"; the segments that begin at reading {begins} are uncertain: they hardly exceed the noise"
        return found.segments, f"segments by their readings ({noise})"

    def counts(self) -> str:
        """Number of readings used."""
        return f"{len(self.force)} of {self.readings} readings are used"


def prepare(section: Section, cantilever: Cantilever, record: Record, kind: str) -> None:
    """Depth from height, drift, contact point, baseline, pop-in and branch, in this order; notes list each step."""
    columns = [v for v in (record.depth, record.force, record.height, record.time, record.sd) if v is not None]
    finite = np.all([np.isfinite(v) for v in columns], axis=0)
    if not finite.all():
        record.keep(finite)
        lost = int((~finite).sum())
        told_as = record.warnings if lost > _MANY_LOST * len(finite) else record.notes
        told_as.append(f"{lost} of {len(finite)} rows have no number in a column that is needed and are left out")
    if len(record.force) < 2:
        raise ProblemError("there are fewer than two rows of numbers")
    record.leave_out_strays()
    record.turn_deflection()
    for what, values in (("depth", record.depth), ("force", record.force)):
        strays = find_strays([] if values is None else values)
        if len(strays):
            record.warnings.append(
                f"{len(strays)} readings of the {what} lie far from both neighbours, the first is reading {strays[0]}: lost "
                "digits, missing numbers written as 0, or rows out of order. Check the file"
            )
    is_raw = record.depth is None
    if is_raw:
        _subtract_deflection(cantilever, record)
    if "drift" in section:
        _subtract_drift(section, record)
    if is_raw or "contact_point" in section or "baseline" in section:
        _find_zero(section, record, is_raw, kind)
    if is_raw:
        _find_pulls(record)
    if section.value("before_pop_in"):
        _cut_at_pop_in(record)
    elif "branch" in section or is_raw:
        _mention_pop_in(record)
    if kind == "depth-time" and is_raw:
        _choose_creep(record)
    elif "branch" in section or is_raw and kind == "force-depth":
        _choose_branch(section, record)


def _depth(record: Record) -> Array:
    assert record.depth is not None
    return record.depth


def _subtract_deflection(cantilever: Cantilever, record: Record) -> None:
    if cantilever.spring_constant is None:
        rule = "the height of the piezo becomes a depth by the deflection, force over spring constant"
        raise ProblemError(f'{rule}: give [instrument] spring_constant = "0.2 N/m"').at("instrument", "spring_constant")
    assert record.height is not None
    record.depth = depth_from_height(record.height, record.force / cantilever.spring_constant, record.sign)
    record.notes.append("depth from height less deflection; the moduli are proportional to the spring constant")


def _subtract_drift(section: Section, record: Record) -> None:
    if record.time is None:
        rule = "drift needs the time of each reading, and this file has neither times nor one rate of sampling"
        raise section.error("drift", rule, "Leave drift out, or export depth, force and time as text", shows=False)
    falls = np.flatnonzero(np.diff(record.time) < 0.0)
    if len(falls):
        rule = f"drift needs times that rise from reading to reading, and they fall after reading {falls[0]}"
        raise section.error("drift", rule, shows=False)
    depth = _depth(record)
    if section.plain("drift") != "hold":
        rate, error = section.quantity("drift"), 0.0
    else:
        largest = record.force.max()
        holds = [s for s in record.parts()[0] if s.kind == "hold" and np.median(record.force[s.points]) < 0.5 * largest]
        if not holds:
            rule = "there is no hold below half of the largest force"
            raise section.error("drift", rule, 'Give the rate, as in "0.05 nm/s"')
        rate, error = drift_rate(record.time[holds[-1].points], depth[holds[-1].points])
    record.depth = without_drift(record.time, depth, rate)
    whole = rate * float(np.ptp(record.time))
    words = f"drift {shown(rate, SPEED)}" + (f" ± {shown(error, SPEED)}" if error else "")
    record.notes.append(f"{words}, {shown(whole, LENGTH)} over the whole test, is subtracted")


def _approach(record: Record) -> slice:
    """The points up to the largest force."""
    return slice(0, int(np.argmax(record.force)) + 1)


def first_loading(record: Record) -> slice:
    """The points up to the first unloading of a record of cycles: later ones lie on other curves."""
    whole = _approach(record)
    first = next((s.start for s in record.parts()[0] if s.kind == "unloading"), whole.stop)
    return slice(0, first) if FEWEST <= first < whole.stop else whole


def _find_zero(section: Section, record: Record, is_raw: bool, kind: str) -> None:
    depth, approach = _depth(record), _approach(record) if is_raw else first_loading(record)
    usual = ("fit" if kind == "force-depth" else METHODS[0]) if is_raw else "given"
    method = section.value("contact_point", kind=kind) or usual
    baseline = section.value("baseline") or ("offset" if is_raw else "none")
    if method == "given" and baseline == "none":
        return
    try:
        found = {name: find_contact_point(depth[approach], record.force[approach], name) for name in METHODS}
        contact = found[method if method in METHODS else METHODS[0]]
        if baseline != "none":
            _take_off_baseline(record, approach, contact, baseline == "tilt")
    except MDRError as problem:
        raise ProblemError(
            f'contact point and baseline cannot be found: {problem}; say contact_point = "given" and baseline = "none" for a '
            "curve that begins in contact"
        ).at(section.path, "contact_point") from problem
    if method == "given":
        return
    zero = float(depth[contact])
    record.depth = depth - zero
    record.contact = contact
    record.contact_points = {name: float(depth[i]) - zero for name, i in found.items()}
    begins = METHODS[0] if method == "fit" else method
    others = ", ".join(
        f"{shown(at, LENGTH)} from it by {name} ({SOURCES[name]})" for name, at in record.contact_points.items() if name != begins
    )
    record.notes.append(f"contact point by {begins} ({SOURCES[begins]}), reading {contact}; {others}")
    if method == "fit":
        record.also_free = ("depth_offset", "force_offset")
        record.notes.append("the remaining offsets of contact point and baseline are free: depth_offset and force_offset")


def _find_pulls(record: Record) -> None:
    """Find the results of approach and retract that need no model, for a record with its baseline."""
    depth, top = _depth(record), int(np.argmax(record.force))
    for name, part in (("jump-in", slice(0, top + 1)), ("pull-off", slice(top, None))):
        try:
            found = find_pull(depth[part], record.force[part])
        except MDRError:
            continue
        if found is not None:
            record.pulls[name] = found
            record.notes.append(f"{name}: {shown(found.force, FORCE)} at depth {shown(found.depth, LENGTH)}, before any fit")
    with suppress(MDRError):
        record.parting = find_parting(depth, record.force)
    if record.parting is not None:
        at, energy = shown(record.parting.rupture_depth, LENGTH), shown(record.parting.energy, ENERGY)
        record.notes.append(f"last rupture at depth {at}, energy lost {energy}, before any fit")


def _take_off_baseline(record: Record, approach: slice, contact: int, tilts: bool) -> None:
    depth = _depth(record)
    tilted = find_baseline(depth[approach], record.force[approach], contact)
    line = tilted if tilts else find_baseline(depth[approach], record.force[approach], contact, tilt=False)
    whole = tilted.tilt * float(np.ptp(depth))
    share = abs(whole) / float(np.ptp(record.force))
    record.force = record.force - line.at(depth)
    left = "" if tilts or share < _LITTLE else ', which remains: baseline = "tilt" subtracts it'
    record.notes.append(
        f"baseline: offset {shown(float(line.at(depth)[contact]), FORCE)} at contact, noise {shown(line.noise, FORCE)}, subtracted"
        f"; its tilt makes {shown(whole, FORCE)} over the curve, {100.0 * share:.2g} % of the force{left}"
    )


def _pop_in(record: Record) -> PopIn | None:
    """Pop-in of the points up to the largest force; None for a curve that begins there."""
    approach = _approach(record)
    return find_pop_in(_depth(record)[approach], record.force[approach]) if approach.stop > 2 else None


def _cut_at_pop_in(record: Record) -> None:
    pop_in = _pop_in(record)
    if pop_in is None:
        record.notes.append("no pop-in: the whole curve is used")
        return
    record.keep(np.arange(len(record.force)) <= pop_in.position)
    record.notes.append(
        f"pop-in of {shown(pop_in.jump, LENGTH)} at depth {shown(pop_in.depth, LENGTH)}, force {shown(pop_in.force, FORCE)}: the "
        f"{pop_in.position + 1} points before it are used"
    )


def _mention_pop_in(record: Record) -> None:
    pop_in = _pop_in(record)
    if pop_in is not None:
        record.notes.append(
            f"pop-in of {shown(pop_in.jump, LENGTH)} at depth {shown(pop_in.depth, LENGTH)}, force "
            f"{shown(pop_in.force, FORCE)}: only before it was the contact elastic. [data] before_pop_in = true uses that part"
        )


def _choose_branch(section: Section, record: Record) -> None:
    branch = section.value("branch") or "loading"
    kinds = ("loading", "unloading") if branch == "both" else (branch,)
    segments, words = record.parts()
    keep = np.zeros(len(record.force), dtype=bool)
    depth = _depth(record)
    for kind in kinds:
        # the longest: others are overshoot and ripples
        longest = max((s for s in segments if s.kind == kind), key=lambda s: float(np.ptp(depth[s.points])), default=None)
        if longest is not None:
            keep[longest.points] = True
    words = f"{words}: {', '.join(f'{s.kind} {s.start}-{s.stop - 1}' for s in segments)}"
    if keep.sum() < 2:
        rule = f"the curve has {int(keep.sum())} readings of branch = {branch!r}; {words}; loading goes up"
        raise section.error("branch", rule, shows=False)
    record.keep(keep)
    usual = "" if "branch" in section else ', the approach; branch = "both" takes the retract too, where adhesion pulls off'
    record.notes.append(f"{words}; {int(keep.sum())} readings of {branch} are used{usual}")


def _choose_creep(record: Record) -> None:
    """Select the readings of a creep test from first contact to the end of the hold: without contact no force determines the depth,
    and under a falling force adhesion holds the contact."""
    segments, words = record.parts()
    top = int(np.argmax(record.force))
    end = next((s.start for s in segments if s.kind == "unloading" and s.start > top), len(record.force))
    place = np.arange(len(record.force))
    keep = (place >= record.contact) & (place < end)
    if keep.sum() < 2:
        raise ProblemError(f"{int(keep.sum())} readings lie between contact and unloading; {words}")
    record.keep(keep)
    record.notes.append(
        f"{words}; from contact, reading {record.contact}, {int(keep.sum())} readings of approach and hold are used"
    )
