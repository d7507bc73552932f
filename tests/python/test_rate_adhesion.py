# SPDX-License-Identifier: GPL-3.0-or-later
"""Works of adhesion that depend on the speed of the edge: reference rows, limits, scaling, conservation of energy."""

from __future__ import annotations

import csv
import math
import warnings

import numpy as np
import pytest
from conftest import ROOT

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.adhesion import RateAdhesion
from mdrcontact.cli import main

TIP = mdr.Paraboloid(1.0)
HALF_SPACE = mdr.Homogeneous(mdr.Elastic(1.0, 0.0))
BODIES = {
    "homogeneous E*=1 paraboloid R=1": HALF_SPACE,
    "film h=1 E=1 nu=.5 on E=100 nu=.3 paraboloid R=1": mdr.Coated(mdr.Elastic(1.0, 0.5), 1.0, mdr.Elastic(100.0, 0.3)),
    "film h=1 E=10 nu=.3 on E=1 nu=.3 paraboloid R=1": mdr.Coated(mdr.Elastic(10.0, 0.3), 1.0, mdr.Elastic(1.0, 0.3)),
}
LAW = {"w0": "work", "v0": "speed", "n": "exponent", "wc": "closing_work", "vc": "closing_speed", "nc": "closing_exponent"}
RUBBER = mdr.Viscoelastic(0.5, [(4.5, 0.1)], nu=0.0)
"""1/E* = 0.1 + 0.9 (1 - exp(-t))."""

pytestmark = pytest.mark.filterwarnings("ignore::mdrcontact.errors.LargeStrainWarning")


def rows(kind):
    with (ROOT / "tests" / "data" / "adhesion_time.csv").open() as file:
        table = csv.DictReader(line for line in file if not line.startswith("#"))
        found = [row for row in table if row["kind"] == kind]
    for row in found:
        words = dict(word.split("=") for word in row["inputs"].split(";"))
        row["inputs"] = {key: value if key in ("control", "start") else float(value) for key, value in words.items()}
    return [pytest.param(row, id=f"{kind}-{i}") for i, row in enumerate(found)]


def contact_of(row):
    law = {LAW[key]: value for key, value in row["inputs"].items() if key in LAW}
    return mdr.Contact(TIP, BODIES[row["body"]], adhesion=RateAdhesion(**law))


def area(x, y):
    return np.sum(0.5 * (y[1:] + y[:-1]) * np.diff(x))


def met(row, found):
    assert found == pytest.approx(float(row["value"]), rel=10.0 * float(row["accuracy"]))


@pytest.mark.parametrize("row", rows("rate_pull_off"))
def test_pull_off_rows(row):
    given, contact = row["inputs"], contact_of(row)
    state = contact.at_radius(given["start_radius"])
    start, spring = state.depth, given.get("spring")
    if spring:
        start += state.force / spring
    time = (start + 4.0) / given["speed"]
    control = {"position": [start, -4.0], "spring_stiffness": spring} if spring else {"depth": [start, -4.0]}
    end = mdr.adhesion.rate_history(contact, [0.0, time], **control, start={"radius": given["start_radius"]}).end
    met(row, end["lowest_force" if row["quantity"] == "F_min" else "lowest_time"])


@pytest.mark.parametrize("row", rows("rate_dead_load"))
def test_dead_load_rows(row):
    contact = contact_of(row)
    force = [row["inputs"]["F"]] * 2
    end = mdr.adhesion.rate_history(
        contact, [0.0, 1e4], force=force, start={"radius": row["inputs"]["start_radius"]}, tolerance=1e-11
    ).end
    met(row, end["rupture_time"])


@pytest.mark.parametrize("row", rows("rate_cycle"))
def test_cycle_rows(row):
    contact, given = contact_of(row), row["inputs"]
    ramp, depth = given["depth"] / given["speed"], given["depth"]
    time = np.array([0.0, ramp, ramp + given["dwell"], 2.0 * ramp + given["dwell"] + 300.0])
    found = mdr.adhesion.rate_history(contact, time, depth=[0.0, depth, depth, -0.3])
    places = {"radius_end_of_approach": found.radius[1], "force_end_of_approach": found.force[1]}
    met(row, {**places, "force_end_of_dwell": found.force[2]}[row["quantity"]])
    assert found.work[-1] == pytest.approx(found.dissipated[-1], rel=1e-8)
    # and by the trapezoidal rule of the force itself
    fine = np.interp(np.linspace(0.0, time[-1], 40001), time, [0.0, depth, depth, -0.3])
    path = mdr.adhesion.rate_history(contact, np.linspace(0.0, time[-1], 40001), depth=fine)
    assert area(fine, path.force) == pytest.approx(found.work[-1], rel=1e-4)


