# SPDX-License-Identifier: GPL-3.0-or-later
"""Dynamic (CSM) data: what the oscillation does to depth, force and stiffness."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..._boundary import number, numbers
from ...errors import InvalidArgumentError

Array = NDArray[np.float64]


def without_oscillation(
    depth: ArrayLike, force: ArrayLike, stiffness: ArrayLike, oscillation: float, exponent: float = 1.5
) -> tuple[Array, Array, Array, NDArray[np.bool_]]:
    """Depth, force and contact stiffness at the top of the oscillation, and which points keep contact all the time.

    While the indenter oscillates it unloads along P = B (h - h_f)^m, so instruments read a secant for the slope, and means for
    largest values (Pharr, Strader, Oliver 2009, J. Mater. Res. 24, 653). With Delta the range of the oscillation, 2 sqrt(2) of its
    rms: S = m P/Delta (1 - (1 - S_read Delta/P)^(1/m)), P the largest force. Where S_read Delta > P contact is lost.

    oscillation : rms amplitude of the displacement [length]; exponent : m of the unloading curve [1]
    """
    h, p, s = (numbers(name, v) for name, v in (("depth", depth), ("force", force), ("stiffness", stiffness)))
    rms, m = number("oscillation", oscillation), number("exponent", exponent)
    if not 0.0 < rms < math.inf:
        raise InvalidArgumentError(f"oscillation = {oscillation!r}: it must be greater than 0 and finite")
    if not 1.0 <= m <= 2.0:
        raise InvalidArgumentError(f"exponent = {exponent!r}: it must be between 1 and 2")
    top, span = p + math.sqrt(2.0) * rms * s, 2.0 * math.sqrt(2.0) * rms
    share = s * span / top
    keeps = (share < 1.0) & (s > 0.0)
    inside = np.clip(1.0 - share, 0.0, None)
    return h + math.sqrt(2.0) * rms, top, np.where(keeps, m * top / span * (1.0 - inside ** (1.0 / m)), s), keeps
