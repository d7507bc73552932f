# SPDX-License-Identifier: GPL-3.0-or-later
"""What wear costs: CPU time of a step with 80 intervals, and of a run to sigma = k E0* s = 30 a0, each the least of some rounds.

    python benchmarks/wear.py

Ends with status 1 where a budget is missed.
"""

import sys
import time

import mdrcontact as mdr

ROUNDS, STEPS, PART = 5, 20, 0.02
"""Rounds; steps of a round; their length over a0, less than that of the steps a path is divided into there."""
FILM, SOFT, STIFF = (mdr.Elastic(E, 0.3) for E in (0.91, 0.091, 9.1))
BODIES = (
    ("homogeneous", mdr.Homogeneous(FILM), 2.0),
    ("film 10:1", mdr.Coated(FILM, 1.0, SOFT), 10.0),
    ("film 1:10", mdr.Coated(FILM, 1.0, STIFF), 10.0),
)
"""With E0* = 1, and the milliseconds that a step may take."""
LONGEST_RUN = 2.0


def cost(medium: mdr.Medium, scheme: str) -> tuple[float, float]:
    """Milliseconds of a step at sigma = a0, and seconds of a run to 30 a0; a0 = h = 1."""
    contact = mdr.Contact(mdr.Paraboloid(1.0), medium)
    force = float(contact.at_radius(1.0).force)
    steps, runs = [], []
    for _ in range(ROUNDS):
        began = time.process_time()
        run = mdr.wear.Wear(contact, 1.0).history(force=force, scheme=scheme)
        run.advance(30.0, force=force)
        runs.append(time.process_time() - began)
        short = mdr.wear.Wear(contact, 1.0).history(force=force, scheme=scheme)
        short.advance(1.0, force=force)
        began = time.process_time()
        for _ in range(STEPS):
            short.advance(PART, force=force)
        steps.append((time.process_time() - began) / STEPS)
    return 1e3 * min(steps), min(runs)


def main() -> int:
    """Prints the rows; whether a budget is missed."""
    late = False
    print("\n## Wear\n\n| body | scheme | a step [ms] | at most | to 30 a0 [s] | at most |\n|---|---|---|---|---|---|")
    for name, medium, most in BODIES:
        for scheme in ("disc", "rings"):
            step, run = cost(medium, scheme)
            late = late or step > most or run > LONGEST_RUN
            print(f"| {name} | {scheme} | {step:.2f} | {most:g} | {run:.2f} | {LONGEST_RUN:g} |")
    return int(late)


if __name__ == "__main__":
    sys.exit(main())
