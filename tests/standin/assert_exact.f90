! SPDX-License-Identifier: GPL-3.0-or-later
!> Equality of integers and of text.
module assert_exact
    use, intrinsic :: iso_fortran_env, only: int64
    use test_record, only: note_assertion, note_failure, SourceLocation
    use test_words, only: element, fail_shapes, text
    implicit none (type, external)
    private
    public :: assertEqual

    interface assertEqual
        module procedure :: equal_integer, equal_integer_1, equal_int64, equal_text
    end interface assertEqual

contains

    subroutine equal_integer(expected, found, message, location)
        integer, intent(in) :: expected, found
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call equal_int64(int(expected, int64), int(found, int64), message, location)
    end subroutine equal_integer

    subroutine equal_integer_1(expected, found, message, location)
        integer, intent(in) :: expected(:), found(:)
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location
        integer :: i

        call note_assertion()
        if (size(expected) /= size(found)) then
            call fail_shapes(shape(expected), shape(found), message, location)
            return
        end if
        do i = 1, size(found)
            if (expected(i) /= found(i)) then
                call note_failure(element(i)//"expected "//text(int(expected(i), int64))//", found "// &
                                  text(int(found(i), int64)), message, location)
                return
            end if
        end do
    end subroutine equal_integer_1

    subroutine equal_int64(expected, found, message, location)
        integer(int64), intent(in) :: expected, found
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call note_assertion()
        if (expected /= found) call note_failure("expected "//text(expected)//", found "//text(found), message, location)
    end subroutine equal_int64

    !> Text is compared without the blanks around it.
    subroutine equal_text(expected, found, message, location)
        character(len=*), intent(in) :: expected, found
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        call note_assertion()
        if (trim(adjustl(expected)) == trim(adjustl(found))) return
        call note_failure("expected """//trim(adjustl(expected))//""", found """//trim(adjustl(found))//"""", message, location)
    end subroutine equal_text

end module assert_exact
