# SPDX-License-Identifier: GPL-3.0-or-later
"""A plastic law in the operations that NumPy and JAX share: mdrcontact_plastic_law.h again, without adhesion."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from .._law_arrays import LawArrays, law_arrays
from ..errors import InvalidArgumentError
from ..plastic import PlasticLaw
from ._generic import Branch, _polynomial

HEAD = ("format", "size", "elastic", "yield", "highest", "scale", "offset", "bits", "panels", "edges", "rows", "energy", "tension",
        "modulus", "line", "radius", "touch", "coated")  # fmt: skip
"""Members of mdr_plastic_head."""


EVEN = (0.7091995761560778, 0.015332626935539106, 0.0013571087988488734, 0.00012895593938380375,
        1.2712705522649381e-05, 1.2950133095189356e-06, 1.1839080872960026e-07, 2.1092491610519582e-08)  # fmt: skip
ODD = (0.05440056512511779, 0.004504519998373107, 0.00041581942315712886, 4.035590547187221e-05,
       4.0290827458097725e-06, 4.1397579345129936e-07, 3.8031184673660666e-08, 6.8235224993021594e-09)  # fmt: skip
"""Of mdr_plastic_segment."""


def segment(t: Any) -> Any:
    """mdr_plastic_segment"""
    x = t - (1.0 - t)
    q = x * x
    even, odd = EVEN[7], ODD[7]
    for c, d in zip(EVEN[6::-1], ODD[6::-1], strict=True):
        even, odd = c + q * even, d + q * odd
    return even + x * odd


class _Elastic:
    """The elastic law in the buffer of a plastic one, for `Branch`."""

    def __init__(self, parts: LawArrays) -> None:
        self.parts = parts

    def arrays(self) -> LawArrays:
        """Its numbers."""
        return self.parts


class Numbers:
    """The buffer of a law, in parts."""

    def __init__(self, law: PlasticLaw) -> None:
        if law.work_of_adhesion:
            raise InvalidArgumentError(
                f"work_of_adhesion = {law.work_of_adhesion!r}: these functions hold without adhesion. Use `advance`"
            )
        buffer = law.buffer()
        self.head = dict(zip(HEAD, buffer.tolist(), strict=False))
        if self.head["coated"]:
            raise InvalidArgumentError("the law is that of a coated body: these functions hold for half-spaces. Use `advance`")
        panels, rows = int(self.head["panels"]), int(self.head["rows"])
        self.elastic = law_arrays(buffer[int(self.head["elastic"]) :])
        # the polynomials of F, a and B2
        self.rows = buffer[rows : rows + 32 * panels].reshape(panels, 8, 4).transpose(0, 2, 1)[:, :3].reshape(panels, 24).copy()
        edges = int(self.head["edges"])
        self.edges = buffer[edges : edges + panels + 1].copy() if edges else None


class Steps:
    """F and the largest depth after steps, for arrays of depths and of largest depths before them. Arguments as of `Branch`."""

    def __init__(self, law: PlasticLaw, xp: Any, place: Callable[[Any], Any], constant: Callable[[Any], Any]) -> None:
        of = Numbers(law)
        self.head, self.xp, self.constant = of.head, xp, constant
        elastic: Any = _Elastic(of.elastic)
        self.elastic = Branch(elastic, "force", "unloading", xp, place, constant)
        self.rows = place(of.rows)
        self.edges = None if of.edges is None else place(of.edges)

    def __call__(self, depth: Any, deepest: Any) -> tuple[Any, Any]:
        """F, and the largest depth; NaN beyond the range."""
        xp, head = self.xp, self.head
        first, last = head["yield"], head["highest"]
        kept = xp.where(depth > deepest, depth, deepest)
        on_first = (depth >= deepest) | (deepest <= first)
        force = self.elastic(xp.where(depth < first, depth, first))
        if len(self.rows):
            beyond = xp.where(depth > first, xp.where(depth < last, depth, last), last)
            force = xp.where(depth > first, _polynomial(self._place(beyond)[0][..., :8], self._place(beyond)[1]), force)
            at = xp.where(on_first, last, xp.where(deepest < last, deepest, last))
            force = xp.where(on_first, force, self._unloading(at, xp.where(on_first, 0.5 * last, depth)))
        known = (abs(depth) <= np.finfo(float).max) & (deepest >= 0.0) & (kept <= last)
        return xp.where(known, force, np.nan), xp.where(known, kept, np.nan)

    def _place(self, depth: Any) -> tuple[Any, Any]:
        """The rows of the panels beyond yield, and the places in them."""
        xp, head = self.xp, self.head
        if self.edges is not None:
            panel = xp.clip(xp.searchsorted(self.edges, self.constant(depth)) - 1, 0, len(self.rows) - 1)
            low, high = self.edges[panel], self.edges[panel + 1]
            return self.rows[panel], ((depth - low) + (depth - high)) / (high - low)
        y = head["scale"] * (depth - head["yield"]) + head["offset"]
        mantissa, exponent = xp.frexp(self.constant(y))
        panels = 2.0 ** head["bits"]
        in_octave = xp.floor((2.0 * mantissa - 1.0) * panels)
        middle = 2.0 ** (exponent - 1.0) * (1.0 + (in_octave + 0.5) / panels)
        panel = ((exponent - 1) * panels + in_octave).astype(np.int64)
        return self.rows[panel], y - middle

    def _unloading(self, deepest: Any, depth: Any) -> Any:
        """F of the imprint of the largest depth, theory/plastic.md (2.9)."""
        xp, modulus = self.xp, self.head["modulus"]
        row, at = self._place(deepest)
        radius, uniform = _polynomial(row[..., 8:16], at), _polynomial(row[..., 16:], at)
        uniform = xp.where(uniform > 0.0, uniform, 0.0)
        hertz = 0.75 / modulus * _polynomial(row[..., :8], at) - 0.375 * np.pi * uniform
        w = (hertz + uniform) - radius * (deepest - depth)
        closed = w > 0.0
        w = xp.where(closed, w, 0.5 * (hertz + uniform))
        b = uniform + 2.0 * hertz
        root = b * b - 4.0 * hertz * w
        total = b + xp.sqrt(xp.where(root > 0.0, root, 1e-300))
        t, u = 2.0 * w / total, 2.0 / total * xp.sqrt(w * (total - w))
        force = u * t * (4.0 / 3.0 * hertz * (2.0 - t) + 2.0 * uniform * segment(t))
        return xp.where(closed, modulus * force, 0.0)
