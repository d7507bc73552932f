# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the scatter of data about a fit agrees with their standard deviations."""

from __future__ import annotations

import math

_FAR = 4.0
"""Standard deviations beyond which a chi-square is not believed to be by chance."""
_LOG_FAR = math.log(3.2e-5)
"""The same as the logarithm of a probability."""


def compare_scatter(chi_square: float, degrees_of_freedom: float) -> int:
    """1 where a chi-square is too large for its degrees of freedom, -1 where it is too small, 0 where it may be chance or there are
    too few degrees of freedom. By Wilson and Hilferty's normal deviate; below, also by P <= (chi^2/2)^(n/2)/Gamma(n/2 + 1),
    for the deviate has no small probabilities at few degrees of freedom."""
    n = degrees_of_freedom
    if not n >= 1.0:
        return 0
    spread = 2.0 / (9.0 * n)
    deviate = ((chi_square / n) ** (1.0 / 3.0) - (1.0 - spread)) / math.sqrt(spread)
    if deviate > _FAR:
        return 1
    half = 0.5 * n
    bound = half * math.log(0.5 * chi_square) - math.lgamma(half + 1.0) if chi_square > 0.0 else -math.inf
    return -1 if bound < _LOG_FAR or deviate < -_FAR else 0
