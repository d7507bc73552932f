# SPDX-License-Identifier: GPL-3.0-or-later
"""What the page has: the text of a problem file, the files that were dropped on it, and its results."""

from __future__ import annotations

import atexit
import hmac
import re
import secrets
import shutil
import tempfile
import threading
from collections.abc import Mapping
from pathlib import Path

from ..errors import FileError, InvalidArgumentError
from ..instruments.files.fit_file import FitFile, fit_file_of_text
from ..problem import Problem, read_text
from ..problem.named import LARGEST_FILE
from .jobs import Jobs

MOST_FILES = 2000
LARGEST_SUM = 10 * LARGEST_FILE
_LONGEST = 100
_FOREIGN = re.compile(r"[^\w .()+=,\[\]-]")


class Session:
    """The state of the page.

    `text` is what the page shows first. Texts of the page open only `files`: those that the user dropped on it, and those that the
    command line named.
    """

    def __init__(self, text: str = "", files: Mapping[str, Path] | None = None) -> None:
        self.text, self.secret, self.jobs = text, secrets.token_urlsafe(24), Jobs()
        self.once, self._unused = secrets.token_urlsafe(24), threading.Semaphore()
        """opens the page once: the address of a browser that is started is in the list of processes, which others read"""
        self.files = dict(files or {})
        """paths by name"""
        # only this user may open it
        self._folder = Path(tempfile.mkdtemp(prefix="mdrcontact-"))
        atexit.register(self.close)

    def opens(self, given: str) -> bool:
        """Whether this is what opens the page once, for the first time."""
        return hmac.compare_digest(given.encode(), self.once.encode()) and self._unused.acquire(blocking=False)

    def add(self, contents: Mapping[str, bytes]) -> list[str]:
        """Keep files that were dropped together, and return their cleaned names. A file of a name that is
        there is replaced, and results of it are forgotten."""
        if len(self.files) + len(contents) > MOST_FILES:
            raise InvalidArgumentError(f"files: they are more than {MOST_FILES}. Drop fewer.")
        names: list[str] = []
        for name in contents:
            names.append(_unlike(cleaned(name), names))
        kept = sum(one.stat().st_size for one in self._folder.iterdir() if one.name not in names)
        for name, content in zip(names, contents.values(), strict=True):
            kept += len(content)
            if len(content) > LARGEST_FILE or kept > LARGEST_SUM:
                raise InvalidArgumentError(
                    f"{name}: it has more than {LARGEST_FILE // 1_000_000} MB, or all files together more than "
                    f"{LARGEST_SUM // 1_000_000} MB. Drop smaller files."
                )
        replaced = self.files.keys() & names
        for name, content in zip(names, contents.values(), strict=True):
            place = self._folder / name
            place.write_bytes(content)
            self.files[name] = place
        if replaced:
            self.jobs.forget()
        return names

    def path(self, name: str) -> Path:
        """Return the path of a file by its name."""
        if name not in self.files:
            raise FileError("The files that were dropped are no longer there. Drop them again.")
        return self.files[name]

    def shortened(self, words: str) -> str:
        """Return words, or what JSON has of them, in which dropped files have no folder."""
        folder = f"{self._folder}/"
        return words.replace(folder, "").replace(folder.replace("/", "\\u002f"), "")

    def problem(self, text: str) -> Problem:
        """Return the problem of a text."""
        return read_text(text, files=self.files)

    def fit_file(self, text: str) -> FitFile:
        """Return the problem of a fit of a text."""
        return fit_file_of_text(text, files=self.files)

    def close(self) -> None:
        """End the job that runs, and remove the files that were dropped."""
        self.jobs.cancel()
        shutil.rmtree(self._folder, ignore_errors=True)
        atexit.unregister(self.close)


def cleaned(name: str) -> str:
    """Return a file name without folders and without signs that mean something to a system; it keeps its suffix."""
    last = re.split(r"[/\\]", name)[-1]
    stem, dot, suffix = _FOREIGN.sub("_", last).strip(" .").rpartition(".")
    suffix = suffix[:20]
    return f"{stem[: _LONGEST - len(suffix)]}{dot}{suffix}" or "file"


def _unlike(name: str, others: list[str]) -> str:
    """Return a name that differs from others, by a number before its suffix."""
    stem, dot, suffix = name.rpartition(".")
    number = 1
    while name in others:
        number += 1
        name = f"{stem} ({number}){dot}{suffix}" if dot else f"{suffix} ({number})"
    return name
