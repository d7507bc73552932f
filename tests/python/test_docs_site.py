# SPDX-License-Identifier: GPL-3.0-or-later
"""The build of the documentation finds what is wrong with pages and docstrings."""

from __future__ import annotations

import sys

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "docs" / "site"))

from pages import PageError, ordered, page  # noqa: E402
from undocumented import undocumented  # noqa: E402

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


def _page(text, tmp_path):
    path = tmp_path / "page.md"
    path.write_text(text, encoding="utf-8")
    return page(path, lambda file: f"files/{file.name}")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("No title\n", "must be the title"),
        ("# T\n\n[x](nowhere.md)\n", "line 3: the link 'nowhere.md' leads nowhere"),
        ("# T\n\na costs 3 $ and\n", "line 3: a dollar sign"),
        ("# T\n\n$$a\n", "a dollar sign"),
    ],
)
def test_wrong_pages(text, words, tmp_path):
    with pytest.raises(PageError, match=words):
        _page(text, tmp_path)


def test_pages_for_ford(tmp_path):
    (tmp_path / "other.md").write_text("# Other\n", encoding="utf-8")
    made = _page("# T\n\n$a'$, [o](other.md#x), `$HOME`\n\n```sh file=run.sh\necho $HOME\n```\n", tmp_path)
    assert made.startswith("title: T\n")
    assert "<math" in made and "(other.html#x)" in made and "`$HOME`" in made
    assert '<p class="file">run.sh</p>' in made and "```sh\necho $HOME\n```" in made


def test_the_start_page_leads_to_every_page_but_later_ones():
    names = [path.name for path in ordered(ROOT / "docs")]
    assert names[0] == "index.md" and len(set(names)) == len(names)
    assert set(names) == {path.name for path in (ROOT / "docs").glob("*.md")}
