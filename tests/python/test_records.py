# SPDX-License-Identifier: GPL-3.0-or-later
"""From an instrument's record to a curve: segments, drift, pop-ins, contact point, baseline, deflection."""

from __future__ import annotations

import json

import numpy as np
import pytest
from records import indentation, wandering

import mdrcontact as mdr
from mdrcontact.cli import main
from mdrcontact.instruments.records import (
    depth_from_height,
    drift_rate,
    find_baseline,
    find_contact_point,
    find_parting,
    find_pop_in,
    find_pull,
    find_segments,
    find_strays,
    segments,
    without_drift,
)
from mdrcontact.instruments.records.contact_point import deflection_sign
from mdrcontact.instruments.records.segments import effective_points

GLASS, RUBBER = mdr.Elastic(70e9, 0.23), mdr.Elastic(2e6, 0.49)
SOFT = mdr.Coated(RUBBER, 2e-6, GLASS)
BALL = mdr.Paraboloid(5e-6)


def approach(n=800, noise=0.3e-9, tilt=3e-3, offset=2e-9, seed=0):
    """An AFM approach: depth, force with baseline; contact at depth 0."""
    depth = np.linspace(-600e-9, 300e-9, n)
    force = np.zeros(n)
    force[depth > 0.0] = mdr.Contact(BALL, SOFT).at_depth(depth[depth > 0.0]).force
    return depth, force + offset + tilt * depth + noise * np.random.default_rng(seed).standard_normal(n)


@pytest.mark.parametrize("points", [(300, 100, 200, 80, 20), (100, 400, 100, 300, 20), (900, 50, 900, 100, 60)])
def test_segments_are_told_apart(points):
    """Each boundary within 3 % of the points."""
    _, h, p, _ = indentation(points=points)
    segments = find_segments(h, p)
    assert [s.kind for s in segments] == ["loading", "hold", "unloading", "hold", "unloading"]
    assert segments[0].start == 0 and segments[-1].stop == len(h)
    ends = np.cumsum(points)
    for segment, end in zip(segments, ends, strict=True):
        # the creep at the beginning of a hold is part of the loading
        assert abs(segment.stop - end) <= 0.03 * len(h) + 0.15 * points[1]


@pytest.mark.parametrize("seed", [11, 1])
@pytest.mark.parametrize(
    ("options", "error"),
    [
        ({}, 5e-12),
        ({"sd": 0.5e-9}, 17e-12),
        ({"servo": 2e-6}, 9e-12),
        ({"servo": 5e-6}, 9e-12),
        ({"times": (5, 2, 5, 10, 1)}, 30e-12),
        ({"times": (5, 30, 5, 60, 1)}, 2e-12),
    ],
)
def test_a_hold_that_wanders_is_one_hold(options, error, seed):
    """It was cut into pieces, up to 27 loadings and 25 unloadings for one and two, and drift = "hold" took the last piece."""
    time, h, p = wandering(**options, seed=seed)
    found = find_segments(h, p)
    assert [s.kind for s in found] == ["loading", "hold", "unloading", "hold", "unloading"]
    held = found[3].points
    drift = drift_rate(time[held], h[held])
    assert abs(drift.rate - 50e-12) < 3.0 * drift.standard_error < 3.0 * error
    assert held.stop - held.start > 0.85 * 200 * options.get("times", (0, 0, 0, 30))[3]


def test_small_cycles_on_the_way_are_no_wander():
    """Twenty partial unloadings by 4 % of the force, each from a higher force."""
    levels = [0.0, *np.ravel([(0.05 * i, 0.05 * i - 0.04) for i in range(1, 21)]), 0.0]
    p = np.concatenate([np.linspace(a, b, 50, endpoint=False) for a, b in zip(levels[:-1], levels[1:], strict=True)])
    top = np.maximum.accumulate(p)
    h = np.sqrt(top) - 0.2 * (top - p) + 1e-5 * np.random.default_rng(0).standard_normal(p.size)
    kinds = [s.kind for s in find_segments(h, p)]
    assert (kinds.count("loading"), kinds.count("unloading")) == (20, 20)


