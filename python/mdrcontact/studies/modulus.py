# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `modulus`: the film's modulus at every depth of a dynamic measurement, and at zero depth."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .._units import LENGTH, MODULUS, RATIO, practical
from ..instruments.files.fit_file import FitFile
from ..instruments.fitting import DepthProfile, StiffnessDepth, modulus_at_depths
from ..instruments.fitting.data import Data
from ..instruments.fitting.quantities import dimension_of, words_of
from ..panels import Figure
from ..problem import ProblemError
from ..progress import Progress
from .result import Column, Number, Result, column, study


@dataclass(frozen=True, eq=False, kw_only=True)
class ModulusResult(Result):
    """A modulus at every depth. Table: "points"."""

    problem: FitFile
    profile: DepthProfile
    doubts: tuple[str, ...]
    """about the data and the modulus at zero depth; `warnings` has them too"""

    def figure(self) -> Figure:
        """Return the moduli against depth, and the line to zero depth."""
        return self.profile.plot(self.title)


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
        `profile`, table "points"; numbers "at zero depth" and "standard error".

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
    dimension, doubts = dimension_of(profile.name), (*data.warnings, *profile.warnings)
    return ModulusResult(
        title=problem.title,
        numbers={
            "at zero depth": Number(profile.at_zero, dimension),
            "standard error": Number(profile.at_zero_error, dimension),
        },
        notes={"zero": profile.summary()},
        tables={"points": _points(profile, thickness)},
        warnings=doubts,
        problem=problem,
        profile=profile,
        doubts=doubts,
    )


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
