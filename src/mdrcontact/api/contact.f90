! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of an indenter with a medium, its states and their fields, for C.
module mdrcontact_api_contact
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_loc, c_ptr, c_sizeof
    use mdrcontact_api_arrays, only: check_each_positive
    use mdrcontact_api_handles, only: return_object
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_options, only: read_options
    use mdrcontact_api_records, only: c_contact_options_t
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_api_text, only: write_text
    use mdrcontact_contact, only: contact_options_t, contact_t, new_contact
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_warnings, only: contact_warning_t
    use mdrcontact_error, only: check_count_from, check_table, count_text, error_invalid, error_t, raise
    use mdrcontact_contact_relaxing_contact, only: new_relaxing_contact, relaxing_contact_t
    use mdrcontact_medium, only: medium_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_numerics_radius_law, only: new_radius_law_from_table, radius_law_t
    implicit none (type, external)
    private
    public :: mdr_contact_new
    public :: mdr_contact_load, mdr_contact_warnings

contains

    function mdr_contact_new(profile, medium, options, out) result(status) bind(C, name="mdrcontact_entry_contact_new")
        type(c_ptr), value :: profile, medium, options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        class(profile_t), pointer :: indenter
        type(medium_t), pointer :: body
        class(*), allocatable :: object
        type(c_contact_options_t), target :: given
        type(contact_options_t) :: chosen
        type(error_t), allocatable :: error

        call read_options(error, "options", options, c_loc(given), c_sizeof(given))
        call open_handle(profile, "profile", indenter, error)
        call open_handle(medium, "medium", body, error)
        chosen%work_of_adhesion = given%work_of_adhesion
        chosen%cohesive_stress = given%cohesive_stress
        if (given%adhesion_rule /= 0_c_int) chosen%adhesion_rule = int(given%adhesion_rule)
        chosen%zeta_is_exact = given%zeta_is_exact /= 0_c_int
        if (chosen%zeta_is_exact .and. given%zeta_count /= 0) then
            call raise(error, error_invalid, "zeta_is_exact = "//count_text(int(given%zeta_is_exact))// &
                       ": it excludes a table of zeta. Set zeta_count = 0 or zeta_is_exact = 0")
        end if
        if (given%zeta_count /= 0 .and. .not. allocated(error)) call read_zeta(given, chosen%zeta, error)
        if (.not. allocated(error)) call make_contact(object, indenter, body, chosen, error)
        status = return_object(object, out, error)
    end function mdr_contact_new

    !> A contact with an elastic medium, or with one that relaxes.
    subroutine make_contact(object, indenter, body, options, error)
        class(*), allocatable, intent(out) :: object
        class(profile_t), intent(in) :: indenter
        type(medium_t), intent(in) :: body
        type(contact_options_t), intent(in) :: options
        type(error_t), allocatable, intent(out) :: error
        type(contact_t), allocatable :: contact
        type(relaxing_contact_t), allocatable :: relaxing

        if (allocated(body%relaxing)) then
            allocate (relaxing)
            call new_relaxing_contact(relaxing, indenter, body%relaxing, error, options)
            call move_alloc(relaxing, object)
        else
            allocate (contact)
            call new_contact(contact, indenter, body%solver, error, options)
            call move_alloc(contact, object)
        end if
    end subroutine make_contact

    !> zeta(a) from the table in the options.
    subroutine read_zeta(options, zeta, error)
        type(c_contact_options_t), intent(in) :: options
        type(radius_law_t), allocatable, intent(out) :: zeta
        type(error_t), allocatable, intent(out) :: error
        real(c_double), pointer :: radius(:), values(:)

        call check_count_from(error, "zeta_count", int(options%zeta_count), 0)
        call check_given(error, "zeta_radius", c_associated(options%zeta_radius))
        call check_given(error, "zeta", c_associated(options%zeta))
        if (allocated(error)) return
        call c_f_pointer(options%zeta_radius, radius, [options%zeta_count])
        call c_f_pointer(options%zeta, values, [options%zeta_count])
        call check_table(error, "zeta_radius", radius, "zeta", values, 3)
        call check_each_positive(error, "zeta_radius", radius)
        call check_each_positive(error, "zeta", values)
        if (allocated(error)) return
        allocate (zeta)
        call new_radius_law_from_table(zeta, radius, "zeta", values, error)
    end subroutine read_zeta

    !> The load refers to the object behind the handle of the contact, which lasts as long.
    function mdr_contact_load(c, state, out) result(status) bind(C, name="mdrcontact_entry_contact_load")
        type(c_ptr), value :: c
        type(contact_state_t), intent(in), optional :: state
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(contact_t), pointer :: contact
        type(contact_load_t), allocatable :: load
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (load)
        call open_handle(c, "c", contact, error)
        if (.not. allocated(error)) call contact%load(state, load, error)
        call move_alloc(load, object)
        status = return_object(object, out, error, held=c)
    end function mdr_contact_load

    function mdr_contact_warnings(c, state, buffer, length, warnings) result(status) &
        bind(C, name="mdrcontact_entry_contact_warnings")
        type(c_ptr), value :: c, buffer
        type(contact_state_t), intent(in), optional :: state
        integer(c_int), value :: length
        integer(c_int), intent(inout), optional :: warnings
        integer(c_int) :: status
        type(contact_t), pointer :: contact
        type(contact_warning_t), allocatable :: found(:)
        type(error_t), allocatable :: error
        character(len=:), allocatable :: text
        integer :: i

        call open_handle(c, "c", contact, error)
        call check_given(error, "buffer", c_associated(buffer) .or. length < 1)
        if (.not. allocated(error)) call contact%warnings(state, found, error)
        status = status_of(error)
        if (allocated(error)) return
        if (present(warnings)) warnings = int(sum(found%code), c_int)
        if (length < 1) return
        text = ""
        do i = 1, size(found)
            text = text//trim(found(i)%text)//new_line("")
        end do
        call write_text(text, int(length), buffer)
    end function mdr_contact_warnings

end module mdrcontact_api_contact
