# SPDX-License-Identifier: GPL-3.0-or-later
"""A discrete-element client that conducts heat: a column of coated grains, packed by its weight and heated from below.

A compiled law gives force and conductance of each neck in nanoseconds. The column
rests under its load; the temperatures of the grains follow from the heat that their necks carry. Compared: grains of the bulk
material, as codes take them that do not know the coating.
"""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr
from mdrcontact.conduction import Conduction, Conductor

RADIUS, COATING = 1e-3, 2e-6
GRAINS, STEPS = 40, 4000
CAPACITY = 4.0 / 3.0 * np.pi * RADIUS**3 * 3.5e6  # J/K of a grain of steel

oxide = mdr.Elastic(200e9, 0.25, Conductor(2.0))  # a scale that conducts poorly
steel = mdr.Elastic(210e9, 0.3, Conductor(45.0))
grain = mdr.Coated(oxide, COATING, steel)
contact = mdr.Contact(mdr.Paraboloid.between(RADIUS, RADIUS), mdr.Pair(grain, grain))
deepest = contact.at_force(60.0)
law = mdr.ContactLaw(contact, float(deepest.depth), tolerance=1e-6, conduction=Conduction(contact.medium))
bare = Conduction(steel.conductor, steel.conductor)

force = np.linspace(50.0, 5.0, GRAINS - 1)  # each neck bears the load and what lies above it
necks = law.at_force(force)
found = law.conductance(necks.depth)[0], bare.at_radius(np.asarray(necks.radius)).conductance


def march(conductance):
    """Temperatures of the column, its lowest grain held at 100 K above the others' start."""
    temperature = np.zeros(GRAINS)
    temperature[0] = 100.0
    step = 0.2 * CAPACITY / conductance.max()
    shown = []
    for i in range(STEPS):
        heat = conductance * np.diff(temperature)
        temperature[1:-1] += step / CAPACITY * np.diff(heat)
        temperature[-1] -= step / CAPACITY * heat[-1]
        if i + 1 in (STEPS // 16, STEPS // 4, STEPS):
            shown.append(((i + 1) * step, temperature.copy()))
    return shown


figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.6), layout="constrained")
axes[0].plot(force, 1e3 * np.asarray(found[0]), label="coated grains")
axes[0].plot(force, 1e3 * np.asarray(found[1]), "--", label="bulk material, 2 S a")
axes[0].set(xlabel="force of a neck [N]", ylabel="conductance [mW/K]", title="necks")
axes[0].legend(frameon=False)
for time, temperature in march(np.asarray(found[0])):
    axes[1].plot(temperature, label=f"{time:.0f} s")
axes[1].set(xlabel="grain, from below", ylabel="temperature rise [K]", title="coated grains")
axes[1].legend(frameon=False)
figure.savefig("heat_chain.png", dpi=130)
print(f"conductance of the lowest neck: {1e3 * found[0][0]:.2f} mW/K, without the coating {1e3 * found[1][0]:.2f} mW/K")
print("written: heat_chain.png")
