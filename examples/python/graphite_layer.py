# SPDX-License-Identifier: GPL-3.0-or-later
"""How deep does a load reach in graphite? Its layers shear easily and pass the pressure down.

A ball of 10 µm radius on 1 µm of graphite on silicon, and on an isotropic layer with the same contact modulus at its surface: the
normal stress on the axis and the field below both. Writes graphite_layer.png into the current folder.
"""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

BALL, THICKNESS, RADIUS = 10e-6, 1e-6, 0.5e-6
GRAPHITE, SILICON = mdr.CRYSTALS["graphite"].material, mdr.Elastic(160e9, 0.22)


def isotropic_reading() -> mdr.Elastic:
    """The isotropic material that a half-space of graphite is taken for."""
    modulus = mdr.Homogeneous(GRAPHITE).modulus(RADIUS)
    return mdr.Elastic(modulus * (1.0 - 0.2**2), 0.2)


def mean_pressure(state: mdr.State) -> float:
    """F/(pi a^2)."""
    return float(state.force / (np.pi * state.radius**2))


def main() -> None:
    """Draws the pressure on the substrate, the forces and the fields."""
    names = ("graphite", "isotropic reading")
    contacts = [mdr.Contact(mdr.Paraboloid(BALL), mdr.Coated(film, THICKNESS, SILICON)) for film in (GRAPHITE, isotropic_reading())]
    states = [contact.at_radius(RADIUS) for contact in contacts]
    r = np.linspace(0.0, 1.6e-6, 81)
    z = np.linspace(0.0, 1.6e-6, 81)

    figure, axes = plt.subplots(1, 3, figsize=(12.0, 3.9), layout="constrained")
    deep = np.linspace(0.0, 3e-6, 151)
    for name, state, color in zip(names, states, ("#D55E00", "0.45"), strict=True):
        axes[0].plot(deep / 1e-6, -state.interior(0.0, deep).s_zz / mean_pressure(state), color=color, label=name)
    axes[0].axvline(THICKNESS / 1e-6, color="0.8", linewidth=0.8)
    axes[0].set(xlabel="depth below the contact's centre [µm]", ylabel="normal stress over mean pressure", xlim=(0.0, 3.0))
    axes[0].legend()
    for axis, name, state in zip(axes[1:], names, states, strict=True):
        pressure = -state.interior(r[:, None], z[None, :]).s_zz / mean_pressure(state)
        both = np.concatenate([pressure[:0:-1], pressure]).T
        x = np.concatenate([-r[:0:-1], r])
        drawn = axis.contourf(x / 1e-6, z / 1e-6, both, levels=np.linspace(0.0, 1.5, 16), cmap="magma_r", extend="both")
        axis.axhline(THICKNESS / 1e-6, color="w", linewidth=0.8)
        axis.set(xlabel="r [µm]", ylabel="z [µm]", title=name, aspect="equal")
        axis.invert_yaxis()
    figure.colorbar(drawn, ax=axes[1:], label="normal stress over mean pressure", shrink=0.85)
    figure.savefig("graphite_layer.png", dpi=150)

    arrives = [-state.interior(0.0, THICKNESS).s_zz / mean_pressure(state) for state in states]
    print(f"contact radius {RADIUS / 1e-6:g} µm, mean pressure {mean_pressure(states[0]) / 1e9:.2f} GPa")
    print(f"normal stress at the substrate: {arrives[0]:.2f} of the mean pressure, {arrives[1]:.2f} in the isotropic reading")
    print(f"E_eff: {contacts[0].medium.modulus(RADIUS) / 1e9:.1f} GPa, {contacts[1].medium.modulus(RADIUS) / 1e9:.1f} GPa")
    print("written: graphite_layer.png")


if __name__ == "__main__":
    main()
