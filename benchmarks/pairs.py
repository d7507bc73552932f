#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the exact contact of two deformable bodies costs against its costlier body under a rigid tip: a state, and a law.

Budgets (exit status 1 if one is missed): a state at most 1.3 times, a law at most twice. Prints a section of
tests/data/benchmarks.md: python pairs.py >> tests/data/benchmarks.md.
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before any library is loaded

import itertools
import math
import sys
import time
import warnings

import numpy as np

import mdrcontact as mdr

STATE_BUDGET, LAW_BUDGET = 1.3, 2.0
STATES, ROUNDS, PATIENCE = 16, 15, 0.1


def bodies():
    steel, tin, dlc, gel = (mdr.Elastic(*values) for values in ((210.0, 0.3), (450.0, 0.25), (150.0, 0.2), (5.0, 0.4)))
    return {
        "TiN 1 on steel": mdr.Coated(tin, 1.0, steel),
        "soft film 0.3 on steel": mdr.Coated(gel, 0.3, steel),
        "DLC 0.3 on steel": mdr.Coated(dlc, 0.3, steel),
        "DLC 0.05 on steel": mdr.Coated(dlc, 0.05, steel),
        "3 layers, 1.5": mdr.Layered([(tin, 0.5), (mdr.Elastic(100.0, 0.3), 0.3), (mdr.Elastic(300.0, 0.2), 0.7)], steel),
        "3 layers, 0.15": mdr.Layered([(tin, 0.05), (mdr.Elastic(100.0, 0.3), 0.03), (mdr.Elastic(300.0, 0.2), 0.07)], steel),
        "soft film 2, rigid base": mdr.Coated(gel, 2.0, mdr.RIGID),
        "graded 1 on steel": mdr.Graded([0.0, 0.5, 1.0], [450.0, 300.0, 210.0], 0.3, model="exact"),
    }


def fastest(actions):
    """Processor seconds of each action: the fastest of some rounds, the actions by turns, for about PATIENCE seconds."""
    best = [math.inf] * len(actions)
    begin = time.process_time()
    for done in range(ROUNDS):
        if done > 1 and time.process_time() - begin > PATIENCE:
            break
        for k, action in enumerate(actions):
            start = time.process_time()
            action()
            best[k] = min(best[k], time.process_time() - start)
    return best


def state_costs(alone):
    """(ratio, microseconds, what) of each pair, tip and radius, the costliest first."""
    costs = []
    for tip, a in itertools.product((mdr.Paraboloid(10.0), mdr.Cone(0.3)), (0.1, 0.3, 1.0, 3.0, 10.0)):
        for (name, one), (other_name, other) in itertools.combinations(alone.items(), 2):
            # a cone on a graded body takes a thousand times as long as other states: two of them
            count = 2 if "graded" in other_name and isinstance(tip, mdr.Cone) else STATES
            radii = a * np.linspace(1.0, 1.0001, count)
            contacts = [mdr.Contact(tip, m) for m in (mdr.Pair(one, other), one, other)]
            pair, *single = fastest([lambda c=c, x=radii: c.at_radius(x) for c in contacts])
            what = f"{type(tip).__name__.lower()}, a = {a:g}: {name}; {other_name}"
            costs.append((pair / max(single), 1e6 * pair / count, what))
    return sorted(costs, reverse=True)


def law_cost(one, other):
    """Ratio of the time to make a law."""
    contacts = [mdr.Contact(mdr.Paraboloid(10.0), m) for m in (mdr.Pair(one, other), one, other)]
    depths = [float(contact.at_radius(3.0).depth) for contact in contacts]
    laws = [lambda c=c, d=d: mdr.ContactLaw(c, largest_depth=d) for c, d in zip(contacts, depths, strict=True)]
    pair, *single = fastest(laws)
    return pair / max(single)


def main():
    mdr.set_threads(1)
    warnings.simplefilter("ignore", mdr.errors.SeparationInsideWarning)  # stiff films under cones: its cost is measured here
    alone = bodies()
    costs = state_costs(alone)
    law = law_cost(alone["TiN 1 on steel"], alone["DLC 0.3 on steel"])
    over = sum(ratio > STATE_BUDGET for ratio, *_ in costs)
    print("\n## Pairs of bodies\n")
    print("Made by `benchmarks/pairs.py`: an exact state of two deformable bodies against that of its costlier body under a rigid")
    print(
        f"tip, from a contact radius, processor time; {len(costs)} cases, {over} of them above the budget of {STATE_BUDGET}, median"
    )
    print(f"{np.median([ratio for ratio, *_ in costs]):.2f}, the costliest:\n")
    print("| pair | us a state | ratio |\n|---|---|---|")
    for ratio, cost, what in costs[:5]:
        print(f"| {what} | {cost:.1f} | {ratio:.2f} |")
    print(f"\nA law of TiN on steel against DLC on steel: {law:.2f} times the costlier body's, budget {LAW_BUDGET:g}.")
    return 1 if over or law > LAW_BUDGET else 0


if __name__ == "__main__":
    sys.exit(main())
