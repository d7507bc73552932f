# SPDX-License-Identifier: GPL-3.0-or-later
"""Indenter profiles."""

from . import base, sampled, shapes, tips
from .base import *  # noqa: F403
from .sampled import *  # noqa: F403
from .shapes import *  # noqa: F403
from .tips import *  # noqa: F403

__all__ = [*base.__all__, *shapes.__all__, *tips.__all__, *sampled.__all__]
