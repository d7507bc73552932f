# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures as data, and what matplotlib draws of them."""

import numpy as np
import pytest
from conftest import ROOT

import mdrcontact as mdr
from mdrcontact import problem, studies
from mdrcontact._units import LENGTH, with_micro, without_micro
from mdrcontact.panels import Axis, Band, Bars, Cells, Figure, Label, Line, Panel, Rule, along, cut, marked

pytest.importorskip("matplotlib")

from mdrcontact.panels.matplotlib import draw, rendered

X = np.linspace(0.0, 2.0, 9)
GRID = Cells(X, X[:5], np.outer(X[:5], X), Axis("stress", "GPa", low=0.5, high=1.5))


def figure(*parts, **options):
    return Figure("a title with $", (Panel(Axis("depth d", "nm"), Axis("force F", "mN"), parts, **options),))


def test_what_is_drawn_is_what_is_there():
    parts = (Line(X, X**2, "model"), Line(X, X, "data", 1, -1, "o", error=0.1 * X), Rule(1.0, vertical=True, name="a = h"))
    axis = draw(figure(*parts, Label(1.0, 1.0, "here"))).axes[0]
    assert (axis.get_xlabel(), axis.get_ylabel()) == ("depth d [nm]", "force F [mN]")
    assert [text.get_text() for text in axis.get_legend().get_texts()] == ["model", "data"]
    assert {text.get_text() for text in axis.texts} == {"a = h", "here"}
    assert np.array_equal(axis.lines[0].get_ydata(), X**2)


def test_names_of_vertical_rules_are_below_each_other():
    rules = [Rule(1.0 + 1e-3 * i, vertical=True, name=f"contact point {i}") for i in range(3)]
    drawn = draw(figure(Line(X, X), *rules))
    drawn.canvas.draw()
    boxes = [text.get_window_extent() for text in drawn.axes[0].texts]
    assert not any(one.overlaps(other) for i, one in enumerate(boxes) for other in boxes[:i])


def test_a_band_is_filled_and_a_warning_is_below_the_figure():
    drawn = draw(figure(Band(X, -X, X, "error"))._replace(warnings=("the film yields",)))
    assert drawn.axes[0].get_legend_handles_labels()[1] == ["error"]
    assert drawn.get_supxlabel() == "the film yields" and not draw(figure()).get_supxlabel()


def test_titles_of_any_length_are_in_the_figure():
    drawn = draw(figure(Line(X, X))._replace(title="\n".join(["a film on a substrate " * 9, "E = 72 GPa"])))
    drawn.canvas.draw()
    box, whole = drawn._suptitle.get_window_extent(), drawn.bbox
    assert whole.x0 <= box.x0 and box.x1 <= whole.x1
    assert drawn.get_suptitle().splitlines()[-1] == "E = 72 GPa"


def test_a_map_that_is_cut_off_has_arrows_and_a_quantity():
    smooth, bar = draw(figure(GRID)).axes
    assert bar.get_ylabel() == "stress [GPa]" and smooth.collections
    pixels = draw(figure(GRID._replace(smooth=False), equal=True, downward=True)).axes[0]
    assert pixels.yaxis_inverted() and pixels.get_aspect() == 1.0
    for cells, extend in ((GRID, "both"), (GRID._replace(axis=Axis("stress", "GPa")), "neither")):
        assert draw(figure(cells)).axes[0].collections[0].extend == extend


def test_many_names_have_one_legend_below_the_figure():
    lines = tuple(Line(X, i * X, f"model {i}", i) for i in range(8))
    drawn = draw(Figure("", (figure(*lines).panels[0],) * 3, columns=3))
    assert len(drawn.legends) == 1 and not any(axis.get_legend() for axis in drawn.axes)


