# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input of every kind: the class of the exception, and words that name argument, value and what is allowed."""

import math

import numpy as np
import pytest
from conftest import OXIDE, RUBBER, SILICON

import mdrcontact as mdr

NAN, INF = math.nan, math.inf

INVALID = [
    (lambda: mdr.Elastic(-1.0, 0.2), r"E = -1: .*greater than 0"),
    (lambda: mdr.Elastic(0.0, 0.2), r"E = 0:"),
    (lambda: mdr.Elastic(NAN, 0.2), r"E = NaN"),
    (lambda: mdr.Elastic(INF, 0.2), r"E = infinity"),
    (lambda: mdr.Elastic(1.0, 0.51), r"nu = 0.51: .*0.5]"),
    (lambda: mdr.Elastic(1.0, -1.0), r"nu = -1: .*\(-1"),
    (lambda: mdr.Paraboloid(0.0), r"radius = 0:"),
    (lambda: mdr.Sphere(-2.0), r"radius = -2:"),
    (lambda: mdr.Cone(2.0), r"inclination = 2:"),
    (lambda: mdr.Cone(half_angle=0.0, degrees=True), r"^half_angle = 0: .*90 degrees$"),
    (lambda: mdr.Cone(half_angle=-3.0, degrees=True), r"^half_angle = -3:"),
    (lambda: mdr.Cone(half_angle=1.6), r"^half_angle = 1.6: .*radian$"),
    (lambda: mdr.Cone(90.0, degrees=True), r"^inclination = 90: .*90 degrees$"),
    (lambda: mdr.FlatEndedCone(1.0, NAN), r"^inclination = nan:"),
    (lambda: mdr.CallableProfile(lambda r: r, r_max=-1.0), r"^r_max = -1: .*greater than 0"),
    (lambda: mdr.CallableProfile(lambda r: r, r_max=math.inf), r"^r_max = inf:"),
    (lambda: mdr.PowerLaw(0.0, 1.0), r"exponent = 0:"),
    (lambda: mdr.PowerLaw(1.0, NAN), r"coefficient = NaN:"),
    (lambda: mdr.FlatPunch(NAN), r"radius = NaN:"),
    (lambda: mdr.FlatEndedCone(0.0, 0.2), r"end_radius = 0:"),
    (lambda: mdr.FlatEndedParaboloid(1.0, 0.0), r"radius = 0:"),
    (lambda: mdr.RoundedCone(-1.0, 0.2), r"blend_radius = -1:"),
    (lambda: mdr.TabulatedProfile([0.0, 1.0, 1.0], [0.0, 1.0, 2.0]), r"entry 3 of r = 1: .*ascending"),
    (lambda: mdr.TabulatedProfile([0.0, 1.0, 2.0], [0.0, NAN, 2.0]), r"f = NaN|entry 2 of f"),
    (lambda: mdr.TabulatedProfile([0.0, 1.0], [0.0]), r"r and f must have the same length; it is 2 and 1"),
    (lambda: mdr.TabulatedProfile([], []), r"r: it is empty"),
    (lambda: mdr.AreaFunction([-1.0], max_height=1.0), r"."),
    (lambda: mdr.SumProfile([]), r"terms: it is empty"),
    (lambda: mdr.Coated(OXIDE, 0.0, SILICON), r"thickness = 0:"),
    (lambda: mdr.Coated(OXIDE, NAN, SILICON), r"thickness = NaN:"),
    (lambda: mdr.Coated(OXIDE, 1.0, SILICON, "goa"), r"model = 'goa': did you mean 'gao'\?"),
    (lambda: mdr.Coated(OXIDE, 1.0, SILICON, "Doerner-Nix"), r"did you mean 'doerner-nix'\?"),
    (lambda: mdr.Coated(OXIDE, 1.0, SILICON, "doerner-nix", alpa=1.0), r"alpa is not an option .*did you mean 'alpha'\?"),
    (lambda: mdr.Coated(OXIDE, 1.0, SILICON, "bec", alpha=1.0), r"alpha is not an option of the model 'bec'"),
    (lambda: mdr.Coated(OXIDE, 1.0, SILICON, "doerner-nix", alpha=-1.0), r"alpha = -1:"),
    (lambda: mdr.Coated(OXIDE, 1.0, SILICON, "gao", weight_nu="surfaces"), r"did you mean 'surface'\?"),
    (lambda: mdr.Coated(OXIDE, 1.0, SILICON, "gao", weight_nu=0.7), r"0\.7"),
    (lambda: mdr.Coated(OXIDE, 1.0, mdr.RIGID, "gao"), r"."),
    (lambda: mdr.Coated(RUBBER, 1.0, OXIDE, "garcia"), r"rigid base"),
    (lambda: mdr.Coated(OXIDE, 1.0, mdr.RIGID, "garcia"), r"nu = 0.17"),
    (
        lambda: mdr.Contact(mdr.Cone(0.1), mdr.Coated(RUBBER, 1.0, mdr.RIGID, "garcia")),
        r"apply to a paraboloid or a sphere. For other",
    ),
    (lambda: mdr.Layered([], SILICON), r"layers: it is empty"),
    (lambda: mdr.Layered([(OXIDE, -1.0)], SILICON), r"thickness.* = -1:"),
    (lambda: mdr.Layered([(OXIDE, 1.0)], SILICON, "bec"), r"model = 'bec':"),
    (lambda: mdr.Graded([0.0, 1.0], [1.0, 2.0, 3.0], 0.2), r"same length; it is 2, 3 and 2"),
    (lambda: mdr.Graded([0.0, 1.0], [1.0, 0.0], 0.2), r"E.* = 0:"),
    (lambda: mdr.Graded([1.0, 2.0], [1.0, 2.0], 0.2), r"z"),
    (lambda: mdr.Graded(-1.0, lambda z: 1.0, 0.2), r"depth = -1:"),
    (lambda: mdr.PowerLawGraded(1.0, 1.0, 1.0, 0.2), r"exponent = 1:"),
    (lambda: mdr.TabulatedMedium([1.0, 2.0, 3.0], [1.0, -1.0, 1.0]), r"moduli.* = -1:"),
    (lambda: mdr.TabulatedMedium([1.0, 2.0], [1.0]), r"same length; it is 2 and 1"),
    (lambda: mdr.CallableMedium(lambda a: 1.0, 2.0, 1.0), r"radius"),
    (lambda: mdr.Contact(mdr.Cone(0.2), mdr.Homogeneous(OXIDE), zeta=([1.0], [1.0, 2.0])), r"same length; it is 1 and 2"),
    (lambda: mdr.Contact(mdr.Cone(0.2), mdr.Homogeneous(OXIDE), zeta=([1.0, 2.0, 3.0], [1.0, -2.0, 1.0])), r"zeta.* = -2:"),
    (lambda: mdr.weights.weight_i0(-1.0), r"xi.* = -1:"),
    (lambda: mdr.weights.weight_i0(1.0, 0.6), r"nu = 0.6:"),
    (lambda: mdr.weights.weight_phi([1.0, NAN]), r"xi.*NaN"),
    (lambda: mdr.Homogeneous(OXIDE).modulus(0.0), r"a.* = 0:"),
    (lambda: mdr.Homogeneous(OXIDE).stiffness([1.0, NAN]), r"a.*NaN"),
    (lambda: mdr.Cone(0.2).mdr(INF), r"x.* = infinity"),
]


