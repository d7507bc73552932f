# SPDX-License-Identifier: GPL-3.0-or-later
"""The approach curve of a disc electrode: its current over a conducting and over an insulating substrate at distance L.

Diffusion to a disc in a wide insulating sheath is the conduction of a spot through a layer of electrolyte. Over a substrate that
turns the species back (positive feedback) the base is perfect; over one that takes none (negative feedback) it insulates, and the
species comes in from the edge of the sheath at r = b. Close to a conductor the current is pi/(4 L/a) + ln 2, far away 1, both in
units of 4 D c a.
"""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from mdrcontact.conduction import INSULATING, PERFECT, Conduction, Conductor, LayeredConductor

electrolyte = Conductor(1.0)  # D; the current is then that per difference of concentration
distance = np.geomspace(0.03, 10.0, 41)  # L/a


def current(base, distance, **edge):
    """Along the approach, in units of that far away from all."""
    films = (LayeredConductor([(electrolyte, float(gap))], base) for gap in distance)
    return np.array([Conduction(film, **edge).at_radius(1.0).conductance / 4.0 for film in films])


over_conductor = current(PERFECT, distance)
figure, axes = plt.subplots(figsize=(5.4, 3.8), layout="constrained")
axes.loglog(distance, over_conductor, label="over a conductor")
axes.loglog(distance, np.pi / (4.0 * distance) + np.log(2.0), ":", label="π a/(4 L) + ln 2")
for sheath in (20.0, 200.0):
    near = distance[distance < 0.02 * sheath]  # the edge of the sheath is far away
    label = f"over an insulator, sheath b = {sheath:.0f} a"
    axes.loglog(near, current(INSULATING, near, sink=sheath), "--", label=label)
axes.axhline(1.0, color="grey", linewidth=0.8)
axes.set(xlabel="distance L/a", ylabel="current/(4 D c a)", title="approach of a disc electrode")
axes.legend(frameon=False, fontsize=8)
figure.savefig("disc_electrode.png", dpi=130)
close, far = over_conductor[0] - (np.pi / (4.0 * distance[0]) + np.log(2.0)), over_conductor[-1] - 1.0
print(f"over a conductor: at L = {distance[0]:.2f} a {close:+.1e} from the limit, at {distance[-1]:.0f} a {far:+.1e} from none")
print("written: disc_electrode.png")
