# SPDX-License-Identifier: GPL-3.0-or-later
"""Each key of a problem file for a fit and of a map file, changed, changes what its reader makes of file and measurements, or is
refused with words, or is an exception with its reason."""

import math

import pytest

from .cases import COLUMNS
from .measured import CALIBRATED, FITS, LABELS, MAPS, answer
from .walk import walk

_READ = "the reader finds this column without its title"
_BEYOND = "all readings lie between the limits"
_SAME = "both methods find the same reading"
UNSEEN = {
    **{("*", "data", role, how): _READ for role in COLUMNS for how in ("left out", f"put in as {COLUMNS[role]!r}")},
    ("*", "data", "decimal", "put in as '.'"): "the reader finds the decimal mark",
    ("bare columns", "data", "decimal", "left out"): "the reader finds the decimal mark",
    ("*", "data", "columns", "put in as ['depth [nm]', 'load [mN]']"): "these are the titles of the file",
    ("*", "data", "max_depth", "put in as '500 nm'"): _BEYOND,
    ("*", "data", "min_radius", "put in as '500 nm'"): _BEYOND,
    ("*", "data", "baseline", "put in as 'none'"): "the default",
    ("*", "data", "contact_point", "put in as 'given'"): "the default",
    ("*", "data", "before_pop_in", "put in as True"): "there is no pop-in",
    ("heights", "data", "contact_point", "left out"): "the default",
    ("depths", "data", "contact_point", "'ratio-of-variances'"): _SAME,
    ("force-time", "data", "contact_point", "'ratio-of-variances'"): _SAME,
    ("depth-time", "data", "contact_point", "'ratio-of-variances'"): _SAME,
    ("drift of a hold", "data", "time", "'other time [s]'"): "a drift times a time is the same in any unit of time",
    ("calibrated tip", "the file", "compute", "put in as {'depths': ['31 nm']}"): "other commands read it",
    ("calibrated tip", "medium", "model", "put in as 'exact'"): "the default",
}
"""By case, "*" for any, table, key and change: why nothing changes."""


def _known(place):
    return {place, ("*", *place[1:])} & set(UNSEEN)


@pytest.fixture(scope="module")
def unseen(tmp_path_factory):
    """Case, table, key and change of all that changes nothing."""
    folder = tmp_path_factory.mktemp("walk")
    for name, content in LABELS.items():
        (folder / name).write_bytes(content)
    (folder / "other.toml").write_text(CALIBRATED.files["tip.toml"].replace("190.0", "210.0"), encoding="utf-8")
    found = set()
    for effect in walk([*FITS, CALIBRATED, *MAPS], folder, [], request=answer):
        assert not math.isnan(effect.size) or len(effect.words) > 10
        if effect.is_lost:
            found.add((effect.triple.case, effect.triple.table, effect.triple.key, effect.how))
    return found


def test_each_key_changes_what_is_read(unseen):
    assert not {place for place in unseen if not _known(place)}


def test_every_exception_is_needed(unseen):
    """Some columns are in no file without their title."""
    used = set().union(*map(_known, unseen))
    assert {key for key in UNSEEN if key[2] not in COLUMNS} <= used
