# SPDX-License-Identifier: GPL-3.0-or-later
"""Fig. 2 of Popov (2014): indentation depth over contact radius of an adhesive paraboloid on an incompressible coating twice as
stiff as its substrate, for h/a_c = 4, 2, 1, 0.5, 0.25 by equation (32), with the balance of energy and the exact solution beside.

Writes adhesion_figure_2.png into the current folder.
"""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr
from mdrcontact.closed_forms import adhesive_depth_scale, adhesive_radius_scale, reduced_adhesive_depth

TAU = 2.0
THICKNESSES = (4.0, 2.0, 1.0, 0.5, 0.25)
COLOURS = ("#0072B2", "#56B4E9", "#009E73", "#E69F00", "#D55E00")
RADIUS, SHEAR, WORK = 1.0, 1.0, 1e-6  # R, G1, gamma: the reduced curves do not depend on them


def contact(reduced_thickness: float, model: str, rule: str) -> mdr.Contact:
    """The adhesive paraboloid on a coating of thickness h = reduced_thickness a_c."""
    coating, substrate = mdr.Elastic(3 * TAU * SHEAR, 0.5), mdr.Elastic(3 * SHEAR, 0.5)  # E = 3 G
    h = reduced_thickness * adhesive_radius_scale(RADIUS, SHEAR, WORK)
    return mdr.Contact(mdr.Paraboloid(RADIUS), mdr.Coated(coating, h, substrate, model), WORK, rule)


def main() -> None:
    """Draws the three panels and prints the pull-off."""
    a_c, d_c = adhesive_radius_scale(RADIUS, SHEAR, WORK), adhesive_depth_scale(RADIUS, SHEAR, WORK)
    reduced = np.linspace(0.02, 2.4, 80)
    panels = (
        ("source's rule, equation (32)", "gao", "paper"),
        ("balance of energy, weights of (15)", "gao", "energy"),
        ("exact", "exact", "energy"),
    )
    figure, axes = plt.subplots(1, 3, figsize=(11.0, 4.4), sharey=True, layout="constrained")
    print("h/a_c    pull-off depth d/d_c: (32), energy, exact")
    for thickness, colour in zip(THICKNESSES, COLOURS, strict=True):
        label, ends = rf"$h/a_c = {thickness:g}$", []
        for axis, (_, model, rule) in zip(axes, panels, strict=True):
            body = contact(thickness, model, rule)
            depth = np.asarray(body.at_radius(reduced * a_c).depth) / d_c
            if model == "gao" and rule == "paper":
                assert np.allclose(depth, reduced_adhesive_depth(reduced, TAU, thickness), rtol=1e-12, atol=1e-12)
            end = body.pull_off("depth")
            axis.plot(reduced, depth, color=colour, label=label)
            axis.plot(end.radius / a_c, end.depth / d_c, "o", color=colour, markersize=4)
            ends.append(end.depth / d_c)
        print(f"{thickness:5.2f}" + "".join(f"{value:10.4f}" for value in ends))
    for axis, (title, _, _) in zip(axes, panels, strict=True):
        for tau, dashes in ((1.0, (0, (5, 2))), (TAU, (0, (1, 1.5)))):
            name = "substrate alone" if tau == 1.0 else "coating alone"
            axis.plot(reduced, reduced**2 / 3 - 4 / 3 * np.sqrt(reduced / tau), color="#707070", lw=1.0, ls=dashes, label=name)
        axis.axhline(0.0, color="#b0b0b0", lw=0.6)
        axis.set(title=title, xlabel="contact radius $a/a_c$", xlim=(0, 2.4), ylim=(-1.1, 0.6))
        for side in ("top", "right"):
            axis.spines[side].set_visible(False)
    axes[0].set_ylabel("indentation depth $d/d_c$")
    axes[0].legend(frameon=False, fontsize=8, loc="upper left")
    figure.suptitle(r"Adhesive paraboloid on an incompressible coating, $G_0/G_1 = 2$; dots: pull-off at given depth")
    figure.savefig("adhesion_figure_2.png", dpi=150)
    print("written: adhesion_figure_2.png")


if __name__ == "__main__":
    main()
