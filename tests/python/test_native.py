# SPDX-License-Identifier: GPL-3.0-or-later
"""The compiled module that lies under the package."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from mdrcontact import _native

ROOT = Path(__file__).parents[2]


def test_types_and_structures_are_those_of_the_header(tmp_path):
    """What wrap_header.py writes for the package lies in the repository."""
    made = [tmp_path / name for name in ("_native.pyf", "_native.pyi", "_layout.py")]
    program = ROOT / "python" / "src" / "wrap_header.py"
    subprocess.run([sys.executable, program, ROOT / "include" / "mdrcontact.h", *made], check=True)
    for path in made[1:]:
        kept = ROOT / "python" / "mdrcontact" / path.name
        assert path.read_text(encoding="utf-8") == kept.read_text(encoding="utf-8"), f"{kept} is out of date: run {program.name}"


def test_entries_are_those_of_the_header(tmp_path):
    made, kept = tmp_path / "entries.c", ROOT / "src" / "mdrcontact" / "api" / "entries.c"
    program = ROOT / "tools" / "write_entries.py"
    subprocess.run([sys.executable, program, ROOT / "include" / "mdrcontact.h", made], check=True)
    assert made.read_text(encoding="utf-8") == kept.read_text(encoding="utf-8"), f"{kept} is out of date: run {program.name}"


def test_every_function_of_the_types_exists():
    text = (ROOT / "python" / "mdrcontact" / "_native.pyi").read_text(encoding="utf-8")
    names = [line.split("(")[0].removeprefix("def ") for line in text.splitlines() if line.startswith("def ")]
    assert len(names) > 80
    assert [name for name in names if not callable(getattr(_native, name, None))] == []


@pytest.mark.skipif(sys.platform != "linux" or not shutil.which("nm"), reason="lists the symbols of an ELF file by nm")
def test_only_the_init_function_is_exported():
    words = subprocess.run(["nm", "-D", "--defined-only", _native.__file__], capture_output=True, text=True, check=True).stdout
    assert [line.split()[-1] for line in words.splitlines()] == ["PyInit__native"]
