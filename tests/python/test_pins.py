# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of the whole library against tests/data/pins.txt."""

import subprocess
import sys

from conftest import ROOT

sys.path.insert(0, str(ROOT / "tools"))

import pin  # noqa: E402


def test_no_number_has_changed():
    """Of states, fields, stresses, friction, time, laws, fits and composites; `tools/pin.py` says what it allows."""
    done = subprocess.run([sys.executable, ROOT / "tools" / "pin.py"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert int(done.stdout.splitlines()[-1].split()[0]) > 3000


def test_pins_notice_a_change():
    """A last digit, a refusal, another count of numbers and a number that is none any more."""
    assert pin.deviation("1.0 2.0 | 1e-09", "1.0 2.0 | 1e-09") == 0.0
    assert 0.9e-12 < pin.deviation("1.0 2.0 | 1e-09", "1.0 2.0 | 1.000000000001e-09") < 1.1e-12
    for other in ("DomainError", "1.0 2.0 3.0 | 1e-09", "1.0 2.0", "1.0 nan | 1e-09", "1.0 2.0 | inf"):
        assert pin.deviation("1.0 2.0 | 1e-09", other) > 1.0