@pytest.mark.parametrize(
    ("written", "shown"),
    [
        ("5 um", "5 \u00b5m"), ("[um]", "[\u00b5m]"), ("um", "\u00b5m"), ("GPa/um", "GPa/\u00b5m"), ("5um^2", "5\u00b5m^2"),
        ("uN*m", "\u00b5N*m"),
        ("2 us", "2 \u00b5s"), ("us", "\u00b5s"), ("column", "column"), ("tell us", "tell us"), ("nu 0.3 mu F", "nu 0.3 mu F"),
    ],
)  # fmt: skip
def test_the_micro_sign_is_that_of_units(written, shown):
    assert with_micro(written) == shown and without_micro(shown) == written


def test_counts_and_names_of_an_axis():
    drawn = draw(Figure("", (Panel(Axis("curve", names=("a", "b")), Axis("E", "GPa"), (Bars(X[:3], X[:2]),)),)))
    assert [text.get_text() for text in drawn.axes[0].get_xticklabels()] == ["a", "b"]


@pytest.mark.parametrize("form", ["png", "pdf", "svg"])
def test_a_figure_is_the_same_file_whenever_it_is_drawn(form):
    assert rendered(draw(figure(GRID)), form) == rendered(draw(figure(GRID)), form)


def test_a_notebook_shows_figures_and_drawings():
    assert figure(GRID)._repr_png_()[:4] == draw(figure(GRID))._repr_png_()[:4] == b"\x89PNG"


@pytest.mark.parametrize("name", ["afm_on_pdms", "sio2_on_si"])
def test_a_text_meets_no_line(name):
    """ "a = h" crossed curves that rise through its point."""
    found = studies.curve(problem.load(ROOT / "examples" / "problems" / f"{name}.toml"), references=True)
    drawn = draw(found.figure())
    drawn.canvas.draw()
    texts = 0
    for axis in drawn.axes:
        lines = [line.get_path().transformed(line.get_transform()) for line in axis.get_lines() if len(line.get_xdata()) > 1]
        for text in axis.texts:
            texts += 1
            assert not any(line.intersects_bbox(text.get_window_extent(), filled=False) for line in lines), text.get_text()
    assert texts >= 3


def test_forces_below_zero_are_inside_the_panel():
    """The coating alone pulls at depths at which the coated body pushes."""
    found = studies.curve(problem.load(ROOT / "examples" / "problems" / "afm_on_pdms.toml"), references=True)
    axis = draw(found.figure()).axes[0]
    assert min(line.get_ydata().min() for line in axis.get_lines()) < -20.0
    assert axis.get_ylim()[0] < min(line.get_ydata().min() for line in axis.get_lines())


def test_small_helpers():
    axis, unit = along("depth d", LENGTH, [2e-9, 5e-8], log=True)
    assert (axis.title, axis.log, float(unit.of(1e-9))) == ("depth d [nm]", True, 1.0)
    assert (marked(X), marked(np.arange(99))) == ("o", "")
    assert np.array_equal(cut(X, 0.5, 1.5), [np.nan, np.nan, 0.5, 0.75, 1.0, 1.25, 1.5, np.nan, np.nan], equal_nan=True)


def test_a_study_has_the_numbers_of_its_figure():
    found = studies.curve(problem.load(ROOT / "examples" / "problems" / "sio2_on_si.toml"), pressures=True, references=True)
    force, radius, stiffness, modulus, pressure = found.figure().panels
    assert [panel.y.title for panel in (force, radius, stiffness)] == [
        "force F [mN]",
        "contact radius a [\u00b5m]",
        "contact stiffness k [kN/m]",
    ]
    assert 1e-3 * force.parts[0].y == pytest.approx(found.states.force, rel=1e-15)
    assert modulus.x == Axis("a/h", log=True) and len(pressure.parts) == 3


def test_a_figure_is_saved(tmp_path):
    for form, begin in (("png", b"\x89PNG"), ("pdf", b"%PDF"), ("svg", b"<?xml")):
        figure(Line(X, X)).save(tmp_path / f"figure.{form}")
        assert (tmp_path / f"figure.{form}").read_bytes().startswith(begin)
    with pytest.raises(mdr.errors.InvalidArgumentError, match=r"figure\.jpg: the name of a figure must end in \.png, \.pdf, \.svg"):
        figure(Line(X, X)).save(tmp_path / "figure.jpg")
