! SPDX-License-Identifier: GPL-3.0-or-later
!> Equality of reals within an absolute or a relative tolerance.
!>
!> NaN and infinity equal nothing, and arrays of different shape are not equal.
module assert_real
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
    use, intrinsic :: iso_fortran_env, only: real64
    use test_record, only: note_assertion, note_failure, SourceLocation
    use test_words, only: element, fail_shapes, number
    implicit none (type, external)
    private
    public :: assertEqual, assertRelativelyEqual

    !> |found - expected| <= tolerance (0 if absent) in every element.
    interface assertEqual
        module procedure :: equal_real, equal_real_1, equal_real_2, equal_real_0_1, equal_real_0_2
    end interface assertEqual

    !> |found - expected| <= tolerance |expected| in every element; expected = 0 fails.
    interface assertRelativelyEqual
        module procedure :: relative, relative_1, relative_2, relative_0_1, relative_0_2
    end interface assertRelativelyEqual

contains

    subroutine equal_real(expected, found, tolerance, message, location)
        real(real64), intent(in) :: expected, found
        real(real64), intent(in), optional :: tolerance
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call compare([expected], [found], [1], [1], tolerance, .false., message, location)
    end subroutine equal_real

    subroutine equal_real_1(expected, found, tolerance, message, location)
        real(real64), intent(in) :: expected(:), found(:)
        real(real64), intent(in), optional :: tolerance
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call compare(expected, found, shape(expected), shape(found), tolerance, .false., message, location)
    end subroutine equal_real_1

    subroutine equal_real_2(expected, found, tolerance, message, location)
        real(real64), intent(in) :: expected(:, :), found(:, :)
        real(real64), intent(in), optional :: tolerance
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call compare([expected], [found], shape(expected), shape(found), tolerance, .false., message, location)
    end subroutine equal_real_2

    subroutine equal_real_0_1(expected, found, tolerance, message, location)
        real(real64), intent(in) :: expected, found(:)
        real(real64), intent(in), optional :: tolerance
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call compare(spread(expected, 1, size(found)), found, shape(found), shape(found), tolerance, .false., message, location)
    end subroutine equal_real_0_1

    subroutine equal_real_0_2(expected, found, tolerance, message, location)
        real(real64), intent(in) :: expected, found(:, :)
        real(real64), intent(in), optional :: tolerance
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call compare(spread(expected, 1, size(found)), [found], shape(found), shape(found), tolerance, .false., message, location)
    end subroutine equal_real_0_2

    subroutine relative(expected, found, tolerance, message, location)
        real(real64), intent(in) :: expected, found
        real(real64), intent(in) :: tolerance
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call compare([expected], [found], [1], [1], tolerance, .true., message, location)
    end subroutine relative

    subroutine relative_1(expected, found, tolerance, message, location)
        real(real64), intent(in) :: expected(:), found(:)
        real(real64), intent(in) :: tolerance
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call compare(expected, found, shape(expected), shape(found), tolerance, .true., message, location)
    end subroutine relative_1

    subroutine relative_2(expected, found, tolerance, message, location)
        real(real64), intent(in) :: expected(:, :), found(:, :)
        real(real64), intent(in) :: tolerance
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call compare([expected], [found], shape(expected), shape(found), tolerance, .true., message, location)
    end subroutine relative_2

    subroutine relative_0_1(expected, found, tolerance, message, location)
        real(real64), intent(in) :: expected, found(:)
        real(real64), intent(in) :: tolerance
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call compare(spread(expected, 1, size(found)), found, shape(found), shape(found), tolerance, .true., message, location)
    end subroutine relative_0_1

    subroutine relative_0_2(expected, found, tolerance, message, location)
        real(real64), intent(in) :: expected, found(:, :)
        real(real64), intent(in) :: tolerance
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call compare(spread(expected, 1, size(found)), [found], shape(found), shape(found), tolerance, .true., message, location)
    end subroutine relative_0_2

    !> Compares rank by rank after the shapes have been compared: `expected` and `found` in array element order.
    subroutine compare(expected, found, expected_shape, found_shape, tolerance, relative, message, location)
        real(real64), intent(in) :: expected(:), found(:)
        integer, intent(in) :: expected_shape(:), found_shape(:)
        real(real64), intent(in), optional :: tolerance
        logical, intent(in) :: relative
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location
        real(real64) :: allowed
        integer :: i

        call note_assertion()
        if (any(expected_shape /= found_shape)) then
            call fail_shapes(expected_shape, found_shape, message, location)
            return
        end if
        do i = 1, size(found)
            if (.not. (ieee_is_finite(expected(i)) .and. ieee_is_finite(found(i)))) then
                call note_failure(element(i)//"expected "//number(expected(i))//", found "//number(found(i))// &
                                  ": only finite numbers compare equal", message, location)
                return
            end if
            if (relative .and. expected(i) == 0.0_real64) then
                call note_failure(element(i)//"expected 0, which allows no relative error", message, location)
                return
            end if
            allowed = 0.0_real64
            if (present(tolerance)) allowed = merge(tolerance*abs(expected(i)), tolerance, relative)
            if (ieee_is_nan(allowed)) allowed = -1.0_real64
            if (abs(found(i) - expected(i)) <= allowed) cycle
            call note_failure(element(i)//"expected "//number(expected(i))//", found "//number(found(i))//", difference "// &
                              number(found(i) - expected(i))//", allowed "//number(allowed), message, location)
            return
        end do
    end subroutine compare

end module assert_real
