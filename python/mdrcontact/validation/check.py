# SPDX-License-Identifier: GPL-3.0-or-later
"""A row of the validation."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Comparison:
    """Numbers of the library next to those of an independent source."""

    x_name: str
    x: Array
    here: Array
    there: Array
    scale: Array | float
    """what the deviation is relative to"""

    @property
    def deviation(self) -> float:
        """The largest of |here - there| over the scale."""
        return float(np.max(np.abs(self.here - self.there) / self.scale))


@dataclass(frozen=True)
class Check:
    """One capability against one source."""

    name: str
    """of the check, for `mdrcontact validate --only`"""
    capability: str
    source: str
    """publication or program with which it is compared"""
    error: float
    """the largest relative deviation that the error of the source explains"""
    whose: str
    """whose error that is"""
    run: Callable[[], Comparison]
    is_long: bool = False
    needs: str = ""
    """the module of the program that it is compared with; nothing for formulas and tables"""


def comparison(x_name: str, x: ArrayLike, here: ArrayLike, there: ArrayLike, scale: Any = None) -> Comparison:
    """A comparison; the deviation is relative to each reference value, unless a scale is given."""
    at, ours, theirs = (np.atleast_1d(np.asarray(values, dtype=float)) for values in (x, here, there))
    return Comparison(x_name, at, ours, theirs, np.abs(theirs) if scale is None else scale)


class Group(NamedTuple):
    """Checks that share a section and a picture."""

    name: str
    """of the picture's file"""
    title: str
    checks: tuple[Check, ...]
