# SPDX-License-Identifier: GPL-3.0-or-later
"""Force curves of NanoScope: a header of keys, and integers of 16 or 32 bits for trace and retrace."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...errors import FileError
from .afm_curve import AfmCurve, Lever, Phase, joined
from .content import content_of

Array = NDArray[np.float64]

SIGNS = (b"\\*Force file list", b"\\*File list", b"\\*EC File list")
_END = b"\\*File list end"
_SCALED = re.compile(r"V \[(Sens\. \S+)\] \(([-+.\deE]+) V/LSB\) ([-+.\deE]+) V")
_SENSITIVITY = re.compile(r"V ([-+.\deE]+)\s*(\S*)")
_PER_VOLT = {"": 1e-9, "nm/V": 1e-9, "um/V": 1e-6, "pm/V": 1e-12, "~m/V": 1e-6}
_EXPORT = "export the force curve as text in NanoScope Analysis, File > Export > ASCII, with Z or separation and force in units"
_BITS_OF_SCALE = 16
"""Bits of the integers to which the scales of a header refer."""


class _List(NamedTuple):
    """A list of the header: its name, keys and values."""

    name: str
    keys: dict[str, str]


def read_nanoscope(path: Path, given: Lever) -> list[AfmCurve]:
    """The force curve of a file. given : properties of the cantilever in the problem"""
    content = content_of(path)
    head, mark, _ = content.partition(_END)
    if not mark or not content.startswith(SIGNS):
        raise FileError(f"it is no file of NanoScope with a whole header: {_EXPORT}")
    lists = _lists(head.decode("latin-1"))
    known = {key: value for one in lists for key, value in one.keys.items() if key.startswith("@Sens.")}
    if "Force Volume" in (one.keys.get("Operating mode") for one in lists):
        raise FileError(f"force volumes of NanoScope are not read: {_EXPORT}")
    channels = [one.keys for one in lists if one.name == "Ciao force image list"]
    deflection = next((keys for keys in channels if "Deflection" in keys.get("@4:Image Data", "")), None)
    if deflection is None:
        raise FileError(f"it holds no force curve of a deflection: {_EXPORT}")
    sensitivity, _, _ = _scale(deflection, "@4:Z scale", known)
    constant = float(deflection.get("Spring Constant", deflection.get("Spring constant", 0.0)))
    lever = Lever(constant or None, sensitivity).replaced(*given)
    per_zoom, _, ramp_volts = _scale(deflection, "@4:Ramp Size" if "@4:Ramp Size" in deflection else "@4:Ramp size", known)
    into, out = _readings(deflection, lists, content)
    ramp = per_zoom * ramp_volts
    heights = [ramp * np.linspace(0.0, 1.0, len(half)) for half in (into, out)]
    phases = [Phase("loading", heights[0], into), Phase("unloading", ramp - heights[1], out)]
    height, volts, segments = joined([phase for phase in phases if len(phase.height)])
    what = f"NanoScope: ramp and deflection error, {len(height)} points"
    notes = (what, f"deflection sensitivity {1e9 * (lever.sensitivity or 0.0):.4g} nm/V, spring constant {constant:.4g} N/m")
    return [AfmCurve(height, lever.force_per("V") * volts, None, lever.spring_constant, None, segments, notes)]


def _lists(text: str) -> list[_List]:
    """The lists of a header."""
    found: list[_List] = []
    for line in text.splitlines():
        if line.startswith("\\*"):
            found.append(_List(line[2:].strip(), {}))
        elif found and line.startswith("\\") and ": " in line:
            key, value = line[1:].split(": ", 1)
            found[-1].keys.setdefault(key, value.strip())
    return found


def _scale(keys: Mapping[str, str], key: str, known: Mapping[str, str]) -> tuple[float, float, float]:
    """Metres per volt, volts per count, and volts of a key."""
    match = _SCALED.match(keys.get(key, ""))
    sense = _SENSITIVITY.match(known.get(f"@{match[1]}", "")) if match else None
    if match is None or sense is None or sense[2] not in _PER_VOLT:
        raise FileError(f"its header does not give {key!r} with a sensitivity: {_EXPORT}")
    return float(sense[1]) * _PER_VOLT[sense[2]], float(match[2]), float(match[3])


def _readings(keys: Mapping[str, str], lists: Sequence[_List], content: bytes) -> tuple[Array, Array]:
    """Deflections of the way in and of the way out in the order of measurement [V]."""
    counts = [int(word) for word in keys["Samps/line"].split()]
    out = next((int(one.keys["Samps/line, retrace"]) for one in lists if "Samps/line, retrace" in one.keys), counts[0])
    into = sum(counts) - out if len(counts) > 1 else counts[0]
    begin, length = int(keys["Data offset"]), int(keys["Data length"])
    # the header states 2 bytes where there are 4
    size = length // max(into + out, 1)
    if size not in (2, 4) or into < 2 or out < 0 or begin + size * (into + out) > len(content):
        raise FileError(f"its data have {length} bytes for {into} and {out} readings, or end before: {_EXPORT}")
    match = _SCALED.match(keys["@4:Z scale"])
    volts = float(match[2]) * np.frombuffer(content, f"<i{size}", into + out, begin) if match else np.zeros(0)
    if match is None or np.abs(volts).max() > float(match[2]) * 2.0 ** (_BITS_OF_SCALE - 1):
        raise FileError(f"its deflections exceed the range of the instrument: they are counted in another way; {_EXPORT}")
    # the way in is stored from contact backwards
    return volts[:into][::-1], volts[into:]
