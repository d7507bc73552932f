! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of conduction that convert, call and deliver, for C. Written by tools/generate.py.
module mdrcontact_api_conduction_entries
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_each_finite, check_each_positive, check_results, make_room, return_parts
    use mdrcontact_api_conduction, only: take_conductors
    use mdrcontact_api_conduction_open_handle, only: open_handle
    use mdrcontact_api_handles, only: return_object
    use mdrcontact_api_status, only: status_of
    use mdrcontact_conduction_along, only: conductance_along
    use mdrcontact_conduction_answers, only: admittance_of, follow_history, step_of
    use mdrcontact_conduction_bodies, only: conduction_t, new_conduction
    use mdrcontact_conduction_conductors, only: conductors_t
    use mdrcontact_conduction_fields, only: conductance_at
    use mdrcontact_conduction_rough, only: joint_conductance, rough_conductance
    use mdrcontact_conduction_rough_law, only: micro_resistance
    use mdrcontact_conduction_table, only: tabulate_conductance
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_memory, error_t, raise_at
    implicit none (type, external)
    private
    public :: mdr_conduction_new
    public :: mdr_conduction_spot
    public :: mdr_conduction_tabulate
    public :: mdr_conduction_compliance
    public :: mdr_conduction_admittance
    public :: mdr_conduction_follow
    public :: mdr_conduction_rough
    public :: mdr_conduction_joint_resistance
    public :: mdr_conduction_joint
    public :: mdr_conduction_along

