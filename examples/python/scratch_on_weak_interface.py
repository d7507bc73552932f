# SPDX-License-Identifier: GPL-3.0-or-later
"""What cracks first where a film is weakly bonded? A tip that slides pulls the film behind it.

A diamond tip of 5 µm radius slides on 1 µm of carbon on steel, whose interface gives along the surface: the largest tension behind
the tip, at the film's underside, and the shear stress at the interface as the interface softens. What a weak interface takes from
its own load it gives to the film. Writes scratch_on_weak_interface.png into the current folder.
"""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

TIP, THICKNESS, FORCE, MU = 5e-6, 1e-6, 20e-3, 0.2
CARBON, STEEL = mdr.Elastic(250e9, 0.2), mdr.Elastic(210e9, 0.3)
BONDED = CARBON.E / (2.0 * (1.0 + CARBON.nu)) / THICKNESS  # stiffness of the film itself under shear
SOFTER = np.geomspace(1e-3, 30.0, 10)


def contact_on(interface: mdr.Interface | None) -> mdr.Contact:
    """The tip on the film, bonded or not."""
    return mdr.Contact(mdr.Paraboloid(TIP), mdr.Layered([mdr.Layer(CARBON, THICKNESS, interface=interface)], STEEL))


def main() -> None:
    """Draws stresses over the stiffness of the interface, and the plane of sliding."""
    found = np.empty((3, len(SOFTER)))
    contacts = [contact_on(mdr.Interface(tangential=ratio * BONDED)) for ratio in SOFTER]
    for i, contact in enumerate(contacts):
        state = contact.at_force(FORCE)
        critical = state.critical(friction=MU)
        r = np.linspace(0.0, 3.0 * state.radius, 200)
        under = state.interior(r, np.full_like(r, THICKNESS), side="above", friction=MU, angle=np.pi)
        found[:, i] = critical.surface.value, np.max(under.s_rr), critical.interfaces[0].shear.value

    figure, axes = plt.subplots(1, 3, figsize=(13.0, 3.9), layout="constrained")
    words = ("surface of the film, tension", "underside of the film, radial stress", "interface, shear")
    for values, word, color in zip(found, words, ("#D55E00", "#0072B2", "0.35"), strict=True):
        axes[0].semilogx(SOFTER, values / 1e9, color=color, label=word)
    axes[0].set(xlabel="stiffness of the interface over that of the film, K_t h/G", ylabel="largest stress [GPa]")
    axes[0].set_title(f"{FORCE / 1e-3:g} mN, friction {MU:g}")
    axes[0].legend(fontsize=8, loc="upper left", bbox_to_anchor=(0.0, 0.9))
    axes[0].grid(color="0.9")
    for axis, contact, title in zip(axes[1:], (contacts[0], contact_on(None)), ("weak interface", "bonded"), strict=True):
        state = contact.at_force(FORCE)
        x, z = np.linspace(-3e-6, 3e-6, 121), np.linspace(0.0, 2e-6, 61)
        field = state.interior(abs(x)[:, None], z[None, :], friction=MU, angle=np.where(x < 0.0, np.pi, 0.0)[:, None])
        drawn = axis.contourf(x / 1e-6, z / 1e-6, field.s_rr.T / 1e9, levels=np.linspace(-12, 12, 25), cmap="RdBu_r", extend="both")
        axis.axhline(THICKNESS / 1e-6, color="k", linewidth=0.8)
        axis.set(xlabel="x [µm], the tip slides to the right", ylabel="z [µm]", title=title)
        axis.invert_yaxis()
    figure.colorbar(drawn, ax=axes[1:], label="stress along x [GPa]")
    figure.savefig("scratch_on_weak_interface.png", dpi=150)

    for i, word in ((0, f"K_t h/G = {SOFTER[0]:g}"), (-1, f"K_t h/G = {SOFTER[-1]:g}")):
        print(f"{word}: tension {found[0, i] / 1e9:.2f} GPa at the surface, {found[1, i] / 1e9:.2f} GPa at the underside, ", end="")
        print(f"interface shear {found[2, i] / 1e9:.2f} GPa")
    print("written: scratch_on_weak_interface.png")


if __name__ == "__main__":
    main()
