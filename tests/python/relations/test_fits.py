# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits against the parameters that made their data."""

import pickle

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st

import mdrcontact as mdr
import mdrcontact.instruments as mdi

from . import draws as d
from .harness import near, relation, same

guesses = d.between(0.6, 1.6)
films = st.builds(mdr.Elastic, d.between(0.3, 3.0), st.floats(0.1, 0.45))
"""Whose modulus differs from that of the base, which is 1."""
BASE = mdr.Elastic(1.0, 0.3)
models = st.sampled_from(["exact", "gao-series", "hay-crawford", "perriot-barthel"])
DEPTHS = np.linspace(0.01, 0.2, 15)


def found(data, indenter, start, name="coating.E", **options):
    result = mdi.fit(data, indenter, start, [name], check_units=False, **options)
    return float(result.estimates[name]), result


@relation(30, film=films, h=d.lengths, model=models, guess=guesses)
def test_force_and_depth(film, h, model, guess):
    """The modulus of the film from F(d) of the contact, against the one that made it."""
    medium = mdr.Coated(film, h, BASE, model)
    force = mdr.Contact(mdr.Paraboloid(h), medium).at_depth(DEPTHS * h).force
    start = medium.replace(coating=film.replace(E=film.E * guess))
    value, _ = found(mdi.ForceDepth(DEPTHS * h, force, relative_sd=0.01), mdr.Paraboloid(h), start)
    near(value, film.E, 1e-6)


@relation(30, film=films, h=d.lengths, model=models, guess=guesses, kind=st.sampled_from(["modulus", "stiffness"]))
def test_radius(film, h, model, guess, kind):
    """The modulus of the film from E_eff(a) or k(a), against the one that made it."""
    medium, a = mdr.Coated(film, h, BASE, model), np.linspace(0.05, 0.8, 12) * h
    data = {"modulus": mdi.ModulusRadius, "stiffness": mdi.StiffnessRadius}[kind](a, getattr(medium, kind)(a), relative_sd=0.01)
    value, _ = found(data, mdr.Paraboloid(h), medium.replace(coating=film.replace(E=film.E * guess)))
    near(value, film.E, 1e-6)


@relation(30, material=films, guess=guesses, R=d.lengths)
def test_stiffness_and_depth_of_a_half_space(material, guess, R):
    """The modulus of a half-space from P and S at depths, epsilon being that of a paraboloid, against the one that made them."""
    state = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(material)).at_depth(DEPTHS * R)
    data = mdi.StiffnessDepth(state.depth, state.force, state.stiffness, relative_sd=0.01)
    value, _ = found(data, mdr.Paraboloid(R), mdr.Homogeneous(material.replace(E=material.E * guess)), "E")
    near(value, material.E, 1e-6)


@relation(20, film=films, h=d.lengths, guess=guesses, order=st.permutations(range(15)))
def test_order_of_the_data(film, h, guess, order):
    """A fit of the points in another order against the fit."""
    medium = mdr.Coated(film, h, BASE)
    force = mdr.Contact(mdr.Paraboloid(h), medium).at_depth(DEPTHS * h).force * (1.0 + 0.01 * np.sin(37.0 * np.arange(15)))
    start = medium.replace(coating=film.replace(E=film.E * guess))
    values, errors = [], []
    for rows in (np.arange(15), np.array(order)):
        data = mdi.ForceDepth(DEPTHS[rows] * h, force[rows], relative_sd=0.01, branch="loading")
        value, result = found(data, mdr.Paraboloid(h), start)
        values.append(value)
        errors.append(float(np.sqrt(np.diag(np.atleast_2d(result.covariance))[0])))
    near(values[1], values[0], 1e-6)
    near(errors[1], errors[0], 1e-4)


@relation(20, film=films, h=d.lengths, guess=guesses, unit=st.tuples(d.between(1e-9, 1e3), d.between(1e-3, 1e12)))
def test_units_of_fits(film, h, guess, unit):
    """A fit in other units of length and modulus, with its standard error."""
    s, t = unit
    answers = []
    for m, n in ((1.0, 1.0), (s, t)):
        medium = mdr.Coated(film.replace(E=film.E * n), h * m, BASE.replace(E=n))
        force = mdr.Contact(mdr.Paraboloid(h * m), medium).at_depth(DEPTHS * h * m).force
        force = force * (1.0 + 0.01 * np.sin(37.0 * np.arange(15)))
        start = medium.replace(coating=film.replace(E=film.E * n * guess))
        value, result = found(mdi.ForceDepth(DEPTHS * h * m, force, relative_sd=0.01), mdr.Paraboloid(h * m), start)
        answers.append((value / n, float(np.sqrt(np.diag(np.atleast_2d(result.covariance))[0])) / n))
    near(answers[1], answers[0], 1e-5)


@relation(20, film=films, h=d.lengths, R=guesses, offset=st.floats(-0.02, 0.02))
def test_two_parameters(film, h, R, offset):
    """Modulus and depth offset together against those that made the data."""
    medium = mdr.Coated(film, h, BASE)
    force = mdr.Contact(mdr.Paraboloid(h), medium).at_depth(DEPTHS * h).force
    data = mdi.ForceDepth((DEPTHS + offset) * h, force, sd=0.01 * float(force[-1]))
    start = medium.replace(coating=film.replace(E=film.E * R))
    result = mdi.fit(data, mdr.Paraboloid(h), start, ["coating.E", "depth_offset"], check_units=False)
    assume(result.converged)
    near(result.estimates["coating.E"], film.E, 1e-5)
    near(result.estimates["depth_offset"], offset * h, 1e-5, size=0.2 * h)