@pytest.mark.parametrize("number", range(len(INVALID)))
def test_values_that_are_never_allowed(number):
    make, words = INVALID[number]
    with pytest.raises(mdr.errors.InvalidArgumentError, match=words) as caught:
        make()
    assert isinstance(caught.value, (mdr.MDRError, ValueError))


WRONG_TYPE = [
    lambda: mdr.Elastic("70 GPa", 0.2),
    lambda: mdr.Elastic([1.0], 0.2),
    lambda: mdr.Elastic(1.0, None),
    lambda: mdr.Elastic(1 + 1j, 0.2),
    lambda: mdr.Elastic(True, 0.2),
    lambda: mdr.Sphere(np.array([1.0, 2.0])),
    lambda: mdr.Cone(),
    lambda: mdr.Cone(0.2, half_angle=0.2),
    lambda: mdr.SumProfile([mdr.Cone(0.2), 1.0]),
    lambda: mdr.TabulatedProfile([[0.0, 1.0]], [[0.0, 1.0]]),
    lambda: mdr.TabulatedProfile("01", "01"),
    lambda: mdr.CallableProfile(1.0, 1.0),
    lambda: mdr.CallableProfile(lambda r: "1", 1.0) if False else mdr.CallableProfile(lambda r: [1.0], 1.0),
    lambda: mdr.Homogeneous(70e9),
    lambda: mdr.Pair(OXIDE, 70e9),
    lambda: mdr.Pair(mdr.Cone(0.2), OXIDE),
    lambda: mdr.Coated(72e9, 1.0, SILICON),
    lambda: mdr.Coated(OXIDE, 1.0, "rigid"),
    lambda: mdr.Layered([OXIDE], SILICON),
    lambda: mdr.Layered([(OXIDE, "1 um")], SILICON),
    lambda: mdr.CallableMedium("f", 1.0, 2.0),
    lambda: mdr.Contact(OXIDE, mdr.Homogeneous(OXIDE)),
    lambda: mdr.Contact(mdr.Cone(0.2), OXIDE),
    lambda: mdr.Contact(mdr.Cone(0.2), mdr.Homogeneous(OXIDE), zeta=1.2),
    lambda: mdr.State(1.0, 1.0, 1.0, 1.0).pressure(0.0),
    lambda: mdr.Contact(mdr.Cone(0.2), mdr.Homogeneous(OXIDE)).at_depth([1.0, 2.0]).pressure(0.0),
    lambda: mdr.Contact(mdr.Cone(0.2), mdr.Homogeneous(OXIDE)).at_depth([1.0, 2.0]).interior(0.0, 0.0),
]


