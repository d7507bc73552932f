# SPDX-License-Identifier: GPL-3.0-or-later
"""Adhesion through Python: closed forms, branches, pull-off, loops, fields, exact zeta, accuracy map, the command."""

import csv
import math
import pickle
from pathlib import Path

import numpy as np
import pytest
from conftest import ELASTIC_MODELS, ROOT, numbers_of
from scipy import optimize

import mdrcontact as mdr
from mdrcontact.cli import main
from mdrcontact.closed_forms import (
    adhesive_depth_scale,
    adhesive_radius_scale,
    coated_cone_force,
    coated_paraboloid_adhesive_depth,
    coated_paraboloid_force,
    reduced_adhesive_depth,
)
from mdrcontact.problem import load

GAMMA, R = 0.05, 2.0
BODY = mdr.Homogeneous(mdr.Elastic(3.0, 0.0))
FILM = mdr.Coated(mdr.Elastic(6.0, 0.3), 1.0, mdr.Elastic(1.0, 0.3), "gao")
PROBLEM = ROOT / "examples" / "problems" / "afm_on_pdms.toml"


def jkr(**options):
    return mdr.Contact(mdr.Paraboloid(R), BODY, GAMMA, **options)


def stiff_film(gamma):
    """A cone on a stiff thin coating: two stable segments under force control."""
    film = mdr.Coated(mdr.Elastic(100.0, 0.3), 0.1, mdr.Elastic(1.0, 0.3), "exact")
    return mdr.Contact(mdr.Cone(0.3), film, gamma)


@pytest.mark.parametrize("rule", ["automatic", "paper", "energy"])
def test_jkr_pull_off(rule):
    contact = jkr(adhesion_rule=rule)
    assert contact.pull_off().force == pytest.approx(-1.5 * math.pi * GAMMA * R, rel=1e-10)
    assert contact.pull_off("depth").force == pytest.approx(-5 / 6 * math.pi * GAMMA * R, rel=1e-10)
    assert contact.pull_off("force").others == ()


def test_other_closed_forms():
    E, t = 3.0, math.tan(0.3)
    cone = mdr.Contact(mdr.Cone(0.3), BODY, GAMMA).pull_off()
    assert cone.force == pytest.approx(-54 * GAMMA**2 / (math.pi * E * t**3), rel=1e-10)
    punch = mdr.Contact(mdr.FlatPunch(0.6), BODY, GAMMA).pull_off("depth")
    assert punch.force == pytest.approx(-math.sqrt(8 * math.pi * GAMMA * E * 0.6**3), rel=1e-12)
    for m in (-0.5, 0.0, 0.6):
        graded = mdr.Contact(mdr.Paraboloid(R), mdr.PowerLawGraded(2.0, 0.7, m, 0.3), GAMMA).pull_off()
        assert graded.force == pytest.approx(-0.5 * (m + 3) * math.pi * GAMMA * R, rel=1e-10)


def test_states_match_jkr_on_both_branches():
    a = np.array([0.7, 0.9, 1.5])
    d, F = a**2 / R - np.sqrt(2 * math.pi * a * GAMMA / 3.0), 4 * a**3 / R - np.sqrt(8 * math.pi * a**3 * GAMMA * 3.0)
    contact = jkr()
    for state in (contact.at_radius(a), contact.at_depth(d), contact.at_force(F)):
        np.testing.assert_allclose(state.radius, a, rtol=1e-9)
        np.testing.assert_allclose(state.depth, d, rtol=1e-9)
        np.testing.assert_allclose(state.force, F, rtol=1e-9)
    assert numbers_of(contact.at_depth(0.2, "loading")) == pytest.approx(numbers_of(contact.at_depth(0.2, "unloading")), rel=1e-10)


def jkr_slope(a):
    """theory/paper.md (5.4) with k = 2 E* a, d0 = a^2/R and dl as the root of a."""
    dl = np.sqrt(2 * math.pi * a * GAMMA / 3.0)
    return 6.0 * a - 6.0 * dl / (2 * a / R - dl / (2 * a))


