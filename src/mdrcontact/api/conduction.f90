! SPDX-License-Identifier: GPL-3.0-or-later
!> Conduction through contact areas, for C.
module mdrcontact_api_conduction
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_results
    use mdrcontact_api_conduction_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of
    use mdrcontact_codes, only: body_lower, body_upper, flux_r, flux_z, potential, spot_flux => flux
    use mdrcontact_conduction_answers, only: flux_after_step
    use mdrcontact_conduction_bodies, only: conduction_t
    use mdrcontact_conduction_conductors, only: conductor_t, conductors_t, new_conductors
    use mdrcontact_conduction_fields, only: flux_at, inside_at
    use mdrcontact_error, only: check_choice, check_code, check_memory, check_not_negative, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: mdr_conduction_field, check_body, take_conductors

    !> Members of struct mdr_conductor.
    integer, parameter :: members = 5
    !> Fields inside a body, in the order of the columns below.
    integer, parameter :: inside(*) = [potential, flux_z, flux_r]

contains

    !> A body from its rows.
    subroutine take_conductors(body, n, base, rows, error)
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
    end subroutine take_conductors

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
            call raise(error, error_invalid, ": after a step only the flux through the contact area is available. Set time = "// &
                "0 or field = MDR_FLUX", "time")
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
        !> not considered after an error
        type(conduction_t), intent(in) :: conduction
        integer, intent(in) :: body

        if (allocated(error)) return
        if (size(conduction%bodies) == 1) then
            call check_code(error, "body", body, [body_lower])
        else
            call check_code(error, "body", body, [body_lower, body_upper])
        end if
    end subroutine check_body

end module mdrcontact_api_conduction
