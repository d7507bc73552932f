! SPDX-License-Identifier: GPL-3.0-or-later
! Weights of laterally heterogeneous structures, flat for f2py.

!> See mdr_lateral_density.
subroutine lateral_density(n, threads, rho, z, nu, shear, poisson, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_c_lateral, only: mdr_lateral_density_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    real(c_double), intent(in) :: rho(n), z(n), nu
    real(c_double), intent(out) :: shear(n), poisson(n)
    integer(c_int), intent(out) :: status

    status = mdr_lateral_density_threads(n, rho, z, nu, shear, poisson, threads)
end subroutine lateral_density

!> See mdr_lateral_cells.
subroutine lateral_cells(nu, a, z_top, z_bottom, nx, x, ny, y, shear, poisson, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_c_lateral, only: mdr_lateral_cells
    implicit none (type, external)
    !f2py threadsafe
    real(c_double), intent(in) :: nu, a, z_top, z_bottom
    integer(c_int), intent(in) :: nx, ny
    real(c_double), intent(in) :: x(nx + 1), y(ny + 1)
    real(c_double), intent(out) :: shear(nx, ny), poisson(nx, ny)
    integer(c_int), intent(out) :: status

    status = mdr_lateral_cells(nu, a, z_top, z_bottom, nx, x, ny, y, shear, poisson)
end subroutine lateral_cells

!> See mdr_lateral_rule; n = 6 order^3.
subroutine lateral_rule(order, nu, n, points, weights, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_c_lateral, only: mdr_lateral_rule
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: order, n
    real(c_double), intent(in) :: nu
    real(c_double), intent(out) :: points(3, n), weights(2, n)
    integer(c_int), intent(out) :: status

    status = mdr_lateral_rule(order, nu, points, weights)
end subroutine lateral_rule
