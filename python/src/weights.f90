! SPDX-License-Identifier: GPL-3.0-or-later
! Weights, flat for f2py.

!> See mdr_weight_phi.
subroutine weight_phi(n, nu, xi, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_weights, only: mdr_weight_phi
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: nu
    real(c_double), intent(in) :: xi(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_weight_phi(n, xi, nu, values)
end subroutine weight_phi

!> See mdr_weight_i0.
subroutine weight_i0(n, nu, xi, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_weights, only: mdr_weight_i0
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: nu
    real(c_double), intent(in) :: xi(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_weight_i0(n, xi, nu, values)
end subroutine weight_i0

!> See mdr_weight_i1.
subroutine weight_i1(n, nu, xi, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_weights, only: mdr_weight_i1
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: nu
    real(c_double), intent(in) :: xi(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_weight_i1(n, xi, nu, values)
end subroutine weight_i1

!> See mdr_weight_j0.
subroutine weight_j0(n, nu, xi, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_weights, only: mdr_weight_j0
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: nu
    real(c_double), intent(in) :: xi(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_weight_j0(n, xi, nu, values)
end subroutine weight_j0

!> See mdr_weight_j1.
subroutine weight_j1(n, nu, xi, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_weights, only: mdr_weight_j1
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: nu
    real(c_double), intent(in) :: xi(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_weight_j1(n, xi, nu, values)
end subroutine weight_j1
