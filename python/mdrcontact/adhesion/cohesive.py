# SPDX-License-Identifier: GPL-3.0-or-later
"""Histories of contacts with viscoelastic bodies that attract the indenter over a range (docs/adhesion.md)."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _layout
from .._boundary import check, native, number, one_path
from .._progress import marching
from ..errors import ArgumentTypeError, InvalidArgumentError
from ..loop import CONTROLS
from ..progress import Progress


class AdhesiveHistory(NamedTuple):
    """The path of a contact with a viscoelastic half-space that attracts the indenter: arrays of one length, then what happened
    once."""

    time: NDArray[np.float64]
    """[time]"""
    depth: NDArray[np.float64]
    """d, that of the bodies where they are apart [length]"""
    radius: NDArray[np.float64]
    """a, 0 without contact [length]"""
    zone_radius: NDArray[np.float64]
    """c, outer radius of the cohesive zone, 0 where the bodies do not attract each other [length]"""
    force: NDArray[np.float64]
    """F [modulus length^2]"""
    end: dict[str, float]
    """pull-off, between the samples, too: "lowest_force", "lowest_time", "lowest_depth", "lowest_radius", "lowest_speed"; of the
    last time that the bodies came apart "rupture_time" and "rupture_depth"; how often they did, "ruptures"; "work", int F dd"""


STATE = _layout.rate_state.names or ()
"""What the library remembers of an adhesive history."""
_HAPPENED = [name for name in STATE if name.startswith(("lowest", "rupture")) or name == "work"]


def adhesive_history(
    contact: Any,
    time: ArrayLike,
    *,
    depth: ArrayLike | None = None,
    force: ArrayLike | None = None,
    position: ArrayLike | None = None,
    spring_stiffness: float | None = None,
    start: str = "apart",
    tolerance: float | None = None,
    progress: bool | Progress = False,
) -> AdhesiveHistory:
    """Follow a contact with a viscoelastic half-space that attracts the indenter over a range.

    Each place of the surface remembers what it bore; contact and cohesive zone move over it.

    Parameters
    ----------
    contact : Contact
        With a `cohesive_stress`, on a viscoelastic half-space.
    time : array_like
        Strictly ascending, one dimension [time]. Before the first the bodies are apart and at rest.
    depth, force, position : array_like
        One of them [length], [modulus length^2], [length]; linear in time in between, the first is reached in a jump. `position`
        is the far end of a spring that presses the indenter, d + F/spring_stiffness.
    spring_stiffness : float, optional
        Of that spring, > 0 [modulus length].
    start : str, optional
        "apart", the default, or "rest": in equilibrium with the first value, the body relaxed.
    tolerance : float, optional
        Of the force, relative to its largest, 1e-7 to 1e-2; default 1e-4.
    progress : bool or Progress, optional
        True shows a bar on a terminal if it takes more than two seconds; a `Progress` follows each round.

    Returns
    -------
    AdhesiveHistory

    Raises
    ------
    InvalidArgumentError
        The contact has no cohesive stress, or the body is elastic or has layers.
    UnreachableError
        There is no stable contact from which to start.
    """
    control, stiffness, accuracy, t, s = controlled_path(
        time, {"position": position, "depth": depth, "force": force}, spring_stiffness, tolerance
    )
    if not contact.cohesive_stress > 0.0:
        raise InvalidArgumentError("contact is not allowed: it must have a cohesive_stress > 0")
    if start not in ("apart", "rest"):
        raise InvalidArgumentError(f'start = {start!r} is not allowed: it must be "apart" or "rest"')
    row = np.zeros(len(STATE))
    row[0] = -1.0 if start == "rest" else 0.0
    with marching(t.size, progress):
        status, d, a, c, F, end = native.contact_adhesive_history(contact._handle, control, stiffness, accuracy, row, t, s)
    check(status)
    happened = dict(zip(STATE, end.tolist(), strict=True))
    return AdhesiveHistory(t, d, a, c, F, {key: happened[key] for key in _HAPPENED})


def controlled_path(
    time: ArrayLike, given: dict[str, ArrayLike | None], spring_stiffness: float | None, tolerance: float | None
) -> tuple[int, float, float, NDArray[np.float64], NDArray[np.float64]]:
    """The library's code of what is controlled, the stiffness of a spring, the tolerance (0: the library's), times and values."""
    name, t, s = one_path(time, **given)
    if (name == "position") != (spring_stiffness is not None):
        raise ArgumentTypeError("spring_stiffness is needed with position=, the far end of the spring, and only there")
    stiffness = 0.0 if spring_stiffness is None else number("spring_stiffness", spring_stiffness)
    if not t.size:
        raise InvalidArgumentError("time must not be empty")
    accuracy = 0.0 if tolerance is None else number("tolerance", tolerance)
    return CONTROLS[{"position": "spring"}.get(name, name)], stiffness, accuracy, t, s
