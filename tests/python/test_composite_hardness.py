# SPDX-License-Identifier: GPL-3.0-or-later
"""Composite hardness: film and base come back from their own forms; finite elements show the error of each form."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import mdrcontact as mdr
import mdrcontact.instruments as mdi
from mdrcontact import studies
from mdrcontact.cli import main
from mdrcontact.errors import InvalidArgumentError

RATIO = np.array([0.29, 0.54, 0.79, 1.04, 1.29, 1.54, 1.79])
HARD_ON_SOFT = np.array([11.1, 10.2, 8.2, 7.1, 6.3, 5.8, 5.4])
"""Finite elements of a cone: film and base with 4:1 in modulus and yield stress, alone 11.2 and 2.8."""
FILM, BASE = 11.2, 2.8
SHARES = {
    "korsunsky": lambda x: 1.0 / (1.0 + 1.3 * x**2),
    "korsunsky-exponent": lambda x: 1.0 / (1.0 + 0.7 * x**1.4),
    "bhattacharya-nix": lambda x: np.exp(-1.1 * x**2),
    "exponential": lambda x: np.exp(-0.9 * x),
    "jonsson-hogmark": lambda x: np.where(x > 0.5, 1.0 / x - 0.25 / x**2, 1.0),
}
K = {"korsunsky": 1.3, "korsunsky-exponent": 0.7, "bhattacharya-nix": 1.1, "exponential": 0.9, "jonsson-hogmark": 0.5}


@pytest.mark.parametrize("name", SHARES)
@pytest.mark.parametrize("base", [None, 3e9])
def test_each_form_finds_what_made_the_readings(name, base):
    found = mdi.composite_hardness(RATIO, 3e9 + 8e9 * SHARES[name](RATIO), base=base)
    form = found.forms[name]
    assert (found.best, form.film, form.base) == (name, pytest.approx(11e9, rel=1e-7), pytest.approx(3e9, rel=1e-6))
    assert form.k == pytest.approx(K[name], rel=1e-6) and form.residual < 1e-9
    if name == "korsunsky-exponent":
        assert form.exponent == pytest.approx(1.4, rel=1e-6)
    x = np.array([0.1, 3.0])
    assert found.at(x, name) == pytest.approx(3e9 + 8e9 * SHARES[name](x), rel=1e-6)
    assert (form.base_error == 0.0) == (base is not None)


def test_errors_of_the_forms_on_finite_elements():
    """Least squares of the seven rows, weighted by the reading, computed once with SciPy's `least_squares` from five starts."""
    found = mdi.composite_hardness(RATIO, HARD_ON_SOFT)
    residuals = {
        "korsunsky": 1.88,
        "korsunsky-exponent": 1.29,
        "bhattacharya-nix": 1.73,
        "exponential": 2.60,
        "jonsson-hogmark": 1.19,
    }
    films = {"korsunsky": 8.9, "korsunsky-exponent": 2.6, "bhattacharya-nix": 5.4, "exponential": 27.1, "jonsson-hogmark": -0.3}
    bases = {"korsunsky": 37.4, "korsunsky-exponent": 71.6, "bhattacharya-nix": 90.4, "exponential": 38.3, "jonsson-hogmark": -18.4}
    for name, form in found.forms.items():
        assert 100.0 * form.residual == pytest.approx(residuals[name], abs=0.01)
        assert 100.0 * (form.film / FILM - 1.0) == pytest.approx(films[name], abs=0.1)
        assert 100.0 * (form.base / BASE - 1.0) == pytest.approx(bases[name], abs=0.1)
    assert found.shallow == pytest.approx(FILM, rel=0.01), "the shallow reading alone is the better film"
    assert any("the forms disagree about the film by 22 %" in words for words in found.warnings)
    assert found.film == (pytest.approx(11.16, abs=0.01), pytest.approx(14.23, abs=0.01))


def test_a_residual_is_no_measure_of_the_film():
    """Shallow readings left out: each form still follows the others to 2 %, and the films differ by a factor."""
    found = mdi.composite_hardness(RATIO[1:], HARD_ON_SOFT[1:])
    assert max(form.residual for form in found.forms.values()) < 0.02
    assert found.film.upper > 1.5 * FILM
    assert math.isnan(found.shallow) and any("extrapolated by a form" in words for words in found.warnings)