# tests/unit/extensions/adhesion/test_rate_adhesion.pf has 27 rows of the steady crack, to 1e-12: they give the compliance, not the
# modulus.
@pytest.mark.parametrize("medium", [*BODIES.values(), mdr.Coated(mdr.Elastic(5.0, 0.4), 1.0, mdr.Elastic(1.0, 0.3), model="gao")])
def test_slow_edges_are_in_equilibrium(medium):
    """V -> 0: both pull-offs of the contact at rest, and the states on the way."""
    rate = RateAdhesion(0.02, 1e-3, 1.0)
    contact = mdr.Contact(TIP, medium, adhesion=rate)
    rest = mdr.Contact(TIP, medium, work_of_adhesion=0.02)
    first = rest.at_depth(0.5)
    pulled = rest.pull_off("depth")
    depth = np.linspace(0.5, pulled.depth * 0.5, 50)
    slow = mdr.adhesion.rate_history(contact, np.linspace(0.0, 1e9, 50), depth=depth, start="rest")
    assert slow.radius[0] == pytest.approx(first.radius, rel=1e-10)
    assert slow.force == pytest.approx(rest.at_depth(depth).force, rel=2e-5, abs=2e-5 * abs(pulled.force))
    end = mdr.adhesion.rate_history(contact, [0.0, 1e10], depth=[0.5, 3.0 * pulled.depth], start="rest").end
    lowest = min(np.min(rest.at_depth(np.linspace(0.5, pulled.depth, 2001)).force), pulled.force)
    assert end["lowest_force"] == pytest.approx(lowest, rel=1e-3)


@pytest.mark.parametrize(("p", "n"), [(2, 0.33), (2, 0.6), (3, 0.33), (3, 0.6)])
def test_fast_edges_scale(p, n):
    """Under depth control F ~ V^(n (1 + p)/(2 p - 1 + n (p - 1))) for a profile r^p, once V is far above the law's speed."""
    tip = TIP if p == 2 else mdr.PowerLaw(3.0, 1.0)
    contact = mdr.Contact(tip, HALF_SPACE, adhesion=RateAdhesion(1e-9, 1e-3, n))
    forces = []
    for speed in (30.0, 300.0):
        start = contact.at_radius(30.0).depth
        forces.append(
            mdr.adhesion.rate_history(contact, [0.0, 2.0 * start / speed], depth=[start, -start], start={"radius": 30.0}).end[
                "lowest_force"
            ]
        )
    slope = math.log10(forces[1] / forces[0])
    assert slope == pytest.approx(n * (1 + p) / (2 * p - 1 + n * (p - 1)), abs=0.01)


def test_soft_springs_lower_the_pull_off():
    """theory/adhesion.md (3.3): beta = 100, n = 0.33, K/(E* a_J) = 10, 1, 0.1: 3.914, 3.414, 2.519; the preload is forgotten."""
    unit = 1e-3 ** (1.0 / 3.0)
    contact = mdr.Contact(TIP, HALF_SPACE, adhesion=RateAdhesion(1e-3, 1e-3, 0.33))
    state = contact.at_radius(5.0 * unit)
    for stiffness, expected in ((10.0, 3.914), (1.0, 3.414), (0.1, 2.519)):
        spring = stiffness * unit
        start = state.depth + state.force / spring
        speed = 100.0 * 1e-3 * unit
        found = mdr.adhesion.rate_history(
            contact, [0.0, 20.0 / speed], position=[start, start - 20.0], spring_stiffness=spring, start="rest"
        )
        assert -found.end["lowest_force"] / (1.5 * math.pi * 1e-3) == pytest.approx(expected, abs=2e-3)


