! SPDX-License-Identifier: GPL-3.0-or-later
!> Histories of contacts with viscoelastic bodies, for C.
module mdrcontact_api_history
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count, check_results
    use mdrcontact_api_handles, only: open_handle
    use mdrcontact_api_status, only: check_memory, status_of
    use mdrcontact_contact, only: contact_t
    use mdrcontact_error, only: error_t
    use mdrcontact_history_relaxation, only: contact_history
    implicit none (type, external)
    private
    public :: mdr_contact_history

contains

    function mdr_contact_history(c, given, n, time, in, d, a, f) result(status) bind(C)
        type(c_ptr), value :: c
        integer(c_int), value :: given, n
        real(c_double), intent(in), optional :: time(*), in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), f(*)
        integer(c_int) :: status
        type(contact_t), pointer :: contact
        real(c_double), allocatable :: values(:, :)
        type(error_t), allocatable :: error
        integer :: i, stat

        call open_handle(c, "c", contact, error)
        call check_count(error, n)
        call check_array(error, "time", n, present(time))
        call check_array(error, "in", n, present(in))
        status = status_of(error)
        if (allocated(error) .or. n == 0) return
        allocate (values(n, 3), stat=stat)
        call check_memory(error, stat)
        if (.not. allocated(error)) then
            call contact_history(contact, int(given), time(:n), in(:n), values(:, 1), values(:, 2), values(:, 3), error)
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

end module mdrcontact_api_history
