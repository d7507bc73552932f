# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured data: files, parts of records, and fits with uncertainties."""

from . import fitting, records, schema
from .files.fit_file import FitFile, fit_file_of_text, load_fit_file
from .files.inspection import inspect_file
from .fitting import *  # noqa: F403
from .reading.afm import read_afm
from .records import *  # noqa: F403

__all__ = [
    *fitting.__all__,
    *records.__all__,
    "FitFile",
    "load_fit_file",
    "fit_file_of_text",
    "inspect_file",
    "read_afm",
    "schema",
]
