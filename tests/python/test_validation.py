# SPDX-License-Identifier: GPL-3.0-or-later
"""`mdrcontact validate`: every comparison within its bound, missing programs named, a wrong number seen."""

from __future__ import annotations

import dataclasses
import re
import sys

import numpy as np
import pytest
from conftest import ROOT

import mdrcontact as mdr
from mdrcontact.__main__ import main
from mdrcontact.validation import CHECKS, GROUPS
from mdrcontact.validation import page as pages
from mdrcontact.validation.check import comparison
from mdrcontact.validation.limits import refusals

PAGE = (ROOT / "docs" / "validation.md").read_text()


MARKS = {check.name: [pytest.mark.slow] if check.is_long else [] for check in CHECKS}


@pytest.mark.parametrize("check", [pytest.param(check, id=check.name, marks=MARKS[check.name]) for check in CHECKS])
def test_within_what_the_source_explains(check):
    if check.needs:
        pytest.importorskip(check.needs)
    found = check.run()
    assert np.isfinite(found.here).all() and len(found.x) == len(found.here) == len(found.there)
    assert found.deviation <= check.error


def test_a_wrong_number_is_seen(monkeypatch, capsys):
    """A part in a hundred thousand."""
    first = CHECKS[0]

    def spoiled():
        found = first.run()
        return comparison(found.x_name, found.x, found.here * 1.00001, found.there)

    # the name of the module is that of its function
    module = sys.modules["mdrcontact.studies.validate"]
    monkeypatch.setattr(module, "CHECKS", (dataclasses.replace(first, run=spoiled),))
    assert main(["validate"]) == 1
    shown = capsys.readouterr()
    assert "BEYOND" in shown.out and "exceeds the error of the source: hertz" in shown.err


def test_what_is_printed_fits_the_screen_and_ends_with_the_count(monkeypatch, capsys):
    """Also where no program of others is installed: what did not run has a line of its own before the count."""
    module = sys.modules["mdrcontact.studies.validate"]
    done = comparison("x", np.array([1.0]), np.array([1.0]), np.array([1.0]))
    quick = tuple(dataclasses.replace(check, run=lambda: done, needs="") for check in CHECKS)
    monkeypatch.setattr(module, "CHECKS", quick)
    assert main(["validate", "--full"]) == 0
    out = capsys.readouterr().out
    assert max(map(len, out.splitlines())) <= 120
    assert out.endswith(f"\n{len(CHECKS)} of {len(CHECKS)} within their bounds\n")
    assert main(["validate"]) == 0
    long = sum(check.is_long for check in CHECKS)
    left = f"\n{long} of {len(CHECKS)} not run: {long} (--full)\n{len(CHECKS) - long} of {len(CHECKS) - long} within their bounds\n"
    assert capsys.readouterr().out.endswith(left)
    spoiled = dataclasses.replace(quick[0], run=lambda: comparison("x", np.ones(1), 2.0 * np.ones(1), np.ones(1)))
    monkeypatch.setattr(module, "CHECKS", (spoiled, *quick[1:3]))
    assert main(["validate", "--full"]) == 1
    assert capsys.readouterr().out.endswith("2 of 3 within their bounds\n")
    pairs = zip(quick, CHECKS, strict=True)
    monkeypatch.setattr(module, "CHECKS", tuple(dataclasses.replace(one, needs=check.needs) for one, check in pairs))
    monkeypatch.setattr(pages, "is_installed", lambda _: False)
    assert main(["validate", "--full"]) == 0
    lines = capsys.readouterr().out.splitlines()
    left = sum(bool(check.needs) for check in CHECKS)
    assert max(map(len, lines)) <= 120 and lines[-1] == f"{len(CHECKS) - left} of {len(CHECKS) - left} within their bounds"
    assert f"{left} of {len(CHECKS)} not run: 1 (SciPy is not installed), 9 (scikit-fem is not installed)" in "\n".join(lines)


def test_missing_programs_are_named(monkeypatch, capsys):
    monkeypatch.setattr(pages, "is_installed", lambda module: False)
    assert main(["validate", "--only", "elements-bonded"]) == 0
    out = capsys.readouterr().out
    assert out.endswith("1 of 1 not run: 1 (scikit-fem is not installed)\n0 of 0 within their bounds\n")
    assert "scikit-fem is" in out.partition("programs:")[0] and "scikit-fem" not in out.partition("programs:")[2].splitlines()[0]
    assert main(["validate", "--only", "hertzz"]) == 2
    assert "Did you mean 'hertz'" in capsys.readouterr().err


def test_the_files_that_are_written(tmp_path, capsys):
    given = ["validate", "--only", "jkr", "--html", str(tmp_path / "a.html"), "--markdown", str(tmp_path / "a.md")]
    assert main(given) == 0
    text = (tmp_path / "a.html").read_text()
    assert "Johnson, Kendall, Roberts 1971" in text and text.count("data:image/png") == 1
    assert "(pictures/validation_adhesion.png)" in (tmp_path / "a.md").read_text()
    assert [path.name for path in (tmp_path / "pictures").iterdir()] == ["validation_adhesion.png"]
    assert main(given) == 1 and "exists" in capsys.readouterr().err


def test_every_source_is_in_the_bibliography():
    """But those of programs, finite elements of a page of theory, and what is added to a work."""
    anchors = set(re.findall(r'<a id="([\w-]+)">', (ROOT / "docs" / "bibliography.md").read_text(encoding="utf-8")))
    for check in CHECKS:
        linked = re.findall(r"\]\(bibliography\.md#([\w-]+)\)", pages.cited(check.source))
        assert set(linked) <= anchors and (linked or check.needs or "](theory/" in pages.cited(check.source)), check.source
    assert pages.cited("Dupré 1869; Style et al. 2013, fit") == (
        "[Dupré 1869](bibliography.md#dupre-1869); [Style et al. 2013](bibliography.md#style-2013), fit"
    )


def test_the_page_of_the_guide():
    """Each comparison with its command and its picture, each limit in the words and constants of the library, and what to cite."""
    count = f"{len(CHECKS)} of {len(CHECKS)} within their bounds"
    assert f"compares mdrcontact {mdr.__version__} with" in PAGE and f"**Result: {count}.**\n" in PAGE
    assert all(f"{program} " in PAGE for program in ("mdrcontact", "Python", "NumPy", *pages.PROGRAMS.values()))
    for named in re.findall(r"`(python/[\w/]+\.py)`", PAGE):
        assert (ROOT / named).is_file(), named
    for check in CHECKS:
        assert f"| {check.capability} | {pages.cited(check.source)} | " in PAGE and f"--only {check.name}`" in PAGE
    for group in GROUPS:
        picture = ROOT / "docs" / "pictures" / f"validation_{group.name}.png"
        assert f"](pictures/{picture.name})" in PAGE and picture.read_bytes().startswith(b"\x89PNG")
    assert "BEYOND" not in PAGE and "not run" not in PAGE
    for cells in refusals()[1:]:
        assert f"| {' | '.join(cells)} |" in PAGE
        assert cells[-1] != "it is computed"
