# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects: printing, pickling, comparing, copying, their end, and threads."""

import copy
import gc
import pickle
import weakref
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from conftest import OXIDE, PUBLIC, RUBBER, SILICON, every_medium, every_profile, numbers_of

import mdrcontact as mdr
from mdrcontact.instruments.fitting.conduction import ConductanceForce, Impedance
from mdrcontact.instruments.fitting.rate_curves import RateCurve
from mdrcontact.lateral import Voxels

OBJECTS = [
    OXIDE,
    mdr.RIGID,
    *every_profile(),
    *every_medium(),
    mdr.Contact(mdr.Berkovich(), mdr.Coated(OXIDE, 5e-7, SILICON)),
    mdr.Contact(mdr.Cone(0.2), mdr.Homogeneous(OXIDE), zeta=([1e-9, 1e-6, 1e-3], [1.1, 1.15, 1.2])),
]


def _name(thing):
    return f"{type(thing).__name__}-{getattr(thing, 'model', '')}"


# a function has no text that rebuilds it
@pytest.mark.parametrize("thing", [thing for thing in OBJECTS if "<function" not in repr(thing)], ids=_name)
def test_repr_rebuilds(thing):
    names = {}
    exec("from mdrcontact import *", names)
    assert eval(repr(thing), names) == thing


@pytest.mark.parametrize("thing", OBJECTS, ids=_name)
def test_pickle_and_copy(thing):
    for other in (pickle.loads(pickle.dumps(thing)), copy.copy(thing), copy.deepcopy(thing)):
        assert other == thing
        assert hash(other) == hash(thing)
    if isinstance(thing, mdr.Contact):
        again = pickle.loads(pickle.dumps(thing))
        assert again.at_depth(1e-8) == thing.at_depth(1e-8)


def test_different_objects_differ():
    for i, one in enumerate(OBJECTS):
        for other in OBJECTS[:i]:
            assert one != other
    assert mdr.Cone(0.2) != 0.2
    assert mdr.Cone(half_angle=70.0, degrees=True) == mdr.Cone(half_angle=70.0, degrees=True)


def test_objects_of_arrays_are_equal_to_themselves_only():
    contact = mdr.Contact(mdr.Paraboloid(1.0), mdr.Homogeneous(OXIDE))
    time = np.arange(40.0)
    pairs = [
        [ConductanceForce([1.0, 2.0], values, contact) for values in ([1.0, 2.0], [3.0, 4.0])],
        [Impedance([1.0, 2.0], values, 1.0) for values in ([1.0, 2.0j], [3.0, 4.0j])],
        [RateCurve(time, time, force) for force in (time, 2.0 * time)],
        [Voxels(np.full((1, 1, 1), i), [OXIDE, RUBBER], 1.0, below=SILICON) for i in (0, 1)],
    ]
    for one, other in pairs:
        assert one == one
        assert one != other
        assert one not in [other]


def test_objects_never_change():
    cone = mdr.Cone(0.2)
    with pytest.raises(AttributeError, match="cannot assign"):
        cone.inclination = 0.3
    assert cone.replace(inclination=0.3) == mdr.Cone(0.3)
    coated = mdr.Coated(OXIDE, 5e-7, SILICON, "doerner-nix", alpha=0.9)
    assert coated.replace(thickness=1e-6) == mdr.Coated(OXIDE, 1e-6, SILICON, "doerner-nix", alpha=0.9)
    assert coated.with_model("gao") == mdr.Coated(OXIDE, 5e-7, SILICON, "gao")
    assert (coated.alpha, coated.model, coated.thickness) == (0.9, "doerner-nix", 5e-7)
    with pytest.raises(AttributeError, match="no attribute 'wave_factor'"):
        coated.wave_factor  # noqa: B018
    assert "alpha" in dir(coated)


def test_sums_are_flat_and_commute_in_value():
    a, b, c = mdr.Cone(0.1), mdr.Paraboloid(1e-5), mdr.PowerLaw(3.0, 1e10)
    assert (a + b) + c == a + (b + c) == mdr.SumProfile([a, b, c])
    r = np.array([1e-8, 1e-6])
    assert (a + b).height(r) == pytest.approx(a.height(r) + b.height(r), rel=1e-14)
    assert (a + b).mdr(r) == pytest.approx(a.mdr(r) + b.mdr(r), rel=1e-14)
    with pytest.raises(TypeError):
        a + 1.0


def test_rigid_is_one_object():
    assert pickle.loads(pickle.dumps(mdr.RIGID)) is mdr.RIGID
    assert mdr.Coated(RUBBER, 1e-6, mdr.RIGID, "garcia").substrate is mdr.RIGID


def test_a_contact_outlives_its_parts():
    contact = mdr.Contact(mdr.Sphere(1e-5), mdr.Coated(mdr.Elastic(72e9, 0.17), 5e-7, mdr.Elastic(163e9, 0.22)))
    expected = numbers_of(contact.at_depth(1e-8))
    part = weakref.ref(contact)
    gc.collect()
    junk = [mdr.Sphere(1e-5 * (1 + i)) for i in range(1000)]
    del junk
    gc.collect()
    assert numbers_of(contact.at_depth(1e-8)) == expected
    del contact
    gc.collect()
    assert part() is None


def test_no_memory_is_lost():
    import resource

    def work(count):
        for _ in range(count):
            contact = mdr.Contact(mdr.Sphere(1e-5), mdr.TabulatedMedium([1e-8, 1e-7, 1e-5], [1e9, 2e9, 3e9]))
            contact.at_depth(np.full(10, 1e-8))
            with pytest.raises(mdr.MDRError):
                contact.at_depth(np.nan)

    work(200)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    work(2000)
    after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    # [KiB]; one lost table handle a time would be several MiB
    assert after - before < 1500


def test_threads_share_objects(coated):
    depths = [np.linspace(1e-9, 1e-7, 60) * (1 + i / 50) for i in range(24)]
    expected = [coated.at_depth(d) for d in depths]
    with ThreadPoolExecutor(8) as pool:
        for found, wanted in zip(pool.map(coated.at_depth, depths), expected, strict=True):
            assert found == wanted


def test_threads_get_their_own_errors(coated):
    def fail(i):
        with pytest.raises(mdr.errors.UnreachableError) as caught:
            coated.at_depth(-float(i))
        return str(caught.value)

    with ThreadPoolExecutor(8) as pool:
        for i, words in enumerate(pool.map(fail, range(1, 400)), start=1):
            assert f"depth = -{i}: " in words


def test_threads_make_objects_with_callbacks():
    def make(i):
        return mdr.CallableProfile(lambda r: i * r * r, 1.0).height(0.5)

    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(make, range(1, 40))) == pytest.approx([i / 4 for i in range(1, 40)], rel=1e-12)


def test_the_version_has_one_source():
    from importlib import metadata

    assert metadata.version("mdrcontact") == mdr.__version__


def test_everything_public_says_what_it_is():
    for name, thing in ((name, getattr(package, name)) for package in PUBLIC for name in package.__all__):
        assert name in ("RIGID", "CRYSTALS") or thing.__doc__, name
        for member in vars(thing) if isinstance(thing, type) else ():
            if not member.startswith("_") and callable(getattr(thing, member)):
                assert getattr(thing, member).__doc__, f"{name}.{member}"
