# SPDX-License-Identifier: GPL-3.0-or-later
"""What imprints cost: CPU time of a state of an imprint and of a paraboloid on the same film, each the least of some rounds.

    python benchmarks/plastic.py

Ends with status 1 where a budget is missed.
"""

import sys
import time

import numpy as np

import mdrcontact as mdr
from mdrcontact.plastic import Imprint

ROUNDS, STATES = 7, 200
MOST = 3.0
"""Times that a state of an imprint may take, in those of a paraboloid."""
RATIOS, WIDTHS = (0.25, 4.0, 20.0), (0.3, 1.0, 3.0, 10.0)
"""Moduli below the film over its own, contact radii over its thickness."""


def cost(contact: mdr.Contact, largest: float) -> float:
    """Microseconds of a state."""
    depths = largest * np.linspace(0.02, 1.0, STATES)
    rounds = []
    for _ in range(ROUNDS):
        began = time.process_time()
        contact.at_depth(depths)
        rounds.append(time.process_time() - began)
    return 1e6 * min(rounds) / STATES


def main() -> int:
    """Prints the rows; whether a budget is missed."""
    late = False
    print("\n## Imprints\n\n| E1/E0 | a/h | paraboloid [us] | imprint [us] | ratio | at most |\n|---|---|---|---|---|---|")
    for ratio in RATIOS:
        for width in WIDTHS:
            film = mdr.Coated(mdr.Elastic(1.0, 0.3), 1.0, mdr.Elastic(ratio, 0.3))
            imprint = Imprint.from_two_terms(film, width, 0.012, 0.012)
            smooth = mdr.Contact(mdr.Paraboloid(100.0), film)
            tip, ours = cost(smooth, float(smooth.at_radius(width).depth)), cost(imprint.contact(), imprint.recovery)
            late = late or ours > MOST * tip
            print(f"| {ratio:g} | {width:g} | {tip:.1f} | {ours:.1f} | {ours / tip:.1f} | {MOST:g} |")
    return int(late)


if __name__ == "__main__":
    sys.exit(main())
