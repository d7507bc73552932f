# SPDX-License-Identifier: GPL-3.0-or-later
"""How thick must a hard coating be so that under a ball the substrate does not yield before the coating cracks?

Draws, for TiN and DLC on steel under a ball of 0.1 mm radius, the loads at which the coating's surface cracks, the coating yields,
the substrate yields and the interface shears off, against the coating's thickness. Writes coating_design.png into the current
folder.

One sweep over a/h serves all thicknesses: at the same a/h stresses under a paraboloid are proportional to a/R and forces to a^3/R.
"""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

BALL = 100e-6
SHALLOW = 1e3  # radius of the paraboloid of the sweep, in thicknesses: slopes stay small
STEEL, STEEL_YIELD = mdr.Elastic(210e9, 0.30), 2.0e9  # hardened tool steel
COATINGS = {
    # E, nu; tensile strength, yield strength and shear strength of the interface: orders of magnitude, they depend on the process
    "TiN": (mdr.Elastic(450e9, 0.25), 2.0e9, 12.0e9, 0.6e9),
    "DLC": (mdr.Elastic(150e9, 0.20), 1.2e9, 8.0e9, 0.6e9),
}
A_OVER_H = np.geomspace(0.05, 20.0, 14)
MODES = ("ring crack in the coating", "yield of the coating", "yield of the substrate", "shear of the interface")


def failure_loads(coating, strengths):
    """Thickness and force at which each mode is reached, for every a/h; NaN where its stress is not tensile."""
    contact = mdr.Contact(mdr.Paraboloid(SHALLOW), mdr.Coated(coating, 1.0, STEEL))
    curves = np.full((len(strengths), len(A_OVER_H), 2), np.nan)
    for i, a in enumerate(A_OVER_H):
        state = contact.at_radius(a)
        found = state.critical()
        film, substrate = found.layers
        stresses = found.surface.value, film.von_mises.value, substrate.von_mises.value, found.interfaces[0].shear.value
        for j, (stress, strength) in enumerate(zip(stresses, strengths, strict=True)):
            if stress > 0.0:
                radius = strength / (stress * SHALLOW / a) * BALL
                curves[j, i] = radius / a, state.force * SHALLOW / a**3 * radius**3 / BALL
    return curves


def main() -> None:
    """Draws both coatings."""
    figure, axes = plt.subplots(1, 2, figsize=(10.0, 4.6), layout="constrained", sharey=True)
    for axis, (name, (coating, tension, film_yield, shear)) in zip(axes, COATINGS.items(), strict=True):
        curves = failure_loads(coating, (tension, film_yield, STEEL_YIELD, shear))
        for curve, mode, dashes in zip(curves, MODES, ("-", "-.", "--", ":"), strict=True):
            axis.loglog(curve[:, 0] / 1e-6, curve[:, 1], dashes, label=mode)
        axis.set(xlabel="thickness of the coating [µm]", title=f"{name} on steel, ball of {BALL / 1e-3:g} mm radius")
        axis.set(xlim=(0.3, 100.0), ylim=(1e-3, 1e3))
        axis.grid(color="0.9")
        # at a given thickness the lowest curve fails first
        h = np.geomspace(0.5e-6, 80e-6, 200)
        loads = [np.exp(np.interp(np.log(h), *np.log(curve[np.argsort(curve[:, 0])]).T)) for curve in curves[[0, 2]]]
        safe = h[loads[1] > loads[0]]
        if safe.size:
            print(f"{name}: from {safe[0] / 1e-6:.3g} um on the coating cracks before the substrate yields")
            axis.axvline(safe[0] / 1e-6, color="0.6", linewidth=0.8)
        else:
            print(f"{name}: the substrate yields before the coating cracks at all thicknesses up to {h[-1] / 1e-6:.3g} um")
    axes[0].set(ylabel="normal force at first failure [N]")
    axes[0].legend()
    figure.savefig("coating_design.png", dpi=150)
    print("written: coating_design.png")


if __name__ == "__main__":
    main()
