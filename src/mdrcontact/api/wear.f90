! SPDX-License-Identifier: GPL-3.0-or-later
!> Wear, for C.
module mdrcontact_api_wear
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_loc, c_ptr, c_sizeof
    use mdrcontact_api_arrays, only: check_array, check_results, make_room
    use mdrcontact_api_handles, only: hand_over
    use mdrcontact_api_wear_open_handle, only: open_handle
    use mdrcontact_api_options, only: read_options
    use mdrcontact_api_records, only: c_wear_options_t
    use mdrcontact_api_status, only: status_of
    use mdrcontact_codes, only: fresh_places => wear_fresh, same_places => wear_same
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_code, check_count_from, check_memory, error_t, raise_at
    use mdrcontact_kinds, only: wp
    use mdrcontact_profile_worn, only: worn_profile_t
    use mdrcontact_wear, only: new_wear, wear_t
    use mdrcontact_wear_history, only: new_wear_history, wear_history_t, wear_past_t, wear_state_t
    use mdrcontact_wear_limit, only: wear_limit_t
    implicit none (type, external)
    private
    public :: mdr_wear_new, mdr_wear_limit, mdr_wear_track, mdr_wear_passes, mdr_wear_running_in
    public :: mdr_wear_history_new, mdr_wear_history_copy, mdr_wear_history_advance, mdr_wear_history_state, &
              mdr_wear_history_profile, mdr_wear_history_save, mdr_wear_history_restore

