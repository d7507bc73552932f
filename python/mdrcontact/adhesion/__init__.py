# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesive contacts in time: works of adhesion that depend on speed, and the histories of contacts that attract each other."""

from .cohesive import AdhesiveHistory
from .rate import RateAdhesion, RateHistory, RheologicalAdhesion

__all__ = ["AdhesiveHistory", "RateAdhesion", "RateHistory", "RheologicalAdhesion"]
