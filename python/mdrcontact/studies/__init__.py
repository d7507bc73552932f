# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies of a contact: one function for each command, by its name, and `many` fits. They print nothing and write nothing.

A study takes a problem, as `mdrcontact.problem.read` and `load` return it, and options. One of measurements takes a problem of
`mdrcontact.instruments.load_fit_file` or `fit_file_of_text`, and data. Its `Result` has numbers, notes, warnings, tables, and what
a figure draws. What it does not support is an exception of `mdrcontact.errors`.
"""

from .adhesion import adhesion
from .calibrate import calibrate
from .compare import compare
from .conduction import conduction
from .curve import curve
from .fit import fit
from .friction import friction
from .history import history
from .imprint import imprint
from .inspect import inspect
from .law import law
from .many import many
from .map import map
from .modulus import modulus
from .result import Column, Mixed, Number, Result, Table, Words
from .stress import stress
from .validate import validate
from .wear import wear

__all__ = [
    "Column",
    "Mixed",
    "Number",
    "Result",
    "Table",
    "Words",
    "adhesion",
    "calibrate",
    "compare",
    "conduction",
    "curve",
    "fit",
    "friction",
    "history",
    "imprint",
    "inspect",
    "law",
    "many",
    "map",
    "modulus",
    "stress",
    "validate",
    "wear",
]