def test_slope_of_jkr():
    contact = jkr()
    states = contact.at_radius(np.geomspace(0.05, 50.0, 31))
    np.testing.assert_allclose(states.slope, jkr_slope(states.radius), rtol=1e-8)
    flat = contact.at_depth(0.0)
    assert flat.slope == pytest.approx(flat.stiffness / 3.0, rel=1e-10)
    ends = [contact.at_radius(contact.pull_off(control).radius) for control in ("force", "depth")]
    assert abs(ends[0].slope) < 1e-9 * ends[0].stiffness and abs(ends[1].slope) > 1e6 * ends[1].stiffness
    assert contact.at_radius(0.9 * ends[0].radius).slope < 0.0


SLOPES = {
    "half-space": BODY,
    "film": FILM.with_model("exact"),
    "soft film": mdr.Coated(mdr.Elastic(0.3, 0.45), 1.0, mdr.Elastic(3.0, 0.3)),
    "Gao": FILM,
    "power law": mdr.PowerLawGraded(1.0, 1.0, 0.3, 0.3),
}
SHAPES = [mdr.Paraboloid(R), mdr.Sphere(3.0), mdr.Cone(0.3), mdr.PowerLaw(4.0, 0.1), mdr.FlatEndedParaboloid(0.2, 3.0)]


@pytest.mark.parametrize("options", [{}, {"adhesion_rule": "paper"}, {"cohesive_stress": 0.05}], ids=str)
@pytest.mark.parametrize("body", SLOPES)
def test_slope_against_differences(body, options):
    """Along the branch, by states close to each other on both sides; near a flat end and on either side of it."""
    if "cohesive_stress" in options and body in ("Gao", "power law"):
        pytest.skip("no range under an effective modulus")
    for shape in SHAPES:
        contact = mdr.Contact(shape, SLOPES[body], 0.01, **options)
        for a in (0.201, 0.25, 0.7, 2.1):
            h = a * np.array([-2.0, -1.0, 1.0, 2.0]) * (1e-4 if a > 0.21 else 1e-5)
            states = contact.at_radius(a + h)
            rise, run = (np.dot([1.0, -8.0, 8.0, -1.0], values) for values in (states.force, states.depth))
            assert contact.at_radius(a).slope == pytest.approx(rise / run, rel=3e-7), (shape, a)


def test_slope_of_bodies_that_attract_each_other_apart():
    """With a range there are states without contact; their force falls as the bodies approach."""
    contact = mdr.Contact(mdr.Paraboloid(3.0), mdr.Homogeneous(mdr.Elastic(1.0, 0.3)), 0.01, cohesive_stress=0.005)
    for depth in (-1.9, -1.0, -0.1, 0.3):
        state, near = contact.at_depth(depth), contact.at_depth(depth + 1e-4 * np.array([-1.0, 1.0]))
        assert (state.radius == 0.0) == (depth < 0.0) == (state.slope < 0.0)
        assert state.slope == pytest.approx(np.ptp(near.force) * np.sign(near.force[1] - near.force[0]) / 2e-4, rel=1e-6)


def test_slope_without_adhesion_is_the_stiffness():
    for body in (BODY, FILM):
        states = mdr.Contact(mdr.Sphere(R), body).at_depth([[0.0, 0.1], [0.2, 0.5]])
        np.testing.assert_array_equal(states.slope, states.stiffness)
    for states in (
        mdr.Contact(mdr.FlatPunch(0.5), FILM, GAMMA).at_depth([-0.01, 0.3]),
        mdr.Contact(mdr.FlatPunch(0.5), FILM).at_depth(0.3),
    ):
        np.testing.assert_array_equal(states.slope, states.stiffness)


def test_slope_at_the_ends():
    """At the rim of a flat end the depth moves before the radius does; at the end of a table states lie on one side."""
    rim = mdr.Contact(mdr.FlatEndedParaboloid(0.2, 3.0), FILM, 0.01)
    assert rim.at_radius(0.2).slope == rim.at_radius(0.2).stiffness
    assert rim.at_radius(0.2 * (1 + 1e-10)).slope == pytest.approx(rim.at_radius(0.2).stiffness, rel=1e-4)
    r = np.linspace(0.0, 1.0, 30)
    table = mdr.Contact(mdr.TabulatedProfile(r, r**2 / 6.0), BODY, 1e-3)
    last, before = table.at_radius(1.0 - 1e-9), table.at_radius(1.0 - 1e-6)
    assert last.slope == pytest.approx((last.force - before.force) / (last.depth - before.depth), rel=1e-5)


