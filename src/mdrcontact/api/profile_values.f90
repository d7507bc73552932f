! SPDX-License-Identifier: GPL-3.0-or-later
!> Height, slope and MDR profile of an indenter at given radii, for C. Loops, since an array expression
!> of a type-bound function takes memory of the array's size without asking.
module mdrcontact_api_profile_values
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count, check_each_not_negative, check_each_within, &
                                     check_results_or_infinity
    use mdrcontact_api_handles, only: open_profile
    use mdrcontact_api_status, only: status_of
    use mdrcontact_error, only: error_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: mdr_profile_height, mdr_profile_slope, mdr_profile_mdr, mdr_profile_mdr_slope

contains

    function mdr_profile_height(p, n, r, out) result(status) bind(C)
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status, i
        class(profile_t), pointer :: profile
        type(error_t), allocatable :: error

        call prepare(p, n, "r", r, present(out), profile, error)
        if (.not. allocated(error)) then
            do i = 1, n
                call check_results_or_infinity(error, [profile%height(r(i))])
            end do
        end if
        if (.not. allocated(error)) then
            do i = 1, n
                out(i) = profile%height(r(i))
            end do
        end if
        status = status_of(error)
    end function mdr_profile_height

    function mdr_profile_slope(p, n, r, out) result(status) bind(C)
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status, i
        class(profile_t), pointer :: profile
        type(error_t), allocatable :: error

        call prepare(p, n, "r", r, present(out), profile, error)
        if (.not. allocated(error)) then
            do i = 1, n
                call check_results_or_infinity(error, [profile%slope(r(i))])
            end do
        end if
        if (.not. allocated(error)) then
            do i = 1, n
                out(i) = profile%slope(r(i))
            end do
        end if
        status = status_of(error)
    end function mdr_profile_slope

    function mdr_profile_mdr(p, n, x, out) result(status) bind(C)
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status, i
        class(profile_t), pointer :: profile
        type(error_t), allocatable :: error

        call prepare(p, n, "x", x, present(out), profile, error)
        if (.not. allocated(error)) then
            do i = 1, n
                call check_results_or_infinity(error, [profile%mdr(x(i))])
            end do
        end if
        if (.not. allocated(error)) then
            do i = 1, n
                out(i) = profile%mdr(x(i))
            end do
        end if
        status = status_of(error)
    end function mdr_profile_mdr

    function mdr_profile_mdr_slope(p, n, x, out) result(status) bind(C)
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status, i
        class(profile_t), pointer :: profile
        type(error_t), allocatable :: error

        call prepare(p, n, "x", x, present(out), profile, error)
        if (.not. allocated(error)) then
            do i = 1, n
                call check_results_or_infinity(error, [profile%mdr_slope(x(i))])
            end do
        end if
        if (.not. allocated(error)) then
            do i = 1, n
                out(i) = profile%mdr_slope(x(i))
            end do
        end if
        status = status_of(error)
    end function mdr_profile_mdr_slope

    subroutine prepare(p, n, name, radii, has_out, profile, error)
        type(c_ptr), intent(in) :: p
        integer(c_int), intent(in) :: n
        character(len=*), intent(in) :: name
        real(c_double), intent(in), optional :: radii(*)
        logical, intent(in) :: has_out
        class(profile_t), pointer, intent(out) :: profile
        type(error_t), allocatable, intent(out) :: error

        call open_profile(p, "p", profile, error)
        call check_count(error, n)
        call check_array(error, name, n, present(radii))
        call check_array(error, "out", n, has_out)
        if (allocated(error) .or. n == 0) return
        call check_each_not_negative(error, name, radii(:n))
        call check_each_within(error, name, radii(:n), 0.0_c_double, profile%largest_radius(), "the profile")
    end subroutine prepare

end module mdrcontact_api_profile_values
