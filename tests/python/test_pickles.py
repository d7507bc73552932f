# SPDX-License-Identifier: GPL-3.0-or-later
"""Every public object and result goes to another process and back, and is copied: none is left out of the list below."""

from __future__ import annotations

import copy
import inspect
import pickle
import subprocess
import sys
import warnings

import numpy as np
import pytest
from conftest import OXIDE, PUBLIC, ROOT, RUBBER, SILICON, every_medium, every_profile

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact import lateral, problem
from mdrcontact.conduction import INSULATING, PERFECT, Conduction, Conductor, LayeredConductor, RoughJoint
from mdrcontact.instruments.files.fit_file import load_fit_file

FILM, BALL = mdr.Coated(OXIDE, 500e-9, SILICON), mdr.Sphere(10e-6)
CONTACT = mdr.Contact(BALL, FILM)
DEPTH = np.linspace(1e-9, 1e-7, 12)
BASES = {mdr.Profile, mdr.Medium, lateral.Structure}
"""Classes without objects of their own."""


def coatings():
    """Layers that are not isotropic, bonded or free of stress, and their parts."""
    bone = mdr.TransverselyIsotropic(23.4, 9.06, 9.11, 32.5, 9.12)
    springs = mdr.Interface(normal=20.0, tangential=3.0)
    film = mdr.Layer(mdr.TransverselyIsotropic.from_engineering(10.0, 25.0, 0.2, 0.15, 3.0), 1.0, 0.1, springs)
    body = mdr.Layered([film, (bone, 2.0)], mdr.SMOOTH)
    return [bone, film, springs, mdr.SLIDING, body, body.wrinkling(), mdr.Homogeneous(bone), mdr.CRYSTALS["GaN"]]


def history_in_time():
    gel = mdr.Coated(mdr.PowerLawRheology(400.0, 1.0, 0.18, 0.5), 4e-6, mdr.RIGID)
    return mdr.Contact(mdr.Paraboloid(5e-6), gel).history([0.0, 0.5, 1.0], depth=[0.0, 1e-7, 1e-7])


def rates():
    rate = mdr.adhesion.RateAdhesion(0.05, 1e-6, 0.4, closing_work=0.03)
    rubber = mdr.Viscoelastic(5e5, [(2e6, 1e-2)], nu=0.5)
    contact = mdr.Contact(mdr.Paraboloid(5e-6), mdr.Homogeneous(RUBBER), adhesion=rate)
    time = np.linspace(0.0, 1.0, 30)
    force = mdr.adhesion.rate_history(contact, time, depth=1e-7 - 1e-6 * time, start="rest").force
    curve = mdi.RateCurve(time, 1e-7 - 1e-6 * time, force)
    return [
        curve,
        mdi.fit_rate([curve], contact, ["work"]),
        rate,
        mdr.adhesion.RateAdhesion.from_rheology(rubber, 0.05, 1e6),
        contact,
        mdr.adhesion.rate_history(contact, [0.0, 1.0], depth=[1e-7, -1e-7], start="rest"),
    ]


