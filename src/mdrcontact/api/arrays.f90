! SPDX-License-Identifier: GPL-3.0-or-later
!> Checks of the arrays that cross the C boundary: every element, before anything is computed.
module mdrcontact_api_arrays
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
    use mdrcontact_api_status, only: check_given
    use mdrcontact_error, only: check_finite, check_not_negative, check_positive, error_domain, error_invalid, error_t, raise, &
                                to_text
    implicit none (type, external)
    private
    public :: check_count, check_array, check_each_finite, check_each_positive, check_each_not_negative, check_each_within, &
              element

contains

    !> Raises unless n >= 0.
    pure subroutine check_count(error, n)
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int), intent(in) :: n

        if (n < 0) call raise(error, error_invalid, "n = "//integer_text(n)//" is not allowed: a number of elements is at least 0")
    end subroutine check_count

    !> Raises unless the array is there or has no elements.
    pure subroutine check_array(error, name, n, is_given)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        integer(c_int), intent(in) :: n
        logical, intent(in) :: is_given

        if (n > 0) call check_given(error, name, is_given)
    end subroutine check_array

    !> Raises unless all values are finite.
    pure subroutine check_each_finite(error, name, values)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(c_double), intent(in) :: values(:)
        integer :: first

        first = findloc(ieee_is_finite(values), .false., dim=1)
        if (first > 0) call check_finite(error, element(name, first), values(first))
    end subroutine check_each_finite

    !> Raises unless all values are finite and greater than 0.
    pure subroutine check_each_positive(error, name, values)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(c_double), intent(in) :: values(:)
        integer :: first

        first = findloc(ieee_is_finite(values) .and. values > 0.0_c_double, .false., dim=1)
        if (first > 0) call check_positive(error, element(name, first), values(first))
    end subroutine check_each_positive

    !> Raises unless all values are finite and at least 0.
    pure subroutine check_each_not_negative(error, name, values)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(c_double), intent(in) :: values(:)
        integer :: first

        first = findloc(ieee_is_finite(values) .and. values >= 0.0_c_double, .false., dim=1)
        if (first > 0) call check_not_negative(error, element(name, first), values(first))
    end subroutine check_each_not_negative

    !> Raises unless smallest <= values <= largest, where `whose` is defined.
    pure subroutine check_each_within(error, name, values, smallest, largest, whose)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name, whose
        real(c_double), intent(in) :: values(:), smallest, largest
        integer :: first

        first = findloc(values >= smallest .and. values <= largest, .false., dim=1)
        if (first == 0) return
        if (values(first) < smallest) then
            call raise(error, error_domain, element(name, first)//" = "//to_text(values(first))//" is not allowed: "//whose// &
                       " is defined from "//to_text(smallest)//" on")
        else
            call raise(error, error_domain, element(name, first)//" = "//to_text(values(first))//" is not allowed: "//whose// &
                       " is defined up to "//to_text(largest))
        end if
    end subroutine check_each_within

    !> The C name of an element: r[0] is the first one.
    pure function element(name, position) result(text)
        character(len=*), intent(in) :: name
        integer, intent(in) :: position
        character(len=:), allocatable :: text

        text = name//"["//integer_text(position - 1)//"]"
    end function element

    pure function integer_text(number) result(text)
        integer, intent(in) :: number
        character(len=:), allocatable :: text
        character(len=12) :: buffer

        write (buffer, "(i0)") number
        text = trim(buffer)
    end function integer_text

end module mdrcontact_api_arrays
