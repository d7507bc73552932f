! SPDX-License-Identifier: GPL-3.0-or-later
!> The weights of a depth, for C.
module mdrcontact_api_weights
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_arrays, only: check_each_not_negative, check_in_out
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_batch, only: run_map
    use mdrcontact_error, only: check_poisson, error_t
    use mdrcontact_weights, only: of_i0, of_i0_slope, of_i0_tangential, of_i1, of_j0, of_j0_tangential, of_j1, weight_map_t
    implicit none (type, external)
    private
    public :: mdr_weight_phi, mdr_weight_i0, mdr_weight_i1, mdr_weight_j0, mdr_weight_j1
    public :: mdr_weight_i0_tangential, mdr_weight_j0_tangential

contains

    function mdr_weight_phi(n, xi, nu, out) result(status) bind(C, name="mdrcontact_entry_weight_phi")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_i0_slope, n, xi, nu, out)
    end function mdr_weight_phi

    function mdr_weight_i0(n, xi, nu, out) result(status) bind(C, name="mdrcontact_entry_weight_i0")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_i0, n, xi, nu, out)
    end function mdr_weight_i0

    function mdr_weight_i1(n, xi, nu, out) result(status) bind(C, name="mdrcontact_entry_weight_i1")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_i1, n, xi, nu, out)
    end function mdr_weight_i1

    function mdr_weight_j0(n, xi, nu, out) result(status) bind(C, name="mdrcontact_entry_weight_j0")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_j0, n, xi, nu, out)
    end function mdr_weight_j0

    function mdr_weight_j1(n, xi, nu, out) result(status) bind(C, name="mdrcontact_entry_weight_j1")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_j1, n, xi, nu, out)
    end function mdr_weight_j1

    function mdr_weight_i0_tangential(n, xi, nu, out) result(status) bind(C, name="mdrcontact_entry_weight_i0_tangential")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_i0_tangential, n, xi, nu, out)
    end function mdr_weight_i0_tangential

    function mdr_weight_j0_tangential(n, xi, nu, out) result(status) bind(C, name="mdrcontact_entry_weight_j0_tangential")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_weights(of_j0_tangential, n, xi, nu, out)
    end function mdr_weight_j0_tangential

    function write_weights(weight, n, xi, nu, out) result(status)
        integer, intent(in) :: weight
        integer(c_int), intent(in) :: n
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), intent(in) :: nu
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(weight_map_t) :: map
        type(error_t), allocatable :: error

        call check_in_out(error, n, "xi", present(xi), present(out))
        call check_poisson(error, "nu", nu)
        if (.not. allocated(error) .and. n > 0) then
            call check_each_not_negative(error, "xi", xi(:n))
            map%weight = weight
            map%nu = nu
            if (.not. allocated(error)) call run_map(map, xi(:n), out(:n), wanted_threads())
        end if
        status = status_of(error)
    end function write_weights

end module mdrcontact_api_weights
