# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels drawn with Plotly: what the page shows is what a figure file shows."""

import numpy as np
import pytest
from conftest import ROOT

from mdrcontact import problem, studies
from mdrcontact.instruments import load_fit_file
from mdrcontact.panels import Axis, Band, Bars, Cells, Figure, Label, Line, Panel, Rule

pytest.importorskip("matplotlib")
pytest.importorskip("plotly")

from mdrcontact.panels import plotly
from mdrcontact.panels.matplotlib import draw

PROBLEMS, FITS = ROOT / "examples" / "problems", ROOT / "examples" / "fit"
X = np.linspace(0.0, 2.0, 9)


def load(name):
    return problem.load(PROBLEMS / f"{name}.toml")


def fitted(study, name, ending="csv"):
    file = load_fit_file(FITS / f"{name}.toml")
    return study(file, file.read_data(FITS / f"{name}.{ending}")[0])


STUDIES = {
    "fit": lambda: fitted(studies.fit, "raw_afm_on_rubber", "txt"),
    "fit of unloadings": lambda: fitted(studies.fit, "indent_on_oxide", "txt"),
    "fit of a gel": lambda: fitted(studies.fit, "punch_on_hydrogel"),
    "modulus": lambda: fitted(studies.modulus, "csm_on_oxide"),
    "calibrate": lambda: fitted(lambda file, data: studies.calibrate(file, [("one", data)]), "csm_on_silica"),
    "law": lambda: studies.law(load("sio2_on_si")),
    "curve": lambda: studies.curve(load("sio2_on_si"), pressures=True, references=True),
    "compare": lambda: studies.compare(load("sio2_on_si")),
    "stress": lambda: studies.stress(load("tin_on_steel"), maps=True, lines=True),
    "adhesion": lambda: studies.adhesion(load("afm_on_pdms")),
    "friction": lambda: studies.friction(load("tin_on_steel"), loops=True),
    "wear": lambda: studies.wear(load("tin_on_steel")),
    "history": lambda: studies.history(load("creep_of_pmma")),
    "conduction": lambda: studies.conduction(load("tin_on_copper")),
    "inspect": lambda: studies.inspect(FITS / "indent_on_oxide.txt"),
    "many": lambda: studies.many(
        load_fit_file(FITS / "sphere_on_oxide.toml"),
        load_fit_file(FITS / "sphere_on_oxide.toml").curves(FITS / "sphere_on_oxide.csv"),
    ),
}


def figure(*parts, **options):
    return Figure("a title", (Panel(Axis("depth d", "nm"), Axis("force F", "mN"), parts, **options),))


@pytest.mark.parametrize("name", STUDIES)
def test_a_study_has_the_same_axes_and_data_as_its_file(name):
    found = STUDIES[name]().figure()
    drawn = plotly.draw(found)
    axes = [axis for axis in draw(found).axes if axis.get_label() != "<colorbar>"]
    assert len(drawn) == len(found.panels) > 0
    for one, axis, panel in zip(drawn, axes, found.panels, strict=False):
        assert one.layout.xaxis.title.text == axis.get_xlabel() == panel.x.title
        assert one.layout.yaxis.title.text == axis.get_ylabel() == panel.y.title
        assert (one.layout.xaxis.type == "log") == (axis.get_xscale() == "log")
        assert (one.layout.yaxis.type == "log") == (axis.get_yscale() == "log")
        rules = [part for part in panel.parts if isinstance(part, Rule)]
        assert len(one.data) == len(panel.parts) - len(rules) and len(one.layout.shapes) == len(rules)
        lines = [line for line in axis.get_lines() if line.get_transform() == axis.transData and line.get_marker() != "_"]
        drawn_lines = [trace for trace in one.data if trace.type == "scatter" and trace.mode != "none"]
        assert sum(isinstance(part, Band) for part in panel.parts) == sum(
            getattr(trace, "fill", None) == "toself" for trace in one.data
        )
        for trace, line in zip(drawn_lines, lines, strict=True):
            assert np.array_equal(np.asarray(trace.x, dtype=float), np.asarray(line.get_xdata(), dtype=float), equal_nan=True)
            assert np.array_equal(np.asarray(trace.y, dtype=float), np.asarray(line.get_ydata(), dtype=float), equal_nan=True)
        names = [part.name for part in panel.parts if isinstance(part, Line | Band) and part.name]
        assert [trace.name for trace in one.data if trace.showlegend] == names
        assert sorted(axis.get_legend_handles_labels()[1]) == sorted(names)


