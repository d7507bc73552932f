! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of time that convert, call and deliver, for C. Written by tools/generate.py.
module mdrcontact_api_time_entries
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_results, make_room, return_parts
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of
    use mdrcontact_contact_relaxing_contact, only: relaxing_contact_t
    use mdrcontact_error, only: error_t
    use mdrcontact_time_history, only: contact_history
    use mdrcontact_time_stiffness, only: dynamic_stiffness, step_response
    implicit none (type, external)
    private
    public :: mdr_contact_history
    public :: mdr_contact_dynamic_stiffness
    public :: mdr_contact_step_response

contains

    function mdr_contact_history(c, given, tolerance, n, time, in, d, a, f) result(status) &
        bind(C, name="mdrcontact_entry_contact_history")
        type(c_ptr), value :: c
        integer(c_int), value :: given, n
        real(c_double), value :: tolerance
        real(c_double), intent(in), optional :: time(*), in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), f(*)
        integer(c_int) :: status
        type(relaxing_contact_t), pointer :: c_inside
        real(c_double), allocatable :: d_values(:), a_values(:), f_values(:)
        type(error_t), allocatable :: error

        call open_handle(c, "c", c_inside, error)
        call make_room(error, n, d_values)
        call make_room(error, n, a_values)
        call make_room(error, n, f_values)
        if (.not. allocated(error) .and. n > 0) then
            call contact_history(c_inside, given, time(:n), in(:n), d_values, a_values, f_values, error, tolerance)
        end if
        if (.not. allocated(error)) call check_results(error, d_values)
        if (.not. allocated(error)) call check_results(error, a_values)
        if (.not. allocated(error)) call check_results(error, f_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(d)) d(:n) = d_values
        if (present(a)) a(:n) = a_values
        if (present(f)) f(:n) = f_values
    end function mdr_contact_history

    function mdr_contact_dynamic_stiffness(c, n, omega, radius, storage, loss) result(status) &
        bind(C, name="mdrcontact_entry_contact_dynamic_stiffness")
        type(c_ptr), value :: c
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: omega(*), radius(*)
        real(c_double), intent(inout), optional :: storage(*), loss(*)
        integer(c_int) :: status
        type(relaxing_contact_t), pointer :: c_inside
        complex(c_double), allocatable :: storage_values(:)
        type(error_t), allocatable :: error

        call open_handle(c, "c", c_inside, error)
        call make_room(error, n, storage_values)
        if (.not. allocated(error) .and. n > 0) call dynamic_stiffness(c_inside, omega(:n), radius(:n), storage_values, error)
        call return_parts(error, storage_values, storage, loss)
        status = status_of(error)
    end function mdr_contact_dynamic_stiffness

    function mdr_contact_step_response(c, step, radius, n, time, out) result(status) &
        bind(C, name="mdrcontact_entry_contact_step_response")
        type(c_ptr), value :: c
        integer(c_int), value :: step, n
        real(c_double), value :: radius
        real(c_double), intent(in), optional :: time(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(relaxing_contact_t), pointer :: c_inside
        real(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call open_handle(c, "c", c_inside, error)
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) call step_response(c_inside, step, time(:n), radius, out_values, error)
        if (.not. allocated(error)) call check_results(error, out_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_contact_step_response

end module mdrcontact_api_time_entries
