# SPDX-License-Identifier: GPL-3.0-or-later
"""Histories of contacts with viscoelastic bodies under finite-range adhesion."""

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
    """Path of a contact with a viscoelastic half-space under finite-range adhesion.

    `adhesive_history` returns it. The first five entries are arrays of one length.

    Examples
    --------
    >>> rubber = mdr.Homogeneous(mdr.Viscoelastic(1e6, [(9e6, 0.01)], nu=0.5))
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), rubber, work_of_adhesion=0.05, cohesive_stress=2e5)
    >>> path = mdr.adhesion.adhesive_history(contact, [0.0, 1.0, 2.0], depth=[0.0, 1e-6, 0.5e-6], start="rest")
    >>> print(np.round(path.force * 1e6, 2))
    [-2.33 17.73  3.04]
    """

    time: NDArray[np.float64]
    """the times of the path [time]"""
    depth: NDArray[np.float64]
    """d, also that of separated bodies [length]"""
    radius: NDArray[np.float64]
    """a, 0 without contact [length]"""
    zone_radius: NDArray[np.float64]
    """c, outer radius of the cohesive zone, 0 if the bodies do not attract each other [length]"""
    force: NDArray[np.float64]
    """F [modulus length^2]"""
    end: dict[str, float]
    """what happened once: pull-off as "lowest_force", "lowest_time", "lowest_depth", "lowest_radius", "lowest_speed"; the last
    separation as "rupture_time" and "rupture_depth"; the number of separations "ruptures"; and "work", int F dd
    [modulus length^3]
    """


STATE = _layout.rate_state.names or ()
"""Members of the state of an adhesive history."""
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
    """Follow a contact with a viscoelastic half-space under finite-range adhesion.

    Contact and cohesive zone move over the surface, each point of which has its own loading history. Give one of `depth`, `force`
    and `position`.

    Parameters
    ----------
    contact : Contact
        Contact with a `cohesive_stress`, on a viscoelastic half-space.
    time : array_like
        Strictly ascending times, one dimension [time]. Before the first time the bodies are separated and at rest.
    depth : array_like, optional
        Depths at these times, linear in between [length]. The first value is reached in a jump.
    force : array_like, optional
        Forces at these times, as `depth` [modulus length^2].
    position : array_like, optional
        Positions d + F/spring_stiffness of the far end of a spring that presses the indenter, as `depth` [length].
    spring_stiffness : float, optional
        Stiffness of that spring, > 0 [modulus length].
    start : {"apart", "rest"}, optional
        "apart": separated bodies. "rest": equilibrium with the first value on the relaxed body.
    tolerance : float, optional
        Tolerance of the force relative to its largest value, 1e-7 to 1e-2; default 1e-4 [1].
    progress : bool or Progress, optional
        True shows a progress bar on a terminal if the work takes more than two seconds. A `Progress` follows each round.

    Returns
    -------
    AdhesiveHistory
        The path, and pull-off.

    Raises
    ------
    InvalidArgumentError
        The contact has no cohesive stress, or the body is elastic or layered.
    UnreachableError
        There is no stable contact from which to start.

    References
    ----------
    haiat-2003
    greenwood-1981

    Examples
    --------
    >>> rubber = mdr.Homogeneous(mdr.Viscoelastic(1e6, [(9e6, 0.01)], nu=0.5))
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), rubber, work_of_adhesion=0.05, cohesive_stress=2e5)
    >>> path = mdr.adhesion.adhesive_history(contact, [0.0, 2.0], depth=[0.5e-6, -2e-6], start="rest")
    >>> print(f"{path.end['lowest_force']:.3e}")
    -3.845e-06
    """
    control, stiffness, accuracy, t, s = controlled_path(
        time, {"position": position, "depth": depth, "force": force}, spring_stiffness, tolerance
    )
    if not contact.cohesive_stress > 0.0:
        raise InvalidArgumentError("contact: it must have a cohesive_stress > 0")
    if start not in ("apart", "rest"):
        raise InvalidArgumentError(f'start = {start!r}: it must be "apart" or "rest"')
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
    """Return the code of the controlled quantity, the stiffness of a spring, the tolerance (0: the library's), times and values."""
    name, t, s = one_path(time, **given)
    if (name == "position") != (spring_stiffness is not None):
        raise ArgumentTypeError("spring_stiffness belongs to position=, the far end of the spring. Give both or none")
    stiffness = 0.0 if spring_stiffness is None else number("spring_stiffness", spring_stiffness)
    if not t.size:
        raise InvalidArgumentError("time must not be empty")
    accuracy = 0.0 if tolerance is None else number("tolerance", tolerance)
    return CONTROLS[{"position": "spring"}.get(name, name)], stiffness, accuracy, t, s
