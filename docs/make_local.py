# SPDX-License-Identifier: GPL-3.0-or-later
"""Make FORD's pages part of the site: make_local.py FOLDER.

FORD's pages load Bootstrap, lunr and MathJax from other hosts. MkDocs contains the first two; no docstring needs the third. The
search of the site, in the folder above FOLDER, gets an entry for each page.
"""

from __future__ import annotations

import json
import re
import shutil
import sys
from pathlib import Path

import mkdocs

MKDOCS = Path(mkdocs.__file__).parent
LOCAL = {
    "css/bootstrap.min.css": MKDOCS / "themes" / "mkdocs" / "css" / "bootstrap.min.css",
    "js/bootstrap.bundle.min.js": MKDOCS / "themes" / "mkdocs" / "js" / "bootstrap.bundle.min.js",
    "js/lunr.js": MKDOCS / "contrib" / "search" / "templates" / "search" / "lunr.js",
}
_REMOTE = re.compile(
    r'<link href="https?://[^>]*>|<script src="https?://[^>]*></script>|<script type="text/x-mathjax-config">.*?</script>',
    re.DOTALL,
)
_LONGEST_TEXT = 300


def _local(tag: str, up: str) -> str:
    """Return the local version of a tag for a page with the prefix `up` to FOLDER."""
    for name in LOCAL:
        is_style = name.endswith(".css")
        if Path(name).name.partition(".")[0] in tag and tag.startswith("<link") == is_style:
            return f'<link href="{up}{name}" rel="stylesheet">' if is_style else f'<script src="{up}{name}"></script>'
    return ""


def _add_to_search(folder: Path) -> None:
    """Add FORD's pages to the search index of the site."""
    database = (folder / "search" / "search_database.json").read_text(encoding="utf-8")
    pages = json.loads(database.partition("=")[2].strip().rstrip(";"))["pages"]
    index_path = folder.parent / "search" / "search_index.json"
    index = json.loads(index_path.read_text(encoding="utf-8"))
    for page in pages:
        title = page["title"].partition(" – ")[0].strip()
        location = f"{folder.name}/{page['url']}"
        index["docs"].append({"location": location, "title": f"{title} (Fortran)", "text": page["text"][:_LONGEST_TEXT]})
    index_path.write_text(json.dumps(index), encoding="utf-8")


def main(folder: Path) -> None:
    """Treat all pages below `folder`."""
    for name, source in LOCAL.items():
        (folder / name).parent.mkdir(exist_ok=True)
        shutil.copy(source, folder / name)
    for page in folder.rglob("*.html"):
        up = "../" * (len(page.relative_to(folder).parts) - 1)
        text = _REMOTE.sub(lambda found, up=up: _local(found[0], up), page.read_text(encoding="utf-8"))
        if left := re.search(r'<(?:script|link|img)\b[^>]*\b(?:src|href)="https?:[^>]*>', text):
            sys.exit(f"{page}: needs another host: {left[0]}")
        page.write_text(text, encoding="utf-8")
    _add_to_search(folder)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
