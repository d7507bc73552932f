! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts of the C API.
!> The manual is include/mdrcontact.h; this is its Fortran picture, for the wrappers only.
module mdrcontact_c_contact
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    implicit none (type, external)
    private
    public :: mdr_contact_options_init, mdr_contact_new, mdr_contact_from_depth, mdr_contact_from_force, &
              mdr_contact_from_radius, mdr_contact_pressure, mdr_contact_displacement, mdr_contact_line_load, &
              mdr_contact_pressure_at_depth, mdr_contact_displacement_at_depth, mdr_contact_line_load_at_depth, &
              mdr_contact_free
    public :: contact_options_t

    !> struct mdr_contact_options
    type, bind(C) :: contact_options_t
        integer(c_int) :: zeta_count
        type(c_ptr) :: zeta_radius
        type(c_ptr) :: zeta
    end type contact_options_t

    interface

        subroutine mdr_contact_options_init(options) bind(C)
            import :: contact_options_t
            implicit none (type, external)
            type(contact_options_t), intent(inout) :: options
        end subroutine mdr_contact_options_init

        function mdr_contact_new(profile, medium, options, out) result(status) bind(C)
            import :: c_int, c_ptr, contact_options_t
            implicit none (type, external)
            type(c_ptr), value :: profile, medium
            type(contact_options_t), intent(in) :: options
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_contact_new

        function mdr_contact_from_depth(c, n, given, d, a, F, k) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: c
            integer(c_int), value :: n
            real(c_double), intent(in) :: given(*)
            real(c_double), intent(inout) :: d(*), a(*), F(*), k(*)
            integer(c_int) :: status
        end function mdr_contact_from_depth

        function mdr_contact_from_force(c, n, given, d, a, F, k) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: c
            integer(c_int), value :: n
            real(c_double), intent(in) :: given(*)
            real(c_double), intent(inout) :: d(*), a(*), F(*), k(*)
            integer(c_int) :: status
        end function mdr_contact_from_force

        function mdr_contact_from_radius(c, n, given, d, a, F, k) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: c
            integer(c_int), value :: n
            real(c_double), intent(in) :: given(*)
            real(c_double), intent(inout) :: d(*), a(*), F(*), k(*)
            integer(c_int) :: status
        end function mdr_contact_from_radius

        function mdr_contact_pressure(c, a, n, r, values) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: c
            real(c_double), value :: a
            integer(c_int), value :: n
            real(c_double), intent(in) :: r(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_contact_pressure

        function mdr_contact_displacement(c, a, n, r, values) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: c
            real(c_double), value :: a
            integer(c_int), value :: n
            real(c_double), intent(in) :: r(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_contact_displacement

        function mdr_contact_line_load(c, a, n, r, values) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: c
            real(c_double), value :: a
            integer(c_int), value :: n
            real(c_double), intent(in) :: r(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_contact_line_load

        function mdr_contact_pressure_at_depth(c, d, n, r, values) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: c
            real(c_double), value :: d
            integer(c_int), value :: n
            real(c_double), intent(in) :: r(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_contact_pressure_at_depth

        function mdr_contact_displacement_at_depth(c, d, n, r, values) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: c
            real(c_double), value :: d
            integer(c_int), value :: n
            real(c_double), intent(in) :: r(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_contact_displacement_at_depth

        function mdr_contact_line_load_at_depth(c, d, n, r, values) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: c
            real(c_double), value :: d
            integer(c_int), value :: n
            real(c_double), intent(in) :: r(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_contact_line_load_at_depth

        function mdr_contact_free(c) result(status) bind(C)
            import :: c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), intent(inout) :: c
            integer(c_int) :: status
        end function mdr_contact_free

    end interface

end module mdrcontact_c_contact
