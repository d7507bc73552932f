# SPDX-License-Identifier: GPL-3.0-or-later
"""What layers with an axis and interfaces that give cost: ratios of CPU time, each taken as the least of several rounds, both sides
in turn.

    python benchmarks/coatings.py

States and media beside those of isotropic, bonded layers of like stiffness. Ends with status 1 where a budget is missed.
"""

import sys
import time
from collections.abc import Callable
from functools import partial

import numpy as np

import mdrcontact as mdr

ROUNDS = 9
RATIOS = (0.1, 1.0, 10.0)
"""a/h"""
GAN = mdr.TransverselyIsotropic(C11=390.0, C12=145.0, C13=106.0, C33=398.0, C44=105.0)
LIKE, BASE = mdr.Elastic(295.0, 0.23), mdr.Elastic(130.0, 0.28)


def cost(work: Callable[[], object], repeats: int) -> float:
    """CPU seconds of one call."""
    before = time.process_time()
    for _ in range(repeats):
        work()
    return (time.process_time() - before) / repeats


def compare(first: Callable[[], object], second: Callable[[], object], repeats: int) -> float:
    """Cost of the first over that of the second."""
    rounds = [(cost(first, repeats), cost(second, repeats)) for _ in range(ROUNDS)]
    return min(a for a, _ in rounds) / min(b for _, b in rounds)


def stacked(film: object, interface: mdr.Interface | None = None) -> mdr.Layered:
    """A film on a half-space."""
    return mdr.Layered([mdr.Layer(film, 1.0, interface=interface)], BASE)


def main() -> int:
    """Prints the rows; how many budgets are missed."""
    springs = mdr.Interface(normal=1e3, tangential=3e2)
    plain, axis = (mdr.Contact(mdr.Paraboloid(1e3), stacked(film)) for film in (LIKE, GAN))
    rows = []
    for a in RATIOS:
        radii = np.full(200, a)
        ratio = compare(partial(axis.at_radius, radii), partial(plain.at_radius, radii), 2)
        rows.append((f"a state of a film with an axis, a/h = {a:g}", "of an isotropic film", ratio, 1.2))
    soft = mdr.Elastic(100.0, 0.3)
    closed = "an isotropic film, by its closed form"
    film = partial(stacked, LIKE)
    for what, beside, first, second, most in (
        ("a film with an axis, tabulated", closed, partial(stacked, GAN), film, 1.5),
        ("two layers, one with an axis", "two isotropic layers", partial(two, GAN, soft), partial(two, LIKE, soft), 1.5),
        ("a film on springs", closed, partial(stacked, LIKE, springs), film, 8.0),
    ):
        rows.append((what, beside, compare(first, second, 5), most))
    print("\n## Coatings with an axis\n\n| what | beside | ratio | at most |\n|---|---|---|---|")
    late = 0
    for what, beside, ratio, most in rows:
        late += ratio > most
        print(f"| {what} | {beside} | {ratio:.2f} | {most:g} |")
    return late


def two(film: object, below: mdr.Elastic) -> mdr.Layered:
    """Two layers on a half-space."""
    return mdr.Layered([mdr.Layer(film, 1.0), mdr.Layer(below, 0.5)], BASE)


if __name__ == "__main__":
    sys.exit(main())
