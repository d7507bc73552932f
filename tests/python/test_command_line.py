# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `mdrcontact`: output, files, exit statuses, and one clear line for every fault."""

import csv
import io
import os
import re
import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import ELASTIC_MODELS, ROOT
from test_problem_files import FAULTS, GOOD

import mdrcontact as mdr
from mdrcontact.cli import main, make_parser
from mdrcontact.cli.example import examples
from mdrcontact.panels import Line
from mdrcontact.problem import load
from mdrcontact.studies.curve import homogeneous_forces

PROBLEMS = sorted((ROOT / "examples" / "problems").glob("*.toml"))
ELASTIC = [path for path in PROBLEMS if "[history]" not in path.read_text(encoding="utf-8")]


@pytest.fixture
def problem(tmp_path, monkeypatch):
    """A problem file in an otherwise empty working folder."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "problem.toml").write_text(GOOD, encoding="utf-8")
    return "problem.toml"


def _rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        head, *rows = csv.reader(file)
    return head, rows


def _png_size(path):
    data = Path(path).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", data[16:24])


def _files(folder="."):
    return sorted(os.listdir(folder))


def test_curve_prints_and_writes_what_the_library_says(problem, capsys):
    assert main(["curve", problem, "--csv", "curve.csv", "--plot", "curve.png", "--pressure-csv", "pressure.csv"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    head, rows = _rows("curve.csv")
    assert head == [
        "depth [nm]", "radius [nm]", "a/h", "force [mN]", "stiffness [kN/m]", "effective modulus [GPa]", "mean pressure [GPa]",
    ]  # fmt: skip
    found = np.array(rows, dtype=float)
    contact = mdr.Contact(mdr.Sphere(1e-5), mdr.Coated(mdr.Elastic(72e9, 0.17), 5e-7, mdr.Elastic(163e9, 0.22), "gao"))
    state = contact.at_depth(np.array([25e-9, 50e-9, 75e-9, 100e-9]))
    a = state.radius
    expected = [
        state.depth / 1e-9, a / 1e-9, a / 5e-7, state.force / 1e-3, state.stiffness / 1e3,
        contact.medium.modulus(a) / 1e9, state.force / (np.pi * a**2) / 1e9,
    ]  # fmt: skip
    assert found == pytest.approx(np.array(expected).T, rel=1e-12)
    for row in found:
        assert f"{row[3]:.5g}" in out
    assert "written: curve.csv" in out and "written: curve.png" in out
    width, height = _png_size("curve.png")
    assert width > 1000 and height > 800
    head, rows = _rows("pressure.csv")
    assert head == ["depth [nm]", "r [nm]", "pressure [GPa]"]
    last = np.array([row for row in rows if float(row[0]) > 99.9], dtype=float)
    expected = contact.at_depth(100e-9).pressure(last[:, 1] * 1e-9) / 1e9
    assert last[:, 2] == pytest.approx(expected, rel=1e-6)


def test_compare_asks_every_model(problem, capsys):
    assert main(["compare", problem, "--csv", "compare.csv", "--plot", "compare.png"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    head, rows = _rows("compare.csv")
    assert [title.split(" [")[0] for title in head[:4]] == ["model", "depth", "radius", "a/h"]
    assert {row[0] for row in rows} == {*ELASTIC_MODELS, "exact"}
    film, base = mdr.Elastic(72e9, 0.17), mdr.Elastic(163e9, 0.22)
    force = head.index("force [mN]")
    ends = []
    for model in (*ELASTIC_MODELS, "exact"):
        contact = mdr.Contact(mdr.Sphere(1e-5), mdr.Coated(film, 5e-7, base, model))
        last = [row for row in rows if row[0] == model][-1]
        ends.append(contact.at_depth(1e-7).force)
        assert float(last[force]) == pytest.approx(ends[-1] / 1e-3, rel=1e-12)
        assert model in out
    spread = next(line for line in out.splitlines() if line.startswith("spread"))
    assert spread.split()[-2:] == [f"{100 * (max(ends) / min(ends) - 1):.1f}", "%"]
    measured = out[out.index("force against exact") :].splitlines()
    gao = next(line for line in measured if line.startswith("gao "))
    assert gao.split()[-2:] == [f"{100 * (ends[0] / ends[-1] - 1):+.1f}", "%"]
    assert _png_size("compare.png")[0] > 1500


@pytest.mark.parametrize("path", ELASTIC, ids=lambda p: p.stem)
@pytest.mark.parametrize("command", ["curve", "compare"])
def test_examples_run_and_draw(path, command, tmp_path, capsys):
    plot = tmp_path / "figure.png"
    assert main([command, str(path), "--plot", str(plot)]) == 0
    assert _png_size(plot)[0] > 1000
    assert capsys.readouterr().err == ""


def test_the_homogeneous_bodies_of_a_figure_adhere_like_the_coated_one():
    problem = load(next(path for path in ELASTIC if path.stem == "afm_on_pdms"))
    names, forces = zip(*homogeneous_forces(problem, np.array([150e-9, 400e-9])), strict=True)
    assert names == ("coating", "substrate")
    modulus, edge, gamma = 2e6 / 0.75, 0.9e-6, 0.05  # JKR: d = a^2/R - sqrt(2 pi a gamma/E*), F = 4 E* a^3/(3 R) - sqrt(8 pi ...)
    depth = edge**2 / 2e-6 - np.sqrt(2 * np.pi * edge * gamma / modulus)
    force = 4 * modulus * edge**3 / 6e-6 - np.sqrt(8 * np.pi * edge**3 * modulus * gamma)
    [(_, alone), _] = homogeneous_forces(problem, np.array([depth]))
    assert alone == pytest.approx([force], rel=1e-9)
    assert forces[0][0] < 0.0


@pytest.mark.parametrize("form", ["png", "pdf", "svg"])
def test_every_form_of_figure(problem, form):
    for command in ("curve", "compare"):
        assert main([command, problem, "--plot", f"{command}.{form}"]) == 0
        assert os.path.getsize(f"{command}.{form}") > 5000


SHAPES = {
    "cone": '"cone"\ninclination = "20 deg"',
    "flat punch": '"flat-punch"\nradius = "1 um"',
    "berkovich": '"berkovich"',
}


@pytest.mark.parametrize(
    ("shape", "compute"),
    [
        ("cone", 'max_depth = "50 nm"\npoints = 5'),
        ("berkovich", 'forces = ["1 mN"]'),
        ("flat punch", 'max_force = "1 mN"\npoints = 5'),
        ("flat punch", 'depths = ["1 nm", "2 nm"]'),
    ],
)
def test_sharp_and_flat_indenters_draw_too(problem, shape, compute):
    text = GOOD.replace('"sphere"\nradius = "10 um"', SHAPES[shape]).replace('max_depth = "100 nm"\npoints = 4', compute)
    with open(problem, "w", encoding="utf-8") as file:
        file.write(text)
    assert main(["curve", problem, "--plot", "curve.png"]) == 0
    assert main(["compare", problem, "--plot", "compare.png"]) == 0


def test_a_single_state_is_seen(problem, monkeypatch):
    pytest.importorskip("matplotlib")
    drawn = []
    monkeypatch.setattr("mdrcontact.panels.matplotlib.draw", lambda figure: drawn.append(figure))
    monkeypatch.setattr("mdrcontact.panels.matplotlib.rendered", lambda drawn, form: b"")
    Path(problem).write_text(GOOD.replace('max_depth = "100 nm"\npoints = 4', 'forces = ["2 mN"]'), encoding="utf-8")
    for command in ("curve", "compare"):
        assert main([command, problem, "--plot", f"{command}.png"]) == 0
        single = [part for part in drawn.pop().panels[0].parts if isinstance(part, Line)]
        assert len(single) >= 3
        assert all(len(line.x) == 1 and line.marker in ("o", "s", "^") for line in single)


def test_existing_files_are_safe(problem, capsys):
    for name in ("curve.csv", "curve.png"):
        with open(name, "w", encoding="utf-8") as file:
            file.write("mine")
    for arguments in (["--csv", "curve.csv"], ["--plot", "curve.png"], ["--csv", "new.csv", "--plot", "curve.png"]):
        for command in ("curve", "compare"):
            assert main([command, problem, *arguments]) == 1
            out, err = capsys.readouterr()
            assert out == "" and "the file exists. Use --overwrite to replace it." in err
    assert Path("curve.csv").read_text() == "mine"
    assert _files() == ["curve.csv", "curve.png", "problem.toml"]
    assert main(["curve", problem, "--csv", "curve.csv", "--plot", "curve.png", "--overwrite"]) == 0
    assert _png_size("curve.png") and len(_rows("curve.csv")[1]) == 4
    assert _files() == ["curve.csv", "curve.png", "problem.toml"]
    assert os.stat("curve.csv").st_mode & 0o777 == 0o666 & ~_umask()


def test_what_a_command_reads_is_not_overwritten(problem, capsys, tmp_path):
    Path("link.csv").symlink_to(problem)
    Path("path.csv").write_text("depth [nm];shift [nm]\n10;0\n20;1\n")
    body = GOOD.partition("[medium]")[0] + '[medium]\ntype = "homogeneous"\nmaterial = { E = "2 GPa", nu = 0.3 }\n'
    Path("led.toml").write_text(body + '[friction]\ncoefficient = 0.3\npath = "path.csv"\n')
    before = {name: Path(name).read_bytes() for name in _files()}
    for command, file, result in (
        ("curve", problem, problem),
        ("curve", problem, "link.csv"),
        ("friction", "led.toml", "path.csv"),
    ):
        assert main([command, file, "--csv", result, "--overwrite"]) == 1
        assert f"{result}: this command reads it. Give the result another name." in capsys.readouterr().err
    assert {name: Path(name).read_bytes() for name in _files()} == before
    Path("round").symlink_to("round")
    assert main(["curve", problem, "--csv", "round", "--overwrite"]) == 1
    assert "circles of links" in capsys.readouterr().err


def test_titles_are_words_and_no_formulas(problem):
    Path(problem).write_text('title = "$\\\\frac$ of 5 $"\n' + GOOD, encoding="utf-8")
    assert main(["curve", problem, "--plot", "curve.png"]) == 0


def _umask():
    mask = os.umask(0)
    os.umask(mask)
    return mask


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--csv", "nowhere/curve.csv"], "there is no folder nowhere"),
        (["--csv", "."], "is a folder"),
        (["--plot", "curve.gif"], "must end in .png, .pdf, .svg"),
        (["--plot", "curve"], "must end in .png, .pdf, .svg"),
        (["--csv", "same.png", "--plot", "same.png"], "two results have the same file name"),
    ],
)
def test_places_where_nothing_can_be_written(problem, capsys, arguments, words):
    assert main(["curve", problem, *arguments]) == 1
    out, err = capsys.readouterr()
    assert out == "" and words in err and err.count("\n") == 1
    assert _files() == ["problem.toml"]


def test_a_failed_computation_writes_nothing(problem, capsys):
    with open(problem, "w", encoding="utf-8") as file:
        file.write(GOOD.replace("100 nm", "100 mm"))
    assert main(["curve", problem, "--csv", "curve.csv", "--plot", "curve.png"]) == 1
    out, err = capsys.readouterr()
    assert out == "" and err.startswith("mdrcontact: depth = 0.025: at radius") and err.count("\n") == 1
    assert _files() == ["problem.toml"]


@pytest.mark.parametrize("number", range(0, len(FAULTS), 5))
def test_faults_in_the_file_are_one_line_and_status_2(problem, capsys, number):
    old, new, _ = FAULTS[number]
    with open(problem, "w", encoding="utf-8") as file:
        file.write(GOOD.replace(old, new))
    assert main(["curve", problem]) == 2
    out, err = capsys.readouterr()
    assert out == "" and err.startswith("mdrcontact: problem.toml: ") and err.count("\n") == 1


def test_strengths_of_too_few_layers(problem, capsys):
    Path(problem).write_text(GOOD + '\n[strength]\nvon_mises = ["1 GPa"]\n', encoding="utf-8")
    assert main(["stress", problem]) == 2
    assert "[strength]: strengths: 'von_mises' has 1 values: give one for each of the 2 layers" in capsys.readouterr().err


def test_nothing_to_compare(problem, capsys):
    text = '[indenter]\nshape="cone"\ninclination="20 deg"\n[medium]\ntype="homogeneous"\n[medium.material]\nE="1 GPa"\nnu=0.3\n'
    with open(problem, "w", encoding="utf-8") as file:
        file.write(text + '[compute]\nmax_depth="1 um"\n')
    assert main(["compare", problem]) == 2
    assert "a Homogeneous medium has one model" in capsys.readouterr().err


def test_layered_and_graded_media_are_compared(problem, capsys):
    layer = '[[medium.layer]]\nE = "72 GPa"\nnu = 0.17\nthickness = "500 nm"'
    text = GOOD.replace('"coated"', '"layered"').replace('[medium.coating]\nE = "72 GPa"\nnu = 0.17\nthickness = "500 nm"', layer)
    with open(problem, "w", encoding="utf-8") as file:
        file.write(text)
    assert main(["compare", problem]) == 0
    out = capsys.readouterr().out
    assert "gao-series" in out and "doerner-nix" not in out


def test_the_nearly_rigid_base_is_marked(tmp_path, capsys):
    assert main(["compare", str(ROOT / "examples" / "problems" / "pdms_on_glass.toml")]) == 0
    out = capsys.readouterr().out
    assert "garcia (rigid base)" in out and "dimitriadis (rigid base)" in out and "left out" not in out
    text = (ROOT / "examples" / "problems" / "pdms_on_glass.toml").read_text(encoding="utf-8").replace('"4 um"', '"10 um"')
    (tmp_path / "deep.toml").write_text(text, encoding="utf-8")
    assert main(["compare", str(tmp_path / "deep.toml")]) == 0
    out = capsys.readouterr().out
    assert re.search(r"left out: garcia \(rigid base\): .* valid for a < h. For larger contacts use the model exact", out)


@pytest.mark.parametrize("rows", ["1", "3", "1000"])
def test_rows_of_the_table(problem, capsys, rows):
    assert main(["curve", problem, "--rows", rows]) == 0
    table = capsys.readouterr().out.split("\n\n")[1].splitlines()
    assert len(table) == 1 + min(4, int(rows))
    assert table[-1].split()[0] == "100"


@pytest.mark.parametrize("rows", ["0", "-1", "x", "1.5"])
def test_wrong_numbers_of_rows(problem, capsys, rows):
    with pytest.raises(SystemExit) as caught:
        main(["curve", problem, f"--rows={rows}"])
    assert caught.value.code == 2
    assert "must be a whole number" in capsys.readouterr().err


def test_examples_are_printed(capsys):
    assert main(["example"]) == 0
    listing = capsys.readouterr().out
    for path in PROBLEMS:
        assert path.stem in listing
        assert main(["example", path.stem]) == 0
        assert capsys.readouterr().out == path.read_text(encoding="utf-8")
    assert list(examples()) == [path.stem for path in PROBLEMS]
    assert main(["example", "sio2_on_s"]) == 2
    assert "name = 'sio2_on_s': there is no such example. Did you mean 'sio2_on_si'?" in capsys.readouterr().err


@pytest.mark.parametrize("command", sorted(make_parser()[1]))
def test_help_has_its_parts_in_order_and_names_pages_and_commands_that_exist(command):
    commands = make_parser()[1]
    text = commands[command].format_help()
    parts = ("usage:", "options:", "problem file:", "map file:", "examples:", "see also:", "exit status:")
    places = [text.find(f"\n{part}" if part != "usage:" else part) for part in parts]
    there = [place for place in places if place >= 0]
    assert there == sorted(there) and there[0] == 0 and min(places[1], *places[4:]) > 0
    assert not [page for page in re.findall(r"docs/[\w-]+\.md", text) if not (ROOT / page).exists()]
    assert {*re.findall(r"^  mdrcontact (\w+)", text, re.MULTILINE)} <= {*commands}


def test_help_teaches(capsys):
    for arguments in ([], ["curve"], ["compare"], ["example"]):
        with pytest.raises(SystemExit) as caught:
            main([*arguments, "--help"])
        assert caught.value.code == 0
        text = capsys.readouterr().out
        assert "mdrcontact example" in text and "problem.toml" in text
    with pytest.raises(SystemExit) as caught:
        main([])
    assert caught.value.code == 2


def test_the_installed_command_and_the_module(problem):
    for command in (["mdrcontact"], [sys.executable, "-m", "mdrcontact"]):
        if command == ["mdrcontact"]:
            command = [os.path.join(os.path.dirname(sys.executable), "mdrcontact")]
        done = subprocess.run([*command, "curve", problem], capture_output=True, text=True, check=True)
        assert "force [mN]" in done.stdout and done.stderr == ""
        failed = subprocess.run([*command, "curve", "none.toml"], capture_output=True, text=True, check=False)
        assert failed.returncode == 2 and failed.stdout == ""
        assert failed.stderr == "mdrcontact: none.toml: it cannot be read: No such file or directory\n"
        version = subprocess.run([*command, "--version"], capture_output=True, text=True, check=True)
        assert version.stdout == f"mdrcontact {mdr.__version__}\n"


def test_a_reader_that_goes_away_is_no_fault(problem):
    command = f"{sys.executable} -m mdrcontact curve {problem} --rows 1000 | true"
    done = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
    assert "Traceback" not in done.stderr


def test_output_to_a_full_disk(problem, tmp_path):
    limited = ["bash", "-c", 'ulimit -f 0; trap "" XFSZ; exec "$0" "$@" > screen', sys.executable, "-m", "mdrcontact"]
    for arguments in (["example"], ["curve", problem]):
        failed = subprocess.run([*limited, *arguments], cwd=tmp_path, capture_output=True, text=True, check=False)
        words = "mdrcontact: the output cannot be written: File too large. Free space or write elsewhere.\n"
        assert (failed.returncode, failed.stderr) == (1, words)


def test_plain_import_is_light():
    code = "import sys, mdrcontact; print([m for m in ('pint', 'tqdm', 'matplotlib') if m in sys.modules])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "[]\n"


def test_figures_without_matplotlib(problem, capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    assert main(["curve", problem, "--plot", "curve.png"]) == 1
    out, err = capsys.readouterr()
    assert out == "" and 'pip install "mdrcontact[plot]"' in err
    assert main(["curve", problem]) == 0


def test_what_a_rigid_indenter_would_have_cost(capsys):
    path = ROOT / "examples" / "problems" / "diamond_on_tin.toml"
    assert main(["curve", str(path)]) == 0
    out, _ = capsys.readouterr()
    film = mdr.Coated(mdr.Elastic(450e9, 0.25), 1e-6, mdr.Elastic(210e9, 0.30), "exact")
    both = mdr.Contact(mdr.Sphere(1e-5), mdr.Pair(film, mdr.Homogeneous(mdr.Elastic(1141e9, 0.07))))
    ends = np.array([1e-9, 100e-9])
    excess = 100 * (mdr.Contact(mdr.Sphere(1e-5), film).at_depth(ends).force / both.at_depth(ends).force - 1)
    assert f"{excess[0]:+.1f} % off at the first depth, {excess[1]:+.1f} % at the last." in out
    assert 20 < excess[1] < excess[0] < 40


def test_compare_takes_the_indenter_into_every_model(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["compare", str(ROOT / "examples" / "problems" / "diamond_on_tin.toml"), "--csv", "compare.csv"]) == 0
    head, rows = _rows("compare.csv")
    deepest = {row[0]: float(row[head.index("force [mN]")]) for row in rows}
    diamond = mdr.Homogeneous(mdr.Elastic(1141e9, 0.07))
    for model in ("gao", "bec", "exact"):
        film = mdr.Coated(mdr.Elastic(450e9, 0.25), 1e-6, mdr.Elastic(210e9, 0.30), model)
        force = mdr.Contact(mdr.Sphere(1e-5), mdr.Pair(film, diamond)).at_depth(100e-9).force
        assert deepest[model] == pytest.approx(force / 1e-3, rel=1e-9)


def test_progress_appears_when_it_takes_long(monkeypatch):
    from mdrcontact import _progress
    from mdrcontact.studies import curve

    class Terminal(io.StringIO):
        def isatty(self):
            return True

    problem = load(ELASTIC[0])
    for patience, shown in ((0.0, True), (60.0, False)):
        terminal = Terminal()
        monkeypatch.setattr(sys, "stderr", terminal)
        monkeypatch.setattr(_progress, "PATIENCE", patience)
        with _progress.on_terminal() as progress:
            curve(problem, progress=progress)
        assert ("states" in terminal.getvalue()) == shown


def test_too_little_memory_is_one_line(problem, capsys, monkeypatch):
    def none_left(_):
        raise MemoryError

    monkeypatch.setattr("mdrcontact.cli.curve.run", none_left)
    assert main(["curve", str(problem)]) == 1
    assert capsys.readouterr().err == "mdrcontact: there is not enough memory. Use fewer points or fewer rows of data.\n"
