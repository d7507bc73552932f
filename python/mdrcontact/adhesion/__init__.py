# SPDX-License-Identifier: GPL-3.0-or-later
"""Histories of adhesive contacts: rate-dependent and finite-range adhesion."""

from .cohesive import AdhesiveHistory, adhesive_history
from .rate import RateAdhesion, RateHistory, RheologicalAdhesion, rate_history

__all__ = ["AdhesiveHistory", "RateAdhesion", "RateHistory", "RheologicalAdhesion", "adhesive_history", "rate_history"]
