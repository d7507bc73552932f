# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies give from Python what their commands print and write, print and write nothing, and commands hold nothing else."""

import ast
import contextlib
import csv
import doctest
import inspect
import io
import json
import shutil
import sys
import threading
import time
import warnings

import numpy as np
import pytest
from conftest import ROOT

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact import problem, studies
from mdrcontact.cli import COMMANDS, main
from mdrcontact.cli import many as cli_many
from mdrcontact.cli.table import as_text
from mdrcontact.instruments import load_fit_file
from mdrcontact.problem import ProblemError
from mdrcontact.progress import Progress
from mdrcontact.studies.result import Column, Mixed, Words

PACKAGE = ROOT / "python" / "mdrcontact"
EXAMPLES = ROOT / "examples" / "problems"
FITS = ROOT / "examples" / "fit"
STUDIES = {name: value for name in studies.__all__ if inspect.isfunction(value := getattr(studies, name))}
MOST_LINES = 60
MEASURED = {
    "inspect": ("sphere_on_oxide.csv", {}),
    "fit": ("sphere_on_oxide.csv", {}),
    "many": ("sphere_on_oxide.csv", {}),
    "modulus": ("csm_on_oxide.csv", {}),
    "calibrate": ("csm_on_silica.csv", {}),
    "map": ("labels.npy", {"threads": 1}),
}
"""By study of measurements and structures: its data, and options."""

CASES = {
    "curve": ("sio2_on_si", "states", {}),
    "compare": ("tin_on_steel", "states", {}),
    "adhesion": ("afm_on_pdms", "loop", {}),
    "stress": ("diamond_on_tin", "grid", {"maps": True}),
    "friction": ("tin_on_steel", "states", {}),
    "wear": ("tin_on_steel", "states", {}),
    "conduction": ("tin_on_copper", "states", {}),
    "history": ("afm_on_gel", "path", {}),
    "imprint": ("aluminium_on_silicon", "states", {}),
}
"""By command: an example, the table that --csv writes, and options that make it."""
BODY = {
    "indenter": {"shape": "paraboloid", "radius": "10 um"},
    "medium": {"type": "homogeneous", "material": {"E": "72 GPa", "nu": 0.3}},
    "compute": {"max_depth": "50 nm"},
}


def computed(name, tmp_path, monkeypatch, capfd, **options):
    """A study's result for its example; nothing is printed, nothing written."""
    monkeypatch.chdir(tmp_path)
    given = problem.load(EXAMPLES / f"{CASES[name][0]}.toml")
    capfd.readouterr()
    found = STUDIES[name](given, **options)
    assert capfd.readouterr() == ("", "") and not [*tmp_path.iterdir()]
    return found


def assert_written(columns, path):
    """A CSV file holds this table, all digits."""
    with open(path, newline="", encoding="utf-8") as file:
        head, *rows = csv.reader(file)
    assert head == [column.title for column in columns] and rows
    for column, cells in zip(columns, zip(*rows, strict=True), strict=True):
        if isinstance(column, Words):
            assert [*column.values] == [*cells]
            continue
        values = np.asarray(column.unit.of(column.values))
        assert len(cells) == len(values) and all(cells[i] == words for i, words in column.instead.items())
        numbers = [i for i in range(len(cells)) if i not in column.instead]
        assert np.array_equal([float(cells[i]) for i in numbers], values[numbers], equal_nan=True)


def measured(name, folder, **options):
    """A study of measurements on its data, and what is read for it."""
    file, given = MEASURED[name]
    options = {**given, **options}
    if name == "inspect":
        return studies.inspect(FITS / file, **options)
    if name == "map":
        return studies.map(problem.load_map(map_file(folder)), **options)
    fit_file = load_fit_file(FITS / f"{file.partition('.')[0]}.toml")
    if name == "many":
        return studies.many(fit_file, 2 * fit_file.curves(FITS / file), **options)
    data, _ = fit_file.read_data(FITS / file)
    return STUDIES[name](fit_file, [(file, data)] if name == "calibrate" else data, **options)


