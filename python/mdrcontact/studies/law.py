# SPDX-License-Identifier: GPL-3.0-or-later
"""The study `law`: the compiled law of a problem."""

from __future__ import annotations

from dataclasses import dataclass

from .._units import FORCE, LENGTH, RATIO
from ..friction import Friction
from ..law import ContactLaw
from ..panels import Figure
from ..problem import Problem
from ..progress import Progress
from .result import Number, Result, study


@dataclass(frozen=True, eq=False, kw_only=True)
class LawResult(Result):
    """A compiled law: `law.to_bytes()` is the content of its file, `law.table(...)` that of a table for another program."""

    problem: Problem
    law: ContactLaw

    def figure(self) -> Figure:
        """Return force, contact radius and stiffness of the law over depth."""
        return self.law.plot()._replace(title=self.title)


@study
def law(
    problem: Problem,
    *,
    largest_depth: float | None = None,
    smallest_depth: float | None = None,
    tolerance: float = 1e-9,
    continue_beyond: bool = False,
    sliders: int = 8,
    shear_strength: float | None = None,
    progress: Progress | None = None,
) -> LawResult:
    """Compile a contact into a law, which other codes evaluate in nanoseconds.

    Parameters
    ----------
    problem : Problem
        With a table [friction] the law has tangential forces.
    largest_depth : float, optional
        End of the law [m]; by default that of [compute].
    smallest_depth : float, optional
        Beginning of the law [m]; by default 1e-4 of the largest depth.
    tolerance : float, optional
        Relative tolerance of force, contact radius and stiffness, 1e-12 to 1e-2 [1].
    continue_beyond : bool, optional
        Continue beyond the largest depth along the tangent.
    sliders : int, optional
        Number of sliders with friction, 4 to 64.
    shear_strength : float, optional
        Constant shear strength of the contact, > 0 [Pa], instead of [friction].
    progress : Progress, optional
        Can stop the work.

    Returns
    -------
    LawResult
        `law`; numbers "smallest depth", "largest depth", "smallest force", "largest force", "error".

    Raises
    ------
    MDRError
        The problem cannot be solved, or the law does not reach its tolerance.

    Examples
    --------
    >>> from mdrcontact import problem, studies
    >>> ball = {"shape": "paraboloid", "radius": "10 um"}
    >>> glass = {"type": "homogeneous", "material": {"E": "72 GPa", "nu": 0.3}}
    >>> found = studies.law(problem.read({"indenter": ball, "medium": glass, "compute": {"max_depth": "300 nm"}}))
    >>> print(found.numbers["largest force"], found.notes["depth"])
    56.045 mN 29.56 pm to 304.47 nm
    """
    progress = progress or Progress()
    progress.step(0, None, "contact")
    contact = problem.contact()
    largest = float(problem.control.states(contact, slice(-1, None))[0].depth) if largest_depth is None else largest_depth
    friction = Friction(contact, problem.friction.coefficient) if problem.friction else None
    progress.step(0, None, "law")
    found = ContactLaw(
        contact,
        largest,
        friction=friction,
        sliders=sliders,
        shear_strength=shear_strength,
        smallest_depth=smallest_depth,
        tolerance=tolerance,
        description=f"{problem.title}; {friction or contact!r}; SI units",
        continue_beyond=continue_beyond,
    )
    numbers, notes = {"error": Number(found.error, RATIO)}, {}
    for name, ends, dimension in (("depth", found.depth_range, LENGTH), ("force", found.force_range, FORCE)):
        first, last = (Number(end, dimension) for end in ends)
        numbers |= {f"smallest {name}": first, f"largest {name}": last}
        notes[name] = f"{first} to {last}"
    notes["error"] = f"{found.error:.0e} relative, tolerance {found.tolerance:.0e}; {found.solutions} contact states"
    if found.sliders:
        off = f"error of T {found.first_shear_error:.1%} of sliding in first shear"
        notes["sliders"] = f"{found.sliders}, {found.memory_size} numbers a contact; {off}"
    return LawResult(
        title=problem.title,
        numbers=numbers,
        notes=notes,
        problem=problem,
        law=found,
    )
