# SPDX-License-Identifier: GPL-3.0-or-later
"""The load at which the strengths of a coated body are reached."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from . import _layout
from ._boundary import Refusal, native, not_zero, number, outcome, words_of
from ._choices import code
from ._warn import Warned
from .critical import Maximum, layers_of, maximum
from .errors import ArgumentTypeError, InvalidArgumentError
from .interior import BODIES
from .state import NAMES, state_of

_MODES = words_of(_layout.VON_MISES, _layout.TENSION, _layout.INTERFACE_SHEAR, _layout.INTERFACE_TENSION)


class _FailureNumbers(NamedTuple):
    """The numbers of a `Failure`."""

    mode: str
    """"von_mises", "tension", "interface_shear" or "interface_tension"; see `Contact.first_failure`"""
    place: int
    """number of the layer or interface from top to bottom; 0 is the first"""
    strength: float
    """the strength that is reached [modulus]"""
    state: Any
    """the `State` at which it is reached; the smallest one examined if it is reached at any load"""
    at: Maximum
    """position in the body; its value exceeds the strength if that is reached at any load"""


class Failure(_FailureNumbers, Warned):
    """Strength that is reached, from `Contact.first_failure`.

    Examples
    --------
    >>> film = mdr.Coated(mdr.Elastic(445e9, 0.25), 1e-6, mdr.Elastic(210e9, 0.3))
    >>> contact = mdr.Contact(mdr.Sphere(10e-6), film)
    >>> first = contact.first_failure({"von_mises": [20e9, 2e9], "interface_shear": [1e9]})[0]
    >>> print(first.mode, first.place, f"{first.state.force:.3e}")
    von_mises 1 6.018e-03
    """

    @property
    def at_once(self) -> bool:
        """True if the strength is exceeded at any load, as below a sharp tip."""
        return self.at.value > 1.001 * self.strength


def first_failure(
    contact: Any, strengths: Mapping[str, Sequence[float | None]], body: str, friction: float, largest_radius: float | None
) -> tuple[Failure, ...]:
    """Return the result of `Contact.first_failure`."""
    side = code("body", body, BODIES)
    wanted = _wanted(contact, strengths, body)
    given = np.array([(_MODES[mode], place, value) for mode, place, value in wanted], _layout.strength)
    found = np.zeros(len(given), _layout.failure_load)
    last = 0.0 if largest_radius is None else not_zero("largest_radius", largest_radius)
    status, count = outcome(
        native.contact_first_failure, contact._handle, side, number("friction", friction), last,
        len(given), given, len(found), found,
    )  # fmt: skip
    if status:
        refusal = Refusal(status)
        if refusal.argument != "strengths" or not refusal.entry:
            raise refusal.error()
        raise InvalidArgumentError(f"strengths: {wanted[refusal.entry - 1][0]!r}{refusal.text}")
    names = {quantity: mode for mode, quantity in _MODES.items()}
    failures = []
    for one in found[:count]:
        state = state_of([float(one[name]) for name in NAMES], contact)
        doubts = [*contact._doubts.about(state), *contact._doubts.inside_or_refused(state, body)]
        contact._reported.report(doubts)
        reached = Failure(names[int(one["quantity"])], int(one["place"]), float(one["strength"]), state, maximum(one))
        failures.append(reached._carrying(doubts))
    return tuple(failures)


def _wanted(contact: Any, strengths: Mapping[str, Sequence[float | None]], body: str) -> list[tuple[str, int, float]]:
    """Return mode, place and strength of every failure of the search."""
    interfaces, rigid = layers_of(contact.medium, body)
    if not isinstance(strengths, Mapping):
        raise ArgumentTypeError(f"strengths = {strengths!r}: it must be a dict of lists, as in {{'von_mises': [1e9, None]}}")
    wanted = []
    for mode, given in strengths.items():
        if mode not in _MODES:
            raise InvalidArgumentError(f"strengths: {mode!r} is not a mode of failure: choose from {', '.join(map(repr, _MODES))}")
        count, of = (len(interfaces), "interfaces") if "interface" in mode else (len(interfaces) + (not rigid), "layers")
        if isinstance(given, str) or not isinstance(given, Iterable):
            raise ArgumentTypeError(f"strengths: {mode!r} = {given!r}: it must be a list, one for each of the {count} {of}")
        values = list(given)
        if len(values) != count:
            raise InvalidArgumentError(
                f"strengths: {mode!r} has {len(values)} values: give one for each of the {count} {of}, from top to bottom"
            )
        wanted += [(mode, i, number(f"strengths: {mode!r}", value)) for i, value in enumerate(values) if value is not None]
    if not wanted:
        raise InvalidArgumentError("strengths: it names no strength")
    return wanted
