! SPDX-License-Identifier: GPL-3.0-or-later
!> Wear, for C.
module mdrcontact_api_wear
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_loc, c_ptr, c_sizeof
    use mdrcontact_api_arrays, only: check_array, check_results, make_room
    use mdrcontact_api_handles, only: return_object
    use mdrcontact_api_wear_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_count_from, check_memory, error_t, raise_at
    use mdrcontact_kinds, only: wp
    use mdrcontact_profile_worn, only: worn_profile_t
    use mdrcontact_wear, only: wear_t
    use mdrcontact_wear_history, only: wear_history_t, wear_past_t, wear_state_t
    use mdrcontact_wear_limit, only: wear_limit_t
    implicit none (type, external)
    private
    public :: mdr_wear_limit
    public :: mdr_wear_history_advance, mdr_wear_history_save

contains

    function mdr_wear_limit(w, state, stick_radius, given, reached, outer_radius, worn_volume, out) result(status) &
        bind(C, name="mdrcontact_entry_wear_limit")
        type(c_ptr), value :: w
        type(contact_state_t), intent(in), optional :: state
        real(c_double), value :: stick_radius
        integer(c_int), value :: given
        type(contact_state_t), intent(inout), optional :: reached
        real(c_double), intent(inout), optional :: outer_radius, worn_volume
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(wear_t), pointer :: wear
        type(wear_limit_t) :: limit
        type(worn_profile_t), allocatable :: profile
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        call open_handle(w, "w", wear, error)
        if (.not. allocated(error)) call wear%limit(state, stick_radius, int(given), limit, error, profile)
        if (.not. allocated(error)) call check_results(error, [limit%state%depth, limit%state%force, limit%state%stiffness, &
                                                               limit%outer_radius, limit%worn_volume])
        call move_alloc(profile, object)
        if (present(out)) then
            status = return_object(object, out, error)
        else
            status = status_of(error)
        end if
        if (allocated(error)) return
        reached = limit%state
        if (present(outer_radius)) outer_radius = limit%outer_radius
        if (present(worn_volume)) worn_volume = limit%worn_volume
    end function mdr_wear_limit

    function mdr_wear_history_advance(h, given, n, sliding, value, out) result(status) &
        bind(C, name="mdrcontact_entry_wear_history_advance")
        type(c_ptr), value :: h
        integer(c_int), value :: given, n
        real(c_double), intent(in), optional :: sliding(*), value(*)
        type(wear_state_t), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(wear_history_t), pointer :: history
        type(wear_past_t) :: past
        type(wear_state_t), allocatable :: states(:)
        type(error_t), allocatable :: error
        integer :: i, stat

        call open_handle(h, "h", history, error)
        if (.not. allocated(error)) then
            allocate (states(n), stat=stat)
            call check_memory(error, stat)
        end if
        status = status_of(error)
        if (allocated(error)) return
        past = history%past
        do i = 1, n
            call history%advance(sliding(i), int(given), value(i), error)
            if (.not. allocated(error)) then
                call history%state(states(i))
                call check_results(error, [states(i)%depth, states(i)%radius, states(i)%worn_volume, states(i)%work])
            end if
            if (allocated(error)) then
                call raise_at(error, i)
                history%past = past
                exit
            end if
        end do
        status = status_of(error)
        if (allocated(error) .or. n == 0) return
        out(:n) = states
    end function mdr_wear_history_advance

    function mdr_wear_history_save(h, capacity, numbers, count) result(status) &
        bind(C, name="mdrcontact_entry_wear_history_save")
        type(c_ptr), value :: h
        integer(c_int), value :: capacity
        real(c_double), intent(inout), optional :: numbers(*)
        integer(c_int), intent(inout), optional :: count
        integer(c_int) :: status
        type(wear_history_t), pointer :: history
        real(wp), allocatable :: all_numbers(:)
        type(error_t), allocatable :: error
        integer :: n

        call open_handle(h, "h", history, error)
        call check_count_from(error, "capacity", int(capacity), 0)
        call check_array(error, "numbers", capacity, present(numbers))
        if (.not. allocated(error)) call make_room(error, int(history%saved_size(), c_int), all_numbers)
        status = status_of(error)
        if (allocated(error)) return
        call history%save(all_numbers)
        n = min(int(capacity), size(all_numbers))
        if (n > 0) numbers(:n) = all_numbers(:n)
        if (present(count)) count = size(all_numbers, kind=c_int)
    end function mdr_wear_history_save

end module mdrcontact_api_wear