def test_slope_is_that_of_a_law():
    contact = mdr.Contact(mdr.Paraboloid(R), FILM.with_model("exact"), GAMMA)
    depth = np.array([-0.01, 0.0, 0.1, 0.5])
    np.testing.assert_allclose(contact.at_depth(depth).slope, mdr.ContactLaw(contact, 1.0).at_depth(depth).slope, rtol=1e-8)


def test_no_adhesion_is_bit_for_bit():
    plain = mdr.Contact(mdr.Paraboloid(R), FILM)
    for rule in ("automatic", "paper", "energy"):
        contact = mdr.Contact(mdr.Paraboloid(R), FILM, 0.0, rule)
        assert numbers_of(contact.at_depth(0.3, "loading")) == numbers_of(plain.at_depth(0.3))
        assert numbers_of(contact.at_force(0.3)) == numbers_of(plain.at_force(0.3))
        assert contact.at_force(0.3).pressure(0.1) == plain.at_force(0.3).pressure(0.1)
    assert plain.pull_off() == (0.0, 0.0, 0.0, 0.0, ())
    loop = plain.loop("force", 0.3, 7)
    assert loop.dissipated_energy == 0.0 and loop.jumps.size == 0 and len(loop.force) == 13


def test_wrong_arguments_are_told():
    contact = jkr()
    for gamma in (-1.0, math.nan, math.inf):
        with pytest.raises(mdr.errors.InvalidArgumentError, match="work_of_adhesion = "):
            mdr.Contact(mdr.Paraboloid(R), BODY, gamma)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="did you mean 'energy'"):
        mdr.Contact(mdr.Paraboloid(R), BODY, GAMMA, "energie")
    with pytest.raises(mdr.errors.InvalidArgumentError, match="did you mean 'unloading'"):
        contact.at_depth(0.1, "unload")
    with pytest.raises(mdr.errors.InvalidArgumentError, match="control = 'spring'"):
        contact.pull_off("spring")
    with pytest.raises(mdr.errors.ArgumentTypeError, match="spring_stiffness"):
        contact.loop("spring", 1.0)
    with pytest.raises(mdr.errors.ArgumentTypeError, match="spring_stiffness"):
        contact.loop("force", 1.0, spring_stiffness=2.0)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="points = 1"):
        contact.loop("force", 1.0, 1)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="largest = "):
        contact.loop("force", math.nan)
    with pytest.raises(mdr.errors.UnreachableError, match="ends at pull-off, force = -0.471238"):
        contact.at_force(-1.0)
    with pytest.raises(mdr.errors.UnreachableError, match="on loading"):
        contact.at_force(-0.1, "loading")


@pytest.mark.parametrize("gamma", [1e-300, 1e-100, 1e100, 1e300, 1.7e308])
def test_extreme_work_gives_an_answer_or_an_error(gamma):
    try:
        force = mdr.Contact(mdr.Paraboloid(R), BODY, gamma).pull_off().force
    except mdr.MDRError:
        return
    assert force == pytest.approx(-1.5 * math.pi * gamma * R, rel=1e-10)


def test_two_stable_states():
    contact = stiff_film(0.0316)
    lowest = contact.pull_off()
    assert len(lowest.others) == 1 and lowest.others[0].force > lowest.force
    small, large = contact.at_force(0.0, "loading"), contact.at_force(0.0)
    assert large.radius > 3 * small.radius
    # fields are those of the requested state
    for state, branch in ((small, "loading"), (large, "unloading")):
        expected = contact.at_radius(state.radius).pressure(0.3 * state.radius)
        assert contact.at_force(0.0, branch).pressure(0.3 * state.radius) == pytest.approx(expected, rel=1e-8)


