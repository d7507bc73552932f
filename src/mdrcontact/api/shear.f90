! SPDX-License-Identifier: GPL-3.0-or-later
!> First shear and first twist of states of contacts with friction, for C. The handle holds the slip, which is solved once.
module mdrcontact_api_shear
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_loc, c_ptr, c_size_t, c_sizeof
    use mdrcontact_api_arrays, only: check_results, check_results_or_infinity, make_room
    use mdrcontact_api_handles, only: return_object
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_options, only: check_size, write_facts
    use mdrcontact_api_records, only: c_shear_facts_t
    use mdrcontact_api_status, only: status_of
    use mdrcontact_codes, only: along, around, field_line_load => tangential_line_load, field_traction => traction, &
                                given_shift => shift, given_tangential_force => tangential_force, given_torque => torque, &
                                given_twist => twist
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_error, only: check_code, check_count_from, check_memory, check_positive, error_t, raise_at
    use mdrcontact_friction_partial_slip, only: first_shear_t, friction_t, tangential_state_t
    implicit none (type, external)
    private
    public :: mdr_shear_new, mdr_shear_states, mdr_shear_about, mdr_shear_field, mdr_shear_loop

contains

    function mdr_shear_new(f, load, direction, out) result(status) bind(C, name="mdrcontact_entry_shear_new")
        type(c_ptr), value :: f, load
        integer(c_int), value :: direction
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(friction_t), pointer :: friction
        type(contact_load_t), pointer :: pressed
        type(first_shear_t), allocatable :: shear
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (shear)
        call open_handle(f, "f", friction, error)
        call open_handle(load, "load", pressed, error)
        call check_code(error, "direction", int(direction), [along, around])
        if (.not. allocated(error)) then
            if (direction == around) then
                call friction%first_twist(pressed, shear, error)
            else
                call friction%first_shear(pressed, shear, error)
            end if
        end if
        if (.not. allocated(error)) call check_results(error, [shear%sliding_force])
        call move_alloc(shear, object)
        status = return_object(object, out, error)
    end function mdr_shear_new

    subroutine solve(shear, given, value, state, error)
        type(first_shear_t), intent(in) :: shear
        integer(c_int), intent(in) :: given
        real(c_double), intent(in) :: value
        type(tangential_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        if (shear%is_twist()) then
            call check_code(error, "given", int(given), [given_twist, given_torque])
        else
            call check_code(error, "given", int(given), [given_shift, given_tangential_force])
        end if
        if (allocated(error)) return
        if (given == merge(given_twist, given_shift, shear%is_twist())) then
            call shear%at_shift(value, state, error)
        else
            call shear%at_tangential_force(value, state, error)
        end if
    end subroutine solve

    function mdr_shear_states(s, given, n, in, out) result(status) bind(C, name="mdrcontact_entry_shear_states")
        type(c_ptr), value :: s
        integer(c_int), value :: given, n
        real(c_double), intent(in), optional :: in(*)
        type(tangential_state_t), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(first_shear_t), pointer :: shear
        type(tangential_state_t), allocatable :: states(:)
        type(error_t), allocatable :: error
        integer :: i, stat

        call open_handle(s, "s", shear, error)
        if (.not. allocated(error)) then
            allocate (states(n), stat=stat)
            call check_memory(error, stat)
        end if
        do i = 1, n
            if (allocated(error)) exit
            call solve(shear, given, in(i), states(i), error)
            if (.not. allocated(error)) call check_results(error, [states(i)%tangential_force, states(i)%shift, &
                                                                   states(i)%dissipated_energy])
            if (allocated(error)) call raise_at(error, i)
        end do
        status = status_of(error)
        if (allocated(error) .or. n == 0) return
        out(:n) = states
    end function mdr_shear_states

    function mdr_shear_about(s, facts) result(status) bind(C, name="mdrcontact_entry_shear_about")
        type(c_ptr), value :: s, facts
        integer(c_int) :: status
        type(first_shear_t), pointer :: shear
        type(c_shear_facts_t), target :: made
        integer(c_size_t) :: used
        type(error_t), allocatable :: error

        call open_handle(s, "s", shear, error)
        call check_size(error, "facts", facts, c_sizeof(made), used)
        ! the axis sticks at any twist
        if (.not. allocated(error)) call check_results(error, [merge(0.0_c_double, shear%sliding_shift, shear%is_twist())])
        status = status_of(error)
        if (allocated(error)) return
        made%sliding_shift = shear%sliding_shift
        made%sliding_force = shear%sliding_force
        made%direction = merge(int(around, c_int), int(along, c_int), shear%is_twist())
        call write_facts(facts, c_loc(made), used)
    end function mdr_shear_about

    function mdr_shear_field(s, at, field, n, r, out) result(status) bind(C, name="mdrcontact_entry_shear_field")
        type(c_ptr), value :: s
        type(tangential_state_t), intent(in), optional :: at
        integer(c_int), value :: field, n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(first_shear_t), pointer :: shear
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error

        call open_handle(s, "s", shear, error)
        call check_code(error, "field", int(field), [field_traction, field_line_load])
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            if (field == field_traction) then
                call shear%traction(at, r(:n), values, error)
            else
                call shear%line_load(at, r(:n), values, error)
            end if
            if (.not. allocated(error)) call check_results_or_infinity(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function mdr_shear_field

    function mdr_shear_loop(s, given, amplitude, n, shift, force, dissipated) result(status) &
        bind(C, name="mdrcontact_entry_shear_loop")
        type(c_ptr), value :: s
        integer(c_int), value :: given, n
        real(c_double), value :: amplitude
        real(c_double), intent(inout), optional :: shift(*), force(*), dissipated
        integer(c_int) :: status
        type(first_shear_t), pointer :: shear
        type(tangential_state_t) :: turn
        real(c_double), allocatable :: shifts(:), forces(:)
        type(error_t), allocatable :: error

        call open_handle(s, "s", shear, error)
        call check_count_from(error, "n", int(n), 3)
        call check_positive(error, "amplitude", amplitude)
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
    end function mdr_shear_loop

end module mdrcontact_api_shear
