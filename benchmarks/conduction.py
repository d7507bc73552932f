# SPDX-License-Identifier: GPL-3.0-or-later
"""What conduction costs beside contact: ratios of CPU time, each taken as the least of several rounds, both sides in turn.

    python benchmarks/conduction.py

A spot and the heat of friction beside an exact state from its radius, a conduction beside an exact medium, a step in time, a table.
Ends with status 1 where a budget is missed.
"""

import sys
import time
from collections.abc import Callable
from functools import partial

import numpy as np

import mdrcontact as mdr
from mdrcontact.conduction import Conduction, Conductor, LayeredConductor

ROUNDS = 9
RATIOS = (0.3, 1.0, 3.0, 10.0)
"""a/h"""


def cost(work: Callable[[], object], repeats: int) -> float:
    """CPU seconds of one call."""
    before = time.process_time()
    for _ in range(repeats):
        work()
    return (time.process_time() - before) / repeats


def compare(first: Callable[[], object], second: Callable[[], object], repeats: int) -> tuple[float, float]:
    """Least costs of both, in turn."""
    rounds = [(cost(first, repeats), cost(second, repeats)) for _ in range(ROUNDS)]
    return min(a for a, _ in rounds), min(b for _, b in rounds)


def main() -> int:
    """Prints the rows; how many budgets are missed."""
    film = mdr.Elastic(50e9, 0.36, Conductor(9.17e6, None, 1.7e6))
    base = mdr.Elastic(117e9, 0.34, Conductor(59.6e6, None, 3.4e6))
    body = mdr.Coated(film, 1.0, base)
    contact, conduction = mdr.Contact(mdr.Paraboloid(1e3), body), Conduction(body)
    rows, late = [], 0
    for a in RATIOS:
        radii = np.full(200, a)
        mine, state = compare(partial(conduction.at_radius, radii), partial(contact.at_radius, radii), 2)
        rows.append((f"conductance and slope, a/h = {a:g}", "an exact state from its radius", mine / state, 1.2))
    mine, theirs = compare(lambda: Conduction(body), lambda: mdr.Coated(film, 1.0, base), 5)
    rows.append(("a conduction", "an exact medium", mine / theirs, 1.0))
    for a in RATIOS:
        radii = np.full(200, a)
        states = contact.at_radius(radii)
        mine, state = compare(partial(conduction.friction_heat, states, 0.1, 1.0), partial(contact.at_radius, radii), 2)
        rows.append((f"friction heat, a/h = {a:g}", "an exact state from its radius", mine / state, 2.0))
    print("\n## Heat and current\n\n| what | beside | ratio | at most |\n|---|---|---|---|")
    for what, beside, ratio, most in rows:
        late += ratio > most
        print(f"| {what} | {beside} | {ratio:.2f} | {most:g} |")
    stack = LayeredConductor([(Conductor(2.0, None, 1.0), 1.0), mdr.Interface(0.2)], Conductor(1.0, None, 3.0))
    heat, times = Conduction(stack), np.geomspace(1e-3, 10.0, 50)
    milliseconds = 1e3 * min(cost(lambda: heat.step(times, 1.0), 1) for _ in range(5))
    print(f"\nA step at 50 times over four decades takes {milliseconds:.0f} ms (at most 100),", end=" ")
    table, radii = conduction.tabulated(0.1, 10.0), np.geomspace(0.1, 10.0, 100_000)
    print(f"a tabulated conductance {1e4 * min(cost(lambda: table.at_radius(radii), 1) for _ in range(5)):.0f} ns.")
    return late + (milliseconds > 100.0)


if __name__ == "__main__":
    sys.exit(main() > 0)