def test_a_curve_without_holds_turns_where_it_is_deepest():
    depth = np.concatenate([np.linspace(0.0, 1.0, 200), np.linspace(1.0, -1.0, 400)])
    force = np.maximum(depth, 0.0) ** 1.5 + 0.005 * np.random.default_rng(0).standard_normal(600)
    one, two = find_segments(depth, force)
    assert (one.kind, two.kind) == ("loading", "unloading") and abs(two.start - 200) <= 2
    assert [s.kind for s in find_segments(depth[:200], force[:200])] == ["loading"]
    assert [s.kind for s in find_segments(depth[200:], force[200:])] == ["unloading"]


def test_drift_is_found_with_its_error():
    scores = []
    for seed in range(30):
        random = np.random.default_rng(seed)
        time = np.linspace(0.0, 60.0, 200)
        noise = np.empty(200)
        noise[0] = random.standard_normal()
        for i in range(1, 200):
            noise[i] = 0.8 * noise[i - 1] + 0.6 * random.standard_normal()
        found = drift_rate(time, 100e-9 + 0.05e-9 * time + 0.2e-9 * noise)
        scores.append((found.rate - 0.05e-9) / found.standard_error)
    assert 0.6 < np.std(scores) < 1.6, "errors of independent noise would give 3"
    depth = 1e-9 * np.arange(5.0)
    assert without_drift(np.arange(5.0) + 7.0, depth, 1e-9) == pytest.approx(np.zeros(5), abs=1e-20)


def test_a_reading_that_strays_is_no_pop_in():
    """Depths with noise: one of them back by six standard deviations, and the next where it was."""
    depth = np.linspace(0.0, 100e-9, 2000) + 0.1e-9 * np.random.default_rng(0).standard_normal(2000)
    force = np.linspace(0.0, 1.0, 2000) ** 1.5
    depth[60] -= 1.5e-9
    assert find_pop_in(depth, force) is None
    depth[1200:] += 4e-9
    found = find_pop_in(depth, force)
    assert found is not None and abs(found.position - 1199) <= 1 and found.jump == pytest.approx(4.1e-9, abs=0.5e-9)


@pytest.mark.parametrize("pull", [0.0, 2e-9])
def test_pulls_of_a_record(pull):
    """Found where they are, with their size; noise is none."""
    depth = np.linspace(-2e-6, 1e-6, 900)
    random = np.random.default_rng(0).standard_normal(900)
    force = 5e-10 + 1e-3 * np.maximum(depth, 0.0) ** 1.0 - pull * np.exp(-(((depth + 1e-7) / 5e-8) ** 2)) + 5e-11 * random
    found = find_pull(depth[::-1], force[::-1])
    if pull == 0.0:
        assert found is None
    else:
        assert found is not None
        assert found.force == pytest.approx(pull, abs=2e-10) and found.depth == pytest.approx(-1e-7, abs=2e-8)
        assert found.noise == pytest.approx(5e-11, rel=0.2)


def test_pop_ins():
    """A jump of 8 nm at constant load, fast and over three readings; none in a smooth curve with noise."""
    force = np.linspace(0.0, 1e-3, 300)
    depth = 100e-9 * (force / 1e-3) ** (2.0 / 3.0) + 0.05e-9 * np.random.default_rng(1).standard_normal(300)
    assert find_pop_in(depth, force) is None
    for width in (1, 3):
        jumped = depth + 8e-9 * np.clip((np.arange(300) - 149) / width, 0.0, 1.0)
        found = find_pop_in(jumped, force)
        assert found is not None and abs(found.position - 149) <= 2
        assert found.jump == pytest.approx(8e-9, rel=0.3)
        assert found.force == pytest.approx(force[149], rel=0.02)


