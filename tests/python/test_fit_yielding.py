# SPDX-License-Identifier: GPL-3.0-or-later
"""What yield stresses tell of a fit: R_Y of each layer of an unloading, and a loading that was not elastic."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact.cli import main
from mdrcontact.errors import InvalidArgumentError

METAL = mdr.Elastic(100e9, 0.3)
SOLID = mdr.Homogeneous(METAL)
BALL = mdr.Paraboloid(10e-6)
HERTZ = 0.6200
"""Largest von Mises stress over the largest pressure of Hertz, nu = 0.3: 0.620 on the axis."""
STIFF = mdr.Coated(mdr.Elastic(400e9, 0.25), 300e-9, mdr.Elastic(70e9, 0.33))


def record(power=1.5, noise=1e-3):
    """An indent of 100 nm with 1 mN that leaves 60 nm."""
    way, back = np.linspace(0.0, 1.0, 60), np.linspace(1.0, 0.0, 60)
    force = 1e-3 * (np.r_[way**2, back**power] + noise * np.random.default_rng(0).standard_normal(120))
    return 100e-9 * np.r_[way, 1.0 - 0.4 * way], force


def unloading(**options):
    return mdi.fit(mdi.Unloading(*record()), mdr.Berkovich(), **options)


def test_the_unloading_of_hertz_in_closed_form():
    """A power of 1.5 is the unloading of Hertz's pressure, whose von Mises stress is 0.62 of its largest value, 1.5 H."""
    result = unloading(medium=SOLID, free=["E"], yield_stresses=[2.4e9])
    hardness = mdi.oliver_pharr(result.data, mdr.Berkovich(), medium=result.medium).hardness[0]
    (one,) = result.reverse_yield
    assert one.layer == 0 and one.yield_stress == 2.4e9
    assert one.ratio == pytest.approx(HERTZ * 1.5 * hardness / 2.4e9, rel=0.01)
    assert f"layer 0 {one.ratio:.2f}" in result.summary()
    assert any(f"R_Y = {one.ratio:.2f} in layer 0: unloading yields again" in words for words in result.warnings)
    assert json.loads(result.to_json())["reverse_yield"] == [one._asdict()]
    harder = unloading(medium=SOLID, free=["E"], yield_stresses=[4.8e9])
    assert harder.reverse_yield[0].ratio == pytest.approx(0.5 * one.ratio, rel=1e-6)
    assert not any("R_Y" in words for words in harder.warnings)
    assert unloading(medium=SOLID, free=["E"]).reverse_yield == ()


def test_a_hardness_gives_its_yield_stress_and_error():
    known = mdr.plastic.yield_stress_from_hardness(METAL, 6.72e9)
    (exact,) = unloading(medium=SOLID, free=["E"], yield_stresses=[2.4e9]).reverse_yield
    result = unloading(medium=SOLID, free=["E"], yield_stresses=[known])
    (one,) = result.reverse_yield
    assert one == pytest.approx(exact._replace(error=0.08), rel=1e-12) and exact.error == 0.0
    words = f"{one.ratio:.2f} ± {0.08 * one.ratio:.2f}"
    assert f"layer 0 {words}" in result.summary() and any(f"R_Y = {words} in layer 0" in text for text in result.warnings)
    assert result.to_dict()["reverse_yield"][0]["error"] == 0.08
    with pytest.raises(InvalidArgumentError, match=r"yield_stresses\[0\] = nan"):
        unloading(medium=SOLID, free=["E"], yield_stresses=[known._replace(yield_stress=np.nan)])


def test_a_loading_is_plastic_beyond_the_error_of_its_yield_stress():
    depth = np.linspace(1e-9, 100e-9, 60)
    force = np.asarray(mdr.Contact(BALL, SOLID).at_depth(depth).force)
    data = mdi.ForceDepth(depth, force * (1.0 + 1e-3 * np.random.default_rng(0).standard_normal(60)))
    stress = HERTZ * 1.5 * force[-1] / (np.pi * 10e-6 * 100e-9)
    for ratio, is_plastic in ((1.04, False), (1.2, True)):
        known = mdr.plastic.yield_stress_from_hardness(METAL, 2.8 * stress / ratio)
        result = mdi.fit(data, BALL, SOLID, ["E"], yield_stresses=[known])
        assert result.yield_ratio == pytest.approx(ratio / 1.08, rel=2e-3) and result.is_plastic is is_plastic
        assert mdi.fit(data, BALL, SOLID, ["E"], yield_stresses=[known.yield_stress]).is_plastic


def test_the_compliance_of_the_tip_is_not_that_of_the_body():
    """The same pressure from the recovery of both: R_Y depends on the tip by its effect on the contact radius alone."""
    plain = unloading(medium=SOLID, free=["E"], yield_stresses=[2.4e9])
    tool = mdi.Instrument(indenter=mdr.Elastic(1141e9, 0.07))
    diamond = unloading(medium=SOLID, free=["E"], instrument=tool, yield_stresses=[2.4e9])
    assert diamond.estimates["E"] > 1.05 * plain.estimates["E"]
    assert diamond.reverse_yield[0].ratio == pytest.approx(plain.reverse_yield[0].ratio, rel=0.01)


