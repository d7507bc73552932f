# SPDX-License-Identifier: GPL-3.0-or-later
"""Surface tension and modulus of a soft gel from force curves: which spheres separate the two.

A gel of 3 kPa with a surface of 30 mN/m (l = 2 tau/E* = 15 um) is pressed by spheres of several sizes to a tenth of their radius,
with 1 % of noise. Each curve alone is fitted by modulus and tension together; a fit without tension says what modulus it would be
taken for.
"""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

modulus, tension = 3e3, 30e-3  # Pa, N/m
gel = mdr.Homogeneous(mdr.Elastic(modulus, 0.5), surface=mdr.Surface(tension))
start = mdr.Homogeneous(mdr.Elastic(2e3, 0.5), surface=mdr.Surface(10e-3))
radii = np.array([3e-6, 10e-6, 30e-6, 100e-6, 300e-6])
random = np.random.default_rng(1)

rows = []
for radius in radii:
    tip = mdr.Paraboloid(radius)
    depth = np.linspace(0.005, 0.1, 40) * radius
    force = np.asarray(mdr.Contact(tip, gel).at_depth(depth).force)
    noise = 0.01 * force
    data = mdr.instruments.ForceDepth(depth, force + noise * random.standard_normal(depth.size), sd=noise)
    both = mdr.instruments.fit(data, tip, start, free=["E", "surface.tension"])
    bare = mdr.instruments.fit(data, tip, mdr.Homogeneous(mdr.Elastic(2e3, 0.5)), free=["E"])
    names = ("E", "surface.tension")
    found, spread = [both.estimates[name] for name in names], [both.standard_errors[name] for name in names]
    rows.append((*found, *spread, bare.estimates["E"]))
found_modulus, found_tension, modulus_sd, tension_sd, bare_modulus = np.array(rows).T

figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.8), layout="constrained")
left.loglog(radii * 1e6, bare_modulus / 1e3, "s--", label="fit without tension")
left.errorbar(radii * 1e6, found_modulus / 1e3, modulus_sd / 1e3, fmt="o", capsize=3, label="fit with both")
left.axhline(modulus / 1e3, color="grey", linewidth=0.8, label="true")
left.set(xlabel="radius of the sphere R [µm]", ylabel="modulus E [kPa]", title="estimated modulus")
left.set_yticks([3, 5, 10, 20, 30], ["3", "5", "10", "20", "30"])
left.yaxis.minorticks_off()
left.legend(frameon=False)
right.loglog(radii * 1e6, 100.0 * modulus_sd / modulus, "o-", label="modulus")
right.loglog(radii * 1e6, 100.0 * tension_sd / tension, "^-", label="surface tension")
right.set(xlabel="radius of the sphere R [µm]", ylabel="standard deviation [%]", title="one curve with 1 % of noise")
right.set_yticks([0.5, 1, 2, 5], ["0.5", "1", "2", "5"])
right.yaxis.minorticks_off()
right.legend(frameon=False)
figure.savefig("gel_with_surface_tension.png", dpi=130)
for radius, *numbers in zip(radii, found_modulus, modulus_sd, found_tension, tension_sd, bare_modulus, strict=True):
    e, se, t, st, b = numbers
    print(
        f"R = {radius * 1e6:3.0f} um: E = {e / 1e3:.2f} +- {se / 1e3:.2f} kPa, tension {t * 1e3:.1f} +- {st * 1e3:.1f} mN/m; "
        f"without tension E = {b / 1e3:.2f} kPa"
    )
print("written: gel_with_surface_tension.png")
