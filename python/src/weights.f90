! SPDX-License-Identifier: GPL-3.0-or-later
! Weights, flat for f2py.

!> See mdr_weight_phi.
subroutine weight_phi(n, threads, nu, xi, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_weights, only: mdr_weight_phi_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    real(c_double), intent(in) :: nu
    real(c_double), intent(in) :: xi(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_weight_phi_threads(n, xi, nu, values, threads)
end subroutine weight_phi

!> See mdr_weight_i0.
subroutine weight_i0(n, threads, nu, xi, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_weights, only: mdr_weight_i0_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    real(c_double), intent(in) :: nu
    real(c_double), intent(in) :: xi(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_weight_i0_threads(n, xi, nu, values, threads)
end subroutine weight_i0

!> See mdr_weight_i1.
subroutine weight_i1(n, threads, nu, xi, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_weights, only: mdr_weight_i1_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    real(c_double), intent(in) :: nu
    real(c_double), intent(in) :: xi(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_weight_i1_threads(n, xi, nu, values, threads)
end subroutine weight_i1

!> See mdr_weight_j0.
subroutine weight_j0(n, threads, nu, xi, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_weights, only: mdr_weight_j0_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    real(c_double), intent(in) :: nu
    real(c_double), intent(in) :: xi(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_weight_j0_threads(n, xi, nu, values, threads)
end subroutine weight_j0

!> See mdr_weight_j1.
subroutine weight_j1(n, threads, nu, xi, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_weights, only: mdr_weight_j1_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    real(c_double), intent(in) :: nu
    real(c_double), intent(in) :: xi(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_weight_j1_threads(n, xi, nu, values, threads)
end subroutine weight_j1
