# SPDX-License-Identifier: GPL-3.0-or-later
"""Warnings about the states of a contact: large strains, moduli in two units, several contact areas, inaccurate fields."""

from __future__ import annotations

import math
import threading
from collections.abc import Collection, Iterable
from typing import Any

import numpy as np

from . import _layout, interior
from ._warn import Caution, is_collected, is_silent, warn
from .errors import (
    InteriorAccuracyWarning,
    LargeStrainWarning,
    MDRError,
    NoConvergenceError,
    SeparationInsideWarning,
    ShortZoneWarning,
    UnitsWarning,
)
from .profile import Paraboloid

__all__: list[str] = []

_NOTICEABLE = 1e-4
"""Fraction of the mean pressure, or of the depth, beyond which a negative pressure, or an overlap, exceeds the solver error."""
_DEEPER = 1.2
"""States this much deeper than those examined before are checked for warnings."""
_BEYOND = np.geomspace(1.1, 60.0, 30)
"""Radii, in contact radii, at which the surface outside the contact is examined."""

_WARNINGS = {
    _layout.WARNING_SLOPE: LargeStrainWarning,
    _layout.WARNING_PRESSURE: LargeStrainWarning,
    _layout.WARNING_COMPRESSION: LargeStrainWarning,
    _layout.WARNING_CONTRAST: UnitsWarning,
    _layout.WARNING_SHORT_ZONE: ShortZoneWarning,
    _layout.WARNING_WETTING: LargeStrainWarning,
}
"""Warnings about a state, in the order of the library."""
_DEVIATES = (
    "displacements and stresses inside have an error of about {:.1e} of the depth and of the largest pressure: "
    "on the surface they differ by this from the displacement and the pressure of the contact"
)


