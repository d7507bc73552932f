# SPDX-License-Identifier: GPL-3.0-or-later
"""Waves .ibw of Asylum Research that hold one channel each, or lack what afmformats needs."""

from __future__ import annotations

import importlib
import re
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...errors import FileError
from .afm_curve import AfmCurve, Lever

Array = NDArray[np.float64]

HEIGHTS = ("ZSnsr", "ZSensor", "LVDT", "Zsnsr", "Raw", "Height")
"""Channels of the height, the measured ones first."""
DEFLECTIONS = ("Defl", "Deflection", "DeflV")
"""Channels of the deflection: metres, and volts in the last."""
_CHANNEL = re.compile(rf"(.*?)({'|'.join((*HEIGHTS, *sorted(DEFLECTIONS, key=len, reverse=True)))})", re.IGNORECASE)
_PLACE = re.compile(r"Line(\d+)Point(\d+)", re.IGNORECASE)


class _Wave(NamedTuple):
    """Columns by channel, and the note."""

    columns: dict[str, Array]
    notes: dict[str, str]


def read_waves(path: Path, given: Lever) -> list[AfmCurve]:
    """The force curve of a wave of several channels, or of it and its partner. given : the cantilever in the problem"""
    wave = _load(path)
    columns, notes = dict(wave.columns), dict(wave.notes)
    if len(columns) == 1:
        for other in _partners(path):
            partner = _load(other)
            columns |= partner.columns
            notes |= partner.notes
    height = next((columns[name] for name in HEIGHTS if name in columns), None)
    channel = next((name for name in DEFLECTIONS if name in columns), None)
    if height is None or channel is None:
        raise FileError(
            f"it holds {', '.join(columns)}: a curve needs a deflection and a height; of one channel to a file, keep the files of "
            f"both channels, as in curve{DEFLECTIONS[0]}.ibw and curve{HEIGHTS[2]}.ibw, in one folder"
        )
    lever = Lever(_number(notes, "SpringConstant"), _number(notes, "InvOLS")).replaced(*given)
    own = _number(notes, "InvOLS")
    factor = lever.force_per("V" if channel == DEFLECTIONS[-1] else "m")
    if channel != DEFLECTIONS[-1] and given.sensitivity is not None and own:
        factor *= given.sensitivity / own
    finite = np.isfinite(height) & np.isfinite(columns[channel]) if len(height) == len(columns[channel]) else None
    if finite is None:
        raise FileError(f"height and deflection have {len(height)} and {len(columns[channel])} readings")
    place = _PLACE.search(path.stem)
    what = f"Asylum .ibw: {channel} and {len(columns) - 1} other channels, {int(finite.sum())} points"
    return [
        AfmCurve(
            height[finite],
            factor * columns[channel][finite],
            None,
            lever.spring_constant,
            (float(place[2]), float(place[1])) if place else None,
            None,
            (what, f"spring constant {lever.spring_constant:.4g} N/m"),
        )
    ]


def is_second(path: Path) -> bool:
    """Whether a wave is the height of a deflection in the same folder: both are one curve."""
    match = _CHANNEL.fullmatch(path.stem)
    return bool(match and _is_height(match[2]) and any(not _is_height(_channel(other)) for other in _partners(path)))


def _is_height(channel: str) -> bool:
    return channel.lower() in [name.lower() for name in HEIGHTS]


def _channel(path: Path) -> str:
    match = _CHANNEL.fullmatch(path.stem)
    return match[2] if match else ""


def _partners(path: Path) -> list[Path]:
    """The waves in the folder of a wave that have its name and another channel."""
    match = _CHANNEL.fullmatch(path.stem)
    if match is None:
        return []
    others = path.parent.glob(f"{glob_word(match[1])}*.[iI][bB][wW]")
    return sorted(o for o in others if o != path and (m := _CHANNEL.fullmatch(o.stem)) and m[1].lower() == match[1].lower())


def glob_word(text: str) -> str:
    """A text that a pattern of names takes as it is."""
    return re.sub(r"([*?\[])", r"[\1]", text)


def _load(path: Path) -> _Wave:
    binarywave: Any = importlib.import_module("igor2.binarywave")
    wave = binarywave.load(path)["wave"]
    values = np.asarray(wave["wData"], dtype=float)
    notes = dict(re.findall(r"([^\r\n:]+): *([^\r\n]*)", wave["note"].decode("latin-1")))
    if values.ndim == 1:
        names = [next((n for n in (*HEIGHTS, *DEFLECTIONS) if n.lower() == _channel(path).lower()), path.stem)]
        return _Wave({names[0]: values}, notes)
    labels = [label.decode("latin-1") for labels in wave["labels"] for label in labels if label]
    if values.ndim != 2 or len(labels) != values.shape[1]:
        raise FileError(f"it holds a wave of {values.ndim} dimensions and {len(labels)} channels: it is no force curve")
    return _Wave({label: values[:, i] for i, label in enumerate(labels)}, notes)


def _number(notes: dict[str, str], key: str) -> float | None:
    """A number above 0 of the note."""
    match = re.match(r"[-+.\deE]+", notes.get(key, ""))
    try:
        value = float(match[0]) if match else 0.0
    except ValueError:
        return None
    return value if value > 0.0 and np.isfinite(value) else None