def test_ends_of_axes():
    (one,) = plotly.draw(figure(Line(X, X), downward=True))
    assert one.layout.yaxis.autorange == "reversed" and one.layout.xaxis.range is None
    sides = Axis("x", low=0.0, high=2.0), Axis("z", low=0.0, high=3.0)
    (one,) = plotly.draw(Figure("", (Panel(*sides, (Line(X, X),), equal=True, downward=True),)))
    assert (one.layout.xaxis.range, one.layout.yaxis.range, one.layout.yaxis.scaleanchor) == ((0.0, 2.0), (3.0, 0.0), "x")
    (one,) = plotly.draw(Figure("", (Panel(Axis("d", low=0.0), Axis("F", log=True, low=0.01, high=10.0), (Line(X, X),)),)))
    assert one.layout.xaxis.autorangeoptions.minallowed == 0.0 and one.layout.yaxis.range == (-2.0, 1.0)


@pytest.mark.parametrize(("ends", "ticks"), [((0.3, 4.0), ("0.5", "1", "2")), ((1.0, 1e4), None)])
def test_a_short_logarithmic_axis_has_ticks_within_decades(ends, ticks):
    (one,) = plotly.draw(Figure("", (Panel(Axis("t", "s", log=True), Axis("F"), (Line(np.array(ends), X[:2]),)),)))
    assert one.layout.xaxis.ticktext is None if ticks is None else set(ticks) < set(one.layout.xaxis.ticktext)


def test_a_map_that_is_cut_off_says_where():
    cells = Cells(X, X[:5], np.outer(X[:5], X), Axis("stress", "GPa", low=0.5, high=1.5))
    (one,) = plotly.draw(figure(cells, Rule(1.0, name="interface"), Label(1.0, 0.5, "film")))
    assert one.data[0].colorbar.title.text == "stress [GPa]<br>ends: \u2264 0.5, \u2265 1.5"
    assert (one.data[0].zmin, one.data[0].zmax) == (0.5, 1.5) and one.layout.shapes[0].layer == "above"
    assert np.array_equal(one.data[0].z, np.outer(X[:5], X).astype(np.float32)) and one.data[1].textfont.shadow
    # one bar for two maps, of which only that without the bar is cut
    rest = cells._replace(values=np.full((5, 9), 1.0))
    assert "ends" in plotly.draw(figure(cells._replace(bar=False), rest))[0].data[1].colorbar.title.text
    assert "ends" not in plotly.draw(figure(rest))[0].data[0].colorbar.title.text


def test_a_band_is_filled_between_its_ends():
    (trace,) = plotly.draw(figure(Band(X, -X, X**2, "error", 1)))[0].data
    assert (trace.mode, trace.fill, trace.fillcolor, trace.name) == ("none", "toself", "#D55E00", "error")
    assert np.array_equal(trace.y, [*-X, *X[::-1] ** 2]) and np.array_equal(trace.x, [*X, *X[::-1]])


def test_looks_of_lines_and_names():
    parts = Line(X, X, "data <b>", 1, -1, "s", error=0.1 * X), Line(X, X, dash=1), Bars(X[:3], X[1:3])
    data, plain, bars = plotly.draw(figure(*parts))[0].data
    assert (data.mode, data.marker.symbol, data.line.color, data.name) == ("markers", "square", "#D55E00", "data &lt;b>")
    assert np.array_equal(data.error_y.array, 0.1 * X) and (plain.mode, plain.line.dash) == ("lines", "dash")
    assert np.array_equal(bars.x, X[:2] + 0.125) and np.array_equal(bars.width, [0.25, 0.25])
    few, many = (plotly.draw(figure(*(Line(X, X, f"model {i}", i) for i in range(n))))[0].layout for n in (6, 7))
    assert (few.legend.orientation, many.legend.orientation) == ("h", None)
    (one,) = plotly.draw(Figure("", (Panel(Axis("curve", names=("a", "b")), Axis("n", whole=True, high=5), (Line(X, X),)),)))
    assert one.layout.xaxis.ticktext == ("a", "b") and one.layout.yaxis.dtick == 1
