# SPDX-License-Identifier: GPL-3.0-or-later
"""Restitution of metal balls against speed, with and without a soft coat.

A steel ball of radius 1 mm hits a rigid plane. Without a coat the law of first loading is that of finite elements. A coat of
soft iron, 80 um thick and as stiff as steel, yields first; its curve of first loading follows from the overload rule.
Restitution does not fall as the power -1/4 of the speed, which is a limit. The coat takes energy at speeds at which steel is
nearly elastic.
"""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

RADIUS, DENSITY, THICKNESS = 1e-3, 7850.0, 80e-6  # [m], [kg/m^3], [m]
mass = DENSITY * 4.0 / 3.0 * np.pi * RADIUS**3
steel = mdr.Elastic(210e9, 0.30)
ball = mdr.Paraboloid(RADIUS)

bare = {
    f"steel, Y = {stress / 1e9:.1f} GPa": mdr.plastic.PlasticLaw(ball, mdr.plastic.Yielding(steel, yield_stress=stress), 4e-6)
    for stress in (0.5e9, 1e9, 2e9)
}
contact = mdr.Contact(ball, mdr.Coated(steel, THICKNESS, steel))
rule = mdr.plastic.Overload(contact, [0.3e9, 2e9])
points = rule.points(np.geomspace(0.002, 1.0, 60) * float(rule.at_radius(0.999 * THICKNESS).depth))
coated = mdr.plastic.PlasticLaw.from_table(*points, modulus=steel.E / (1.0 - steel.nu**2))
laws = {**bare, "2.0 GPa with an iron coat, Y = 0.3 GPa": coated}

figure, (left, right) = plt.subplots(1, 2, figsize=(9.6, 4.0), layout="constrained")
for name, law in laws.items():
    largest = np.sqrt(2.0 * float(law.loading(0.999 * law.largest_depth).work) / mass)
    speed = np.geomspace(1e-3, 1.0, 80) * largest
    restitution = law.restitution(mass, speed)
    left.loglog(speed, restitution, label=name)
    depth = np.linspace(0.0, law.largest_depth, 100)[1:]
    right.loglog(1e6 * depth, law.loading(depth).force)
    power = np.polyfit(np.log(speed[-10:]), np.log(restitution[-10:]), 1)[0]
    print(f"{name}: e = {restitution[-1]:.2f} at {largest:.2f} m/s, where it falls as the power {power:.2f} of the speed")
speed = np.array([0.05, 3.0])
left.loglog(speed, 0.6 * (speed / speed[0]) ** -0.25, "k:", label="power -1/4")
left.set(xlabel="speed V [m/s]", ylabel="restitution e", title="balls of 2 mm on a rigid plane", ylim=(0.2, 1.1))
left.set_yticks([0.2, 0.3, 0.4, 0.6, 0.8, 1.0], ["0.2", "0.3", "0.4", "0.6", "0.8", "1"])
left.yaxis.minorticks_off()
right.set(xlabel="depth d [µm]", ylabel="force F [N]", title="first loading")
left.legend(frameon=False, fontsize=8)
figure.savefig("bouncing_metal.png", dpi=130)
print("written: bouncing_metal.png")
