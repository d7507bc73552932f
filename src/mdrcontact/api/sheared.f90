! SPDX-License-Identifier: GPL-3.0-or-later
!> What contacts with friction answer to a shift and to a twist, for C: states, fields and loops of both.
module mdrcontact_api_sheared
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_in_out, check_results, check_results_or_infinity, make_room
    use mdrcontact_api_handles, only: open_handle
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_choice, check_count_from, check_memory, check_positive, error_t, raise_at
    use mdrcontact_history_friction, only: first_shear_t, friction_t, tangential_state_t
    implicit none (type, external)
    private
    public :: shear_of, write_states, write_field, write_loop, by_shift, by_twist

    !> What the contact is sheared by; enum mdr_tangential_given and mdr_torsional_given; enum mdr_tangential_field
    integer, parameter :: by_shift = 1, by_twist = 2, given_way = 1, given_load = 2, field_traction = 1, field_line_load = 2
    !> Names of arguments, and what may be given.
    character(len=*), parameter :: ways(*) = [character(len=5) :: "shift", "twist"], &
                                   loads(*) = [character(len=6) :: "force", "torque"], &
                                   sheared(*) = [character(len=7) :: "shear", "twisted"], &
                                   choices(*) = [character(len=33) :: "1 (shift) or 2 (tangential force)", &
                                                                       "1 (twist) or 2 (torque)"]

contains

    !> First shear of a normal state.
    subroutine shear_of(f, by, state, shear, error)
        type(c_ptr), intent(in) :: f
        integer, intent(in) :: by
        type(contact_state_t), intent(in), optional :: state
        type(first_shear_t), intent(out) :: shear
        type(error_t), allocatable, intent(inout) :: error
        type(friction_t), pointer :: friction

        call open_handle(f, "f", friction, error)
        call check_given(error, "state", present(state))
        if (allocated(error)) return
        if (by == by_twist) then
            call friction%first_twist(state, shear, error)
        else
            call friction%first_shear(state, shear, error)
        end if
    end subroutine shear_of

    subroutine solve(shear, by, given, value, state, error)
        type(first_shear_t), intent(in) :: shear
        integer, intent(in) :: by
        integer(c_int), intent(in) :: given
        real(c_double), intent(in) :: value
        type(tangential_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        call check_choice(error, "given", int(given), given_way, given_load, trim(choices(by)))
        if (allocated(error)) return
        if (given == given_way) then
            call shear%at_shift(value, state, error)
        else
            call shear%at_tangential_force(value, state, error)
        end if
    end subroutine solve

    !> The state at each of n shifts or loads.
    function write_states(f, by, state, given, n, in, out) result(status)
        type(c_ptr), intent(in) :: f
        integer, intent(in) :: by
        type(contact_state_t), intent(in), optional :: state
        integer(c_int), intent(in) :: given, n
        real(c_double), intent(in), optional :: in(*)
        !> [n] tangential_state_t, or null: gfortran takes the address of an absent array of structures that is passed on
        type(c_ptr), intent(in) :: out
        integer(c_int) :: status
        type(first_shear_t) :: shear
        type(tangential_state_t), allocatable :: states(:)
        type(tangential_state_t), pointer :: results(:)
        type(error_t), allocatable :: error
        integer :: i, stat

        call check_in_out(error, n, "in", present(in), c_associated(out))
        if (.not. allocated(error)) call shear_of(f, by, state, shear, error)
        if (.not. allocated(error)) then
            allocate (states(n), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) then
            do i = 1, n
                call solve(shear, by, given, in(i), states(i), error)
                if (.not. allocated(error)) call check_results(error, [states(i)%tangential_force, states(i)%shift, &
                                                                       states(i)%dissipated_energy])
                if (.not. allocated(error)) cycle
                call raise_at(error, i)
                exit
            end do
        end if
        status = status_of(error)
        if (allocated(error) .or. n == 0) return
        call c_f_pointer(out, results, [n])
        results = states
    end function write_states

    !> Tractions or line load of a state at n positions.
    function write_field(f, by, state, shear, field, n, r, out) result(status)
        type(c_ptr), intent(in) :: f
        integer, intent(in) :: by
        type(contact_state_t), intent(in), optional :: state
        type(tangential_state_t), intent(in), optional :: shear
        integer(c_int), intent(in) :: field, n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(first_shear_t) :: first
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error

        call check_given(error, trim(sheared(by)), present(shear))
        call check_in_out(error, n, "r", present(r), present(out))
        call check_choice(error, "field", int(field), field_traction, field_line_load, "1 (traction) or 2 (line load)")
        if (.not. allocated(error)) call shear_of(f, by, state, first, error)
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            if (field == field_traction) then
                call first%traction(shear, r(:n), values, error)
            else
                call first%line_load(shear, r(:n), values, error)
            end if
            if (.not. allocated(error)) call check_results_or_infinity(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function write_field

    !> A cycle in n steps, and what it dissipates.
    function write_loop(f, by, state, given, amplitude, n, shift, force, dissipated) result(status)
        type(c_ptr), intent(in) :: f
        integer, intent(in) :: by
        type(contact_state_t), intent(in), optional :: state
        integer(c_int), intent(in) :: given, n
        real(c_double), intent(in) :: amplitude
        real(c_double), intent(inout), optional :: shift(*), force(*), dissipated
        integer(c_int) :: status
        type(first_shear_t) :: shear
        type(tangential_state_t) :: turn
        real(c_double), allocatable :: shifts(:), forces(:)
        type(error_t), allocatable :: error

        call check_count_from(error, "n", int(n), 3)
        call check_array(error, ways(by), n, present(shift))
        call check_array(error, trim(loads(by)), n, present(force))
        call check_given(error, "dissipated", present(dissipated))
        call check_positive(error, "amplitude", amplitude)
        if (.not. allocated(error)) call shear_of(f, by, state, shear, error)
        if (.not. allocated(error)) call solve(shear, by, given, amplitude, turn, error)
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
    end function write_loop

end module mdrcontact_api_sheared
