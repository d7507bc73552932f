! SPDX-License-Identifier: GPL-3.0-or-later
!> Conduction through spots, for C.
module mdrcontact_api_conduction
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_each_not_negative, check_each_positive, check_results, deliver_parts, &
                                     make_room
    use mdrcontact_api_handles, only: deliver
    use mdrcontact_api_conduction_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of
    use mdrcontact_codes, only: body_lower, body_upper, flux_r, flux_z, potential, spot_flux => flux
    use mdrcontact_conduction_answers, only: admittance_of, flux_after_step, follow_history, step_of
    use mdrcontact_conduction_bodies, only: conduction_t, new_conduction
    use mdrcontact_conduction_conductors, only: conductor_t, conductors_t, new_conductors
    use mdrcontact_conduction_table, only: tabulate_conductance
    use mdrcontact_conduction_fields, only: conductance_at, flux_at, inside_at
    use mdrcontact_error, only: check_choice, check_code, check_memory, check_not_negative, error_invalid, error_t, raise, &
                                raise_at
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: mdr_conduction_new, mdr_conduction_spot, mdr_conduction_field, mdr_conduction_admittance, mdr_conduction_follow, &
              mdr_conduction_tabulate, mdr_conduction_compliance, check_body

    !> Members of struct mdr_conductor.
    integer, parameter :: members = 5
    !> Fields inside a body, in the order of the columns below.
    integer, parameter :: inside(*) = [potential, flux_z, flux_r]

