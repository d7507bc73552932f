# SPDX-License-Identifier: GPL-3.0-or-later
"""What a contact has warned about: large strains, moduli in two units, contacts that are not one disc, poor fields inside."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from . import _layout, interior
from ._warn import warn
from .errors import (
    InteriorAccuracyWarning,
    LargeStrainWarning,
    MDRError,
    NoConvergenceError,
    NotOneDiscWarning,
    ShortZoneWarning,
    UnitsWarning,
)
from .profile import Paraboloid

__all__: list[str] = []

_NOTICEABLE = 1e-4
"""A negative pressure of this part of the mean pressure is more than the solver's error; of the depth, an overlap."""
_DEEPER = 1.2
"""States this much deeper than those looked at before are checked for doubts."""
_BEYOND = np.geomspace(1.1, 60.0, 30)
"""Radii, in contact radii, at which the surface beyond the contact is looked at."""

_WARNINGS = {
    _layout.WARNING_SLOPE: LargeStrainWarning,
    _layout.WARNING_PRESSURE: LargeStrainWarning,
    _layout.WARNING_COMPRESSION: LargeStrainWarning,
    _layout.WARNING_CONTRAST: UnitsWarning,
    _layout.WARNING_SHORT_ZONE: ShortZoneWarning,
    _layout.WARNING_WETTING: LargeStrainWarning,
}
"""Doubts about a state, in the order of the library's sentences."""


class Doubts:
    """The doubts that one contact has raised."""

    def __init__(self, contact: Any) -> None:
        self.seen = -math.inf
        """depth up to which no state needs to be looked at"""
        self._given: set[type[Warning]] = set()
        may_bend = getattr(contact.medium, "model", None) == "exact" or _has_plate(contact.medium)
        self.may_open = contact.work_of_adhesion == 0.0 and may_bend and not isinstance(contact.indenter, Paraboloid)
        """whether its states may not be one disc, which is not known yet"""
        self._sizes: set[int] = set()
        self._compared: dict[tuple[str | float, ...], tuple[int, float | None]] = {}
        """of the last body and state looked into: points so far, and their deviation on the surface once it is known"""

    def of(self, states: Any) -> None:
        """Gives a warning of each kind that was not given yet, of the deepest of the states."""
        shape = np.shape(states.depth)
        deepest = states[np.unravel_index(np.argmax(states.depth), shape)] if shape else states
        self.seen = max(_DEEPER * float(deepest.depth), 0.0)
        codes, texts = deepest._cautions()
        for text, kind in zip(texts, (kind for code, kind in _WARNINGS.items() if codes & code), strict=True):
            self._give(text, kind)

    def look(self, states: Any) -> None:
        """Warns where the contact is not one disc: looks at the largest of the states and at some smaller ones, at a radius of
        about the same size only once."""
        radii = np.ravel(states.radius)
        order = np.argsort(radii)
        for place in order[[-1, len(order) // 2, len(order) // 4]] if len(order) else ():
            size = round(4.0 * math.log2(radii[place])) if radii[place] > 0.0 else None
            if size is None or size in self._sizes:
                continue
            self._sizes.add(size)
            state = states[np.unravel_index(place, np.shape(states.radius))] if np.shape(states.radius) else states
            fault = _fault(state)
            if fault:
                self.may_open = False
                off = (
                    "nor are depth and force: a plate does not follow a tip or a flank that no plate can take the shape of"
                    if _has_plate(state._owner.medium)
                    else "F(d) is off by at most a few per cent where the coating is up to 200 times stiffer than the body"
                )
                warn(
                    f"this contact is not one disc: {fault} (contact radius {radii[place]:.3g}). Its pressure is not that of the "
                    f"true contact; {off}",
                    NotOneDiscWarning,
                )
                return

    def compare(self, contact: Any, row: list[float], body: str, points: int) -> None:
        """Warns of a field inside that deviates from the surface of its contact, or refuses it."""
        key: tuple[str | float, ...] = (body, *row)
        so_far, deviation = self._compared.get(key, (0, None))
        if deviation is None:
            so_far += points
            if so_far >= interior.ENOUGH_POINTS:
                deviation = interior.deviation(contact._handle, row, body)
            self._compared = {key: (so_far, deviation)}
        if deviation is None or deviation <= max(interior.USUAL, interior.TOLERANCES * contact.medium._tolerance()):
            return
        text = (
            f"displacements and stresses inside are off by about {deviation:.1e} of the depth and of the largest pressure: by that "
            "they differ on the surface from the displacement and the pressure of the contact"
        )
        if deviation > interior.WRONG:
            raise NoConvergenceError(text)
        self._give(text, InteriorAccuracyWarning)

    def _give(self, text: str, kind: type[Warning]) -> None:
        if kind not in self._given:
            self._given.add(kind)
            warn(text, kind)


def _fault(state: Any) -> str:
    """Where the one disc of a state pulls, or the surface beyond it passes through the indenter; empty if neither."""
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
    """Whether its surface carries a plate."""
    return getattr(getattr(medium, "surface", None), "bending", 0.0) > 0.0
