# SPDX-License-Identifier: GPL-3.0-or-later
"""What the fuzzer of the readers has kept, fed to them again."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

import pytest

from mdrcontact.problem import ProblemError, load

FUZZ = Path(__file__).parents[1] / "fuzz"
CORPUS = sorted((FUZZ / "corpus" / "readers").iterdir())
HEADERS = Path(__file__).parents[2] / "include" / "mdrcontact"
NOT_FUZZED = {
    "mdr_version": "takes nothing",
    "mdr_sized": "what MDR_SIZED is in C++",
    "mdr_law_save": "writes a file; mdr_law_write has the same content",
    "mdr_law_load": "reads a file; mdr_law_read has the same content",
    "mdr_set_cancel": "c_cancel ends every kind of long call",
}


@pytest.fixture(scope="module")
def feed():
    return runpy.run_path(str(FUZZ / "readers" / "entry.py"))["feed"]


def test_every_function_of_c_is_fuzzed():
    comments = r"/\*.*?\*/"
    headers = "\n".join(path.read_text() for path in HEADERS.glob("*.h"))
    functions = set(re.findall(r"\b(mdr_\w+)\(", re.sub(comments, "", headers, flags=re.DOTALL)))
    sources = "\n".join(path.read_text() for path in [*FUZZ.glob("*/*.c"), FUZZ.parent / "c" / "calls.h"])
    called = set(re.findall(r"\bmdr_\w+", re.sub(comments + r'|"[^"\n]*"', "", sources, flags=re.DOTALL)))
    assert len(functions) > 100
    assert sorted(functions - called) == sorted(NOT_FUZZED)


def test_corpus_is_tame(feed):
    assert len(CORPUS) > 10
    for path in CORPUS:
        feed(path.read_bytes())


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[compute]\npoints = " + "1" * 5000, "not valid TOML"),
        ("a = " + "[" * 5000 + "]" * 5000, "nested too deeply"),
        ("a = [", "not valid TOML"),
    ],
)
def test_what_python_refuses_is_a_problem_error(tmp_path, text, words):
    path = tmp_path / "problem.toml"
    path.write_text(text)
    with pytest.raises(ProblemError, match=words):
        load(path)


def test_a_number_beyond_all_floats(tmp_path):
    path = tmp_path / "problem.toml"
    path.write_text(
        '[indenter]\nshape = "paraboloid"\nradius = "1 um"\n[medium]\ntype = "homogeneous"\n'
        '[medium.material]\nE = "1 GPa"\nnu = 1' + "0" * 400 + '\n[compute]\nmax_depth = "1 nm"\n'
    )
    with pytest.raises(ProblemError, match=r"nu = 1000"):
        load(path)


@pytest.mark.parametrize(
    ("depth", "words"),
    [
        ('max_depth = "1e999 nm"', "must be greater than 0 and finite"),
        ('max_depth = "1e999 nr"', "there is no unit 'nr'"),
        ('depths = ["1 nm", "1e999 nm"]', "must be finite and greater than the one before"),
    ],
)
def test_depths_beyond_all_floats(tmp_path, depth, words):
    path = tmp_path / "problem.toml"
    path.write_text(
        '[indenter]\nshape = "paraboloid"\nradius = "1 um"\n[medium]\ntype = "homogeneous"\n'
        f'[medium.material]\nE = "1 GPa"\nnu = 0.3\n[compute]\n{depth}\n'
    )
    with pytest.raises(ProblemError, match=words):
        load(path)
