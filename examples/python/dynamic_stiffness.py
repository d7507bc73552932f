# SPDX-License-Identifier: GPL-3.0-or-later
"""A polymer coating on steel under an oscillating flat punch: stiffness and loss over seven decades of frequency.

The substrate hides part of the relaxation: tan delta of the contact is not that of the polymer, and differs from punch to punch.
Writes dynamic_stiffness.png into the current folder.
"""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

# a polymer that relaxes from 1.0 to 0.2 GPa in shear over four decades of time, its bulk elastic
POLYMER = mdr.Viscoelastic(0.2e9, [(0.2e9, 10.0**n) for n in (-3, -2, -1, 0)], bulk_modulus=4e9)
STEEL = mdr.Elastic(210e9, 0.3)
THICKNESS = 2e-6
RADII = (0.5e-6, 2e-6, 8e-6)


def main() -> None:
    """Draws storage stiffness and tan delta of three punches, and tan delta of the polymer itself."""
    omega = np.geomspace(1e-2, 1e5, 57)
    medium = mdr.Coated(POLYMER, THICKNESS, STEEL)
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 4.0), layout="constrained")
    # at a given contact radius the indenter's shape does not matter: any one stands for all three punches
    stiffness = mdr.Contact(mdr.Cone(0.3), medium).dynamic_stiffness(omega[:, None], radius=RADII)
    for k, radius in zip(stiffness.T, RADII, strict=True):
        left.loglog(omega, k.real / 1e3, label=f"a/h = {radius / THICKNESS:g}")
        right.semilogx(omega, k.imag / k.real, label=f"a/h = {radius / THICKNESS:g}")
    modulus = POLYMER.complex_modulus(omega)
    right.semilogx(omega, modulus.imag / modulus.real, "k--", label="polymer, shear")
    left.set(xlabel=r"angular frequency $\omega$ [rad/s]", ylabel="storage stiffness k' [kN/m]")
    right.set(xlabel=r"angular frequency $\omega$ [rad/s]", ylabel=r"tan $\delta$ = k''/k'")
    left.legend()
    right.legend()
    figure.suptitle("2 µm of a polymer on steel, flat punches")
    figure.savefig("dynamic_stiffness.png", dpi=150)
    print("written: dynamic_stiffness.png")


if __name__ == "__main__":
    main()
