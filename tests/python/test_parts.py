# SPDX-License-Identifier: GPL-3.0-or-later
"""Independent parts of long calls on several threads: the same bits, the first error, warnings in order, a prompt end."""

import threading
import time
import warnings
from pathlib import Path

import numpy as np
import pytest
from conftest import OXIDE, SILICON

import mdrcontact as mdr
from mdrcontact import _parts, poroelastic, problem, studies
from mdrcontact import instruments as mdi
from mdrcontact._parts import share
from mdrcontact._warn import collected, is_silent, reported_to, silence, warn
from mdrcontact.cli import main
from mdrcontact.instruments import fitting
from mdrcontact.progress import Progress
from mdrcontact.threads import all_cores, cores, team

TEAMS = (1, 2, 8)
FITS = Path(__file__).resolve().parents[2] / "examples" / "fit"
BALL = mdr.Paraboloid(1e-5)
FILM = mdr.Coated(OXIDE, 5e-7, SILICON)
DEPTH = np.linspace(5e-9, 1e-7, 60)
NOISE = 1.0 + 0.01 * np.random.default_rng(3).standard_normal(60)
DATA = mdi.ForceDepth(DEPTH, mdr.Contact(BALL, FILM).at_depth(DEPTH).force * NOISE)
GEL = mdr.Homogeneous(poroelastic.Poroelastic(28e3, 0.28, 3e-8))
PUNCH = mdr.FlatPunch(1e-3)
TIME = np.linspace(0.0, 60.0, 12)
RELAXATION = mdi.ForceTime(TIME, np.full(12, 5e-5), 10.0 + 2.0 * np.exp(-TIME / 20.0))

STRENGTHS = """
[indenter]
shape = "paraboloid"
radius = "10 um"
[medium]
type = "coated"
coating = { E = "445 GPa", nu = 0.25, thickness = "1 um" }
substrate = { E = "210 GPa", nu = 0.3 }
[compute]
max_depth = "100 nm"
[strength]
von_mises = ["14 GPa", "2 GPa"]
tension = ["3 GPa", "none"]
interface_shear = ["0.8 GPa"]
"""


@pytest.fixture(autouse=True)
def one_thread_afterwards():
    yield
    mdr.set_threads(1)


def settings():
    """The numbers of threads by which a test is repeated."""
    for threads in TEAMS:
        mdr.set_threads(threads)
        yield threads


def bits(value):
    """Numbers as text that tells each bit."""
    if isinstance(value, dict):
        return {key: bits(one) for key, one in value.items()}
    return [float(one).hex() for one in np.ravel(value)]


def profile_ends():
    file = mdi.load_fit_file(FITS / "csm_on_oxide.toml")
    found = studies.fit(file, file.read_data(FITS / "csm_on_oxide.csv")[0], interval="profile")
    assert len(found.intervals) > 1
    return dict(found.intervals)


def tables():
    poroelastic.table.cache_clear()
    answers = fitting.gel._Answers(RELAXATION, PUNCH, GEL, "surface")
    return [*answers.between(0.3, 2e-8), *answers.between(0.1, 4e-8)]


def drainages():
    poroelastic.table.cache_clear()
    return {fit.drainage: dict(fit.values) for fit in mdi.compare_drainages(RELAXATION, PUNCH, GEL, ["shear_modulus"])}


def models():
    ranking = mdi.compare_models(DATA, BALL, FILM, ["coating.E"])
    assert len(ranking.models) > 3
    return {one.model: one.result.estimates for one in ranking.models}


def moves():
    moved = mdi.find_moves(mdi.fit(DATA, BALL, FILM, ["coating.E", "depth_offset"]))
    assert len(moved.ranges) > 2
    return {one.choice: [one.value, one.standard_error] for one in moved.ranges}


def failures():
    found = studies.stress(problem.read_text(STRENGTHS)).failures
    assert len(found) > 2
    return {f"{one.mode} {one.place}": [one.state.force, one.at.value] for one in found}


CALLS = {call.__name__: call for call in (profile_ends, tables, drainages, models, moves, failures)}


@pytest.mark.parametrize("name", CALLS)
def test_same_bits_for_any_number_of_threads(name, monkeypatch):
    """Each call gives its parts to several threads, and finds the same."""
    if name in ("tables", "drainages"):
        pytest.importorskip("scipy")
    seen, see = [], _parts._one

    def one(*arguments):
        seen.append(threading.get_ident())
        return see(*arguments)

    monkeypatch.setattr(_parts, "_one", one)
    found = []
    for threads in settings():
        seen.clear()
        found.append(bits(CALLS[name]()))
        assert len({*seen}) == 0 if threads == 1 else len({*seen}) > 1
    assert found[1] == found[0] and found[2] == found[0]


def test_simulated_intervals_have_the_same_bits(monkeypatch):
    result = mdi.fit(DATA, BALL, FILM, ["coating.E", "depth_offset"])
    found = []
    for threads in TEAMS:
        monkeypatch.setenv("OMP_NUM_THREADS", str(threads))
        found.append(bits(result.simulate(draws=20, seed=1)))
    assert found[1] == found[0] and found[2] == found[0]


