! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts with viscoelastic bodies in time, for C.
module mdrcontact_api_time
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_results, deliver_parts, make_room
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_time_history, only: contact_history
    use mdrcontact_time_stiffness, only: dynamic_stiffness, step_response
    use mdrcontact_contact_relaxing_contact, only: relaxing_contact_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: mdr_contact_history, mdr_contact_dynamic_stiffness, mdr_contact_step_response

contains

    function mdr_contact_history(c, given, tolerance, n, time, in, d, a, f) result(status) &
        bind(C, name="mdrcontact_entry_contact_history")
        type(c_ptr), value :: c
        integer(c_int), value :: given, n
        real(c_double), value :: tolerance
        real(c_double), intent(in), optional :: time(*), in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), f(*)
        integer(c_int) :: status
        type(relaxing_contact_t), pointer :: contact
        real(c_double), allocatable :: values(:, :)
        type(error_t), allocatable :: error
        integer :: i, stat

        call open_handle(c, "c", contact, error)
        status = status_of(error)
        if (allocated(error) .or. n == 0) return
        allocate (values(n, 3), stat=stat)
        call check_memory(error, stat)
        if (.not. allocated(error)) then
            call contact_history(contact, int(given), time(:n), in(:n), values(:, 1), values(:, 2), values(:, 3), error, tolerance)
        end if
        do i = 1, 3
            if (.not. allocated(error)) call check_results(error, values(:, i))
        end do
        status = status_of(error)
        if (allocated(error)) return
        if (present(d)) d(:n) = values(:, 1)
        if (present(a)) a(:n) = values(:, 2)
        if (present(f)) f(:n) = values(:, 3)
    end function mdr_contact_history

    function mdr_contact_dynamic_stiffness(c, n, omega, radius, storage, loss) result(status) &
        bind(C, name="mdrcontact_entry_contact_dynamic_stiffness")
        type(c_ptr), value :: c
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: omega(*), radius(*)
        real(c_double), intent(inout), optional :: storage(*), loss(*)
        integer(c_int) :: status
        type(relaxing_contact_t), pointer :: contact
        complex(wp), allocatable :: values(:)
        type(error_t), allocatable :: error

        call open_handle(c, "c", contact, error)
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) call dynamic_stiffness(contact, omega(:n), radius(:n), values, error)
        call deliver_parts(error, values, storage, loss)
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
        type(relaxing_contact_t), pointer :: contact
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error

        call open_handle(c, "c", contact, error)
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            call step_response(contact, int(step), time(:n), radius, values, error)
            if (.not. allocated(error)) call check_results(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function mdr_contact_step_response

end module mdrcontact_api_time
