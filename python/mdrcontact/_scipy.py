# SPDX-License-Identifier: GPL-3.0-or-later
"""Import of SciPy, for maps, sliding, and fits of gels and adhesion."""

from __future__ import annotations

from .errors import MDRError


def require() -> None:
    """An exception that states how to install it if it is missing."""
    try:
        import scipy  # noqa: F401
    except ImportError as problem:
        words = 'maps, sliding and fits of gels, conductors and adhesion need SciPy: pip install "mdrcontact[map]"'
        raise MDRError(words) from problem