def map_file(folder):
    """A map file beside its labels."""
    np.save(folder / "labels.npy", np.random.default_rng(3).integers(0, 2, (4, 10, 12)))
    phases = "".join(f'[[structure.phase]]\nE = "{E} GPa"\nnu = 0.3\n' for E in (3, 70))
    text = f'title = "Two phases"\n[structure]\nlabels = "labels.npy"\nspacing = ["1 um", "1 um", "1 um"]\n{phases}'
    (folder / "map.toml").write_text(f'{text}[map]\nradii = ["1 um", "3 um"]\n', encoding="utf-8")
    return folder / "map.toml"


@pytest.mark.parametrize("name", CASES)
def test_a_study_gives_the_numbers_that_its_command_writes_and_prints(name, tmp_path, monkeypatch, capfd):
    example, table, options = CASES[name]
    found = computed(name, tmp_path, monkeypatch, capfd, **options)
    assert main([name, str(EXAMPLES / f"{example}.toml"), "--csv", "found.csv"]) == 0
    printed = capfd.readouterr().out
    assert_written(found.tables[table], "found.csv")
    assert printed.startswith(f"{found.title}\n\n")
    for about, note in found.notes.items():
        assert (f"{about}: {note}" if about.startswith("left out") else note) in printed
    assert found.numbers and all(np.isfinite(number.value) for number in found.numbers.values())


def test_a_law_is_the_file_that_its_command_writes(tmp_path, monkeypatch, capfd):
    given = problem.load(EXAMPLES / "tin_on_steel.toml")
    monkeypatch.chdir(tmp_path)
    capfd.readouterr()
    found = studies.law(given, largest_depth=200e-9, tolerance=1e-6, continue_beyond=True)
    assert capfd.readouterr() == ("", "") and not [*tmp_path.iterdir()]
    options = ["--largest-depth", "200 nm", "--tolerance", "1e-6", "--continue-beyond"]
    assert main(["law", str(EXAMPLES / "tin_on_steel.toml"), "found.law", *options]) == 0
    printed = capfd.readouterr().out
    assert (tmp_path / "found.law").read_bytes() == found.law.to_bytes()
    assert all(f"{name:<16}{note}\n" in printed for name, note in found.notes.items())
    assert set(found.notes) == {"depth", "force", "error", "sliders"}


def test_comparisons_are_those_that_the_command_prints(tmp_path, monkeypatch, capfd):
    monkeypatch.chdir(tmp_path)
    found = studies.validate(only="hertz")
    assert capfd.readouterr() == ("", "") and not [*tmp_path.iterdir()] and found.beyond == ()
    assert main(["validate", "--only", "hertz"]) == 0
    printed = capfd.readouterr().out
    assert all(cell in printed for column in found.tables["comparisons"] for cell in (column.title, *column.values))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="did you mean 'hertz'"):
        studies.validate(only="herz")


