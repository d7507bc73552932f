! SPDX-License-Identifier: GPL-3.0-or-later
!> Viscoelastic materials, for C.
module mdrcontact_api_material
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_results, return_parts, make_room
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of
    use mdrcontact_codes, only: of_complex_modulus => complex_modulus, of_creep => creep, of_relaxation => relaxation
    use mdrcontact_error, only: check_code, check_not_negative, check_positive, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_material_rheology, only: rheology_t
    implicit none (type, external)
    private
    public :: mdr_material_values

contains

    function mdr_material_values(m, quantity, n, x, out, imaginary) result(status) &
        bind(C, name="mdrcontact_entry_material_values")
        type(c_ptr), value :: m
        integer(c_int), value :: quantity, n
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*), imaginary(*)
        integer(c_int) :: status
        type(rheology_t), pointer :: material
        complex(wp), allocatable :: values(:)
        real(c_double), allocatable :: in_time(:)
        type(error_t), allocatable :: error
        integer :: i

        call open_handle(m, "m", material, error)
        call check_code(error, "quantity", int(quantity), [of_relaxation, of_creep, of_complex_modulus])
        do i = 1, n
            if (allocated(error)) exit
            if (quantity == of_complex_modulus) then
                call check_positive(error, "omega", x(i), i)
            else
                call check_not_negative(error, "t", x(i), i)
                if (quantity == of_creep .or. x(i) > 0.0_wp .or. material%has_glassy()) cycle
                call raise(error, error_invalid, " = 0.0: G(0) of a power law or with a parallel dashpot is infinite. Use t > 0", &
                           "t", i)
            end if
        end do
        if (quantity == of_complex_modulus) then
            call make_room(error, n, values)
            do i = 1, merge(n, 0_c_int, .not. allocated(error))
                values(i) = material%complex_shear(cmplx(0.0_wp, x(i), wp))
            end do
            call return_parts(error, values, out, imaginary)
        else
            call make_room(error, n, in_time)
            if (.not. allocated(error) .and. n > 0) then
                if (quantity == of_creep) then
                    in_time = material%creep(x(:n))
                else
                    in_time = material%relaxation(x(:n))
                end if
                call check_results(error, in_time)
                if (.not. allocated(error)) out(:n) = in_time
                if (present(imaginary) .and. .not. allocated(error)) imaginary(:n) = 0.0_c_double
            end if
        end if
        status = status_of(error)
    end function mdr_material_values

end module mdrcontact_api_material
