# SPDX-License-Identifier: GPL-3.0-or-later
"""The effective indenter of Bolshakov and Pharr, of indents in a half-space and in coatings.

A yielded contact unloads as an elastic contact of a blunter profile, whose shape follows from the pressure at the largest load. The
three indents have the same pressure, that of a sphere of radius R = 10 um in a metal (L = a E*/(R Y) = 16, P = 2.41, S = 1.97), in
the metal alone and in films of it on a stiffer and on a softer body. The pressure is theirs to a few percent up to a = h.
"""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

metal, radius, tip = mdr.Elastic(70e9, 0.30), 1e-6, mdr.Sphere(10e-6)
yield_stress = metal.E / (1.0 - metal.nu**2) * radius / (tip.radius * 16.0)
mean, scale = 2.412 * yield_stress, 1.972 * radius  # F/(pi a^2), and q(0) over it
two_terms = (np.pi / 2.0 * radius - 2.0 / 3.0 * scale) / (np.pi / 4.0 - 2.0 / 3.0)
uniform, hertz = mean * two_terms / (2.0 * radius), mean * (scale - two_terms) * 2.0 / (np.pi * radius)
bodies = {
    "metal": mdr.Homogeneous(metal),
    "film on a body 4 times as stiff, h = a": mdr.Coated(metal, radius, mdr.Elastic(280e9, 0.3)),
    "film on a body half as stiff, h = a": mdr.Coated(metal, radius, mdr.Elastic(35e9, 0.3)),
}

figure, (left, middle, right) = plt.subplots(1, 3, figsize=(11.5, 3.8), layout="constrained")
r = np.linspace(0.0, radius, 101)
for name, body in bodies.items():
    imprint = mdr.plastic.Imprint.from_two_terms(body, radius, uniform, hertz)
    states = imprint.contact().at_force(np.linspace(0.01, 1.0, 60) * imprint.force)
    recovered = states.depth / imprint.recovery
    left.plot(1e9 * states.depth, 1e3 * states.force, label=name)
    middle.plot(r / radius, 1e9 * np.asarray(imprint.profile.height(r)))
    upper = recovered > 0.5
    power = np.polyfit(np.log(recovered[upper]), np.log(states.force[upper]), 1)[0]
    right.loglog(recovered, states.force / imprint.force, label=f"exponent {power:.2f}")
    ratio = imprint.reverse_yield([yield_stress] + [np.inf] * (len(body.parameters()) > 2)).ratio
    print(f"{name}: recovers {1e9 * imprint.recovery:.1f} nm, exponent {power:.3f}, R_Y = {ratio:.2f}")
middle.plot(r / radius, 1e9 * tip.height(r), "k--", label="sphere, R = 10 µm")
left.set(xlabel="depth after the residual depth [nm]", ylabel="force F [mN]", title="unloading and reloading")
middle.set(xlabel="r/a", ylabel="height [nm]", title="effective indenter")
right.set(xlabel="recovered depth, relative", ylabel="$F/F_m$", title="power of the unloading curve")
left.legend(frameon=False, fontsize=7)
middle.legend(frameon=False, fontsize=8)
right.legend(frameon=False, fontsize=8)
figure.savefig("effective_indenter.png", dpi=130)
print("written: effective_indenter.png")
