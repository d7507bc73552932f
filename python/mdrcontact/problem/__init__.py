# SPDX-License-Identifier: GPL-3.0-or-later
"""Problem files: an indenter, a medium and what to compute, in TOML with units."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from ..contact import Contact
from ..medium import Medium
from ..medium.viscoelastic import is_viscoelastic
from ..poroelastic import is_poroelastic
from ..profile import Profile
from . import adhesion, compute, conduction, friction, history, imprint, indenter, medium, schema, strength, wear
from .adhesion import Adhesion
from .compute import Control
from .conduction import Conducting
from .friction import Sliding
from .history import HistoryPath
from .imprint import Imprinted
from .named import Files, Folder, Given, GivenFiles
from .section import WHOLE, ProblemError, Section
from .strength import Strengths
from .structure import MapProblem, load_map, read_map_text
from .tip_file import with_calibration
from .toml import parse_file, parse_text
from .wear import Rubbing

if TYPE_CHECKING:
    from ..plastic import YieldStress

__all__ = ["MapProblem", "Problem", "ProblemError", "load", "load_map", "read", "read_map_text", "read_text", "schema"]


class _Part(NamedTuple):
    """A table that only some problems have."""

    read: Callable[[Section], Any]
    known: schema.Table
    example: str
    """an example of its contents"""


_PARTS: Mapping[str, _Part] = {
    "adhesion": _Part(adhesion.read_adhesion, adhesion.KNOWN, 'work_of_adhesion = "50 mJ/m^2"'),
    "strength": _Part(strength.read_strength, strength.KNOWN, 'von_mises = ["14 GPa", "1.5 GPa"]'),
    "friction": _Part(friction.read_friction, friction.KNOWN, "coefficient = 0.3"),
    "history": _Part(history.read_history, history.KNOWN, 'path = "ramp", depth and rise_time'),
    "wear": _Part(wear.read_wear, wear.KNOWN, 'coefficient = "1e-6 mm^3/(N*m)", sliding = ["1 m"]'),
    "imprint": _Part(imprint.read_imprint, imprint.KNOWN, 'radius = "1 um", force, depth and residual_depth'),
    "conduction": _Part(conduction.read_conduction, conduction.KNOWN, 'kind = "thermal" or "electrical"'),
}


class Problem(NamedTuple):
    """The contents of a problem file."""

    title: str
    indenter: Profile
    medium: Medium
    control: Control
    adhesion: Adhesion | None = None
    strength: Strengths | None = None
    friction: Sliding | None = None
    history: HistoryPath | None = None
    wear: Rubbing | None = None
    imprint: Imprinted | None = None
    conduction: Conducting | None = None
    yield_stresses: tuple[YieldStress | None, ...] = ()
    """of the layers and the substrate of [medium], top to bottom; (): none is given"""
    path: Path | None = None
    """the file; None: the problem is not from a file"""

    def check_elastic(self) -> None:
        """Raise an error for a medium whose states depend on time."""
        if is_poroelastic(self.medium):
            raise self._error("this command does not support gels", "Use mdrcontact history", "medium")
        if is_viscoelastic(self.medium):
            raise self._error("this command does not support viscoelastic bodies", "Use mdrcontact history", "medium")

    def contact(self, in_time: bool = False) -> Contact:
        """Return the contact of indenter and medium, with adhesion if the file has it. in_time : for a history"""
        if not in_time:
            self.check_elastic()
        if self.adhesion is None:
            return Contact(self.indenter, self.medium)
        adhesion = self.adhesion
        if adhesion.rate is not None and not in_time:
            raise self._error(
                "this command does not support a work of adhesion that depends on speed",
                "Use mdrcontact history, or leave out speed, exponent and closing_...",
                "adhesion",
                "speed",
            )
        if adhesion.rate is not None:
            if adhesion.cohesive_stress:
                raise self._error("cohesive_stress and speed exclude each other", "Keep one", "adhesion", "cohesive_stress")
            return Contact(self.indenter, self.medium, adhesion_rule=adhesion.adhesion_rule, adhesion=adhesion.rate)
        return Contact(
            self.indenter,
            self.medium,
            adhesion.work_of_adhesion,
            adhesion.adhesion_rule,
            cohesive_stress=adhesion.cohesive_stress,
        )

    def part(self, name: str) -> Any:
        """Return the contents of a table; an error if the problem has none."""
        part = getattr(self, name)
        if part is None:
            raise self._error(f"the table [{name}] is missing", f"Write it with {_PARTS[name].example}", key=name)
        return part

    def _error(self, rule: str, remedy: str, table: str = "", key: str = "") -> ProblemError:
        return ProblemError(rule, remedy, table=table, key=key, file=str(self.path or ""))


def load(path: str | Path) -> Problem:
    """Read a problem file.

    Parameters
    ----------
    path
        The file. Names of other files in it are relative to its folder.

    Returns
    -------
    Problem
        Its contents, in SI units.

    Raises
    ------
    ProblemError
        If the file cannot be read, or its contents are wrong. The message names the file.

    Examples
    --------
    >>> from pathlib import Path
    >>> import mdrcontact as mdr
    >>> problem = mdr.problem.load(Path(mdr.__file__).parent / "problems" / "sio2_on_si.toml")
    >>> problem.indenter
    Sphere(radius=1e-05)
    """
    path = Path(path)
    try:
        return _read(parse_file(path), path.stem, Folder(path.parent))._replace(path=path)
    except ProblemError as problem:
        raise problem.within(path) from problem


def read_text(text: str, title: str = "", files: Given = ()) -> Problem:
    """Read the text of a problem file from another source.

    Parameters
    ----------
    text
        The text. It may only name files that are given with it.
    title
        The title, if the text has none.
    files
        A dict from names of files to contents (bytes) or paths, or a list of paths.

    Returns
    -------
    Problem
        Its contents, in SI units.

    Raises
    ------
    ProblemError
        If the text is wrong, or names a file that is not given.

    Examples
    --------
    >>> from mdrcontact.problem import read_text
    >>> text = '''
    ... indenter = { shape = "cone", inclination = "20 deg" }
    ... medium = { type = "homogeneous", material = { E = "3 GPa", nu = 0.4 } }
    ... compute = { depths = ["10 nm", "50 nm"] }
    ... '''
    >>> read_text(text).control.values
    array([1.e-08, 5.e-08])
    """
    return _read(parse_text(text), title, GivenFiles(files))


def read(table: dict[str, Any], title: str = "", folder: Path | None = None, files: Given = ()) -> Problem:
    """Read the tables of a problem file.

    Parameters
    ----------
    table
        The tables, as a TOML reader returns them.
    title
        The title, if the tables have none.
    folder
        The folder of files that the tables name. Without it they may only name `files`.
    files
        Given files, as in `read_text`.

    Returns
    -------
    Problem
        Its contents, in SI units.

    Raises
    ------
    ProblemError
        If a table, a key or a value is wrong.

    Examples
    --------
    >>> from mdrcontact.problem import read
    >>> body = {"type": "homogeneous", "material": {"E": "3 GPa", "nu": 0.4}}
    >>> found = read({"indenter": {"shape": "berkovich"}, "medium": body, "compute": {"depths": ["50 nm"]}})
    >>> round(float(found.contact().at_depth(found.control.values[0]).force), 9)
    1.5875e-05
    """
    return _read(table, title, GivenFiles(files) if folder is None else Folder(folder))


def _read(table: dict[str, Any], title: str, files: Files) -> Problem:
    table = with_calibration(table, files)
    whole = Section(table, WHOLE, schema.PROBLEM)
    parts = {name: part.read(Section(table[name], name, part.known, files)) for name, part in _PARTS.items() if name in table}
    path = parts.get("history") or getattr(parts.get("friction"), "path", None)
    sections = {}
    for name, known in (("indenter", indenter.KNOWN), ("medium", medium.KNOWN), ("compute", compute.KNOWN)):
        if name in table:
            sections[name] = Section(table[name], name, known)
        elif name != "compute" or path is None and "imprint" not in parts:
            raise ProblemError(f"the table [{name}] is missing", "A problem needs [indenter], [medium] and [compute]", key=name)
    if "compute" in sections:
        control = compute.read_control(sections["compute"])
    elif path is None:
        control = imprint.unloading(parts["imprint"].force)
    else:
        control = Control(path.name, path.values.max(keepdims=True))
    tip = indenter.read_indenter(sections["indenter"])
    body = medium.read_medium(sections["medium"], sections["indenter"])
    if "conduction" in parts:
        for name in ("indenter", "medium"):
            conduction.check_kind(parts["conduction"].kind, table[name], name)
    stresses = medium.read_yield_stresses(sections["medium"])
    return Problem(str(whole.plain("title", title)), tip, body, control, **parts, yield_stresses=stresses)