@pytest.mark.parametrize(
    ("file", "options"),
    [
        ("sphere_on_oxide.csv", {"compare": True}),
        ("punches_on_rubber.csv", {"interval": "profile"}),
        ("indent_on_oxide.txt", {}),
        ("punch_on_hydrogel.csv", {}),
    ],
)
def test_a_fit_is_what_its_command_writes(file, options, tmp_path, monkeypatch, capfd):
    """Of a film, of unloading curves after Oliver and Pharr, and of a gel."""
    monkeypatch.chdir(tmp_path)
    path = FITS / file
    fit_file = load_fit_file(path.with_suffix(".toml"))
    found = studies.fit(fit_file, fit_file.read_data(path)[0], **options)
    assert capfd.readouterr() == ("", "") and not [*tmp_path.iterdir()] and found.refusal is None
    words = [f"--{name}" if value is True else f"--{name}={value}" for name, value in options.items()]
    written = ["--csv", "found.csv", "--json", "found.json"]
    assert main(["fit", str(path), "--problem", str(path.with_suffix(".toml")), *written, *words]) == 0
    printed = capfd.readouterr().out
    assert_written(found.tables["points"], "found.csv")
    kept = json.loads((tmp_path / "found.json").read_text())
    assert kept.pop("file", str(path)) == str(path) and kept == json.loads(json.dumps(found.to_dict()))
    assert {"fit", *(["models"] if "compare" in options else [])} == set(found.notes)
    assert ("interval (profile)" in found.notes["fit"]) == ("interval" in options), "in the table"
    assert all(note in printed for note in found.notes.values())
    assert (found.analysis is not None) == ("hardness [GPa]" in printed)
    values = {name: entry["value"] for name, entry in kept["parameters"].items()}
    assert {name: found.numbers[name].value for name in values} == values


def test_simulated_intervals_come_from_one_simulation(monkeypatch):
    """Those of each parameter alone, with its seed, are bitwise the same."""
    table = 'shape = "paraboloid"\nradius = "10 um"\n[medium]\ntype = "homogeneous"\nmaterial = { E = "50 GPa", nu = 0.17 }'
    problem = mdi.fit_file_of_text(f'[indenter]\n{table}\n[data]\nkind = "force-depth"\n[fit]\nfree = ["E", "depth_offset"]')
    depth = np.linspace(10e-9, 100e-9, 12)
    force = mdr.Contact(mdr.Paraboloid(1e-5), mdr.Homogeneous(mdr.Elastic(72e9, 0.17))).at_depth(depth).force
    data = mdi.ForceDepth(depth, force + 1e-6 * np.random.default_rng(2).standard_normal(12))
    calls, simulate = [], mdi.FitResult.simulate
    monkeypatch.setattr(mdi.FitResult, "simulate", lambda *given: calls.append(given) or simulate(*given))
    found = studies.fit(problem, data, interval="monte-carlo")
    assert [given[1:] for given in calls] == [(200, 0)]
    assert found.intervals == {name: found.fit.interval(name, method="monte-carlo", seed=0) for name in ("E", "depth_offset")}
    with pytest.raises(mdr.errors.InvalidArgumentError, match="level = 1.0"):
        found.fit.simulated_intervals(1.0)


def test_what_is_refused_after_a_fit_leaves_the_fit(tmp_path, capfd):
    """A half-space has one model."""
    text = (FITS / "sphere_on_oxide.toml").read_text()
    head, tail = text.partition("[medium]")[0], text.partition("[data]")[2].partition("[fit.free]")[0]
    body = '[medium]\ntype = "homogeneous"\nmaterial = { E = "100 GPa", nu = 0.2 }\n'
    (tmp_path / "fit.toml").write_text(f'{head}{body}[data]{tail}[fit]\nfree = ["E", "depth_offset"]\n')
    fit_file, data = load_fit_file(tmp_path / "fit.toml"), FITS / "sphere_on_oxide.csv"
    found = studies.fit(fit_file, fit_file.read_data(data)[0], compare=True, moves=True)
    assert "only coated and layered media" in str(found.refusal) and set(found.notes) == {"fit", "moves"}
    given = [str(data), "--problem", str(tmp_path / "fit.toml"), "--compare", "--json", str(tmp_path / "found.json")]
    assert main(["fit", *given]) == 1
    printed, said = capfd.readouterr()
    assert found.notes["fit"] in printed and str(found.refusal) in said and not (tmp_path / "found.json").exists()


@pytest.mark.parametrize("options", [{"moves": True}, {"interval": "profile"}])
def test_a_gel_has_no_other_intervals(options):
    fit_file = load_fit_file(FITS / "punch_on_hydrogel.toml")
    data, _ = fit_file.read_data(FITS / "punch_on_hydrogel.csv")
    with pytest.raises(mdr.errors.InvalidArgumentError, match="a gel"):
        studies.fit(fit_file, data, **options)