@pytest.mark.parametrize(("control", "largest", "spring"), [("depth", 0.3, None), ("spring", 0.6, 0.2), ("force", 0.4, None)])
def test_loops(control, largest, spring):
    contact = mdr.Contact(mdr.Paraboloid(5.0), FILM, GAMMA, "energy")
    loop = contact.loop(control, largest, 400, spring_stiffness=spring)
    assert len(loop.position) == len(loop.depth) == len(loop.radius) == len(loop.force)
    assert loop.position[loop.turning_point] == largest and loop.control == control
    assert len(loop.jumps) == 2 and loop.jumps[0] < loop.turning_point < loop.jumps[1]
    np.testing.assert_array_equal(loop.position[loop.jumps], loop.position[loop.jumps + 1])
    assert loop.dissipated_energy > 0.0
    if control != "force":
        # the area of the loop; under force control the bodies fly apart without end
        area = np.sum(0.5 * (loop.force[1:] + loop.force[:-1]) * np.diff(loop.position))
        assert loop.dissipated_energy == pytest.approx(area, rel=1e-3)
    inside = loop.radius > 0
    states = contact.at_radius(loop.radius[inside])
    np.testing.assert_allclose(loop.force[inside], states.force, rtol=1e-9, atol=1e-12)


def flat_ended(shape, unit):
    """A flat-ended indenter with b = 0.1 unit, and its g'(x) sqrt(x^2 - b^2)."""
    b = 0.1 * unit
    if shape == "paraboloid":
        return mdr.FlatEndedParaboloid(b, unit), lambda x: (2 * x**2 - b**2) / unit
    return mdr.FlatEndedCone(b, 0.3), lambda x: math.tan(0.3) * (np.sqrt(x**2 - b**2) * np.arccos(b / x) + b)


@pytest.mark.parametrize("model", ["gao", "exact"])
@pytest.mark.parametrize("shape", ["paraboloid", "cone"])
def test_flat_ends_on_films_in_any_unit(shape, model):
    """Beside the end the states lose the digits of a - b, and in some units of length more than in others."""
    nodes, weights = np.polynomial.legendre.leggauss(40)
    for unit in (1.0, 1e3, 1e-3, 1e-6, 7.0, 1 / 3):
        indenter, slope = flat_ended(shape, unit)
        film = mdr.Coated(mdr.Elastic(1.0, 0.3), 0.4 * unit, mdr.Elastic(3.0, 0.2), model)
        contact, b, gamma = mdr.Contact(indenter, film, 0.02 * unit), 0.1 * unit, 0.02 * unit

        def force(a):
            if model == "exact":
                return float(contact.at_radius(a).force)
            # theory/paper.md (4.2), (5.1): F = 2 int E x g' dx - 2 a E dl, x^2 = b^2 + y^2
            y = np.sqrt(a**2 - b**2) * 0.5 * (1 + nodes)
            x = np.sqrt(b**2 + y**2)
            load = np.sqrt(a**2 - b**2) * (weights @ (film.modulus(x) * slope(x)))
            return load - math.sqrt(8 * math.pi * gamma * film.modulus(a) * a**3)

        found = optimize.minimize_scalar(force, bounds=(2 * b, 10 * b), method="bounded", options={"xatol": 1e-9 * b})
        pull_off = contact.pull_off("force")
        assert pull_off.force == pytest.approx(found.fun, rel=1e-10)
        assert pull_off.radius == pytest.approx(found.x, rel=1e-5)
        (rim,) = pull_off.others
        assert rim.radius == b
        if model == "gao":
            assert rim.force == pytest.approx(-math.sqrt(8 * math.pi * gamma * film.modulus(b) * b**3), rel=1e-12)


@pytest.mark.parametrize("control", ["force", "depth"])
def test_pull_off_lies_where_the_medium_is_defined(control):
    expected = mdr.Contact(mdr.Cone(0.3), mdr.Homogeneous(mdr.Elastic(1.0, 0.0)), work_of_adhesion=GAMMA).pull_off(control)
    for start, reaches in ((0.5, True), (2.0, False)):
        medium = mdr.TabulatedMedium(expected.radius * np.array([start, 10.0, 100.0]), [1.0, 1.0, 1.0])
        contact = mdr.Contact(mdr.Cone(0.3), medium, work_of_adhesion=GAMMA)
        if reaches:
            assert contact.pull_off(control)[:3] == pytest.approx(expected[:3], rel=1e-6)
        else:
            with pytest.raises(mdr.errors.DomainError, match="still stable at the smallest radius"):
                contact.pull_off(control)


def test_jkr_loss():
    loss = jkr().loop("depth", 0.5, 10).dissipated_energy
    assert loss / (GAMMA**5 * R**4 / 9.0) ** (1 / 3) == pytest.approx(7.0922, abs=5e-5)


