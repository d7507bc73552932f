# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies that yield: imprints, laws of yielding contacts, pressure caps."""

from .imprint import Imprint, ImprintProfile, ReverseYield

__all__ = ["Imprint", "ImprintProfile", "ReverseYield"]
