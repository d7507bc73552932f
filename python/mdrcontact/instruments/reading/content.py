# SPDX-License-Identifier: GPL-3.0-or-later
"""The bytes of files of measurements."""

from __future__ import annotations

from pathlib import Path

from ...problem.named import LARGEST_FILE, ProblemError


def content_of(path: Path) -> bytes:
    """All of a file, up to the largest size that is read."""
    content = begin_of(path, LARGEST_FILE + 1)  # of a device there is no end
    if len(content) > LARGEST_FILE:
        raise ProblemError(f"{path}: it has more than {LARGEST_FILE // 1_000_000} MB: that is no measured curve")
    return content


def begin_of(path: Path, count: int) -> bytes:
    """The first bytes of a file."""
    try:
        with path.open("rb") as file:
            return file.read(count)
    except (OSError, ValueError) as problem:
        raise ProblemError(f"{path}: it cannot be read: {getattr(problem, 'strerror', None) or problem}") from problem
