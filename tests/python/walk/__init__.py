# SPDX-License-Identifier: GPL-3.0-or-later
"""The walk: every member of every object of physics matters to every answer that it serves, or is refused, or is an exception
with a reason.

    tree        members of objects, and how each is changed
    answers     what objects answer, as numbers
    scenes      objects in which every member is present once, and the answers that they serve
    exceptions  members that do not matter to an answer, one line each, and why
    run         goes from scene to scene
"""
