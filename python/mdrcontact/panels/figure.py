# SPDX-License-Identifier: GPL-3.0-or-later
"""A figure that a notebook shows."""

from __future__ import annotations

from .panel import Sheet


class Figure(Sheet):
    """Panels under one title."""

    __slots__ = ()

    def _repr_png_(self) -> bytes:
        """Draw the figure in a notebook."""
        from .matplotlib import png

        return png(self)