def test_fits_of_a_folder_are_what_the_command_writes(tmp_path, monkeypatch, capfd):
    """One curve is a copy of another, one cannot be read."""
    (tmp_path / "curves").mkdir()
    monkeypatch.chdir(tmp_path)
    for name in ("a.csv", "b.csv"):
        shutil.copy(FITS / "sphere_on_oxide.csv", tmp_path / "curves" / name)
    (tmp_path / "curves" / "words.csv").write_text("depth [nm],load [mN]\n1,x\n2,y\n3,z\n4,w\n")
    fit_file = load_fit_file(FITS / "sphere_on_oxide.toml")
    steps = []
    progress = Progress(lambda *step: steps.append(step))
    curves = fit_file.all_curves(sorted((tmp_path / "curves").iterdir()), progress)
    assert [curve.name for curve in curves] == ["a.csv", "b.csv", "words.csv"] and steps[-1] == (3, 3, "files")
    found = studies.many(fit_file, curves)
    assert capfd.readouterr() == ("", "")
    written = ["--csv", "found.csv", "--json", "found.json"]
    assert main(["fit", str(tmp_path / "curves"), "--problem", str(FITS / "sphere_on_oxide.toml"), *written]) == 0
    printed = capfd.readouterr().out
    assert_written(found.tables["estimates"], "found.csv")
    assert json.loads((tmp_path / "found.json").read_text()) == json.loads(json.dumps(found.to_dict()))
    assert all(note in printed for note in found.notes.values())
    assert all(f"warning: {words}\n" in printed for words in found.doubts)
    assert len(found.doubts) > 1 and found.warnings == found.doubts and "same readings as a.csv" in "".join(found.doubts)
    assert [one.curve.name for one in found.fitted if one.counts] == ["a.csv", "b.csv"]
    assert found.numbers["coating.E"].value == found.means["coating.E"].value > 0.0
    assert {column.title for column in found.tables["spread"]} >= {"mean of tests", "scatter"}


def test_moduli_are_what_the_command_writes(tmp_path, monkeypatch, capfd):
    monkeypatch.chdir(tmp_path)
    found = measured("modulus", tmp_path)
    assert capfd.readouterr() == ("", "") and not [*tmp_path.iterdir()]
    given = [str(FITS / "csm_on_oxide.csv"), "--problem", str(FITS / "csm_on_oxide.toml")]
    assert main(["modulus", *given, "--csv", "found.csv", "--json", "found.json"]) == 0
    printed = capfd.readouterr().out
    assert_written(found.tables["points"], "found.csv")
    assert json.loads((tmp_path / "found.json").read_text()) == {**found.profile.to_dict(), "warnings": [*found.doubts]}
    assert found.notes["zero"] in printed and all(f"warning: {words}\n" in printed for words in found.doubts)


def test_a_calibration_is_the_file_that_its_command_writes(tmp_path, monkeypatch, capfd):
    monkeypatch.chdir(tmp_path)
    found = measured("calibrate", tmp_path)
    assert capfd.readouterr() == ("", "") and not [*tmp_path.iterdir()]
    given = [str(FITS / "csm_on_silica.csv"), "--problem", str(FITS / "csm_on_silica.toml")]
    assert main(["calibrate", *given, "--output", "tip.toml"]) == 0
    assert (tmp_path / "tip.toml").read_text() == found.tip_file()
    assert found.notes["fit"] in capfd.readouterr().out
    assert found.numbers["frame_compliance"].value == found.fit.estimates["frame_compliance"]