@pytest.mark.parametrize("model", ["gao", "exact"])
def test_fields(model):
    contact = mdr.Contact(mdr.Paraboloid(5.0), FILM.with_model(model), GAMMA)
    state = contact.at_depth(-0.01)
    a = state.radius
    # p(r) = P(r)/sqrt(a^2 - r^2): with r = a sin(t) the singularity is gone
    t, w = np.polynomial.legendre.leggauss(60)
    t, w = 0.25 * math.pi * (t + 1), 0.25 * math.pi * w
    r = a * np.sin(t)
    force = np.sum(w * 2 * math.pi * r * contact.at_radius(a).pressure(r) * a * np.cos(t))
    assert force == pytest.approx(state.force, rel=1e-6)
    x, wx = 0.5 * a * (np.polynomial.legendre.leggauss(40)[0] + 1), 0.5 * a * np.polynomial.legendre.leggauss(40)[1]
    assert 2 * np.sum(wx * contact.at_radius(a).line_load(x)) == pytest.approx(state.force, rel=1e-9)
    assert contact.at_radius(a).pressure(a) == -math.inf
    inside = np.array([0.0, 0.5, 1.0]) * a
    np.testing.assert_allclose(contact.at_radius(a).displacement(inside), state.depth - inside**2 / 10.0, rtol=1e-9, atol=1e-15)
    # the neck: the surface hangs on the indenter's side and falls back with a vertical tangent
    neck = contact.at_radius(a).displacement(a * np.array([1.0 + 1e-6, 1.01, 1.1, 50.0]))
    assert np.all(neck[:3] > state.depth - (a * np.array([1.0, 1.01, 1.1])) ** 2 / 10.0 - 1e-12)
    assert abs(neck[3]) < 0.1 * abs(neck[0])


def test_figure_2_by_32():
    a_c, d_c = adhesive_radius_scale(R, 0.7, GAMMA), adhesive_depth_scale(R, 0.7, GAMMA)
    at = np.array([0.05, 0.4, 1.0, 2.5])
    for ht in (4, 2, 1, 0.5, 0.25):
        body = mdr.Coated(mdr.Elastic(3 * 1.4, 0.5), ht * a_c, mdr.Elastic(3 * 0.7, 0.5), "gao")
        depth = mdr.Contact(mdr.Paraboloid(R), body, GAMMA, "paper").at_radius(at * a_c).depth
        np.testing.assert_allclose(depth / d_c, reduced_adhesive_depth(at, 2.0, ht), rtol=0, atol=1e-12)
        closed = coated_paraboloid_adhesive_depth(at * a_c, R, 1.4, 0.7, ht * a_c, GAMMA)
        np.testing.assert_allclose(depth, closed, rtol=0, atol=1e-12 * d_c)
    h = coated_paraboloid_force(at, R, 1.4, 0.7, 0.3), coated_cone_force(at, 0.3, 1.4, 0.7, 0.3)
    body = mdr.Coated(mdr.Elastic(3 * 1.4, 0.5), 0.3, mdr.Elastic(3 * 0.7, 0.5), "gao")
    for closed, shape in zip(h, (mdr.Paraboloid(R), mdr.Cone(0.3)), strict=True):
        np.testing.assert_allclose(mdr.Contact(shape, body).at_radius(at).force, closed, rtol=1e-12)
    # theory's figures at at = ht = 1, tau = 2: (32), energy balance with Gao's weights, exact
    found = []
    for model, rule in (("gao", "paper"), ("gao", "energy"), ("exact", "automatic")):
        body = mdr.Coated(mdr.Elastic(4.2, 0.5), a_c, mdr.Elastic(2.1, 0.5), model)
        found.append(mdr.Contact(mdr.Paraboloid(R), body, GAMMA, rule).at_radius(a_c).depth / d_c)
    assert found == pytest.approx([-0.8181, -0.9852, -0.9172], abs=5e-5)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="shear_ratio = 0"):
        reduced_adhesive_depth(1.0, 0.0, 1.0)