@relation(15, film=films, h=d.lengths, work=d.between(1e-4, 1e-2))
def test_adhesion(film, h, work):
    """The work of adhesion from the unloading branch against the one that made it."""
    medium = mdr.Coated(film, h, BASE, "gao-series")
    contact = mdr.Contact(mdr.Paraboloid(h), medium, work * h)
    depth = DEPTHS[3:] * h
    data = mdi.ForceDepth(
        depth, contact.at_depth(depth).force, sd=0.01 * float(contact.at_depth(depth[-1]).force), branch="unloading"
    )
    value, _ = found(
        data, mdr.Paraboloid(h), medium, "work_of_adhesion", instrument=mdi.Instrument(work_of_adhesion=1.3 * work * h)
    )
    near(value, work * h, 1e-4)


@relation(15, G=d.between(0.3, 3.0), g=d.between(0.3, 3.0), tau=d.between(0.3, 3.0), guess=d.between(0.8, 1.25), R=d.lengths)
def test_relaxation(G, g, tau, guess, R):
    """The time constant of a half-space from F(t) under a ramp and a hold against the one that made it."""
    t = np.linspace(0.0, 5.0, 40)
    depth = 0.05 * R * np.minimum(t, 1.0)
    material = mdr.Viscoelastic(G, [(g, tau)], nu=0.4)
    force = mdr.Contact(mdr.Paraboloid(R), mdr.Homogeneous(material)).history(t, depth=depth).force
    start = mdr.Homogeneous(mdr.Viscoelastic(G, [(g, tau * guess)], nu=0.4))
    value, _ = found(mdi.ForceTime(t, depth, force, sd=0.01 * float(force.max())), mdr.Paraboloid(R), start, "terms[0].time")
    near(value, tau, 1e-3)


@relation(15, film=films, h=d.lengths)
def test_copies_of_models_predict_the_same(film, h):
    """Predictions of a fit against the contact with the estimates."""
    medium = mdr.Coated(film, h, BASE)
    contact = mdr.Contact(mdr.Paraboloid(h), medium)
    _, result = found(mdi.ForceDepth(DEPTHS * h, contact.at_depth(DEPTHS * h).force, relative_sd=0.01), mdr.Paraboloid(h), medium)
    fitted = mdr.Contact(result.indenter, result.medium).at_depth(DEPTHS * h).force
    near(fitted, contact.at_depth(DEPTHS * h).force, 1e-7)
    same(len(result.estimates), 1)


FILMS = {
    "oxide on silicon": (mdr.Elastic(72e9, 0.17), mdr.Elastic(163e9, 0.22)),
    "polymer on silicon": (mdr.Elastic(3e9, 0.35), mdr.Elastic(163e9, 0.22)),
    "tungsten on glass": (mdr.Elastic(410e9, 0.28), mdr.Elastic(70e9, 0.2)),
    "TiN on steel": (mdr.Elastic(450e9, 0.25), mdr.Elastic(210e9, 0.3)),
    "gold on glass": (mdr.Elastic(78e9, 0.42), mdr.Elastic(70e9, 0.2)),
}
tips = st.sampled_from([mdr.Berkovich(), mdr.AreaFunction([24.5, 300e-9], max_height=5e-6), mdr.Paraboloid(2e-6)])


@relation(20, name=st.sampled_from(sorted(FILMS)), tip=tips, h=d.between(2e-7, 5e-6), guess=guesses)
def test_stiffness_and_depth_of_films(name, tip, h, guess):
    """The modulus of a film from P and S of the exact contact at depths of 0.04 to 0.3 h, against the one that made them."""
    film, base = FILMS[name]
    depth = np.linspace(0.04, 0.3, 12) * h
    state = mdr.Contact(tip, mdr.Coated(film, h, base)).at_depth(depth)
    data = mdi.StiffnessDepth(state.depth, state.force, state.stiffness, relative_sd=0.01)
    start = mdr.Coated(film.replace(E=film.E * guess), h, base)
    near(mdi.fit(data, tip, start, ["coating.E"]).estimates["coating.E"], film.E, 1e-2)


@relation(10, film=films, h=d.lengths)
def test_fits_pickle(film, h):
    """A fit, pickled and loaded, against itself; with errors given for data without noise it has no doubt about the model."""
    medium = mdr.Coated(film, h, BASE)
    force = mdr.Contact(mdr.Paraboloid(h), medium).at_depth(DEPTHS * h).force
    _, result = found(mdi.ForceDepth(DEPTHS * h, force, relative_sd=0.01), mdr.Paraboloid(h), medium)
    assert "MISSES" not in result.summary()
    again = pickle.loads(pickle.dumps(result))
    same([*again.estimates.values()], [*result.estimates.values()])
    same(again.covariance, result.covariance)
    assert again.summary() == result.summary()
