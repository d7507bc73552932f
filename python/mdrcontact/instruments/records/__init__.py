# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of records: segments, drift, pop-ins, contact point and baseline."""

from .contact_point import Baseline, depth_from_height, find_baseline, find_contact_point
from .dynamic import without_oscillation
from .pull import Parting, Pull, find_parting, find_pull
from .segments import (
    Drift,
    PopIn,
    Segment,
    Segmentation,
    drift_rate,
    find_pop_in,
    find_segments,
    find_strays,
    segmentation,
    without_drift,
)

__all__ = [
    "Baseline",
    "depth_from_height",
    "find_baseline",
    "find_contact_point",
    "Drift",
    "PopIn",
    "Segment",
    "Segmentation",
    "drift_rate",
    "find_pop_in",
    "find_parting",
    "find_pull",
    "Parting",
    "Pull",
    "find_segments",
    "find_strays",
    "segmentation",
    "without_drift",
    "without_oscillation",
]
