! SPDX-License-Identifier: GPL-3.0-or-later
!> Media of the C API.
!> The manual is include/mdrcontact.h; this is its Fortran picture, for the wrappers only.
module mdrcontact_c_medium
    use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_ptr
    implicit none (type, external)
    private
    public :: mdr_medium_options_init, mdr_medium_homogeneous, mdr_medium_contact_modulus, mdr_medium_coated, &
              mdr_medium_layered, mdr_medium_graded, mdr_medium_graded_callback, mdr_medium_power_graded, &
              mdr_medium_table, mdr_medium_callback, mdr_medium_modulus, mdr_medium_stiffness, mdr_medium_free
    public :: medium_options_t

    !> struct mdr_medium_options
    type, bind(C) :: medium_options_t
        real(c_double) :: alpha
        real(c_double) :: wave_factor
        integer(c_int) :: weight_nu_choice
        real(c_double) :: weight_nu
        real(c_double) :: tolerance
    end type medium_options_t

    interface

        subroutine mdr_medium_options_init(options) bind(C)
            import :: medium_options_t
            implicit none (type, external)
            type(medium_options_t), intent(inout) :: options
        end subroutine mdr_medium_options_init

        function mdr_medium_homogeneous(E, nu, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            real(c_double), value :: E, nu
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_medium_homogeneous

        function mdr_medium_contact_modulus(contact_modulus, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            real(c_double), value :: contact_modulus
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_medium_contact_modulus

        function mdr_medium_coated(coating_E, coating_nu, thickness, substrate_E, substrate_nu, model, options, &
            out) result(status) bind(C)
            import :: c_double, c_int, c_ptr, medium_options_t
            implicit none (type, external)
            real(c_double), value :: coating_E, coating_nu, thickness, substrate_E, substrate_nu
            integer(c_int), value :: model
            type(medium_options_t), intent(in) :: options
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_medium_coated

        function mdr_medium_layered(n, E, nu, thickness, substrate_E, substrate_nu, model, options, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr, medium_options_t
            implicit none (type, external)
            integer(c_int), value :: n, model
            real(c_double), intent(in) :: E(*), nu(*), thickness(*)
            real(c_double), value :: substrate_E, substrate_nu
            type(medium_options_t), intent(in) :: options
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_medium_layered

        function mdr_medium_graded(n, z, E, nu, model, options, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr, medium_options_t
            implicit none (type, external)
            integer(c_int), value :: n, model
            real(c_double), intent(in) :: z(*), E(*), nu(*)
            type(medium_options_t), intent(in) :: options
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_medium_graded

        function mdr_medium_graded_callback(E, nu, context, depth, model, options, out) result(status) bind(C)
            import :: c_double, c_funptr, c_int, c_ptr, medium_options_t
            implicit none (type, external)
            type(c_funptr), value :: E, nu
            type(c_ptr), value :: context
            real(c_double), value :: depth
            integer(c_int), value :: model
            type(medium_options_t), intent(in) :: options
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_medium_graded_callback

        function mdr_medium_power_graded(E0, z0, exponent, nu, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            real(c_double), value :: E0, z0, exponent, nu
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_medium_power_graded

        function mdr_medium_table(n, a, modulus, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            integer(c_int), value :: n
            real(c_double), intent(in) :: a(*), modulus(*)
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_medium_table

        function mdr_medium_callback(modulus, context, smallest_radius, largest_radius, out) result(status) bind(C)
            import :: c_double, c_funptr, c_int, c_ptr
            implicit none (type, external)
            type(c_funptr), value :: modulus
            type(c_ptr), value :: context
            real(c_double), value :: smallest_radius, largest_radius
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_medium_callback

        function mdr_medium_modulus(m, n, a, values) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: m
            integer(c_int), value :: n
            real(c_double), intent(in) :: a(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_medium_modulus

        function mdr_medium_stiffness(m, n, a, values) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: m
            integer(c_int), value :: n
            real(c_double), intent(in) :: a(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_medium_stiffness

        function mdr_medium_free(m) result(status) bind(C)
            import :: c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), intent(inout) :: m
            integer(c_int) :: status
        end function mdr_medium_free

    end interface

end module mdrcontact_c_medium