def fits():
    """Data, results and what is made of results."""
    states = CONTACT.at_depth(DEPTH)
    force, stiffness = np.asarray(states.force), np.asarray(states.stiffness)
    curve = mdi.ForceDepth(DEPTH, force, relative_sd=0.01)
    csm = mdi.StiffnessDepth(DEPTH, force, stiffness, relative_sd=0.01)
    free = {"coating.E": None, "thickness": mdi.Free(prior=(5e-7, 1e-8))}
    result = mdi.fit(curve, BALL, FILM, free)
    joint = mdi.JointPrior(("indenter.C0", "indenter.C1"), (24.5, 1e-7), ((0.01, 0.0), (0.0, 1e-18)))
    tip = mdr.AreaFunction([24.5, 1e-7], max_height=1e-6)
    paired = mdi.fit(csm, tip, mdr.Pair(FILM, mdr.Elastic(1141e9, 0.07)), ["coating.E"], known=[joint])
    layers = mdr.Pair(FILM, mdr.Coated(SILICON, 2e-7, OXIDE))
    two = mdi.fit(curve, BALL, layers, ["upper.coating.E"], instrument=mdi.Instrument(depth_offset=1e-10), max_iterations=2)
    ranking = mdi.compare_models(curve, BALL, FILM, ["coating.E"], models=["exact", "gao"])
    fits = mdi.fit_many([curve, lambda: mdi.ForceDepth(DEPTH, force * np.nan)], BALL, FILM, ["coating.E"])
    h = np.concatenate([DEPTH, DEPTH[::-1]])
    unloading = mdi.Unloading(
        np.interp(np.arange(0, 24, 0.1), np.arange(24), h), np.interp(np.arange(0, 24, 0.1), np.arange(24), h**1.5)
    )
    way, back = np.linspace(0.0, 1.0, 60), np.linspace(1.0, 0.0, 60)
    noise = 1e-6 * np.random.default_rng(0).standard_normal(120)
    indent = mdi.Unloading(1e-7 * np.r_[way, 1.0 - 0.4 * way], 1e-3 * np.r_[way**2, back**1.5] + noise)
    yielded = mdi.fit(indent, mdr.Berkovich(), mdr.Homogeneous(OXIDE), ["E"], yield_stresses=[4.8e9])
    states = mdr.Contact(mdr.Vickers(), FILM).at_radius(FILM.thickness * np.array([0.5, 1.0, 1.5]))
    pyramid = mdi.ForceDepth(states.depth, 1.03 * states.force, relative_sd=0.01)
    of_pyramid = mdi.fit(pyramid, mdr.Vickers(), FILM, ["coating.E"], pyramid_correction=True)
    profile = mdi.modulus_at_depths(csm, BALL, FILM, ["coating.E"])
    composite = mdi.composite_hardness(np.arange(1.0, 8.0), 1.0 + 1.0 / np.arange(1.0, 8.0))
    time = np.linspace(0.0, 1.0, 9)
    omega = np.geomspace(1.0, 10.0, 5)
    end = mdi.Move("up to depth 5 nm", 5e-9, 7e10, 1e9)
    gel = mdr.Homogeneous(mdr.poroelastic.Poroelastic(2e3, 0.2, 1e-9))
    held = mdi.ForceTime(time, np.full(time.shape, 1e-6), 1e-9 / (1.0 + time), sd=1e-11)
    return [
        mdi.fit_gel(held, mdr.FlatPunch(1e-6), gel, drainage="surface"),
        mdi.Moves(result, "coating.E", (end,), (), ()),
        end,
        result.misfit,
        mdi.Indent(0.4, 5e-8, 0.5, True),
        mdi.rate(result),
        mdi.mean_of_tests([result, result], "coating.E"),
        curve,
        csm,
        unloading,
        unloading.unloadings[0],
        yielded,
        *yielded.reverse_yield,
        of_pyramid,
        of_pyramid.pyramid_correction,
        mdi.ModulusRadius([1e-7, 2e-7], [1e11, 1.1e11]),
        mdi.StiffnessRadius([1e-7, 2e-7], [1e4, 2e4], sd=1.0),
        mdi.ForceTime(time, 1e-8 * time, 1e-9 * time),
        mdi.DepthTime(time, 1e-9 * time, 1e-8 * time),
        mdi.DynamicStiffness(omega, omega * (1.0 + 1.0j), 1e-6),
        free["thickness"],
        joint,
        mdi.Instrument(indenter=OXIDE),
        result,
        paired,
        two,
        ranking,
        ranking.models[0],
        fits,
        fits[1],
        profile,
        composite,
        composite.forms["korsunsky"],
        mdi.oliver_pharr(csm, BALL),
        mdi.as_prior(result),
    ]


def friction():
    pair = mdr.Friction(CONTACT, 0.3)
    state = CONTACT.at_depth(5e-8)
    ball = mdr.Friction(mdr.Contact(BALL, mdr.Homogeneous(OXIDE)), 0.3)
    twisted = ball.twist(ball.contact.at_depth(5e-8))
    by_rings, springs = pair.history(5e-8, 20), mdr.Friction(mdr.Contact(BALL, mdr.Homogeneous(OXIDE)), 0.3).history()
    for one in (by_rings, springs):
        one.advance(depth=[1e-8, 4e-8], shift=[0.0, 1e-9])
        one.advance(force=0.9 * one.state.force, shift=2e-9)
        one.advance(depth=3e-8, tangential_force=0.0)
    return [
        pair,
        pair.shear(state).at_shift(1e-9),
        pair.shear(state).loop(1e-9),
        by_rings,
        springs,
        mdr.ContactLaw(CONTACT, 5e-8, friction=pair, tolerance=1e-4),
        pair.shear(state),
        twisted,
        twisted.at_shift(1e-4),
        twisted.loop(1e-4),
    ]


