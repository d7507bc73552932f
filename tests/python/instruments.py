# SPDX-License-Identifier: GPL-3.0-or-later
"""Small files as instruments write them, made up with known numbers in them."""

from __future__ import annotations

import io
import struct

import numpy as np
from records import indentation

NO_NUMBER = 1.7976931348623157e308
"""What NanoSuite writes where there is no number."""


def one_test(i=0, points=(60, 20, 60, 20, 10)):
    """Time, depth and force [s], [nm], [mN] of one test of a series, loading, hold, unloading, drift hold and the rest, and where
    these begin."""
    time, h, p, _ = indentation(10e-3 * (1 + i), noise=1e-6, seed=i, points=points)
    return time, 1e9 * h, 1e3 * p, np.concatenate([[0], np.cumsum(points)[:-1]])


def nanosuite(i=0):
    """Rows of a sheet of NanoSuite: titles, units, and readings with marks of the segments beside them."""
    time, h, p, begins = one_test(i)
    names = dict(zip(begins, ("Load", "Hold", "Unload From Peak", "Thermal Drift Hold"), strict=False))
    rows = [
        ["Segment", "Displacement Into Surface", "Load On Sample", "Time On Sample", "Harmonic Contact Stiffness"],
        ["", "nm", "mN", "s", "N/m"],
    ]
    for k in range(len(h)):
        stiffness = 2e3 * h[k] if 0 < k < begins[1] else NO_NUMBER
        rows.append([f"{names[k]} Segment Type" if k in names else "", h[k], p[k], time[k], stiffness])
    return [*rows, ["END", "", "", "", ""]]


def xlsx(sheets):
    """A spreadsheet of sheets by name."""
    import openpyxl

    book = openpyxl.Workbook()
    book.remove(book.active)
    for name, rows in sheets.items():
        sheet = book.create_sheet(name)
        for row in rows:
            sheet.append([None if cell == "" else cell for cell in row])
    out = io.BytesIO()
    book.save(out)
    return out.getvalue()


def xls(rows):
    """An old spreadsheet of one sheet, in the format of Excel 2."""
    out = [struct.pack("<HHHH", 9, 4, 2, 16)]
    for i, row in enumerate(rows):
        for j, cell in enumerate(row):
            if cell == "":
                continue
            if isinstance(cell, str):
                text = cell.encode("ascii")
                out.append(struct.pack("<HHHH3xB", 4, 8 + len(text), i, j, len(text)) + text)
            else:
                out.append(struct.pack("<HHHH3xd", 3, 15, i, j, float(cell)))
    return b"".join([*out, struct.pack("<HH", 10, 0)])


def series(count=3):
    """A spreadsheet of NanoSuite: results, settings and tests."""
    settings = [["Test", "Poissons Ratio", "Depth Limit"], ["", "", "nm"], *([i + 1, 0.18, 2000.0] for i in range(count))]
    results = [["Test", "Displacement", "Load", "Stiffness"], ["", "nm", "mN", "N/m"]]
    results += [[i + 1, 250.0, 10.0, 9e4] for i in range(8)]
    tests = {f"Test {i + 1:03}": nanosuite(i) for i in reversed(range(count))}
    return xlsx({"Results": results, "Required Inputs": settings, **tests})


def fischer(count=3):
    """Blocks of F, h and t without units, decimal commas."""
    lines = ["FS.hap\tName of the application", "R = 10% 8 Cycles", "1\tNumber of block"]
    lines += [f"{3900 - 10 * i},5\t44,{i}\t6,01\tHM\tx\ty" for i in range(count)]
    for i in range(count):
        time, h, p, _ = one_test(i)
        lines += ["FS.hap   26.05.2020  15:17:54", f"Block : 1   Value : {i + 1}", "EIT/(1-vs^2)\t[GPa]\t     83.7"]
        lines += ["Compliance\t[\N{MICRO SIGN}m/N]\t      1.9", "", "HIT          0.300 / 120.0  / 0.0 / 2.2", "", "F\th\tt"]
        rows = zip(p, h / 1e3, time, strict=True)
        lines += ["\t".join(f"{v:.6g}".replace(".", ",") for v in row) for row in rows]
    return "\r\n".join(lines).encode("latin-1")


