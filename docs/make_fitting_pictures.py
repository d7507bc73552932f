# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the pictures of fit.md and unloading.md from the curves in examples/fit. python docs/make_fitting_pictures.py
[FOLDER]

FOLDER is docs/pictures by default.
"""

from __future__ import annotations

import sys
from pathlib import Path

from make_pictures import save

from mdrcontact.instruments.files.fit_file import load_fit_file
from mdrcontact.instruments.fitting import compare_models, fit, modulus_at_depths
from mdrcontact.panels.matplotlib import draw

DOCS = Path(__file__).resolve().parent
CURVES = DOCS.parent / "examples" / "fit"


def main(folder: Path) -> None:
    """One picture for each data kind, and the modulus that every model finds."""
    from matplotlib.figure import Figure

    folder.mkdir(exist_ok=True)
    files = ("sphere_on_oxide.csv", "afm_on_rubber.csv", "csm_on_oxide.csv", "modulus_of_oxide.csv", "punches_on_rubber.csv")
    for path in (CURVES / name for name in (*files, "indent_on_oxide.txt", "raw_afm_on_rubber.txt", "csm_on_silica.csv")):
        name = path.stem
        problem = load_fit_file(path.with_suffix(".toml"))
        data, _ = problem.read_data(path)
        arguments = (data, problem.indenter, problem.medium, problem.free)
        result = fit(*arguments, instrument=problem.instrument, **problem.options)
        save(draw(result.plot()), folder / f"fit_{name}.png")
    problem = load_fit_file(CURVES / "csm_on_oxide.toml")
    data, _ = problem.read_data(CURVES / "csm_on_oxide.csv")
    profile = modulus_at_depths(data, problem.indenter, problem.medium, problem.free, instrument=problem.instrument)
    save(draw(profile.plot()), folder / "fit_modulus_against_depth.png")
    problem = load_fit_file(CURVES / "sphere_on_oxide.toml")
    data, _ = problem.read_data(CURVES / "sphere_on_oxide.csv")
    ranking = compare_models(data, problem.indenter, problem.medium, ["coating.E", "depth_offset"])
    figure = Figure(figsize=(6.4, 3.2), layout="constrained")
    axis = figure.subplots()
    names = [entry.model for entry in ranking.models][::-1]
    moduli = [entry.result.estimates["coating.E"] / 1e9 for entry in ranking.models][::-1]
    axis.barh(names, moduli, color="#0072B2")
    axis.axvline(72.0, color="#D55E00", label="true film modulus")
    axis.set_xlabel("film modulus [GPa]; models from best (top) to worst by AIC")
    axis.legend(frameon=False)
    axis.spines[["top", "right"]].set_visible(False)
    save(figure, folder / "fit_models.png")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else DOCS / "pictures")
