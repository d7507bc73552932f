! SPDX-License-Identifier: GPL-3.0-or-later
!> The largest stresses inside the bodies of a contact, and the loads at first failure, for C.
module mdrcontact_api_critical
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_results
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_records, only: c_failure_load_t, c_maximum_t, c_strength_t
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_codes, only: body_lower, body_upper
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_error, only: check_code, check_memory, error_t
    use mdrcontact_inside_critical, only: critical
    use mdrcontact_inside_failure, only: failure_load_t, first_failure, strength_t
    use mdrcontact_inside_largest, only: maximum_t
    implicit none (type, external)
    private
    public :: mdr_load_critical, mdr_contact_first_failure

contains

    function mdr_load_critical(load, body, friction, capacity, out, count) result(status) &
        bind(C, name="mdrcontact_entry_load_critical")
        type(c_ptr), value :: load
        integer(c_int), value :: body, capacity
        real(c_double), value :: friction
        type(c_maximum_t), intent(inout), optional :: out(*)
        integer(c_int), intent(inout), optional :: count
        integer(c_int) :: status
        type(contact_load_t), pointer :: pressed
        type(maximum_t), allocatable :: maxima(:)
        type(error_t), allocatable :: error
        integer :: i, n

        n = 0
        call open_handle(load, "load", pressed, error)
        call check_code(error, "body", int(body), [body_lower, body_upper])
        if (.not. allocated(error)) then
            call critical(pressed, body == body_upper, friction, maxima, error, wanted_threads(), counted_only=capacity == 0)
        end if
        if (.not. allocated(error)) n = size(maxima)
        do i = 1, n
            call check_results(error, [maxima(i)%value, maxima(i)%r, maxima(i)%z])
        end do
        status = status_of(error)
        if (allocated(error)) return
        count = size(maxima, kind=c_int)
        do i = 1, min(size(maxima), int(capacity))
            out(i) = c_maximum_t(maxima(i)%quantity, maxima(i)%place, maxima(i)%value, maxima(i)%r, maxima(i)%z, maxima(i)%angle)
        end do
    end function mdr_load_critical

    function mdr_contact_first_failure(c, body, friction, largest_radius, n, strengths, capacity, out, count) result(status) &
        bind(C, name="mdrcontact_entry_contact_first_failure")
        type(c_ptr), value :: c
        integer(c_int), value :: body, n, capacity
        real(c_double), value :: friction, largest_radius
        type(c_strength_t), intent(in), optional :: strengths(*)
        type(c_failure_load_t), intent(inout), optional :: out(*)
        integer(c_int), intent(inout), optional :: count
        integer(c_int) :: status
        type(contact_t), pointer :: contact
        type(strength_t), allocatable :: wanted(:)
        type(failure_load_t), allocatable :: failures(:)
        type(error_t), allocatable :: error
        integer :: i, stat

        call open_handle(c, "c", contact, error)
        call check_code(error, "body", int(body), [body_lower, body_upper])
        if (.not. allocated(error)) then
            allocate (wanted(n), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) then
            do i = 1, n
                wanted(i) = strength_t(strengths(i)%quantity, strengths(i)%place, strengths(i)%value)
            end do
            call first_failure(contact, body == body_upper, friction, largest_radius, wanted, failures, error, wanted_threads())
        end if
        status = status_of(error)
        if (allocated(error)) return
        count = size(failures, kind=c_int)
        do i = 1, min(size(failures), int(capacity))
            associate (state => failures(i)%state, strength => failures(i)%strength, at => failures(i)%at)
                out(i) = c_failure_load_t(state%depth, state%radius, state%force, state%stiffness, state%punch_depth, &
                                          state%zone_radius, strength%quantity, strength%place, strength%value, at%value, at%r, &
                                          at%z, at%angle)
            end associate
        end do
    end function mdr_contact_first_failure

end module mdrcontact_api_critical
