# SPDX-License-Identifier: GPL-3.0-or-later
"""A figure that a notebook shows."""

from __future__ import annotations

import os

from .._files import check_place, replace
from .panel import Sheet

__all__ = ["Figure"]


class Figure(Sheet):
    """Figure of a result: panels under one title, which a notebook shows.

    `panels` contains the axes with their units and the lines with their points. `mdrcontact.panels.matplotlib.draw` returns a
    figure of matplotlib, which can be changed.

    Examples
    --------
    >>> contact = mdr.Contact(mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Elastic(72e9, 0.17)))
    >>> figure = contact.plot(100e-9)
    >>> line = figure.panels[0].parts[0]
    >>> print(figure.panels[0].y.title, f"{line.y[-1]:.3f}")
    force F [mN] 9.886
    """

    __slots__ = ()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the figure to a file.

        Parameters
        ----------
        path : str or path-like
            File, whose name ends in .png, .pdf or .svg.

        Raises
        ------
        InvalidArgumentError
            The name ends otherwise.
        MDRError
            matplotlib is not installed.
        """
        from .matplotlib import draw, form_of, rendered

        check_place(path)
        form = form_of(path)
        replace(path, rendered(draw(self), form))

    def _repr_png_(self) -> bytes:
        """Draw the figure in a notebook."""
        from .matplotlib import png

        return png(self)
