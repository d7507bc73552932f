! SPDX-License-Identifier: GPL-3.0-or-later
!> The weights of a depth, for C.
module mdrcontact_api_weights
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_arrays, only: check_array, check_count, check_each_not_negative
    use mdrcontact_api_status, only: status_of
    use mdrcontact_error, only: check_poisson, error_t
    use mdrcontact_weights, only: weight_i0, weight_i0_slope, weight_i1, weight_j0, weight_j1
    implicit none (type, external)
    private
    public :: mdr_weight_phi, mdr_weight_i0, mdr_weight_i1, mdr_weight_j0, mdr_weight_j1

contains

    function mdr_weight_phi(n, xi, nu, out) result(status) bind(C)
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(error_t), allocatable :: error

        call check(error, n, xi, nu, present(out))
        if (.not. allocated(error) .and. n > 0) out(:n) = weight_i0_slope(xi(:n), nu)
        status = status_of(error)
    end function mdr_weight_phi

    function mdr_weight_i0(n, xi, nu, out) result(status) bind(C)
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(error_t), allocatable :: error

        call check(error, n, xi, nu, present(out))
        if (.not. allocated(error) .and. n > 0) out(:n) = weight_i0(xi(:n), nu)
        status = status_of(error)
    end function mdr_weight_i0

    function mdr_weight_i1(n, xi, nu, out) result(status) bind(C)
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(error_t), allocatable :: error

        call check(error, n, xi, nu, present(out))
        if (.not. allocated(error) .and. n > 0) out(:n) = weight_i1(xi(:n))
        status = status_of(error)
    end function mdr_weight_i1

    function mdr_weight_j0(n, xi, nu, out) result(status) bind(C)
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(error_t), allocatable :: error

        call check(error, n, xi, nu, present(out))
        if (.not. allocated(error) .and. n > 0) out(:n) = weight_j0(xi(:n), nu)
        status = status_of(error)
    end function mdr_weight_j0

    function mdr_weight_j1(n, xi, nu, out) result(status) bind(C)
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(error_t), allocatable :: error

        call check(error, n, xi, nu, present(out))
        if (.not. allocated(error) .and. n > 0) out(:n) = weight_j1(xi(:n))
        status = status_of(error)
    end function mdr_weight_j1

    subroutine check(error, n, xi, nu, has_out)
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int), intent(in) :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), intent(in) :: nu
        logical, intent(in) :: has_out

        call check_count(error, n)
        call check_array(error, "xi", n, present(xi))
        call check_array(error, "out", n, has_out)
        call check_poisson(error, "nu", nu)
        if (allocated(error) .or. n == 0) return
        call check_each_not_negative(error, "xi", xi(:n))
    end subroutine check

end module mdrcontact_api_weights
