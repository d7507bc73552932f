! SPDX-License-Identifier: GPL-3.0-or-later
!> Height, slope and MDR profile of an indenter at given radii, for C.
module mdrcontact_api_profile_values
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_each_not_negative, check_each_within, check_results_or_infinity, make_room
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_error, only: check_code, error_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_profile_values, only: of_height, of_mdr, of_mdr_slope, of_slope, profile_values
    implicit none (type, external)
    private
    public :: mdr_profile_values

contains

    function mdr_profile_values(p, quantity, n, x, out) result(status) bind(C, name="mdrcontact_entry_profile_values")
        type(c_ptr), value :: p
        integer(c_int), value :: quantity, n
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        class(profile_t), pointer :: profile
        character :: name
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", profile, error)
        call check_code(error, "quantity", int(quantity), [of_height, of_slope, of_mdr, of_mdr_slope])
        name = merge("r", "x", quantity < of_mdr)
        if (.not. allocated(error) .and. n > 0) then
            call check_each_not_negative(error, name, x(:n))
            call check_each_within(error, name, x(:n), 0.0_c_double, profile%largest_radius, "the profile")
        end if
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            call profile_values(profile, int(quantity), x(:n), values, wanted_threads())
            call check_results_or_infinity(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function mdr_profile_values

end module mdrcontact_api_profile_values
