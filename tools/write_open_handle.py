# SPDX-License-Identifier: GPL-3.0-or-later
"""The Fortran procedures that turn a handle into its object, for generate.py: one for each type behind a handle."""

# The core and the extensions that have handles: the kind of handle in C, the type behind it, the type's module, and where a type
# extends it, "class".
CORE = [
    ("mdr_profile", "profile_t", "mdrcontact_profile", "class"),
    ("mdr_body", "any_body_t", "mdrcontact_api_any_body", "type"),
    ("mdr_response", "response_t", "mdrcontact_medium_response", "type"),
    ("mdr_medium", "medium_t", "mdrcontact_medium", "type"),
    ("mdr_contact", "contact_t", "mdrcontact_contact", "type"),
    ("mdr_contact", "relaxing_contact_t", "mdrcontact_contact_relaxing_contact", "type"),
    ("mdr_load", "contact_load_t", "mdrcontact_contact_load", "type"),
    ("mdr_loop", "loop_t", "mdrcontact_contact_loop", "type"),
    ("mdr_law", "contact_law_t", "mdrcontact_law", "type"),
    ("mdr_friction", "friction_t", "mdrcontact_friction_partial_slip", "type"),
    ("mdr_shear", "first_shear_t", "mdrcontact_friction_partial_slip", "type"),
    ("mdr_friction_history", "friction_history_t", "mdrcontact_friction_history", "type"),
    ("mdr_material", "rheology_t", "mdrcontact_material_rheology", "type"),
]
EXTENSIONS = {
    "adhesion": [("mdr_rate", "rate_contact_t", "mdrcontact_adhesion_rate_contact", "type")],
    "wear": [
        ("mdr_wear", "wear_t", "mdrcontact_wear", "type"),
        ("mdr_wear_history", "wear_history_t", "mdrcontact_wear_history", "type"),
    ],
    "conduction": [("mdr_conduction", "conduction_t", "mdrcontact_conduction_bodies", "type")],
    "poroelastic": [("mdr_poroelastic", "poroelastic_t", "mdrcontact_poroelastic_table", "type")],
    "plastic": [
        ("mdr_imprint", "imprint_t", "mdrcontact_plastic_imprint", "type"),
        ("mdr_yielding", "yielding_t", "mdrcontact_plastic_yielding", "type"),
        ("mdr_plastic_law", "plastic_law_t", "mdrcontact_plastic_law", "type"),
        ("mdr_overload", "overload_t", "mdrcontact_plastic_overload", "type"),
        ("mdr_cap", "cap_t", "mdrcontact_plastic_cap", "type"),
    ],
    "lateral": [("mdr_structure", "structure_t", "mdrcontact_lateral_structure", "class")],
}
# A handle of the right kind whose object is of the other of two types: what is said then.
OTHERWISE = {
    "contact_t": ("relaxing_contact_t", "call refuse_states(error)"),
    "relaxing_contact_t": (
        "contact_t",
        'call raise(error, error_invalid, "the body is elastic: its states do not depend on time")',
    ),
}
OTHER_NAMES = {"mdrcontact_medium": ["refuse_states"], "mdrcontact_error": ["error_invalid", "raise"]}
TOP = """\
! SPDX-License-Identifier: GPL-3.0-or-later
!> The object behind a handle, by the type of the pointer that is to hold it. Written by tools/generate.py.
module {module}
    use, intrinsic :: iso_c_binding, only: c_ptr
    use mdrcontact_api_handles, only: look_inside, refuse_kind"""
ALL_OF_CORE = "    use mdrcontact_api_open_handle, only: open_handle"
REST = """\
    implicit none (type, external)
    private
    public :: open_handle

    !> The object behind a handle; null after an error. `name` is the argument's.
    interface open_handle
        module procedure"""


def accessor(word, of_type, clause):
    """One procedure."""
    name = f"open_{of_type.removesuffix('_t')}"
    lines = [f"subroutine {name}(handle, name, object, error)", "    type(c_ptr), intent(in) :: handle"]
    lines += ["    character(len=*), intent(in) :: name", f"    {clause}({of_type}), pointer, intent(out) :: object"]
    lines += ["    type(error_t), allocatable, intent(inout) :: error", "    class(*), pointer :: inside", ""]
    lines += ["    nullify (object)", f'    call look_inside(handle, name, "{word}", inside, error)']
    lines += ["    if (allocated(error)) return"]
    lines += ["    select type (inside)", f"    {clause} is ({of_type})", "        object => inside"]
    if of_type in OTHERWISE:
        other, words = OTHERWISE[of_type]
        lines += [f"    type is ({other})", f"        {words}"]
    lines += ["    class default", f'        call refuse_kind(name, "{word}", error)', "    end select", f"end subroutine {name}"]
    return ["", *(f"    {line}" if line else "" for line in lines)]


def open_handles():
    """The lines of each file by its name: api/open_handle.f90, and that of each extension, which opens those of the core too."""
    files = {"open_handle": CORE} | {f"{extension}_open_handle": kinds for extension, kinds in EXTENSIONS.items()}
    return {f"{name}.f90": module_of(f"mdrcontact_api_{name}", kinds) for name, kinds in files.items()}


def module_of(name, kinds):
    """The lines of one file."""
    wanted = {"mdrcontact_error": ["error_t"]}
    for module, names in OTHER_NAMES.items() if kinds is CORE else ():
        wanted.setdefault(module, []).extend(names)
    for _, of_type, module, _ in kinds:
        wanted.setdefault(module, []).append(of_type)
    lines = TOP.format(module=name).split("\n") + [ALL_OF_CORE] * (kinds is not CORE)
    lines += [f"    use {module}, only: {', '.join(sorted(names))}" for module, names in sorted(wanted.items())]
    lines += REST.split("\n")
    lines[-1] += " &"
    names = [f"open_{of_type.removesuffix('_t')}" for _, of_type, *_ in kinds]
    lines += [f"            {name}{', &' if i + 1 < len(names) else ''}" for i, name in enumerate(names)]
    lines += ["    end interface open_handle", "", "contains"]
    for word, of_type, _, clause in kinds:
        lines += accessor(word, of_type, clause)
    return [*lines, "", f"end module {name}"]
