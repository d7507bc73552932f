# SPDX-License-Identifier: GPL-3.0-or-later
"""Problem files for fits and map files in which every key that is there matters, and what their readers make of them."""

from __future__ import annotations

import functools
import inspect
import io
import warnings
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

import mdrcontact as mdr
from mdrcontact.instruments.files.fit_file import load_fit_file
from mdrcontact.problem import load_map

from .cases import BASE, COATED, GEL, PRONY, Case, merged
from .commands import Answer, numbers_of
from .tables import Table, as_toml

_TIP = mdr.Sphere(51e-6)
_BODY = mdr.Coated(mdr.Elastic(9.1e9, 0.27), 2.1e-6, mdr.Elastic(3.05e9, 0.34))


@functools.cache
def readings() -> dict[str, np.ndarray]:
    """A record of approach, contact, hold, unloading and a second hold near zero force, columns in the units of the titles."""
    contact = mdr.Contact(_TIP, _BODY)
    path = np.concatenate([np.linspace(-90e-9, 160e-9, 60), np.full(8, 160e-9), np.linspace(158e-9, 41e-9, 30), np.full(9, 40e-9)])
    state = contact.at_depth(np.where(path > 1e-9, path, 1e-9))
    noise = np.random.default_rng(5).standard_normal((4, len(path)))
    force = np.where(path > 1e-9, state.force, 0.0) + 2e-7 * noise[0] + 3e-7
    depth = path + 0.02e-9 * noise[1] + 0.03e-9 * np.arange(len(path))
    columns = {
        "time [s]": 0.5 * np.arange(len(path)),
        "depth [nm]": 1e9 * depth,
        "load [mN]": 1e3 * force,
        "height [nm]": 1e9 * (depth + force / 3e4),
        "deflection [nm]": 1e9 * force / 3e4,
        "stiffness [N/m]": state.stiffness * (1.0 + 0.003 * noise[2]),
        "radius [um]": 1e6 * state.radius,
        "area [um^2]": 1e12 * np.pi * state.radius**2,
        "modulus [GPa]": 1e-9 * _BODY.modulus(state.radius) * (1.0 + 0.003 * noise[3]),
        "a/h": state.radius / 2.1e-6,
        "omega [rad/s]": np.geomspace(0.1, 30.0, len(path)),
        "storage [N/m]": 2e3 * (1.0 + 0.003 * noise[2]),
        "loss [N/m]": 3e2 * (1.0 + 0.003 * noise[3]),
        "sd [mN]": np.full(len(path), 0.0013),
        "sd [nm]": np.full(len(path), 0.13),
        "sd [N/m]": np.full(len(path), 31.0),
        "sd [GPa]": np.full(len(path), 0.031),
    }
    others = {f"other {title}": 1.02 * values for title, values in columns.items()}
    popped = columns["depth [nm]"] + 90.0 * (np.arange(len(path)) > 47)
    return {**columns, **others, "popped [nm]": popped, "deflection [V]": columns["deflection [nm]"] / 53.0}


def table(*titles: str, rows: slice = slice(None), header: bool = True) -> str:
    """Columns of the readings as a text, with further ones of their kind beside them."""
    columns = [readings()[title][rows] for title in titles]
    lines = [",".join(titles)] if header else []
    return "\n".join([*lines, *(",".join(f"{value:.9g}" for value in row) for row in zip(*columns, strict=True))]) + "\n"


def _both(*titles: str) -> tuple[str, ...]:
    return (*titles, *(f"other {title}" for title in titles))


_UP = slice(24, 60)
"""Readings in contact of the approach."""
_BODY_FILE = merged(COATED, {"compute": None})
_SOFT = merged(COATED, {"compute": None, "medium": None}, {"medium": {"type": "homogeneous", "material": PRONY}})


