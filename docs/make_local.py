# SPDX-License-Identifier: GPL-3.0-or-later
"""FORD's pages without the network: make_local.py FOLDER.

They load from other hosts Bootstrap, which MkDocs brings along, and for MathJax, which no docstring needs.
"""

from __future__ import annotations

import re
import shutil
import sys
from pathlib import Path

import mkdocs

BOOTSTRAP = ("css/bootstrap.min.css", "js/bootstrap.bundle.min.js")
_REMOTE = re.compile(
    r'<link href="https?://[^>]*>|<script src="https?://[^>]*></script>|<script type="text/x-mathjax-config">.*?</script>',
    re.DOTALL,
)


def _local(tag: str, up: str) -> str:
    """What stands in the place of `tag` in a page that lies as deep as `up` says."""
    style, script = (f"{up}{name}" for name in BOOTSTRAP)
    if "bootstrap" not in tag:
        return ""
    return f'<link href="{style}" rel="stylesheet">' if tag.startswith("<link") else f'<script src="{script}"></script>'


def main(folder: Path) -> None:
    """All pages below `folder`."""
    for name in BOOTSTRAP:
        shutil.copy(Path(mkdocs.__file__).parent / "themes" / "mkdocs" / name, folder / name)
    for page in folder.rglob("*.html"):
        up = "../" * (len(page.relative_to(folder).parts) - 1)
        text = _REMOTE.sub(lambda found, up=up: _local(found[0], up), page.read_text(encoding="utf-8"))
        if left := re.search(r'<(?:script|link|img)\b[^>]*\b(?:src|href)="https?:[^>]*>', text):
            sys.exit(f"{page}: needs another host: {left[0]}")
        page.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