def test_parts_run_at_the_same_time_in_threads_that_use_one_each():
    for threads in settings():
        meet = threading.Barrier(threads)

        def one(part, meet=meet):
            meet.wait(timeout=60)
            return part, team(), threading.get_ident()

        found = share(one, range(16))
        assert [part for part, _, _ in found] == [*range(16)]
        if threads > 1:
            assert {inner for _, inner, _ in found} == {1}
            assert threading.get_ident() not in {own for _, _, own in found}
        else:
            assert {own for _, _, own in found} == {threading.get_ident()}


def test_the_first_part_that_fails_raises_its_error():
    """Also where a later one fails earlier; parts are counted up to it."""
    for _ in settings():
        counted, late = [], threading.Event()

        def one(part, late=late):
            if part == 5 and team() == 1 and threading.current_thread() is not threading.main_thread():
                late.wait(timeout=60)
            if part in (5, 6):
                late.set()
                raise mdr.errors.DomainError(f"part {part}")
            return part

        with pytest.raises(mdr.errors.DomainError, match="part 5"):
            share(one, range(12), done=counted.append)
        assert counted == [1, 2, 3, 4, 5]
    assert share(one, []) == []


def test_warnings_come_in_the_order_of_the_parts():
    def one(part):
        time.sleep(0.02 * (part % 3 == 0))
        warn(f"{part}", mdr.MDRWarning)

    expected = [f"{part}" for part in range(9)]
    for _ in settings():
        read = []
        with reported_to(lambda text, _kind, read=read: read.append(text)):
            share(one, range(9))
        with collected() as found:
            share(one, range(9))
        with warnings.catch_warnings(record=True) as shown:
            warnings.simplefilter("always")
            share(one, range(9))
        assert read == [caution.text for caution in found] == [str(each.message) for each in shown] == expected
        with silence(), warnings.catch_warnings():
            warnings.simplefilter("error")
            assert share(lambda _part: is_silent() or one(0), range(3)) == [True] * 3


def test_a_stop_ends_the_parts():
    """Parts in the library end soon; parts that have not begun do not begin."""
    begun = []
    contact = mdr.Contact(mdr.Cone(0.3), mdr.Coated(OXIDE, 5e-7, SILICON))

    def one(part):
        begun.append(part)
        contact.at_depth(np.linspace(1e-9, 4e-7, 50_000))
        return part

    for _ in settings():
        begun.clear()
        count = []
        with (
            pytest.raises(mdr.errors.CancelledError, match="stopped by its caller"),
            Progress(stop=lambda count=count: count.append(0) or bool(begun)).listened(),
        ):
            share(one, range(30))
        assert len(begun) < 20


def test_ctrl_c_ends_the_parts(monkeypatch):
    begun = []

    def one(part):
        begun.append(part)
        time.sleep(0.01)

    def interrupted(done):
        if done == 3:
            raise KeyboardInterrupt

    for _ in settings():
        begun.clear()
        with pytest.raises(KeyboardInterrupt):
            share(one, range(1000), done=interrupted)
        assert len(begun) < 500


def test_where_the_system_refuses_threads_one_does_the_parts(monkeypatch):
    start, started = threading.Thread.start, []

    def refuse(self):
        if started:
            raise RuntimeError("can't start new thread")
        started.append(self)
        start(self)

    for most in (0, 1):
        started[:] = [None] * (1 - most)
        with monkeypatch.context() as patched:
            patched.setattr(threading.Thread, "start", refuse)
            assert share(lambda part: part**2, range(5), threads=4) == [0, 1, 4, 9, 16]


def test_number_of_cores(monkeypatch):
    monkeypatch.delenv("OMP_NUM_THREADS", raising=False)
    own = cores()
    assert own >= 1
    for words, expected in (("3", 3), (" 4,2 ", 4), ("0", own), ("-1", own), ("many", own), ("", own)):
        monkeypatch.setenv("OMP_NUM_THREADS", words)
        assert cores() == expected
        with all_cores():
            assert team() == expected
    assert team() == 1
    mdr.set_threads(5)
    with all_cores():
        pass
    assert team() == 5


def test_commands_use_all_cores_and_leave_the_setting(monkeypatch, capsys):
    seen = []
    monkeypatch.setattr("mdrcontact.cli.fit.run", lambda _arguments: seen.append(team()))
    monkeypatch.setenv("OMP_NUM_THREADS", "6")
    mdr.set_threads(3)
    assert main(["fit", str(FITS / "csm_on_oxide.csv"), "--problem", str(FITS / "csm_on_oxide.toml")]) == 0
    assert seen == [6] and team() == 3


def test_a_stop_ends_simulated_intervals(monkeypatch):
    """Within the trials, not after them."""
    file = mdi.load_fit_file(FITS / "gel_in_time.toml")
    data = file.read_data(FITS / "gel_in_time.csv")[0]
    phases, trials, answer = [], [], fitting.problem.Problem.answer

    def counted(self):
        trials.append(self)
        return answer(self)

    def step(_done, _total, what):
        phases.append(what)
        trials.clear()

    monkeypatch.setattr(fitting.problem.Problem, "answer", counted)
    monkeypatch.setenv("OMP_NUM_THREADS", "2")
    stop = Progress(step, stop=lambda: "intervals" in phases and len(trials) > 2)
    with pytest.raises(mdr.errors.CancelledError, match="stopped by its caller"):
        studies.fit(file, data, interval="monte-carlo", progress=stop)
    assert phases[-1] == "intervals" and len(trials) < 150
