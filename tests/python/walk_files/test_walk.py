# SPDX-License-Identifier: GPL-3.0-or-later
"""Each key of each table of a problem file, changed, changes what a command says by more than 100 times its tolerance, or is
refused with words, or stands in exceptions.txt with its reason."""

import math

import pytest

from .cases import CASES
from .walk import rules, walk

_EACH = 53
"""The quick run takes one change of that many."""
_HELD = ("the file", "indenter", "medium", "compute", "adhesion", "friction", "wear", "history", "strength", "conduction")
"""Tables whose keys must be used somewhere."""

NEVER = {
    ("the file", "title"): "words for the reader",
    ("the file", "indenter"): "cannot be left out, and its keys are walked",
    ("the file", "medium"): "cannot be left out, and its keys are walked",
    ("the file", "conduction"): "cannot be left out where it is used, and its keys are walked",
    ("the file", "history"): "cannot be left out where it is used, and its keys are walked",
    ("the file", "imprint"): "cannot be left out where it is used, and its keys are walked",
    ("the file", "wear"): "cannot be left out where it is used, and its keys are walked",
    ("medium", "type"): "another type wants other keys: all types are cases",
    ("medium", "coating"): "cannot be left out, and its keys are walked",
    ("medium", "layer"): "cannot be left out, and its keys are walked",
    ("medium", "substrate"): "cannot be left out, and its keys are walked",
    ("medium", "heat_capacity"): "of flow in time, which no command computes",
    ("medium", "tolerance"): "it bounds the error of a solution that is far better",
    ("indenter", "max_height"): "where the samples end, beyond the contact; a smaller one is refused",
    ("conduction", "kind"): "the other one wants other conductivities: both are cases",
}
"""Keys of which no change makes another answer, and why."""


def _lost(effects, known):
    return [
        f"{e.triple.command}/{e.triple.case} | {e.triple.table}:{e.triple.key} | {e.how} | changes the answer by {e.size:.1g}"
        for e in effects
        if e.is_lost and not any(rule.covers(e) for rule in known)
    ]


def test_some_keys_change_what_commands_say(tmp_path):
    """One change of each hundred, of the cases that cost least."""
    known = rules()
    slow = ("relaxing", "surface", "strength", "graded", "axis")
    cases = [case for case in CASES if not any(word in case.name for word in slow)][::4]
    effects = list(walk(cases, tmp_path, known, lambda number: number % _EACH == 0))
    assert len(effects) > 50
    assert not _lost(effects, known)


@pytest.mark.slow
def test_each_key_changes_what_commands_say(tmp_path):
    """All of it; the table of exceptions holds no line too many or too wide, and each key of each table is used by a command."""
    known = rules()
    effects = list(walk(CASES, tmp_path, known))
    print(f"{len({e.triple for e in effects})} triples of key, case and command, {len(effects)} changes, {len(known)} exceptions")
    assert not _lost(effects, known)
    stale = [rule for rule in known if not any(e.is_lost and rule.covers(e) for e in effects)]
    assert not stale, "lines of exceptions.txt that cover nothing"
    wide = [rule for rule in known if any(e.size > 1e-7 and rule.covers(e) for e in effects)]
    assert not wide, "lines of exceptions.txt that cover what does show"
    mute = [e for e in effects if math.isnan(e.size) and len(e.words) < 10]
    assert not mute, "refused without words"
    used = {(e.triple.table, e.triple.key) for e in effects if e.size > 1e-7}
    unused = {(e.triple.table, e.triple.key) for e in effects if e.triple.table in _HELD} - used
    # keys of materials stand in the tables of materials, which readers say
    inside = {key for table, key in used if table.count(".")}
    dead = sorted(place for place in unused if not (place[0] == "medium" and place[1] in inside))
    assert dead == sorted(NEVER)
