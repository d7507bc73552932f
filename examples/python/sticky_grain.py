# SPDX-License-Identifier: GPL-3.0-or-later
"""A sticky grain of metal that is loaded, unloaded and loaded again: force, stiffness and energies of a plastic law with adhesion.

The law remembers the largest depth of each contact and whether it is closed. Unloading follows the imprint of the largest
depth. Its edge rests there until adhesion detaches it: the pull-off force grows with the load before. Reloading retraces
unloading and joins the first loading.
"""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

RADIUS, WORK = 20e-6, 0.5  # of the grain [m], of adhesion [J/m^2]
metal = mdr.plastic.Yielding(mdr.Elastic(70e9, 0.33), yield_stress=0.6e9)
law = mdr.plastic.PlasticLaw(mdr.Paraboloid(RADIUS), metal, 40e-9, work_of_adhesion=WORK)
turns = 1e-9 * np.array([-40.0, 6.0, -40.0, 15.0, 10.0, 15.0, 30.0, -40.0])
depth = np.concatenate([np.linspace(a, b, 400)[1:] for a, b in zip(turns, turns[1:], strict=False)])

memory = law.contacts(1)
force, stored, lost = (np.zeros(len(depth)) for _ in range(3))
for i, d in enumerate(depth):
    force[i] = law.advance(memory, [d]).force[0]
    stored[i], lost[i] = (part[0] for part in law.energies(memory, [d]))

figure, (left, right) = plt.subplots(1, 2, figsize=(9.6, 4.0), layout="constrained")
left.plot(1e9 * depth, 1e6 * force, linewidth=1.2)
left.axhline(0.0, color="grey", linewidth=0.8)
left.set(xlabel="depth d [nm]", ylabel="force F [µN]", xlim=(-15, 31), title="loading, unloading, reloading")
path = 1e9 * np.abs(np.diff(depth, prepend=depth[0])).cumsum()
right.plot(path, 1e12 * stored, label="stored")
right.plot(path, 1e12 * lost, label="dissipated")
right.set(xlabel="path [nm]", ylabel="energy [pJ]", title="energies")
right.legend(frameon=False)
figure.savefig("sticky_grain.png", dpi=130)

assert np.all(np.diff(lost) >= -1e-12 * lost[-1]), "dissipated energy never falls"
print(f"largest tension {1e6 * -force.min():.1f} uN, JKR of the grain {1e6 * 1.5 * np.pi * WORK * RADIUS:.1f} uN")
print("written: sticky_grain.png")