@pytest.mark.parametrize("name", ["modulus", "calibrate"])
def test_data_without_stiffnesses_are_refused(name):
    fit_file = load_fit_file(FITS / "sphere_on_oxide.toml")
    data, _ = fit_file.read_data(FITS / "sphere_on_oxide.csv")
    with pytest.raises(ProblemError, match=r"^\[data\]: kind must be"):
        STUDIES[name](fit_file, [("one", data)] if name == "calibrate" else data)


def test_maps_are_what_the_command_writes(tmp_path, monkeypatch, capfd):
    monkeypatch.chdir(tmp_path)
    found = measured("map", tmp_path)
    assert capfd.readouterr() == ("", "") and len([*tmp_path.iterdir()]) == 2
    assert main(["map", str(map_file(tmp_path)), "--npy", "found.npy", "--threads", "1"]) == 0
    printed = capfd.readouterr().out
    assert np.array_equal(np.load("found.npy"), found.maps) and found.notes["bounds"] in printed
    table = as_text(found.tables["moduli"], left=2)
    assert table in printed and len(table.splitlines()) == 5
    assert found.numbers["most"].value == found.maps.max() and set(found.moduli) == {-1.0, 1.0}
    with pytest.raises(mdr.errors.OutOfMemoryError):
        measured("map", tmp_path, memory_limit=1.0)


def test_an_inspection_is_what_the_command_prints(tmp_path, monkeypatch, capfd):
    monkeypatch.chdir(tmp_path)
    found = measured("inspect", tmp_path)
    assert capfd.readouterr() == ("", "") and not [*tmp_path.iterdir()] and found.refusal is None
    assert main(["inspect", str(FITS / "sphere_on_oxide.csv"), "--problem", "start.toml"]) == 0
    printed = capfd.readouterr().out
    assert (tmp_path / "start.toml").read_text() == found.inspection.problem
    assert as_text(found.tables["tests"], left=1) in printed and found.notes["segments"] in printed
    assert len(found.curves) == 1 and all(f"\n  {words}\n" in printed for words in found.curves)
    assert f"guessed in the problem file: {', '.join(found.guessed)}\n" in printed


@pytest.mark.parametrize("name", ["stress", "adhesion"])
def test_tables_on_the_screen(name, tmp_path, monkeypatch, capfd):
    """Numbers of which each has its own unit, and words in place of numbers."""
    found = computed(name, tmp_path, monkeypatch, capfd)
    assert main([name, str(EXAMPLES / f"{CASES[name][0]}.toml")]) == 0
    printed = capfd.readouterr().out
    for table in (table for about, table in found.tables.items() if about != "loop"):
        kinds = {type(column) for column in table}
        assert kinds <= {Column, Mixed, Words} and Words in kinds
        lines = [line.split("  ") for line in printed.splitlines()]
        for row in range(len(table[0].values)):
            words = [column.values[row] for column in table if isinstance(column, Words)]
            assert any(all(word in "  ".join(line) for word in words) for line in lines)
    assert ("maxima" if name == "stress" else "jumps") in found.tables


@pytest.mark.parametrize(
    ("name", "option"),
    [("stress", "lines"), ("friction", "loops"), pytest.param("conduction", "section", marks=pytest.mark.slow)],
)
def test_what_a_figure_needs_is_computed_on_demand(name, option, tmp_path, monkeypatch, capfd):
    assert not getattr(computed(name, tmp_path, monkeypatch, capfd), option)
    assert getattr(computed(name, tmp_path, monkeypatch, capfd, **{option: True}), option)


def test_pressures_and_references_of_a_curve(tmp_path, monkeypatch, capfd):
    found = computed("curve", tmp_path, monkeypatch, capfd, pressures=True, references=True)
    assert main(["curve", str(EXAMPLES / "sio2_on_si.toml"), "--pressure-csv", "pressures.csv"]) == 0
    written = np.loadtxt("pressures.csv", delimiter=",", skiprows=1)
    columns = found.tables["pressures"]
    assert np.array_equal(written.T, [column.unit.of(column.values) for column in columns])
    assert [name for name, _ in found.references] == ["coating", "substrate"]
    assert sum(len(one.r) for one in found.pressures) == len(written)


