# SPDX-License-Identifier: GPL-3.0-or-later
"""Results carry their own warnings: each class of them, from the main thread and from any other, whatever was computed before."""

import copy
import pickle
import re
import sys
import threading
import warnings
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact._interrupt import workers
from mdrcontact._warn import collected, reported_to, silence, warn
from mdrcontact.cli import main

THREADS = 8
HALF_SPACE = mdr.Homogeneous(mdr.Elastic(1.0, 0.3))
STEEL = mdr.Elastic(210.0, 0.3)
FILM = mdr.Coated(mdr.Elastic(3.0, 0.3), 1.0, mdr.Elastic(1.0, 0.3), "exact")
STIFF = mdr.Coated(mdr.Elastic(100.0, 0.25), 1.0, mdr.Elastic(1.0, 0.3), "exact")
RUBBER = mdr.Viscoelastic(0.5, [(4.5, 0.1)], nu=0.0)


def at_radius(radius):
    return mdr.Contact(mdr.Paraboloid(1.0), HALF_SPACE).at_radius(radius)


def in_units(young):
    return mdr.Contact(mdr.Sphere(10e-6), mdr.Coated(mdr.Elastic(young, 0.17), 5e-7, mdr.Elastic(163e9, 0.22))).at_depth(1e-9)


def short_zone(stress):
    return mdr.Contact(mdr.Paraboloid(1.0), FILM, work_of_adhesion=0.01, cohesive_stress=stress).at_depth(0.01)


def on_a_film(film):
    return mdr.Contact(mdr.PowerLaw(4.0, 0.01), film).at_radius(2.0)


def inside(share, points=1000):
    """The field belongs to the load, the depth is that of another state."""
    state = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(STEEL)).at_radius(1.0)
    return state.replace(depth=state.depth * (1.0 + share)).interior(np.linspace(0.0, 2.0, points), 0.1)


def sheared(base):
    film = mdr.Coated(mdr.Elastic(4.75, 0.3), 0.514, mdr.Elastic(base, 0.0))
    friction = mdr.Friction(mdr.Contact(mdr.FlatEndedCone(0.608, 0.191), film), 0.3)
    shear = friction.shear(friction.contact.at_radius(0.614))
    return shear.at_shift(0.98 * shear.sliding_shift)


def of_a_law(depth):
    return mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(1.0), HALF_SPACE), 0.1, continue_beyond=True).at_depth([0.01, depth])


RATE = mdr.adhesion.RateAdhesion.from_rheology(RUBBER, 0.01, 1.0)
ADHESIVE = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(RUBBER.relaxed), adhesion=RATE)


def at_speed(speed):
    start = ADHESIVE.at_radius(0.6).depth
    return mdr.adhesion.rate_history(ADHESIVE, [0.0, (start + 1.0) / speed], depth=[start, -1.0], start="rest")


def worn(distance):
    sphere = mdr.Contact(mdr.Sphere(1.0), HALF_SPACE)
    return mdr.wear.Wear(sphere, 1.0).history(force=0.1, intervals=16, scheme="rings").advance([0.1, distance], force=[0.1, 0.1])


def unloaded(yield_stress):
    """R_Y of an imprint whose largest von Mises stress is 0.01863."""
    return mdr.plastic.Imprint.from_two_terms(HALF_SPACE, 0.9, 0.017, 0.013).reverse_yield(yield_stress)


def overloaded(radius):
    return mdr.plastic.Overload(mdr.Contact(mdr.Paraboloid(1.0), HALF_SPACE), [0.01]).at_radius(radius)


def imprinted(share):
    """An imprint with a residual depth below that of Hertz's unloading by a share of the recovery."""
    hertz = mdr.plastic.Imprint.from_two_terms(HALF_SPACE, 0.9, 0.0, 0.03)
    return mdr.plastic.Imprint(HALF_SPACE, 0.9, hertz.force, 1.0 - (1.0 + share) * hertz.recovery, 1.0)


