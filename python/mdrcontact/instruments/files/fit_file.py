# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables [data], [instrument] and [fit] of a problem file for `mdrcontact fit`."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ..._choices import nearest
from ..._units import LENGTH, dimensions, shown
from ...errors import MDRError
from ...poroelastic import is_poroelastic
from ...problem import indenter as indenters
from ...problem import medium as mediums
from ...problem.named import Folder, Given, GivenFiles
from ...problem.section import WHOLE, ProblemError, Section
from ...problem.tip_file import with_calibration
from ...problem.toml import parse_file, parse_text
from ...progress import Progress
from .. import schema
from ..fitting import Free, Instrument, JointPrior
from ..fitting.data import Data, StiffnessDepth
from ..fitting.gel import NAMES as GEL_NAMES
from ..fitting.parameters import pattern_of
from ..fitting.quantities import dimension_of
from ..reading.area_function import area
from ..reading.formats import Fact, terms_of
from . import curves as files
from . import data as measured
from .data_keys import KNOWN, RECORDS
from .record import Cantilever

_APART = 0.01
"""Largest relative difference between numbers of two files that counts as rounding."""


class FitFile(NamedTuple):
    """Content of a problem file for a fit, from `load_fit_file`.

    Examples
    --------
    >>> text = '''
    ... [indenter]
    ... shape = "paraboloid"
    ... radius = "10 um"
    ... [medium]
    ... type = "homogeneous"
    ... material = { E = "50 GPa", nu = 0.17 }
    ... [data]
    ... kind = "force-depth"
    ... [fit]
    ... free = ["E"]
    ... '''
    >>> problem = mdr.instruments.fit_file_of_text(text, "Silica")
    >>> print(problem.title, list(problem.free), sorted(problem.arguments))
    Silica ['E'] ['free', 'indenter', 'instrument', 'medium']
    """

    title: str
    """title of the problem"""
    indenter: Any
    """the indenter"""
    medium: Any
    """the body, with fixed and starting values"""
    instrument: Instrument
    """properties of the instrument"""
    cantilever: Cantilever
    """properties of the cantilever, for AFM files"""
    free: dict[str, Free]
    """free parameters by name"""
    options: dict[str, Any]
    """further arguments of `fit`"""
    data: Section
    """the table [data], which describes how to read files"""
    drainage: str | None = None
    """drainage of a gel, else None"""
    tip: Mapping[str, Any] = {}
    """the table [indenter]; of a calibrated tip the table of its file"""

    @property
    def arguments(self) -> dict[str, Any]:
        """Arguments of `fit` except the data."""
        known = {"indenter": self.indenter, "medium": self.medium, "free": self.free, "instrument": self.instrument}
        return {**known, **self.options}

    def curves(self, path: str | Path) -> list[files.Curve]:
        """Return the curves of one file.

        Parameters
        ----------
        path : str or Path
            The file.

        Returns
        -------
        list of Curve
            Curves that are read on demand, with a warning if the file contradicts the problem.

        Raises
        ------
        MDRError
            The file cannot be read.
        """
        found = files.curves(self.data, self.cantilever, Path(path))
        return [one._replace(read=partial(self._read, one)) for one in found]

    def all_curves(self, paths: Sequence[Path], progress: Progress) -> list[files.Curve]:
        """Return the curves of several files.

        Parameters
        ----------
        paths : sequence of Path
            The files. A file that cannot be read becomes a curve that cannot be read.
        progress : Progress
            Reports the files, and can stop the work between two of them.

        Returns
        -------
        list of Curve
            Curves that are read on demand.
        """
        found: list[files.Curve] = []
        for done, path in enumerate(paths, start=1):
            try:
                found += self.curves(path)
            except MDRError as refusal:
                found.append(files.Curve(path.name, partial(_refuse, refusal)))
            progress.step(done, len(paths), "files")
        return found

    def _read(self, curve: files.Curve) -> tuple[Data, list[str]]:
        data, notes = curve.read()
        if curve.facts:
            notes = [*notes, f"stated in the file: {', '.join(map(str, curve.facts))}"]
        data.warnings += [*self._contradictions(curve.facts), *self._other_tip(terms_of(curve.facts), data)]
        return data, notes

    def _contradictions(self, facts: Sequence[Fact]) -> list[str]:
        """Notes on numbers that differ between the file and the problem."""
        said = {"indenter.radius": getattr(self.indenter, "radius", None), "spring_constant": self.cantilever.spring_constant}
        words = []
        for fact in facts:
            own = said.get(fact.name)
            if own is not None and abs(own - fact.value) > _APART * abs(fact.value):
                words.append(
                    f"{fact.name} is {shown(own, fact.dimension)} in the problem file and {shown(fact.value, fact.dimension)} in "
                    "the file of the instrument: one of them is wrong"
                )
        return words

    def _other_tip(self, terms: Mapping[int, float], data: Data) -> list[str]:
        """Note if the tip of the problem has another area than the tip of the file at the depths of the data."""
        if not terms or not isinstance(data, StiffnessDepth):
            return []
        height = 0.7 * float(np.median(data.x))
        found = area(terms, height) if height > 0.0 else 0.0
        if found <= 0.0:
            return []
        radius = math.sqrt(found / math.pi)
        try:
            own = float(self.indenter.height(radius))
        except MDRError:
            return []
        if abs(own - height) <= _APART * height:
            return []
        return [
            f"the file gives the area function of its tip, which has a radius of {shown(radius, LENGTH)} at a height of "
            f"{shown(height, LENGTH)}; that of the problem file has it at {shown(own, LENGTH)}: give [indenter] shape = "
            '"area-function" with the coefficients of the file, or one of them is wrong'
        ]

    def read_data(self, path: str | Path) -> tuple[Data, list[str]]:
        """Read the data of a file with one curve, or of its first.

        Parameters
        ----------
        path : str or Path
            The file.

        Returns
        -------
        tuple
            The data, and notes on how the file was interpreted.

        Raises
        ------
        MDRError
            The file cannot be read.
        """
        return self.curves(path)[0].read()


