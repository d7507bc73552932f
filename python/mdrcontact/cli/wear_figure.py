# SPDX-License-Identifier: GPL-3.0-or-later
"""The figure of the command `wear`: contact radius against sliding distance, and the profile."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._units import LENGTH, practical
from ..studies.wear import WearResult
from .figures import COLOURS, sheet


def draw(found: WearResult) -> Any:
    """Radius against distance, and the profile before and after."""
    states = found.states
    with sheet(found.title, 1, 2, (9.6, 4.2)) as (figure, axes):
        along = practical(LENGTH, np.asarray(states.sliding))
        length = practical(LENGTH, np.asarray(states.radius))
        height = practical(LENGTH, np.asarray(states.depth))
        axes[0].semilogx(
            along.of(np.asarray(states.sliding)), length.of(np.asarray(states.radius)), "o-", color=COLOURS[0], markersize=4
        )
        axes[0].set(xlabel=f"sliding [{along.symbol}]", ylabel=f"contact radius [{length.symbol}]")
        r, new, worn = (column.values for column in found.tables["profile"])
        axes[1].plot(length.of(r), height.of(new), color="#707070", linestyle=":", label="new")
        axes[1].plot(length.of(r), height.of(worn), color=COLOURS[1], label="worn")
        axes[1].set(xlabel=f"r [{length.symbol}]", ylabel=f"profile [{height.symbol}]")
        axes[1].legend(frameon=False)
    return figure
