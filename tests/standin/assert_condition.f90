! SPDX-License-Identifier: GPL-3.0-or-later
!> Conditions and order. NaN is neither finite nor less than, equal to or greater than anything.
module assert_condition
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
    use, intrinsic :: iso_fortran_env, only: int64, real64
    use test_record, only: note_assertion, note_failure, SourceLocation
    use test_words, only: number, text
    implicit none (type, external)
    private
    public :: assertTrue, assertFalse, assertIsNaN, assertIsFinite
    public :: assertLessThan, assertLessThanOrEqual, assertGreaterThan, assertGreaterThanOrEqual

    interface assertLessThan
        module procedure :: less_real, less_integer
    end interface assertLessThan

    interface assertLessThanOrEqual
        module procedure :: less_or_equal_real, less_or_equal_integer
    end interface assertLessThanOrEqual

    interface assertGreaterThan
        module procedure :: greater_real, greater_integer
    end interface assertGreaterThan

    interface assertGreaterThanOrEqual
        module procedure :: greater_or_equal_real, greater_or_equal_integer
    end interface assertGreaterThanOrEqual

contains

    subroutine assertTrue(condition, message, location)
        logical, intent(in) :: condition
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call require(condition, "expected true, found false", message, location)
    end subroutine assertTrue

    subroutine assertFalse(condition, message, location)
        logical, intent(in) :: condition
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call require(.not. condition, "expected false, found true", message, location)
    end subroutine assertFalse

    subroutine assertIsNaN(x, message, location)
        real(real64), intent(in) :: x
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call require(ieee_is_nan(x), "expected NaN, found "//number(x), message, location)
    end subroutine assertIsNaN

    subroutine assertIsFinite(x, message, location)
        real(real64), intent(in) :: x
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call require(ieee_is_finite(x), "expected a finite number, found "//number(x), message, location)
    end subroutine assertIsFinite

    subroutine less_real(a, b, message, location)
        real(real64), intent(in) :: a, b
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call require(a < b, "expected "//number(a)//" less than "//number(b), message, location)
    end subroutine less_real

    subroutine less_integer(a, b, message, location)
        integer, intent(in) :: a, b
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call require(a < b, "expected "//text(int(a, int64))//" less than "//text(int(b, int64)), message, location)
    end subroutine less_integer

    subroutine less_or_equal_real(a, b, message, location)
        real(real64), intent(in) :: a, b
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call require(a <= b, "expected "//number(a)//" at most "//number(b), message, location)
    end subroutine less_or_equal_real

    subroutine less_or_equal_integer(a, b, message, location)
        integer, intent(in) :: a, b
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call require(a <= b, "expected "//text(int(a, int64))//" at most "//text(int(b, int64)), message, location)
    end subroutine less_or_equal_integer

    subroutine greater_real(a, b, message, location)
        real(real64), intent(in) :: a, b
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call require(a > b, "expected "//number(a)//" greater than "//number(b), message, location)
    end subroutine greater_real

    subroutine greater_integer(a, b, message, location)
        integer, intent(in) :: a, b
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call require(a > b, "expected "//text(int(a, int64))//" greater than "//text(int(b, int64)), message, location)
    end subroutine greater_integer

    subroutine greater_or_equal_real(a, b, message, location)
        real(real64), intent(in) :: a, b
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call require(a >= b, "expected "//number(a)//" at least "//number(b), message, location)
    end subroutine greater_or_equal_real

    subroutine greater_or_equal_integer(a, b, message, location)
        integer, intent(in) :: a, b
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call require(a >= b, "expected "//text(int(a, int64))//" at least "//text(int(b, int64)), message, location)
    end subroutine greater_or_equal_integer

    subroutine require(holds, reason, message, location)
        logical, intent(in) :: holds
        character(len=*), intent(in) :: reason
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call note_assertion()
        if (.not. holds) call note_failure(reason, message, location)
    end subroutine require

end module assert_condition
