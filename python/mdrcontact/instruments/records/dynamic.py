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
    """Return depth, force and stiffness at the top of an oscillation.

    An oscillating indenter unloads along P = B (h - h_f)^m, so that instruments read a secant instead of the slope, and means
    instead of largest values. With Delta = 2 sqrt(2) rms, S = m P/Delta (1 - (1 - S_read Delta/P)^(1/m)). If S_read Delta > P,
    contact is lost.

    Parameters
    ----------
    depth : array_like
        Depth readings [length].
    force : array_like
        Force readings [modulus length^2].
    stiffness : array_like
        Stiffness readings [modulus length].
    oscillation : float
        Root-mean-square amplitude of the displacement, > 0 [length].
    exponent : float, optional
        m of the unloading curve, 1 <= m <= 2 [1].

    Returns
    -------
    tuple of ndarray
        Depth, force and stiffness, and True for points that stay in contact.

    Raises
    ------
    InvalidArgumentError
        The amplitude or the exponent is outside its range.

    References
    ----------
    pharr-2009

    Examples
    --------
    >>> depth, force, stiffness, keeps = mdr.instruments.without_oscillation([50e-9], [1e-4], [1e4], 1e-9)
    >>> print(f"{stiffness[0]:.4e}", keeps[0])
    1.0466e+04 True
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