def wear():
    contact = mdr.Contact(BALL, mdr.Homogeneous(OXIDE))
    worn = mdr.wear.Wear(contact, (1e-15, 2e-15), (1e-9,), 1e-16)
    state = contact.at_depth(5e-8)
    history = worn.history(force=state.force, intervals=40)
    history.advance(1.0, force=state.force)
    fit = mdr.wear.wear_coefficient_from_volume([1e-18, 2e-18], [1.0, 2.0], 1e-3)
    return [worn, worn.limit(state, 0.5 * state.radius), history, history.state, history.profile, fit]


def imprints():
    imprint = mdr.plastic.Imprint(mdr.Homogeneous(SILICON), 1e-6, 0.018, 60e-9, 130e-9)
    points = mdr.plastic.Imprint.from_pressure(FILM, [0.0, 3e-7, 6e-7, 9e-7], [7e9, 6.9e9, 6.4e9, 5e9])
    return [imprint, points, imprint.profile, imprint.reverse_yield(7e9), imprint.contact(0.1)]


def yielding():
    """Bodies that yield, their laws, models of first loading, and the states of each."""
    flat = mdr.plastic.Yielding(OXIDE, yield_stress=2e9)
    rising = mdr.plastic.Yielding(OXIDE, hardening=[(0.0, 2e9), (0.01, 2.1e9)])
    law = mdr.plastic.PlasticLaw(mdr.Paraboloid(1e-4), rising, 5e-7, other=SILICON)
    adhesive = mdr.plastic.PlasticLaw(mdr.Paraboloid(1e-4), flat, 5e-7, work_of_adhesion=0.05)
    points = mdr.plastic.Overload(mdr.Contact(mdr.Cone(0.1), mdr.Homogeneous(OXIDE)), [1e9]).points([1e-8, 2e-8, 4e-8])
    contact = mdr.Contact(mdr.Paraboloid(1e-5), FILM)
    rule, cap = mdr.plastic.Overload(contact, [1e9, 7e9]), mdr.plastic.PressureCap(contact, 2e9)
    return [
        flat,
        rising,
        law,
        adhesive,
        law.with_radius(2e-4),
        mdr.plastic.PlasticLaw.from_table(*points, modulus=OXIDE.E / (1.0 - OXIDE.nu**2)),
        law.advance(law.contacts(2), [1e-7, 4e-7]),
        law.loading([1e-8, 4e-7]),
        mdr.plastic.yield_stress_from_hardness(OXIDE, 5e9),
        points,
        rule,
        rule.at_radius(3e-7),
        rule.at_radius(9e-7).imprint(),
        rule.at_radius(9e-7),
        cap,
        cap.at_radius(6e-7),
        cap.at_radius(6e-7).imprint(),
    ]


def zone_in_time():
    sticky = mdr.Contact(
        mdr.Paraboloid(10e-6), mdr.Homogeneous(mdr.Viscoelastic(0.5e6, [(4.5e6, 1e-3)], nu=0.5)), 0.05, cohesive_stress=0.5e6
    )
    return mdr.adhesion.adhesive_history(sticky, [0.0, 1e-3], depth=[-1e-5, -0.9e-5])


def results():
    adhesive = mdr.Contact(mdr.Paraboloid(5e-6), mdr.Coated(RUBBER, 2e-6, mdr.RIGID), 0.05)
    law = mdr.ContactLaw(CONTACT, 1e-7)
    state = CONTACT.at_depth(5e-8)
    critical = state.critical()
    return [
        CONTACT,
        state,
        CONTACT.at_depth(DEPTH),
        adhesive.pull_off(),
        adhesive.loop("force", 1e-6),
        state.interior(0.0, 1e-7),
        critical,
        critical.layers[0],
        critical.layers[0].von_mises,
        critical.interfaces[0],
        *CONTACT.first_failure({"von_mises": [1e8, 1e8]}),
        history_in_time(),
        *rates(),
        zone_in_time(),
        law,
        law.at_depth(5e-8),
        law.arrays(),
        mdr.accuracy_map([0.5, 2.0], [0.3, 1.0], ["gao"]),
    ]