def test_standard_errors_are_those_of_simulated_readings():
    """Scatter of 200 fits of readings with 1 % of noise, given and not given."""
    random = np.random.default_rng(0)
    x = np.linspace(0.2, 2.0, 20)
    true = 3.0 + 8.0 / (1.0 + 1.3 * x**2)
    films, errors = [], []
    for _ in range(200):
        noisy = true * (1.0 + 0.01 * random.standard_normal(len(x)))
        form = mdi.composite_hardness(x, noisy).forms["korsunsky"]
        films.append(form.film)
        errors.append(form.film_error)
    assert np.mean(errors) == pytest.approx(np.std(films), rel=0.1)
    given = mdi.composite_hardness(x, true, sd=0.01 * true).forms["korsunsky"]
    assert given.film_error == pytest.approx(np.std(films), rel=0.1)
    assert mdi.composite_hardness(x, noisy, sd=1e-4 * true).forms["korsunsky"].film_error == pytest.approx(
        form.film_error, rel=0.05
    )


def test_units_order_and_json():
    mixed = np.random.default_rng(0).permutation(len(RATIO))
    one = mdi.composite_hardness(RATIO, HARD_ON_SOFT)
    two = mdi.composite_hardness(RATIO[mixed], 1e9 * HARD_ON_SOFT[mixed])
    for name in one.forms:
        assert two.forms[name].film == pytest.approx(1e9 * one.forms[name].film, rel=1e-6)
    found = json.loads(json.dumps(two.to_dict(), allow_nan=False))
    assert found["best"] == two.best and found["forms"]["korsunsky"]["film"] == two.forms["korsunsky"].film
    assert found["forms"]["jonsson-hogmark"]["exponent"] is None
    assert "film 12.19 ± 0.39 GPa" in two.summary() and "fits of data, no predictions" in two.summary()


@pytest.mark.parametrize(
    ("arguments", "options", "words"),
    [
        ((RATIO[:4], HARD_ON_SOFT[:4]), {}, "too few contact radii: 4; at least 5"),
        ((RATIO, HARD_ON_SOFT[:6]), {}, "the same length"),
        ((RATIO - 0.29, HARD_ON_SOFT), {}, "ratio = 0.0 in entry 0"),
        ((RATIO, HARD_ON_SOFT * np.nan), {}, "hardness = nan in entry 0"),
        ((RATIO, HARD_ON_SOFT), {"sd": 0.0}, "sd = 0.0 in entry 0"),
        ((RATIO, HARD_ON_SOFT), {"base": -1.0}, "base = -1.0: it must be greater than 0"),
        ((RATIO, HARD_ON_SOFT), {"base": math.inf}, "base = inf: it must be greater than 0"),
        (([1.0] * 9, [2.0] * 9), {}, "too few contact radii: 1"),
    ],
)
def test_refusals(arguments, options, words):
    with pytest.raises(InvalidArgumentError, match=words):
        mdi.composite_hardness(*arguments, **options)


def test_refusals_of_readings_between():
    found = mdi.composite_hardness(RATIO, HARD_ON_SOFT)
    with pytest.raises(InvalidArgumentError, match="form = 'korsunski': did you mean"):
        found.at(1.0, "korsunski")
    with pytest.raises(InvalidArgumentError, match="ratio = 0: it must be greater than 0"):
        found.at([1.0, 0.0])
    assert found.at(RATIO[3]).shape == () and found.at(RATIO[3]) == pytest.approx(HARD_ON_SOFT[3], rel=0.03)


def test_a_constant_hardness_has_no_base():
    """A film as hard as its base: both come out, or a form says that it cannot."""
    found = mdi.composite_hardness(RATIO, np.full(7, 5.0))
    for form in found.forms.values():
        assert form.film == pytest.approx(5.0, rel=1e-6)


def test_the_figure_goes_down_to_the_film():
    found = mdi.composite_hardness(RATIO, 1e9 * HARD_ON_SOFT)
    (panel,) = found.plot("hardness").panels
    lines = {part.name: part for part in panel.parts if hasattr(part, "dash") and hasattr(part, "marker")}
    assert set(lines) == {*found.forms, "readings"} and panel.y.unit == "GPa"
    for name, form in found.forms.items():
        assert lines[name].y[0] == pytest.approx(form.film / 1e9, rel=2e-3), "at a/h = 0.001"
        assert lines[name].y[-1] == pytest.approx(float(found.at(1.05 * RATIO[-1], name)) / 1e9, rel=1e-12)
    assert lines["readings"].y == pytest.approx(HARD_ON_SOFT)


