! SPDX-License-Identifier: GPL-3.0-or-later
!> Checks of the arrays that cross the C boundary: every element, before anything is computed. Loops and not array
!> expressions: a check must not need memory of the array's size, which a temporary would take without a status.
module mdrcontact_api_arrays
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
    use mdrcontact_api_status, only: check_given
    use mdrcontact_error, only: check_count_from, check_finite, check_memory, check_not_negative, check_positive, count_text, &
                                error_domain, error_invalid, error_no_convergence, error_t, raise, to_text
    implicit none (type, external)
    private
    public :: check_count, check_array, check_not_empty, check_each_finite, check_each_positive, &
              check_each_not_negative, check_each_within
    public :: make_room, return_parts, check_results, check_results_or_infinity, check_positive_results

    !> refuse.h: 2^31 less as many entries as any loop takes at a time.
    integer(c_int), parameter :: most_entries = 2147418112_c_int

    !> Room for n results, unless there is an error: they are written to the array of the caller when all of them are known.
    interface make_room
        module procedure :: make_real_room, make_complex_room
    end interface make_room

contains

    !> Raises unless n >= 0, and loops over n entries end within the range of integers.
    pure subroutine check_count(error, n)
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int), intent(in) :: n

        if (n < 0) call check_count_from(error, "n", int(n), 0)
        if (n > most_entries) call raise(error, error_invalid, " = "//count_text(int(n))//": it must be at most "// &
                                         count_text(int(most_entries))//". Divide the arrays", "n")
    end subroutine check_count

    !> Raises unless the array is there or has no elements.
    pure subroutine check_array(error, name, n, is_given)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        integer(c_int), intent(in) :: n
        logical, intent(in) :: is_given

        if (n > 0) call check_given(error, name, is_given)
    end subroutine check_array

    !> Raises for an empty table: the array may then be missing, and a section of what is missing must not be passed on.
    pure subroutine check_not_empty(error, name, n, fewest)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        integer(c_int), intent(in) :: n
        integer, intent(in) :: fewest

        if (n == 0) call raise(error, error_invalid, "a table of 0 entries in "//name//" is too short. Give at least "// &
                               count_text(fewest))
    end subroutine check_not_empty

    !> Raises unless all values are finite.
    pure subroutine check_each_finite(error, name, values)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(c_double), intent(in) :: values(:)
        integer :: i

        do i = 1, size(values)
            if (ieee_is_finite(values(i))) cycle
            call check_finite(error, name, values(i), i)
            return
        end do
    end subroutine check_each_finite

    !> Raises unless all values are finite and greater than 0.
    pure subroutine check_each_positive(error, name, values)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(c_double), intent(in) :: values(:)
        integer :: i

        do i = 1, size(values)
            if (ieee_is_finite(values(i)) .and. values(i) > 0.0_c_double) cycle
            call check_positive(error, name, values(i), i)
            return
        end do
    end subroutine check_each_positive

    !> Raises unless all values are finite and at least 0.
    pure subroutine check_each_not_negative(error, name, values)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(c_double), intent(in) :: values(:)
        integer :: i

        do i = 1, size(values)
            if (ieee_is_finite(values(i)) .and. values(i) >= 0.0_c_double) cycle
            call check_not_negative(error, name, values(i), i)
            return
        end do
    end subroutine check_each_not_negative

    !> Raises unless smallest <= values <= largest, where `whose` is defined.
    pure subroutine check_each_within(error, name, values, smallest, largest, whose, reason)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name, whose
        real(c_double), intent(in) :: values(:), smallest, largest
        !> text if a value is too large
        character(len=*), intent(in), optional :: reason
        character(len=:), allocatable :: end_words
        integer :: i

        end_words = ""
        if (present(reason)) end_words = reason
        do i = 1, size(values)
            if (values(i) < smallest) then
                call raise(error, error_domain, " = "//to_text(values(i))//": "//whose//" is defined from "//to_text(smallest)// &
                           " on", name, i)
                return
            else if (values(i) > largest) then
                call raise(error, error_domain, " = "//to_text(values(i))//": "//whose//" is defined up to "//to_text(largest)// &
                           end_words, name, i)
                return
            end if
        end do
    end subroutine check_each_within

    pure subroutine make_real_room(error, n, values)
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int), intent(in) :: n
        real(c_double), allocatable, intent(out) :: values(:)
        integer :: stat

        if (allocated(error)) return
        allocate (values(n), stat=stat)
        call check_memory(error, stat)
    end subroutine make_real_room

    pure subroutine make_complex_room(error, n, values)
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int), intent(in) :: n
        complex(c_double), allocatable, intent(out) :: values(:)
        integer :: stat

        if (allocated(error)) return
        allocate (values(n), stat=stat)
        call check_memory(error, stat)
    end subroutine make_complex_room

    !> Writes complex results to the arrays of the caller, unless there is an error or one of them is not finite. All are required
    !> except the imaginary part, which may be missing.
    pure subroutine return_parts(error, values, real_part, imaginary_part)
        type(error_t), allocatable, intent(inout) :: error
        !> not allocated if there is an error
        complex(c_double), allocatable, intent(in) :: values(:)
        real(c_double), intent(inout), optional :: real_part(*), imaginary_part(*)
        integer :: i

        if (allocated(error)) return
        do i = 1, size(values)
            if (ieee_is_finite(real(values(i), c_double)) .and. ieee_is_finite(aimag(values(i)))) cycle
            call raise_range(error, i)
            return
        end do
        do i = 1, size(values)
            real_part(i) = real(values(i), c_double)
            if (present(imaginary_part)) imaginary_part(i) = aimag(values(i))
        end do
    end subroutine return_parts

    !> Raises unless all results are finite: from numbers that are far apart they can leave the number range.
    pure subroutine check_results(error, values)
        type(error_t), allocatable, intent(inout) :: error
        real(c_double), intent(in) :: values(:)
        integer :: i

        do i = 1, size(values)
            if (ieee_is_finite(values(i))) cycle
            call raise_range(error, i)
            return
        end do
    end subroutine check_results

    !> The same for what is greater than 0 and can only be rounded to it.
    pure subroutine check_positive_results(error, values)
        type(error_t), allocatable, intent(inout) :: error
        real(c_double), intent(in) :: values(:)
        integer :: i

        do i = 1, size(values)
            if (ieee_is_finite(values(i)) .and. values(i) > 0.0_c_double) cycle
            call raise_range(error, i)
            return
        end do
    end subroutine check_positive_results

    !> The same where infinity is a result.
    pure subroutine check_results_or_infinity(error, values)
        type(error_t), allocatable, intent(inout) :: error
        real(c_double), intent(in) :: values(:)
        integer :: i

        do i = 1, size(values)
            if (.not. ieee_is_nan(values(i))) cycle
            call raise_range(error, i)
            return
        end do
    end subroutine check_results_or_infinity

    pure subroutine raise_range(error, position)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: position

        call raise(error, error_no_convergence, " exceeds the range of double precision: the arguments are too large or too "// &
                   "small", "the result", position)
    end subroutine raise_range

end module mdrcontact_api_arrays
