# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of a problem file for a fit as data, in addition to those of `mdrcontact.problem.schema`.

Examples
--------
>>> from mdrcontact.instruments import schema
>>> schema.TABLES["data"].keys_of("kind", "modulus-radius")[:4]
['kind', 'radius', 'area', 'modulus']
"""

from __future__ import annotations

from collections.abc import Mapping
from inspect import signature

from .._units import LENGTH, RATIO, SENSITIVITY, STIFFNESS, dimensions
from ..loop import RULES
from ..poroelastic import DRAINAGES
from ..problem.field import NOT_NEGATIVE, POSITIVE, Field, Range, Table
from ..problem.medium import MATERIAL
from ..problem.schema import PROBLEM, tables_of
from .files.data_keys import KNOWN
from .fitting import Instrument, fit
from .fitting.gel import NAMES as GEL_NAMES
from .fitting.problem import LOSSES
from .fitting.weighted import RULES as WEIGHT_RULES

__all__ = ["CALIBRATION", "FIT", "TABLES"]

_NUMBERS = {
    "work_of_adhesion": "work of adhesion; of force-depth",
    "depth_offset": "depth that the instrument reports at first contact",
    "force_offset": "force that the instrument reports at first contact",
    "frame_compliance": "compliance of the frame, beyond what the instrument has subtracted",
    "contact_depth_factor": "epsilon of the contact depth; of stiffness-depth and unloading",
    "stiffness_factor": "beta of the contact stiffness; of stiffnesses",
    "contact_depth_scale": "factor of the contact depth; of stiffness-depth and unloading",
    "area_factor": "true contact area divided by the assumed one; of stiffnesses and moduli",
    "cohesive_stress": "cohesive stress of finite-range adhesion, 0: JKR limit; of force-depth",
}
CANTILEVER = ("spring_constant", "deflection_sensitivity")
INSTRUMENT = Table(
    "the instrument; all keys are optional",
    (
        *(
            Field(name, meaning, dimensions(Instrument)[name], signature(Instrument).parameters[name].default)
            for name, meaning in _NUMBERS.items()
        ),
        Field("indenter", "material of the indenter, for its compliance", optional=True, table=MATERIAL),
        Field(CANTILEVER[0], "spring constant of the cantilever; of records", STIFFNESS, optional=True, range=POSITIVE),
        Field(CANTILEVER[1], "deflection per volt; of records", SENSITIVITY, optional=True),
    ),
    "docs/unloading.md",
)
FREE = Table(
    "a parameter to find, by its name; its values have the unit of the parameter",
    (
        Field("start", "where the search starts; default: the value of the file", optional=True, example='"70 GPa"'),
        Field("lower", "lower bound", optional=True, example='"1 GPa"'),
        Field("upper", "upper bound", optional=True, example='"500 GPa"'),
        Field("prior", "value that is known beforehand; goes with prior_sd", optional=True, example='"70 GPa"'),
        Field("prior_sd", "its standard deviation", optional=True, example='"5 GPa"'),
    ),
    "docs/fit.md",
    name="coating.E",
)
CALIBRATION = Table(
    "joint prior of several parameters; mdrcontact calibrate writes it",
    (
        Field("names", "names of the parameters", example='["indenter.C0", "frame_compliance"]'),
        Field("values", "their values", example='[24.5, "0.1 nm/mN"]'),
        Field("sds", "their standard deviations", example='[0.2, "0.01 nm/mN"]'),
        Field("correlation", "their correlation matrix; default: none", optional=True, example="[[1.0, 0.3], [0.3, 1.0]]"),
    ),
    "docs/fit.md",
)
"""The table [calibration] of the file of a tip, and each table [[fit.joint_prior]]."""
_DEFAULTS = {name: one.default for name, one in signature(fit).parameters.items()}
_WEIGHTED = {"contact_weight": ()}
OPTIONS = Table(
    "what a fit finds, and how",
    (
        Field(
            "free",
            f"names of the parameters to find, of a gel {', '.join(GEL_NAMES)}",
            table=FREE,
            example='["coating.E"]',
        ),
        Field("loss", "loss function of the residuals", default=_DEFAULTS["loss"], choices=tuple(LOSSES)),
        Field("loss_scale", "scale of the loss, in standard deviations", RATIO, _DEFAULTS["loss_scale"]),
        Field(
            "adhesion_rule",
            "critical elongation at the edge of an adhesive contact",
            default=_DEFAULTS["adhesion_rule"],
            choices=tuple(RULES),
        ),
        Field(
            "max_iterations",
            "largest number of iterations",
            RATIO,
            _DEFAULTS["max_iterations"],
            range=Range(1, 100_000, True, True),
            step=1,
        ),
        Field(
            "sd_is_absolute",
            "whether intervals use the given standard deviations; false: the scatter of the residuals",
            default=_DEFAULTS["sd_is_absolute"],
            is_boolean=True,
        ),
        Field(
            "contact_weight",
            "distance from the contact point within which readings count less",
            LENGTH,
            _DEFAULTS["contact_weight"],
            range=NOT_NEGATIVE,
        ),
        Field(
            "contact_weight_rule",
            "whether the weights follow the contact point during the fit",
            default=_DEFAULTS["contact_weight_rule"],
            choices=tuple(WEIGHT_RULES),
            when=_WEIGHTED,
        ),
        Field(
            "pyramid_correction",
            "whether forces on a film are those of the pyramid instead of its equivalent cone; of force-depth",
            default=_DEFAULTS["pyramid_correction"],
            is_boolean=True,
        ),
        Field("joint_prior", "joint prior of several parameters", optional=True, table=CALIBRATION, many=True),
        Field("drainage", "where the fluid of a gel may leave; required of a gel", optional=True, choices=tuple(DRAINAGES)),
    ),
    "docs/fit.md",
)
TAKEN = tuple(one.name for one in OPTIONS.fields if one.name in _DEFAULTS and one.name != "free")
"""Keys of [fit] that are arguments of `fit`."""
FIT = Table(
    "a fit",
    (
        *(PROBLEM.field(name) for name in ("title", "indenter", "medium")),
        Field("instrument", INSTRUMENT.meaning, optional=True, table=INSTRUMENT),
        Field("data", KNOWN.meaning, table=KNOWN),
        Field("fit", OPTIONS.meaning, table=OPTIONS),
        PROBLEM.field("compute")._replace(optional=True),
    ),
    "docs/problem-files.md",
)
"""The file of mdrcontact fit, modulus and calibrate. They do not read [compute], which other commands read in the same file."""
TABLES: Mapping[str, Table] = {**tables_of(FIT), "calibration": CALIBRATION}
"""Every table by its path; "calibration" is in the file of a tip."""
