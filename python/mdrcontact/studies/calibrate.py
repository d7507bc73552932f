# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `calibrate`: tip and frame from indents into a known body."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..instruments.files.calibration_file import calibration_text
from ..instruments.files.fit_file import FitFile
from ..instruments.fitting import FitResult, StiffnessDepth, fit
from ..instruments.fitting.calibration import together, words_of_tests
from ..instruments.fitting.data import Data
from ..panels import Figure
from ..problem import ProblemError
from ..progress import Progress
from .estimates import estimates
from .result import Result, study


@dataclass(frozen=True, eq=False, kw_only=True)
class CalibrateResult(Result):
    """A calibrated tip and frame."""

    problem: FitFile
    fit: FitResult
    tests: tuple[str, ...]
    """names"""
    doubts: tuple[str, ...]
    """about how the tests agree; `warnings` has them too"""

    def figure(self) -> Figure:
        """Return data, fit and residuals of all tests."""
        return self.fit.plot(self.title)

    def tip_file(self) -> str:
        """The content of a file that [indenter] reads; raises for a calibration that has fitted the body."""
        return calibration_text(self.fit, self.title, self.problem.tip, self.tests)


@study
def calibrate(problem: FitFile, tests: Sequence[tuple[str, Data]], *, progress: Progress | None = None) -> CalibrateResult:
    """Fit the tip and the frame compliance to all tests together.

    Parameters
    ----------
    problem : FitFile
        Tip, known body and free parameters, as `mdrcontact.instruments.load_fit_file` returns them.
    tests : sequence of (str, StiffnessDepth)
        Name and data of each indent, unloading curves or CSM curves.
    progress : Progress, optional
        Can stop the work.

    Returns
    -------
    CalibrateResult
        `fit`, `tip_file()`; numbers: each estimate, and "standard error of" it.

    Raises
    ------
    ProblemError
        The data have no contact stiffnesses.
    MDRError
        There are no tests, they are of two kinds, or the fit fails.

    Examples
    --------
    >>> import numpy as np
    >>> from mdrcontact import instruments, studies
    >>> text = '''
    ... [indenter]
    ... shape = "sphere"
    ... radius = "4 um"
    ... [medium]
    ... type = "homogeneous"
    ... material = { E = "72 GPa", nu = 0.17 }
    ... [data]
    ... kind = "stiffness-depth"
    ... [fit]
    ... free = ["indenter.radius"]
    ... '''
    >>> height, reduced = np.linspace(20e-9, 200e-9, 30), 72e9 / (1.0 - 0.17**2)
    >>> a = np.sqrt(10e-6 * height - height**2)
    >>> force, stiffness = 5e9 * np.pi * a**2, 2.0 * reduced * a
    >>> test = instruments.StiffnessDepth(height + 0.75 * force / stiffness, force, stiffness, sd=0.01 * stiffness)
    >>> found = studies.calibrate(instruments.fit_file_of_text(text, "Ball"), [("ball", test)])
    >>> print(found.numbers["indenter.radius"])
    5 um
    """
    data = []
    for _, test in tests:
        if not isinstance(test, StiffnessDepth):
            raise ProblemError('[data]: kind must be "unloading" or "stiffness-depth": a calibration needs contact stiffnesses')
        data.append(test)
    (progress or Progress()).step(0, None, "fit")
    found = fit(together(data), **problem.arguments)
    doubts = tuple(words_of_tests(found))
    return CalibrateResult(
        title=problem.title,
        numbers=estimates(found),
        notes={"fit": found.summary()},
        warnings=(*found.warnings, *doubts),
        problem=problem,
        fit=found,
        tests=tuple(name for name, _ in tests),
        doubts=doubts,
    )