@pytest.mark.parametrize("number", range(len(WRONG_TYPE)))
def test_things_of_the_wrong_kind(number):
    with pytest.raises(mdr.errors.ArgumentTypeError) as caught:
        WRONG_TYPE[number]()
    assert isinstance(caught.value, TypeError) and str(caught.value)


def test_states_that_do_not_exist(coated):
    for make, words in (
        (lambda: coated.at_depth(-1e-9), r"^depth = -1e-09: without adhesion"),
        (lambda: coated.at_force([1e-3, -1.0]), r"^entry 2 of force = -1: without adhesion"),
        (lambda: coated.at_force([-1.0]), r"^entry 1 of force = -1: without adhesion"),
        (lambda: coated.at_depth(1e-3), r"depth = .*: at radius"),
        (
            lambda: mdr.Contact(mdr.FlatPunch(1.0), mdr.Homogeneous(OXIDE)).at_radius(1.0),
            r"radius = 1: it does not determine a state",
        ),
    ):
        with pytest.raises(mdr.errors.UnreachableError, match=words) as caught:
            make()
        assert isinstance(caught.value, ValueError)


def test_models_outside_their_range():
    """The series of dimitriadis and garcia: under a paraboloid or a sphere, a < h."""
    for model in "dimitriadis", "garcia":
        layer = mdr.Coated(RUBBER, 1.0, mdr.RIGID, model)
        with pytest.raises(mdr.errors.DomainError, match=r"^a = 1.1: .* valid for a < h. For larger contacts use the model exact"):
            layer.modulus(1.1)
        for tip in mdr.Paraboloid(9.0), mdr.Sphere(9.0):
            contact = mdr.Contact(tip, layer)
            assert contact.at_depth(0.1).radius < 1.0
            with pytest.raises(
                mdr.errors.UnreachableError, match=r"^depth = 0.12: .* valid for a < h. For larger contacts use the model exact"
            ):
                contact.at_depth(0.12)
        adhesive = mdr.Contact(tip, layer, work_of_adhesion=1e-3 * RUBBER.E)
        with pytest.raises(
            mdr.errors.UnreachableError, match=r"^depth = 0.12: .* valid for a < h. For larger contacts use the model exact"
        ):
            adhesive.at_depth(0.12)
        for tip in mdr.Cone(0.1), mdr.FlatPunch(0.5), mdr.PowerLaw(4.0, 1.0), mdr.Paraboloid(9.0) + mdr.Cone(0.1):
            with pytest.raises(
                mdr.errors.InvalidArgumentError, match="apply to a paraboloid or a sphere. For other indenters use the model exact"
            ):
                mdr.Contact(tip, layer)
        mdr.Contact(mdr.PowerLaw(2.0, 0.1) + mdr.Paraboloid(9.0), layer)


