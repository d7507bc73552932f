! SPDX-License-Identifier: GPL-3.0-or-later
!> Poroelastic gels, for C.
module mdrcontact_api_poroelastic
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_each_positive, check_results, deliver_parts, make_room
    use mdrcontact_api_handles, only: deliver
    use mdrcontact_api_poroelastic_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of
    use mdrcontact_error, only: check_choice, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_poroelastic_compliance, only: poroelastic_compliance
    use mdrcontact_poroelastic_response, only: poroelastic_dynamic_stiffness, poroelastic_pressure, poroelastic_response
    use mdrcontact_poroelastic_table, only: new_poroelastic, poroelastic_t
    implicit none (type, external)
    private
    public :: mdr_poroelastic_new, mdr_poroelastic_response, mdr_poroelastic_dynamic_stiffness, &
              mdr_poroelastic_pressure, mdr_poroelastic_compliance

contains

    function mdr_poroelastic_new(nu, drainage, ratio, deviation, out) result(status) &
        bind(C, name="mdrcontact_entry_poroelastic_new")
        real(c_double), value :: nu, ratio
        integer(c_int), value :: drainage
        real(c_double), intent(inout), optional :: deviation
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(poroelastic_t) :: table
        type(error_t), allocatable :: error

        if (.not. allocated(error)) call new_poroelastic(table, nu, int(drainage), ratio, error)
        status = deliver(table, out, error)
        if (present(deviation) .and. .not. allocated(error)) deviation = table%error
    end function mdr_poroelastic_new

    function mdr_poroelastic_response(p, answer, shear_modulus, diffusivity, radius, n, time, out) result(status) &
        bind(C, name="mdrcontact_entry_poroelastic_response")
        type(c_ptr), value :: p
        integer(c_int), value :: answer, n
        real(c_double), value :: shear_modulus, diffusivity, radius
        real(c_double), intent(in), optional :: time(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(poroelastic_t), pointer :: table
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", table, error)
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            call poroelastic_response(table, int(answer), shear_modulus, diffusivity, radius, time(:n), values, error)
            if (.not. allocated(error)) call check_results(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function mdr_poroelastic_response

    function mdr_poroelastic_dynamic_stiffness(p, shear_modulus, diffusivity, radius, n, omega, storage, loss) result(status) &
        bind(C, name="mdrcontact_entry_poroelastic_dynamic_stiffness")
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), value :: shear_modulus, diffusivity, radius
        real(c_double), intent(in), optional :: omega(*)
        real(c_double), intent(inout), optional :: storage(*), loss(*)
        integer(c_int) :: status
        type(poroelastic_t), pointer :: table
        complex(wp), allocatable :: values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", table, error)
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            call poroelastic_dynamic_stiffness(table, shear_modulus, diffusivity, radius, omega(:n), values, error)
        end if
        call deliver_parts(error, values, storage, loss)
        status = status_of(error)
    end function mdr_poroelastic_dynamic_stiffness

    function mdr_poroelastic_pressure(p, kind, is_flat, shear_modulus, diffusivity, radius, time, n, r, out) result(status) &
        bind(C, name="mdrcontact_entry_poroelastic_pressure")
        type(c_ptr), value :: p
        integer(c_int), value :: kind, is_flat, n
        real(c_double), value :: shear_modulus, diffusivity, radius, time
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(poroelastic_t), pointer :: table
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", table, error)
        call check_choice(error, "is_flat", int(is_flat), 0, 1, "0 (a paraboloid) or 1 (a flat punch)")
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            call poroelastic_pressure(table, int(kind), is_flat == 1, shear_modulus, diffusivity, radius, time, r(:n), values, &
                                      error)
            if (.not. allocated(error)) call check_results(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function mdr_poroelastic_pressure

    function mdr_poroelastic_compliance(nu, drainage, thickness, shear_modulus, diffusivity, omega, n, k, out, imaginary) &
        result(status) bind(C, name="mdrcontact_entry_poroelastic_compliance")
        real(c_double), value :: nu, thickness, shear_modulus, diffusivity, omega
        integer(c_int), value :: drainage, n
        real(c_double), intent(in), optional :: k(*)
        real(c_double), intent(inout), optional :: out(*), imaginary(*)
        integer(c_int) :: status
        complex(wp), allocatable :: values(:)
        real(c_double), allocatable :: wavenumbers(:)
        type(error_t), allocatable :: error

        if (.not. allocated(error) .and. n > 0) call check_each_positive(error, "k", k(:n))
        call make_room(error, n, values)
        call make_room(error, n, wavenumbers)
        if (.not. allocated(error)) then
            if (n > 0) wavenumbers(:) = k(:n)
            call poroelastic_compliance(nu, int(drainage), thickness, shear_modulus, diffusivity, omega, wavenumbers, values, error)
        end if
        call deliver_parts(error, values, out, imaginary)
        status = status_of(error)
    end function mdr_poroelastic_compliance

end module mdrcontact_api_poroelastic
