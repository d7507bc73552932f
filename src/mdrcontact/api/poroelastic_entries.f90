! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of poroelastic that convert, call and deliver, for C. Written by tools/generate.py.
module mdrcontact_api_poroelastic_entries
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_each_finite, check_each_positive, check_results, make_room, return_parts
    use mdrcontact_api_handles, only: return_object
    use mdrcontact_api_poroelastic_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_error, only: check_choice, error_t
    use mdrcontact_poroelastic_compliance, only: poroelastic_compliance
    use mdrcontact_poroelastic_history, only: poroelastic_history
    use mdrcontact_poroelastic_response, only: poroelastic_dynamic_stiffness, poroelastic_pressure, poroelastic_response
    use mdrcontact_poroelastic_table, only: new_poroelastic, poroelastic_t
    implicit none (type, external)
    private
    public :: mdr_poroelastic_new
    public :: mdr_poroelastic_response
    public :: mdr_poroelastic_history
    public :: mdr_poroelastic_dynamic_stiffness
    public :: mdr_poroelastic_pressure
    public :: mdr_poroelastic_compliance

contains

    function mdr_poroelastic_new(nu, drainage, ratio, deviation, out) result(status) &
        bind(C, name="mdrcontact_entry_poroelastic_new")
        real(c_double), value :: nu, ratio
        integer(c_int), value :: drainage
        real(c_double), intent(inout), optional :: deviation
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(poroelastic_t), allocatable :: made
        class(*), allocatable :: object
        real(c_double) :: deviation_value
        type(error_t), allocatable :: error

        allocate (made)
        call new_poroelastic(made, nu, drainage, ratio, error, wanted_threads())
        deviation_value = 0.0_c_double
        if (.not. allocated(error)) deviation_value = made%error
        call move_alloc(made, object)
        status = return_object(object, out, error)
        if (allocated(error)) return
        if (present(deviation)) deviation = deviation_value
    end function mdr_poroelastic_new

    function mdr_poroelastic_response(p, answer, shear_modulus, diffusivity, radius, n, time, out) result(status) &
        bind(C, name="mdrcontact_entry_poroelastic_response")
        type(c_ptr), value :: p
        integer(c_int), value :: answer, n
        real(c_double), value :: shear_modulus, diffusivity, radius
        real(c_double), intent(in), optional :: time(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(poroelastic_t), pointer :: p_inside
        real(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", p_inside, error)
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) then
            call poroelastic_response(p_inside, answer, shear_modulus, diffusivity, radius, time(:n), out_values, error)
        end if
        if (.not. allocated(error)) call check_results(error, out_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_poroelastic_response

    function mdr_poroelastic_history(p, given, shear_modulus, diffusivity, radius, n, time, in, out) result(status) &
        bind(C, name="mdrcontact_entry_poroelastic_history")
        type(c_ptr), value :: p
        integer(c_int), value :: given, n
        real(c_double), value :: shear_modulus, diffusivity, radius
        real(c_double), intent(in), optional :: time(*), in(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(poroelastic_t), pointer :: p_inside
        real(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", p_inside, error)
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) then
            call poroelastic_history(p_inside, given, shear_modulus, diffusivity, radius, time(:n), in(:n), out_values, error)
        end if
        if (.not. allocated(error)) call check_results(error, out_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_poroelastic_history

    function mdr_poroelastic_dynamic_stiffness(p, shear_modulus, diffusivity, radius, n, omega, storage, loss) result(status) &
        bind(C, name="mdrcontact_entry_poroelastic_dynamic_stiffness")
        type(c_ptr), value :: p
        real(c_double), value :: shear_modulus, diffusivity, radius
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: omega(*)
        real(c_double), intent(inout), optional :: storage(*), loss(*)
        integer(c_int) :: status
        type(poroelastic_t), pointer :: p_inside
        complex(c_double), allocatable :: storage_values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", p_inside, error)
        call make_room(error, n, storage_values)
        if (.not. allocated(error) .and. n > 0) then
            call poroelastic_dynamic_stiffness(p_inside, shear_modulus, diffusivity, radius, omega(:n), storage_values, error)
        end if
        call return_parts(error, storage_values, storage, loss)
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
        type(poroelastic_t), pointer :: p_inside
        real(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", p_inside, error)
        if (.not. allocated(error)) call check_choice(error, "is_flat", is_flat, 0, 1, "0 (a paraboloid) or 1 (a flat punch)")
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) then
            call poroelastic_pressure(p_inside, kind, is_flat == 1, shear_modulus, diffusivity, radius, time, r(:n), out_values, &
                error)
        end if
        if (.not. allocated(error)) call check_results(error, out_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_poroelastic_pressure

    function mdr_poroelastic_compliance(nu, drainage, thickness, shear_modulus, diffusivity, n, k, omega, out, imaginary) result( &
        status) &
        bind(C, name="mdrcontact_entry_poroelastic_compliance")
        real(c_double), value :: nu, thickness, shear_modulus, diffusivity
        integer(c_int), value :: drainage, n
        real(c_double), intent(in), optional :: k(*), omega(*)
        real(c_double), intent(inout), optional :: out(*), imaginary(*)
        integer(c_int) :: status
        real(c_double), allocatable :: wavenumbers(:), frequencies(:)
        complex(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call make_room(error, n, wavenumbers)
        if (.not. allocated(error)) call make_room(error, n, frequencies)
        if (.not. allocated(error) .and. n > 0) wavenumbers(:) = k(:n)
        if (.not. allocated(error)) frequencies(:) = 0.0_c_double
        if (.not. allocated(error) .and. n > 0) then
            if (present(omega)) frequencies(:) = omega(:n)
        end if
        if (.not. allocated(error)) call check_each_positive(error, "k", wavenumbers)
        if (.not. allocated(error)) call check_each_finite(error, "omega", frequencies)
        call make_room(error, n, out_values)
        if (.not. allocated(error)) then
            call poroelastic_compliance(nu, drainage, thickness, shear_modulus, diffusivity, frequencies, wavenumbers, out_values, &
                error)
        end if
        call return_parts(error, out_values, out, imaginary)
        status = status_of(error)
    end function mdr_poroelastic_compliance

end module mdrcontact_api_poroelastic_entries