def _case(name: str, data: Table, text: str, *more: Table, file: str = "data.csv", free: Any = ("coating.E",)) -> Case:
    base = more[0] if more and "medium" in more[0] else _BODY_FILE
    tables = merged(base, {"data": data, "fit": {"free": [*free]}}, *more)
    return Case(name, tables, ("fit",), {file: text}, only="[dif][ani][!d]*")


TIP_FILE = """
[indenter]
shape = "area-function"
coefficients = [24.5, 190.0]
length_unit = "nm"
max_height = "1 um"
[calibration]
names = ["indenter.C0", "frame_compliance"]
values = [24.5, "0.1 nm/mN"]
sds = [0.2, "0.01 nm/mN"]
correlation = [[1.0, 0.3], [0.3, 1.0]]
"""
_JOINT = {"names": ["coating.E", "substrate.E"], "values": ["8.7 GPa", "3.3 GPa"], "sds": ["0.3 GPa", "0.2 GPa"],
          "correlation": [[1.0, 0.183], [0.183, 1.0]]}  # fmt: skip
_FREE = {"coating.E": {"start": "8.3 GPa", "lower": "1.3 GPa", "upper": "71 GPa"},
         "thickness": {"prior": "2.3 um", "prior_sd": "0.3 um"}}  # fmt: skip
_OPTIONS = {"loss": "huber", "loss_scale": 0.7, "adhesion_rule": "energy", "max_iterations": 71, "sd_is_absolute": False,
            "contact_weight": "31 nm", "contact_weight_rule": "moving"}  # fmt: skip
_INSTRUMENT = {"work_of_adhesion": "0.31 J/m^2", "cohesive_stress": "23 MPa", "depth_offset": "1.3 nm", "force_offset": "1.1 uN",
               "frame_compliance": "0.2 nm/mN", "indenter": {"E": "71 GPa", "nu": 0.21}}  # fmt: skip
_CONTACT_FACTORS = {"contact_depth_factor": 0.71, "stiffness_factor": 1.03, "contact_depth_scale": 1.05, "area_factor": 0.97}
_DEPTHS = _both("time [s]", "depth [nm]", "load [mN]", "sd [mN]")
_HEIGHTS = _both("time [s]", "height [nm]", "deflection [nm]")
_STIFFNESSES = _both("depth [nm]", "load [mN]", "stiffness [N/m]", "sd [N/m]")
_RECORD = {"depth": "depth [nm]", "force": "load [mN]"}
_TESTS = table("depth [nm]", "load [mN]", rows=_UP) + "\n" + table("depth [nm]", "load [mN]", rows=slice(30, 60))