def conductors():
    tin, copper = Conductor(9.17e6), Conductor(59.6e6, 50e6, 3.4e6)
    body = LayeredConductor(((tin, 1e-6), mdr.Interface(1e-12)), copper)
    conduction = Conduction(body, copper, film=1e-13)
    return [
        tin,
        mdr.Interface(1e-9),
        RoughJoint(1e-7, 0.1, 2e9, 1e-8, 0.03),
        body,
        conduction,
        PERFECT,
        INSULATING,
        conduction.at_radius(1e-6),
        conduction.replace(film=0.0).friction_heat(CONTACT.at_depth(1e-8), 0.1, 1.0),
        conduction.along(CONTACT.at_depth(1e-8)),
        conduction.replace(film=0.0).tabulated(1e-7, 1e-6, 1e-4),
        mdi.ConductanceForce([1e-6, 2e-6], [1.0, 1.2], CONTACT),
        mdi.Impedance([1.0, 10.0], [1.0 + 0.1j, 0.9], 1e-6),
        mdi.fit_conduction(mdi.ConductanceForce([1e-6, 2e-6], [1.0, 1.2], CONTACT), conduction.replace(film=0.0), ["layer1.sigma"]),
    ]


def bodies():
    gel = mdr.Viscoelastic(500.0, [(300.0, 0.05)], bulk_modulus=5e3)
    fluid = mdr.poroelastic.Poroelastic(2e3, 0.2, 1e-9)
    return [
        OXIDE,
        gel,
        fluid,
        mdr.PowerLawRheology(400.0, 1.0, 0.18, 0.5),
        mdr.RIGID,
        mdr.SMOOTH,
        *coatings(),
        mdr.Surface(0.03),
        *every_profile(),
        *every_medium(),
    ]


def structures():
    matrix, glass = mdr.Elastic(3e9, 0.35), mdr.Elastic(70e9, 0.22)
    kinds = [
        lateral.Ball((5e-6, 5e-6, 4e-6), 3e-6, glass),
        lateral.Box((0.0, 1e-6), (0.0, 1e-6), (1e-6, 2e-6), glass),
        lateral.Fibre((0.0, 0.0, 4e-6), (1.0, 0.0, 0.0), 1e-6, glass),
        lateral.HalfSpace((0.0, 0.0, 8e-6), (0.0, 0.0, 1.0), glass),
        lateral.Layer(1e-6, 2e-6, glass),
        lateral.Pillar(0.0, 0.0, 1e-6, 1e-6, 2e-6, glass),
    ]
    shapes = lateral.Shapes(matrix, kinds[:1])
    voxels = lateral.Voxels(np.arange(64).reshape(4, 4, 4) % 2, [matrix, glass], 1e-6)
    return [
        *kinds,
        shapes,
        voxels,
        lateral.Field(moduli, 0.3),
        lateral.LateralMedium(shapes, 0.0, 0.0, 1e-8, 1e-5),
        shapes.bounds(0.0, 0.0, 1e-6),
        lateral.slide(voxels, BALL, np.linspace(0.0, 1e-6, 5), depth=1e-9),
        lateral.indentation_map(voxels, BALL, 1e-9),
    ]


def moduli(x, y, z):
    """A structure that pickles."""
    return 70e9 + 0.0 * x, 0.2


def records():
    h, p = np.linspace(-1e-7, 1e-7, 60), np.maximum(np.linspace(-1e-7, 1e-7, 60), 0.0)
    h, p = np.concatenate([h, h[::-1]]), np.concatenate([p, p[::-1]])
    return [
        mdi.find_segments(h, p)[0],
        mdi.segmentation(h, p),
        mdi.find_baseline(h[:60], p[:60], 30),
        mdi.PopIn(3, 1e-8, 1e-5, 1e-9),
        mdi.Drift(1e-11, 1e-12),
        mdi.Pull(1e-9, -1e-8, 1e-11),
        mdi.Parting(-1e-8, 1e-17),
    ]


