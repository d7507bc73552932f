! SPDX-License-Identifier: GPL-3.0-or-later
!> Laterally heterogeneous structures of the C API.
!> The manual is include/mdrcontact.h; this is its Fortran picture, for the wrappers only.
module mdrcontact_c_lateral
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    implicit none (type, external)
    private
    public :: structure_options_t, mdr_structure_options_init, mdr_structure_shapes, mdr_structure_voxels, &
              mdr_structure_modulus_threads, mdr_structure_free, mdr_lateral_density_threads, mdr_lateral_cells, mdr_lateral_rule

    !> struct mdr_structure_options
    type, bind(C) :: structure_options_t
        real(c_double) :: reference_nu, tolerance
        integer(c_int) :: padded, images
        real(c_double) :: beside_e, beside_nu
        real(c_double) :: origin(2)
    end type structure_options_t

    interface
        subroutine mdr_structure_options_init(options) bind(C)
            import :: structure_options_t
            implicit none (type, external)
            type(structure_options_t), intent(inout) :: options
        end subroutine mdr_structure_options_init

        function mdr_structure_shapes(E, nu, n, kind, parameters, shape_E, shape_nu, options, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr, structure_options_t
            implicit none (type, external)
            real(c_double), value :: E, nu
            integer(c_int), value :: n
            integer(c_int), intent(in) :: kind(*)
            real(c_double), intent(in) :: parameters(7, *), shape_E(*), shape_nu(*)
            type(structure_options_t), intent(in) :: options
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_structure_shapes

        function mdr_structure_voxels(size, labels, phases, E, nu, spacing, below_E, below_nu, options, out) result(status) bind(C)
            import :: c_double, c_int, c_ptr, structure_options_t
            implicit none (type, external)
            integer(c_int), intent(in) :: size(3), labels(*)
            integer(c_int), value :: phases
            real(c_double), intent(in) :: E(*), nu(*), spacing(3)
            real(c_double), value :: below_E, below_nu
            type(structure_options_t), intent(in) :: options
            type(c_ptr), intent(inout) :: out
            integer(c_int) :: status
        end function mdr_structure_voxels

        function mdr_structure_modulus_threads(s, n, x, y, a, values, threads) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), value :: s
            integer(c_int), value :: n, threads
            real(c_double), intent(in) :: x(*), y(*), a(*)
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function mdr_structure_modulus_threads

        function mdr_structure_free(s) result(status) bind(C)
            import :: c_int, c_ptr
            implicit none (type, external)
            type(c_ptr), intent(inout) :: s
            integer(c_int) :: status
        end function mdr_structure_free

        function mdr_lateral_density_threads(n, rho, z, nu, shear, poisson, threads) result(status) bind(C)
            import :: c_double, c_int
            implicit none (type, external)
            integer(c_int), value :: n, threads
            real(c_double), intent(in) :: rho(*), z(*)
            real(c_double), value :: nu
            real(c_double), intent(inout) :: shear(*), poisson(*)
            integer(c_int) :: status
        end function mdr_lateral_density_threads

        function mdr_lateral_cells(nu, a, z_top, z_bottom, nx, x, ny, y, shear, poisson) result(status) bind(C)
            import :: c_double, c_int
            implicit none (type, external)
            real(c_double), value :: nu, a, z_top, z_bottom
            integer(c_int), value :: nx, ny
            real(c_double), intent(in) :: x(*), y(*)
            real(c_double), intent(inout) :: shear(*), poisson(*)
            integer(c_int) :: status
        end function mdr_lateral_cells

        function mdr_lateral_rule(order, nu, points, weights) result(status) bind(C)
            import :: c_double, c_int
            implicit none (type, external)
            integer(c_int), value :: order
            real(c_double), value :: nu
            real(c_double), intent(inout) :: points(3, *), weights(2, *)
            integer(c_int) :: status
        end function mdr_lateral_rule
    end interface

end module mdrcontact_c_lateral
