# SPDX-License-Identifier: GPL-3.0-or-later
"""The order of the guide: every page is in the index and begins with what it leads to; three paths of five pages; no dead links."""

from __future__ import annotations

import re

import pytest
from conftest import ROOT

DOCS = ROOT / "docs"
PAGES = sorted(DOCS.glob("*.md"))
THEORY = sorted((DOCS / "theory").glob("*.md"))
INDEX = (DOCS / "index.md").read_text()
TABLES = {"bibliography", "glossary"}
"""Pages that are a table to look up."""
NOT_IN_THE_SOURCE_PACKAGE = {"benchmarks"}
"""Folders that it leaves out (pyproject.toml): links to them are looked at where they are."""
LINK = re.compile(r"\]\(([^)\s]+)\)")
CODE = re.compile(r"^```.*?^```$|`[^`\n]*`|\$\$.*?\$\$|\$[^$\n]*\$", re.DOTALL | re.MULTILINE)
"""What holds no links: code and formulas."""


def anchors(text):
    """Of the headings of a page, as GitHub and MkDocs name them, and those that it sets itself."""
    text = re.sub(r"^```.*?^```$", "", text, flags=re.DOTALL | re.MULTILINE)
    headings = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    named = {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}
    return named | set(re.findall(r'<a id="([\w-]+)">', text))


def dead(path):
    """Links of a page to files or headings that are not there."""
    found = []
    for link in LINK.findall(CODE.sub("", path.read_text())):
        name, _, anchor = link.partition("#")
        if name.startswith(("http:", "https:", "mailto:")):
            continue
        target = (path.parent / name).resolve() if name else path
        if any(target.is_relative_to(ROOT / folder) and not (ROOT / folder).exists() for folder in NOT_IN_THE_SOURCE_PACKAGE):
            continue
        if not target.exists() or (anchor and target.suffix == ".md" and anchor not in anchors(target.read_text())):
            found.append(link)
    return found


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.stem)
def test_a_page_begins_with_the_picture_or_number_that_it_leads_to(path):
    first = path.read_text().split("\n", 1)[1].strip().split("\n\n")[0]
    assert path.stem in TABLES or first.startswith("![") or re.match(r"\*\*[^*]*\d", first), first


@pytest.mark.parametrize(
    "path", [*PAGES, *THEORY, *sorted(set(ROOT.glob("*.md")) - {ROOT / "ford.md"})], ids=lambda path: str(path.relative_to(ROOT))
)
def test_no_dead_links(path):
    assert not dead(path)


def test_dead_links_are_found(tmp_path):
    page = tmp_path / "page.md"
    page.write_text('# A title\n\n<a id="key"></a> [a](#a-title) [b](other.md) [c](#no) `[d](x)` [e](#key) $[f](y)$\n')
    assert dead(page) == ["other.md", "#no"]


def test_every_page_is_in_the_index():
    linked = {link.partition("#")[0] for link in LINK.findall(INDEX)}
    assert {path.relative_to(DOCS).as_posix() for path in [*PAGES, *THEORY]} - {"index.md"} <= linked


def test_three_paths_of_five_pages_that_end_with_the_reader():
    paths = [line.strip("| ").split(" | ") for line in INDEX.splitlines() if line.startswith("| ") and "(install.md)" in line]
    assert len(paths) == 3
    for _, *steps in paths:
        assert len(steps) <= 5 and all(LINK.search(step) for step in steps)
        name, _, anchor = LINK.findall(steps[-1])[0].partition("#")
        last = (DOCS / name).read_text().rpartition("\n## ")[2]
        assert anchor in anchors(f"## {last}") and anchor.startswith("your-own-")
