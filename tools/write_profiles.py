# SPDX-License-Identifier: GPL-3.0-or-later
"""The constructors of indenters that a few numbers describe, for generate.py."""

import re

# The indenter in the header, the file of its type, and what makes it.
SHAPES = {
    "paraboloid": ("power_law", "new_paraboloid"),
    "sphere": ("sphere", "new_sphere"),
    "cone": ("power_law", "new_cone"),
    "power": ("power_law", "new_power_law"),
    "flat_punch": ("flat_punch", "new_flat_punch"),
    "flat_cone": ("flat_cone", "new_flat_cone"),
    "flat_paraboloid": ("flat_paraboloid", "new_flat_paraboloid"),
    "rounded_cone": ("rounded_cone", "new_rounded_cone"),
}
TOP = """\
! SPDX-License-Identifier: GPL-3.0-or-later
!> Indenter profiles with closed forms, for C. Written by tools/generate.py.
module mdrcontact_api_profile
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_handles, only: deliver
    use mdrcontact_error, only: error_t"""


def constructor(shape, kind, procedure, numbers):
    """One function; `numbers` are its arguments."""
    name = f"mdr_profile_{shape}"
    return [
        f"    function {name}({', '.join(numbers)}, out) result(status) &",
        f'        bind(C, name="mdrcontact_entry_profile_{shape}")',
        f"        real(c_double), value :: {', '.join(numbers)}",
        "        type(c_ptr), intent(inout), optional :: out",
        "        integer(c_int) :: status",
        f"        type({kind}_t) :: profile",
        "        type(error_t), allocatable :: error",
        "",
        f"        call {procedure}(profile, {', '.join(numbers)}, error)",
        "        status = deliver(profile, out, error)",
        f"    end function {name}",
        "",
    ]


def profiles(functions):
    """The lines of api/profile.f90, from the header's functions: result, name and arguments."""
    arguments = {name: words for _, name, words in functions}
    used = {}
    for kind, procedure in SHAPES.values():
        used.setdefault(kind, []).append(procedure)
    lines = TOP.split("\n")
    for kind, procedures in sorted(used.items()):
        lines.append(f"    use mdrcontact_profile_{kind}, only: {', '.join(sorted([f'{kind}_t', *procedures]))}")
    lines += ["    implicit none (type, external)", "    private"]
    lines += [f"    public :: mdr_profile_{shape}" for shape in SHAPES] + ["", "contains", ""]
    for shape, (kind, procedure) in SHAPES.items():
        numbers = [re.fullmatch(r"double (\w+)", word)[1] for word in arguments[f"mdr_profile_{shape}"][:-1]]
        lines += constructor(shape, kind, procedure, numbers)
    return [*lines, "end module mdrcontact_api_profile"]
