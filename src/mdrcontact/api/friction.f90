! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts with friction, for C.
module mdrcontact_api_friction
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_results
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_memory, error_t, raise_at
    use mdrcontact_friction_partial_slip, only: tangential_state_t
    use mdrcontact_friction_history, only: friction_history_t, friction_past_t
    implicit none (type, external)
    private
    public :: mdr_friction_history_advance

contains

    function mdr_friction_history_advance(h, normal_given, tangential_given, n, normal, tangential, states, out) &
        result(status) bind(C, name="mdrcontact_entry_friction_history_advance")
        type(c_ptr), value :: h
        integer(c_int), value :: normal_given, tangential_given, n
        real(c_double), intent(in), optional :: normal(*), tangential(*)
        type(contact_state_t), intent(inout), optional :: states(*)
        type(tangential_state_t), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(friction_history_t), pointer :: history
        type(friction_past_t) :: past
        type(contact_state_t), allocatable :: normals(:)
        type(tangential_state_t), allocatable :: tangentials(:)
        type(error_t), allocatable :: error
        integer :: i, stat

        call open_handle(h, "h", history, error)
        status = status_of(error)
        if (allocated(error)) return
        allocate (normals(n), tangentials(n), stat=stat)
        call check_memory(error, stat)
        status = status_of(error)
        if (allocated(error)) return
        past = history%past
        do i = 1, n
            call history%advance(int(normal_given), normal(i), int(tangential_given), tangential(i), error)
            if (.not. allocated(error)) call check_results(error, [history%past%tangential%tangential_force, &
                                                                   history%past%tangential%dissipated_energy])
            if (allocated(error)) then
                call raise_at(error, i)
                history%past = past
                exit
            end if
            normals(i) = history%past%normal
            tangentials(i) = history%past%tangential
        end do
        status = status_of(error)
        if (allocated(error) .or. n == 0) return
        do i = 1, n
            states(i) = normals(i)
            out(i) = tangentials(i)
        end do
    end function mdr_friction_history_advance

end module mdrcontact_api_friction
