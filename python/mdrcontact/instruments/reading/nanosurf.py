# SPDX-License-Identifier: GPL-3.0-or-later
"""Files .nid of Nanosurf: a header of keys, and integers of 16 or 32 bits for each line of each channel."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...errors import FileError
from .afm_curve import AfmCurve, Lever, Phase, joined
from .content import content_of

Array = NDArray[np.float64]

_PHASES = (("Spec forward", "loading"), ("Spec fwd pause", "hold"), ("Spec backward", "unloading"))
_DEFLECTION, _HEIGHT = "Deflection", "Z-Axis Sensor"
_BEGIN = b"\r\n#!"
"""Before the numbers."""
_CALIBRATION = "DataSet\\Calibration\\"
_FORCE, _LENGTH = "In0", "In5"
"""Inputs of the deflection: its range as a force, and as a length."""
_VOLTS = 10.0
"""The range of the inputs as a voltage [V]."""


class _Channel(NamedTuple):
    """One channel of one direction."""

    keys: Mapping[str, str]
    values: Array
    """lines, points; in the unit of the channel"""

    def line(self, i: int) -> Array:
        """The points of one curve."""
        values: Array = self.values[i, : int(self.keys.get(f"LineDim{i}Points", self.values.shape[1]))]
        return values

    def ramp(self, i: int) -> Array:
        """The axis along which a curve was measured."""
        prefix = f"LineDim{i}" if f"LineDim{i}Range" in self.keys else "Dim0"
        begin, span = float(self.keys[f"{prefix}Min"]), float(self.keys[f"{prefix}Range"])
        return begin + span * np.linspace(0.0, 1.0, len(self.line(i)))


def read_nid(path: Path, given: Lever) -> list[AfmCurve]:
    """The force curves of a file. given : properties of the cantilever in the problem"""
    head, mark, numbers = content_of(path).partition(_BEGIN)
    if not mark or not head.startswith(b"[DataSet]"):
        raise FileError("it is no .nid file: it does not begin with data sets")
    header = _header(head.decode("latin-1"))
    channels = _channels(header, numbers)
    if ("Spec forward", _DEFLECTION) not in channels:
        raise FileError(f"it holds no force curves, but {', '.join(sorted({frame for frame, _ in channels}))}")
    lines = len(channels["Spec forward", _DEFLECTION].values)
    unit = channels["Spec forward", _DEFLECTION].keys["Dim2Unit"]
    own = _lever(header)
    lever = own.replaced(*given)
    # a file of forces was made with its own constants
    factor = lever.force_per("V") / own.force_per("V") if unit == "N" and given != (None, None) else 1.0
    factor = factor if unit == "N" else lever.force_per(unit)
    notes = [f"Nanosurf .nid: {_DEFLECTION.lower()} in {unit}, {lines} curves"]
    notes += [f"forces times {factor:.4g}, according to [instrument]"] if unit == "N" and factor != 1.0 else []
    return [_curve(channels, i, factor, lever, notes) for i in range(lines)]


def _header(text: str) -> dict[str, dict[str, str]]:
    """Keys and values of each section."""
    found = {}
    for section in re.split(r"\r\n(?=\[)", text):
        title, *lines = section.split("\r\n")
        found[title.strip("[] ")] = dict(line.split("=", 1) for line in lines if "=" in line)
    return found


def _channels(header: Mapping[str, Mapping[str, str]], numbers: bytes) -> dict[tuple[str, str], _Channel]:
    """Channels by direction and quantity."""
    found: dict[tuple[str, str], _Channel] = {}
    begin = 0
    for section, keys in header.items():
        if not re.fullmatch(r"DataSet-\d+:\d+", section):
            continue
        points, lines, bits = (int(keys[name]) for name in ("Points", "Lines", "SaveBits"))
        if bits not in (16, 32) or points < 1 or lines < 1 or begin + points * lines * bits // 8 > len(numbers):
            raise FileError(f"it ends within the data set {section}, or is damaged")
        raw = np.frombuffer(numbers, f"<i{bits // 8}", points * lines, begin).reshape(lines, points)
        begin += points * lines * bits // 8
        share = (raw.astype(float) + 2.0 ** (bits - 1)) / 2.0**bits
        values = float(keys["Dim2Min"]) + float(keys["Dim2Range"]) * share
        found.setdefault((keys["Frame"], keys.get("Dim2Name", "")), _Channel(keys, values))
    return found


def _lever(header: Mapping[str, Mapping[str, str]]) -> Lever:
    """Cantilever constants from the ranges of one input as force, length and voltage."""
    inputs = header.get(f"{_CALIBRATION}Scanhead", {})
    ranges = {name: inputs[name].split(",") for name in (_FORCE, _LENGTH) if name in inputs}
    force, length = (
        float(ranges[name][4]) if name in ranges and ranges[name][3] == unit else None
        for name, unit in ((_FORCE, "N"), (_LENGTH, "m"))
    )
    return Lever(force / length if force and length else None, length / _VOLTS if length else None)


def _curve(channels: Mapping[tuple[str, str], _Channel], i: int, factor: float, lever: Lever, notes: list[str]) -> AfmCurve:
    phases = []
    for frame, kind in _PHASES:
        channel = channels.get((frame, _DEFLECTION))
        if channel is None or i >= len(channel.values):
            continue
        sensor = channels.get((frame, _HEIGHT))
        height = channel.ramp(i) if sensor is None else sensor.line(i)
        turn = slice(None, None, -1) if kind == "unloading" else slice(None)
        # the way back lies in the file as the way in does
        phases.append(Phase(kind, height[turn], channel.line(i)[turn]))
    height, deflection, segments = joined(phases)
    return AfmCurve(height, factor * deflection, None, lever.spring_constant, None, segments, tuple(notes), number=i + 1)