@pytest.mark.parametrize("shape", [mdr.Paraboloid(5.0), mdr.Cone(0.2), mdr.FlatEndedCone(0.2, 0.3)], ids=lambda s: type(s).__name__)
def test_exact_zeta(shape):
    """Depths are the exact ones; with the exact E_eff as a table, forces are too: only E_eff is approximate."""
    contact, truth = mdr.Contact(shape, FILM, zeta="exact"), mdr.Contact(shape, FILM.with_model("exact"))
    a = np.array([0.3, 1.0, 7.0])
    np.testing.assert_allclose(contact.at_radius(a).depth, truth.at_radius(a).depth, rtol=1e-6)
    assert abs(contact.at_radius(1.0).force / truth.at_radius(1.0).force - 1) > 0.05
    assert contact.zeta == "exact" and pickle.loads(pickle.dumps(contact)) == contact


@pytest.mark.parametrize("pair", [mdr.Pair(FILM, mdr.Elastic(3.0, 0.2)), mdr.Pair(mdr.RIGID, FILM)], ids=["elastic", "rigid"])
def test_exact_zeta_of_two_bodies(pair):
    a = np.array([0.3, 1.0, 7.0])
    contact, truth = mdr.Contact(mdr.Cone(0.2), pair, zeta="exact"), mdr.Contact(mdr.Cone(0.2), pair.with_model("exact"))
    np.testing.assert_allclose(contact.at_radius(a).depth, truth.at_radius(a).depth, rtol=1e-6)


def test_exact_zeta_refuses():
    with pytest.raises(mdr.errors.InvalidArgumentError, match="one contact radius"):
        mdr.Contact(mdr.FlatPunch(1.0), FILM, zeta="exact")
    with pytest.raises(mdr.errors.InvalidArgumentError, match="approximate"):
        mdr.Contact(mdr.Cone(0.2), BODY, zeta="exact")
    with pytest.raises(mdr.errors.InvalidArgumentError, match="approximate"):
        mdr.Contact(mdr.Cone(0.2), FILM.with_model("exact"), zeta="exact")
    with pytest.raises(mdr.MDRError, match="zeta"):
        mdr.Contact(mdr.Cone(0.2), FILM, zeta="exakt")


def test_accuracy_map():
    result = mdr.accuracy_map([0.5, 1.0, 2.0], [0.3, 1.0])
    assert result.models == ELASTIC_MODELS and result.modulus_error.shape == (len(ELASTIC_MODELS), 3, 2)
    equal = [i for i, name in enumerate(result.models) if name != "hay-crawford"]
    assert np.abs(result.modulus_error[equal, 1]).max() < 1e-9 and np.abs(result.force_error[equal, 1]).max() < 1e-9
    # theory's figures for incompressible bodies, a = h
    known = {"gao": 0.085, "gao-series": -0.024, "doerner-nix": 0.18, "wave": 0.57}
    errors = mdr.accuracy_map(2.0, 1.0, known, coating_nu=0.5, substrate_nu=0.5).modulus_error[:, 0, 0]
    assert errors == pytest.approx(list(known.values()), abs=0.006)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="did you mean"):
        mdr.accuracy_map(2.0, 1.0, ["goa"])


def test_command(tmp_path, capsys):
    table, figure = tmp_path / "loop.csv", tmp_path / "loop.png"
    assert main(["adhesion", str(PROBLEM), "--csv", str(table), "--plot", str(figure)]) == 0
    out = capsys.readouterr().out
    film = mdr.Coated(mdr.Elastic(2e6, 0.5), 1e-6, mdr.Elastic(70e9, 0.23), "exact")
    contact = mdr.Contact(mdr.Paraboloid(2e-6), film, 0.05)
    for control in ("force", "depth"):
        line = next(line for line in out.splitlines() if line.startswith(f"pull-off, {control} prescribed"))
        assert float(line.split()[-1]) == pytest.approx(contact.pull_off(control).force * 1e9, rel=1e-4)
    assert "energy lost in the cycle: 726.9 fJ" in out
    rows = list(csv.reader(table.read_text(encoding="utf-8").splitlines()))
    assert rows[0] == ["way", "position [um]", "depth [um]", "radius [um]", "force [nN]"]
    assert {row[0] for row in rows[1:]} == {"approach", "retraction"}
    assert figure.read_bytes()[:4] == b"\x89PNG"


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (('control = "spring"', 'control = "force"'), "spring_stiffness needs control"),
        (('"50 mJ/m^2"', "0.05"), "has no unit"),
        (('"50 mJ/m^2"', '"-1 J/m^2"'), "work_of_adhesion = '-1 J/m^2': it must be"),
        (('"0.2 N/m"', '"0.2 N"'), "is not a unit of a stiffness"),
        (("[adhesion]", "[adhesive]"), "Did you mean 'adhesion'"),
        (("[adhesion]", '[adhesion]\nadhesion_rule = "energi"'), "Did you mean 'energy'"),
    ],
)
def test_wrong_problem_files(change, words, tmp_path, capsys):
    path = Path(tmp_path / "problem.toml")
    path.write_text(PROBLEM.read_text(encoding="utf-8").replace(*change), encoding="utf-8")
    assert main(["adhesion", str(path)]) == 2
    assert words in capsys.readouterr().err


