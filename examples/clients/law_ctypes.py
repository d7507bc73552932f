# SPDX-License-Identifier: GPL-3.0-or-later
"""The C library of the Python package by ctypes: no compiler, no second installation. The same calls serve cffi, Julia, C# and
others that load a shared library by its path.

Hertz's contact is made by calls of C, and its force compared with the closed form."""

import ctypes
import math

import mdrcontact

library = ctypes.CDLL(mdrcontact.get_library())
library.mdr_last_error.restype = ctypes.c_char_p
Handle = ctypes.c_void_p
UNLOADING = 302  # MDR_ON_UNLOADING of mdrcontact.h


def call(name, *arguments):
    """Calls a function; the words of a failure are those of this thread's last one."""
    if getattr(library, name)(*arguments):
        raise RuntimeError(library.mdr_last_error().decode())


def main():
    E, nu, R, depth = 72e9, 0.17, 1e-5, 1e-7
    ball, body, contact, law = Handle(), Handle(), Handle(), Handle()
    call("mdr_profile_paraboloid", ctypes.c_double(R), ctypes.byref(ball))
    call("mdr_medium_contact_modulus", ctypes.c_double(E / (1 - nu**2)), ctypes.byref(body))
    call("mdr_contact_new", ball, body, None, ctypes.byref(contact))
    call("mdr_law_new", contact, ctypes.c_double(2 * depth), None, ctypes.byref(law))
    force, slope = ctypes.c_double(), ctypes.c_double()
    call("mdr_law_force", law, UNLOADING, ctypes.c_double(depth), ctypes.byref(force), ctypes.byref(slope))
    hertz = 4 / 3 * E / (1 - nu**2) * math.sqrt(R) * depth**1.5
    print(f"F = {force.value * 1e3:.4f} mN, dF/dd = {slope.value:.1f} N/m")
    error = abs(force.value / hertz - 1)
    print(f"largest relative error of F: {error:.1e}")
    assert error < 1e-9
    for handle in (law, contact, body, ball):
        call("mdr_free", handle)


if __name__ == "__main__":
    main()
