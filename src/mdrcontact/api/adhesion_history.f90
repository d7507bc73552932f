! SPDX-License-Identifier: GPL-3.0-or-later
!> Histories of contacts with viscoelastic bodies that attract the indenter, for C.
module mdrcontact_api_adhesion_history
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_adhesion_cohesive_history, only: cohesive_columns, cohesive_history
    use mdrcontact_adhesion_rate_state, only: rate_state_t
    use mdrcontact_api_arrays, only: check_results
    use mdrcontact_api_loop, only: choose_control
    use mdrcontact_api_status, only: status_of
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_error, only: check_memory, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_contact_relaxing_contact, only: relaxing_contact_t
    implicit none (type, external)
    private
    public :: mdr_contact_adhesive_history

contains

    function mdr_contact_adhesive_history(c, control, spring_stiffness, tolerance, start, n, time, in, d, a, zone_radius, f, end) &
        result(status) bind(C, name="mdrcontact_entry_contact_adhesive_history")
        type(c_ptr), value :: c
        integer(c_int), value :: control, n
        real(c_double), value :: spring_stiffness, tolerance
        type(rate_state_t), intent(in), optional :: start
        real(c_double), intent(in), optional :: time(*), in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), zone_radius(*), f(*)
        type(rate_state_t), intent(inout), optional :: end
        integer(c_int) :: status
        type(relaxing_contact_t), pointer :: contact
        type(control_t) :: chosen
        type(rate_state_t) :: state
        real(c_double), allocatable :: path(:, :)
        type(error_t), allocatable :: error
        integer :: i, stat

        call open_handle(c, "c", contact, error)
        call choose_control(chosen, control, spring_stiffness, .true., error)
        if (.not. allocated(error)) then
            if (start%radius > 0.0_c_double) call raise(error, error_invalid, " = "//to_text(real(start%radius, wp))// &
                                                        " is not allowed: it must be 0 (apart) or less (at rest)", "start")
        end if
        status = status_of(error)
        if (allocated(error)) return
        allocate (path(cohesive_columns, n), stat=stat)
        call check_memory(error, stat)
        if (.not. allocated(error) .and. n > 0) then
            call cohesive_history(contact, chosen, start%radius < 0.0_c_double, time(:n), in(:n), path, state, error, tolerance)
        end if
        do i = 1, cohesive_columns
            if (.not. allocated(error)) call check_results(error, path(i, :))
        end do
        status = status_of(error)
        if (allocated(error)) return
        if (present(d)) d(:n) = path(1, :)
        if (present(a)) a(:n) = path(2, :)
        if (present(zone_radius)) zone_radius(:n) = path(3, :)
        if (present(f)) f(:n) = path(4, :)
        end = state
    end function mdr_contact_adhesive_history

end module mdrcontact_api_adhesion_history