contains

    function mdr_conduction_new(n, lower, lower_base, m, upper, upper_base, film, sink, out) result(status) &
        bind(C, name="mdrcontact_entry_conduction_new")
        integer(c_int), value :: n, lower_base, m, upper_base
        !> rows of struct mdr_conductor
        real(c_double), intent(in), optional :: lower(members, *), upper(members, *)
        real(c_double), value :: film, sink
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(conductors_t), allocatable :: bodies(:)
        type(conduction_t) :: conduction
        type(error_t), allocatable :: error
        integer :: stat

        if (.not. allocated(error)) then
            allocate (bodies(merge(2, 1, m > 0)), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) call take(bodies(1), int(n), lower_base, lower, error)
        if (.not. allocated(error) .and. m > 0) call take(bodies(2), int(m), upper_base, upper, error)
        if (.not. allocated(error)) call new_conduction(conduction, bodies, film, sink, error)
        status = deliver(conduction, out, error)
    end function mdr_conduction_new

    !> A body from its rows.
    subroutine take(body, n, base, rows, error)
        type(conductors_t), intent(out) :: body
        integer, intent(in) :: n
        integer(c_int), intent(in) :: base
        real(c_double), intent(in), optional :: rows(members, *)
        type(error_t), allocatable, intent(inout) :: error
        type(conductor_t), allocatable :: layers(:)
        integer :: i, stat

        allocate (layers(n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = 1, n
            layers(i) = conductor_t(rows(1, i), rows(2, i), rows(3, i), rows(4, i), rows(5, i))
        end do
        call new_conductors(body, layers, int(base), error)
    end subroutine take

    function mdr_conduction_spot(p, n, radius, conductance, slope) result(status) bind(C, name="mdrcontact_entry_conduction_spot")
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: radius(*)
        real(c_double), intent(inout), optional :: conductance(*), slope(*)
        integer(c_int) :: status
        type(conduction_t), pointer :: conduction
        real(c_double), allocatable :: values(:, :)
        type(error_t), allocatable :: error
        integer :: i, stat

        call open_handle(p, "p", conduction, error)
        if (.not. allocated(error)) then
            allocate (values(n, 2), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) then
            do i = 1, n
                call conductance_at(conduction, radius(i), values(i, 1), values(i, 2), error)
                if (.not. allocated(error)) call check_results(error, values(i, :))
                if (allocated(error)) call raise_at(error, i)
                if (allocated(error)) exit
            end do
        end if
        status = status_of(error)
        if (allocated(error)) return
        if (present(conductance)) conductance(:n) = values(:, 1)
        if (present(slope)) slope(:n) = values(:, 2)
    end function mdr_conduction_spot

    function mdr_conduction_tabulate(p, smallest, largest, tolerance, out) result(status) &
        bind(C, name="mdrcontact_entry_conduction_tabulate")
        type(c_ptr), value :: p
        real(c_double), value :: smallest, largest, tolerance
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(conduction_t), pointer :: conduction
        type(conduction_t) :: tabulated
        type(error_t), allocatable :: error

        call open_handle(p, "p", conduction, error)
        if (.not. allocated(error)) call tabulate_conductance(conduction, smallest, largest, tolerance, tabulated, error)
        status = deliver(tabulated, out, error)
    end function mdr_conduction_tabulate

    function mdr_conduction_field(p, field, radius, body, below, time, n, r, z, out) result(status) &
        bind(C, name="mdrcontact_entry_conduction_field")
        type(c_ptr), value :: p
        integer(c_int), value :: field, body, below, n
        real(c_double), value :: radius, time
        real(c_double), intent(in), optional :: r(*), z(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(conduction_t), pointer :: conduction
        real(c_double), allocatable :: values(:, :)
        type(error_t), allocatable :: error
        integer :: column, stat

        call open_handle(p, "p", conduction, error)
        call check_code(error, "field", int(field), [spot_flux, inside])
        call check_choice(error, "below", int(below), 0, 1, "0 (above an interface) or 1 (below it)")
        if (field /= spot_flux) call check_body(error, conduction, int(body))
        if (field /= spot_flux) call check_array(error, "z", n, present(z))
        call check_not_negative(error, "time", time)
        if (field /= spot_flux .and. time > 0.0_wp) then
            call raise(error, error_invalid, " is not allowed: after a step only the flux through the spot is known", "time")
        end if
        if (.not. allocated(error)) then
            allocate (values(n, size(inside)), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error) .and. n > 0) then
            if (time > 0.0_wp) then
                call flux_after_step(conduction, radius, time, r(:n), values(:, 1), error)
            else if (field == spot_flux) then
                call flux_at(conduction, radius, r(:n), values(:, 1), error)
            else
                call inside_at(conduction, merge(2, 1, body == body_upper), radius, r(:n), z(:n), below == 1, values(:, 1), &
                               values(:, 2), values(:, 3), error)
            end if
            column = max(findloc(inside, int(field), dim=1), 1)
            if (.not. allocated(error)) call check_results(error, values(:, column))
            if (.not. allocated(error)) out(:n) = values(:, column)
        end if
        status = status_of(error)
    end function mdr_conduction_field

    !> Raises unless it is a body of the conduction.
    subroutine check_body(error, conduction, body)
        type(error_t), allocatable, intent(inout) :: error
        !> not looked at after an error
        type(conduction_t), intent(in) :: conduction
        integer, intent(in) :: body

        if (allocated(error)) return
        if (size(conduction%bodies) == 1) then
            call check_code(error, "body", body, [body_lower])
        else
            call check_code(error, "body", body, [body_lower, body_upper])
        end if
    end subroutine check_body

    function mdr_conduction_compliance(p, omega, n, k, out, imaginary) result(status) &
        bind(C, name="mdrcontact_entry_conduction_compliance")
        type(c_ptr), value :: p
        real(c_double), value :: omega
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: k(*)
        real(c_double), intent(inout), optional :: out(*), imaginary(*)
        integer(c_int) :: status
        type(conduction_t), pointer :: conduction
        complex(wp), allocatable :: values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", conduction, error)
        if (.not. allocated(error)) call check_each_not_negative(error, "omega", [omega])
        if (.not. allocated(error) .and. n > 0) call check_each_positive(error, "k", k(:n))
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) call conduction%compliance(k(:n), omega, values)
        call deliver_parts(error, values, out, imaginary)
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
        type(conduction_t), pointer :: conduction
        complex(wp), allocatable :: values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", conduction, error)
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) call admittance_of(conduction, int(answer), radius, omega(:n), values, error)
        call deliver_parts(error, values, in_phase, ahead)
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
        type(conduction_t), pointer :: conduction
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", conduction, error)
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            if (present(given)) then
                call follow_history(conduction, int(answer), radius, time(:n), given(:n), values, error)
            else
                call step_of(conduction, int(answer), radius, time(:n), values, error)
            end if
            if (.not. allocated(error)) call check_results(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function mdr_conduction_follow

end module mdrcontact_api_conduction
