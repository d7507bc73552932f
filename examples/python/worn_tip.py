# SPDX-License-Identifier: GPL-3.0-or-later
"""A measured tip: its profile as a table, and what the wear of a sharp cone does to stiffness at small depth.

Writes worn_tip.png into the current folder.
"""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

STEEL = mdr.Elastic(210e9, 0.30)
NITRIDE = mdr.Elastic(445e9, 0.25)
THICKNESS = 2e-6
INCLINATION = np.radians(19.7)


def measured_tip() -> mdr.TabulatedProfile:
    """Heights as a profilometer would give them: a hyperbola, round within some 100 nm and a cone beyond."""
    r = np.concatenate([[0.0], np.geomspace(1e-9, 5e-6, 120)])
    b = 100e-9
    return mdr.TabulatedProfile(r, np.tan(INCLINATION) * (np.sqrt(r**2 + b**2) - b))


def main() -> None:
    """Draws tips and force-depth curves."""
    coated = mdr.Coated(NITRIDE, THICKNESS, STEEL)
    tips = {
        "sharp cone": mdr.Cone(INCLINATION),
        "rounded cone, b = 100 nm": mdr.RoundedCone(100e-9, INCLINATION),
        "measured": measured_tip(),
        "worn flat, b = 100 nm": mdr.FlatEndedCone(100e-9, INCLINATION),
    }
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 4.0), layout="constrained")
    r, depth = np.linspace(0.0, 400e-9, 200), np.linspace(1e-9, 60e-9, 60)
    for (name, tip), dashes in zip(tips.items(), ("-", "--", ":", "-."), strict=True):
        left.plot(r / 1e-9, tip.height(r) / 1e-9, dashes, label=name)
        right.plot(depth / 1e-9, mdr.Contact(tip, coated).at_depth(depth).force / 1e-3, dashes, label=name)
    left.set(xlabel="r [nm]", ylabel="height f [nm]", xlim=(0, 400), ylim=(0, None))
    right.set(xlabel="indentation depth d [nm]", ylabel="force F [mN]", xlim=(0, None), ylim=(0, None))
    left.legend()
    figure.suptitle("Four tips on 2 \N{MICRO SIGN}m TiN on steel")
    figure.savefig("worn_tip.png", dpi=150)
    print("written: worn_tip.png")


if __name__ == "__main__":
    main()
