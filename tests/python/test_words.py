# SPDX-License-Identifier: GPL-3.0-or-later
"""The words of comments, docstrings, messages and guide: a routine takes, does, returns; no person stands for a caller."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WORDS = re.compile(
    r"\b(ask|asks|asked|asking|tell|tells|told|telling|had|dear|whoever|nobody|somebody|anybody|everybody)\b", re.IGNORECASE
)
FOLDERS = ["recipes", "src", "include", "python", "tests", "tools", "examples", "benchmarks", "docs", "cmake"]
KINDS = {".f90", ".pf", ".c", ".h", ".hpp", ".cpp", ".py", ".md", ".toml", ".cmake", ".txt", ".sh", ".f", ".rs"}
EXCEPTIONS = {"tests/python/test_words.py": "lists them"}


def files():
    """What people read of the project; data and what is built or fetched are not."""
    yield from (ROOT / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md", "ford.md", "CMakeLists.txt"))
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in KINDS and not {"data", "site", "_build", "__pycache__", "problems"} & set(path.parts):
                yield path


def places(text):
    """Lines with a word of the list, and the word."""
    return [(number, found[0]) for number, line in enumerate(text.splitlines(), 1) if (found := WORDS.search(line))]


def test_the_list_is_found():
    assert places("it takes\nwhat it is asked for\nand a dearth") == [(2, "asked")]


def test_no_word_of_the_list():
    found = [
        f"{path.relative_to(ROOT)}:{number}: {word!r}: say what is taken, done, returned"
        for path in files()
        if str(path.relative_to(ROOT)) not in EXCEPTIONS
        for number, word in places(path.read_text("utf-8"))
    ]
    assert not found, "\n".join(found)
