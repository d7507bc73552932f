! SPDX-License-Identifier: GPL-3.0-or-later
!> Pull-off and loops of adhesive contacts, for C.
module mdrcontact_api_loop
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_loc, c_ptr, c_size_t, c_sizeof
    use mdrcontact_api_arrays, only: check_array, check_results
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_options, only: check_size, write_facts
    use mdrcontact_api_records, only: c_loop_facts_t
    use mdrcontact_api_status, only: status_of
    use mdrcontact_codes, only: by_depth => depth, by_force => force, by_spring => spring
    use mdrcontact_contact_control, only: control_t, depth_control, force_control
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_code, check_count_from, error_t
    use mdrcontact_contact_loop, only: loop_t, spring_control
    implicit none (type, external)
    private
    public :: mdr_contact_pull_off, choose_control
    public :: mdr_loop_points, mdr_loop_about

    !> struct mdr_loop_point
    type, bind(C) :: point_t
        real(c_double) :: position, depth, radius, force, jumps
    end type point_t

contains

    function mdr_contact_pull_off(c, control, capacity, out, count) result(status) &
        bind(C, name="mdrcontact_entry_contact_pull_off")
        type(c_ptr), value :: c
        integer(c_int), value :: control, capacity
        type(contact_state_t), intent(inout), optional :: out(*)
        integer(c_int), intent(inout), optional :: count
        integer(c_int) :: status
        type(contact_t), pointer :: contact
        type(control_t) :: chosen
        type(contact_state_t) :: state
        type(contact_state_t), allocatable :: all_states(:), others(:)
        type(error_t), allocatable :: error
        integer :: n

        call open_handle(c, "c", contact, error)
        call check_count_from(error, "capacity", int(capacity), 0)
        call check_array(error, "out", capacity, present(out))
        call choose_control(chosen, control, 0.0_c_double, .false., error)
        if (.not. allocated(error)) call contact%pull_off(chosen, state, error, others)
        status = status_of(error)
        if (allocated(error)) return
        all_states = [state, others]
        if (present(count)) count = merge(size(all_states, kind=c_int), 0_c_int, contact%is_adhesive())
        n = min(size(all_states), int(capacity))
        if (n > 0) out(:n) = all_states(:n)
    end function mdr_contact_pull_off

    function mdr_loop_points(l, capacity, out, count) result(status) bind(C)
        type(c_ptr), value :: l
        integer(c_int), value :: capacity
        type(point_t), intent(inout), optional :: out(*)
        integer(c_int), intent(inout), optional :: count
        integer(c_int) :: status
        type(loop_t), pointer :: loop
        type(error_t), allocatable :: error
        integer :: i, n

        call open_handle(l, "l", loop, error)
        call check_count_from(error, "capacity", int(capacity), 0)
        call check_array(error, "out", capacity, present(out))
        status = status_of(error)
        if (allocated(error)) return
        n = size(loop%position)
        if (present(count)) count = int(n, c_int)
        do i = 1, min(n, int(capacity))
            associate (state => loop%state(i))
                out(i) = point_t(loop%position(i), state%depth, state%radius, state%force, 0.0_c_double)
            end associate
            if (any(loop%jumps == i)) out(i)%jumps = 1.0_c_double
        end do
    end function mdr_loop_points

    function mdr_loop_about(l, facts) result(status) bind(C, name="mdrcontact_entry_loop_about")
        type(c_ptr), value :: l, facts
        integer(c_int) :: status
        type(loop_t), pointer :: loop
        type(c_loop_facts_t), target :: made
        integer(c_size_t) :: used
        type(error_t), allocatable :: error

        call open_handle(l, "l", loop, error)
        call check_size(error, "facts", facts, c_sizeof(made), used)
        if (.not. allocated(error)) call check_results(error, [loop%dissipated_energy])
        status = status_of(error)
        if (allocated(error)) return
        made%dissipated_energy = loop%dissipated_energy
        made%points = size(loop%position, kind=c_int)
        made%turning_point = int(loop%turning_point - 1, c_int)
        made%jumps = size(loop%jumps, kind=c_int)
        call write_facts(facts, c_loc(made), used)
    end function mdr_loop_about

    !> The control behind its code. A spring is allowed for loops only.
    subroutine choose_control(chosen, control, spring_stiffness, spring_allowed, error)
        type(control_t), intent(out) :: chosen
        integer(c_int), intent(in) :: control
        real(c_double), intent(in) :: spring_stiffness
        logical, intent(in) :: spring_allowed
        type(error_t), allocatable, intent(inout) :: error

        if (spring_allowed) then
            call check_code(error, "control", int(control), [by_force, by_depth, by_spring])
        else
            call check_code(error, "control", int(control), [by_force, by_depth])
        end if
        if (allocated(error)) return
        select case (control)
        case (by_force)
            chosen = force_control
        case (by_depth)
            chosen = depth_control
        case default
            call spring_control(chosen, spring_stiffness, error)
        end select
    end subroutine choose_control

end module mdrcontact_api_loop
