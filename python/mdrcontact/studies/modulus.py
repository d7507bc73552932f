# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `modulus`: the film's modulus at every depth of a dynamic measurement, and at zero depth."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from .._units import LENGTH, MODULUS, RATIO, practical
from ..errors import MDRError
from ..instruments.files.fit_file import FitFile
from ..instruments.fitting import CompositeHardness, DepthProfile, StiffnessDepth, composite_hardness, modulus_at_depths
from ..instruments.fitting.data import Data
from ..instruments.fitting.quantities import dimension_of, words_of
from ..panels import Figure
from ..problem import ProblemError
from ..progress import Progress
from .result import Array, Column, Number, Result, Words, column, study

_CONSTANT = 0.05
"""Relative change below which a hardness is the same at all depths."""


@dataclass(frozen=True, eq=False, kw_only=True)
class ModulusResult(Result):
    """A modulus at every depth. Tables: "points", and "hardness" of film and base by form."""

    problem: FitFile
    profile: DepthProfile
    doubts: tuple[str, ...]
    """about the data, the modulus at zero depth and the hardness; `warnings` has them too"""
    hardness: CompositeHardness | None = None
    """of film and base, if the hardness of a coated body changes with depth"""

    def figure(self) -> Figure:
        """Return the moduli against depth, the line to zero depth, and the hardness against a/h."""
        moduli = self.profile.plot(self.title)
        if self.hardness is None:
            return moduli
        return moduli._replace(panels=(*moduli.panels, *self.hardness.plot().panels))

    def to_dict(self) -> dict[str, Any]:
        """The moduli, and the hardness of film and base, as plain Python values."""
        found = {**self.profile.to_dict(), "warnings": [*self.doubts]}
        return found if self.hardness is None else {**found, "composite_hardness": self.hardness.to_dict()}


@study
def modulus(problem: FitFile, data: Data, *, progress: Progress | None = None) -> ModulusResult:
    """Fit the film modulus at each depth, and extrapolate it to zero depth.

    Parameters
    ----------
    problem : FitFile
        Tip, medium, instrument and the one free modulus, as `mdrcontact.instruments.load_fit_file` returns them.
    data : StiffnessDepth
        Depths [m], forces [N] and contact stiffnesses [N/m] with standard deviations.
    progress : Progress, optional
        Reports each point, and can stop the work between two of them.

    Returns
    -------
    ModulusResult
        `profile`, table "points"; numbers "at zero depth" and "standard error"; `hardness` of film and base, table "hardness".

    Raises
    ------
    ProblemError
        The data are of another kind.
    MDRError
        There are too few points, or they do not determine a modulus.

    Examples
    --------
    >>> import numpy as np
    >>> import mdrcontact as mdr
    >>> from mdrcontact import instruments, studies
    >>> text = '''
    ... [indenter]
    ... shape = "paraboloid"
    ... radius = "1 um"
    ... [medium]
    ... type = "coated"
    ... model = "exact"
    ... coating = { E = "90 GPa", nu = 0.17, thickness = "500 nm" }
    ... substrate = { E = "163 GPa", nu = 0.22 }
    ... [data]
    ... kind = "stiffness-depth"
    ... [fit]
    ... free = ["coating.E"]
    ... '''
    >>> film = mdr.Coated(mdr.Elastic(72e9, 0.17), 500e-9, mdr.Elastic(163e9, 0.22), "exact")
    >>> states = mdr.Contact(mdr.Paraboloid(1e-6), film).at_depth(np.linspace(10e-9, 60e-9, 8))
    >>> columns = states.depth, states.force, states.stiffness
    >>> data = instruments.StiffnessDepth(*columns, sd=0.01 * states.stiffness)
    >>> found = studies.modulus(instruments.fit_file_of_text(text), data)
    >>> print(found.numbers["at zero depth"])
    72 GPa
    """
    if not isinstance(data, StiffnessDepth):
        raise ProblemError('[data]: kind must be "stiffness-depth"')
    progress, total = progress or Progress(), len(data)
    progress.step(0, total, "points")
    profile = modulus_at_depths(
        data,
        problem.indenter,
        problem.medium,
        problem.free,
        instrument=problem.instrument,
        known=problem.options.get("known", ()),
        progress=lambda done: progress.step(done, total, "points"),
    )
    thickness = getattr(getattr(problem.medium, "lower", problem.medium), "thickness", None)
    hardness = _hardness(data, profile, thickness)
    dimension = dimension_of(profile.name)
    doubts = (*data.warnings, *profile.warnings, *(hardness.warnings if hardness else ()))
    return ModulusResult(
        title=problem.title,
        numbers={
            "at zero depth": Number(profile.at_zero, dimension),
            "standard error": Number(profile.at_zero_error, dimension),
        },
        notes={"zero": profile.summary(), **({"hardness": hardness.summary()} if hardness else {})},
        tables={"points": _points(profile, thickness), **({"hardness": _forms(hardness)} if hardness else {})},
        warnings=doubts,
        problem=problem,
        profile=profile,
        doubts=doubts,
        hardness=hardness,
    )


def _hardness(data: StiffnessDepth, profile: DepthProfile, thickness: float | None) -> CompositeHardness | None:
    """Return film and base; None if nothing yields, or if the hardness does not change with depth."""
    is_elastic = data.seems_elastic if data.elastic is None else data.elastic
    found = profile.analysis
    good = np.isfinite(found.radius) & np.isfinite(found.hardness) & (found.radius > 0.0) & (found.hardness > 0.0)
    if thickness is None or is_elastic or not good.any():
        return None
    values = found.hardness[good]
    if float(np.ptp(values)) < _CONSTANT * float(values.mean()):
        return None
    try:
        return composite_hardness(found.radius[good] / thickness, values, sd=_errors(found.hardness_error[good]))
    except MDRError:
        return None


def _errors(errors: Array) -> Array | None:
    return errors if np.all(errors > 0.0) else None


def _forms(found: CompositeHardness) -> list[Column | Words]:
    """Return film and base of each form."""
    names, forms = [*found.forms], [*found.forms.values()]
    return [
        Words("form", names),
        column("film", [one.film for one in forms], MODULUS),
        column("standard error", [one.film_error for one in forms], MODULUS),
        column("base", [one.base for one in forms], MODULUS),
        column("standard error", [one.base_error for one in forms], MODULUS),
        column("residual", [one.residual for one in forms], RATIO),
        Words("in finite elements", [one.known_error for one in forms]),
    ]


def _points(profile: DepthProfile, thickness: float | None) -> list[Column]:
    found = profile.analysis
    unit = practical(dimension_of(profile.name), profile.modulus[np.isfinite(profile.modulus)])
    return [
        column("depth", found.depth, LENGTH),
        column("contact depth", found.contact_depth, LENGTH),
        column("contact radius a", found.radius, LENGTH),
        *([] if thickness is None else [column("a/h", found.radius / thickness, RATIO)]),
        column("E_r", found.reduced_modulus, MODULUS),
        column("hardness", found.hardness, MODULUS),
        Column(words_of(profile.name), profile.modulus, unit),
        Column("standard error", profile.standard_error, unit),
        Column("common error", profile.common_error, unit),
    ]