@pytest.mark.parametrize("name", ["adhesion", "friction", "wear", "conduction", "history"])
def test_a_table_that_is_missing_is_named(name):
    with pytest.raises(ProblemError, match=rf"^the table \[{name}\] is missing. Write it with"):
        STUDIES[name](problem.read(BODY))


@pytest.mark.parametrize("name", STUDIES)
def test_examples_of_docstrings(name):
    """And the sections that each has."""
    text = inspect.getdoc(STUDIES[name])
    assert all(f"{part}\n{'-' * len(part)}\n" in text for part in ("Parameters", "Returns", "Raises", "Examples"))
    parsed = doctest.DocTestParser().get_doctest(text, {}, name, None, 0)
    out = io.StringIO()
    assert parsed.examples and doctest.DocTestRunner().run(parsed, out=out.write).failed == 0, out.getvalue()


def test_each_study_is_a_module_of_its_name():
    commands = {command.__name__.rpartition(".")[2] for command in COMMANDS}
    assert set(STUDIES) == commands - {"app", "completion", "example"} | {"many"} == {*CASES, *MEASURED, "law", "validate"}
    for name, study in STUDIES.items():
        assert study.__module__ == f"mdrcontact.studies.{name}"
        # what may be followed may be stopped
        assert inspect.signature(study).parameters["progress"].kind is inspect.Parameter.KEYWORD_ONLY


def test_the_example_of_progress():
    parsed = doctest.DocTestParser().get_doctest(inspect.getdoc(Progress), {}, "Progress", None, 0)
    assert parsed.examples and doctest.DocTestRunner().run(parsed).failed == 0


@pytest.mark.parametrize("name", [*CASES, *MEASURED, "law"])
def test_progress_of_each_study(name, tmp_path):
    steps = []
    progress = Progress(lambda *step: steps.append(step))
    if name in MEASURED:
        measured(name, tmp_path, progress=progress)
    else:
        STUDIES[name](problem.load(EXAMPLES / f"{CASES.get(name, ('tin_on_steel',))[0]}.toml"), progress=progress)
    phases = {}
    for done, total, what in steps:
        assert total is None or 0 <= done <= total
        phases.setdefault(what, []).append(done)
    assert all(values == sorted(values) for what, values in phases.items())
    assert phases


@pytest.mark.parametrize("name", ["curve", "compare", "stress", "law"])
def test_a_study_stops_between_two_parts(name):
    """Compare lists models that refuse a problem; a stop is no refusal."""
    given = problem.load(EXAMPLES / "tin_on_steel.toml")
    calls = []
    with pytest.raises(mdr.errors.CancelledError):
        STUDIES[name](given, progress=Progress(stop=lambda: calls.append(0) or len(calls) > 2))
    assert len(STUDIES[name](given).title) > 0


@pytest.mark.parametrize(
    ("name", "options", "phase"),
    [
        ("fit", {"moves": True}, "other choices"),
        ("fit", {"interval": "profile"}, "intervals"),
        ("fit", {"compare": True}, "models"),
        ("many", {}, "curves"),
        ("modulus", {}, "points"),
        ("map", {}, "slices"),
        ("inspect", {}, "curves"),
        ("calibrate", {}, None),
    ],
)
def test_a_study_of_measurements_stops(name, options, phase, tmp_path):
    """A stop is no refusal of a model or of an interval."""
    phases = [None]
    progress = Progress(lambda _done, _total, what: phases.append(what), stop=lambda: phase in phases)
    with pytest.raises(mdr.errors.CancelledError):
        measured(name, tmp_path, **options, progress=progress)
    assert phases[-1] == phase


