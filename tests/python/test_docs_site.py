# SPDX-License-Identifier: GPL-3.0-or-later
"""The build of the documentation finds what is wrong with pages and docstrings."""

from __future__ import annotations

import json
import sys
from types import SimpleNamespace

import pytest
from code_blocks import blocks
from conftest import ROOT
from fortran_docstrings import undocumented
from mkdocs.exceptions import PluginError

sys.path.insert(0, str(ROOT / "docs"))

from hooks import on_page_content, on_page_markdown  # noqa: E402
from make_notebooks import TUTORIALS, notebook  # noqa: E402

DOCUMENTED = """\
!> Facade.
module mdrcontact
    use shapes, only: shape_t, new_shape
    implicit none
    public
end module mdrcontact

!> Shapes.
module shapes
    implicit none
    private
    public :: shape_t, new_shape
    !> A shape.
    type :: shape_t
        !> its size
        real :: size = 0.0
    end type shape_t
contains
    !> Makes a shape.
    subroutine new_shape(self, size)
        type(shape_t), intent(out) :: self
        !> > 0
        real, intent(in) :: size
        real :: local
        local = size
        self%size = local
    end subroutine new_shape
end module shapes
"""


# FORD leaves the files that it reads to the garbage collector
@pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize(
    ("docstring", "name"),
    [
        ("", None),
        ("!> Shapes.\n", "module shapes"),
        ("    !> A shape.\n", "shapes: shape_t"),
        ("        !> its size\n", "shapes: shape_t%size"),
        ("    !> Makes a shape.\n", "shapes: new_shape"),
        ("        !> > 0\n", "shapes: new_shape(size)"),
    ],
)
def test_missing_docstrings(docstring, name, tmp_path):
    (tmp_path / "mdrcontact.f90").write_text(DOCUMENTED.replace(docstring, ""), encoding="utf-8")
    assert undocumented(tmp_path, tmp_path / "nowhere") == ([name] if name else [])


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::pytest.PytestUnraisableExceptionWarning")
def test_everything_public_in_fortran_has_a_docstring():
    assert undocumented(ROOT / "src", ROOT / "src" / "mdrcontact" / "api") == []


PAGE = SimpleNamespace(file=SimpleNamespace(src_uri="page.md"))


@pytest.mark.parametrize("text", ["a costs 3 $ and\n", "$$a\n"])
def test_formulas_that_do_not_close(text):
    with pytest.raises(PluginError, match="page.md: a dollar sign"):
        on_page_markdown(f"# T\n\n{text}", page=PAGE)


@pytest.mark.parametrize("formula", ["$a \\tag{1.1}$", "$$a \\tag{1.1} b$$"])
def test_numbers_that_are_not_at_the_end_of_a_displayed_formula(formula):
    with pytest.raises(PluginError, match="page.md: a number"):
        on_page_markdown(f"# T\n\n{formula}\n", page=PAGE)


def test_numbered_equations():
    made = on_page_markdown("# T\n\n$$g(x)\n= x \\tag{2.1}$$\n", page=PAGE)
    assert made.count("<math") == 1 and "tag" not in made
    assert '<p class="equation" id="eq-2.1"><math' in made and "</math><span>(2.1)</span></p>" in made


def test_links_of_a_page_in_a_folder():
    page = SimpleNamespace(file=SimpleNamespace(src_uri="folder/page.md"))
    made = on_page_markdown("[a](../media.md#b) ![c](../pictures/stress.png) [d](../../README.md) [e](paper.md)", page=page)
    assert made == "[a](../media.md#b) ![c](../pictures/stress.png) [d](../files/README.md.txt) [e](paper.md)"


def test_formulas_titles_and_links():
    text = "# T\n\n$a'$, [o](../README.md), `$HOME`\n\n```sh file=run.sh\necho $HOME\n```\n"
    made = on_page_markdown(text, page=PAGE)
    assert "<math" in made and "](files/README.md.txt)" in made and "`$HOME`" in made
    assert '```sh title="run.sh"\necho $HOME\n```' in made


@pytest.mark.parametrize("page", TUTORIALS, ids=lambda page: page.stem)
def test_notebooks_have_the_code_and_output_of_their_page(page):
    cells = json.loads(notebook(page))["cells"]
    code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    output = ["".join(one["text"]) for cell in cells for one in cell.get("outputs", [])]
    tested = blocks(page)
    magic = {"sh": "%%bash\n", "python": ""}
    assert code == [
        (f"%%writefile {block.file}\n" if block.file else magic[block.language]) + block.text.rstrip("\n")
        for block in tested
        if block.file or block.language in magic
    ]
    assert output == [block.output for block in tested if block.output is not None]
    assert not any("](" in "".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")


def test_a_notebook(tmp_path):
    page = tmp_path / "page.md"
    page.write_text(
        "# T\n\n![a](b.png)\n\n*c* [d](e.md)\n\n```python\nprint(1)\n```\n```text\n1\n```\n\n```sh\nls\n```\n", encoding="utf-8"
    )
    title, one, shell = json.loads(notebook(page))["cells"]
    assert "".join(title["source"]) == "# T\n\n\n*c* d" and "".join(shell["source"]) == "%%bash\nls"
    assert one["source"] == ["print(1)"] and one["outputs"][0]["text"] == ["1\n"]


def test_references_of_docstrings():
    lines = "popov-2014, equation (10)\ngao-1992"
    html = f'<details class="references" open>\n  <summary>References</summary>\n  <p>{lines}</p>\n</details>'
    made = on_page_content(html, page=SimpleNamespace(file=SimpleNamespace(src_uri="python-api/media.md")))
    assert '<p><a href="../bibliography.html#popov-2014">Popov (2014)</a>, equation (10)\n<br><a href="../bibliography' in made
    assert made.count("<a ") == 2 and on_page_content(html, page=PAGE) == html
