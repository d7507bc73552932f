# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages of theory and the sources cite each other: every equation, file and work that is cited is there."""

from __future__ import annotations

import re

import pytest
from conftest import ROOT

DOCS = ROOT / "docs"
PAGES = sorted((DOCS / "theory").glob("*.md"))
FOLDERS = ("src", "python", "include", "tests", "examples", "benchmarks", "tools")
KINDS = {".f90", ".pf", ".f", ".c", ".h", ".hpp", ".cpp", ".py", ".pyi", ".rs", ".sh", ".csv", ".txt", ".md", ".toml", ".inc"}
NUMBER = r"\(\d+\.\d+\)"
CITATION = re.compile(rf"theory/(\w+)\.md((?:\s*(?:,|;|and|-)?\s*{NUMBER})*)")
LEFTOVER = re.compile(r"\btheory(?: of \w+)? \d|\btheory_[a-z]\w*|\btheory\.md\b|section \d+ of (?:the )?theory")
BREAK = re.compile(r"\s*\n\s*(?:!>|!<|!|#|\*(?!/)|//)?\s*")
"""A line break in a comment or a docstring."""
LINK = re.compile(r"\]\((?:\.\./|docs/)*bibliography\.md#([\w-]+)\)")


def text_of(path):
    """The text of a file, its comments on one line."""
    return BREAK.sub(" ", path.read_text(encoding="utf-8"))


def sources():
    """The texts of all files that may cite the theory: not this one, nor a room's page, which links to whole pages."""
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*")):
            built = {"__pycache__", "problems", "build", "site"} & set(path.relative_to(ROOT).parts)
            if path.suffix in KINDS and path.is_file() and not built and path.name not in ("test_theory.py", "README.md"):
                yield path, text_of(path)


def page_text(page):
    """The text of a page without its blocks of code."""
    return re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)


def equations(text):
    """(section, number) of each numbered equation of a page, in order: the section is that of the heading above it."""
    found, section = [], 0
    for line in re.finditer(r"^## (\d+)\. |\\tag\{(\d+)\.(\d+)\}", text, re.MULTILINE):
        if line[1]:
            section = int(line[1])
        else:
            found.append((section, (int(line[2]), int(line[3]))))
    return found


def unresolved(text, pages):
    """Citations in a text that lead to no equation; `pages` are the numbers of each page."""
    wrong = []
    for name, numbers in CITATION.findall(text):
        cited = re.findall(r"\((\d+\.\d+)\)", numbers)
        if not cited:
            wrong.append(f"theory/{name}.md: no equation")
        wrong += [f"theory/{name}.md ({number})" for number in cited if number not in pages.get(name, ())]
    return wrong


def listed(text):
    """The files and folders in the last section of a page."""
    *_, heading, last = re.split(r"^## (.*)$", text, flags=re.MULTILINE)
    return [name for name in re.findall(r"`([\w./-]+)`", last) if "/" in name] if heading == "Files" else []


NUMBERS = {page.stem: {f"{i}.{j}" for _, (i, j) in equations(page_text(page))} for page in PAGES}


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        ("theory/wear.md (5.2)", []),
        ("theory/wear.md (5.2), (5.3) and (6.1)-(6.2)", ["theory/wear.md (6.2)"]),
        ("theory/wear.md", ["theory/wear.md: no equation"]),
        ("theory/wear.md and (a)", ["theory/wear.md: no equation"]),
        ("theory/heat.md (5.2)", ["theory/heat.md (5.2)"]),
    ],
)
def test_citations_that_lead_nowhere_are_found(text, wrong):
    assert unresolved(text, {"wear": {"5.2", "5.3", "6.1"}}) == wrong


def test_a_citation_goes_on_in_the_next_line_of_a_comment(tmp_path):
    for sign in ("!>", "#", " *", "//", ""):
        path = tmp_path / "file"
        path.write_text(f"{sign} theory/wear.md\n    {sign} (5.2),\n{sign} (5.3); theory of\n{sign} time 4")
        assert re.findall(r"\d\.\d", CITATION.search(text_of(path))[2]) == ["5.2", "5.3"]
        assert LEFTOVER.search(text_of(path))


@pytest.mark.parametrize("text", ["(theory 5)", "theory of time 2", "theory_surfaces 6", "docs/theory.md", "section 3 of theory"])
def test_leftovers_are_found(text):
    assert LEFTOVER.search(text)


def test_every_cited_equation_exists():
    wrong = {str(path.relative_to(ROOT)): found for path, text in sources() if (found := unresolved(text, NUMBERS))}
    assert not wrong


def test_no_leftover_citations():
    """Sections of pages that are gone, or of pages that the repository does not hold."""
    left = {str(path.relative_to(ROOT)): found for path, text in sources() if (found := LEFTOVER.findall(text))}
    assert not left


def test_no_page_links_to_the_page_that_was_divided():
    pages = {*DOCS.rglob("*.md"), *ROOT.glob("*.md")} - {ROOT / "CHANGELOG.md"}
    assert not [page.name for page in pages if re.search(r"\btheory\.md\b", page.read_text(encoding="utf-8"))]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_equations_rise_within_the_sections_of_a_page(page):
    found = equations(page_text(page))
    assert found
    assert [number for _, number in found] == sorted({number for _, number in found})
    assert all(section == number[0] for section, number in found), found


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_a_page_ends_with_its_files_which_exist(page):
    names = listed(page_text(page))
    assert names
    assert not [name for name in names if not (ROOT / name).exists()]


def test_every_file_of_src_that_cites_a_page_is_listed_there():
    lists = {page.stem: listed(page_text(page)) for page in PAGES}
    missing = []
    for path, text in sources():
        name = path.relative_to(ROOT).as_posix()
        if name.startswith("src/"):
            for page in sorted({page for page, _ in CITATION.findall(text)} & set(lists)):
                if not any(name == entry or (entry.endswith("/") and name.startswith(entry)) for entry in lists[page]):
                    missing.append(f"{page}.md: {name}")
    assert not missing


def test_cited_works_are_in_the_bibliography():
    keys = re.findall(r'<a id="([\w-]+)"></a>', (DOCS / "bibliography.md").read_text(encoding="utf-8"))
    assert keys == sorted(set(keys)), "sorted, each once"
    cited = {key for page in [*DOCS.rglob("*.md"), *ROOT.glob("*.md")] for key in LINK.findall(page.read_text(encoding="utf-8"))}
    assert cited <= set(keys), sorted(cited - set(keys))