class StateWarnings:
    """Finds the warnings about the states of one contact. They depend on the state alone."""

    def __init__(self, contact: Any) -> None:
        may_bend = getattr(contact.medium, "model", None) == "exact" or _has_plate(contact.medium)
        self.may_open = contact.work_of_adhesion == 0.0 and may_bend and not isinstance(contact.indenter, Paraboloid)
        """whether its states may not be a single contact area, which an examination of each decides"""

    def about(self, states: Any) -> list[Caution]:
        """Warnings about the deepest of the states, one of each kind at most."""
        shape = np.shape(states.depth)
        if shape and not np.size(states.depth):
            return []
        deepest = states[np.unravel_index(np.argmax(states.depth), shape)] if shape else states
        codes, texts = deepest._cautions()
        kinds = [kind for code, kind in _WARNINGS.items() if codes & code]
        return [Caution(text, kind) for text, kind in zip(texts, kinds, strict=True)]

    def one_disc(self, states: Any, skipped: Collection[int] = ()) -> tuple[list[Caution], set[int]]:
        """Examine whether the contact is a single area, in the largest of the states and some smaller ones, except skipped sizes.
        Also the sizes that were examined."""
        looked_at: set[int] = set()
        radii = np.ravel(states.radius)
        if not self.may_open or not radii.size:
            return [], looked_at
        order = np.argsort(radii)
        for place in order[[-1, len(order) // 2, len(order) // 4]]:
            size = _size(float(radii[place]))
            if size is None or size in skipped or size in looked_at:
                continue
            looked_at.add(size)
            shape = np.shape(states.radius)
            fault = _fault(states[np.unravel_index(place, shape)] if shape else states)
            if fault:
                off = (
                    "nor are depth and force: a plate does not follow a tip or a flank that no plate can take the shape of"
                    if _has_plate(states._owner.medium)
                    else "F(d) has an error of at most a few per cent where the coating is up to 200 times stiffer than the body"
                )
                text = (
                    f"this contact is not a single area: {fault} (contact radius {radii[place]:.3g}). Its pressure is not "
                    f"that of the true contact; {off}"
                )
                return [Caution(text, SeparationInsideWarning)], looked_at
        return [], looked_at

    def inside(self, state: Any, body: str) -> tuple[list[Caution], float]:
        """Return warnings about a field inside, and its deviation from the contact at the surface."""
        deviation = interior.deviation(state, body)
        if deviation <= max(interior.USUAL, interior.TOLERANCES * state._owner.medium._tolerance()):
            return [], deviation
        return [Caution(_DEVIATES.format(deviation), InteriorAccuracyWarning)], deviation

    def inside_or_refused(self, state: Any, body: str) -> list[Caution]:
        """Return the warnings of `inside`; raise for a wrong field."""
        found, deviation = self.inside(state, body)
        if deviation > interior.WRONG:
            raise NoConvergenceError(_DEVIATES.format(deviation))
        return found


class Reported:
    """Warnings that the user has already read about one contact, each kind once. Neither results of a contact nor
    their warnings depend on it."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._seen = -math.inf
        """depth up to which no state needs to be examined"""
        self._kinds: set[type[Warning]] = set()
        self._sizes: set[int] = set()
        """of contacts examined for a single contact area"""
        self._points: tuple[tuple[str | float, ...], int] = ((), 0)
        """of the last body and state evaluated at few points: how many so far"""

    def report(self, cautions: Iterable[Caution]) -> None:
        """Warns of what is new; of all to a computation that collects."""
        for caution in cautions:
            with self._lock:
                is_new = is_collected() or caution.kind not in self._kinds
                if not is_collected():
                    self._kinds.add(caution.kind)
            if is_new:
                warn(*caution)

    def of(self, states: Any) -> None:
        """Warnings about states that were just made, if they are deeper than those before."""
        if is_collected():
            if not is_silent():
                self.report(states.contact._doubts.about(states))
            return
        depth = states.depth
        deepest = depth if isinstance(depth, float) else float(depth.max(initial=-math.inf))
        if deepest > self._seen:
            self.report(states.contact._doubts.about(states))
            with self._lock:
                self._seen = max(self._seen, _DEEPER * deepest, 0.0)

    def one_disc(self, states: Any) -> None:
        """Report contacts that are not a single area, once at a radius of about that size."""
        doubts = states.contact._doubts
        if not doubts.may_open or is_silent():
            return
        if is_collected():
            self.report(doubts.one_disc(states)[0])
        elif SeparationInsideWarning not in self._kinds:
            found, sizes = doubts.one_disc(states, frozenset(self._sizes))
            with self._lock:
                self._sizes |= sizes
            self.report(found)

    def inside(self, state: Any, body: str, points: int) -> None:
        """A field that was given at few points at a time: it is compared once they are many."""
        key: tuple[str | float, ...] = (body, *state._row())
        with self._lock:
            before = self._points[1] if self._points[0] == key else 0
            so_far = before + points
            self._points = key, so_far
        if before < interior.ENOUGH_POINTS <= so_far or (is_collected() and so_far >= interior.ENOUGH_POINTS):
            self.report(state._owner._doubts.inside(state, body)[0])


def _size(radius: float) -> int | None:
    """Radii within a fifth of each other have one size, mostly."""
    return round(4.0 * math.log2(radius)) if radius > 0.0 else None


def _fault(state: Any) -> str:
    """Describe where a state is under tension, or its surface outside passes through the indenter; empty if neither."""
    try:
        pressure, r = state.lowest_pressure()
        if pressure * math.pi * float(state.radius) ** 2 < -_NOTICEABLE * float(state.force):
            return f"without adhesion its pressure would be {pressure:.3g} at r = {r:.3g}"
        beyond = float(state.radius) * _BEYOND
        gap = np.asarray(state.displacement(beyond) - state.depth + state._owner.indenter.height(beyond))
    except MDRError:
        return ""
    place = int(np.argmin(gap))
    if gap[place] >= -_NOTICEABLE * float(state.depth):
        return ""
    return f"the surface beyond it would pass through the indenter, by {-gap[place]:.3g} at r = {beyond[place]:.3g}"


def _has_plate(medium: Any) -> bool:
    """Return whether the surface of a medium has a plate."""
    return getattr(getattr(medium, "surface", None), "bending", 0.0) > 0.0
