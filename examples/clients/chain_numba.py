# SPDX-License-Identifier: GPL-3.0-or-later
"""numba: a steel ball runs into a chain of a hundred coated ones; the time loop is one compiled function with the law in it.

Checks: momentum and the energy of motion and contacts stay at 200 of the steps; the pulse throws off the last ball with most of the
speed.
SI units. Steel balls of 5 mm, E = 210 GPa, nu = 0.3, 7850 kg/m^3, painted with 20 um of E = 3 GPa, nu = 0.4 (handbook values). Ball
on ball is a ball of half the radius on a flat; the paint of both is taken as one of twice the thickness.
"""

import time

import numba
import numpy as np

import mdrcontact as mdr
from mdrcontact import interop

RADIUS, SPEED, COUNT, STEP = 5e-3, 0.1, 100, 2e-7
PAINTED = mdr.Coated(mdr.Elastic(3e9, 0.4), 40e-6, mdr.Elastic(210e9 / 2, 0.3), "exact")
LAW = mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(RADIUS / 2), PAINTED), 20e-6)
force = interop.numba_function(LAW)


@numba.njit
def run(x, v, mass, step, steps, record):
    """Leapfrog; records velocities and overlaps every `steps // len(record)` steps."""
    count, every = x.size, steps // len(record)
    pull = np.zeros(count)
    for i in range(steps):
        pull[:] = 0.0
        for j in range(count - 1):
            F, _ = force(x[j] - x[j + 1])
            pull[j] -= F
            pull[j + 1] += F
        for j in range(count):
            v[j] += step * pull[j] / mass
            x[j] += step * v[j]
        if i % every == every - 1:
            record[i // every, 0] = v - 0.5 * step * pull / mass
            record[i // every, 1] = x - step * v


def main():
    mass = 7850 * 4 / 3 * np.pi * RADIUS**3
    x, v = np.zeros(COUNT), np.zeros(COUNT)  # gaps between neighbours are counted from touch
    x[0], v[0] = -1e-6, SPEED
    record = np.zeros((200, 2, COUNT))
    run(x.copy(), v.copy(), mass, STEP, 200, record)  # compiles
    steps = 60_000
    begin = time.perf_counter()
    run(x, v, mass, STEP, steps, record)
    spent = time.perf_counter() - begin
    motion = 0.5 * mass * (record[:, 0] ** 2).sum(axis=1)
    contact = LAW.energy(record[:, 1, :-1] - record[:, 1, 1:]).sum(axis=1)
    energy = np.abs((motion + contact) / (0.5 * mass * SPEED**2) - 1).max()
    momentum = np.abs(record[:, 0].sum(axis=1) / SPEED - 1).max()
    print(f"{1e9 * spent / steps / (COUNT - 1):.1f} ns a contact and step")
    print(f"last ball: {record[-1, 0, -1] / SPEED:.3f} of the speed")
    print(f"largest relative change of momentum {momentum:.1e}, of energy {energy:.1e}")
    assert energy < 1e-4 and momentum < 1e-10 and record[-1, 0, -1] > 0.5 * SPEED


if __name__ == "__main__":
    main()