def test_points_outside_the_domain(coated):
    for make in (
        lambda: coated.at_radius(1e-6).pressure(2e-6),
        lambda: coated.at_radius(1e-6).line_load([0.0, 2e-6]),
        lambda: mdr.Sphere(1.0).height(1.5),
        lambda: mdr.TabulatedProfile([0.0, 1.0, 1.5], [0.0, 1.0, 2.0]).mdr(2.0),
        lambda: mdr.CallableProfile(lambda r: r, 1.0).height(1.1),
        lambda: coated.at_radius(1e-3),
    ):
        with pytest.raises(mdr.errors.DomainError, match="must be at most|defined up to") as caught:
            make()
        assert isinstance(caught.value, ValueError)


def test_nan_is_found_anywhere_in_an_array(coated):
    depth = np.full(1000, 1e-8)
    depth[777] = NAN
    with pytest.raises(mdr.errors.InvalidArgumentError, match="^entry 778 of depth = NaN:"):
        coated.at_depth(depth)


def test_a_number_has_no_first_entry(coated):
    for make, words in (
        (lambda a: coated.medium.modulus(a), "a = -1:"),
        (lambda r: mdr.Cone(0.3).height(r), "r = -1:"),
        (lambda xi: mdr.weights.weight_i0(xi), "xi = -1:"),
    ):
        with pytest.raises(mdr.errors.InvalidArgumentError, match=f"^{words}"):
            make(-1.0)
        with pytest.raises(mdr.errors.InvalidArgumentError, match=f"^entry 1 of {words}"):
            make([-1.0])


class Oops(Exception):
    """What a user's function may raise."""


def _raise(_):
    raise Oops("my own words")


@pytest.mark.parametrize(
    "make",
    [
        lambda f: mdr.CallableProfile(f, 1.0),
        lambda f: mdr.CallableMedium(f, 1.0, 2.0),
        lambda f: mdr.Graded(1.0, f, 0.2),
        lambda f: mdr.Graded(1.0, lambda z: 1.0, f),
    ],
)
def test_exceptions_of_user_functions_arrive_unchanged(make):
    with pytest.raises(Oops, match="my own words"):
        make(_raise)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="must return a real number"):
        make(lambda x: None)
    for bad in (NAN, INF):
        with pytest.raises(mdr.MDRError):
            make(lambda x, bad=bad: bad)
    with pytest.raises(KeyboardInterrupt):
        make(_interrupt)
    # and the library goes on unharmed
    assert mdr.Cone(0.2).height(1.0) == pytest.approx(math.tan(0.2), rel=1e-15)


def _interrupt(_):
    raise KeyboardInterrupt


def test_exceptions_of_a_later_call_arrive_too():
    calls = []

    def fails_at_the_tenth(r):
        calls.append(r)
        if len(calls) == 10:
            raise Oops
        return r * r

    with pytest.raises(Oops):
        mdr.CallableProfile(fails_at_the_tenth, 1.0)
    assert len(calls) == 10


def test_user_functions_are_called_during_creation_only():
    calls = []

    def height(r):
        calls.append(r)
        return r * r

    profile = mdr.CallableProfile(height, 1.0)
    count = len(calls)
    assert count > 0 and all(0.0 <= r <= 1.0 for r in calls)
    profile.mdr(np.linspace(0.0, 1.0, 50))
    mdr.Contact(profile, mdr.Homogeneous(OXIDE)).at_depth(0.1)
    assert len(calls) == count


def test_the_classes_follow_the_table_of_statuses():
    from mdrcontact.errors import error_class

    assert [error_class(i).__name__ for i in range(1, 9)] == [
        "InvalidArgumentError",
        "InvalidArgumentError",
        "DomainError",
        "UnreachableError",
        "NoConvergenceError",
        "OutOfMemoryError",
        "CallbackError",
        "FileError",
    ]
    assert issubclass(mdr.errors.OutOfMemoryError, MemoryError) and issubclass(mdr.errors.FileError, OSError)
