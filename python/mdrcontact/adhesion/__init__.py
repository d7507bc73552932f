# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesive contacts in time: works of adhesion that depend on speed, and the histories of contacts that attract each other."""

from .cohesive import AdhesiveHistory, adhesive_history
from .rate import RateAdhesion, RateHistory, RheologicalAdhesion, rate_history

__all__ = ["AdhesiveHistory", "RateAdhesion", "RateHistory", "RheologicalAdhesion", "adhesive_history", "rate_history"]
