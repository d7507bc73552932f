# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `validate`: the library against formulas, tables and programs of others."""

from __future__ import annotations

from dataclasses import dataclass

from .._choices import nearest
from .._units import RATIO
from ..errors import InvalidArgumentError
from ..progress import Progress
from ..validation import CHECKS
from ..validation.page import TITLES, Row, counted, programs, run
from .result import Number, Result, in_words, shared, study


@dataclass(frozen=True, eq=False, kw_only=True)
class ValidateResult(Result):
    """Comparisons with others. Table: "comparisons"."""

    rows: tuple[Row, ...]
    """each comparison and what came out"""
    beyond: tuple[str, ...]
    """names of those that deviate by more than the error of the source"""


@study
def validate(*, full: bool = False, only: str | None = None, progress: Progress | None = None) -> ValidateResult:
    """Compare the library with closed forms, printed tables and other programs.

    Parameters
    ----------
    full : bool, optional
        Also run the comparisons that take longest.
    only : str, optional
        Name of the comparison to run; by default all run.
    progress : Progress, optional
        Reports the comparisons, and can stop the work.

    Returns
    -------
    ValidateResult
        `rows`, `beyond`; numbers "comparisons" and "comparisons beyond".

    Raises
    ------
    InvalidArgumentError
        There is no comparison of this name.

    Examples
    --------
    >>> from mdrcontact import studies
    >>> found = studies.validate(only="hertz")
    >>> found.beyond
    ()
    """
    chosen = [check for check in CHECKS if only in (None, check.name)]
    if not chosen:
        raise InvalidArgumentError(f"only = {only!r}: {nearest(str(only), [check.name for check in CHECKS])}")
    # programs of others need not expect each other in several threads
    others = [check for check in chosen if check.needs]
    parts = [others] * bool(others) + [[check] for check in chosen if not check.needs]
    found = shared(progress or Progress(), lambda part: run(part, full), parts, "comparisons")
    rows = sorted((row for part in found for row in part), key=lambda row: chosen.index(row.check))
    beyond = tuple(row.check.name for row in rows if not row.holds)
    *left, held = counted(rows)
    return ValidateResult(
        title="Validation",
        numbers={"comparisons": Number(len(rows), RATIO), "comparisons beyond": Number(len(beyond), RATIO)},
        notes={"programs": f"programs: {', '.join(programs())}", **({"not run": left[0]} if left else {}), "bounds": held},
        tables={"comparisons": in_words([TITLES[:5], *(row.cells()[:5] for row in rows)])},
        rows=tuple(rows),
        beyond=beyond,
    )
