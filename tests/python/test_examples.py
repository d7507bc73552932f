# SPDX-License-Identifier: GPL-3.0-or-later
"""Every Python example runs and draws; every code block of README.md does what README.md says."""

import re
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest
from conftest import ELASTIC_MODELS, ROOT, run

import mdrcontact as mdr
from mdrcontact.problem import load

CLIENTS = {
    "plate_fem": "skfem",
    "layered_bem": "ContactMechanics",
    "layered_tamaas": "tamaas",
    "ball_mujoco": "mujoco",
    "chain_numba": "numba",
    "column_jax": "jax",
}
SCRIPTS = sorted((ROOT / "examples" / "python").glob("*.py"))
README = (ROOT / "README.md").read_text(encoding="utf-8")
FORCE, RADIUS = 17.11, 1097.3
"""What README.md says that its examples print [mN], [nm]."""


def _block(language):
    blocks = re.findall(rf"^```{language}\n(.*?)^```", README, flags=re.MULTILINE | re.DOTALL)
    assert len(blocks) == 1, f"README.md has {len(blocks)} blocks of {language}"
    return blocks[0]


@pytest.mark.slow
@pytest.mark.parametrize("script", SCRIPTS, ids=lambda path: path.stem)
def test_scripts(script, tmp_path):
    out = run([sys.executable, "-W", "error", script], tmp_path)
    figure = tmp_path / f"{script.stem}.png"
    assert f"written: {figure.name}" in out
    assert figure.read_bytes()[:8] == b"\x89PNG\r\n\x1a\n" and figure.stat().st_size > 20_000


@pytest.mark.slow
def test_problems(tmp_path):
    """What quickstart.sh computes: every problem by the commands that its sections are for, with tables and figures."""
    assert "examples/problems/run.sh " in (ROOT / "quickstart.sh").read_text(encoding="utf-8")
    run([ROOT / "examples/problems/run.sh", Path(sys.executable).with_name("mdrcontact"), tmp_path], tmp_path)
    written = {path.name for path in tmp_path.iterdir() if path.stat().st_size > 200}
    problems = {path.stem for path in (ROOT / "examples/problems").glob("*.toml")}
    extra = {"afm_on_pdms": "loop", "tin_on_steel": "stress friction wear"}
    for name in problems:
        endings = [""] + [f"-{end}" for end in extra.get(name, "").split()]
        assert {f"{name}{end}.{kind}" for end in endings for kind in ("png", "csv")} <= written


@pytest.mark.slow
@pytest.mark.parametrize(("script", "host"), CLIENTS.items())
def test_clients(script, host, tmp_path):
    """They check their results themselves. Where the host is missing: examples/clients/install_hosts.sh."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a host that looks for MPI
        pytest.importorskip(host)
    quiet = ["-W", "error", "-W", "ignore::ImportWarning"]
    assert "largest" in run([sys.executable, *quiet, ROOT / "examples" / "clients" / f"{script}.py"], tmp_path)


def test_ctypes(tmp_path):
    """The C library of the package without a compiler."""
    try:
        mdr.get_library()
    except mdr.errors.FileError as problem:
        pytest.skip(str(problem))
    script = ROOT / "examples" / "clients" / "law_ctypes.py"
    assert "largest relative error" in run([sys.executable, "-W", "error", script], tmp_path)


def test_readme_says_what_its_examples_print():
    assert f"F = {FORCE} mN and a = {RADIUS} nm" in README


def test_readme_python(tmp_path):
    out = run([sys.executable, "-c", _block("python")], tmp_path)
    numbers = {line.split(":")[0]: line.split(":")[1].strip(" []").split() for line in out.splitlines()}
    assert float(numbers["F [mN]"][-1]) == pytest.approx(FORCE, abs=0.005)
    assert float(numbers["a [nm]"][-1]) == pytest.approx(RADIUS, abs=0.05)


def test_readme_problem_file(tmp_path):
    (tmp_path / "problem.toml").write_text(_block("toml"), encoding="utf-8")
    problem = load(tmp_path / "problem.toml")
    assert problem.contact().at_depth(problem.control.values[-1]).force == pytest.approx(FORCE * 1e-3, rel=3e-4)


@pytest.mark.slow
def test_readme_table_of_errors():
    percents = r" ([-+]\d+) % \|" * 4
    table = re.findall(rf"^\| `([\w-]+)` \|[^|]*\|{percents}$", README, flags=re.MULTILINE)
    assert sorted(row[0] for row in table) == sorted(ELASTIC_MODELS)
    a_over_h = np.array([0.1, 0.5, 1.0, 3.0, 10.0])
    for model, *printed in table:
        for words, ratio in zip(printed, (0.1, 0.5, 2.0, 10.0), strict=True):
            errors = []
            for nu0, nu1 in ((0.2, 0.45), (0.3, 0.3), (0.5, 0.5)):
                # E = 2 G (1 + nu), G0/G1 = ratio, h = 1
                body = mdr.Coated(mdr.Elastic(2 * ratio * (1 + nu0), nu0), 1.0, mdr.Elastic(2 * (1 + nu1), nu1), model)
                errors += list(body.modulus(a_over_h) / body.with_model("exact").modulus(a_over_h) - 1)
            assert 100 * max(errors, key=abs) == pytest.approx(float(words), abs=0.501), (model, ratio)


@pytest.mark.slow
@pytest.mark.parametrize(("language", "suffix"), [("fortran", "f90"), ("c", "c")])
def test_readme_compiled_examples(installed, tmp_path, language, suffix):
    (tmp_path / f"example.{suffix}").write_text(_block(language), encoding="utf-8")
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.22)\nproject(example LANGUAGES C Fortran)\n"
        "find_package(mdrcontact REQUIRED COMPONENTS static)\n"
        f"add_executable(example example.{suffix})\ntarget_compile_options(example PRIVATE -Wall -Wextra -Werror)\n"
        f"target_link_libraries(example PRIVATE mdrcontact::{'static' if language == 'fortran' else 'shared'})\n",
        encoding="utf-8",
    )
    run(["cmake", "-S", ".", "-B", "build", f"-DCMAKE_PREFIX_PATH={installed}"], tmp_path)
    run(["cmake", "--build", "build"], tmp_path)
    out = run([tmp_path / "build" / "example"], tmp_path)
    found = re.fullmatch(r"F = +([\d.]+) mN, a = +([\d.]+) nm\n", out)
    assert found, out
    assert float(found[1]) == pytest.approx(FORCE, abs=0.005)
    assert float(found[2]) == pytest.approx(RADIUS, abs=0.05)
