# SPDX-License-Identifier: GPL-3.0-or-later
"""How much does the choice of a model matter? A sphere on 500 nm SiO2 on silicon, from the film to the substrate.

Writes oxide_on_silicon.png into the current folder.
"""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

OXIDE = mdr.Elastic(72e9, 0.17)
SILICON = mdr.Elastic(163e9, 0.22)
THICKNESS = 500e-9
MODELS = {"exact": "k-", "gao": "-", "gao-series": "--", "hay-crawford": "-.", "doerner-nix": ":"}


def main() -> None:
    """Draws the effective modulus over a/h, and the pressure under the sphere where a = h."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 4.0), layout="constrained")
    a_over_h = np.geomspace(1e-2, 1e2, 200)
    for model, dashes in MODELS.items():
        coated = mdr.Coated(OXIDE, THICKNESS, SILICON, model)
        left.semilogx(a_over_h, coated.modulus(a_over_h * THICKNESS) / 1e9, dashes, label=model)
        contact = mdr.Contact(mdr.Sphere(10e-6), coated)
        r = np.linspace(0.0, THICKNESS, 200)
        right.plot(r / 1e-9, contact.at_radius(THICKNESS).pressure(r) / 1e9, dashes, label=model)
    for material, name in ((OXIDE, "oxide"), (SILICON, "silicon")):
        left.axhline(material.contact_modulus / 1e9, color="0.6", linewidth=0.8)
        left.annotate(name, (1e-2, material.contact_modulus / 1e9), xytext=(2, -11), textcoords="offset points", color="0.4")
    left.set(xlabel="a/h", ylabel=r"effective modulus $E_\mathrm{eff}$ [GPa]", ylim=(60, 185))
    right.set(xlabel="r [nm]", ylabel="contact pressure p [GPa] at a = h", ylim=(0, None), xlim=(0, None))
    left.legend(loc="lower right", bbox_to_anchor=(1.0, 0.12))
    figure.suptitle("500 nm SiO2 on silicon")
    figure.savefig("oxide_on_silicon.png", dpi=150)
    print("written: oxide_on_silicon.png")


if __name__ == "__main__":
    main()
