# SPDX-License-Identifier: GPL-3.0-or-later
"""The host's rounding mode: numbers are those of rounding to nearest, or refused."""

import contextlib
import ctypes
import platform

import numpy as np
import pytest
from hypothesis import strategies as st

import mdrcontact as mdr

from . import draws as d
from .harness import near, relation
from .test_time import constant

MODES = {"x86_64": {"downward": 0x400, "upward": 0x800, "to zero": 0xC00},
         "aarch64": {"downward": 0x800000, "upward": 0x400000, "to zero": 0xC00000}}.get(platform.machine(), {})  # fmt: skip
"""Of fesetround; nearest is 0."""
pytestmark = pytest.mark.skipif(not MODES or platform.system() != "Linux", reason="the codes of the modes are those of glibc")
modes = st.sampled_from(sorted(MODES) or ["upward"])


@contextlib.contextmanager
def rounding(mode):
    """The calling thread rounds so."""
    library = ctypes.CDLL(None)
    library.fesetround(MODES[mode])
    try:
        yield
    finally:
        library.fesetround(0)


@relation(2, mode=modes, material=constant, base=d.usual, R=d.lengths, may_refuse=1.0)
def test_histories(mode, material, base, R):
    """A marched history in another rounding mode against that in rounding to nearest."""
    contact = mdr.Contact(mdr.Paraboloid(R), mdr.Coated(material, 0.2, base))
    t, depth = np.arange(4) * 0.5, np.array([0.0, 0.05, 0.0, 0.04])
    expected = contact.history(t, depth=depth).force
    with rounding(mode):
        found = contact.history(t, depth=depth).force
    near(found, expected, 2e-5, size=np.max(expected))


@relation(20, mode=modes, medium=d.exact_films, R=d.lengths, share=d.shares, may_refuse=1.0)
def test_states_and_fields(mode, medium, R, share):
    """States and stresses in another rounding mode against those in rounding to nearest."""
    contact = mdr.Contact(mdr.Paraboloid(R), medium)
    a = 0.5 * share
    r, z = np.array([0.0, 0.3]), np.array([0.0, 0.05])
    state = contact.at_radius(a)
    expected = state.interior(r, z)
    with rounding(mode):
        again = mdr.Contact(mdr.Paraboloid(R), medium)
        other = again.at_radius(a)
        field = other.interior(r, z)
    near(other.force, state.force, 1e-9)
    for name in ("s_rr", "s_tt", "s_zz"):
        near(getattr(field, name), getattr(expected, name), 1e-8, size=np.max(np.abs(expected.s_zz)))


@relation(10, mode=modes, medium=d.exact_films, R=d.lengths, may_refuse=1.0)
def test_laws(mode, medium, R):
    """A law made in another rounding mode against the law made in rounding to nearest."""
    contact = mdr.Contact(mdr.Paraboloid(R), medium)
    law = mdr.ContactLaw(contact, 0.05)
    with rounding(mode):
        compiled = mdr.ContactLaw(contact, 0.05)
    x = np.array([0.005, 0.02, 0.05])
    near(compiled.force(x), law.force(x), 1e-8)
