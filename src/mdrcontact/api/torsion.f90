! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts with friction that are twisted, for C.
module mdrcontact_api_torsion
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_in_out, check_results, check_results_or_infinity, make_room
    use mdrcontact_api_handles, only: open_handle
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_choice, check_count_from, check_memory, check_positive, error_t, raise_at
    use mdrcontact_history_friction, only: friction_t
    use mdrcontact_history_torsion, only: new_torsion, torsion_t, torsional_state_t
    implicit none (type, external)
    private
    public :: mdr_torsion_states, mdr_torsion_sliding, mdr_torsion_field, mdr_torsion_loop

    !> enum mdr_torsional_given and enum mdr_tangential_field
    integer, parameter :: given_twist = 1, given_torque = 2, field_traction = 1, field_line_load = 2

contains

    !> First twist of a normal state.
    subroutine torsion_of(f, state, torsion, error)
        type(c_ptr), intent(in) :: f
        type(contact_state_t), intent(in), optional :: state
        type(torsion_t), intent(out) :: torsion
        type(error_t), allocatable, intent(inout) :: error
        type(friction_t), pointer :: friction

        call open_handle(f, "f", friction, error)
        call check_given(error, "state", present(state))
        if (.not. allocated(error)) call new_torsion(torsion, friction, state, error)
    end subroutine torsion_of

    subroutine solve(torsion, given, value, state, error)
        type(torsion_t), intent(in) :: torsion
        integer(c_int), intent(in) :: given
        real(c_double), intent(in) :: value
        type(torsional_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        call check_choice(error, "given", int(given), given_twist, given_torque, "1 (twist) or 2 (torque)")
        if (allocated(error)) return
        if (given == given_twist) then
            call torsion%at_twist(value, state, error)
        else
            call torsion%at_torque(value, state, error)
        end if
    end subroutine solve

    function mdr_torsion_states(f, state, given, n, in, out) result(status) bind(C, name="mdrcontact_entry_torsion_states")
        type(c_ptr), value :: f
        type(contact_state_t), intent(in), optional :: state
        integer(c_int), value :: given, n
        real(c_double), intent(in), optional :: in(*)
        type(torsional_state_t), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(torsion_t) :: torsion
        type(torsional_state_t), allocatable :: states(:)
        type(error_t), allocatable :: error
        integer :: i, stat

        call check_in_out(error, n, "in", present(in), present(out))
        if (.not. allocated(error)) call torsion_of(f, state, torsion, error)
        if (.not. allocated(error)) then
            allocate (states(n), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) then
            do i = 1, n
                call solve(torsion, given, in(i), states(i), error)
                if (.not. allocated(error)) cycle
                call raise_at(error, i)
                exit
            end do
        end if
        if (.not. allocated(error) .and. n > 0) then
            call check_results(error, states%torque)
            call check_results(error, states%twist)
            call check_results(error, states%dissipated_energy)
            if (.not. allocated(error)) out(:n) = states
        end if
        status = status_of(error)
    end function mdr_torsion_states

    function mdr_torsion_sliding(f, state, torque) result(status) bind(C, name="mdrcontact_entry_torsion_sliding")
        type(c_ptr), value :: f
        type(contact_state_t), intent(in), optional :: state
        real(c_double), intent(inout), optional :: torque
        integer(c_int) :: status
        type(torsion_t) :: torsion
        type(error_t), allocatable :: error

        call check_given(error, "torque", present(torque))
        if (.not. allocated(error)) call torsion_of(f, state, torsion, error)
        if (.not. allocated(error)) call check_results(error, [torsion%sliding_torque])
        status = status_of(error)
        if (.not. allocated(error)) torque = torsion%sliding_torque
    end function mdr_torsion_sliding

    function mdr_torsion_field(f, state, twisted, field, n, r, out) result(status) bind(C, name="mdrcontact_entry_torsion_field")
        type(c_ptr), value :: f
        type(contact_state_t), intent(in), optional :: state
        type(torsional_state_t), intent(in), optional :: twisted
        integer(c_int), value :: field, n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(torsion_t) :: torsion
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error

        call check_given(error, "twisted", present(twisted))
        call check_in_out(error, n, "r", present(r), present(out))
        call check_choice(error, "field", int(field), field_traction, field_line_load, "1 (traction) or 2 (line load)")
        if (.not. allocated(error)) call torsion_of(f, state, torsion, error)
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            if (field == field_traction) then
                call torsion%traction(twisted, r(:n), values, error)
            else
                call torsion%line_load(twisted, r(:n), values, error)
            end if
            if (.not. allocated(error)) call check_results_or_infinity(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function mdr_torsion_field

    function mdr_torsion_loop(f, state, given, amplitude, n, twist, torque, dissipated) result(status) &
        bind(C, name="mdrcontact_entry_torsion_loop")
        type(c_ptr), value :: f
        type(contact_state_t), intent(in), optional :: state
        integer(c_int), value :: given, n
        real(c_double), value :: amplitude
        real(c_double), intent(inout), optional :: twist(*), torque(*), dissipated
        integer(c_int) :: status
        type(torsion_t) :: torsion
        type(torsional_state_t) :: turn
        real(c_double), allocatable :: twists(:), torques(:)
        type(error_t), allocatable :: error

        call check_count_from(error, "n", int(n), 3)
        call check_array(error, "twist", n, present(twist))
        call check_array(error, "torque", n, present(torque))
        call check_given(error, "dissipated", present(dissipated))
        call check_positive(error, "amplitude", amplitude)
        if (.not. allocated(error)) call torsion_of(f, state, torsion, error)
        if (.not. allocated(error)) call solve(torsion, given, amplitude, turn, error)
        call make_room(error, n, twists)
        call make_room(error, n, torques)
        if (.not. allocated(error)) call torsion%loop(turn, twists, torques, error)
        if (.not. allocated(error)) call check_results(error, [twists, torques, 4.0_c_double*turn%dissipated_energy])
        status = status_of(error)
        if (allocated(error)) return
        twist(:n) = twists
        torque(:n) = torques
        dissipated = 4.0_c_double*turn%dissipated_energy
    end function mdr_torsion_loop

end module mdrcontact_api_torsion
