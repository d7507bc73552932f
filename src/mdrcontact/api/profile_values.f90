! SPDX-License-Identifier: GPL-3.0-or-later
!> Height, slope and MDR profile of an indenter at given radii, for C.
module mdrcontact_api_profile_values
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count, check_each_not_negative, check_each_within, &
                                     check_results_or_infinity
    use mdrcontact_api_handles, only: open_profile
    use mdrcontact_api_status, only: check_memory, status_of
    use mdrcontact_batch, only: check_threads
    use mdrcontact_error, only: error_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_profile_values, only: of_height, of_mdr, of_mdr_slope, of_slope, profile_values
    implicit none (type, external)
    private
    public :: mdr_profile_height, mdr_profile_slope, mdr_profile_mdr, mdr_profile_mdr_slope
    public :: mdr_profile_height_threads, mdr_profile_slope_threads, mdr_profile_mdr_threads, mdr_profile_mdr_slope_threads

contains

    function mdr_profile_height(p, n, r, out) result(status) bind(C)
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_values(p, of_height, n, "r", r, out, 1_c_int)
    end function mdr_profile_height

    function mdr_profile_slope(p, n, r, out) result(status) bind(C)
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_values(p, of_slope, n, "r", r, out, 1_c_int)
    end function mdr_profile_slope

    function mdr_profile_mdr(p, n, x, out) result(status) bind(C)
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_values(p, of_mdr, n, "x", x, out, 1_c_int)
    end function mdr_profile_mdr

    function mdr_profile_mdr_slope(p, n, x, out) result(status) bind(C)
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_values(p, of_mdr_slope, n, "x", x, out, 1_c_int)
    end function mdr_profile_mdr_slope

    function mdr_profile_height_threads(p, n, r, out, threads) result(status) bind(C)
        type(c_ptr), value :: p
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_values(p, of_height, n, "r", r, out, threads)
    end function mdr_profile_height_threads

    function mdr_profile_slope_threads(p, n, r, out, threads) result(status) bind(C)
        type(c_ptr), value :: p
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_values(p, of_slope, n, "r", r, out, threads)
    end function mdr_profile_slope_threads

    function mdr_profile_mdr_threads(p, n, x, out, threads) result(status) bind(C)
        type(c_ptr), value :: p
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_values(p, of_mdr, n, "x", x, out, threads)
    end function mdr_profile_mdr_threads

    function mdr_profile_mdr_slope_threads(p, n, x, out, threads) result(status) bind(C)
        type(c_ptr), value :: p
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_values(p, of_mdr_slope, n, "x", x, out, threads)
    end function mdr_profile_mdr_slope_threads

    function write_values(p, quantity, n, name, radii, out, threads) result(status)
        type(c_ptr), intent(in) :: p
        integer, intent(in) :: quantity
        integer(c_int), intent(in) :: n, threads
        character(len=*), intent(in) :: name
        real(c_double), intent(in), optional :: radii(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        class(profile_t), pointer :: profile
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error
        integer :: stat

        call open_profile(p, "p", profile, error)
        call check_count(error, n)
        call check_array(error, name, n, present(radii))
        call check_array(error, "out", n, present(out))
        call check_threads(error, int(threads))
        if (.not. allocated(error) .and. n > 0) then
            call check_each_not_negative(error, name, radii(:n))
            call check_each_within(error, name, radii(:n), 0.0_c_double, profile%largest_radius(), "the profile")
        end if
        if (.not. allocated(error) .and. n > 0) then
            allocate (values(n), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error) .and. n > 0) then
            call profile_values(profile, quantity, radii(:n), values, int(threads))
            call check_results_or_infinity(error, values)
        end if
        if (.not. allocated(error) .and. n > 0) out(:n) = values
        status = status_of(error)
    end function write_values

end module mdrcontact_api_profile_values
