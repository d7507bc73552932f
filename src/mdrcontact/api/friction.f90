! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts with friction, for C.
module mdrcontact_api_friction
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count, check_in_out, check_results, check_results_or_infinity, make_room
    use mdrcontact_api_handles, only: hand_over, open_handle
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_choice, check_count_from, check_memory, check_positive, error_t, raise_at
    use mdrcontact_history_friction, only: first_shear_t, friction_t, new_friction, tangential_state_t
    use mdrcontact_history_friction_history, only: friction_history_t, friction_past_t, given_shift, &
                                                   given_tangential_force, new_friction_history
    implicit none (type, external)
    private
    public :: mdr_friction_new, mdr_friction_states, mdr_friction_sliding, mdr_friction_field, mdr_friction_loop
    public :: mdr_friction_history_new, mdr_friction_history_copy, mdr_friction_history_advance

    !> enum mdr_tangential_field
    integer, parameter :: field_traction = 1, field_line_load = 2

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

    !> First shear of a normal state.
    subroutine shear_of(f, state, shear, error)
        type(c_ptr), intent(in) :: f
        type(contact_state_t), intent(in), optional :: state
        type(first_shear_t), intent(out) :: shear
        type(error_t), allocatable, intent(inout) :: error
        type(friction_t), pointer :: friction

        call open_handle(f, "f", friction, error)
        call check_given(error, "state", present(state))
        if (.not. allocated(error)) call friction%first_shear(state, shear, error)
    end subroutine shear_of

    subroutine solve(shear, given, value, state, error)
        type(first_shear_t), intent(in) :: shear
        integer(c_int), intent(in) :: given
        real(c_double), intent(in) :: value
        type(tangential_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        call check_choice(error, "given", int(given), given_shift, given_tangential_force, "1 (shift) or 2 (tangential force)")
        if (allocated(error)) return
        if (given == given_shift) then
            call shear%at_shift(value, state, error)
        else
            call shear%at_tangential_force(value, state, error)
        end if
    end subroutine solve

    function mdr_friction_states(f, state, given, n, in, out) result(status) bind(C, name="mdrcontact_entry_friction_states")
        type(c_ptr), value :: f
        type(contact_state_t), intent(in), optional :: state
        integer(c_int), value :: given, n
        real(c_double), intent(in), optional :: in(*)
        type(tangential_state_t), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(first_shear_t) :: shear
        type(tangential_state_t), allocatable :: states(:)
        type(error_t), allocatable :: error
        integer :: i, stat

        call check_in_out(error, n, "in", present(in), present(out))
        if (.not. allocated(error)) call shear_of(f, state, shear, error)
        if (.not. allocated(error)) then
            allocate (states(n), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) then
            do i = 1, n
                call solve(shear, given, in(i), states(i), error)
                if (.not. allocated(error)) call check_results(error, [states(i)%tangential_force, states(i)%shift, &
                                                                       states(i)%dissipated_energy])
                if (.not. allocated(error)) cycle
                call raise_at(error, i)
                exit
            end do
        end if
        status = status_of(error)
        if (allocated(error) .or. n == 0) return
        do i = 1, n
            out(i) = states(i)
        end do
    end function mdr_friction_states

    function mdr_friction_sliding(f, state, shift, force) result(status) bind(C, name="mdrcontact_entry_friction_sliding")
        type(c_ptr), value :: f
        type(contact_state_t), intent(in), optional :: state
        real(c_double), intent(inout), optional :: shift, force
        integer(c_int) :: status
        type(first_shear_t) :: shear
        type(error_t), allocatable :: error

        call shear_of(f, state, shear, error)
        if (.not. allocated(error)) call check_results(error, [shear%sliding_shift, shear%sliding_force])
        status = status_of(error)
        if (allocated(error)) return
        if (present(shift)) shift = shear%sliding_shift
        if (present(force)) force = shear%sliding_force
    end function mdr_friction_sliding

    function mdr_friction_field(f, state, shear, field, n, r, out) result(status) bind(C, name="mdrcontact_entry_friction_field")
        type(c_ptr), value :: f
        type(contact_state_t), intent(in), optional :: state
        type(tangential_state_t), intent(in), optional :: shear
        integer(c_int), value :: field, n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(first_shear_t) :: sheared
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error

        call check_given(error, "shear", present(shear))
        call check_in_out(error, n, "r", present(r), present(out))
        call check_choice(error, "field", int(field), field_traction, field_line_load, "1 (traction) or 2 (line load)")
        if (.not. allocated(error)) call shear_of(f, state, sheared, error)
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            if (field == field_traction) then
                call sheared%traction(shear, r(:n), values, error)
            else
                call sheared%line_load(shear, r(:n), values, error)
            end if
            if (.not. allocated(error)) call check_results_or_infinity(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function mdr_friction_field

    function mdr_friction_loop(f, state, given, amplitude, n, shift, force, dissipated) result(status) &
        bind(C, name="mdrcontact_entry_friction_loop")
        type(c_ptr), value :: f
        type(contact_state_t), intent(in), optional :: state
        integer(c_int), value :: given, n
        real(c_double), value :: amplitude
        real(c_double), intent(inout), optional :: shift(*), force(*), dissipated
        integer(c_int) :: status
        type(first_shear_t) :: shear
        type(tangential_state_t) :: turn
        real(c_double), allocatable :: shifts(:), forces(:)
        type(error_t), allocatable :: error

        call check_count_from(error, "n", int(n), 3)
        call check_array(error, "shift", n, present(shift))
        call check_array(error, "force", n, present(force))
        call check_given(error, "dissipated", present(dissipated))
        call check_positive(error, "amplitude", amplitude)
        if (.not. allocated(error)) call shear_of(f, state, shear, error)
        if (.not. allocated(error)) call solve(shear, given, amplitude, turn, error)
        call make_room(error, n, shifts)
        call make_room(error, n, forces)
        if (.not. allocated(error)) call shear%loop(turn, shifts, forces, error)
        if (.not. allocated(error)) call check_results(error, shifts)
        if (.not. allocated(error)) call check_results(error, forces)
        if (.not. allocated(error)) call check_results(error, [4.0_c_double*turn%dissipated_energy])
        status = status_of(error)
        if (allocated(error)) return
        shift(:n) = shifts
        force(:n) = forces
        dissipated = 4.0_c_double*turn%dissipated_energy
    end function mdr_friction_loop

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
        call check_count(error, n)
        call check_array(error, "normal", n, present(normal))
        call check_array(error, "tangential", n, present(tangential))
        call check_array(error, "states", n, present(states))
        call check_array(error, "out", n, present(out))
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