def test_histories_go_on():
    contact = mdr.Contact(TIP, HALF_SPACE, adhesion=RateAdhesion(1e-3, 1e-3, 0.33, closing_work=7e-4))
    time, depth = np.linspace(0.0, 300.0, 301), np.interp(np.linspace(0, 300, 301), [0, 60, 80, 300], [-0.01, 0.05, 0.05, -0.17])
    whole = mdr.adhesion.rate_history(contact, time, depth=depth)
    first = mdr.adhesion.rate_history(contact, time[:101], depth=depth[:101])
    again = mdr.adhesion.rate_history(contact, time[100:], depth=depth[100:], start=first.end)
    assert again.force == pytest.approx(whole.force[100:], abs=1e-9)
    assert again.dissipated[-1] == pytest.approx(whole.dissipated[-1], rel=1e-7)
    assert np.all(np.diff(whole.dissipated) >= 0.0)
    assert whole.radius[0] == whole.force[0] == 0.0
    assert whole.depth == pytest.approx(depth)
    assert whole.end["ruptures"] == 1.0


def test_energy_under_a_spring():
    """The work of the machine is what the edge loses, and what is left in spring and body."""
    contact = mdr.Contact(TIP, HALF_SPACE, adhesion=RateAdhesion(1e-3, 1e-3, 0.33, closing_work=7e-4))
    time = np.linspace(0.0, 400.0, 20001)
    position = np.interp(time, [0.0, 60.0, 80.0, 400.0], [-0.01, 0.05, 0.05, -0.27])
    found = mdr.adhesion.rate_history(contact, time, position=position, spring_stiffness=0.3)
    assert 0.3 * (position - found.depth) == pytest.approx(found.force, abs=1e-12)
    assert found.work[-1] == pytest.approx(found.dissipated[-1], rel=1e-7)
    assert area(position, found.force) == pytest.approx(found.dissipated[-1], rel=1e-3)
    assert found.radius[-1] == 0.0


@pytest.mark.parametrize(("stress", "speed", "expected", "warns"), [
    (1.0, 2e-4, 1.1204, False), (1.0, 1e-3, 1.3890, False), (1.0, 5e-3, 2.0569, True),
    (0.25, 0.01, 1.2803, True), (0.25, 0.1, 2.1935, True), (0.25, 1.0, 4.2814, True),
])  # fmt: skip
def test_pull_off_of_a_viscoelastic_surface(stress, speed, expected, warns):
    """theory/adhesion.md (4.2) in (3.3), its section 6, and that the law's range is watched."""
    contact = mdr.Contact(TIP, mdr.Homogeneous(RUBBER.relaxed), adhesion=RateAdhesion.from_rheology(RUBBER, 0.01, stress))
    start = contact.at_radius(0.6).depth
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        end = mdr.adhesion.rate_history(contact, [0.0, (start + 1.0) / speed], depth=[start, -1.0], start="rest").end
    assert -end["lowest_force"] / (1.5 * math.pi * 0.01) == pytest.approx(expected, rel=1e-4)
    assert any(issubclass(entry.category, mdr.errors.AdhesionRateWarning) for entry in caught) == warns


def test_works_at_speeds():
    rate = RateAdhesion(2.0, 0.5, 0.5, closing_work=1.0, closing_speed=0.25)
    assert rate.at_speed([0.0, 0.5, 2.0, -0.25]) == pytest.approx([2.0, 4.0, 6.0, 0.5])
    surface = RateAdhesion.from_rheology(RUBBER, 0.01, 1.0)
    assert surface.at_speed([1e9, -1e9]) == pytest.approx([0.1, 0.001], rel=1e-6)
    assert surface.at_speed(0.0) == 0.01


@pytest.mark.parametrize(("wrong", "words"), [
    ({"speed": -1.0}, "speed = -1"), ({"exponent": 0.0}, "exponent = 0"), ({"exponent": 2.5}, "exponent = 2.5"),
    ({"work": 0.0}, "work = 0"), ({"closing_work": 2.0}, "closing_work = 2"), ({"closing_speed": 0.0}, "closing_speed = 0"),
    ({"closing_exponent": -0.5}, "closing_exponent = -0.5"),
])  # fmt: skip
def test_laws_that_cannot_be(wrong, words):
    with pytest.raises(mdr.errors.InvalidArgumentError, match=words):
        RateAdhesion(**{"work": 1.0, "speed": 1.0, "exponent": 0.5, **wrong})


