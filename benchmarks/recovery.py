# SPDX-License-Identifier: GPL-3.0-or-later
"""What the studies of intervals share: noise whose neighbours are alike, and how often intervals hold the true values."""

from __future__ import annotations

import argparse
import sys
import warnings

import numpy as np

import mdrcontact as mdr


def autoregression(random: np.random.Generator, lag: float, points: int) -> np.ndarray:
    """Noise of variance 1 whose neighbours have the correlation `lag`."""
    noise = random.standard_normal(points)
    for i in range(1, points):
        noise[i] = lag * noise[i - 1] + np.sqrt(1.0 - lag**2) * noise[i]
    return noise


def options(about: str) -> argparse.Namespace:
    """Of the command line: --sets, --lag, --noise. Warnings of the package are not shown."""
    parser = argparse.ArgumentParser(description=about.splitlines()[0])
    parser.add_argument("--sets", type=int, default=200)
    for name, default in {"lag": 0.9, "noise": 0.02}.items():
        parser.add_argument(f"--{name}", type=float, default=default)
    warnings.simplefilter("ignore", mdr.MDRWarning)
    return parser.parse_args()


class Count:
    """How often intervals hold the true values, and where estimates lie."""

    def __init__(self, truth: dict[str, float]) -> None:
        """Nothing counted yet."""
        self.truth, self.sets, self.ratios = truth, [], []

    def add(self, values: dict[str, float], intervals: dict[str, tuple[float, float]]) -> None:
        """One fit."""
        self.sets.append([intervals[name][0] <= true <= intervals[name][1] for name, true in self.truth.items()])
        self.ratios.append([values[name] / true for name, true in self.truth.items()])

    def report(self, decisive: str) -> None:
        """Prints all shares; the exit status is 1 unless the decisive value's is 91 to 98 %."""
        shares = dict(zip(self.truth, np.mean(self.sets, axis=0), strict=True))
        for i, (name, share) in enumerate(shares.items()):
            found = np.array(self.ratios)[:, i]
            print(f"{name:18} inside {100.0 * share:5.1f} %   found/true {np.mean(found):.4f} +- {np.std(found):.4f}")
        if not 0.91 <= shares[decisive] <= 0.98:
            sys.exit(f"the interval of {decisive} does not hold what it promises")