def optics11(radius=27.5, stiffness=0.019):
    """A curve of a ball on a gel of an effective modulus of 156 Pa."""
    piezo = np.concatenate([np.linspace(0.0, 12e3, 240), np.linspace(12e3, 0.0, 240)[1:]])
    contact, modulus = 5e3, 156.0
    depth = np.maximum(piezo - contact, 0.0)
    for _ in range(200):
        load = 4.0 / 3.0 * modulus * np.sqrt(radius * 1e-6) * (1e-9 * depth) ** 1.5
        depth = 0.5 * (depth + np.maximum(piezo - contact - 1e9 * load / stiffness, 0.0))
    lines = ["Date\t12/05/2025\tTime\t11:20:38", "gel_01", "X-position (um)\t5314.320", "", f"k (N/m)\t{stiffness:.3f}"]
    lines += [f"Tip radius (um)\t{radius:.3f}", "Calibration factor\t2.809", "Device:\tChiaro", "Max load (\N{MICRO SIGN}N)\t0.050"]
    lines += ["E[eff] (Pa)\t156.009", "", "Time (s)\tLoad (uN)\tIndentation (nm)\tCantilever (nm)\tPiezo (nm)"]
    random = np.random.default_rng(1)
    for k in range(len(piezo)):
        force = 1e6 * load[k] + 1e-5 * random.standard_normal()
        lines.append(f"{0.001 * k:.6f}\t{force:.6f}\t{depth[k]:.6f}\t{1e3 * force / stiffness:.6f}\t{piezo[k]:.6f}")
    return "\r\n".join(lines).encode("latin-1")


def hysitron_text():
    """A text of TriboScan."""
    time, h, p, _ = one_test()
    lines = ["Mon Apr 29 10:41:06 2019", "", f"Number of Points = {len(h)}", "Depth (nm)\tLoad (\N{MICRO SIGN}N)\tTime (s)"]
    lines += [f"{x:.6f}\t{1e3 * y:.6f}\t{t:.6f}" for x, y, t in zip(h, p, time, strict=True)]
    return "\r\n".join(lines).encode("latin-1")


def hysitron_hld():
    """A .hld: settings, then three tables of which the last is the test."""
    time, h, p, _ = one_test()
    lines = ["File Version: Hysitron HighLoad FBControls 6.1 Release", "Machine Comp: 0.00663947 nm/\N{MICRO SIGN}N"]
    lines += ["Drift Rate: 0.03648 nm/s", "Tip C0: 24.5 nm^2/nm^2", "Sample Approach Data Points: 20"]
    lines += ["Time_s\tMotorDisp_mm\tPiezo Extension_nm", *(f"{0.1 * i:.3f}\t{1e-3 * i:.6f}\t{2.0 * i:.3f}" for i in range(20))]
    lines += ["Drift Measurement Data Points: 20", "Time_s\tDisp_nm", *(f"{0.1 * i:.3f}\t{0.01 * i:.6f}" for i in range(20))]
    lines += [f"Test Data Points: {len(h)}", "Time_s\tDisp_nm\tForce_\N{MICRO SIGN}N\tLoadCell_nm"]
    lines += [f"{t:.6f}\t{x:.6f}\t{1e3 * y:.6f}\t{0.5 * x:.6f}" for t, x, y in zip(time, h, p, strict=True)]
    return "\r\n".join(lines).encode("latin-1")


def side_by_side(count=3):
    """Tests of one file in columns beside each other, with the same titles; the last is shorter."""
    columns = []
    for i in range(count):
        _, h, p, _ = one_test(i, (60, 20, 60 - 10 * (i == count - 1), 20, 10))
        columns += [h, p]
    lines = ["Indentation series", "\t".join(count * ["Pd [nm]", "Fn [mN]"])]
    for k in range(max(map(len, columns))):
        lines.append("\t".join(f"{v[k]:.6f}" if k < len(v) else "" for v in columns))
    return "\n".join(lines).encode()


def bare():
    """Three columns without titles, as Micro Materials writes them."""
    time, h, p, _ = one_test()
    return "\n".join(f"{y:.6f}\t{x:.6f}\t{t:.6f}" for y, x, t in zip(p, h, time, strict=True)).encode()


def files():
    """By name."""
    return {
        "series.xlsx": series(),
        "old.xls": xls(nanosuite()),
        "blocks.txt": fischer(),
        "gel.txt": optics11(),
        "triboscan.txt": hysitron_text(),
        "high_load.hld": hysitron_hld(),
        "beside.txt": side_by_side(),
        "bare.txt": bare(),
        "nanoscope.spm": b"\\*Force file list\r\n\\Version: 0x09400000\r\n" + bytes(4096),
        "triboscan.hys": bytes(range(256)) * 20,
        "other.hdf5": b"\x89HDF\r\n\x1a\n" + bytes(4096),
    }
