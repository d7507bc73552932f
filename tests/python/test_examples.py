# SPDX-License-Identifier: GPL-3.0-or-later
"""Every example runs and draws; the table of models lists them all."""

import re
import sys
import warnings

import numpy as np
import pytest
from conftest import ELASTIC_MODELS, ROOT, run

import mdrcontact as mdr

CLIENTS = {
    "plate_fem": "skfem",
    "layered_bem": "ContactMechanics",
    "layered_tamaas": "tamaas",
    "ball_mujoco": "mujoco",
    "chain_numba": "numba",
    "column_jax": "jax",
}
SCRIPTS = sorted((ROOT / "examples" / "python").glob("*.py"))


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
    assert "python examples/problems/run.py " in (ROOT / "quickstart.sh").read_text(encoding="utf-8")
    run([sys.executable, ROOT / "examples" / "problems" / "run.py", tmp_path], tmp_path)
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


def test_the_table_of_models_lists_them_all():
    page = (ROOT / "docs" / "media.md").read_text(encoding="utf-8")
    rows = [re.findall(r"`([\w-]+)`", row) for row in re.findall(r"^\| (`[^|]*) \|[^|]*\|[^|]*\|$", page, flags=re.MULTILINE)]
    listed = sorted(name for row in rows for name in row if name != "model")
    assert listed == sorted({*mdr.Coated.models(), "exact", "dimitriadis", "garcia"})


@pytest.mark.parametrize("model", ELASTIC_MODELS)
def test_models_at_equal_shear_moduli(model):
    """Exact for one material; for other Poisson's ratios the page of media states the largest error."""
    a_over_h = np.array([0.1, 0.5, 1.0, 3.0, 10.0])

    def largest_error(nu0, nu1):
        # E = 2 G (1 + nu), G0 = G1 = 1, h = 1
        body = mdr.Coated(mdr.Elastic(2 * (1 + nu0), nu0), 1.0, mdr.Elastic(2 * (1 + nu1), nu1), model)
        return 100 * max(body.modulus(a_over_h) / body.with_model("exact").modulus(a_over_h) - 1, key=abs)

    of_one_material = pytest.approx(1.5, abs=0.05) if model == "hay-crawford" else pytest.approx(0.0, abs=1e-8)
    assert largest_error(0.3, 0.3) == of_one_material
    stated = {"gao": -2.5, "perriot-barthel": 9.5, "bec": 10.9, "mencik-exponential": 15.6}
    if model in stated:
        assert largest_error(0.2, 0.45) == pytest.approx(stated[model], abs=0.05)
