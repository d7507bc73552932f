# SPDX-License-Identifier: GPL-3.0-or-later
"""Where each approximate model of a coated body can be trusted: its error of E_eff, and of F at a given contact radius, over
modulus ratio and a/h, against the exact solution.

Writes accuracy_map.png into the current folder.
"""

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np

import mdrcontact as mdr

MODELS = ("gao", "gao-series", "hay-crawford", "perriot-barthel", "doerner-nix", "wave")
LEVELS = (-50, -20, -10, -5, -2, 2, 5, 10, 20, 50)


def main() -> None:
    """Computes the map, draws it and prints the largest errors."""
    result = mdr.accuracy_map(np.geomspace(0.01, 100.0, 25), np.geomspace(0.03, 30.0, 31), MODELS)
    rows = (("error of $E_\\mathrm{eff}$", result.modulus_error), ("error of $F$ at given $a$", result.force_error))
    figure, axes = plt.subplots(2, len(MODELS), figsize=(14.0, 5.6), sharex=True, sharey=True, layout="constrained")
    colours = plt.get_cmap("RdBu_r")(np.linspace(0.02, 0.98, len(LEVELS) + 1))
    for row, (line, (name, errors)) in enumerate(zip(axes, rows, strict=True)):
        for axis, model, error in zip(line, result.models, errors, strict=True):
            shown = axis.contourf(result.radius_ratio, result.modulus_ratio, 100.0 * error, LEVELS, colors=colours, extend="both")
            axis.contour(result.radius_ratio, result.modulus_ratio, 100.0 * error, (-2, 2), colors="#404040", linewidths=0.6)
            axis.set(xscale="log", yscale="log")
            if row == 0:
                axis.set_title(model)
            else:
                axis.set_xlabel("$a/h$")
        line[0].set_ylabel(f"{name}\nmodulus ratio $E_0/E_1$")
    bar = figure.colorbar(shown, ax=axes, ticks=LEVELS, aspect=40, pad=0.01)
    bar.set_label("error against exact [%]; white: within 2 %")
    figure.suptitle("Approximate models of a coated body under a paraboloid, Poisson's ratios 0.3")
    figure.savefig("accuracy_map.png", dpi=150)
    print("largest error over 0.1 <= E0/E1 <= 10:  E_eff, F")
    comparable = (result.modulus_ratio > 0.099) & (result.modulus_ratio < 10.01)
    for model, modulus, force in zip(result.models, result.modulus_error, result.force_error, strict=True):
        print(f"{model:<16}{100 * np.abs(modulus[comparable]).max():8.1f} %{100 * np.abs(force[comparable]).max():8.1f} %")
    print("written: accuracy_map.png")


if __name__ == "__main__":
    main()
