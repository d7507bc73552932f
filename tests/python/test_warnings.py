# SPDX-License-Identifier: GPL-3.0-or-later
"""States beyond linear elasticity and moduli in two units: a warning each, once for a contact, and none where there is no need."""

import pickle
import warnings

import numpy as np
import pytest

import mdrcontact as mdr
from mdrcontact.cli import main

HALF_SPACE = mdr.Homogeneous(mdr.Elastic(1.0, 0.3))
GEL = mdr.Coated(mdr.Elastic(1e3, 0.49), 1e-6, mdr.RIGID)
SPHERE = mdr.Sphere(10e-6)

CASES = {
    "depth beyond the film on a rigid base": (mdr.Contact(SPHERE, GEL), "depth", 1.5e-6, "compressed by 1.5e-06"),
    "a paraboloid at 3.2 R": (mdr.Contact(mdr.Paraboloid(1.0), HALF_SPACE), "radius", 3.2, "slope of 3.2"),
    "30 times the modulus": (mdr.Contact(mdr.FlatPunch(1.0), HALF_SPACE), "force", 30.0 * np.pi, "27.3 times"),
}


@pytest.mark.parametrize("case", CASES)
def test_each_warns_once(case):
    contact, given, value, words = CASES[case]
    contact = pickle.loads(pickle.dumps(contact))
    with pytest.warns(mdr.errors.LargeStrainWarning, match=words) as seen:
        state = getattr(contact, f"at_{given}")(value)
        getattr(contact, f"at_{given}")([0.5 * value, 1.01 * value, 2.0 * value])
    assert len(seen) == 1
    assert len(state.warnings()) == 1 and words in state.warnings()[0]


def test_the_deepest_of_an_array_warns():
    contact = mdr.Contact(mdr.Paraboloid(1.0), HALF_SPACE)
    with pytest.warns(mdr.errors.LargeStrainWarning, match="contact radius 3"):
        contact.at_radius(np.array([[0.1, 3.0], [0.2, 0.3]]))


def test_gpa_beside_pa():
    contact = mdr.Contact(SPHERE, mdr.Coated(mdr.Elastic(72.0, 0.17), 5e-7, mdr.Elastic(163e9, 0.22)))
    with pytest.warns(mdr.errors.UnitsWarning, match=r"from 72 to 1\.63e\+11") as seen:
        contact.at_depth(1e-9)
        contact.at_depth(2e-9)
    assert len(seen) == 1


@pytest.mark.parametrize("z", [[0.0, 1e-6], [0.0, 0.5e-6, 1e-6]])
def test_gpa_beside_pa_in_a_graded_body(z):
    young = np.geomspace(1.0, 2e9, len(z))
    with pytest.warns(mdr.errors.UnitsWarning, match=r"from [\d.]+ to [\d.]+e\+09"):
        mdr.Contact(SPHERE, mdr.Graded(z, young, 0.3, model="gao-series")).at_depth(1e-9)


def test_laws_and_loops_warn():
    with pytest.warns(mdr.errors.LargeStrainWarning, match="compressed"):
        mdr.ContactLaw(mdr.Contact(SPHERE, GEL), 1e-6)
    with pytest.warns(mdr.errors.LargeStrainWarning, match="compressed"):
        mdr.Contact(SPHERE, GEL, work_of_adhesion=1e-5).loop("depth", 1e-6, 10)


@pytest.mark.filterwarnings("error")
def test_ordinary_contacts_do_not_warn():
    silicon, steel = mdr.Elastic(163e9, 0.22), mdr.Elastic(210e9, 0.3)
    for film, base, depth in [
        (mdr.Elastic(72e9, 0.17), silicon, 1e-6),
        (mdr.Elastic(5e9, 0.4), steel, 1e-7),
        (mdr.Elastic(1000e9, 0.1), mdr.Elastic(3e9, 0.4), 2e-6),
    ]:
        for tip in (SPHERE, mdr.Cone(0.35)):
            mdr.Contact(tip, mdr.Coated(film, 500e-9, base)).at_depth([0.0, 1e-9, depth])
    mdr.Contact(SPHERE, mdr.Coated(mdr.Elastic(1e3, 0.49), 1e-4, mdr.Elastic(70e9, 0.2))).at_depth(1e-6)
    # a stiff film on a polymer is bent by a pressure that strains it little
    bent = mdr.Coated(mdr.Elastic(1000e9, 0.1), 500e-9, mdr.Elastic(3e9, 0.4))
    state = mdr.Contact(mdr.Cone(0.85), bent).at_depth(2e-6)
    assert state.force / (np.pi * state.radius**2) > 0.6 * state.stiffness / (2.0 * state.radius)
    # an adhesive contact under no force presses in the middle what it pulls at the edge: it is carried by the base
    adhesive = mdr.Coated(mdr.Elastic(100.0, 0.3), 0.1, mdr.Elastic(1.0, 0.3))
    mdr.Contact(mdr.Cone(0.3), adhesive, work_of_adhesion=0.0316).at_force(0.0)
    on_gel = mdr.Pair(mdr.Coated(mdr.Elastic(1e9, 0.3), 1e-6, mdr.RIGID), mdr.Homogeneous(mdr.Elastic(1e6, 0.49)))
    mdr.Contact(mdr.Paraboloid(1e-3), on_gel).at_depth(5e-6)


@pytest.mark.filterwarnings("error")
def test_a_search_does_not_warn_of_what_it_looks_at():
    tin = mdr.Coated(mdr.Elastic(450e9, 0.25), 2e-6, mdr.Elastic(210e9, 0.3))
    contact = mdr.Contact(mdr.Paraboloid(20e-6), tin)
    (failure,) = contact.first_failure({"von_mises": [None, 1e9]})
    assert float(failure.state.radius) < 20e-6


def test_the_command_line_prints_it_once(tmp_path, capsys):
    path = tmp_path / "gel.toml"
    path.write_text(
        '[indenter]\nshape = "sphere"\nradius = "10 um"\n[medium]\ntype = "coated"\nsubstrate = "rigid"\n'
        '[medium.coating]\nE = "1 kPa"\nnu = 0.49\nthickness = "1 um"\n[compute]\nmax_depth = "900 nm"\npoints = 20\n'
    )
    assert main(["curve", str(path)]) == 0
    assert capsys.readouterr().err.count("would be compressed by") == 1


def test_every_warning_of_the_package_has_one_base():
    for name in mdr.errors.__all__:
        kind = getattr(mdr.errors, name)
        assert issubclass(kind, mdr.MDRWarning if name.endswith("Warning") else mdr.MDRError)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", mdr.MDRWarning)
        mdr.Contact(mdr.Paraboloid(1.0), HALF_SPACE).at_radius(9.0)