@pytest.mark.parametrize("method", ["piecewise", "ratio-of-variances"])
def test_contact_point_and_baseline(method):
    for seed in range(5):
        depth, force = approach(seed=seed)
        found = find_contact_point(depth, force, method)
        assert abs(depth[found]) < 12e-9, "4 % of the depth"
        line = find_baseline(depth, force, found)
        assert line.tilt == pytest.approx(3e-3, rel=0.1)
        assert line.offset == pytest.approx(2e-9, abs=0.15e-9)
        assert line.noise == pytest.approx(0.3e-9, rel=0.2)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_depth_is_height_less_deflection(sign):
    depth, force = approach(noise=0.0, tilt=0.0, offset=0.0)
    found = depth_from_height(sign * (depth + force / 0.5) + 3e-6, force / 0.5)
    assert found - found[0] == pytest.approx(depth - depth[0], abs=1e-15)


PROBLEM = """
title = "Deflection"
[indenter]
shape = "paraboloid"
radius = "5 um"
[medium]
type = "coated"
coating = { E = "1 MPa", nu = 0.49, thickness = "2 um" }
substrate = { E = "70 GPa", nu = 0.23 }
[instrument]
spring_constant = "30 N/m"
deflection_sensitivity = "50 nm/V"
[data]
kind = "force-depth"
[fit.free]
"coating.E" = {}
depth_offset = {}
"""
PLAIN = PROBLEM.replace('[instrument]\nspring_constant = "30 N/m"\ndeflection_sensitivity = "50 nm/V"\n', "")
"""Of tables that have depth and force already."""


@pytest.fixture
def raw(tmp_path):
    """A record of piezo height and photodiode voltage: approach and retract."""
    depth, force = approach()
    depth, force = np.concatenate([depth, depth[::-1]]), np.concatenate([force, force[::-1]])
    deflection = force / 30.0
    np.savetxt(
        tmp_path / "raw.txt",
        np.column_stack([-1e9 * (depth + deflection), deflection / 50e-9]),
        header="Height [nm]\tDeflection [V]",
        comments="",
        delimiter="\t",
    )
    (tmp_path / "problem.toml").write_text(PROBLEM)
    return tmp_path


@pytest.mark.parametrize("extra", ["", 'branch = "loading"\n', 'branch = "unloading"\n', 'contact_point = "ratio-of-variances"\n'])
def test_a_raw_record_goes_into_a_fit(raw, capsys, extra):
    (raw / "problem.toml").write_text(PROBLEM.replace("[fit.free]", extra + "[fit.free]"))
    options = ["--problem", str(raw / "problem.toml"), "--json", str(raw / "fit.json")]
    assert main(["fit", str(raw / "raw.txt"), *options]) == 0
    found = json.loads((raw / "fit.json").read_text())
    assert found["parameters"]["coating.E"]["value"] == pytest.approx(RUBBER.E, rel=5e-3)
    out = capsys.readouterr().out
    assert "Gavara 2016" in out and "Lin, Dimitriadis, Horkay 2007" in out and "baseline: offset" in out
    if "branch" in extra:
        assert "readings of" in out


@pytest.mark.parametrize("height", [1.0, -1.0])
def test_a_deflection_of_the_other_sign(raw, capsys, height):
    """Contact under tension from end to end, it could not be fitted."""
    readings = np.loadtxt(raw / "raw.txt", skiprows=1) * [height, -1.0]
    np.savetxt(raw / "raw.txt", readings, header="Height [nm]\tDeflection [V]", comments="", delimiter="\t")
    assert main(["fit", str(raw / "raw.txt"), "--problem", str(raw / "problem.toml"), "--json", str(raw / "fit.json")]) == 0
    assert "its sign is turned" in capsys.readouterr().out
    found = json.loads((raw / "fit.json").read_text())
    assert found["parameters"]["coating.E"]["value"] == pytest.approx(RUBBER.E, rel=5e-3)