FITS = [
    _case(
        "depths",
        {
            "kind": "force-depth", **_RECORD, "time": "time [s]", "sd": "sd [mN]", "min_depth": "-51 nm", "max_depth": "103 nm",
            "branch": "loading", "drift": "0.07 nm/s", "baseline": "offset", "contact_point": "piecewise",
        },
        table(*_DEPTHS),
        {"instrument": _INSTRUMENT, "fit": {"free": _FREE, **_OPTIONS}},
    ),
    _case("depths as they are", {"kind": "force-depth", "relative_sd": 0.013}, table("depth [nm]", "load [mN]", rows=_UP)),
    _case(
        "pyramid",
        {"kind": "force-depth"},
        table("depth [nm]", "load [mN]", rows=slice(40, 60)),
        {"indenter": {"shape": "berkovich", "radius": None}, "fit": {"pyramid_correction": True}},
        {"medium": {"coating": {"thickness": "0.41 um"}}},
    ),
    _case(
        "pop-in",
        {"kind": "force-depth", "depth": "popped [nm]", "before_pop_in": True},
        table("popped [nm]", "load [mN]", rows=_UP),
    ),
    _case(
        "heights",
        {"kind": "force-depth", "height": "height [nm]", "deflection": "deflection [nm]", "branch": "both", "baseline": "tilt",
         "contact_point": "fit"},
        table(*_HEIGHTS),
        {"instrument": {"spring_constant": "31 kN/m"}, "fit": {"contact_weight": "31 nm"}},
    ),
    _case(
        "volts",
        {"kind": "force-depth", "height": "height [nm]", "deflection": "deflection [V]"},
        table("height [nm]", "deflection [V]"),
        {"instrument": {"spring_constant": "31 kN/m", "deflection_sensitivity": "53 nm/V"}},
    ),
    _case(
        "drift of a hold",
        {"kind": "force-depth", **_RECORD, "time": "time [s]", "drift": "hold", "branch": "loading"},
        table(*_DEPTHS),
    ),
    _case(
        "unloading",
        {"kind": "unloading", **_RECORD, "upper_part": [0.31, 0.93], "elastic": True, "min_depth": "-61 nm", "max_depth": "155 nm"},
        table(*_DEPTHS),
        {"instrument": {**_CONTACT_FACTORS, "frame_compliance": "0.2 nm/mN"}},
    ),
    *(
        _case(
            kind,
            {"kind": kind, **_RECORD, "time": "time [s]", "sd": sd, "baseline": "offset", "contact_point": "piecewise"},
            table(*_both("time [s]", "depth [nm]", "load [mN]", sd), rows=slice(0, 66)),
            _SOFT,
            {"instrument": {"depth_offset": "1.3 nm", "force_offset": "1.1 uN"}},
            free=["relaxed_shear_modulus"],
        )
        for kind, sd in (("force-time", "sd [mN]"), ("depth-time", "sd [nm]"))
    ),
    _case(
        "stiffness-depth",
        {"kind": "stiffness-depth", **_RECORD, "stiffness": "stiffness [N/m]", "sd": "sd [N/m]", "branch": "loading",
         "oscillation": "1.3 nm", "elastic": False, "min_depth": "40 nm", "max_depth": "131 nm"},
        table(*_STIFFNESSES),
        {"instrument": {**_CONTACT_FACTORS, "frame_compliance": "0.2 nm/mN"}},
    ),
    _case(
        "modulus-radius",
        {"kind": "modulus-radius", "radius": "radius [um]", "modulus": "modulus [GPa]", "nu": 0.23, "sd": "sd [GPa]",
         "min_radius": "1.1 um", "max_radius": "2.3 um"},
        table(*_both("radius [um]", "modulus [GPa]", "sd [GPa]"), rows=_UP),
        {"instrument": {"area_factor": 0.97}},
    ),
    _case(
        "in thicknesses",
        {"kind": "modulus-radius", "radius_over_thickness": "a/h", "thickness": "2.3 um", "modulus": "modulus [GPa]"},
        table(*_both("a/h", "modulus [GPa]"), rows=_UP),
    ),
    _case(
        "stiffness-radius",
        {"kind": "stiffness-radius", "area": "area [um^2]", "stiffness": "stiffness [N/m]", "relative_sd": 0.013},
        table(*_both("area [um^2]", "stiffness [N/m]"), rows=_UP),
        {"instrument": {"stiffness_factor": 1.03, "area_factor": 0.97}},
    ),
    _case(
        "dynamic-stiffness",
        {"kind": "dynamic-stiffness", "omega": "omega [rad/s]", "storage": "storage [N/m]", "loss": "loss [N/m]",
         "contact_radius": "2.1 um"},
        table(*_both("omega [rad/s]", "storage [N/m]", "loss [N/m]"), rows=_UP),
        _SOFT,
        free=["relaxed_shear_modulus"],
    ),
    _case(
        "dynamic at radii",
        {"kind": "dynamic-stiffness", "radius": "radius [um]"},
        table("omega [rad/s]", "storage [N/m]", "loss [N/m]", "radius [um]", rows=_UP),
        _SOFT,
        free=["relaxed_shear_modulus"],
    ),
    _case(
        "bare columns",
        {"kind": "force-depth", "columns": ["h", "P"], "depth": "h", "force": "P", "units": {"h": "nm", "P": "mN"}, "skip": 2,
         "decimal": "."},
        table("depth [nm]", "load [mN]", rows=_UP, header=False),
    ),
    _case("one test", {"kind": "force-depth", "sheet": "test 2"}, _TESTS),
    _case("without a test", {"kind": "force-depth", "leave_out": ["test 1"]}, _TESTS),
    _case(
        "what is known",
        {"kind": "force-depth"},
        table("depth [nm]", "load [mN]", rows=_UP),
        {"fit": {"joint_prior": [_JOINT]}},
    ),
    _case(
        "gel",
        {"kind": "force-time", "relative_sd": 0.013},
        table("time [s]", "depth [nm]", "load [mN]", rows=_UP),
        merged(_SOFT, {"indenter": {"shape": "paraboloid"}, "medium": None}, {"medium": {"type": "homogeneous", "material": GEL}}),
        {"fit": {"drainage": "indenter"}},
        free=["shear_modulus", "nu", "diffusivity"],
    ),
]  # fmt: skip
CALIBRATED = Case(
    "calibrated tip",
    merged(FITS[1].tables, {"indenter": None}, {"indenter": {"file": "tip.toml"}}),
    ("fit",),
    {**FITS[1].files, "tip.toml": TIP_FILE},
)


