# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the tutorials as Jupyter notebooks. python docs/make_notebooks.py FOLDER

The build of the site calls `notebook` for each tutorial, so that page and notebook have the same code.
"""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path
from typing import Any

DOCS = Path(__file__).resolve().parent
TUTORIALS = sorted(DOCS.glob("tutorial-*.md"))
_BLOCK = re.compile(r"^```(\w+)(?: file=(\S+))?\n(.*?)^```$\n?", flags=re.DOTALL | re.MULTILINE)


def notebook(page: Path) -> str:
    """Return a page as a notebook: text, code, and what the page states as the output of the code."""
    text = page.read_text(encoding="utf-8")
    cells: list[dict[str, Any]] = []
    end = 0
    for found in _BLOCK.finditer(text):
        between = text[end : found.start()]
        _add_text(cells, between)
        language, file, code = found.groups()
        if language == "text" and not file and cells and cells[-1]["cell_type"] == "code" and not between.strip():
            cells[-1]["outputs"] = [{"output_type": "stream", "name": "stdout", "text": _lines(code)}]
        elif file or language in ("python", "sh"):
            magic = f"%%writefile {file}\n" if file else "%%bash\n" if language == "sh" else ""
            cells.append({**_cell("code", magic + code), "execution_count": None, "outputs": []})
        else:
            cells.append(_cell("markdown", found[0]))
        end = found.end()
    _add_text(cells, text[end:])
    for i, cell in enumerate(cells):
        cell["id"] = f"cell-{i}"
    kernel = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}
    return json.dumps({"cells": cells, "metadata": kernel, "nbformat": 4, "nbformat_minor": 5}, indent=1, ensure_ascii=False) + "\n"


def _add_text(cells: list[dict[str, Any]], text: str) -> None:
    """Without pictures, which the code draws, and with links as their words: the pages are not next to the notebook."""
    text = re.sub(r"^!\[[^\]]*\]\([^)]*\)\n", "", text, flags=re.MULTILINE)
    text = re.sub(r"\[([^\]]+)\]\((?!https?:)[^)]*\)", r"\1", text).strip("\n")
    if text:
        cells.append(_cell("markdown", text))


def _cell(kind: str, text: str) -> dict[str, Any]:
    return {"cell_type": kind, "metadata": {}, "source": _lines(text.rstrip("\n"))}


def _lines(text: str) -> list[str]:
    return text.splitlines(keepends=True)


if __name__ == "__main__":
    for tutorial in TUTORIALS:
        (Path(sys.argv[1]) / f"{tutorial.stem}.ipynb").write_text(notebook(tutorial), encoding="utf-8")