@pytest.mark.parametrize("value", [0.0, 1e6, -7e3])
@pytest.mark.parametrize("at", [[0], [1], [400], [-1], [0, 1, 700]])
@pytest.mark.parametrize("column", [0, 1])
def test_a_glitch_loses_no_curve(raw, capsys, at, column, value):
    """Of one in the first height nothing was left: "too few points before contact for a baseline"."""
    readings = np.loadtxt(raw / "raw.txt", skiprows=1)
    readings[at, column] = value * np.arange(1, len(at) + 1)
    np.savetxt(raw / "raw.txt", readings, header="Height [nm]\tDeflection [V]", comments="", delimiter="\t")
    assert main(["fit", str(raw / "raw.txt"), "--problem", str(raw / "problem.toml"), "--json", str(raw / "fit.json")]) == 0
    out = capsys.readouterr().out
    assert value == 0.0 or "lie far from both neighbours and are left out" in out
    found = json.loads((raw / "fit.json").read_text())
    assert found["parameters"]["coating.E"]["value"] == pytest.approx(RUBBER.E, rel=5e-3)


def test_a_table_of_unloading_alone(raw, capsys):
    depth, force = approach()
    depth, force = depth[::-1], force[::-1]
    np.savetxt(raw / "fall.txt", np.column_stack([1e9 * depth, 1e9 * force]), header="depth [nm] load [nN]", comments="")
    for branch, words in (
        ("unloading", f"{len(depth)} readings of unloading"),
        ("loading", "the curve has 0 readings of branch = 'loading'"),
    ):
        (raw / "problem.toml").write_text(PLAIN.replace("[fit.free]", f'branch = "{branch}"\n[fit.free]'))
        main(["fit", str(raw / "fall.txt"), "--problem", str(raw / "problem.toml")])
        assert words in "".join(capsys.readouterr())


def test_a_curve_in_contact_from_its_first_reading(raw, capsys):
    """The remedy that the refusal names is one."""
    depth = np.linspace(20e-9, 100e-9, 4)
    force = np.asarray(mdr.Contact(BALL, SOFT).at_depth(depth).force)
    np.savetxt(raw / "short.txt", np.column_stack([1e9 * depth, 1e9 * force]), header="depth [nm] load [nN]", comments="")
    problem = PLAIN.replace("depth_offset = {}\n", "")
    for given, status in (('baseline = "tilt"', 2), ('contact_point = "given"\nbaseline = "none"', 0)):
        (raw / "problem.toml").write_text(problem.replace("[fit.free]", f"{given}\n[fit.free]"))
        assert main(["fit", str(raw / "short.txt"), "--problem", str(raw / "problem.toml")]) == status
        assert status == 0 or 'say contact_point = "given" and baseline = "none"' in capsys.readouterr().err


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('spring_constant = "30 N/m"\n', "", "spring_constant"),
        ('deflection_sensitivity = "50 nm/V"\n', "", "deflection_sensitivity"),
        ('kind = "force-depth"', 'kind = "force-depth"\nbranch = "up"', "'loading', 'unloading', 'both'"),
        ('kind = "force-depth"', 'kind = "force-depth"\ndrift = "hold"', "time"),
        ('kind = "force-depth"', 'kind = "force-depth"\nupper_part = [0.2, 0.9]', "upper_part"),
        ('kind = "force-depth"', 'kind = "modulus-radius"\nbranch = "loading"', "branch"),
        ('kind = "force-depth"', 'kind = "force-depth"\nbefore_pop_in = 3', "before_pop_in"),
        ('kind = "force-depth"', 'kind = "force-depth"\ncontact_point = "eye"', "piecewise"),
    ],
)
def test_what_is_missing_is_named(raw, capsys, old, new, words):
    assert old in PROBLEM
    (raw / "problem.toml").write_text(PROBLEM.replace(old, new))
    assert main(["fit", str(raw / "raw.txt"), "--problem", str(raw / "problem.toml")]) == 2
    assert words in capsys.readouterr().err


