# SPDX-License-Identifier: GPL-3.0-or-later
"""What surfaces with tension and plates cost: CPU time of a state, the least of some rounds, and of making the medium.

    python benchmarks/tension.py

Ends with status 1 where a budget is missed.
"""

import sys
import time
import warnings
from collections.abc import Callable

import numpy as np

import mdrcontact as mdr

ROUNDS, STATES = 5, 10
GEL = mdr.Elastic(0.75, 0.5)
TENSE = mdr.Surface(0.5)
"""E* = 1, l = 1"""
ROWS = (
    ("half-space, from the table, a = 1", lambda: mdr.Homogeneous(GEL, surface=TENSE), 1.0, 0.05),
    ("half-space, from the table, a = 10", lambda: mdr.Homogeneous(GEL, surface=TENSE), 10.0, 0.05),
    ("half-space, solved, a = 5e-4", lambda: mdr.Homogeneous(GEL, surface=TENSE), 5e-4, 3.0),
    ("half-space, solved, a = 300", lambda: mdr.Homogeneous(GEL, surface=TENSE), 300.0, 3.0),
    ("film on a rigid base, h = 1, a = 0.3", lambda: mdr.Coated(GEL, 1.0, mdr.RIGID, surface=TENSE), 0.3, 20.0),
    ("film on a rigid base, h = 1, a = 3", lambda: mdr.Coated(GEL, 1.0, mdr.RIGID, surface=TENSE), 3.0, 20.0),
    ("film on a rigid base, h = 1, a = 10", lambda: mdr.Coated(GEL, 1.0, mdr.RIGID, surface=TENSE), 10.0, 20.0),
    ("film on a rigid base, h = 1, a = 29", lambda: mdr.Coated(GEL, 1.0, mdr.RIGID, surface=TENSE), 29.0, 20.0),
    ("film on a half-space, h = 1, a = 3", lambda: mdr.Coated(GEL, 1.0, mdr.Elastic(7.5, 0.3), surface=TENSE), 3.0, 20.0),
    ("plate, (2 B/E*)^(1/3) = 1, a = 1", lambda: mdr.Homogeneous(GEL, surface=mdr.Surface(0.0, 0.5)), 1.0, 20.0),
)
"""With a, and the milliseconds that a state may take."""


def cost(make: Callable[[], mdr.Medium], a: float) -> tuple[float, float]:
    """Milliseconds of a state under a paraboloid of radius 100, and of the medium."""
    began = time.process_time()
    contact = mdr.Contact(mdr.Paraboloid(100.0), make())
    made = time.process_time() - began
    radii = np.full(STATES, a) * np.linspace(1.0, 1.01, STATES)
    least = np.inf
    for _ in range(ROUNDS):
        began = time.process_time()
        contact.at_radius(radii)
        least = min(least, (time.process_time() - began) / STATES)
    return 1e3 * least, 1e3 * made


def main() -> int:
    """Prints the rows; whether a budget is missed."""
    late = False
    warnings.simplefilter("ignore", mdr.MDRWarning)
    mdr.set_threads(1)
    print("\n## Surfaces with tension and plates\n\n| body | a state [ms] | at most | its medium [ms] |\n|---|---|---|---|")
    for name, make, a, most in ROWS:
        state, medium = cost(make, a)
        late = late or state > most
        print(f"| {name} | {state:.3f} | {most:g} | {medium:.0f} |")
    return int(late)


if __name__ == "__main__":
    sys.exit(main())
