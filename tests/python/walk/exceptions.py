# SPDX-License-Identifier: GPL-3.0-or-later
"""Members that do not matter to an answer, and why: one line a class, member and answer."""

from __future__ import annotations

from typing import NamedTuple


class Exempt(NamedTuple):
    """A member that does not matter to an answer: nowhere, or in one scene or at one place of it."""

    member: str
    """Class.member, and of a choice what it becomes"""
    answer: str
    reason: str
    where: str = ""
    """"", a scene, or a scene and a path"""


EXCEPTIONS: list[Exempt] = []
