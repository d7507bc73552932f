# SPDX-License-Identifier: GPL-3.0-or-later
"""Writing of result files.

A file is written next to its place, flushed, closed and then moved there: a reader of the name finds the old content or the new,
and a full disk costs nothing but an error. A symbolic link is followed, its target replaced. What exists and is not a regular file
(a folder, a device, a pipe) or is write-protected is left alone.
"""

from __future__ import annotations

import os
import secrets
import stat
from pathlib import Path

from .errors import FileError


def check_place(path: str | os.PathLike[str]) -> Path:
    """The file that `path` means once links are followed; `FileError` if it must not be written."""
    place = Path(os.path.realpath(path))
    try:
        mode = place.lstat().st_mode
    except FileNotFoundError:
        if not place.parent.is_dir():
            folder = place.parent if Path(path).is_symlink() else Path(path).parent
            raise FileError(f"{os.fspath(path)}: there is no folder {folder}") from None
        return place
    except OSError as problem:
        raise FileError(f"{os.fspath(path)}: it cannot be written: {problem.strerror}") from problem
    if stat.S_ISDIR(mode):
        raise FileError(f"{os.fspath(path)} is a folder, not a file")
    if not stat.S_ISREG(mode):
        raise FileError(f"{os.fspath(path)} is not a regular file: nothing is written to devices, pipes and circles of links")
    if not os.access(place, os.W_OK):
        raise FileError(f"{os.fspath(path)} is write-protected")
    return place


def replace(path: str | os.PathLike[str], content: bytes) -> None:
    """Makes the file `path`, or replaces it, with its permissions kept; `FileError`, and everything as it was, if that fails."""
    place = check_place(path)
    beside = place.parent / f".mdrcontact-{secrets.token_hex(8)}.tmp"
    try:
        with beside.open("xb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
            if place.exists():
                beside.chmod(stat.S_IMODE(place.stat().st_mode))
        beside.replace(place)
    except OSError as problem:
        raise FileError(f"{os.fspath(path)}: it cannot be written: {problem.strerror or problem}") from problem
    finally:
        beside.unlink(missing_ok=True)
