# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of a compiled law as NumPy arrays."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _layout

Reals = NDArray[np.float64]


class LawArrays(NamedTuple):
    """Numbers of a compiled law as views of one array, from `ContactLaw.arrays`.

    `mdrcontact.h` describes the records: `mdr_law_head`, `mdr_law_segment` and `mdr_law_interval`.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-3), mdr.Homogeneous(mdr.Elastic(210e9, 0.3)))
    >>> parts = mdr.ContactLaw(contact, 10e-6).arrays()
    >>> print(len(parts.segments), parts.force.shape[1])
    1 8
    """

    buffer: Reals
    """all numbers, as `ContactLaw.buffer` returns them"""
    head: Any
    """the first record: ends of the range, powers near initial contact, counts and places"""
    segments: NDArray[Any]
    """stable segments of the branch, by ascending contact radius"""
    intervals: NDArray[Any]
    """intervals of the segments; each has its own variable y of the depth"""
    force: Reals
    """(panels, 8) coefficients of F in powers of y minus the middle of the panel [modulus length^2]"""
    radius: Reals
    """(panels, 8) coefficients of the contact radius a [length]"""
    stiffness: Reals
    """(panels, 8) coefficients of the stiffness k [modulus length]"""
    energy: Reals
    """(panels) energy U in the middle of the panel [modulus length^3]"""


def law_arrays(buffer: Reals) -> LawArrays:
    """The parts of a law's buffer."""
    head = buffer[: len(_layout.law_head.names or ())].view(_layout.law_head)[0]
    panels = int(head["panel_count"])
    contact = _part(buffer, head["contact"], 16 * panels).reshape(panels, 16)
    return LawArrays(
        buffer,
        head,
        _records(buffer, head["segments"], head["segment_count"], _layout.law_segment),
        _records(buffer, head["intervals"], head["interval_count"], _layout.law_interval),
        _part(buffer, head["force"], 8 * panels).reshape(panels, 8),
        contact[:, :8],
        contact[:, 8:],
        _part(buffer, head["energy"], panels),
    )


def _part(buffer: Reals, place: float, size: int) -> Reals:
    return buffer[int(place) : int(place) + size]


def _records(buffer: Reals, place: float, count: float, kind: np.dtype[Any]) -> NDArray[Any]:
    return _part(buffer, place, int(count) * len(kind.names or ())).view(kind)
