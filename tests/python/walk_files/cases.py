# SPDX-License-Identifier: GPL-3.0-or-later
"""Problem files in which every key that is there matters: films three times as stiff as what is below them, contacts as wide as
films are thick, numbers that are equal to no other."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

from mdrcontact.loop import CONTROLS, RULES
from mdrcontact.medium.models import MODELS

from .tables import Table


class Case(NamedTuple):
    """A problem file, and the commands that say what it is."""

    name: str
    tables: Table
    commands: tuple[str, ...]
    files: Mapping[str, str] = MappingProxyType({})
    """what lies beside it"""
    only: str = "*"
    """which keys are changed, as in "strength:*" """


def merged(*tables: Table) -> Table:
    """Tables laid over each other, the last one on top; a key that is None is left out."""
    found: Table = {}
    for table in tables:
        for key, value in table.items():
            if value is None:
                found.pop(key, None)
            elif isinstance(value, dict) and isinstance(found.get(key), dict):
                found[key] = merged(found[key], value)
            else:
                found[key] = copy.deepcopy(value)
    return found


FILM = {"E": "9.1 GPa", "nu": 0.27, "thickness": "2.1 um"}
BASE = {"E": "3.05 GPa", "nu": 0.34}
AXIS = {"C11": "9.3 GPa", "C12": "3.1 GPa", "C13": "2.7 GPa", "C33": "6.2 GPa", "C44": "1.9 GPa"}
NAMED_AXIS = {"E_t": "9.3 GPa", "nu_t": 0.21, "E_z": "5.9 GPa", "nu_tz": 0.23, "G_z": "1.9 GPa"}
SPRINGS = {"normal": "4.1 GPa/um", "tangential": "2.3 GPa/um"}
SURFACE = {"surface_tension": "910 N/m", "surface_bending": "1.7e-9 N*m", "surface_stretching": "2.3e3 N/m"}
YIELDING = {"yield_stress": "0.53 GPa"}
INDENTED = {"hardness": "1.21 GPa"}
IMPRINT = {"radius": "2.3 um", "force": "9.9 mN", "depth": "640 nm", "residual_depth": "61 nm"}
PRESSED = {"radius": "2.3 um", "uniform": "0.31 GPa", "hertz": "0.43 GPa"}
UNLOADED = {"forces": ["1.3 mN", "5.1 mN", "8.3 mN"], "depths": None}
ONE_STEP = {"depths": ["83 nm"]}
SPHERE = {"title": "walk", "indenter": {"shape": "sphere", "radius": "51 um"}, "compute": {"depths": ["41 nm", "83 nm", "160 nm"]}}
COATED = merged(SPHERE, {"medium": {"type": "coated", "coating": FILM, "substrate": BASE}})
TWO_LAYERS = [{"E": "9.1 GPa", "nu": 0.27, "thickness": "0.9 um"}, {"E": "2.9 GPa", "nu": 0.31, "thickness": "1.2 um"}]


def under(model: str) -> Table:
    """A body under a model, with its options."""
    given: dict[str, Any] = {"alpha": 0.91, "wave_factor": 2.3, "weight_nu": 0.29, "tolerance": 3e-9, "exponent": -0.41}
    return {"model": model, **{name: given[name] for name in MODELS[model].options}}


def _of_models() -> list[Case]:
    found = []
    for name, model in MODELS.items():
        tables = merged(COATED, {"medium": under(name)})
        # all else is walked in cases without options
        only = "medium:*" if name == "exact" else "*"
        if model.needs_rigid_base:
            tables = merged(
                tables,
                {"medium": {"substrate": None}},
                {"medium": {"substrate": "rigid", "coating": {"nu": 0.5}}},
                {"compute": {"depths": ["21 nm", "43 nm", "71 nm"]}},
            )
        found.append(Case(f"coated {name}", tables, ("curve",), only=only))
        if model.layers:
            layered = {"medium": {"type": "layered", "coating": None, "layer": TWO_LAYERS}}
            found.append(Case(f"layered {name}", merged(tables, layered), ("curve",), only=only))
        if model.graded:
            graded = {"type": "graded", "z": ["0 um", "1.1 um", "2.3 um"], "E": ["9.1 GPa", "6.2 GPa", "3.05 GPa"], "nu": 0.27}
            found.append(Case(f"graded {name}", merged(SPHERE, {"medium": {**graded, **under(name)}}), ("curve",), only=only))
    return found


HEAT = {"thermal_conductivity": "31 W/(m*K)", "thermal_conductivity_along": "43 W/(m*K)", "heat_capacity": "2.3 MJ/(m^3*K)"}
HEAT_BASE = {"thermal_conductivity": "9.1 W/(m*K)", "thermal_conductivity_along": "6.3 W/(m*K)", "heat_capacity": "1.7 MJ/(m^3*K)"}
CURRENT = {"electrical_conductivity": "31 MS/m", "electrical_conductivity_along": "43 MS/m", "heat_capacity": "2.3 MJ/(m^3*K)"}
CURRENT_BASE = {"electrical_conductivity": "9.1 MS/m", "electrical_conductivity_along": "6.3 MS/m"}
PRONY = {
    "relaxed_shear_modulus": "0.71 GPa",
    "moduli": ["1.9 GPa", "0.53 GPa"],
    "times": ["0.31 s", "2.7 s"],
    "nu": 0.37,
}
BULK = merged(PRONY, {"nu": None, "bulk_modulus": "2.3 GPa"})
POWER_LAW = {"modulus": "1.3 GPa", "time": "1.1 s", "exponent": 0.17, "nu": 0.41}
GEL = {"shear_modulus": "11 kPa", "nu": 0.21, "diffusivity": "130 um^2/s"}
SEEPING = {"shear_modulus": "11 kPa", "nu": 0.21, "permeability": "110 nm^2", "viscosity": "1.3 mPa*s"}
RAMP = {"path": "ramp", "depth": "91 nm", "rise_time": "0.7 s", "hold_time": "1.9 s", "fall_time": "0.8 s", "points": 23}
STEP: Table = {"path": "step", "rise_time": None, "fall_time": None, "points": 3}
STICKY = {"work_of_adhesion": "0.31 J/m^2"}
RATE = {
    **STICKY,
    "speed": "1.3 um/s",
    "exponent": 0.43,
    "closing_work": "0.19 J/m^2",
    "closing_speed": "0.9 um/s",
    "closing_exponent": 0.61,
}
ELECTRIC = {"kind": "electrical", "film": "2e-15 ohm*m^2", "interfaces": ["5.3e-15 ohm*m^2"]}
THERMAL = {
    "kind": "thermal",
    "thermal_interfaces": ["2.3e-8 m^2*K/W"],
    "friction_coefficient": 0.23,
    "speed": "0.11 m/s",
}
ROUGH = {"roughness": "0.31 um", "slope": 0.11, "hardness": "2.9 GPa"}
SHAPES: dict[str, Table] = {
    "paraboloid": {"radius": "51 um"},
    "cone": {"inclination": "3.1 deg"},
    "flat-punch": {"radius": "2.1 um"},
    "flat-ended-cone": {"end_radius": "0.9 um", "inclination": "3.1 deg"},
    "flat-ended-paraboloid": {"end_radius": "0.9 um", "radius": "41 um"},
    "rounded-cone": {"blend_radius": "0.7 um", "inclination": "3.1 deg"},
    "berkovich": {},
    "vickers": {},
    "cube-corner": {},
    "table": {"r": ["0 um", "1.1 um", "2.3 um", "5.1 um"], "f": ["0 um", "0.011 um", "0.053 um", "0.31 um"]},
    "power-law": {"exponent": 2.3, "coefficient": 0.011, "length_unit": "um"},
    "area-function": {"coefficients": [24.5, 110.0], "length_unit": "nm", "max_height": "1.3 um", "min_height": "0.3 nm"},
}
MECHANICS = ("curve", "compare", "stress", "law")
ROUNDS = ("0.0,0", "0.01,0.4")


def _film(*keys: Table) -> Table:
    return merged(COATED, {"medium": {"coating": merged(*keys)}})


def _history(medium: Table, **history: Any) -> Table:
    return merged(SPHERE, {"compute": None, "medium": medium, "history": merged(RAMP, history)})


_PLAIN_BODY = {"type": "homogeneous", "material": BASE}
_RELAXING = {"type": "coated", "coating": {**PRONY, "thickness": "2.1 um"}, "substrate": BASE}
_PATH = "depth [nm],force [mN],shift [nm],tangential force [uN]\n31,0.2,1.1,11\n73,0.7,4.3,90\n53,0.4,-2.1,-40\n91,0.9,7.3,160\n"
_IN_TIME = (
    "time [s],later [s],depth [nm],force [mN],radius [um]\n0,0,0,0,0\n0.7,0.9,61,0.9,1.7\n1.9,2.3,83,1.3,2.0\n2.7,3.1,91,1.4,2.1\n"
)

CASES = [
    *_of_models(),
    Case(
        "homogeneous cone by its half angle",
        merged(SPHERE, {"indenter": None}, {"indenter": {"shape": "cone", "half_angle": "77.3 deg"}, "medium": _PLAIN_BODY}),
        ("curve",),
        only="indenter:*",
    ),
    *(
        Case(
            f"homogeneous {shape}",
            merged(SPHERE, {"indenter": None}, {"indenter": {"shape": shape, **keys}, "medium": _PLAIN_BODY}),
            ("curve",),
        )
        for shape, keys in SHAPES.items()
    ),
    Case("homogeneous", merged(SPHERE, {"medium": _PLAIN_BODY}), ("curve", "stress", "law")),
    Case("homogeneous axis", merged(SPHERE, {"medium": {"type": "homogeneous", "material": AXIS}}), ("curve", "stress")),
    Case("homogeneous named axis", merged(SPHERE, {"medium": {"type": "homogeneous", "material": NAMED_AXIS}}), ("curve",)),
    Case("homogeneous crystal", merged(SPHERE, {"medium": {"type": "homogeneous", "material": "ZnO"}}), ("curve",)),
    Case("homogeneous surface", merged(SPHERE, {"medium": {**_PLAIN_BODY, **SURFACE}, "compute": ONE_STEP}), ("curve",)),
    Case("coated", COATED, MECHANICS),
    Case(
        "coated crystals",
        merged(SPHERE, {"medium": {"type": "coated", "coating": {"material": "ZnO", "thickness": "2.1 um"}, "substrate": BASE}}),
        ("curve",),
    ),
    Case(
        "coated axis",
        merged(SPHERE, {"medium": {"type": "coated", "coating": {**AXIS, "thickness": "2.1 um"}, "substrate": NAMED_AXIS}}),
        ("curve",),
    ),
    Case("coated prestress", _film({"prestress": "0.21 GPa", "interface": SPRINGS}), ("curve", "law")),
    Case("coated sliding", _film({"interface": "sliding"}), ("curve",)),
    Case("coated surface", merged(COATED, {"medium": SURFACE, "compute": ONE_STEP}), ("curve",), only="medium:surface_*"),
    Case(
        "layered",
        merged(
            SPHERE,
            {
                "medium": {
                    "type": "layered",
                    "substrate": BASE,
                    "layer": [{**TWO_LAYERS[0], "interface": SPRINGS}, {**TWO_LAYERS[1], "prestress": "0.11 GPa"}],
                }
            },
        ),
        ("curve", "compare", "law"),
    ),
    Case(
        "power-law-graded",
        merged(SPHERE, {"medium": {"type": "power-law-graded", "E0": "3.1 GPa", "z0": "1.3 um", "exponent": 0.23, "nu": 0.29}}),
        ("curve", "law"),
    ),
    Case(
        "table",
        merged(
            SPHERE, {"medium": {"type": "table", "a": ["0.3 um", "1.1 um", "9 um"], "moduli": ["9.1 GPa", "5.3 GPa", "3.1 GPa"]}}
        ),
        ("curve",),
    ),
    Case(
        "graded",
        merged(
            SPHERE,
            {
                "medium": {
                    "type": "graded",
                    "z": ["0 um", "1.1 um", "2.3 um"],
                    "E": ["9.1 GPa", "6.2 GPa", "3.05 GPa"],
                    "nu": [0.27, 0.33, 0.36],
                },
                "compute": ONE_STEP,
            },
        ),
        ("curve",),
    ),
    Case("pair", merged(COATED, {"indenter": {"material": {"E": "17 GPa", "nu": 0.23}}}), ("curve", "compare", "law")),
    Case(
        "two coated",
        merged(
            COATED,
            {
                "indenter": {
                    "body": {
                        "type": "coated",
                        "coating": {"E": "17 GPa", "nu": 0.23, "thickness": "1.3 um"},
                        "substrate": {"E": "5.1 GPa", "nu": 0.31},
                    }
                }
            },
        ),
        ("curve", "compare", "law"),
    ),
    *(
        Case(f"steps by {name}", merged(SPHERE, {"medium": _PLAIN_BODY}, {"compute": None}, {"compute": steps}), ("curve",))
        for name, steps in {
            "largest depth": {"max_depth": "160 nm", "min_depth": "31 nm", "points": 5},
            "largest force": {"max_force": "1.3 mN", "min_force": "0.3 mN", "points": 5},
            "largest radius": {"max_radius": "3.1 um", "min_radius": "0.7 um", "points": 5, "spacing": "log"},
            "depths": {"depths": ["41 nm", "83 nm"]},
            "forces": {"forces": ["0.3 mN", "0.9 mN"]},
            "radii": {"radii": ["1.1 um", "2.3 um"]},
        }.items()
    ),
    Case("sticky", merged(SPHERE, {"medium": _PLAIN_BODY, "adhesion": STICKY}), ("curve", "adhesion", "law", "stress")),
    Case(
        "sticky cohesive",
        merged(SPHERE, {"medium": _PLAIN_BODY, "adhesion": {**STICKY, "cohesive_stress": "23 MPa"}}),
        ("curve", "adhesion", "law"),
    ),
    Case(
        "sticky coated",
        merged(COATED, {"adhesion": {**STICKY, "work_of_adhesion": "1.7 J/m^2", "adhesion_rule": "paper"}}),
        ("curve", "adhesion"),
    ),
    Case(
        "sticky spring",
        merged(COATED, {"adhesion": {"work_of_adhesion": "1.7 J/m^2", "control": "spring", "spring_stiffness": "2.3 kN/m"}}),
        ("adhesion",),
    ),
    Case(
        "sticky rate",
        merged(COATED, {"compute": None, "adhesion": RATE, "history": {**RAMP, "retract_to": "-0.6 um"}}),
        ("history",),
    ),
    Case(
        "sticky rate spring",
        merged(
            SPHERE,
            {
                "compute": None,
                "medium": _PLAIN_BODY,
                "adhesion": {**RATE, "spring_stiffness": "5.3 kN/m"},
                "history": {**RAMP, "retract_to": "-0.6 um"},
            },
        ),
        ("history",),
    ),
    Case(
        "strength of layers",
        merged(
            COATED,
            {"compute": {"depths": ["41 nm"]}, "strength": {"von_mises": ["0.11 GPa", "none"], "tension": ["23 MPa", "none"]}},
        ),
        ("stress",),
        only="strength:*",
    ),
    Case(
        "strength of interfaces",
        merged(
            COATED,
            {"compute": {"depths": ["41 nm"]}, "strength": {"interface_shear": ["11 MPa"], "interface_tension": ["1.1 MPa"]}},
        ),
        ("stress",),
        only="strength:*",
    ),
    Case(
        "rubbed by shifts", merged(COATED, {"friction": {"coefficient": 0.31, "shifts": ["1.1 nm", "4.3 nm"]}}), ("friction", "law")
    ),
    Case(
        "rubbed by forces",
        merged(COATED, {"friction": {"coefficient": 0.31, "tangential_forces": ["31 uN", "90 uN"]}}),
        ("friction",),
    ),
    Case(
        "rubbed path",
        merged(
            SPHERE,
            {
                "compute": None,
                "medium": _PLAIN_BODY,
                "friction": {"coefficient": 0.31, "path": "path.csv", "normal": "depth", "tangential": "shift"},
            },
        ),
        ("friction",),
        {"path.csv": _PATH, "other.csv": _PATH.replace("4.3", "5.1")},
    ),
    Case(
        "rubbed path coated",
        merged(
            COATED,
            {
                "compute": None,
                "friction": {"coefficient": 0.31, "path": "path.csv", "normal": "force", "tangential": "shift", "rings": 20},
            },
        ),
        ("friction",),
        {"path.csv": _PATH, "other.csv": _PATH.replace("4.3", "5.1")},
    ),
    *(
        Case(
            f"worn {name}",
            merged(
                COATED,
                {"compute": None},
                {
                    "compute": steps,
                    "wear": {"coefficient": "1.1e-6 mm^3/(N*m)", "sliding": ["0.011 m", "0.053 m"], "intervals": 16, **more},
                },
            ),
            ("wear",),
        )
        for name, steps, more in (
            ("at depth", {"max_depth": "91 nm", "points": 2}, {"scheme": "disc"}),
            ("at force", {"max_force": "1.3 mN", "points": 2}, {"scheme": "rings"}),
            ("at radius", {"max_radius": "2.1 um", "points": 2}, {}),
        )
    ),
    *(
        Case(
            f"imprint {name}",
            merged(COATED, {"medium": {"coating": film, "substrate": base}, **more}),
            ("imprint",),
        )
        for name, film, base, more in (
            ("measured", YIELDING, {"yield_stress": "0.61 GPa"}, {"imprint": IMPRINT, "compute": UNLOADED}),
            ("by its pressure", YIELDING, {"yield_stress": "0.61 GPa"}, {"imprint": PRESSED, "compute": None}),
            ("of hardness", {"hardness": "0.91 GPa", "radius_ratio": 0.26}, INDENTED, {"imprint": PRESSED, "compute": None}),
        )
    ),
    Case("electric", merged(_film(CURRENT), {"medium": {"substrate": CURRENT_BASE}, "conduction": ELECTRIC}), ("conduction",)),
    Case(
        "thermal",
        merged(
            _film(HEAT),
            {
                "medium": {"substrate": HEAT_BASE},
                "indenter": {
                    "material": {
                        "E": "17 GPa",
                        "nu": 0.23,
                        "thermal_conductivity": "13 W/(m*K)",
                        "thermal_conductivity_along": "17 W/(m*K)",
                        "heat_capacity": "1.3 MJ/(m^3*K)",
                    }
                },
                "conduction": THERMAL,
            },
        ),
        ("conduction",),
    ),
    Case(
        "thermal film",
        merged(
            _film(HEAT), {"medium": {"substrate": HEAT_BASE}, "conduction": {"kind": "thermal", "thermal_film": "3.1e-8 m^2*K/W"}}
        ),
        ("conduction",),
    ),
    *(
        Case(
            f"{kind} rough",
            merged(_film(of_film), {"medium": {"substrate": of_base}, "conduction": {"kind": kind, "joint": joint}}),
            ("conduction",),
            only="conduction*",
        )
        for kind, of_film, of_base, joint in (
            ("electrical", CURRENT, CURRENT_BASE, ROUGH),
            ("thermal", HEAT, HEAT_BASE, {**ROUGH, "gas": "0.9 W/(m*K)", "jump": "0.13 um"}),
        )
    ),
    Case("thermal alone", merged(_film(HEAT), {"medium": {"substrate": HEAT_BASE}, "conduction": THERMAL}), ("conduction",)),
    Case("relaxing bulk", _history({"type": "homogeneous", "material": BULK}), ("history",)),
    Case(
        "relaxing interface",
        _history(merged(_RELAXING, {"coating": {"interface": SPRINGS}}), **STEP),
        ("history",),
        only="medium.*",
    ),
    Case(
        "relaxing dashpot",
        merged(
            _history({"type": "homogeneous", "material": {**PRONY, "viscosity": "31 MPa*s"}}),
            {"indenter": {"shape": "flat-punch", "radius": "2.1 um"}},
        ),
        ("history",),
    ),
    Case("relaxing power law", _history({"type": "homogeneous", "material": POWER_LAW}), ("history",)),
    Case(
        "relaxing sticky",
        merged(
            _history({"type": "homogeneous", "material": PRONY}, hold_time=None, retract_to="-0.3 um", fall_time="5.3 s", points=7),
            {"adhesion": {**STICKY, "cohesive_stress": "31 MPa"}},
        ),
        ("history",),
        only="adhesion:*",
    ),
    *(
        Case(
            f"path {name}",
            merged(SPHERE, {"compute": None, "medium": {"type": "homogeneous", "material": PRONY}, "history": keys}),
            ("history",),
            {"path.csv": _IN_TIME, "other.csv": _IN_TIME.replace("0.9,1.7", "0.8,1.7")},
        )
        for name, keys in {
            "step": {"path": "step", "radius": "2.1 um", "hold_time": "1.9 s", "points": 7},
            "triangle": {"path": "triangle", "force": "1.3 mN", "duration": "1.9 s", "points": 20},
            "sine": {"path": "sine", "depth": "91 nm", "duration": "1.9 s", "points": 7},
            "file": {"path": "file", "file": "path.csv", "time": "later [s]", "control": "force"},
        }.items()
    ),
    *(
        Case(
            f"gel {name}",
            merged(
                SPHERE,
                {
                    "compute": None,
                    "indenter": {"shape": "paraboloid"},
                    "medium": {"type": "homogeneous", "material": material},
                    "history": {"path": "step", "radius": "5.3 um", "hold_time": "0.21 s", "points": 5, "drainage": drainage},
                },
            ),
            ("history",),
        )
        for name, material, drainage in (("diffusing", GEL, "indenter"), ("seeping", SEEPING, "surface"))
    ),
]

COLUMNS = {
    "depth": "depth [nm]",
    "force": "load [mN]",
    "stiffness": "stiffness [N/m]",
    "radius": "radius [um]",
    "area": "area [um^2]",
    "modulus": "modulus [GPa]",
    "height": "height [nm]",
    "deflection": "deflection [nm]",
    "time": "time [s]",
    "omega": "omega [rad/s]",
    "storage": "storage [N/m]",
    "loss": "loss [N/m]",
    "radius_over_thickness": "a/h",
}
"""By key of [data]: the title of its column in the tables of measurements."""
SAMPLES: dict[tuple[str, str], list[Any]] = {
    ("the file", "title"): ["another"],
    ("the file", "adhesion"): [{"work_of_adhesion": "5.3 J/m^2"}],
    ("the file", "compute"): [{"depths": ["31 nm"]}],
    ("the file", "strength"): [{"von_mises": ["0.31 GPa", "0.11 GPa"]}],
    ("the file", "friction"): [{"coefficient": 0.31}],
    ("the file", "history"): [{"path": "step", "depth": "90 nm", "hold_time": "2.1 s", "points": 7}],
    ("the file", "wear"): [{"coefficient": "1e-6 mm^3/(N*m)", "sliding": ["1 m"]}],
    ("the file", "conduction"): [{"kind": "thermal"}],
    ("the file", "imprint"): [IMPRINT],
    ("indenter", "exponent"): [2.3],
    ("indenter", "coefficient"): [1.2],
    ("indenter", "coefficients"): [[24.5, 110.0]],
    ("indenter", "length_unit"): ["nm"],
    ("indenter", "r"): [["0 um", "1 um", "2 um"]],
    ("indenter", "f"): [["0 um", "1 um", "2 um"]],
    ("indenter", "material"): [BASE],
    ("indenter", "body"): [{"type": "homogeneous", "material": BASE}],
    ("compute", "points"): [7],
    ("compute", "spacing"): ["linear", "log"],
    ("*", "moduli"): [["1.1 GPa"]],
    ("*", "times"): [["1.3 s"]],
    ("*", "z"): [["0 um", "1 um"]],
    ("*", "a"): [["0 um", "1 um"]],
    ("*", "cohesive_stress"): ["23 MPa"],
    ("*", "E"): ["7.3 GPa"],
    ("*", "hardness"): ["1.7 GPa"],
    ("*", "radius_ratio"): [0.27],
    ("*", "nu"): [0.22],
    ("*", "nu_t"): [0.22],
    ("*", "nu_tz"): [0.22],
    ("*", "exponent"): [0.13],
    ("*", "interface"): ["sliding", SPRINGS],
    ("*", "material"): ["ZnO"],
    ("medium", "material"): ["ZnO", BASE],
    ("*", "coating"): [FILM],
    ("*", "layer"): [[FILM]],
    ("*", "substrate"): ["rigid", "smooth", "ZnO", BASE],
    ("medium", "model"): list(MODELS),
    ("indenter.body", "model"): list(MODELS),
    ("*", "alpha"): [0.7],
    ("*", "wave_factor"): [2.0],
    ("*", "weight_nu"): [0.4, "surface", "substrate", "effective"],
    ("*", "tolerance"): [1e-4],
    ("adhesion", "adhesion_rule"): list(RULES),
    ("adhesion", "control"): list(CONTROLS),
    ("adhesion", "exponent"): [0.43],
    ("adhesion", "closing_exponent"): [0.43],
    ("adhesion", "spring_stiffness"): ["2.3 kN/m"],
    ("friction", "coefficient"): [0.2],
    ("friction", "path"): ["path.csv"],
    ("friction", "normal"): ["depth", "force"],
    ("friction", "tangential"): ["shift", "tangential_force"],
    ("friction", "rings"): [24],
    ("friction", "shifts"): [["1.1 nm", "4.3 nm"]],
    ("friction", "tangential_forces"): [["31 uN", "90 uN"]],
    ("wear", "scheme"): ["rings"],
    ("wear", "intervals"): [20],
    ("conduction", "friction_coefficient"): [0.23],
    ("conduction", "joint"): [ROUGH],
    ("history", "points"): [9],
    ("history", "file"): ["path.csv"],
    ("history", "time"): ["later [s]", "time [s]"],
    ("history", "control"): ["depth", "force", "radius"],
    ("history", "drainage"): ["indenter", "surface", "sealed"],
    ("*", "interfaces"): [["5.3e-15 ohm*m^2"]],
    ("*", "thermal_interfaces"): [["2.3e-8 m^2*K/W"]],
    ("strength", "von_mises"): [["0.31 GPa", "none"]],
    ("strength", "tension"): [["0.11 GPa", "none"]],
    ("strength", "interface_shear"): [["71 MPa"]],
    ("strength", "interface_tension"): [["11 MPa"]],
    ("the file", "instrument"): [{"frame_compliance": "0.3 nm/mN"}],
    **{("data", role): [title] for role, title in COLUMNS.items()},
    ("data", "columns"): [["depth [nm]", "load [mN]"]],
    ("data", "units"): [{"depth": "nm"}],
    ("data", "skip"): [1],
    ("data", "sheet"): ["test 1"],
    ("data", "leave_out"): [["test 1"]],
    ("data", "decimal"): [",", "."],
    ("data", "sd"): ["sd [mN]"],
    ("data", "relative_sd"): [0.02],
    ("data", "branch"): ["unloading", "loading"],
    ("data", "baseline"): ["none", "tilt"],
    ("data", "contact_point"): ["given", "piecewise"],
    ("data", "before_pop_in"): [True],
    ("data", "upper_part"): [[0.35, 0.91]],
    ("data", "elastic"): [False, True],
    ("instrument", "indenter"): [{"E": "1070 GPa", "nu": 0.07}],
    **{("instrument", f"{name}_factor"): [1.11] for name in ("contact_depth", "stiffness", "area")},
    ("instrument", "contact_depth_scale"): [1.11],
    ("fit", "loss"): ["huber", "cauchy"],
    ("fit", "loss_scale"): [0.9],
    ("fit", "adhesion_rule"): ["energy"],
    ("fit", "max_iterations"): [31],
    ("fit", "sd_is_absolute"): [False],
    ("fit", "pyramid_correction"): [True],
    ("fit", "contact_weight_rule"): ["moving"],
    ("fit", "joint_prior"): [[{"names": ["coating.nu"], "values": [0.3], "sds": [0.01]}]],
    ("fit", "drainage"): ["surface"],
    ("fit.joint_prior", "correlation"): [[[1.0, 0.2], [0.2, 1.0]]],
    ("structure", "beside"): ["padded"],
    ("structure", "exponent"): [-0.3],
}
"""By table, "*" for any, and key: what stands there where it was absent; quantities without a line are the example of messages."""

OTHERS: dict[tuple[str, str], list[Any]] = {
    ("the file", "title"): ["another"],
    ("strength", "tension"): [["27 MPa", "none"]],
    ("strength", "von_mises"): [["0.12 GPa", "none"], ["0.11 GPa", "0.06 GPa"]],
    ("friction", "path"): ["other.csv"],
    ("history", "file"): ["other.csv"],
    ("history", "time"): ["time [s]"],
    ("wear", "intervals"): [20],
    ("medium", "weight_nu"): [0.319, "surface", "substrate", "effective"],
    ("medium", "substrate"): ["smooth", "ZnO"],
    ("indenter", "length_unit"): ["mm"],
    ("indenter", "file"): ["other.toml"],
    **{("data", role): [f"other {title}"] for role, title in COLUMNS.items()},
    ("data", "columns"): [["P", "h"]],
    ("data", "units"): [{"h": "um", "P": "mN"}, {"h": "nm", "P": "N"}],
    ("data", "sheet"): ["test 1"],
    ("data", "leave_out"): [["test 2"]],
    ("data", "decimal"): [","],
    ("data", "sd"): ["other sd [mN]"],
    ("data", "branch"): ["unloading", "both"],
    ("data", "drift"): ["0.03 nm/s", "hold"],
    ("data", "baseline"): ["tilt", "none"],
    ("data", "contact_point"): ["given", "ratio-of-variances"],
    ("fit", "free"): [["coating.nu"]],
    ("fit.joint_prior", "names"): [["coating.E", "coating.nu"]],
    ("structure", "labels"): ["other.npy"],
}
"""By table and key: what else can stand there."""
