! SPDX-License-Identifier: GPL-3.0-or-later
!> Profiles of the C API.
!> The manual is include/mdrcontact.h; this is its Fortran picture, for the wrappers only.
module mdrcontact_c_profile
    use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_ptr
    implicit none (type, external)
    private
    public :: mdr_profile_paraboloid, mdr_profile_sphere, mdr_profile_cone, mdr_profile_power, &
              mdr_profile_flat_punch, mdr_profile_flat_cone, mdr_profile_flat_paraboloid, &
              mdr_profile_rounded_cone, mdr_profile_area_function, mdr_profile_table, mdr_profile_from_mdr_table, &
              mdr_profile_callback, mdr_profile_sum, mdr_profile_height, mdr_profile_slope, mdr_profile_mdr, &
              mdr_profile_mdr_slope, mdr_profile_free

    interface

        function mdr_profile_paraboloid(radius, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            real(c_double), value :: radius
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_profile_paraboloid

        function mdr_profile_sphere(radius, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            real(c_double), value :: radius
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_profile_sphere

        function mdr_profile_cone(inclination, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            real(c_double), value :: inclination
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_profile_cone

        function mdr_profile_power(exponent, coefficient, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            real(c_double), value :: exponent, coefficient
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_profile_power

        function mdr_profile_flat_punch(radius, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            real(c_double), value :: radius
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_profile_flat_punch

        function mdr_profile_flat_cone(end_radius, inclination, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            real(c_double), value :: end_radius, inclination
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_profile_flat_cone

        function mdr_profile_flat_paraboloid(end_radius, radius, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            real(c_double), value :: end_radius, radius
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_profile_flat_paraboloid

        function mdr_profile_rounded_cone(blend_radius, inclination, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            real(c_double), value :: blend_radius, inclination
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_profile_rounded_cone

        function mdr_profile_area_function(n, coefficients, min_height, max_height, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            integer(c_int), value :: n
            real(c_double), intent(in) :: coefficients(*)
            real(c_double), value :: min_height, max_height
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_profile_area_function

        function mdr_profile_table(n, r, f, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            integer(c_int), value :: n
            real(c_double), intent(in) :: r(*), f(*)
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_profile_table

        function mdr_profile_from_mdr_table(n, x, g, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            integer(c_int), value :: n
            real(c_double), intent(in) :: x(*), g(*)
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_profile_from_mdr_table

        function mdr_profile_callback(height, context, largest_radius, out) result(status) bind(C)
            import :: c_double, c_funptr, c_int, c_ptr
            implicit none (type, external)
            type(c_funptr), value :: height
            type(c_ptr), value :: context
            real(c_double), value :: largest_radius
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_profile_callback

        function mdr_profile_sum(n, terms, out) result(status) bind(C)
            import :: c_int, c_ptr
            implicit none (type, external)
            integer(c_int), value :: n
            type(c_ptr), intent(in) :: terms(*)
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_profile_sum

        function mdr_profile_height(p, n, x, values) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: p
            integer(c_int), value :: n
            real(c_double), intent(in) :: x(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_profile_height

        function mdr_profile_slope(p, n, x, values) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: p
            integer(c_int), value :: n
            real(c_double), intent(in) :: x(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_profile_slope

        function mdr_profile_mdr(p, n, x, values) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: p
            integer(c_int), value :: n
            real(c_double), intent(in) :: x(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_profile_mdr

        function mdr_profile_mdr_slope(p, n, x, values) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: p
            integer(c_int), value :: n
            real(c_double), intent(in) :: x(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_profile_mdr_slope

        function mdr_profile_free(p) result(status) bind(C)
            import :: c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), intent(inout) :: p
            integer(c_int) :: status
        end function mdr_profile_free

    end interface

end module mdrcontact_c_profile
