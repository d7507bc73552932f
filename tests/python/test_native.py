# SPDX-License-Identifier: GPL-3.0-or-later
"""The compiled module that lies under the package."""

import shutil
import subprocess
import sys

import pytest

from mdrcontact import _native


@pytest.mark.skipif(sys.platform != "linux" or not shutil.which("nm"), reason="lists the symbols of an ELF file by nm")
def test_only_the_init_function_is_exported():
    words = subprocess.run(["nm", "-D", "--defined-only", _native.__file__], capture_output=True, text=True, check=True).stdout
    assert [line.split()[-1] for line in words.splitlines()] == ["PyInit__native"]