CASES = {
    mdr.errors.PathEndsWarning: (worn, 60.0, 0.1, "ends after 1 of 2 parts"),
    mdr.errors.LargeStrainWarning: (at_radius, 3.0, 0.1, "slope of 3"),
    mdr.errors.UnitsWarning: (in_units, 72.0, 72e9, "from 72 to"),
    mdr.errors.ShortZoneWarning: (short_zone, 1e7, 0.1, "JKR limit"),
    mdr.errors.SeparationInsideWarning: (on_a_film, STIFF, STIFF.with_model("gao"), "not a single area"),
    mdr.errors.InteriorAccuracyWarning: (inside, 1e-6, 0.0, "an error of about 1.0e-06"),
    mdr.errors.SlipInsideWarning: (sheared, 3.5, 3.57, "slip would begin inside"),
    mdr.errors.BeyondRangeWarning: (of_a_law, 0.2, 0.05, "1 of 2 values of depth lie beyond 0.1"),
    mdr.errors.AdhesionRateWarning: (at_speed, 5e-3, 2e-4, "beyond its range"),
    mdr.errors.PlasticityWarning: (unloaded, 0.009, 0.02, "unloading yields again"),
}
"""Of each class how a result is made, with what it warns, with what it does not, and words of the warning."""


def looped(depth):
    gel = mdr.Coated(mdr.Elastic(1e3, 0.49), 1e-6, mdr.RIGID)
    return mdr.Contact(mdr.Sphere(10e-6), gel, work_of_adhesion=1e-5).loop("depth", depth, 10)


def made_a_law(depth):
    return mdr.ContactLaw(mdr.Contact(mdr.Paraboloid(1.0), HALF_SPACE), depth, tolerance=1e-3)


PLASTIC = {"overload": (overloaded, 0.2, 0.05, "hardness of spheres falls"), "imprint": (imprinted, 5e-4, -5e-4, "taken as 0")}
"""Others that a `PlasticityWarning` is about."""
THREADED = {**CASES, **PLASTIC, "loop": (looped, 1e-6, 1e-7, "compressed"), "law": (made_a_law, 3.0, 0.1, "slope of")}
"""The same, and objects that collect the warnings of what they compute."""