def test_the_adhesion_rule_of_a_problem_file(tmp_path):
    text = PROBLEM.read_text(encoding="utf-8").replace("[adhesion]", '[adhesion]\nadhesion_rule = "paper"')
    path = Path(tmp_path / "problem.toml")
    path.write_text(text, encoding="utf-8")
    assert load(path).contact().adhesion_rule == "paper"
    assert load(PROBLEM).contact().adhesion_rule == "automatic"


def test_command_needs_adhesion(capsys):
    assert main(["adhesion", str(ROOT / "examples" / "problems" / "sio2_on_si.toml")]) == 2
    assert "[adhesion] is missing" in capsys.readouterr().err


@pytest.mark.parametrize("slope", [-0.7, -0.3, 0.3, 1.0, 3.0])
def test_kinks_of_a_modulus(slope):
    """E = 1 + a + slope*(a - b) beyond b: the slope of the kink was noise, and the pull-off force with it up to 21 % off."""
    R, gamma, rng, refused = 50.0, 0.02, np.random.default_rng(7), 0
    for b in 10 ** rng.uniform(-1.3, 0.7, 12):
        a = np.concatenate([np.geomspace(1e-3, b * (1 - 1e-9), 20000), np.geomspace(b * (1 + 1e-9), 9.9, 20000)])
        beyond = np.maximum(a - b, 0.0)
        E, rise = 1.0 + a + slope * beyond, 1.0 + slope * (a > b)
        F0 = 4.0 / R * (a**3 / 3.0 + a**4 / 4.0 + slope * np.where(a > b, (a**4 - b**4) / 4.0 - b * (a**3 - b**3) / 3.0, 0.0))
        force = F0 - 2.0 * a * E * np.sqrt(2.0 * np.pi * a * gamma / (E + a * rise))
        medium = mdr.CallableMedium(lambda x, b=b: 1.0 + x + slope * max(x - b, 0.0), 1e-3, 10.0)
        try:
            contact = mdr.Contact(mdr.Paraboloid(R), medium, work_of_adhesion=gamma, adhesion_rule="energy")
        except mdr.errors.NoConvergenceError as error:
            assert "kink" in str(error)
            assert float(str(error).split("radius = ")[1].split(":")[0]) == pytest.approx(b, rel=1e-5)
            refused += 1
            continue
        assert contact.pull_off("force").force == pytest.approx(force.min(), rel=1e-6)
    assert refused < 12 if slope < 0.0 else refused == 12


@pytest.mark.parametrize("gamma", [0.001, 0.03, 0.1, 0.3])
@pytest.mark.parametrize("model", ["exact", "gao-power", "doerner-nix"])
def test_spheres_up_to_their_equator(gamma, model):
    """Where the slope is infinite, samples miss the contact: no jump. Pull-off is the lowest force of all radii."""
    film = mdr.Coated(mdr.Elastic(0.0629, 0.0), 0.17, mdr.Elastic(0.879, 0.0), model)
    contact = mdr.Contact(mdr.Sphere(6.375), film, work_of_adhesion=gamma)
    radii = np.geomspace(0.02, 6.3, 400)
    lowest = optimize.minimize_scalar(
        lambda a: float(contact.at_radius(a).force),
        bounds=(radii[(i := int(contact.at_radius(radii).force.argmin())) - 1], radii[i + 1]),
        method="bounded",
        options={"xatol": 1e-8},
    )
    assert contact.pull_off("force").force == pytest.approx(lowest.fun, rel=1e-8)
