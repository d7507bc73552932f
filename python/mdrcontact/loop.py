# SPDX-License-Identifier: GPL-3.0-or-later
"""Pull-off of adhesive contacts, and cycles of approach and retraction.

See theory/paper.md (5.1).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _layout
from ._boundary import Handle, call, native, number, record, whole, words_of
from ._choices import code
from ._warn import Warned
from .errors import ArgumentTypeError

if TYPE_CHECKING:
    from .panels import Figure

RULES = words_of(_layout.ADHESION_AUTOMATIC, _layout.ADHESION_PAPER, _layout.ADHESION_ENERGY)
"""Names and codes of the adhesion rules."""
BRANCHES = words_of(_layout.ON_LOADING, _layout.ON_UNLOADING)
"""Names and codes of the branches of an adhesive contact."""
CONTROLS = words_of(_layout.FORCE, _layout.DEPTH, _layout.SPRING)
"""Names and codes of prescribed quantities."""

_FIRST_ROOM = 16
"""Stable segments of a branch for which there is room at first; there are hardly ever more than three."""


class PullOff(NamedTuple):
    """State in which an adhesive contact breaks, from `Contact.pull_off`.

    It is the state of lowest force, or of lowest depth, of all stable states.

    Examples
    --------
    >>> rubber = mdr.Homogeneous(mdr.Elastic(1e6, 0.5))
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), rubber, work_of_adhesion=0.05)
    >>> pull_off = contact.pull_off()
    >>> print(f"{pull_off.force:.4e} {-1.5 * np.pi * 0.05 * 10e-6:.4e}")
    -2.3562e-06 -2.3562e-06
    """

    depth: float
    """d, indentation depth, positive into the medium [length]"""
    radius: float
    """a, contact radius [length]; 0 if bodies with a cohesive stress part while they attract each other without contact"""
    force: float
    """F, normal force, positive in compression [modulus length^2]"""
    stiffness: float
    """k = 2 a E_eff(a), contact stiffness at constant radius [modulus length]"""
    others: tuple[PullOff, ...] = ()
    """ends of the other stable segments of the branch, by ascending radius; a coated body can have several"""


class _LoopNumbers(NamedTuple):
    """The numbers of a `Loop`."""

    position: NDArray[np.float64]
    """the prescribed quantity: the force [modulus length^2], the depth, or the far end of the spring, d + F/stiffness [length]"""
    depth: NDArray[np.float64]
    """d, negative while the bodies are separated [length]"""
    radius: NDArray[np.float64]
    """a, 0 while the bodies are separated [length]"""
    force: NDArray[np.float64]
    """F [modulus length^2]"""
    turning_point: int
    """index of the last point of the approach"""
    jumps: NDArray[np.int64]
    """indices of the points before each jump; a jump leads to the next point at the same position"""
    dissipated_energy: float
    """energy lost in the cycle, the area of the loop; under a prescribed force up to pull-off, because the further motion of the
    bodies is not known [modulus length^3]
    """
    control: str
    """"force", "depth" or "spring" """


class Loop(_LoopNumbers, Warned):
    """Cycle of approach and retraction, from `Contact.loop`; arrays of one length.

    The indenter approaches from afar, jumps into contact, presses, and retracts until the bodies are separated again.

    Examples
    --------
    >>> rubber = mdr.Homogeneous(mdr.Elastic(1e6, 0.5))
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), rubber, work_of_adhesion=0.05)
    >>> cycle = contact.loop("depth", largest=1e-6, points=50)
    >>> print(len(cycle.jumps), f"{cycle.dissipated_energy:.3e}")
    2 8.559e-13
    """

    def plot(self) -> Figure:
        """Return force and contact radius along the cycle as a figure; jumps are dotted.

        The abscissa is the position of the spring's end, or the depth without a spring. Numbers are taken as SI.

        Returns
        -------
        Figure
            The figure.
        """
        from .panels import Figure, contacts

        return Figure("Approach and retraction", contacts.of_loop(self))


def pull_offs(contact: Any, control: str) -> PullOff:
    """The pull-off of a contact and its other ends of stability."""
    chosen, room = code("control", control, CONTROLS, "force", "depth"), _FIRST_ROOM
    while True:
        found, count = call(native.contact_pull_off, contact._handle, chosen, room)
        if count <= room:
            break
        room = count
    if not count:
        return PullOff(0.0, 0.0, 0.0, 0.0)
    d, a, F = found.T[:3]
    # bodies with a cohesive stress may part without having touched
    k = np.zeros(count)
    k[a[:count] > 0.0] = contact.medium.stiffness(a[:count][a[:count] > 0.0]) if np.any(a[:count] > 0.0) else 0.0
    states = [PullOff(float(d[i]), float(a[i]), float(F[i]), float(k[i])) for i in range(count)]
    return states[0]._replace(others=tuple(states[1:]))


def loop(contact: Any, control: str, largest: Any, points: Any, spring_stiffness: Any) -> Loop:
    """A cycle of a contact."""
    chosen = code("control", control, CONTROLS)
    if (spring_stiffness is not None) != (control == "spring"):
        raise ArgumentTypeError('spring_stiffness belongs to control "spring". Give both or none')
    stiffness = 0.0 if spring_stiffness is None else number("spring_stiffness", spring_stiffness)
    count = whole("points", points, 2, 1_000_000)
    created = native.loop_new(contact._handle, chosen, number("largest", largest), count, stiffness)
    handle = Handle(created)
    facts = record(_layout.loop_facts)
    call(native.loop_about, handle, facts)
    rows, _ = call(native.loop_points, handle, int(facts[0]["points"]))
    position, d, a, F, jumps = np.ascontiguousarray(rows.T)
    doubts = contact._warn_at(float(d.max()))
    energy = float(facts[0]["dissipated_energy"])
    found = Loop(position, d, a, F, int(facts[0]["turning_point"]), np.flatnonzero(jumps), energy, control)
    return found._carrying(doubts)