@pytest.fixture(autouse=True)
def _often():
    """Threads take turns after microseconds."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    yield
    sys.setswitchinterval(before)


def carried(result):
    return result.warnings() if callable(result.warnings) else result.warnings


def test_each_class_has_a_case():
    assert set(CASES) == {getattr(mdr.errors, name) for name in mdr.errors.__all__ if name.endswith("Warning")} - {mdr.MDRWarning}


@pytest.mark.parametrize("kind", CASES, ids=lambda kind: kind.__name__)
def test_each_class_is_raised_and_carried(kind):
    make, doubtful, sound, words = CASES[kind]
    with pytest.warns(kind) as seen:
        result = make(doubtful)
    (text,) = {str(warning.message) for warning in seen if warning.category is kind}
    assert text in carried(result) and words in text
    assert carried(pickle.loads(pickle.dumps(result))) == carried(copy.copy(result)) == carried(result)
    with warnings.catch_warnings():
        warnings.simplefilter("error", kind)
        assert not any(words in other for other in carried(make(sound)))


@pytest.mark.parametrize("kind", PLASTIC)
def test_plastic_results_carry_theirs(kind):
    make, doubtful, sound, words = PLASTIC[kind]
    with pytest.warns(mdr.errors.PlasticityWarning, match=words) as seen:
        result = make(doubtful)
    assert result.warnings == tuple(str(warning.message) for warning in seen)
    assert pickle.loads(pickle.dumps(result)).warnings == copy.copy(result).warnings == result.warnings
    assert make(sound).warnings == ()


@pytest.mark.filterwarnings("ignore::mdrcontact.MDRWarning")
def test_each_of_eight_threads_gets_its_own():
    """Sixty results of all kinds, every other one doubtful, made and read at a time."""
    kinds = list(THREADED)
    jobs = [(kinds[i // 2 % len(kinds)], i % 2 == 0) for i in range(60)]
    expected = {(kind, doubtful): carried(THREADED[kind][0](THREADED[kind][1 if doubtful else 2])) for kind, doubtful in set(jobs)}
    start = threading.Barrier(THREADS)

    def one(job):
        kind, doubtful = job
        return carried(THREADED[kind][0](THREADED[kind][1 if doubtful else 2]))

    with ThreadPoolExecutor(THREADS, initializer=start.wait) as pool:
        found = list(pool.map(one, jobs))
    assert found == [expected[job] for job in jobs]
    assert all(
        any(THREADED[kind][3] in text for text in texts) == doubtful for (kind, doubtful), texts in zip(jobs, found, strict=True)
    )


@pytest.mark.filterwarnings("ignore::mdrcontact.MDRWarning")
def test_what_a_shared_contact_was_asked_before_changes_nothing():
    """One contact for eight threads: deep states between shallow ones, each with its own sentence."""
    contact, radii = mdr.Contact(mdr.PowerLaw(4.0, 0.01), STIFF), [0.05, 1.5, 2.0]
    fresh = [mdr.Contact(mdr.PowerLaw(4.0, 0.01), STIFF).at_radius(radius).warnings() for radius in radii]
    assert len(set(fresh)) == 3
    with ThreadPoolExecutor(THREADS) as pool:
        found = list(pool.map(lambda i: contact.at_radius(radii[i % 3]).warnings(), range(48)))
    assert found == 16 * fresh


@pytest.mark.filterwarnings("ignore::mdrcontact.MDRWarning")
def test_a_field_is_refused_whatever_was_asked_before():
    """Few points are answered however often, and their warning states the error; many are refused every time."""
    state = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(STEEL)).at_radius(1.0)
    wrong, r = state.replace(depth=state.depth * 1.01), np.linspace(0.0, 2.0, 1000)
    for _ in range(3):
        few = wrong.interior(r[:400], 0.1)
        assert "an error of about 9.9e-03" in few.warnings[0]
        with pytest.raises(mdr.errors.NoConvergenceError, match="an error of about 9"):
            wrong.interior(r, 0.1)
    assert state.interior(0.1, 0.1).warnings == () == state.interior(r, 0.1).warnings


@pytest.mark.filterwarnings("ignore::mdrcontact.MDRWarning")
def test_objects_made_of_states_carry_theirs():
    gel = mdr.Coated(mdr.Elastic(1e3, 0.49), 1e-6, mdr.RIGID)
    contact = mdr.Contact(mdr.Sphere(10e-6), gel, work_of_adhesion=1e-5)
    for _ in range(2):  # a contact that has warned already
        assert "compressed" in contact.loop("depth", 1e-6, 10).warnings[0]
        law = mdr.ContactLaw(contact, 1e-6)
        assert "compressed" in law.warnings[0]
    assert pickle.loads(pickle.dumps(law)).warnings == law.warnings
    assert contact.loop("depth", 1e-7, 10).warnings == () == mdr.ContactLaw(contact, 1e-7).warnings
    film = mdr.Contact(mdr.Paraboloid(1.0), FILM)
    assert film.at_radius(1.0).critical().warnings == ()
    state = film.at_radius(1.0)
    assert "an error of about" in state.replace(depth=state.depth * (1.0 + 1e-5)).critical().warnings[0]
    (failure,) = film.first_failure({"von_mises": [None, 1.0]})
    assert failure.warnings == failure.state.warnings() != ()
    shear = sheared(3.5)
    friction = shear._asked_of.friction
    loop = friction.shear(friction.contact.at_radius(0.614)).loop(float(shear.shift), points=5)
    assert loop.warnings == shear.warnings != ()


@pytest.mark.filterwarnings("ignore::mdrcontact.MDRWarning")
def test_some_of_several_states():
    states = at_radius([0.1, 3.0, 2.0])
    assert "slope of 3 " in states.warnings()[0]
    assert [len(states[i].warnings()) for i in range(3)] == [0, 1, 1]
    shear = sheared(3.5)
    both = shear._asked_of.at_shift([0.01 * shear.shift, shear.shift])
    assert both.warnings == both[1].warnings == shear.warnings != () == both[0].warnings


def test_the_user_reads_each_kind_once_from_all_threads():
    contact = mdr.Contact(mdr.Paraboloid(1.0), HALF_SPACE)
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        with ThreadPoolExecutor(THREADS) as pool:
            list(pool.map(contact.at_radius, np.linspace(2.0, 9.0, 64)))
    assert [warning.category for warning in seen] == [mdr.errors.LargeStrainWarning]


def test_who_listens_belongs_to_a_thread():
    """Each of eight collects its own while all of them are at it, and one is silent."""
    meet = threading.Barrier(THREADS)

    def one(i):
        with collected() if i else silence() as found:
            for _ in range(3):
                meet.wait()
                warn(f"{i}", mdr.MDRWarning)
            meet.wait()
        return found and [caution.text for caution in found]

    with ThreadPoolExecutor(THREADS) as pool:
        assert list(pool.map(one, range(THREADS))) == [None, *(3 * [f"{i}"] for i in range(1, THREADS))]


def test_threads_of_a_computation_warn_whom_it_warns():
    read = []
    with warnings.catch_warnings(), reported_to(lambda text, kind: read.append((text, kind))):
        warnings.simplefilter("error")
        with workers(THREADS) as pool:
            list(pool.map(lambda i: warn(f"{i}", mdr.MDRWarning), range(16)))
        with silence(), workers(THREADS) as pool:
            list(pool.map(lambda i: warn(f"{i}", mdr.MDRWarning), range(16)))
        with collected() as found, workers(THREADS) as pool:
            list(pool.map(lambda i: warn(f"{i}", mdr.errors.UnitsWarning), range(16)))
    assert {*read} == {(f"{i}", mdr.MDRWarning) for i in range(16)} and len(read) == 16
    assert {*found} == {(f"{i}", mdr.errors.UnitsWarning) for i in range(16)}


def test_fits_in_threads_carry_theirs():
    """Curves with a jump of the modulus at half depth beside sound ones."""
    depth = np.linspace(0.05, 1.0, 20) * 1e-7
    sound = 4.0 / 3.0 * 1e9 / 0.91 * np.sqrt(1e-5) * depth**1.5
    random = np.random.default_rng(7)
    curves = []
    for i in range(60):
        force = sound * (1.0 + 0.3 * (i % 2) * (depth > 5e-8)) * (1.0 + 1e-3 * random.standard_normal(20))
        curves.append(mdi.ForceDepth(depth, force))
    arguments = mdr.Paraboloid(1e-5), mdr.Homogeneous(mdr.Elastic(1e9, 0.3)), ["E"]
    alone = [mdi.fit(curve, *arguments).warnings for curve in curves]
    assert [bool(words) for words in alone] == [i % 2 == 1 for i in range(60)]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert [result.warnings for result in mdi.fit_many(curves, *arguments, threads=THREADS)] == alone


@pytest.mark.slow
def test_trials_of_a_fit_do_not_warn_and_its_result_does():
    pytest.importorskip("scipy")
    start, curves = ADHESIVE.at_radius(0.6).depth, []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for speed in (2e-3, 5e-3):
            time = np.linspace(0.0, 0.6 / speed, 40)
            path = mdr.adhesion.rate_history(ADHESIVE, time, depth=start - speed * time, start="rest")
            curves.append(mdi.RateCurve(time, start - speed * time, path.force))
    with pytest.warns(mdr.errors.AdhesionRateWarning) as seen:
        found = mdi.fit_rate(curves, ADHESIVE.replace(adhesion=RATE.replace(work=0.011), work_of_adhesion=0.0), ["work"])
    assert tuple(str(warning.message) for warning in seen) == found.warnings
    assert len(found.warnings) <= len(curves)


def test_the_command_line_leaves_the_filters_of_the_process_alone(tmp_path, capsys):
    path = tmp_path / "gel.toml"
    path.write_text(
        '[indenter]\nshape = "sphere"\nradius = "10 um"\n[medium]\ntype = "coated"\nsubstrate = "rigid"\n'
        '[medium.coating]\nE = "1 kPa"\nnu = 0.49\nthickness = "1 um"\n[compute]\nmax_depth = "900 nm"\npoints = 20\n'
    )
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("always")
        assert main(["curve", str(path)]) == 0
        np.log(np.zeros(1))  # not ours, and not among the command's
    assert capsys.readouterr().err.count("would be compressed by") == 1
    assert [warning.category for warning in seen] == [RuntimeWarning]


def test_no_source_takes_warnings_from_the_process():
    """`catch_warnings` and the like change the filters of all threads."""
    taken = re.compile(r"catch_warnings|showwarning|simplefilter|filterwarnings|__warningregistry__|np\.seterr\b|numpy\.seterr\b")
    root = Path(mdr.__file__).parent
    assert [str(path.relative_to(root)) for path in root.rglob("*.py") if _uses(path, taken)] == []


def _uses(path, pattern):
    """Outside docstrings, whose examples may."""
    text = re.sub(r'""".*?"""', "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
    return pattern.search(text) is not None


def test_results_are_pickled_without_their_contact():
    """Fields inside and states of shear of a contact with a function that no other process knows."""
    contact = mdr.Contact(mdr.CallableProfile(lambda r: r * r / 2.0, 2.0), FILM)
    state = contact.at_radius(0.4)
    inside = state.interior(np.array([0.1, 0.2]), 0.3)
    again = pickle.loads(pickle.dumps(inside))
    assert all(np.array_equal(*pair) for pair in zip(again, inside, strict=True)) and again.warnings == inside.warnings
    sheared = mdr.Friction(contact, 0.3).shear(state).at_force([0.1 * state.force, 0.2 * state.force])
    again = pickle.loads(pickle.dumps(sheared))
    assert all(np.array_equal(*pair) for pair in zip(again, sheared, strict=True)) and again.warnings == sheared.warnings
    assert again[0].warnings == again.warnings
