# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact point and baseline of an approach, and depth from piezo height."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..._boundary import number, numbers
from ..._choices import nearest
from ...errors import InvalidArgumentError
from .segments import curve

Array = NDArray[np.float64]

METHODS = ("piecewise", "ratio-of-variances")
SOURCES = {"piecewise": "Lin, Dimitriadis, Horkay 2007", "ratio-of-variances": "Gavara 2016"}
FEWEST = 20
"""Fewest readings for the search for a contact point."""
_WINDOW = 0.05
"""Fraction of the points on either side whose variances are compared."""
_CANDIDATES = 200
_LOW = 0.1
"""Fraction of the force up to which a contact is taken as a power law."""
_BINS = 20
"""Parts of the travel of the piezo."""
_CLEAR = 0.8
"""The baseline ends before this part of the way to the contact point."""


class Baseline(NamedTuple):
    """Force without contact, offset + tilt depth, from `find_baseline`.

    Examples
    --------
    >>> depth = np.linspace(-500e-9, 200e-9, 141)
    >>> force = 1e-9 + 1e-2 * np.maximum(depth, 0.0) ** 1.5
    >>> contact = mdr.instruments.find_contact_point(depth, force)
    >>> baseline = mdr.instruments.find_baseline(depth, force, contact)
    >>> print(f"{baseline.offset:.2e} {baseline.at(0.0):.2e}")
    1.00e-09 1.00e-09
    """

    offset: float
    """force at depth 0 [force]"""
    tilt: float
    """slope of the force against depth [force/length]"""
    noise: float
    """standard deviation of the readings about it [force]"""

    def at(self, depth: Array) -> Array:
        """Return the force of the baseline at given depths.

        Parameters
        ----------
        depth : ndarray
            Depths [length].

        Returns
        -------
        ndarray
            Forces [force].
        """
        return self.offset + self.tilt * depth


def find_contact_point(depth: ArrayLike, force: ArrayLike, method: str = "piecewise", *, power: float = 1.5) -> int:
    """Find the first point in contact on an approach.

    Parameters
    ----------
    depth : array_like
        Depths in the order of measurement, at least 20 [length].
    force : array_like
        Forces, as many [force].
    method : {"piecewise", "ratio-of-variances"}, optional
        "piecewise": a straight baseline and force = c (depth - d0)^power, by least squares over d0. "ratio-of-variances": the point
        after which the forces vary most, compared with those before.
    power : float, optional
        Power for "piecewise": 1.5 for spheres and paraboloids, 2 for cones and pyramids [1].

    Returns
    -------
    int
        Position of the point.

    Raises
    ------
    InvalidArgumentError
        There are too few points, or the method is unknown.

    References
    ----------
    lin-2007
    gavara-2016

    Examples
    --------
    >>> depth = np.linspace(-500e-9, 200e-9, 141)
    >>> force = 1e-9 + 1e-2 * np.maximum(depth, 0.0) ** 1.5
    >>> contact = mdr.instruments.find_contact_point(depth, force)
    >>> print(f"{abs(depth[contact]) * 1e9:.0f}")
    0
    """
    d, f = curve(depth, force, fewest=FEWEST)
    if method not in METHODS:
        raise InvalidArgumentError(f"method = {method!r}: {nearest(str(method), METHODS)}")
    return _piecewise(d, f, number("power", power)) if method == "piecewise" else _ratio_of_variances(f)


def _ratio_of_variances(f: Array) -> int:
    n = len(f)
    window = max(5, round(_WINDOW * n))
    one, two = (np.concatenate([[0.0], np.cumsum(v)]) for v in (f - f.mean(), (f - f.mean()) ** 2))
    mean, square = (one[window:] - one[:-window]) / window, (two[window:] - two[:-window]) / window
    variance = np.maximum(square - mean**2, 1e-12 * np.var(f))
    # of the points i+1 ... i+window over i-window ... i-1
    ratio = variance[window + 1 :] / variance[: -window - 1]
    return int(np.argmax(ratio)) + window


