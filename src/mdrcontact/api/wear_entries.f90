! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of wear that convert, call and deliver, for C. Written by tools/generate.py.
module mdrcontact_api_wear_entries
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_loc, c_ptr, c_sizeof
    use mdrcontact_api_arrays, only: check_array, check_results, make_room
    use mdrcontact_api_handles, only: return_object
    use mdrcontact_api_options, only: read_options
    use mdrcontact_api_records, only: c_wear_options_t
    use mdrcontact_api_status, only: status_of
    use mdrcontact_api_wear_open_handle, only: open_handle
    use mdrcontact_codes, only: wear_fresh, wear_same
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_code, check_count_from, error_t
    use mdrcontact_profile_worn, only: worn_profile_t
    use mdrcontact_wear, only: new_wear, wear_t
    use mdrcontact_wear_history, only: new_wear_history, wear_history_t, wear_state_t
    implicit none (type, external)
    private
    public :: mdr_wear_new
    public :: mdr_wear_track
    public :: mdr_wear_passes
    public :: mdr_wear_running_in
    public :: mdr_wear_history_new
    public :: mdr_wear_history_copy
    public :: mdr_wear_history_state
    public :: mdr_wear_history_profile
    public :: mdr_wear_history_restore

contains

    function mdr_wear_new(c, n, coefficient, thickness, body_coefficient, out) result(status) &
        bind(C, name="mdrcontact_entry_wear_new")
        type(c_ptr), value :: c
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: coefficient(*), thickness(*)
        real(c_double), value :: body_coefficient
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(wear_t), allocatable :: made
        class(*), allocatable :: object
        type(contact_t), pointer :: c_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(c, "c", c_inside, error)
        if (.not. allocated(error)) call check_count_from(error, "n", n, 1)
        if (.not. allocated(error)) call check_array(error, "thickness", max(n, 1) - 1, present(thickness))
        if (.not. allocated(error) .and. n > 0) then
            if (n > 1) call new_wear(made, c_inside, coefficient(:n), error, thickness(:n - 1), body_coefficient)
        end if
        if (.not. allocated(error) .and. n > 0) then
            if (n == 1) call new_wear(made, c_inside, coefficient(:n), error, body_coefficient=body_coefficient)
        end if
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_wear_new

    function mdr_wear_track(w, state, passes, n, y, out) result(status) &
        bind(C, name="mdrcontact_entry_wear_track")
        type(c_ptr), value :: w
        type(contact_state_t), intent(in), optional :: state
        real(c_double), value :: passes
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: y(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(wear_t), pointer :: w_inside
        real(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call open_handle(w, "w", w_inside, error)
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) call w_inside%track(state, y(:n), passes, out_values, error)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_wear_track

    function mdr_wear_passes(w, state, depth, passes) result(status) &
        bind(C, name="mdrcontact_entry_wear_passes")
        type(c_ptr), value :: w
        type(contact_state_t), intent(in), optional :: state
        real(c_double), value :: depth
        real(c_double), intent(inout), optional :: passes
        integer(c_int) :: status
        type(wear_t), pointer :: w_inside
        real(c_double) :: passes_value
        type(error_t), allocatable :: error

        call open_handle(w, "w", w_inside, error)
        passes_value = 0.0_c_double
        if (.not. allocated(error)) call w_inside%passes_through(state, depth, passes_value, error)
        if (.not. allocated(error)) call check_results(error, [passes_value])
        status = status_of(error)
        if (allocated(error)) return
        if (present(passes)) passes = passes_value
    end function mdr_wear_passes

    function mdr_wear_running_in(w, given, length) result(status) &
        bind(C, name="mdrcontact_entry_wear_running_in")
        type(c_ptr), value :: w
        integer(c_int), value :: given
        real(c_double), intent(inout), optional :: length
        integer(c_int) :: status
        type(wear_t), pointer :: w_inside
        real(c_double) :: length_value
        type(error_t), allocatable :: error

        call open_handle(w, "w", w_inside, error)
        length_value = 0.0_c_double
        if (.not. allocated(error)) call w_inside%running_in_length(given, length_value, error)
        if (.not. allocated(error)) call check_results(error, [length_value])
        status = status_of(error)
        if (allocated(error)) return
        if (present(length)) length = length_value
    end function mdr_wear_running_in

    function mdr_wear_history_new(w, given, value, options, out) result(status) &
        bind(C, name="mdrcontact_entry_wear_history_new")
        type(c_ptr), value :: w, options
        integer(c_int), value :: given
        real(c_double), value :: value
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(wear_history_t), allocatable :: made
        class(*), allocatable :: object
        type(wear_t), pointer :: w_inside
        type(c_wear_options_t), target :: chosen
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(w, "w", w_inside, error)
        if (.not. allocated(error)) call read_options(error, "options", options, c_loc(chosen), c_sizeof(chosen))
        if (.not. allocated(error)) then
            if (chosen%places == 0) chosen%places = wear_fresh
        end if
        if (.not. allocated(error)) call check_code(error, "places", chosen%places, [wear_fresh, wear_same])
        if (.not. allocated(error)) then
            call new_wear_history(made, w_inside, given, value, error, chosen%intervals, chosen%places == wear_same, &
                chosen%scheme)
        end if
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_wear_history_new

    function mdr_wear_history_copy(h, out) result(status) &
        bind(C, name="mdrcontact_entry_wear_history_copy")
        type(c_ptr), value :: h
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(wear_history_t), allocatable :: made
        class(*), allocatable :: object
        type(wear_history_t), pointer :: h_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(h, "h", h_inside, error)
        if (.not. allocated(error)) made = h_inside
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_wear_history_copy

    function mdr_wear_history_state(h, n, r, out, pressure) result(status) &
        bind(C, name="mdrcontact_entry_wear_history_state")
        type(c_ptr), value :: h
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*)
        type(wear_state_t), intent(inout), optional :: out
        real(c_double), intent(inout), optional :: pressure(*)
        integer(c_int) :: status
        type(wear_history_t), pointer :: h_inside
        real(c_double), allocatable :: pressure_values(:)
        type(wear_state_t) :: out_value
        type(error_t), allocatable :: error

        call open_handle(h, "h", h_inside, error)
        call make_room(error, n, pressure_values)
        if (.not. allocated(error) .and. n > 0) call h_inside%pressure(r(:n), pressure_values, error)
        if (.not. allocated(error)) call h_inside%state(out_value)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out = out_value
        if (present(pressure)) pressure(:n) = pressure_values
    end function mdr_wear_history_state

    function mdr_wear_history_profile(h, out) result(status) &
        bind(C, name="mdrcontact_entry_wear_history_profile")
        type(c_ptr), value :: h
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(worn_profile_t), allocatable :: made
        class(*), allocatable :: object
        type(wear_history_t), pointer :: h_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(h, "h", h_inside, error)
        if (.not. allocated(error)) call h_inside%worn_profile(made, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_wear_history_profile

    function mdr_wear_history_restore(h, n, numbers) result(status) &
        bind(C, name="mdrcontact_entry_wear_history_restore")
        type(c_ptr), value :: h
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: numbers(*)
        integer(c_int) :: status
        type(wear_history_t), pointer :: h_inside
        real(c_double), allocatable :: own(:)
        type(error_t), allocatable :: error

        call open_handle(h, "h", h_inside, error)
        if (.not. allocated(error)) call make_room(error, n, own)
        if (.not. allocated(error) .and. n > 0) own(:) = numbers(:n)
        if (.not. allocated(error)) call h_inside%restore(own, error)
        status = status_of(error)
    end function mdr_wear_history_restore

end module mdrcontact_api_wear_entries