LONG = {
    **BODY,
    "medium": {
        "type": "coated",
        "model": "exact",
        "coating": {
            "relaxed_shear_modulus": "1 MPa", "moduli": ["2 MPa"], "times": ["0.5 s"], "nu": 0.5, "thickness": "1 um",
        },
        "substrate": {"relaxed_shear_modulus": "3 MPa", "moduli": ["2 MPa"], "times": ["2 s"], "nu": 0.3},
    },
    "history": {"path": "sine", "depth": "300 nm", "duration": "10 s", "points": 2000},
}  # fmt: skip


@pytest.mark.parametrize("in_main_thread", [True, False])
def test_a_study_stops_within_a_call_into_the_library(in_main_thread):
    """And the history that is marched in one call reports its rounds."""
    steps, ended = [], []
    begun = time.monotonic()
    late = threading.Event()

    def stop():
        if time.monotonic() - begun > 0.6:
            late.set()
        return late.is_set()

    def run():
        try:
            studies.history(problem.read(LONG), progress=Progress(lambda *step: steps.append(step), stop))
        except mdr.errors.CancelledError:
            ended.append(time.monotonic() - begun)

    if in_main_thread:
        run()
    else:
        thread = threading.Thread(target=run)
        thread.start()
        thread.join()
    assert ended and ended[0] < 10.0
    rounds = [total for _, total, what in steps if what.startswith("samples in round ")]
    assert rounds and set(rounds) == {2001}
    # the next call is not stopped
    assert mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.3))).at_depth(0.1).force > 0.0


def test_what_stop_raises_is_raised_by_the_study():
    def stop():
        if sys._getframe(1).f_code.co_name == "is_over":
            raise KeyboardInterrupt
        return False

    with pytest.raises(KeyboardInterrupt):
        studies.history(problem.read(LONG), progress=Progress(stop=stop))


def test_warnings_belong_to_the_result():
    deep = problem.read({**BODY, "compute": {"depths": ["20 um"]}})
    with warnings.catch_warnings(record=True) as shown:
        warnings.simplefilter("always")
        found = studies.curve(deep)
    assert len(found.warnings) >= 1 and "slope of" in found.warnings[0]
    assert [str(one.message) for one in shown] == [*found.warnings]
    assert {one.filename for one in shown} == {__file__}
    assert studies.curve(problem.read(BODY)).warnings == ()


def test_a_refused_study_has_warned_as_well():
    deep = problem.read({**BODY, "compute": {"depths": ["20 um"]}, "strength": {"von_mises": ["none"]}})
    with warnings.catch_warnings(record=True) as shown, pytest.raises(ProblemError, match="all strengths"):
        warnings.simplefilter("always")
        studies.stress(deep)
    assert any("slope of" in str(one.message) for one in shown)


FORBIDDEN = {"print", "open", "input", "exit", "quit"}


def faults(source):
    """What a study must not do: print, open files, end the program, parse or know a command line."""
    found = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call):
            name = getattr(node.func, "id", getattr(node.func, "attr", ""))
            if name in FORBIDDEN | {"write_text", "write_bytes", "read_text", "read_bytes", "replace_file"}:
                found.add(name)
        elif isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names} & {"argparse", "sys", "tqdm", "matplotlib"}
        elif isinstance(node, ast.ImportFrom):
            words = {*(node.module or "").split("."), *(alias.name for alias in node.names)}
            found |= words & {"argparse", "sys", "tqdm", "matplotlib", "cli", "_progress", "_files"}
    return found


def test_studies_neither_print_nor_open_files():
    sources = {path.name: path.read_text() for path in (PACKAGE / "studies").glob("*.py")}
    assert len(sources) > len(STUDIES)
    assert not {name: found for name, source in sources.items() if (found := faults(source))}
    assert faults("print(1)\nfrom ..cli import files\nimport sys\nopen('x')") == {"print", "cli", "sys", "open"}