def test_refusals():
    rate = RateAdhesion(1e-3, 1e-3, 0.33)
    contact = mdr.Contact(TIP, HALF_SPACE, adhesion=rate)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="relaxed"):
        mdr.Contact(TIP, mdr.Homogeneous(RUBBER), adhesion=rate)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="flat end"):
        mdr.adhesion.rate_history(mdr.Contact(mdr.FlatEndedCone(0.1, 0.2), HALF_SPACE, adhesion=rate), [0.0, 1.0], depth=[0.1, 0.0])
    with pytest.raises(mdr.errors.ArgumentTypeError, match="spring_stiffness"):
        mdr.adhesion.rate_history(contact, [0.0, 1.0], position=[0.0, 1.0])
    with pytest.raises(mdr.errors.ArgumentTypeError, match="position, depth and force, not none"):
        mdr.adhesion.rate_history(contact, [0.0, 1.0])
    with pytest.raises(mdr.errors.InvalidArgumentError, match="rate_history"):
        contact.history([0.0, 1.0], depth=[0.0, 1.0])
    with pytest.raises(mdr.errors.InvalidArgumentError, match="start"):
        mdr.adhesion.rate_history(contact, [0.0, 1.0], depth=[0.0, 1.0], start="here")
    with pytest.raises(mdr.errors.InvalidArgumentError, match="'radios'.*Remove"):
        mdr.adhesion.rate_history(contact, [0.0, 1.0], depth=[0.0, 1.0], start={"radios": 1.0})
    end = mdr.adhesion.rate_history(contact, [0.0, 1.0], depth=[0.0, 0.1]).end
    with pytest.raises(mdr.errors.InvalidArgumentError, match="mark"):
        mdr.adhesion.rate_history(contact, [0.0, 1.0], depth=[0.1, 0.1], start={**end, "work": 2.0 * end["work"]})
    with pytest.raises(mdr.errors.UnreachableError, match="no stable"):
        mdr.adhesion.rate_history(contact, [0.0, 1.0], depth=[-1.0, -1.0], start="rest")
    with pytest.raises(mdr.errors.InvalidArgumentError, match="work_of_adhesion"):
        mdr.Contact(TIP, HALF_SPACE, work_of_adhesion=1.0, adhesion=rate)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="cohesive_stress"):
        mdr.Contact(TIP, HALF_SPACE, cohesive_stress=1.0, adhesion=rate)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="must have an adhesion"):
        mdr.adhesion.rate_history(mdr.Contact(TIP, HALF_SPACE), [0.0, 1.0], depth=[0.0, 1.0], start="rest")


def noisy_curves(noise, seed=1):
    contact = mdr.Contact(mdr.Paraboloid(20e-6), RUBBERY, adhesion=RateAdhesion(0.05, 1e-6, 0.4))
    random, curves = np.random.default_rng(seed), []
    for speed in (1e-7, 1e-6, 1e-5):
        time = np.linspace(0.0, 3.2e-6 / speed, 150)
        position = 2e-6 - speed * time + 1e-8
        force = mdr.adhesion.rate_history(contact, time, position=position - 1e-8, spring_stiffness=20.0, start="rest").force
        curves.append(mdi.RateCurve(time, position, force + noise * random.standard_normal(150) * 1e-5, 20.0))
    return curves


RUBBERY = mdr.Homogeneous(mdr.Elastic(1e6, 0.5))


def test_fits_of_several_speeds():
    """Without noise the truth comes back, with the contact point; pull-off at another speed follows."""
    guess = mdr.Contact(mdr.Paraboloid(20e-6), RUBBERY, adhesion=RateAdhesion(0.07, 3e-6, 0.5))
    curves = noisy_curves(0.0)
    found = mdi.fit_rate(curves, guess, ["E", "work", "speed", "exponent", "position_offset"])
    truth = {"E": 1e6, "work": 0.05, "speed": 1e-6, "exponent": 0.4, "position_offset": 1e-8}
    assert found.values == pytest.approx(truth, rel=1e-3)
    assert found.contact.adhesion.work == found.values["work"]
    assert "work" in found.summary()
    true = mdr.Contact(mdr.Paraboloid(20e-6), RUBBERY, adhesion=RateAdhesion(0.05, 1e-6, 0.4))
    end = mdr.adhesion.rate_history(true, [0.0, 4.0], position=[2e-6, -10e-6], spring_stiffness=20.0, start="rest").end
    assert found.pull_off(3e-6) == pytest.approx(end["lowest_force"], rel=1e-4)
    noisy = mdi.fit_rate(noisy_curves(0.02), guess, ["work", "speed", "exponent", "position_offset"])
    low, high = noisy.intervals["work"]
    assert low < 0.05 < high and high / low < 1.5
    assert abs(noisy.lag) < 0.2
    assert len(noisy.fitted) == 3 and len(noisy.fitted[0]) == noisy.curves[0].count


