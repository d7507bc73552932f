! SPDX-License-Identifier: GPL-3.0-or-later
!> What surfaces answer to a wave of load, for C.
module mdrcontact_api_compliance
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count, check_each_not_negative, check_each_positive, deliver_parts, &
                                     make_room
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of
    use mdrcontact_body_compliance, only: normal_load, shear_load, twist_load
    use mdrcontact_error, only: check_code, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium, only: medium_t
    use mdrcontact_medium_compliance, only: surface_compliance
    implicit none (type, external)
    private
    public :: mdr_medium_compliance

contains

    function mdr_medium_compliance(m, load, omega, n, k, out, imaginary) result(status) &
        bind(C, name="mdrcontact_entry_medium_compliance")
        type(c_ptr), value :: m
        integer(c_int), value :: load, n
        real(c_double), value :: omega
        real(c_double), intent(in), optional :: k(*)
        real(c_double), intent(inout), optional :: out(*), imaginary(*)
        integer(c_int) :: status
        type(medium_t), pointer :: medium
        complex(wp), allocatable :: values(:)
        real(c_double), allocatable :: wavenumbers(:)
        type(error_t), allocatable :: error

        call open_handle(m, "m", medium, error)
        if (.not. allocated(error)) then
            call check_code(error, "load", int(load), [normal_load, shear_load, twist_load])
        end if
        if (.not. allocated(error)) call check_each_not_negative(error, "omega", [omega])
        call check_count(error, n)
        call check_array(error, "k", n, present(k))
        call check_array(error, "out", n, present(out))
        if (.not. allocated(error) .and. n > 0) call check_each_positive(error, "k", k(:n))
        call make_room(error, n, values)
        call make_room(error, n, wavenumbers)
        if (.not. allocated(error)) then
            ! without points k may be NULL
            if (n > 0) wavenumbers(:) = k(:n)
            if (allocated(medium%relaxing)) then
                call surface_compliance(medium%relaxing, load, omega, wavenumbers, values, error)
            else
                call surface_compliance(medium%solver, load, wavenumbers, values, error)
            end if
        end if
        call deliver_parts(error, values, out, imaginary)
        status = status_of(error)
    end function mdr_medium_compliance

end module mdrcontact_api_compliance