def counted(source):
    """Lines of a command but for blank ones, its line of help, its arguments and the functions that read one of these."""
    tree = ast.parse(source)
    arguments = [node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == "add_arguments"]
    types = {
        keyword.value.id
        for function in arguments
        for node in ast.walk(function)
        if isinstance(node, ast.Call)
        for keyword in node.keywords
        if keyword.arg == "type" and isinstance(keyword.value, ast.Name)
    }
    help_texts = [
        node
        for node in tree.body
        if (isinstance(node, ast.FunctionDef) and node.name in types)
        or (isinstance(node, ast.Assign) and [getattr(target, "id", "") for target in node.targets] == ["HELP"])
    ]
    left_out = {line for node in (*arguments, *help_texts) for line in range(node.lineno, node.end_lineno + 1)}
    return sum(bool(line.strip()) and number not in left_out for number, line in enumerate(source.splitlines(), start=1))


@pytest.mark.parametrize("command", [*COMMANDS, cli_many], ids=lambda command: command.__name__)
def test_commands_parse_call_print_and_write(command):
    assert counted(inspect.getsource(command)) <= MOST_LINES


def test_lines_are_counted():
    source = (
        'HELP = "x"\n\n\ndef add_arguments(parser):\n    parser.add_argument("a", type=_a)\n\n\ndef run(a):\n    print(a)\n\n\n'
    )
    assert counted(source + "def _a(text):\n    return text\n") == 2
    assert counted(source + "def _b(text):\n    return text\n") == 4


def test_each_command_has_a_text_of_help():
    texts = {path.stem: path.read_text(encoding="utf-8") for path in (PACKAGE / "cli" / "help").glob("*.txt")}
    assert set(texts) == {command.__name__.rpartition(".")[2] for command in COMMANDS}
    assert all(len(text) > 200 and text.endswith("\n") for text in texts.values())


def test_a_stop_is_not_taken_for_a_refusal():
    """Work that goes on after an error of one of its calls ends, too."""
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Graded([0.0, 0.5, 2.0], [1.0, 2.0, 5.0], 0.3))
    went_on = []
    with pytest.raises(mdr.errors.CancelledError, match="stopped by its caller"), Progress(stop=lambda: True).listened():
        with contextlib.suppress(mdr.MDRError):
            contact.at_force(np.linspace(0.01, 1.0, 1_000_000))
        went_on.append(True)
    assert went_on and contact.at_depth(0.5).force > 0.0


@pytest.mark.parametrize("depths", [["5 nm", "50 nm"], ["10 nm", "30 nm", "80 nm"], ["30 nm", "60 nm"], ["5 nm", "10 nm"]])
def test_the_contact_is_as_wide_as_the_coating_thick_at_one_depth(depths):
    """By interpolation between the rows it was 21.218, 21.136 or 20.947 nm, and "always above" it from 30 nm on."""
    table = {"coating": {"E": "72 GPa", "nu": 0.17, "thickness": "500 nm"}, "substrate": {"E": "163 GPa", "nu": 0.22}}
    tables = {
        "indenter": {"shape": "sphere", "radius": "10 um"},
        "medium": {"type": "coated", **table},
        "compute": {"depths": depths},
    }
    read = problem.read(tables)
    found = studies.curve(read)
    h = 500e-9
    inside = found.states.radius[0] < h < found.states.radius[-1]
    assert found.at_thickness.radius == pytest.approx(h)
    assert read.contact().at_depth(found.at_thickness.depth).radius == pytest.approx(h, rel=1e-12)
    words = found.notes["thickness"]
    assert words.endswith("at depth 20.946 nm.") and ("equals the coating" in words) == inside
    assert ("stays above" in words) == (found.states.radius[0] > h) and ("stays below" in words) == (found.states.radius[-1] < h)
    labels = [part.y for panel in found.figure().panels for part in panel.parts if getattr(part, "text", "") == "a = h"]
    assert len(labels) == 3 * inside
