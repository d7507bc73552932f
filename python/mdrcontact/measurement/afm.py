# SPDX-License-Identifier: GPL-3.0-or-later
"""Binary files of atomic force microscopes, read with afmformats."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..errors import FileError, MDRError

Array = NDArray[np.float64]

SUFFIXES = (".jpk-force", ".jpk-force-map", ".jpk-qi-data", ".jpk-qi-series", ".h5", ".ibw", ".tab")
"""Endings of files that are left to afmformats."""
_HEIGHTS = ("height (measured)", "height (piezo)")


class AfmCurve(NamedTuple):
    """One force curve, SI units."""

    height: Array
    force: Array
    time: Array | None
    spring_constant: float | None
    place: tuple[float, float] | None
    """column and row in a map, or None"""
    notes: tuple[str, ...]


def read_afm(path: Path) -> list[AfmCurve]:
    """All force curves of a file; `FileError` where it holds none or cannot be read."""
    try:
        afmformats: Any = importlib.import_module("afmformats")
    except ImportError as problem:
        raise MDRError(f'{path}: files of this kind need afmformats: pip install "mdrcontact[afm]"') from problem
    if not path.is_file():
        raise FileError(f"{path}: it cannot be read: there is no such file")
    try:
        curves = [_curve(data) for data in afmformats.load_data(path) if data.modality == "force-distance"]
    except MDRError:
        raise
    except Exception as problem:  # noqa: BLE001 - a damaged file makes its reader raise almost anything
        raise FileError(f"{path}: afmformats cannot read it: {type(problem).__name__}: {problem}") from problem
    if not curves:
        raise FileError(f"{path}: it holds no curves of force against distance")
    return curves


def _curve(data: Any) -> AfmCurve:
    columns = list(data.columns)
    height = next((name for name in _HEIGHTS if name in columns), None)
    if height is None or "force" not in columns:
        raise FileError(f"it has no height and force, but {', '.join(columns)}")
    meta = data.metadata
    place = meta.get("grid index x"), meta.get("grid index y")
    constant = meta.get("spring constant")
    what = [f"{meta.get('format', 'AFM file')}: {height} and force, {len(data)} points"]
    if constant:
        what.append(f"spring constant {constant:.4g} N/m from the file")
    return AfmCurve(
        np.asarray(data[height], dtype=float),
        np.asarray(data["force"], dtype=float),
        np.asarray(data["time"], dtype=float) if "time" in columns else None,
        float(constant) if constant else None,
        (float(place[0]), float(place[1])) if place[0] is not None and place[1] is not None else None,
        tuple(what),
    )