def problems():
    return [
        problem.load(next((ROOT / "examples" / "problems").glob("*.toml"))),
        problem.MapProblem(
            "two phases", lateral.Voxels(np.zeros((2, 2, 2), dtype=int), [mdr.Elastic(1e9, 0.3)], 1e-6), np.array([1e-6])
        ),
        load_fit_file(ROOT / "examples" / "fit" / "csm_on_oxide.toml"),
    ]


def faults():
    words = [getattr(mdr.errors, name)("words") for name in mdr.errors.__all__]
    return [*words, problem.ProblemError("words")]


MAKERS = (bodies, conductors, results, friction, wear, imprints, yielding, fits, structures, records, problems, faults)


@pytest.fixture(scope="module")
def things():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return [thing for maker in MAKERS for thing in maker()]


def is_same(one, other):
    """Whether two things hold the same, whatever they are."""
    if type(one) is not type(other):
        return False
    if isinstance(one, np.ndarray):
        return np.array_equal(one, other, equal_nan=one.dtype.kind in "fc")
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(is_same(one[key], other[key]) for key in one)
    if isinstance(one, (tuple, list)):
        return len(one) == len(other) and all(map(is_same, one, other))
    if isinstance(one, BaseException):
        return one.args == other.args
    if type(one).__eq__ is not object.__eq__:
        return one == other or one != one
    if inspect.isfunction(one) or isinstance(one, type):
        return one is other or one.__qualname__ == other.__qualname__
    hidden = {"_handle", "problem", "_looked_at"}
    return is_same(*({k: v for k, v in state_of(thing).items() if k not in hidden} for thing in (one, other)))


def state_of(thing):
    return {**getattr(thing, "__dict__", {}), **{k: getattr(thing, k) for k in getattr(type(thing), "__slots__", ())}}


def test_nothing_public_is_missing(things):
    public = (vars(package)[name] for package in (*PUBLIC, problem) for name in package.__all__)
    classes = set(filter(inspect.isclass, public)) - BASES
    shown = {type(thing) for thing in things}
    assert not {cls.__name__ for cls in classes - shown}


def test_pickles_and_copies(things):
    for thing in things:
        for made in (lambda t: pickle.loads(pickle.dumps(t)), copy.copy, copy.deepcopy):
            other = made(thing)
            assert is_same(other, thing), thing


def test_results_go_on_in_another_process(things, tmp_path):
    """What was unpickled computes: it holds no addresses of the process that pickled it."""
    chosen = [thing for thing in things if isinstance(thing, (mdi.FitResult, mdr.Contact, mdr.ContactLaw))]
    (tmp_path / "things").write_bytes(pickle.dumps(chosen))
    text = """
import pickle, sys
for thing in pickle.load(open(sys.argv[1], "rb")):
    if hasattr(thing, "interval"):
        print(*thing.problem.predict(thing._values)[0], *thing.problem.answer()[0], thing.summary())
    else:
        print(thing.at_depth(1e-8))
"""
    done = subprocess.run([sys.executable, "-c", text, str(tmp_path / "things")], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    expected = []
    for thing in chosen:
        if isinstance(thing, mdi.FitResult):
            found = [*thing.problem.predict(thing._values)[0], *thing.problem.answer()[0], thing.summary()]
            expected.append(" ".join(map(str, found)))
        else:
            expected.append(str(thing.at_depth(1e-8)))
    assert done.stdout.split() == "\n".join(expected).split()


def test_a_history_goes_on_from_where_it_was(things):
    for history in [thing for thing in things if isinstance(thing, mdr.FrictionHistory)]:
        others = [pickle.loads(pickle.dumps(history)), copy.copy(history), copy.deepcopy(history), history.copy()]
        step = {"depth": 4.5e-8, "shift": 1e-9}
        expected = history.copy().advance(**step)
        for other in others:
            assert other.state == history.state and other.shear == history.shear
            assert other.advance(**step) == expected
            assert history.state != other.state, "each goes its own way"


def test_handles_stay_where_they_are():
    for made in (pickle.dumps, copy.copy, copy.deepcopy):
        with pytest.raises(TypeError, match="neither copied nor pickled"):
            made(BALL._handle)