def hard_film(composite=True):
    """CSM data of a film of 350 GPa and a base of 210 GPa, with the hardness of the finite elements, or a constant one."""
    tip, film = mdr.AreaFunction([24.5], max_height=1e-5), mdr.Coated(mdr.Elastic(350e9, 0.25), 1e-6, mdr.Elastic(210e9, 0.3))
    ratio = np.linspace(0.25, 1.8, 12)
    a = 1e-6 * ratio
    hardness = 2e9 * np.interp(ratio, RATIO, HARD_ON_SOFT) if composite else 2e10
    force = hardness * np.pi * a**2
    stiffness = 2.0 * a * np.asarray(film.modulus(a))
    shallow = mdr.Contact(mdr.Paraboloid(1e-5), film).at_radius(a)
    sigma = (shallow.depth - a**2 / 2e-5) * shallow.stiffness / shallow.force
    depth = np.sqrt(np.pi * a**2 / 24.5) + sigma * force / stiffness
    return tip, film, mdi.StiffnessDepth(depth, force, stiffness, relative_sd=0.01, elastic=False)


def modulus_of(composite):
    tip, film, data = hard_film(composite)
    text = (
        '[indenter]\nshape = "area-function"\ncoefficients = [24.5]\nlength_unit = "um"\nmax_height = "10 um"\n'
        '[medium]\ntype = "coated"\n'
        'coating = { E = "350 GPa", nu = 0.25, thickness = "1 um" }\nsubstrate = { E = "210 GPa", nu = 0.3 }\n'
        '[data]\nkind = "stiffness-depth"\nrelative_sd = 0.01\nelastic = false\n[fit]\nfree = ["coating.E"]\n'
    )
    return text, data, studies.modulus(mdi.fit_file_of_text(text), data)


def test_hardness_of_film_and_base_next_to_their_modulus(tmp_path, capsys):
    """The study, its command, the table and the JSON file: film and base of each form, with its known error."""
    text, data, found = modulus_of(True)
    hardness = found.hardness
    assert hardness.ratio == pytest.approx(np.linspace(0.25, 1.8, 12), rel=0.01)
    assert found.profile.modulus == pytest.approx(np.full(12, 350e9), rel=0.03)
    assert hardness.shallow == pytest.approx(2e9 * 11.1, rel=0.03)
    names, *columns = found.tables["hardness"]
    assert [*names.values] == [*hardness.forms] and columns[0].values == pytest.approx([f.film for f in hardness.forms.values()])
    assert any("the forms disagree" in words for words in found.doubts)
    np.savetxt(tmp_path / "csm.csv", np.c_[data.x * 1e9, data.force * 1e3, data.y * 1e-3], delimiter=",", comments="",
               header="depth (nm),force (mN),stiffness (mN/um)")  # fmt: skip
    (tmp_path / "p.toml").write_text(text, encoding="utf-8")
    arguments = [str(tmp_path / "csm.csv"), "--problem", str(tmp_path / "p.toml")]
    files = {kind: tmp_path / f"found.{kind}" for kind in ("json", "png", "html")}
    written = [f"--{o}={files[k]}" for o, k in (("json", "json"), ("plot", "png"), ("report", "html"))]
    assert main(["modulus", *arguments, *written]) == 0
    printed = capsys.readouterr().out
    assert "fits of data, no predictions" in printed and "film 9 to 15 % too hard" in printed
    saved = json.loads(files["json"].read_text(encoding="utf-8"))["composite_hardness"]
    assert saved["forms"]["exponential"]["film"] == pytest.approx(hardness.forms["exponential"].film, rel=1e-4)
    assert len(found.figure().panels) == 2 and "fits of data" in files["html"].read_text(encoding="utf-8")


def test_a_hardness_that_does_not_change_has_no_forms():
    _, _, found = modulus_of(False)
    assert found.hardness is None and "hardness" not in found.tables and "composite_hardness" not in found.to_dict()
