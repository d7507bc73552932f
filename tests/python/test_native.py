# SPDX-License-Identifier: GPL-3.0-or-later
"""The compiled module that lies under the package."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from mdrcontact import _native

ROOT = Path(__file__).parents[2]


def test_what_follows_from_the_headers_is_up_to_date(tmp_path):
    """What tools/generate.py writes lies in the repository."""
    program = ROOT / "tools" / "generate.py"
    subprocess.run([sys.executable, program, tmp_path], check=True)
    made = [path for path in tmp_path.rglob("*") if path.is_file()]
    assert len(made) > 5
    for path in made:
        kept = ROOT / path.relative_to(tmp_path)
        assert path.read_text(encoding="utf-8") == kept.read_text(encoding="utf-8"), f"{kept} is out of date: run {program}"


def test_every_structure_that_grows_is_used_at_every_size():
    """The C test of programs with another header leaves none out."""
    headers = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "include").rglob("*.h"))
    growing = re.findall(r"typedef struct (mdr_\w+) \{\s*size_t size;", headers)
    used = re.findall(r"EVERY_SIZE\(\w+, (mdr_\w+),", (ROOT / "tests" / "c" / "test_sized.c").read_text(encoding="utf-8"))
    assert len(growing) > 10
    assert sorted(used) == sorted(growing)


def test_every_function_of_the_types_exists():
    text = (ROOT / "python" / "mdrcontact" / "_native.pyi").read_text(encoding="utf-8")
    names = [line.split("(")[0].removeprefix("def ") for line in text.splitlines() if line.startswith("def ")]
    assert len(names) > 80
    assert [name for name in names if not callable(getattr(_native, name, None))] == []


@pytest.mark.skipif(sys.platform != "linux" or not shutil.which("nm"), reason="lists the symbols of an ELF file by nm")
def test_only_the_init_function_is_exported():
    words = subprocess.run(["nm", "-D", "--defined-only", _native.__file__], capture_output=True, text=True, check=True).stdout
    assert [line.split()[-1] for line in words.splitlines()] == ["PyInit__native"]
