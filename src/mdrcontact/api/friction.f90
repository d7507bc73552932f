! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts with friction, for C.
module mdrcontact_api_friction
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_results
    use mdrcontact_api_handles, only: hand_over
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_memory, error_t, raise_at
    use mdrcontact_friction_partial_slip, only: friction_t, new_friction, tangential_state_t
    use mdrcontact_friction_history, only: friction_history_t, friction_past_t, new_friction_history
    implicit none (type, external)
    private
    public :: mdr_friction_new, mdr_friction_history_new, mdr_friction_history_copy, mdr_friction_history_advance

contains

    function mdr_friction_new(c, coefficient, out) result(status) bind(C, name="mdrcontact_entry_friction_new")
        type(c_ptr), value :: c
        real(c_double), value :: coefficient
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(contact_t), pointer :: contact
        type(friction_t), allocatable :: friction
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (friction)
        call open_handle(c, "c", contact, error)
        if (.not. allocated(error)) call new_friction(friction, contact, coefficient, error)
        call move_alloc(friction, object)
        status = hand_over(object, out, error)
    end function mdr_friction_new

    function mdr_friction_history_new(f, largest_depth, rings, out) result(status) &
        bind(C, name="mdrcontact_entry_friction_history_new")
        type(c_ptr), value :: f
        real(c_double), value :: largest_depth
        integer(c_int), value :: rings
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(friction_t), pointer :: friction
        type(friction_history_t), allocatable :: history
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (history)
        call open_handle(f, "f", friction, error)
        if (.not. allocated(error)) call new_friction_history(history, friction, error, largest_depth, int(rings))
        call move_alloc(history, object)
        status = hand_over(object, out, error)
    end function mdr_friction_history_new

    function mdr_friction_history_copy(h, out) result(status) bind(C, name="mdrcontact_entry_friction_history_copy")
        type(c_ptr), value :: h
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(friction_history_t), pointer :: history
        type(friction_history_t), allocatable :: copy
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (copy)
        call open_handle(h, "h", history, error)
        if (.not. allocated(error)) call history%copy(copy, error)
        call move_alloc(copy, object)
        status = hand_over(object, out, error)
    end function mdr_friction_history_copy

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
