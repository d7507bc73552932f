# SPDX-License-Identifier: GPL-3.0-or-later
"""Binary files of AFMs as their programs write them, made up with known numbers in them."""

from __future__ import annotations

import struct

import numpy as np

import mdrcontact as mdr

RADIUS, MODULUS, SPRING, SENSITIVITY = 2.5e-6, 1.5e6, 0.4, 60e-9
"""Of a ball on rubber, and of a cantilever."""


def curve(count=400, contact=600e-9, ramp=1200e-9):
    """Height of the piezo and deflection on the way in [m]."""
    depth = np.linspace(0.0, 400e-9, 4001)
    body = mdr.Homogeneous(mdr.Elastic(MODULUS, 0.5))
    deflection = np.zeros_like(depth)
    deflection[1:] = np.asarray(mdr.Contact(mdr.Paraboloid(RADIUS), body).at_depth(depth[1:]).force) / SPRING
    height = np.linspace(0.0, ramp, count)
    noise = 2e-11 * np.random.default_rng(3).standard_normal(count)
    return height, np.interp(height - contact, depth + deflection, deflection, left=0.0) + noise


def nanoscope(size=4, samples=(400, 400), scale="(0.0003750000 V/LSB)", mode="Force", more=b""):
    """A force curve with sensitivity, spring constant and ramp in its header; the way in lies backwards in it."""
    height, deflection = curve(samples[1])
    back = curve(samples[0])[1][::-1]
    counts = np.rint(np.concatenate([deflection[::-1], back]) / SENSITIVITY / 0.000375)
    head = f"\\*Force file list\r\n\\Version: 0x0920B046\r\n\\*Ciao scan list\r\n\\Operating mode: {mode}\r\n"
    head += "\\@Sens. Zsens: V 12.00000 nm/V\r\n\\@Sens. DeflSens: V 60.00000 nm/V\r\n\\*Ciao force list\r\n"
    head += f"\\Samps/line, retrace: {samples[0]}\r\n\\*Ciao force image list\r\n\\Data offset: 4096\r\n\\Data length: "
    head += f"{size * sum(samples)}\r\n\\Bytes/pixel: 2\r\n\\Samps/line: {samples[0]} {samples[1]}\r\n"
    head += f"\\Spring Constant: {SPRING}\r\n"
    head += '\\@4:Image Data: S [DeflectionError] "Deflection Error"\r\n'
    head += f"\\@4:Z scale: V [Sens. DeflSens] {scale} 2.500000 V\r\n"
    head += "\\@4:Ramp Size: V [Sens. Zsens] (0.006713765 V/LSB) 100.0000 V\r\n\\*File list end\r\n\x1a"
    return head.encode("latin-1").ljust(4096, b"\0") + counts.astype(f"<i{size}").tobytes() + more


def nid(unit="N", lines=2, sensor=True, bits=32, pause=False):
    """Curves of Nanosurf with pauses or not; deflections in the unit of a file that says it."""
    height, deflection = curve()
    values = {"N": SPRING * deflection, "m": deflection, "V": deflection / SENSITIVITY}[unit]
    frames = ["Spec forward", *(["Spec fwd pause"] if pause else []), "Spec backward"]
    channels = [("Deflection", unit, values), *([("Z-Axis Sensor", "m", height - 3e-6)] if sensor else [])]
    length = 10.0 * SENSITIVITY
    head = "[DataSet]\r\nVersion=2\r\n\r\n[DataSet\\Calibration\\Scanhead]\r\n"
    head += f"In0=0,Channel0,Deflection,N,{length * SPRING:.9g},0\r\nIn5=5,TipSignalDC,Deflection,m,{length:.9g},0\r\n"
    data = b""
    for i, frame in enumerate(frames):
        for j, (name, own, wanted) in enumerate(channels):
            low, span = wanted.min(), np.ptp(wanted)
            counts = np.rint((wanted - low) / span * (2.0**bits - 1.0) - 2.0 ** (bits - 1))
            counts = np.full_like(counts, counts[-1]) if "pause" in frame else counts
            head += (
                f"\r\n[DataSet-{i}:{j}]\r\nPoints={len(height)}\r\nLines={lines}\r\nFrame={frame}\r\nDim0Min=0\r\nDim0Range=1.2e-06"
            )
            head += f"\r\nDim2Name={name}\r\nDim2Unit={own}\r\nDim2Min={low:.12g}\r\nDim2Range={span:.12g}\r\nSaveBits={bits}\r\n"
            data += np.tile(counts, lines).astype(f"<i{bits // 8}").tobytes()
    return head.encode("latin-1") + b"\r\n\r\n#!" + data


def ibw(columns, labels=(), note=""):
    """A wave of Igor, version 5, of one column or of several with labels."""
    values = np.asarray(columns, dtype="<f8")
    shape = [values.shape[1], len(values)] if values.ndim == 2 else [len(values), 0]
    text = note.encode("latin-1")
    names = b"".join(label.encode().ljust(32, b"\0") for label in ("", *labels)) if labels else b""
    wave = struct.pack("<IIIihh6xh32siI4i4d4d4s16shhdd", 0, 0, 0, values.size, 4, 0, 1, b"wave", 0, 0, *shape, 0, 0,
                       *(1.0,) * 4, *(0.0,) * 4, b"m", b"", 0, 0, 0.0, 0.0)  # fmt: skip
    wave = wave.ljust(320, b"\0")
    sizes = (len(wave) + values.nbytes, 0, len(text), 0, 0, 0, 0, 0, 0, len(names), 0, 0, 0, 0, 0)
    head = struct.pack("<hh15i", 5, 0, *sizes)
    total = int(np.frombuffer(head + wave, "<i2").astype(int).sum()) & 0xFFFF
    head = struct.pack("<hh15i", 5, (-total + 0x8000) % 0x10000 - 0x8000, *sizes)
    return head + wave + values.tobytes() + text + names


def asylum():
    """Deflection and height of a curve, a wave each, with the same note."""
    height, deflection = curve()
    note = f"SpringConstant: {SPRING}\rInvOLS: {SENSITIVITY}\r"
    both = [np.concatenate([v, v[::-1]]) for v in (height, deflection)]
    return ibw(both[1], note=note), ibw(both[0], note=note), ibw(both, ("LVDT", "Defl"), note)
