# SPDX-License-Identifier: GPL-3.0-or-later
"""Computes the tables of the guide and writes them there. python docs/make_tables.py [--check] [PAGE.md ...]

--check writes nothing and ends with status 1 if a table there is not what the library computes. Tables of benchmarks.md
are taken from the results of benchmarks/run.sh in tests/data/benchmarks.md.
"""

from __future__ import annotations

import csv
import re
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
from scipy.optimize import minimize_scalar

import mdrcontact as mdr

DOCS = Path(__file__).resolve().parent
sys.path.insert(0, str(DOCS))

import command_line  # noqa: E402

RESULTS = DOCS.parent / "tests" / "data" / "benchmarks.md"
SECTIONS = DOCS.parent / "tests" / "data" / "pyramids.csv"
CONTRASTS, FILM_RADII = (0.01, 0.1, 1.0, 10.0, 100.0), (0.3, 1.0, 3.0)
"""E0*/E1* and a/h of the tables of pyramids"""
RADII = np.geomspace(0.03, 30.0, 61)
"""a/h"""
FEW_RADII = np.array([0.1, 0.5, 1.0, 3.0, 10.0])
"""a/h"""
MODELS = mdr.accuracy_map([2.0], [1.0]).models


def modulus_error() -> str:
    """The largest error of E_eff by the ratio of shear moduli, for three pairs of Poisson's ratios."""
    ratios = (0.1, 0.5, 1.0, 2.0, 10.0)
    lines = ["| model | " + " | ".join(f"$G_0/G_1$ = {ratio:g}" for ratio in ratios) + " |", "|---|" + "---|" * len(ratios)]
    for model in MODELS:
        cells = []
        for ratio in ratios:
            errors: list[float] = []
            for nu0, nu1 in ((0.2, 0.45), (0.3, 0.3), (0.5, 0.5)):
                body = mdr.Coated(mdr.Elastic(2 * ratio * (1 + nu0), nu0), 1.0, mdr.Elastic(2 * (1 + nu1), nu1), model)
                errors += list(np.asarray(body.modulus(FEW_RADII) / body.with_model("exact").modulus(FEW_RADII) - 1))
            cells.append(f"{100 * max(errors, key=abs):+.{ratio == 1.0:d}f} %")
        lines.append(f"| `{model}` | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def fitted_alpha() -> str:
    """The largest error of E_eff with alpha = 1, and with the alpha of the smallest one, for nu = 0.3."""
    ratios = (0.1, 0.5, 2.0, 10.0)
    lines = ["| model | " + " | ".join(f"$G_0/G_1$ = {ratio:g}" for ratio in ratios) + " |", "|---|" + "---|" * len(ratios)]
    for model in ("doerner-nix", "mencik-exponential", "mencik-reciprocal"):
        cells = []
        for ratio in ratios:
            error = partial(_error_with_alpha, mdr.Elastic(ratio, 0.3), model)
            start = min(np.linspace(-3.0, 3.0, 61), key=error)
            best = minimize_scalar(error, bounds=(start - 0.1, start + 0.1), method="bounded")
            cells.append(f"{100 * error(0.0):.0f} -> {100 * best.fun:.0f} %, {np.exp(best.x):.2f}")
        lines.append(f"| `{model}` | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _error_with_alpha(coating: mdr.Elastic, model: str, log_alpha: float) -> float:
    """Return the largest error of E_eff with alpha = exp(log_alpha) on a substrate of E = 1."""
    body = mdr.Coated(coating, 1.0, mdr.Elastic(1.0, coating.nu), model, alpha=float(np.exp(log_alpha)))
    return float(np.abs(body.modulus(FEW_RADII) / body.with_model("exact").modulus(FEW_RADII) - 1).max())


def both_errors() -> str:
    """The largest errors of E_eff and of F at given a, within a factor 2 and a factor 10 of equal moduli."""
    lines = [
        "| model | $E_\\mathrm{eff}$, factor 2 | $F$, factor 2 | $E_\\mathrm{eff}$, factor 10 | $F$, factor 10 |",
        "|---|---|---|---|---|",
    ]
    maps = [mdr.accuracy_map(np.geomspace(1.0 / factor, factor, 21), RADII, MODELS) for factor in (2.0, 10.0)]
    for i, model in enumerate(MODELS):
        cells = [f"{100 * np.abs(error[i]).max():.0f} %" for m in maps for error in (m.modulus_error, m.force_error)]
        lines.append(f"| `{model}` | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def ranges() -> str:
    """Between which E0/E1 the force is right within 10 %, at any a/h, and where the contact is small or large."""
    parts = (("any $a/h$", 0.0, np.inf), ("$a/h < 0.1$", 0.0, 0.1), ("$a/h > 10$", 10.0, np.inf))
    lines = ["| model | " + " | ".join(name for name, _, _ in parts) + " |", "|---|" + "---|" * len(parts)]
    ratios = np.geomspace(0.01, 100.0, 81)
    result = mdr.accuracy_map(ratios, RADII, MODELS)
    for i, model in enumerate(MODELS):
        cells = []
        for _, low, high in parts:
            chosen = (result.radius_ratio > low) & (result.radius_ratio < high)
            good = np.abs(result.force_error[i][:, chosen]).max(axis=1) <= 0.1
            cells.append(_around_one(ratios, good))
        lines.append(f"| `{model}` | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _around_one(ratios: np.ndarray, good: np.ndarray) -> str:
    middle = len(ratios) // 2
    bad_below, bad_above = np.flatnonzero(~good[:middle]), np.flatnonzero(~good[middle:])
    first = bad_below[-1] + 1 if bad_below.size else 0
    last = middle + bad_above[0] - 1 if bad_above.size else len(ratios) - 1
    if last < first:
        return "nowhere"
    low = "less than 0.01" if first == 0 else f"{ratios[first]:.2g}"
    high = "more than 100" if last == len(ratios) - 1 else f"{ratios[last]:.2g}"
    return f"{low} to {high}"


def measured(heading: str, table: int = 0, rows: slice | tuple[int, ...] = slice(None)) -> str:
    """Return rows of a table of measured run times: the table of that number below a heading."""
    section = RESULTS.read_text(encoding="utf-8").split(f"\n## {heading}\n")[1].partition("\n## ")[0]
    head, line, *body = re.findall(r"(?:^\|.*\n?)+", section, re.MULTILINE)[table].splitlines()
    return "\n".join([head, line, *(body[rows] if isinstance(rows, slice) else (body[i] for i in rows))])


def _film(contrast: float) -> mdr.Coated:
    """A film by its contact modulus over that of its base."""
    return mdr.Coated(mdr.Elastic(contrast, 0.3), 1.0, mdr.Elastic(1.0, 0.3))


def pyramid_forces() -> str:
    """Forces of pyramids, ellipsoids and punches over those of axisymmetric indenters of equal sections."""
    lines = ["| indenter | " + " | ".join(f"{contrast:g}" for contrast in CONTRASTS) + " |", "|---|" + "---|" * len(CONTRASTS)]
    with SECTIONS.open(encoding="utf-8") as file:
        kept = {(row["shape"], float(row["contrast"]), float(row["a_over_h"])): float(row["force"]) for row in csv.DictReader(file)}
    rows = {
        type(tip).__name__: [mdr.instruments.pyramid_correction(tip, _film(contrast), FILM_RADII).force for contrast in CONTRASTS]
        for tip in (mdr.Berkovich(), mdr.Vickers())
    }
    for name in dict.fromkeys(name for name, _, _ in kept):
        rows[name] = [np.array([kept[name, contrast, ratio] for ratio in FILM_RADII]) for contrast in CONTRASTS]
    for name, columns in rows.items():
        cells = [", ".join(f"{100.0 * (force - 1.0):.1f}" for force in forces) for forces in columns]
        lines.append(f"| {name} | " + " | ".join(cells).replace("-0.0", "0.0") + " |")
    return "\n".join(lines)


def pyramid_moduli() -> str:
    """Errors of the modulus of a film that is fitted as under the equivalent cone."""
    lines = ["| tip | " + " | ".join(f"{contrast:g}" for contrast in CONTRASTS) + " |", "|---|" + "---|" * len(CONTRASTS)]
    for tip in (mdr.Berkovich(), mdr.Vickers()):
        found = [mdr.instruments.pyramid_correction(tip, _film(contrast), FILM_RADII).film_modulus for contrast in CONTRASTS]
        cells = [", ".join(f"{100.0 * (1.0 / one - 1.0):+.0f}" for one in moduli) for moduli in found]
        lines.append(f"| {type(tip).__name__} | " + " | ".join(cells).replace("-0", "0").replace("+0", "0") + " |")
    return "\n".join(lines)


TABLES: dict[str, dict[str, Callable[[], str]]] = {
    "model-errors.md": {"modulus_error": modulus_error, "fitted_alpha": fitted_alpha, "both_errors": both_errors, "ranges": ranges},
    "pyramids.md": {"pyramid_forces": pyramid_forces, "pyramid_moduli": pyramid_moduli},
    "problem-files.md": {"readers": command_line.readers, "keys": command_line.tables_of_keys},
    "cli.md": {"commands": command_line.commands},
    "benchmarks.md": {
        "force": partial(measured, "One force", rows=(0, 1, 2, 4, 8, 9, 10, 16, 17, 19, 20)),
        "plastic": partial(measured, "Laws of bodies that yield"),
        "plastic-arrays": partial(measured, "Laws of bodies that yield", table=1),
        "hertz": partial(measured, "Hertz's F(d)", rows=(0, 1, 2, 3, 6, 8)),
        "radii": partial(measured, "Scaling"),
        "stresses": partial(measured, "Stresses inside"),
        "slip": partial(measured, "Partial slip", rows=(0, 3, 5, 6, 7)),
        "time": partial(measured, "Viscoelastic bodies", rows=(0, 2, 3, 9)),
        "fits": partial(measured, "Fits"),
    },
}
"""By page."""


def with_tables(name: str) -> tuple[str, str]:
    """The text of a page, and the text with its tables made anew."""
    before = after = (DOCS / name).read_text(encoding="utf-8")
    for table, make in TABLES[name].items():
        pattern = rf"(?<=<!-- table: {table} -->\n\n).*?(?=\n\n<!-- end -->)"
        made = make()
        after, count = re.subn(pattern, lambda _, made=made: made, after, flags=re.DOTALL)
        assert count == 1, f"{name} has no place for the table {table}"
    return before, after


def main() -> int:
    """Writes or checks every table."""
    pages = {name: with_tables(name) for name in [name for name in sys.argv[1:] if name in TABLES] or TABLES}
    if "--check" in sys.argv:
        wrong = [name for name, (before, after) in pages.items() if before != after]
        print(f"not what the library computes: {', '.join(wrong)}: run docs/make_tables.py" if wrong else "the tables are right")
        return int(bool(wrong))
    for name, (_, after) in pages.items():
        (DOCS / name).write_text(after, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