def _refuse(refusal: MDRError) -> Any:
    raise refusal


def load_fit_file(path: str | Path) -> FitFile:
    """Read a problem file for a fit.

    Parameters
    ----------
    path : str or Path
        The file (TOML).

    Returns
    -------
    FitFile
        Its content.

    Raises
    ------
    ProblemError
        The file has an error; the message names it.

    Examples
    --------
    >>> import tempfile
    >>> from pathlib import Path
    >>> text = '''
    ... [indenter]
    ... shape = "paraboloid"
    ... radius = "10 um"
    ... [medium]
    ... type = "homogeneous"
    ... material = { E = "50 GPa", nu = 0.17 }
    ... [data]
    ... kind = "force-depth"
    ... [fit]
    ... free = ["E"]
    ... '''
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = Path(folder) / "silica.toml"
    ...     _ = path.write_text(text)
    ...     problem = mdr.instruments.load_fit_file(path)
    >>> print(problem.title, problem.indenter)
    silica Paraboloid(radius=1e-05)
    """
    path = Path(path)
    try:
        return _read(with_calibration(parse_file(path), Folder(path.parent)), path.stem)
    except ProblemError as problem:
        raise problem.within(path) from problem


def fit_file_of_text(text: str, title: str = "", files: Given = ()) -> FitFile:
    """Read the text of a problem file for a fit.

    Parameters
    ----------
    text : str
        The text (TOML).
    title : str, optional
        Title if the text has none.
    files : mapping or sequence, optional
        Files by name that the text may name, as the file of a calibrated tip.

    Returns
    -------
    FitFile
        Its content.

    Raises
    ------
    ProblemError
        The text has an error.

    Examples
    --------
    >>> text = '''
    ... [indenter]
    ... shape = "paraboloid"
    ... radius = "10 um"
    ... [medium]
    ... type = "homogeneous"
    ... material = { E = "50 GPa", nu = 0.17 }
    ... [data]
    ... kind = "force-depth"
    ... [fit]
    ... free = ["E"]
    ... '''
    >>> print(mdr.instruments.fit_file_of_text(text).medium)
    Homogeneous(material=Elastic(E=50000000000.0, nu=0.17))
    """
    return _read(with_calibration(parse_text(text), GivenFiles(files)), title)


def _read(table: dict[str, Any], title: str) -> FitFile:
    if "adhesion" in table:
        raise ProblemError(
            "a fit takes adhesion from the instrument",
            "Write work_of_adhesion in [instrument], and name it in [fit] free to find it",
            table="adhesion",
        )
    whole = Section(table, WHOLE, schema.FIT)
    for name in ("indenter", "medium", "data", "fit"):
        if name not in table:
            raise ProblemError(f"the table [{name}] is missing", "A fit has [indenter], [medium], [data] and [fit]", key=name)
    shape = Section(table["indenter"], "indenter", indenters.KNOWN)
    body = mediums.read_medium(Section(table["medium"], "medium", mediums.KNOWN), shape)
    of_instrument = Section(table.get("instrument", {}), "instrument", schema.INSTRUMENT)
    instrument, cantilever = _read_instrument(of_instrument), Cantilever(**of_instrument.given(schema.CANTILEVER))
    tip = indenters.read_indenter(shape)
    fit, data = Section(table["fit"], "fit", schema.OPTIONS), Section(table["data"], "data", KNOWN)
    drainage, options = None, dict[str, Any]()
    if is_poroelastic(body):
        free, drainage = _read_gel(fit, instrument)
    else:
        fit.only([key for key in schema.OPTIONS if key != "drainage"], "a body without a fluid")
        if "contact_weight_rule" in fit and "contact_weight" not in fit:
            raise fit.error("contact_weight", "contact_weight_rule needs contact_weight", "Give both, or leave it out", shows=False)
        names = pattern_of(tip, body, instrument).names
        options = {key: fit.value(key) for key in schema.TAKEN if key in fit}
        if "joint_prior" in fit:
            options["known"] = [_read_joint_prior(section, names) for section in fit.value("joint_prior")]
        free = _read_free(fit, names)
        if stresses := mediums.read_yield_stresses(Section(table["medium"], "medium", mediums.KNOWN)):
            options["yield_stresses"] = stresses
    measured.check(data)
    if data.plain("kind") not in RECORDS:
        because = f"kind = {data.plain('kind')!r}, which has no deflection"
        of_instrument.only([key for key in schema.INSTRUMENT if key not in schema.CANTILEVER], because)
    return FitFile(
        str(whole.plain("title", title)), tip, body, instrument, cantilever, free, options, data, drainage, table["indenter"]
    )