contains

    function mdr_conduction_new(n, lower, lower_base, m, upper, upper_base, film, sink, out) result(status) &
        bind(C, name="mdrcontact_entry_conduction_new")
        integer(c_int), value :: n, lower_base, m, upper_base
        real(c_double), intent(in), optional :: lower(5, *), upper(5, *)
        real(c_double), value :: film, sink
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(conduction_t), allocatable :: made
        class(*), allocatable :: object
        type(conductors_t), allocatable :: bodies(:)
        integer :: stat
        type(error_t), allocatable :: error

        allocate (made)
        if (.not. allocated(error)) then
            allocate (bodies(merge(2, 1, m > 0)), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) call take_conductors(bodies(1), n, lower_base, lower, error)
        if (.not. allocated(error)) then
            if (m > 0) call take_conductors(bodies(2), m, upper_base, upper, error)
        end if
        if (.not. allocated(error)) call new_conduction(made, bodies, film, sink, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_conduction_new

    function mdr_conduction_spot(p, n, radius, conductance, slope) result(status) &
        bind(C, name="mdrcontact_entry_conduction_spot")
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: radius(*)
        real(c_double), intent(inout), optional :: conductance(*), slope(*)
        integer(c_int) :: status
        type(conduction_t), pointer :: p_inside
        real(c_double), allocatable :: conductance_values(:), slope_values(:)
        integer :: i
        type(error_t), allocatable :: error

        call open_handle(p, "p", p_inside, error)
        call make_room(error, n, conductance_values)
        call make_room(error, n, slope_values)
        do i = 1, n
            if (allocated(error)) exit
            call conductance_at(p_inside, radius(i), conductance_values(i), slope_values(i), error)
            if (.not. allocated(error)) call check_results(error, [conductance_values(i), slope_values(i)])
            if (allocated(error)) call raise_at(error, i)
        end do
        status = status_of(error)
        if (allocated(error)) return
        if (present(conductance)) conductance(:n) = conductance_values
        if (present(slope)) slope(:n) = slope_values
    end function mdr_conduction_spot

    function mdr_conduction_tabulate(p, smallest, largest, tolerance, out) result(status) &
        bind(C, name="mdrcontact_entry_conduction_tabulate")
        type(c_ptr), value :: p
        real(c_double), value :: smallest, largest, tolerance
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(conduction_t), allocatable :: made
        class(*), allocatable :: object
        type(conduction_t), pointer :: p_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(p, "p", p_inside, error)
        if (.not. allocated(error)) call tabulate_conductance(p_inside, smallest, largest, tolerance, made, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_conduction_tabulate

    function mdr_conduction_compliance(p, n, k, omega, out, imaginary) result(status) &
        bind(C, name="mdrcontact_entry_conduction_compliance")
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: k(*), omega(*)
        real(c_double), intent(inout), optional :: out(*), imaginary(*)
        integer(c_int) :: status
        type(conduction_t), pointer :: p_inside
        real(c_double), allocatable :: frequencies(:)
        complex(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", p_inside, error)
        if (.not. allocated(error)) call make_room(error, n, frequencies)
        if (.not. allocated(error)) frequencies(:) = 0.0_c_double
        if (.not. allocated(error) .and. n > 0) then
            if (present(omega)) frequencies(:) = omega(:n)
        end if
        if (.not. allocated(error)) call check_each_finite(error, "omega", frequencies)
        if (.not. allocated(error) .and. n > 0) call check_each_positive(error, "k", k(:n))
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) call p_inside%compliance(k(:n), frequencies, out_values)
        call return_parts(error, out_values, out, imaginary)
        status = status_of(error)
    end function mdr_conduction_compliance

    function mdr_conduction_admittance(p, answer, radius, n, omega, in_phase, ahead) result(status) &
        bind(C, name="mdrcontact_entry_conduction_admittance")
        type(c_ptr), value :: p
        integer(c_int), value :: answer, n
        real(c_double), value :: radius
        real(c_double), intent(in), optional :: omega(*)
        real(c_double), intent(inout), optional :: in_phase(*), ahead(*)
        integer(c_int) :: status
        type(conduction_t), pointer :: p_inside
        complex(c_double), allocatable :: in_phase_values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", p_inside, error)
        call make_room(error, n, in_phase_values)
        if (.not. allocated(error) .and. n > 0) call admittance_of(p_inside, answer, radius, omega(:n), in_phase_values, error)
        call return_parts(error, in_phase_values, in_phase, ahead)
        status = status_of(error)
    end function mdr_conduction_admittance

    function mdr_conduction_follow(p, answer, radius, n, time, given, out) result(status) &
        bind(C, name="mdrcontact_entry_conduction_follow")
        type(c_ptr), value :: p
        integer(c_int), value :: answer, n
        real(c_double), value :: radius
        real(c_double), intent(in), optional :: time(*), given(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(conduction_t), pointer :: p_inside
        real(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", p_inside, error)
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) then
            if (present(given)) call follow_history(p_inside, answer, radius, time(:n), given(:n), out_values, error)
        end if
        if (.not. allocated(error) .and. n > 0) then
            if (.not. present(given)) call step_of(p_inside, answer, radius, time(:n), out_values, error)
        end if
        if (.not. allocated(error)) call check_results(error, out_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_conduction_follow

    function mdr_conduction_rough(p, c, state, kappa, out) result(status) &
        bind(C, name="mdrcontact_entry_conduction_rough")
        type(c_ptr), value :: p, c
        type(contact_state_t), intent(in), optional :: state
        real(c_double), value :: kappa
        real(c_double), intent(inout), optional :: out
        integer(c_int) :: status
        type(conduction_t), pointer :: p_inside
        type(contact_t), pointer :: c_inside
        real(c_double) :: out_value
        type(error_t), allocatable :: error

        call open_handle(p, "p", p_inside, error)
        call open_handle(c, "c", c_inside, error)
        out_value = 0.0_c_double
        if (.not. allocated(error)) call rough_conductance(p_inside, c_inside, state, kappa, out_value, error)
        if (.not. allocated(error)) call check_results(error, [out_value])
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out = out_value
    end function mdr_conduction_rough

    function mdr_conduction_joint_resistance(p, roughness, slope, hardness, gas, jump, n, pressure, out) result(status) &
        bind(C, name="mdrcontact_entry_conduction_joint_resistance")
        type(c_ptr), value :: p
        real(c_double), value :: roughness, slope, hardness, gas, jump
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: pressure(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(conduction_t), pointer :: p_inside
        real(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", p_inside, error)
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) then
            call micro_resistance(p_inside, roughness, slope, hardness, gas, jump, pressure(:n), out_values, error)
        end if
        if (.not. allocated(error)) call check_results(error, out_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_conduction_joint_resistance

    function mdr_conduction_joint(p, c, state, roughness, slope, hardness, gas, jump, out) result(status) &
        bind(C, name="mdrcontact_entry_conduction_joint")
        type(c_ptr), value :: p, c
        type(contact_state_t), intent(in), optional :: state
        real(c_double), value :: roughness, slope, hardness, gas, jump
        real(c_double), intent(inout), optional :: out
        integer(c_int) :: status
        type(conduction_t), pointer :: p_inside
        type(contact_t), pointer :: c_inside
        real(c_double) :: out_value
        type(error_t), allocatable :: error

        call open_handle(p, "p", p_inside, error)
        call open_handle(c, "c", c_inside, error)
        out_value = 0.0_c_double
        if (.not. allocated(error)) then
            call joint_conductance(p_inside, c_inside, state, roughness, slope, hardness, gas, jump, out_value, error)
        end if
        if (.not. allocated(error)) call check_results(error, [out_value])
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out = out_value
    end function mdr_conduction_joint

    function mdr_conduction_along(p, c, n, states, conductance, by_force, by_depth) result(status) &
        bind(C, name="mdrcontact_entry_conduction_along")
        type(c_ptr), value :: p, c
        integer(c_int), value :: n
        type(contact_state_t), intent(in), optional :: states(*)
        real(c_double), intent(inout), optional :: conductance(*), by_force(*), by_depth(*)
        integer(c_int) :: status
        type(conduction_t), pointer :: p_inside
        type(contact_t), pointer :: c_inside
        real(c_double), allocatable :: conductance_values(:), by_force_values(:), by_depth_values(:)
        integer :: i
        type(error_t), allocatable :: error

        call open_handle(p, "p", p_inside, error)
        call open_handle(c, "c", c_inside, error)
        call make_room(error, n, conductance_values)
        call make_room(error, n, by_force_values)
        call make_room(error, n, by_depth_values)
        do i = 1, n
            if (allocated(error)) exit
            call conductance_along(p_inside, c_inside, states(i), conductance_values(i), by_force_values(i), by_depth_values(i), &
                error)
            if (.not. allocated(error)) call check_results(error, [conductance_values(i), by_force_values(i), by_depth_values(i)])
            if (allocated(error)) call raise_at(error, i)
        end do
        status = status_of(error)
        if (allocated(error)) return
        if (present(conductance)) conductance(:n) = conductance_values
        if (present(by_force)) by_force(:n) = by_force_values
        if (present(by_depth)) by_depth(:n) = by_depth_values
    end function mdr_conduction_along

end module mdrcontact_api_conduction_entries
