! SPDX-License-Identifier: GPL-3.0-or-later
!> Weights of the C API.
!> The manual is include/mdrcontact.h; this is its Fortran picture, for the wrappers only.
module mdrcontact_c_weights
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    implicit none (type, external)
    private
    public :: mdr_weight_phi, mdr_weight_i0, mdr_weight_i1, mdr_weight_j0, mdr_weight_j1

    interface

        function mdr_weight_phi(n, xi, nu, values) result(status) bind(C)
            import :: c_double, c_int
            implicit none (type, external)
            integer(c_int), value :: n
            real(c_double), intent(in) :: xi(*)
            real(c_double), value :: nu
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_weight_phi

        function mdr_weight_i0(n, xi, nu, values) result(status) bind(C)
            import :: c_double, c_int
            implicit none (type, external)
            integer(c_int), value :: n
            real(c_double), intent(in) :: xi(*)
            real(c_double), value :: nu
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_weight_i0

        function mdr_weight_i1(n, xi, nu, values) result(status) bind(C)
            import :: c_double, c_int
            implicit none (type, external)
            integer(c_int), value :: n
            real(c_double), intent(in) :: xi(*)
            real(c_double), value :: nu
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_weight_i1

        function mdr_weight_j0(n, xi, nu, values) result(status) bind(C)
            import :: c_double, c_int
            implicit none (type, external)
            integer(c_int), value :: n
            real(c_double), intent(in) :: xi(*)
            real(c_double), value :: nu
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_weight_j0

        function mdr_weight_j1(n, xi, nu, values) result(status) bind(C)
            import :: c_double, c_int
            implicit none (type, external)
            integer(c_int), value :: n
            real(c_double), intent(in) :: xi(*)
            real(c_double), value :: nu
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_weight_j1

    end interface

end module mdrcontact_c_weights