def test_a_fit_is_drawn():
    guess = mdr.Contact(mdr.Paraboloid(20e-6), RUBBERY, adhesion=RateAdhesion(0.05, 1e-6, 0.4))
    fit, readings = mdi.fit_rate(noisy_curves(0.01), guess, ["work"]).plot(points=4).panels[0].parts
    assert (len(fit.x), len(readings.x)) == (4, 3)
    assert np.interp(readings.x, fit.x, fit.y) == pytest.approx(readings.y, rel=0.2)


def test_fits_that_cannot_be():
    curves = noisy_curves(0.0)
    guess = mdr.Contact(mdr.Paraboloid(20e-6), RUBBERY, adhesion=RateAdhesion(0.05, 1e-6, 0.4))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="free = 'gamma'"):
        mdi.fit_rate(curves, guess, ["gamma"])
    layered = guess.replace(medium=mdr.Layered([(mdr.Elastic(1e6, 0.5), 1e-4)], mdr.Elastic(2e6, 0.5)))
    with pytest.raises(mdr.errors.InvalidArgumentError, match=r"free = 'layers\[0\].e': .*layers\[0\]\.E"):
        mdi.fit_rate(curves, layered, ["layers[0].e"])
    with pytest.raises(mdr.errors.ArgumentTypeError, match="adhesion="):
        mdi.fit_rate(curves, mdr.Contact(mdr.Paraboloid(20e-6), RUBBERY), ["work"])
    with pytest.raises(mdr.errors.ArgumentTypeError, match="RateCurve"):
        mdi.fit_rate([1.0], guess)
    with pytest.raises(mdr.errors.InvalidArgumentError, match="ascending"):
        mdi.RateCurve(np.ones(9), np.ones(9), np.ones(9))
    with pytest.raises(mdr.errors.InvalidArgumentError, match="same length"):
        mdi.RateCurve(np.arange(9.0), np.ones(8), np.ones(9))


PROBLEM = """
[indenter]
shape = "paraboloid"
radius = "20 um"
[medium]
type = "homogeneous"
[medium.material]
E = "1 MPa"
nu = 0.5
[adhesion]
work_of_adhesion = "50 mJ/m^2"
speed = "1 um/s"
exponent = 0.4
closing_work = "30 mJ/m^2"
spring_stiffness = "20 N/m"
[history]
path = "ramp"
depth = "500 nm"
rise_time = "1 s"
fall_time = "10 s"
retract_to = "-5 um"
"""


def test_the_command(tmp_path, capsys):
    """The same pull-off as in Python."""
    file = tmp_path / "pull.toml"
    file.write_text(PROBLEM)
    assert main(["history", str(file), "--csv", str(tmp_path / "path.csv")]) == 0
    said = capsys.readouterr().out
    law = RateAdhesion(0.05, 1e-6, 0.4, closing_work=0.03)
    contact = mdr.Contact(mdr.Paraboloid(20e-6), RUBBERY, adhesion=law)
    found = mdr.adhesion.rate_history(contact, [0.0, 1.0, 11.0], position=[0.0, 5e-7, -5e-6], spring_stiffness=20.0)
    assert f"lowest force: {found.end['lowest_force'] * 1e6:.5g} uN" in said
    assert f"energy lost at the edge: {found.dissipated[-1] * 1e12:.5g} pJ" in said
    assert (tmp_path / "path.csv").read_text().startswith("time")


@pytest.mark.parametrize(("old", "new", "words"), [
    ("exponent = 0.4", "", "speed needs the key 'exponent'"), ("exponent = 0.4", "exponent = 3", "exponent = 3"),
    ('speed = "1 um/s"', 'speed = "1 um"', "speed"), ('fall_time = "10 s"', "", "retract_to"),
])  # fmt: skip
def test_problem_files_that_cannot_be(tmp_path, capsys, old, new, words):
    file = tmp_path / "pull.toml"
    file.write_text(PROBLEM.replace(old, new))
    assert main(["history", str(file)]) != 0
    assert words in capsys.readouterr().err