def _piecewise(d: Array, f: Array, power: float) -> int:
    # far beyond the contact point a layer on a substrate is no power law; so high that the noise does not matter
    first = f[: max(len(f) // 10, 5)]
    level = first.mean() + max(_LOW * np.ptp(f), 20.0 * float(np.std(first)))
    above = np.flatnonzero(f > level)
    last = max(int(above[0]) if len(above) else len(f) - 1, FEWEST - 1)
    d, f = d[: last + 1], f[: last + 1]
    places = np.arange(3, max(len(d) - 3, 4))
    step = max(1, len(places) // _CANDIDATES)
    coarse = places[::step]
    best = coarse[np.argmin(_misfits(d, f, coarse, power))]
    near = places[np.abs(places - best) <= step]
    return int(near[np.argmin(_misfits(d, f, near, power))])


def _misfits(d: Array, f: Array, places: NDArray[np.int64], power: float) -> Array:
    """Sums of squares about a line to which a power law is added behind each place."""
    line, _ = np.linalg.qr(np.column_stack([np.ones_like(d), d - d.mean()]))
    left = f - line @ (line.T @ f)
    into = np.maximum(d - d[places, None], 0.0) ** power
    into -= (into @ line) @ line.T
    share, size = into @ left, np.maximum((into**2).sum(axis=1), 1e-300)
    # a contact under tension does not count
    return np.asarray(left @ left - np.where(share > 0.0, share**2 / size, 0.0))


def find_baseline(depth: ArrayLike, force: ArrayLike, contact: int, *, tilt: bool = True) -> Baseline:
    """Fit the baseline before the contact point.

    The last 20 % before contact are excluded, because forces of longer range may act there.

    Parameters
    ----------
    depth : array_like
        Depths in the order of measurement [length].
    force : array_like
        Forces, as many [force].
    contact : int
        Position of the first point in contact.
    tilt : bool, optional
        False fits an offset only.

    Returns
    -------
    Baseline
        Offset, tilt and noise.

    Raises
    ------
    InvalidArgumentError
        Fewer than 5 points are before contact.

    Examples
    --------
    >>> depth = np.linspace(-500e-9, 200e-9, 141)
    >>> force = 1e-9 + 1e-2 * np.maximum(depth, 0.0) ** 1.5
    >>> baseline = mdr.instruments.find_baseline(depth, force, 100, tilt=False)
    >>> print(f"{baseline.offset:.2e}")
    1.00e-09
    """
    d, f = curve(depth, force)
    last = int(_CLEAR * contact)
    if last < 5:
        raise InvalidArgumentError(f"too few points before contact for a baseline: {last}; at least 5 are needed")
    d, f = d[:last], f[:last]
    slope = float(np.polyfit(d - d.mean(), f, 1)[0]) if tilt and np.ptp(d) > 0.0 else 0.0
    offset = float(f.mean() - slope * d.mean())
    return Baseline(offset, slope, float(np.std(f - offset - slope * d)))


def height_sign(height: Array, deflection: Array) -> int:
    """1 where the height grows into the sample, -1 where it falls: the deflection grows with it, step by step. So a reading far
    away counts once up and once down."""
    return 1 if float(np.diff(height) @ np.diff(deflection)) > 0.0 else -1


def deflection_sign(height: ArrayLike, deflection: ArrayLike) -> int:
    """1 where the deflection grows as the tip is pressed into the sample, -1 where it falls.

    Contact is at that end of the way of the piezo where the deflection changes more; what the cantilever reads there lies above
    the readings of the other end. A hold counts by its way, not by its readings.
    """
    z, x = curve(height, deflection)
    # one way: in a liquid the other has another baseline
    turn = int(np.argmax(np.abs(z - z[0])))
    z, x = z[: turn + 1], x[: turn + 1]
    place = np.minimum(((z - z.min()) / np.ptp(z) * _BINS).astype(np.int64), _BINS - 1)
    levels = np.array([np.median(x[place == i]) for i in np.unique(place)])
    few = max(len(levels) // 5, 1)
    from_contact = levels if np.ptp(levels[: few + 1]) > np.ptp(levels[-few - 1 :]) else levels[::-1]
    return 1 if from_contact[0] >= np.median(from_contact[len(levels) // 2 :]) else -1


def depth_from_height(height: ArrayLike, deflection: ArrayLike, sign: int | None = None) -> Array:
    """Return the indentation depth from piezo height and cantilever deflection.

    The depth is the motion of the piezo into the sample minus the deflection.

    Parameters
    ----------
    height : array_like
        Heights of the piezo [length].
    deflection : array_like
        Deflections of the cantilever [length].
    sign : int, optional
        1 if the height grows into the sample, -1 if it falls; None: as the deflection grows with it.

    Returns
    -------
    ndarray
        Depths [length].

    Raises
    ------
    InvalidArgumentError
        The columns differ in length or are not finite.

    Examples
    --------
    >>> print(mdr.instruments.depth_from_height([0.0, 100e-9, 200e-9], [0.0, 10e-9, 30e-9]))
    [0.0e+00 9.0e-08 1.7e-07]
    """
    z, x = numbers("height", height), numbers("deflection", deflection)
    z, x = curve(z, x)
    return np.asarray((height_sign(z, x) if sign is None else sign) * z - x)
