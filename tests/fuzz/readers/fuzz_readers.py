#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The fuzzer of the readers: fuzz_readers.py CORPUS [libFuzzer options]. Needs atheris and the installed package."""

import sys
from pathlib import Path

import atheris

sys.path.insert(0, str(Path(__file__).parent))
with atheris.instrument_imports(include=["mdrcontact", "tomllib", "entry"]):
    from entry import feed

atheris.Setup(sys.argv, feed)
atheris.Fuzz()