@pytest.mark.parametrize(
    ("header", "old", "new", "words"),
    [
        ("Height [nm]\tDeflection [nm]", "", "", "deflection_sensitivity belongs to a deflection in volts"),
        ("Height [nm]\tForce [nN]", "", "", "deflection_sensitivity belongs to a deflection in volts"),
        ("Depth [nm]\tForce [nN]", 'deflection_sensitivity = "50 nm/V"\n', "", "spring_constant belongs to"),
        ("Depth [nm]\tForce [nN]\tDeflection [V]", "[fit.free]", 'deflection = "Deflection [V]"\n[fit.free]', "is not read"),
        ("Height [nm]\tDeflection [V]\tTime", "[fit.free]", 'units = { Time = "s" }\n[fit.free]', "'Time' of units is not read"),
    ],
)  # fmt: skip
def test_settings_and_columns_that_are_not_read_are_refused(raw, capsys, header, old, new, words):
    """They were passed over: the wrong column, or a raw record that is none, went unseen."""
    heights, volts = np.loadtxt(raw / "raw.txt", skiprows=1, unpack=True)
    columns = np.column_stack([heights, volts, np.arange(len(volts))][: header.count("\t") + 1])
    np.savetxt(raw / "raw.txt", columns, header=header, comments="", delimiter="\t")
    (raw / "problem.toml").write_text(PROBLEM.replace(old, new) if old else PROBLEM)
    assert main(["fit", str(raw / "raw.txt"), "--problem", str(raw / "problem.toml")]) == 2
    assert words in capsys.readouterr().err


def test_a_column_of_area_stands_for_the_radius(tmp_path, capsys):
    a = np.linspace(0.5e-6, 4e-6, 20)
    table = np.column_stack([np.pi * a**2 * 1e12, np.asarray(SOFT.stiffness(a))])
    np.savetxt(tmp_path / "areas.csv", table, header="contact area [um^2],stiffness [N/m]", comments="", delimiter=",")
    text = PLAIN.replace("force-depth", "stiffness-radius").replace("depth_offset = {}\n", "")
    (tmp_path / "problem.toml").write_text(text)
    options = ["--problem", str(tmp_path / "problem.toml"), "--json", str(tmp_path / "fit.json")]
    assert main(["fit", str(tmp_path / "areas.csv"), *options]) == 0
    assert "sqrt(area/pi)" in capsys.readouterr().out
    assert json.loads((tmp_path / "fit.json").read_text())["parameters"]["coating.E"]["value"] == pytest.approx(RUBBER.E, rel=1e-4)


def test_noise_and_effective_points_of_known_series():
    """White noise on a slope has its standard deviation; 40 readings with rho = 0.5 are worth n (1 - rho)/(1 + rho) = 13.3, where
    the plain lag-1 coefficient, 0.45 on average, would say 15."""
    random = np.random.default_rng(4)
    assert segments._noise(3.0 * np.arange(4000.0) + random.standard_normal(4000)) == pytest.approx(1.0, rel=0.05)
    rho, counted = 0.5, []
    for _ in range(2000):
        series = random.standard_normal(40)
        for i in range(1, 40):
            series[i] = rho * series[i - 1] + np.sqrt(1.0 - rho**2) * series[i]
        counted.append(effective_points(series - series.mean()))
    assert np.median(counted) == pytest.approx(40.0 * (1.0 - rho) / (1.0 + rho), rel=0.06)


def jump_in(steps, seed=2):
    """A JKR record under a soft spring (7.5 um, 1.4 MPa, nu 0.49, 60 mJ/m^2, 3 N/m): depth and force of the approach."""
    radius, modulus, work, spring = 7.5e-6, 1.4e6 / (1.0 - 0.49**2), 60e-3, 3.0
    a = np.geomspace(1e-8, 4e-6, 20001)
    force = 4.0 * modulus * a**3 / (3.0 * radius) - np.sqrt(8.0 * np.pi * work * modulus * a**3)
    height = a**2 / radius - np.sqrt(2.0 * np.pi * work * a / modulus) + force / spring
    stable = np.argmin(height)
    up = np.linspace(-1.5e-6, 1.2e-6, steps)
    f = np.where(up < 0.0, 0.0, np.interp(up, height[stable:], force[stable:]))
    f += 0.4e-9 * np.random.default_rng(seed).standard_normal(steps)
    return up - f / spring, f