def _read_gel(fit: Section, instrument: Instrument) -> tuple[dict[str, Free], str]:
    """Free numbers and drainage of a gel."""
    fit.only(("free", "drainage"), "a poroelastic gel")
    if instrument != Instrument():
        raise ProblemError("fits of gels take data without offsets and compliances", "Leave the table out", table="instrument")
    free = fit.plain("free") if "free" in fit else None
    if not isinstance(free, list) or not free or any(name not in GEL_NAMES for name in free):
        rule = f"free must name numbers of the gel, of {', '.join(GEL_NAMES)}"
        raise fit.error("free", rule, 'Write it as in free = ["diffusivity"]', shows=False)
    return {name: Free() for name in free}, fit.choice("drainage", schema.OPTIONS.field("drainage").choices)


def _read_instrument(section: Section) -> Instrument:
    given = section.given(dimensions(Instrument))
    material = mediums.read_indenter_material(section.value("indenter")) if "indenter" in section else None
    return Instrument(indenter=material, **given)


def _read_free(fit: Section, names: list[str]) -> dict[str, Free]:
    """[fit] free = ["coating.E", ...], or a table [fit.free] with start, lower, upper, prior, prior_sd for each name."""
    given = fit.plain("free") if "free" in fit else None
    if isinstance(given, list) and given and all(isinstance(name, str) for name in given):
        given = {name: {} for name in given}
    if not isinstance(given, dict) or not given:
        remedy = 'Write it as in free = ["coating.E"], or as a table [fit.free]'
        raise fit.error("free", "free must name parameters", remedy, shows=False)
    free = {}
    for name, entry in given.items():
        known = [n for n in names if n]
        if name not in known:
            rule = f"{name!r} is not a parameter of this problem: {nearest(name, known)}"
            raise ProblemError(rule, table="fit", key="free")
        section = Section(entry, f'fit.free."{name}"', dict.fromkeys(schema.FREE, dimension_of(name)))
        value = section.given(schema.FREE)
        if ("prior" in value) != ("prior_sd" in value):
            key = "prior_sd" if "prior" in value else "prior"
            raise section.error(key, "prior and prior_sd belong together", "Give both or none", shows=False)
        prior = (value.pop("prior"), value.pop("prior_sd")) if "prior" in value else None
        with section.words():
            free[name] = Free(**value, prior=prior)
    return free


def _read_joint_prior(section: Section, names: list[str]) -> JointPrior:
    """Joint prior of several parameters: values and standard deviations with units, and their correlation."""
    chosen = section.plain("names")
    if not isinstance(chosen, list) or not chosen:
        remedy = 'Write it as in names = ["indenter.C0", "indenter.C1"]'
        raise section.error("names", "names must be a list of parameters", remedy, shows=False)
    for name in chosen:
        if not name or name not in names:
            rule = f"{name!r} is not a parameter of this problem: {nearest(str(name), [n for n in names if n])}"
            raise section.error("names", rule, shows=False)
    if len(set(chosen)) < len(chosen):
        raise section.error("names", "names contains a parameter twice", "Name each parameter once", shows=False)
    columns = []
    for key in ("values", "sds"):
        given = section.plain(key)
        if not isinstance(given, list) or len(given) != len(chosen):
            raise section.error(key, f"it must be a list of {len(chosen)} entries, one for each name")
        entries = Section(dict(zip(chosen, given, strict=True)), section.path, {n: dimension_of(n) for n in chosen})
        try:
            columns.append([*entries.given(chosen).values()])
        except ProblemError as problem:
            raise section.error(key, problem.rule, problem.remedy, chosen.index(problem.key) + 1) from None
    values, sds = columns
    rows = section.plain("correlation", np.eye(len(chosen)))
    try:
        covariance = tuple(tuple(float(c) * a * b for c, b in zip(row, sds, strict=True)) for row, a in zip(rows, sds, strict=True))
    except (TypeError, ValueError) as problem:
        raise section.error("correlation", f"it must be {len(chosen)} rows of {len(chosen)} numbers") from problem
    with section.words():
        return JointPrior(tuple(chosen), tuple(values), covariance)
