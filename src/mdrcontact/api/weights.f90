! SPDX-License-Identifier: GPL-3.0-or-later
!> The weights of a depth, for C.
module mdrcontact_api_weights
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_arrays, only: check_each_not_negative
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_batch, only: run_map
    use mdrcontact_error, only: check_code, check_poisson, error_t
    use mdrcontact_weights, only: of_i0, of_i0_slope, of_i0_tangential, of_i1, of_j0, of_j0_tangential, of_j1, weight_map_t
    implicit none (type, external)
    private
    public :: mdr_weight

contains

    function mdr_weight(weight, nu, n, xi, out) result(status) bind(C, name="mdrcontact_entry_weight")
        integer(c_int), value :: weight, n
        real(c_double), value :: nu
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(weight_map_t) :: map
        type(error_t), allocatable :: error

        call check_code(error, "weight", int(weight), [of_i0_slope, of_i0, of_i1, of_j0, of_j1, of_i0_tangential, of_j0_tangential])
        call check_poisson(error, "nu", nu)
        if (.not. allocated(error) .and. n > 0) then
            call check_each_not_negative(error, "xi", xi(:n))
            map%weight = int(weight)
            map%nu = nu
            if (.not. allocated(error)) call run_map(map, xi(:n), out(:n), wanted_threads())
        end if
        status = status_of(error)
    end function mdr_weight

end module mdrcontact_api_weights
