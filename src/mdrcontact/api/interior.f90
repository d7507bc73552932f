! SPDX-License-Identifier: GPL-3.0-or-later
!> Stresses and displacements inside the bodies of a contact, for C.
module mdrcontact_api_interior
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_results, check_results_or_infinity
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_codes, only: body_lower, body_upper, side_above, side_below
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_error, only: check_code, check_count_from, check_memory, error_t, raise_at
    use mdrcontact_inside, only: interior, interior_error, layer_energy
    use mdrcontact_inside_interior, only: components
    implicit none (type, external)
    private
    public :: mdr_load_interior, mdr_load_interior_error, mdr_load_layer_energies

contains

    function mdr_load_interior(load, body, side, friction, n, r, z, angle, out) result(status) &
        bind(C, name="mdrcontact_entry_load_interior")
        type(c_ptr), value :: load
        integer(c_int), value :: body, side, n
        real(c_double), value :: friction
        real(c_double), intent(in), optional :: r(*), z(*), angle(*)
        !> rows of struct mdr_interior
        real(c_double), intent(inout), optional :: out(components, *)
        integer(c_int) :: status
        type(contact_load_t), pointer :: pressed
        real(c_double), allocatable :: field(:, :), azimuth(:)
        type(error_t), allocatable :: error
        integer :: i, stat

        call open_handle(load, "load", pressed, error)
        call check_code(error, "body", int(body), [body_lower, body_upper])
        call check_code(error, "side", int(side), [side_below, side_above])
        if (.not. allocated(error)) then
            allocate (field(n, components), azimuth(n), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error) .and. n > 0) then
            azimuth(:) = 0.0_c_double
            if (present(angle)) azimuth(:) = angle(:n)
            call interior(pressed, body == body_upper, r(:n), z(:n), side == side_below, friction, azimuth, field, error, &
                          wanted_threads())
            do i = 1, n
                if (allocated(error)) exit
                call check_results_or_infinity(error, field(i, :))
                if (allocated(error)) call raise_at(error, i)
            end do
            do i = 1, merge(n, 0, .not. allocated(error))
                out(:, i) = field(i, :)
            end do
        end if
        status = status_of(error)
    end function mdr_load_interior

    function mdr_load_interior_error(load, body, deviation) result(status) &
        bind(C, name="mdrcontact_entry_load_interior_error")
        type(c_ptr), value :: load
        integer(c_int), value :: body
        real(c_double), intent(inout), optional :: deviation
        integer(c_int) :: status
        type(contact_load_t), pointer :: pressed
        real(c_double) :: found
        type(error_t), allocatable :: error

        call open_handle(load, "load", pressed, error)
        call check_code(error, "body", int(body), [body_lower, body_upper])
        if (.not. allocated(error)) call interior_error(pressed, body == body_upper, found, error)
        if (.not. allocated(error)) call check_results(error, [found])
        status = status_of(error)
        if (.not. allocated(error)) deviation = found
    end function mdr_load_interior_error

    function mdr_load_layer_energies(load, body, capacity, out, count) result(status) &
        bind(C, name="mdrcontact_entry_load_layer_energies")
        type(c_ptr), value :: load
        integer(c_int), value :: body, capacity
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int), intent(inout), optional :: count
        integer(c_int) :: status
        type(contact_load_t), pointer :: pressed
        real(c_double), allocatable :: energies(:)
        type(error_t), allocatable :: error
        integer :: n

        call open_handle(load, "load", pressed, error)
        call check_code(error, "body", int(body), [body_lower, body_upper])
        call check_count_from(error, "capacity", int(capacity), 0)
        if (.not. allocated(error)) call layer_energy(pressed, body == body_upper, energies, error)
        status = status_of(error)
        if (allocated(error)) return
        count = size(energies, kind=c_int)
        n = min(size(energies), int(capacity))
        if (present(out)) out(:n) = energies(:n)
    end function mdr_load_layer_energies

end module mdrcontact_api_interior