@pytest.mark.parametrize("steps", [300, 1200, 4000])
@pytest.mark.parametrize("barrier", [0.0, 2e-8])
def test_a_jump_into_contact_is_no_pop_in(steps, barrier):
    """It was reported as one of 265 nm, "only before it was the contact elastic"; a repulsion before it changes nothing."""
    depth, force = jump_in(steps)
    at = int(np.argmax(-np.diff(force)))
    force += barrier * np.exp(np.minimum(depth - depth[at], 0.0) / 5e-8) * (np.arange(steps) <= at)
    assert find_pull(depth, force) is not None
    assert find_pop_in(depth, force) is None
    assert find_pop_in(depth + 2e-7 * (np.arange(steps) >= steps // 4), force) is None, "a step in the air"
    # one behind it, under load, is found
    late = int(0.95 * steps)
    popped = find_pop_in(depth + 2e-7 * (np.arange(steps) >= late), force)
    assert popped is not None and abs(popped.position - late) <= 2


def test_stray_readings_are_found_and_jumps_are_none():
    depth = np.linspace(-50.0, 100.0, 200)
    force = np.maximum(depth, 0.0) ** 1.5 + np.random.default_rng(1).standard_normal(200)
    assert not len(find_strays(force)) and not len(find_strays(np.concatenate([force, force[::-1]])))
    force[150:] += 200.0
    assert not len(find_strays(force))
    force[[60, 170]] = 500.0, 0.0
    assert list(find_strays(force)) == [60, 170]


def test_how_a_tip_comes_off():
    """Last rupture and energy lost of a cycle that is known: a polymer pulled by a spring, with a baseline of its own and noise."""
    contact = mdr.Contact(
        mdr.Paraboloid(20e-6),
        mdr.Homogeneous(mdr.Elastic(1e6, 0.5)),
        adhesion=mdr.adhesion.RateAdhesion(0.05, 1e-6, 0.4, closing_work=0.03),
    )
    time = np.linspace(0.0, 8.0, 4001)
    position = np.interp(time, [0.0, 2.0, 8.0], [-2e-6, 2e-6, -10e-6])
    path = mdr.adhesion.rate_history(contact, time, position=position, spring_stiffness=20.0)
    random = np.random.default_rng(3).standard_normal(time.size)
    found = find_parting(path.depth, path.force + 3e-8 + 5e-9 * random)
    assert found is not None
    assert path.end["ruptures"] == 1.0
    assert found.energy == pytest.approx(path.dissipated[-1], rel=5e-3)
    assert found.rupture_depth == path.depth[np.flatnonzero(path.radius)[-1]]
    assert find_parting(path.depth, 3e-8 + 5e-9 * random) is None


@pytest.mark.parametrize("height", [1.0, -1.0])
@pytest.mark.parametrize("deflection", [1, -1])
def test_the_sign_of_a_deflection_in_a_liquid(height, deflection):
    """Drag gives the way out another baseline, and the cantilever swings when it comes off: only the way in counts."""
    way_in, way_out = np.linspace(-1.3e-6, 0.0, 300), np.linspace(0.0, -0.7e-6, 500)
    noise = 1e-11 * np.random.default_rng(0).standard_normal(800)
    contact = 1e-10 * np.maximum(way_in / 3e-8 + 1.0, 0.0) ** 1.5
    swing = 6e-11 * np.exp(way_out / 2e-7) * np.sin(way_out / 1e-8) - 1.4e-10
    force = np.concatenate([contact, swing]) + noise
    found = deflection_sign(height * np.concatenate([way_in, way_out]), deflection * force)
    assert found == deflection
