# SPDX-License-Identifier: GPL-3.0-or-later
"""Binary files of atomic force microscopes, read with afmformats, or by readers of their own."""

from __future__ import annotations

import importlib
import logging
import math
import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import FileError, MDRError
from ..records.segments import segments_of_numbers
from .afm_curve import AfmCurve, Array, Lever, MissingSettings
from .asylum import read_waves
from .content import begin_of
from .nanoscope import SIGNS, read_nanoscope
from .nanosurf import read_nid

_OWN: Mapping[str, Callable[[Path, Lever], list[AfmCurve]]] = {".nid": read_nid, ".spm": read_nanoscope}
"""Readers of files that afmformats does not support."""
SUFFIXES = (".jpk-force", ".jpk-force-map", ".jpk-qi-data", ".jpk-qi-series", ".h5", ".ibw", ".tab", ".zip", *_OWN)
"""Endings of files that are no tables."""
_NUMBERED = re.compile(r"\.\d{3}")
"""Endings that NanoScope gives its files."""
TEXT_SUFFIXES = (".csv", ".txt")
"""Endings of files that it may support if they are no plain tables."""
_BEGIN = 50_000
"""Bytes in which the numbers of a text begin."""
_NUMBER = re.compile(r"\s*[-+]?\.?\d")
_HINTS = {
    ".zip": "; unpack it, and give the folder of its files",
    ".h5": "; of HDF5 only force curves that it wrote are read: export depth, force and time as text",
}
"""Remedies for files whose format differs from their ending."""
_MODALITIES = ("force-distance", "creep-compliance", "stress-relaxation")
_HEIGHTS = ("height (measured)", "height (piezo)")


def is_of_afm(path: Path) -> bool:
    """Whether a file is one of an AFM, by its ending, or by its begin where the ending is a number."""
    if not _NUMBERED.fullmatch(path.suffix):
        return path.suffix.lower() in SUFFIXES
    return path.is_file() and begin_of(path, max(map(len, SIGNS))).startswith(SIGNS)


def read_afm(path: Path, spring_constant: float | None = None, deflection_sensitivity: float | None = None) -> list[AfmCurve]:
    """Read all force curves of a file of an AFM.

    It needs afmformats: `pip install "mdrcontact[afm]"`.

    Parameters
    ----------
    path : Path
        The file.
    spring_constant : float, optional
        Spring constant of the cantilever [N/m]; None is that of the file.
    deflection_sensitivity : float, optional
        Deflection sensitivity [m/V]; None is that of the file.

    Returns
    -------
    list of AfmCurve
        Heights [m], forces [N], times [s] and segments.

    Raises
    ------
    FileError
        The file contains no force curves or cannot be read.
    MDRError
        afmformats is not installed.

    Examples
    --------
    >>> from pathlib import Path
    >>> try:
    ...     mdr.instruments.read_afm(Path("no-such-file.jpk-force"))
    ... except mdr.MDRError as problem:
    ...     print(type(problem).__name__)
    FileError
    """
    if not path.is_file():
        raise FileError(f"{path}: it cannot be read: there is no such file")
    given = Lever(spring_constant, deflection_sensitivity)
    own = read_nanoscope if _NUMBERED.fullmatch(path.suffix) else _OWN.get(path.suffix.lower())
    if own is not None:
        return _by_own(own, path, given)
    try:
        return _by_afmformats(path, given)
    except MissingSettings:
        raise
    except FileError as refusal:
        if path.suffix.lower() != ".ibw":
            raise
        return _by_own(read_waves, path, given, refusal)


def _by_own(
    read: Callable[[Path, Lever], list[AfmCurve]], path: Path, given: Lever, refusal: FileError | None = None
) -> list[AfmCurve]:
    """The curves of a reader, with errors that name the file. refusal : error of another reader, raised if the file is damaged"""
    try:
        return read(path, given)
    except MDRError as problem:
        fault = MissingSettings if isinstance(problem, MissingSettings) else FileError
        # of words of the file an end of line is none
        raise fault(f"{path}: {' '.join(str(problem).split())}") from problem
    except Exception as problem:  # noqa: BLE001 - damage makes readers raise anything
        words = f"{path}: it cannot be read, it is damaged or of another kind: {type(problem).__name__}"
        raise refusal or FileError(words) from problem