contains

    function mdr_wear_new(c, n, coefficient, thickness, body_coefficient, out) result(status) &
        bind(C, name="mdrcontact_entry_wear_new")
        type(c_ptr), value :: c
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: coefficient(*), thickness(*)
        real(c_double), value :: body_coefficient
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(contact_t), pointer :: contact
        type(wear_t), allocatable :: wear
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (wear)
        call open_handle(c, "c", contact, error)
        call check_count_from(error, "n", int(n), 1)
        call check_array(error, "thickness", max(n, 1) - 1, present(thickness))
        if (.not. allocated(error)) then
            if (n > 1) then
                call new_wear(wear, contact, coefficient(:n), error, thickness(:n - 1), body_coefficient)
            else
                call new_wear(wear, contact, coefficient(:n), error, body_coefficient=body_coefficient)
            end if
        end if
        call move_alloc(wear, object)
        status = hand_over(object, out, error)
    end function mdr_wear_new

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
            status = hand_over(object, out, error)
        else
            status = status_of(error)
        end if
        if (allocated(error)) return
        reached = limit%state
        if (present(outer_radius)) outer_radius = limit%outer_radius
        if (present(worn_volume)) worn_volume = limit%worn_volume
    end function mdr_wear_limit

    function mdr_wear_track(w, state, passes, n, y, out) result(status) bind(C, name="mdrcontact_entry_wear_track")
        type(c_ptr), value :: w
        type(contact_state_t), intent(in), optional :: state
        real(c_double), value :: passes
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: y(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(wear_t), pointer :: wear
        real(wp), allocatable :: depths(:)
        type(error_t), allocatable :: error

        call open_handle(w, "w", wear, error)
        if (.not. allocated(error)) call make_room(error, n, depths)
        if (.not. allocated(error) .and. n > 0) call wear%track(state, y(:n), passes, depths, error)
        status = status_of(error)
        if (.not. allocated(error) .and. n > 0) out(:n) = depths
    end function mdr_wear_track

    function mdr_wear_passes(w, state, depth, passes) result(status) bind(C, name="mdrcontact_entry_wear_passes")
        type(c_ptr), value :: w
        type(contact_state_t), intent(in), optional :: state
        real(c_double), value :: depth
        real(c_double), intent(inout), optional :: passes
        integer(c_int) :: status
        type(wear_t), pointer :: wear
        real(wp) :: found
        type(error_t), allocatable :: error

        call open_handle(w, "w", wear, error)
        if (.not. allocated(error)) call wear%passes_through(state, depth, found, error)
        if (.not. allocated(error)) call check_results(error, [found])
        status = status_of(error)
        if (.not. allocated(error)) passes = found
    end function mdr_wear_passes

    function mdr_wear_running_in(w, given, length) result(status) bind(C, name="mdrcontact_entry_wear_running_in")
        type(c_ptr), value :: w
        integer(c_int), value :: given
        real(c_double), intent(inout), optional :: length
        integer(c_int) :: status
        type(wear_t), pointer :: wear
        real(wp) :: found
        type(error_t), allocatable :: error

        call open_handle(w, "w", wear, error)
        if (.not. allocated(error)) call wear%running_in_length(int(given), found, error)
        if (.not. allocated(error)) call check_results(error, [found])
        status = status_of(error)
        if (.not. allocated(error)) length = found
    end function mdr_wear_running_in

    function mdr_wear_history_new(w, given, value, options, out) result(status) &
        bind(C, name="mdrcontact_entry_wear_history_new")
        type(c_ptr), value :: w, options
        integer(c_int), value :: given
        real(c_double), value :: value
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(c_wear_options_t), target :: chosen
        type(wear_t), pointer :: wear
        type(wear_history_t), allocatable :: history
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (history)
        call open_handle(w, "w", wear, error)
        call read_options(error, "options", options, c_loc(chosen), c_sizeof(chosen))
        if (chosen%places == 0) chosen%places = fresh_places
        call check_code(error, "places", int(chosen%places), [fresh_places, same_places])
        if (.not. allocated(error)) then
            call new_wear_history(history, wear, int(given), value, error, int(chosen%intervals), chosen%places == same_places, &
                                  int(chosen%scheme))
        end if
        call move_alloc(history, object)
        status = hand_over(object, out, error)
    end function mdr_wear_history_new

    function mdr_wear_history_copy(h, out) result(status) bind(C, name="mdrcontact_entry_wear_history_copy")
        type(c_ptr), value :: h
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(wear_history_t), pointer :: history
        type(wear_history_t), allocatable :: copy
        class(*), allocatable :: object
        type(error_t), allocatable :: error
        integer :: stat

        call open_handle(h, "h", history, error)
        if (.not. allocated(error)) then
            allocate (copy, stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) copy = history
        call move_alloc(copy, object)
        status = hand_over(object, out, error)
    end function mdr_wear_history_copy

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

    function mdr_wear_history_state(h, n, r, out, pressure) result(status) bind(C, name="mdrcontact_entry_wear_history_state")
        type(c_ptr), value :: h
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*)
        type(wear_state_t), intent(inout), optional :: out
        real(c_double), intent(inout), optional :: pressure(*)
        integer(c_int) :: status
        type(wear_history_t), pointer :: history
        real(wp), allocatable :: values(:)
        type(error_t), allocatable :: error

        call open_handle(h, "h", history, error)
        if (.not. allocated(error)) call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) call history%pressure(r(:n), values, error)
        status = status_of(error)
        if (allocated(error)) return
        if (n > 0) pressure(:n) = values
        if (present(out)) call history%state(out)
    end function mdr_wear_history_state

    function mdr_wear_history_profile(h, out) result(status) bind(C, name="mdrcontact_entry_wear_history_profile")
        type(c_ptr), value :: h
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(wear_history_t), pointer :: history
        type(worn_profile_t), allocatable :: profile
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        call open_handle(h, "h", history, error)
        if (.not. allocated(error)) call history%worn_profile(profile, error)
        call move_alloc(profile, object)
        status = hand_over(object, out, error)
    end function mdr_wear_history_profile

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

    function mdr_wear_history_restore(h, n, numbers) result(status) bind(C, name="mdrcontact_entry_wear_history_restore")
        type(c_ptr), value :: h
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: numbers(*)
        integer(c_int) :: status
        type(wear_history_t), pointer :: history
        real(wp), allocatable :: own(:)
        type(error_t), allocatable :: error

        call open_handle(h, "h", history, error)
        if (.not. allocated(error)) call make_room(error, n, own)
        if (.not. allocated(error) .and. n > 0) own(:) = numbers(:n)
        if (.not. allocated(error)) call history%restore(own, error)
        status = status_of(error)
    end function mdr_wear_history_restore

end module mdrcontact_api_wear
