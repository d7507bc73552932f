# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures and tables of the guide come from their scripts."""

from __future__ import annotations

import importlib.util
import re
import sys

import pytest
from conftest import ROOT, run

from mdrcontact.validation import GROUPS

DOCS = ROOT / "docs"
SHOWN = {name for page in DOCS.glob("*.md") for name in re.findall(r"\]\(pictures/([\w.]+)\)", page.read_text(encoding="utf-8"))}


@pytest.mark.slow
@pytest.mark.parametrize(("script", "options"), [("make_pictures.py", ["--quick"]), ("make_fitting_pictures.py", [])])
def test_pictures_are_drawn(script, options, tmp_path):
    run([sys.executable, "-W", "error", DOCS / script, tmp_path, *options], tmp_path)
    drawn = {path.name for path in tmp_path.iterdir()}
    assert drawn and drawn <= {path.name for path in (DOCS / "pictures").iterdir()}
    for path in tmp_path.iterdir():
        assert path.read_bytes()[:8] == b"\x89PNG\r\n\x1a\n" and path.stat().st_size > 3000, path.name


def test_every_picture_has_a_script_and_a_page():
    kept = {path.name for path in (DOCS / "pictures").iterdir()}
    makers = ("make_pictures.py", "make_fitting_pictures.py", "make_app_pictures.py")
    scripts = "".join((DOCS / name).read_text(encoding="utf-8") for name in makers)
    scripts += " ".join(f"validation_{group.name} " for group in GROUPS)  # by mdrcontact validate
    scripts += " ".join(f"gallery_{path.stem}" for path in (ROOT / "examples" / "python").glob("*.py"))  # by docs/make_gallery.py
    assert kept >= SHOWN
    for name in kept:
        stem = name.removesuffix(".png")
        assert stem in scripts or stem.removeprefix("fit_") in scripts, f"{name} has no script"
        assert (DOCS / "pictures" / name).stat().st_size < 100_000, f"{name} is large"


@pytest.mark.parametrize("page", ["cli.md", "problem-files.md"])
def test_commands_and_keys_are_those_of_the_package(page):
    spec = importlib.util.spec_from_file_location("make_tables", DOCS / "make_tables.py")
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    before, after = made.with_tables(page)
    assert before == after, f"run docs/make_tables.py {page}"


@pytest.mark.slow
def test_tables_are_what_the_library_computes():
    run([sys.executable, DOCS / "make_tables.py", "--check"], DOCS)