def _by_afmformats(path: Path, lever: Lever) -> list[AfmCurve]:
    try:
        afmformats: Any = importlib.import_module("afmformats")
    except ImportError as problem:
        raise MDRError(f'{path}: files of this kind need afmformats: pip install "mdrcontact[afm]"') from problem
    # they log their errors, one of them with the whole file
    for name in ("afmformats", "igor2"):
        logging.getLogger(name).setLevel(logging.CRITICAL + 1)
    given = {"spring constant": lever.spring_constant, "sensitivity": lever.sensitivity}
    chosen = {name: value for name, value in given.items() if value is not None}
    try:
        # NumPy would warn of a text without numbers or with comments above them, which is of no AFM
        if path.suffix.lower() in TEXT_SUFFIXES and not _may_be_text(path):
            raise ValueError("no curve in a text")
        try:
            loaded = afmformats.load_data(path)
        except afmformats.errors.MissingMetaDataError:
            loaded = afmformats.load_data(path, meta_override=chosen)
        curves = numbered([(data.metadata.get("enum"), _curve(data, chosen)) for data in loaded if data.modality in _MODALITIES])
    except MDRError as problem:
        fault = MissingSettings if isinstance(problem, MissingSettings) else FileError
        raise fault(f"{path}: {problem}") from problem
    except afmformats.errors.MissingMetaDataError as problem:
        raise MissingSettings(f"{path}: {problem}: give [instrument] spring_constant and deflection_sensitivity") from problem
    except (Exception, afmformats.errors.AFMFileFormatError) as problem:  # noqa: BLE001 - damage makes readers raise anything
        hint = _HINTS.get(path.suffix.lower(), "")
        raise FileError(f"{path}: afmformats cannot read it{hint}: {type(problem).__name__}: {problem}") from problem
    if not curves:
        raise FileError(f"{path}: it holds no curves of force against distance, of creep or of relaxation")
    return curves


def _may_be_text(path: Path) -> bool:
    """Whether a text begins with no comment, and has a line that begins with a number."""
    lines = begin_of(path, _BEGIN).decode("utf-8", "replace").split("\n")
    return not lines[0].startswith("#") and any(map(_NUMBER.match, lines))


def _curve(data: Any, chosen: dict[str, float]) -> AfmCurve:
    columns = list(data.columns)
    height = next((name for name in _HEIGHTS if name in columns), None)
    if height is None or "force" not in columns:
        raise FileError(f"it has no height and force, but {', '.join(columns)}")
    meta = data.metadata
    if "sensitivity" in chosen and not meta.get("sensitivity"):
        raise MissingSettings(
            "deflection_sensitivity: the file has forces and does not state their sensitivity. Leave it out, and "
            "correct the spring_constant"
        )
    # forces are deflection [V] times sensitivity times spring constant
    factor = 1.0
    for name, value in chosen.items():
        factor *= value / (meta.get(name) or value)
    constant = chosen.get("spring constant") or meta.get("spring constant")
    is_in_time = data.modality != "force-distance"
    what = [f"{meta.get('format', 'AFM file')}: {height} and force, {len(data)} points"]
    if is_in_time:
        what.append(f"a test of {data.modality.replace('-', ' ')}: kind depth-time or force-time")
    if constant:
        what.append(f"spring constant {constant:.4g} N/m")
    if factor != 1.0:
        what.append(f"forces times {factor:.4g}, for spring constant and deflection sensitivity of [instrument]")
    # heights fall on the way into the sample
    depth = -np.asarray(data[height], dtype=float)
    return AfmCurve(
        depth,
        factor * np.asarray(data["force"], dtype=float),
        np.asarray(data["time"], dtype=float) if "time" in columns else _sampled(meta, len(depth)),
        float(constant) if constant else None,
        _pair(meta, "grid index x", "grid index y"),
        segments_of_numbers(np.asarray(data["segment"]), depth) if "segment" in columns else None,
        tuple(what),
        _pair(meta, "position x", "position y"),
        is_in_time,
    )


def numbered(curves: Sequence[tuple[Any, AfmCurve]]) -> list[AfmCurve]:
    """The curves in the order in which the file counts them; in the order of the file where it does not."""
    counts = [count for count, _ in curves]
    known = all(isinstance(count, (int, np.integer)) for count in counts) and len(set(counts)) == len(counts)
    found = [one._replace(number=int(count) + 1 if known else i) for i, (count, one) in enumerate(curves, start=1)]
    return sorted(found, key=lambda one: one.number)


def _sampled(meta: Any, count: int) -> Array | None:
    """The time of each reading by the rate of sampling; None where the file has no rate, or two."""
    rates = {meta.get(f"rate {part}") for part in ("approach", "retract")} - {None}
    rate = float(rates.pop()) if len(rates) == 1 else math.nan
    return np.arange(count) / rate if 0.0 < rate < math.inf else None


def _pair(meta: Any, *names: str) -> tuple[float, float] | None:
    """Two numbers of the file; None where one is missing."""
    x, y = (meta.get(name) for name in names)
    return None if x is None or y is None or not np.isfinite([x, y]).all() else (float(x), float(y))