def _labels(*shape: int) -> bytes:
    buffer = io.BytesIO()
    np.save(buffer, np.random.default_rng(3).integers(0, 2, shape))
    return buffer.getvalue()


LABELS = {"labels.npy": _labels(3, 4, 5), "other.npy": _labels(3, 5, 4)}
MAPS = [
    Case(
        "voxels",
        {
            "title": "walk",
            "structure": {
                "labels": "labels.npy",
                "spacing": ["1.1 um", "0.9 um", "1.3 um"],
                "beside": "padded",
                "exponent": 0.7,
                "phase": [BASE, {"E": "9.1 GPa", "nu": 0.27}],
            },
            "map": {"radii": ["1.1 um", "2.3 um"]},
        },
        ("map",),
    )
]


_DEFAULTS = {name: one.default for name, one in inspect.signature(mdr.instruments.fit).parameters.items()}


def answer_of_fit(file: Path) -> Answer:
    """What the reader of a problem file for a fit makes of it and of the measurements beside it."""
    found = load_fit_file(file)
    curves = found.curves(file.with_name("data.csv"))
    data = [curve.read()[0] for curve in curves]
    shown = {name: repr(getattr(found, name)) for name in ("indenter", "medium", "instrument", "cantilever", "free", "drainage")}
    kept = [
        {name: value for name, value in vars(one).items() if isinstance(value, (np.ndarray, float, bool, str, tuple))}
        for one in data
    ]
    return {
        **{name: [text] for name, text in shown.items()},
        "options": [repr({**_DEFAULTS, **found.options})],
        "data": [repr(kept)],
    }


def answer_of_map(file: Path) -> Answer:
    """What the reader of a map file makes of it."""
    found = load_map(file)
    voxels = {name: repr(value) for name, value in vars(found.voxels).items() if name != "labels"}
    return {
        "title": [found.title],
        "radii": found.radii,
        "voxels": [repr(voxels)],
        **numbers_of(np.asarray(found.voxels.labels), "labels"),
    }


ANSWERS: Mapping[str, Callable[[Path], Answer]] = {"fit": answer_of_fit, "map": answer_of_map}


def answer(command: str, file: Path) -> Answer:
    """What the reader of a command's file makes of it."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return ANSWERS[command](file)


def read_in(folder: Path, command: str, tables: Table) -> Answer:
    """The same of tables; the files that they name lie in the folder."""
    file = folder / "problem.toml"
    file.write_text(as_toml(tables), encoding="utf-8")
    return answer(command, file)
