# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of many curves as one object, and what notebooks show of results."""

import copy
import pickle
from html.parser import HTMLParser

import numpy as np
import pytest
from conftest import OXIDE, SILICON

import mdrcontact as mdr
from mdrcontact import instruments as mdi

BALL = mdr.Paraboloid(10e-6)
DEPTH = np.linspace(10e-9, 100e-9, 40)


def measured(young, seed, noise=0.01):
    force = mdr.Contact(BALL, mdr.Homogeneous(mdr.Elastic(young, 0.17))).at_depth(DEPTH).force
    return mdi.ForceDepth(DEPTH, force * (1.0 + noise * np.random.default_rng(seed).standard_normal(40)), relative_sd=noise)


def broken():
    return mdi.ForceDepth(DEPTH, np.nan * DEPTH)


@pytest.fixture(scope="module")
def found():
    curves = [measured(70e9, 1), broken, measured(72e9, 2), measured(74e9, 3), measured(71e9, 4, noise=0.6)]
    return mdi.fit_many(curves, BALL, mdr.Homogeneous(mdr.Elastic(50e9, 0.17)), ["E"])


class Cells(HTMLParser):
    """Rows of the tables of a text whose tags are all closed."""

    def __init__(self, text):
        super().__init__()
        self.open, self.rows = [], []
        self.feed(text)
        assert not self.open

    def handle_starttag(self, tag, attrs):
        self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        elif tag in ("th", "td"):
            self.rows[-1].append("")

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open and self.open[-1] in ("th", "td"):
            self.rows[-1][-1] += data


def test_it_is_a_sequence(found):
    assert len(found) == 5 and isinstance(found[1], mdi.FailedFit) and found[-1] is found[4]
    assert isinstance(found[1:3], mdi.FitResults) and list(found[1:3]) == [found[1], found[2]]
    assert [one.position for one in found.failed] == [1] and len(found.fitted) == 4 and found.names == ("E",)
    assert list(mdi.FitResults([found[0], found[1]])) == [found[0], found[1]]
    with pytest.raises(mdr.errors.ArgumentTypeError, match="not float"):
        mdi.FitResults([70e9])
    assert repr(found) == "<FitResults: 5 curves, 4 fitted, 3 sound>"
    for same in (pickle.loads(pickle.dumps(found)), copy.deepcopy(found)):
        assert same.table()["E"] == pytest.approx(found.table()["E"], nan_ok=True)


def test_the_mean_is_that_of_the_sound_fits(found):
    sound = [one for one in found.fitted if mdi.rate(one).is_sound]
    assert found.mean("E") == mdi.mean_of_tests(sound, "E") != found.mean("E", keep_all=True)
    assert found.mean("E", keep_all=True) == mdi.mean_of_tests(found.fitted, "E")
    assert found.mean("E", 0.5).interval.upper < found.mean("E").interval.upper


def test_the_table_has_results_reasons_and_settings(found):
    table = found.table()
    assert {len(column) for column in table.values()} == {5}
    assert np.isnan(table["E"][1]) and table["E"][[0, 2, 3]] == pytest.approx([70e9, 72e9, 74e9], rel=0.02)
    assert table["sound"] == [True, False, True, True, False]
    assert table["warnings"][1].startswith("not fitted: 40 rows are not finite") and "noise 25 %" in table["warnings"][4]
    assert table["fixed nu"][0] == 0.17 and table["indenter"] == ["Paraboloid"] * 5 and table["fixed indenter.radius"][0] == 10e-6


def test_its_figure_and_report(found, tmp_path):
    each, counts = found.plot("Silica").panels
    assert each.x.names == ("0", "2", "3", "4")
    values = {int(each.x.names[int(x) - 1]): 1e9 * y for part in each.parts for x, y in zip(part.x, part.y, strict=True)}
    assert values == pytest.approx({i: one.estimates["E"] for i, one in enumerate(found) if isinstance(one, mdi.FitResult)})
    assert [part.name for part in each.parts] == ["in the mean", "left out of the mean"] and counts.parts[0].counts.sum() == 3
    text = found.report(tmp_path / "report.html", "Silica")
    assert (tmp_path / "report.html").read_text(encoding="utf-8") == text
    assert "4 of 5 curves fitted; 3 of them count in the means." in text and "40 rows are not finite" in text
    assert found._repr_html_().count("<tr>") == 6


def test_nothing_that_could_be_fitted():
    found = mdi.fit_many([broken, broken], BALL, mdr.Homogeneous(OXIDE), ["E"])
    assert found.names == () and found.table()["warnings"][0].startswith("not fitted") and "<table>" in found._repr_html_()
    for part in (found.plot, found.report):
        with pytest.raises(mdr.errors.InvalidArgumentError, match="no curve could be fitted"):
            part()


def test_notebooks_show_states():
    contact = mdr.Contact(BALL, mdr.Coated(OXIDE, 500e-9, SILICON))
    one, many = contact.at_depth(50e-9), contact.at_depth(np.linspace(1e-9, 1e-7, 30))
    titles, row = Cells(one._repr_html_()).rows
    assert titles[:3] == ["depth [length]", "radius [length]", "force [modulus length^2]"]
    assert float(row[2]) == pytest.approx(one.force, rel=1e-4)
    shown = many._repr_html_()
    assert len(Cells(shown).rows) == 21 and shown.endswith("<p>20 of 30 states</p>")
    assert Cells(mdr.State(1e-8, 1e-7, 1e-3, 1e5)._repr_html_()).rows[1][0] == "1.0000e-08"


def test_notebooks_show_fits_and_models():
    film = mdr.Coated(OXIDE, 500e-9, SILICON)
    force = mdr.Contact(BALL, film).at_depth(DEPTH).force
    ranking = mdi.compare_models(mdi.ForceDepth(DEPTH, force, relative_sd=0.01), BALL, film, ["coating.E"], models=["exact", "gao"])
    fit = ranking.models[0].result
    assert fit._repr_html_().startswith(f"<p>{fit.verdict}</p>")
    assert Cells(fit._repr_html_()).rows[1][:2] == ["film modulus E (coating.E)", fit.as_text("coating.E")]
    rows = Cells(ranking._repr_html_()).rows
    assert [row[0] for row in rows] == ["model", "exact", "gao"] and "WRONG HERE" in rows[2][4]
