# SPDX-License-Identifier: GPL-3.0-or-later
"""Problem files: an indenter, a medium and what to compute, in TOML with units written out."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

from ..contact import Contact
from ..medium import Medium
from ..medium.viscoelastic import is_viscoelastic
from ..poroelastic import is_poroelastic
from ..profile import Profile
from . import adhesion, compute, conduction, friction, history, indenter, medium, strength, wear
from .adhesion import Adhesion
from .compute import Control
from .conduction import Conducting
from .friction import Sliding
from .history import HistoryPath
from .section import ProblemError, Section
from .strength import Strengths
from .tip_file import with_calibration
from .toml import parse_file
from .wear import Rubbing

__all__ = ["Problem", "ProblemError", "load", "read"]

_TABLES = dict.fromkeys(
    ("title", "indenter", "medium", "compute", "adhesion", "strength", "friction", "history", "wear", "conduction")
)


class Problem(NamedTuple):
    """What a problem file says."""

    title: str
    indenter: Profile
    medium: Medium
    control: Control
    adhesion: Adhesion | None = None
    strength: Strengths | None = None
    friction: Sliding | None = None
    history: HistoryPath | None = None
    wear: Rubbing | None = None
    conduction: Conducting | None = None

    def check_elastic(self) -> None:
        """Refuses a medium whose states depend on time, for a command that knows no time."""
        if is_poroelastic(self.medium):
            raise ProblemError("[medium] is a poroelastic gel, and this command takes elastic bodies: use mdrcontact history")
        if is_viscoelastic(self.medium):
            raise ProblemError("[medium] is viscoelastic, and this command takes elastic bodies: use mdrcontact history")

    def contact(self, in_time: bool = False) -> Contact:
        """The contact of the indenter with the medium, with adhesion if the file has it; viscoelastic only if led `in_time`."""
        if not in_time:
            self.check_elastic()
        if self.adhesion is None:
            return Contact(self.indenter, self.medium)
        adhesion = self.adhesion
        if adhesion.rate is not None and in_time:
            if adhesion.cohesive_stress:
                raise ProblemError("[adhesion]: cohesive_stress and speed exclude each other")
            return Contact(self.indenter, self.medium, adhesion_rule=adhesion.adhesion_rule, adhesion=adhesion.rate)
        return Contact(
            self.indenter,
            self.medium,
            adhesion.work_of_adhesion,
            adhesion.adhesion_rule,
            cohesive_stress=adhesion.cohesive_stress,
        )


def load(path: str | Path) -> Problem:
    """Reads a problem file; a fault in it is a `ProblemError` that names the file."""
    path = Path(path)
    try:
        return read(with_calibration(parse_file(path), path.parent), title=path.stem, folder=path.parent)
    except ProblemError as problem:
        raise ProblemError(f"{path}: {problem}") from problem


def read(table: dict[str, Any], title: str = "", folder: Path = Path()) -> Problem:
    """The problem that the tables of a problem file describe; files that it names lie in `folder`."""
    whole = Section(table, "the file", _TABLES)
    sections = {}
    path = sliding = None
    if "history" in table:
        path = history.read_history(Section(table["history"], "history", history.KNOWN), folder)
    if "friction" in table:
        sliding = friction.read_friction(Section(table["friction"], "friction", friction.KNOWN), folder)
    way = path or (sliding and sliding.path)
    for name, known in (("indenter", indenter.KNOWN), ("medium", medium.KNOWN), ("compute", compute.KNOWN)):
        if name == "compute" and way and name not in table:
            continue
        if name not in table:
            raise ProblemError(f"the table [{name}] is missing: a problem has [indenter], [medium] and [compute]")
        sections[name] = Section(table[name], name, known)
    shape = sections["indenter"]
    if "compute" in sections or not way:
        control = compute.read_control(sections["compute"])
    else:
        control = Control(way.name, way.values.max(keepdims=True))
    if "title" in whole:
        title = str(whole.plain("title"))
    return Problem(
        title,
        indenter.read_indenter(shape),
        medium.read_medium(sections["medium"], shape),
        control,
        adhesion.read_adhesion(Section(table["adhesion"], "adhesion", adhesion.KNOWN)) if "adhesion" in table else None,
        strength.read_strength(Section(table["strength"], "strength", strength.KNOWN)) if "strength" in table else None,
        sliding,
        path,
        wear.read_wear(Section(table["wear"], "wear", wear.KNOWN)) if "wear" in table else None,
        conduction.read_conduction(Section(table["conduction"], "conduction", conduction.KNOWN)) if "conduction" in table else None,
    )
