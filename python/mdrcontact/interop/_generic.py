# SPDX-License-Identifier: GPL-3.0-or-later
"""A branch of a compiled law in the operations that NumPy, JAX and PyTorch share, so that the latter two have its derivatives."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from .._choices import code
from ..law import ContactLaw
from ._cells import BELOW, OPEN, cells_of, tangent_of

QUANTITIES = {"force": 1, "energy": 2}
LARGEST = float(np.finfo(float).max)


class Branch:
    """F or U of arrays of depths. `xp` is the module whose arrays these are, `place` makes its array of one of NumPy, `constant`
    takes an array out of the differentiation."""

    def __init__(
        self, law: ContactLaw, quantity: str, branch: str, xp: Any, place: Callable[[Any], Any], constant: Callable[[Any], Any]
    ) -> None:
        code("quantity", quantity, QUANTITIES)
        self.quantity = quantity
        arrays = law.arrays()
        cells = cells_of(arrays, branch)
        self.xp, self.constant = xp, constant
        self.edges, self.cell_interval = place(cells.edges), place(cells.interval)
        self.interval = {name: place(arrays.intervals[name].copy()) for name in arrays.intervals.dtype.names or ()}
        self.force, self.energy = place(arrays.force.copy()), place(arrays.energy.copy())
        self.head = {name: float(arrays.head[name]) for name in arrays.head.dtype.names}
        self.tangent = tangent_of(arrays, lambda d: (law.at_depth(d, branch), law.energy(d, branch)))

    def __call__(self, d: Any) -> Any:
        """The quantity at depths of any shape."""
        xp, (highest, force, slope, energy) = self.xp, self.tangent
        cell = self.pick(self.cell_interval, xp.searchsorted(self.edges, d))
        value = xp.where(cell == BELOW, self._below(xp.where(cell == BELOW, d, self.head["lowest"])), 0.0)
        inside = xp.where(cell >= 0, d, highest)
        value = xp.where(cell >= 0, self._within(xp.where(cell >= 0, cell, self.cell_interval[-1]), inside), value)
        by = xp.where(d > highest, d - highest, 0.0)
        beyond = force + slope * by if self.quantity == "force" else energy + (force + 0.5 * slope * by) * by
        closed = xp.where(d > highest, beyond, xp.where(cell == OPEN, 0.0, value))
        return xp.where(d >= -LARGEST, closed, np.nan)

    def _below(self, d: Any) -> Any:
        head, share, p, half = self.head, d / self.head["lowest"], self.head["force_power"], 0.5 * self.head["force_roots"]
        if half == 0.0:
            force = head["first_force"] * share**p
            return force if self.quantity == "force" else force * d / (1.0 + p)
        bend = 2.0 * (p - half)
        straight, tilt = head["first_force"] * (1.0 - bend), head["first_force"] * bend
        if self.quantity == "force":
            return straight * share**half + tilt * share ** (half + 0.5)
        return d * (straight * share**half / (half + 1.0) + tilt * share ** (half + 0.5) / (half + 1.5))

    def _within(self, interval: Any, d: Any) -> Any:
        xp, of = self.xp, {name: self.pick(values, interval) for name, values in self.interval.items()}
        is_root = of["is_root"] > 0.0
        distance = of["side"] * (d - of["origin"])
        # next to the origin a straight line: there the slope of the root has no end
        near = distance <= of["smallest_root"] ** 2
        root = xp.where(near, distance / of["smallest_root"], xp.sqrt(xp.where(near | ~is_root, 1.0, distance)))
        y = of["scale"] * xp.where(is_root, root, d) + of["offset"]
        inside = self.constant(xp.where(y > 1.0, xp.where(y < of["last_y"], y, of["last_y"]), 1.0))
        mantissa, exponent = xp.frexp(inside)
        panels = 2.0 ** of["bits"]
        in_octave = xp.floor((2.0 * mantissa - 1.0) * panels)
        middle = 0.5 * inside / mantissa * (1.0 + (in_octave + 0.5) / panels)
        panel = self.whole(of["first_panel"] + (exponent - 1) * panels + in_octave)
        t, c = y - middle, self.pick(self.force, panel)
        if self.quantity == "force":
            return _polynomial(c, t)
        return self.pick(self.energy, panel) + self._energy(of, is_root, c, t, middle)

    def _energy(self, of: Any, is_root: Any, c: Any, t: Any, middle: Any) -> Any:
        """int F dd from the middle of a panel."""
        first, second = 0.0 * t, 0.0 * t
        for i in range(7, -1, -1):
            first = first * t + c[..., i] / (i + 1)
            second = second * t + c[..., i] / (i + 2)
        first, second = first * t, second * t * t
        with_root = 2.0 * of["side"] * ((middle - of["offset"]) * first + second) / of["scale"] ** 2
        return self.xp.where(is_root, with_root, first / of["scale"])

    def pick(self, rows: Any, index: Any) -> Any:
        """Rows of an array, in the shape of the index."""
        return rows[index]

    def whole(self, numbers: Any) -> Any:
        """Numbers of panels, for indexing."""
        return numbers.astype(np.int64)


def _polynomial(c: Any, t: Any) -> Any:
    """In the order of operations of mdrcontact_law.h."""
    q = t * t
    even = c[..., 0] + q * (c[..., 2] + q * (c[..., 4] + q * c[..., 6]))
    return even + t * (c[..., 1] + q * (c[..., 3] + q * (c[..., 5] + q * c[..., 7])))