def test_a_stiff_film_on_a_soft_body_is_refused_unless_its_area_is_measured():
    words = r"yield_stresses\[1\] = 1.5e\+08: R_Y = \d+\.\d+ exceeds 3.*34 to 43 %.*Measure the contact area"
    with pytest.raises(mdr.MDRError, match=words):
        unloading(medium=STIFF, free=["coating.E"], yield_stresses=[None, 0.15e9])
    (failed,) = mdi.fit_many([mdi.Unloading(*record())], mdr.Berkovich(), STIFF, ["coating.E"], yield_stresses=[None, 0.15e9])
    assert not failed.converged and "34 to 43 %" in str(failed.error)
    free = {"coating.E": None, "area_factor": mdi.Free(prior=(1.0, 0.02))}
    result = unloading(medium=STIFF, free=free, yield_stresses=[None, 0.15e9])
    assert result.reverse_yield[0].ratio > 3.0 and any("up to 17 %" in words for words in result.warnings)
    safe = unloading(medium=STIFF, free=["coating.E"], yield_stresses=[5e9, 5e9])
    assert [one.layer for one in safe.reverse_yield] == [0, 1] and max(one.ratio for one in safe.reverse_yield) < 2.0


def test_stiffnesses_have_a_ratio_too():
    """Without residual depths the pressure is uniform: its largest von Mises stress on a half-space is 0.66 of it inside."""
    a = np.linspace(0.2e-6, 1e-6, 9)
    stiffness = 2.0 * a * 100e9 / 0.91
    force = 5e9 * np.pi * a**2
    data = mdi.StiffnessDepth(a**2 / 20e-6 + 0.75 * force / stiffness, force, stiffness, relative_sd=0.01, elastic=False)
    result = mdi.fit(data, BALL, SOLID, ["E"], yield_stresses=[2e9])
    assert 0.6 < result.reverse_yield[0].ratio * 2e9 / 5e9 < 0.9


def test_a_loading_beyond_yield_is_not_elastic():
    depth = np.linspace(1e-9, 100e-9, 60)
    force = np.asarray(mdr.Contact(BALL, SOLID).at_depth(depth).force)
    data = mdi.ForceDepth(depth, force * (1.0 + 1e-3 * np.random.default_rng(0).standard_normal(60)))
    largest = HERTZ * 1.5 * force[-1] / (np.pi * 10e-6 * 100e-9)
    elastic, plastic = (mdi.fit(data, BALL, SOLID, ["E"], yield_stresses=[part * largest]) for part in (1.1, 0.5))
    assert elastic.yield_ratio == pytest.approx(1.0 / 1.1, rel=2e-3) and elastic.verdict == "describes"
    assert plastic.yield_ratio == pytest.approx(2.0, rel=2e-3) and plastic.describes_data is False
    assert plastic.verdict == "plastic, the stress is 2 times the yield stress" in mdi.rate(plastic).reasons
    assert any("2 times the yield stress" in words for words in plastic.warnings)
    assert "THE CONTACT IS PLASTIC, THE MODEL ELASTIC" in plastic.summary()
    assert plastic.to_dict()["yield_ratio"] == plastic.yield_ratio


@pytest.mark.parametrize(
    ("stresses", "words"),
    [
        ([0.0], r"yield_stresses\[0\] = 0: it must be greater than 0"),
        ([-1e9], r"yield_stresses\[0\] = -1e\+09"),
        ([float("nan")], r"yield_stresses\[0\] = nan"),
        ([1e9, 1e9], "yield_stresses has 2 entries: give one for each of 1"),
    ],
)
def test_refusals(stresses, words):
    with pytest.raises(InvalidArgumentError, match=words):
        unloading(medium=SOLID, free=["E"], yield_stresses=stresses)


def test_data_and_bodies_without_stresses():
    data = mdi.ModulusRadius([1e-7, 2e-7, 3e-7], [1e11, 1.1e11, 1.05e11], relative_sd=0.1)
    with pytest.raises(InvalidArgumentError, match="yield stresses need forces"):
        mdi.fit(data, BALL, SOLID, ["E"], yield_stresses=[1e9])
    graded = mdr.Graded([0.0, 1e-6], [100e9, 50e9], 0.3)
    with pytest.raises(InvalidArgumentError, match="a Graded has no layers"):
        unloading(medium=graded, free=["E[0]"], yield_stresses=[1e9])


def test_problem_files_give_the_yield_stresses(tmp_path, capsys):
    depth, force = record()
    np.savetxt(tmp_path / "indent.csv", np.c_[depth * 1e9, force * 1e3], delimiter=",", header="depth (nm),force (mN)", comments="")
    text = (
        '[indenter]\nshape = "berkovich"\n[medium]\ntype = "coated"\n'
        'coating = { E = "400 GPa", nu = 0.25, thickness = "300 nm" }\n'
        'substrate = { E = "70 GPa", nu = 0.33, STRESS }\n'
        '[data]\nkind = "unloading"\n[fit]\nfree = ["coating.E"]\n'
    )
    for stress, status, words in (
        ('yield_stress = "5 GPa"', 0, r"reverse yield ratio R_Y: layer 1 0\.\d\d; unloading"),
        ('hardness = "14 GPa"', 0, r"reverse yield ratio R_Y: layer 1 0\.\d\d ± 0\.0\d; unloading"),
        ('hardness = "420 MPa"', 1, "34 to 43 %"),
        ('yield_stress = "150 MPa"', 1, "34 to 43 %"),
        ('yield_stress = "5 GPa", hardness = "14 GPa"', 2, r"\[medium.substrate\]: yield_stress and hardness exclude each other."),
    ):
        (tmp_path / "p.toml").write_text(text.replace("STRESS", stress), encoding="utf-8")
        assert main(["fit", str(tmp_path / "indent.csv"), "--problem", str(tmp_path / "p.toml")]) == status
        said = capsys.readouterr()
        assert re.search(words, said.out + said.err)
