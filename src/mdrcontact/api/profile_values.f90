! SPDX-License-Identifier: GPL-3.0-or-later
!> Height, slope and MDR profile of an indenter at given radii, for C.
module mdrcontact_api_profile_values
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_each_not_negative, check_each_within, check_in_out, check_results_or_infinity, &
                                     make_room
    use mdrcontact_api_handles, only: open_handle
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_error, only: error_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_profile_values, only: of_height, of_mdr, of_mdr_slope, of_slope, profile_values
    implicit none (type, external)
    private
    public :: mdr_profile_height, mdr_profile_slope, mdr_profile_mdr, mdr_profile_mdr_slope

contains

    function mdr_profile_height(p, n, r, out) result(status) bind(C, name="mdrcontact_entry_profile_height")
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_values(p, of_height, n, "r", r, out)
    end function mdr_profile_height

    function mdr_profile_slope(p, n, r, out) result(status) bind(C, name="mdrcontact_entry_profile_slope")
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_values(p, of_slope, n, "r", r, out)
    end function mdr_profile_slope

    function mdr_profile_mdr(p, n, x, out) result(status) bind(C, name="mdrcontact_entry_profile_mdr")
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_values(p, of_mdr, n, "x", x, out)
    end function mdr_profile_mdr

    function mdr_profile_mdr_slope(p, n, x, out) result(status) bind(C, name="mdrcontact_entry_profile_mdr_slope")
        type(c_ptr), value :: p
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_values(p, of_mdr_slope, n, "x", x, out)
    end function mdr_profile_mdr_slope

    function write_values(p, quantity, n, name, radii, out) result(status)
        type(c_ptr), intent(in) :: p
        integer, intent(in) :: quantity
        integer(c_int), intent(in) :: n
        character(len=*), intent(in) :: name
        real(c_double), intent(in), optional :: radii(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        class(profile_t), pointer :: profile
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", profile, error)
        call check_in_out(error, n, name, present(radii), present(out))
        if (.not. allocated(error) .and. n > 0) then
            call check_each_not_negative(error, name, radii(:n))
            call check_each_within(error, name, radii(:n), 0.0_c_double, profile%largest_radius, "the profile")
        end if
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            call profile_values(profile, quantity, radii(:n), values, wanted_threads())
            call check_results_or_infinity(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function write_values

end module mdrcontact_api_profile_values
