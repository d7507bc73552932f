! SPDX-License-Identifier: GPL-3.0-or-later
!> The weights of a depth, for C.
module mdrcontact_api_weights
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_arrays, only: check_array, check_count, check_each_not_negative
    use mdrcontact_api_status, only: status_of
    use mdrcontact_batch, only: check_threads, run_map
    use mdrcontact_error, only: check_poisson, error_t
    use mdrcontact_weights, only: of_i0, of_i0_slope, of_i1, of_j0, of_j1, weight_map_t
    implicit none (type, external)
    private
    public :: mdr_weight_phi, mdr_weight_i0, mdr_weight_i1, mdr_weight_j0, mdr_weight_j1
    public :: mdr_weight_phi_threads, mdr_weight_i0_threads, mdr_weight_i1_threads, mdr_weight_j0_threads, &
              mdr_weight_j1_threads

contains

    function mdr_weight_phi(n, xi, nu, out) result(status) bind(C)
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_i0_slope, n, xi, nu, out, 1_c_int)
    end function mdr_weight_phi

    function mdr_weight_i0(n, xi, nu, out) result(status) bind(C)
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_i0, n, xi, nu, out, 1_c_int)
    end function mdr_weight_i0

    function mdr_weight_i1(n, xi, nu, out) result(status) bind(C)
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_i1, n, xi, nu, out, 1_c_int)
    end function mdr_weight_i1

    function mdr_weight_j0(n, xi, nu, out) result(status) bind(C)
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_j0, n, xi, nu, out, 1_c_int)
    end function mdr_weight_j0

    function mdr_weight_j1(n, xi, nu, out) result(status) bind(C)
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_j1, n, xi, nu, out, 1_c_int)
    end function mdr_weight_j1

    function mdr_weight_phi_threads(n, xi, nu, out, threads) result(status) bind(C)
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_i0_slope, n, xi, nu, out, threads)
    end function mdr_weight_phi_threads

    function mdr_weight_i0_threads(n, xi, nu, out, threads) result(status) bind(C)
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_i0, n, xi, nu, out, threads)
    end function mdr_weight_i0_threads

    function mdr_weight_i1_threads(n, xi, nu, out, threads) result(status) bind(C)
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_i1, n, xi, nu, out, threads)
    end function mdr_weight_i1_threads

    function mdr_weight_j0_threads(n, xi, nu, out, threads) result(status) bind(C)
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_j0, n, xi, nu, out, threads)
    end function mdr_weight_j0_threads

    function mdr_weight_j1_threads(n, xi, nu, out, threads) result(status) bind(C)
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_j1, n, xi, nu, out, threads)
    end function mdr_weight_j1_threads

    function write_weights(weight, n, xi, nu, out, threads) result(status)
        integer, intent(in) :: weight
        integer(c_int), intent(in) :: n, threads
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), intent(in) :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(weight_map_t) :: map
        type(error_t), allocatable :: error

        call check_count(error, n)
        call check_array(error, "xi", n, present(xi))
        call check_array(error, "out", n, present(out))
        call check_poisson(error, "nu", nu)
        call check_threads(error, int(threads))
        if (.not. allocated(error) .and. n > 0) then
            call check_each_not_negative(error, "xi", xi(:n))
            map%weight = weight
            map%nu = nu
            if (.not. allocated(error)) call run_map(map, xi(:n), out(:n), int(threads))
        end if
        status = status_of(error)
    end function write_weights

end module mdrcontact_api_weights
