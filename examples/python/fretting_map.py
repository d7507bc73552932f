# SPDX-License-Identifier: GPL-3.0-or-later
"""Does a coating save a contact from fretting? It depends on what is prescribed, the shift or the tangential force.

Draws the running conditions of a ball of 5 mm radius on 5 µm coatings of many stiffnesses on steel under 1 N: which part of the
contact slips at a given amplitude of the shift (partial slip below the line of sliding, gross slip above), and the energy
dissipated in a cycle of given shift and of given tangential force, relative to the bare steel. Writes fretting_map.png into the
current folder.
"""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

BALL, THICKNESS, FORCE, MU = 5e-3, 5e-6, 1.0, 0.3
STEEL = mdr.Elastic(210e9, 0.3)
RATIOS = np.geomspace(0.1, 5.0, 13)
SLIPPING = (0.1, 0.3, 0.6, 0.9)  # part of the contact's area that slips


def sheared(body: mdr.Medium) -> mdr.ShearedContact:
    """The ball on a body under the normal force."""
    contact = mdr.Contact(mdr.Paraboloid(BALL), body)
    return mdr.Friction(contact, MU).shear(contact.at_force(FORCE))


def main() -> None:
    """Draws the map and the energies."""
    bare = sheared(mdr.Homogeneous(STEEL))
    shift, tangential_force = 0.5 * bare.sliding_shift, 0.5 * MU * FORCE
    basis = bare.cycle_energy(shift), bare.cycle_energy(tangential_force, "force")

    lines = np.empty((len(SLIPPING) + 1, len(RATIOS)))
    energies = np.empty((2, len(RATIOS)))
    for i, ratio in enumerate(RATIOS):
        coating = mdr.Elastic(ratio * STEEL.E, STEEL.nu)
        coated = sheared(mdr.Coated(coating, THICKNESS, STEEL))
        sliding = coated.sliding_shift
        shifts = np.linspace(0.0, 1.0, 60)[1:-1] * sliding
        slipping = 1.0 - (np.asarray(coated.at_shift(shifts).stick_radius) / coated.state.radius) ** 2
        lines[:-1, i] = np.interp(SLIPPING, slipping, shifts)
        lines[-1, i] = sliding
        energies[:, i] = coated.cycle_energy(shift), coated.cycle_energy(tangential_force, "force")
    energies /= np.array(basis)[:, None]

    figure, (left, right) = plt.subplots(1, 2, figsize=(10.0, 4.4), layout="constrained")
    for part, line in zip(SLIPPING, lines, strict=False):
        left.loglog(RATIOS, line / 1e-9, color="0.6", linewidth=1.0)
        words = f"{100 * part:.0f} % slips"
        left.annotate(words, (RATIOS[0], line[0] / 1e-9), (0, -9), textcoords="offset points", va="top", fontsize=8)
    left.loglog(RATIOS, lines[-1] / 1e-9, color="#D55E00", label="gross slip above")
    left.set(xlabel="modulus ratio $E_0/E_1$", ylabel="amplitude of the shift s [nm]")
    left.set_title(f"ball of {BALL / 1e-3:g} mm, {FORCE:g} N, {THICKNESS / 1e-6:g} µm coating, friction {MU:g}")
    left.legend()
    for energy, words in zip(energies, (f"shift ±{shift / 1e-9:.0f} nm", f"tangential force ±{tangential_force:g} N"), strict=True):
        right.loglog(RATIOS, energy, label=words)
    right.axhline(1.0, color="0.6", linewidth=0.8)
    right.set(xlabel="modulus ratio $E_0/E_1$", ylabel="dissipated energy of a cycle, relative to bare steel")
    right.legend()
    right.set_yticks([0.3, 0.5, 1.0, 2.0, 3.0], ["0.3", "0.5", "1", "2", "3"])
    right.yaxis.minorticks_off()
    for axis in (left, right):
        axis.grid(color="0.9")
    figure.savefig("fretting_map.png", dpi=150)

    for words, i in ((f"{RATIOS[-1]:g} times stiffer", -1), (f"{1 / RATIOS[0]:g} times softer", 0)):
        print(f"a coating {words}: {energies[0, i]:.2f} of the energy under given shift, {energies[1, i]:.2f} under given force")
    print("written: fretting_map.png")


if __name__ == "__main__":
    main()
