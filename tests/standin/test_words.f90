! SPDX-License-Identifier: GPL-3.0-or-later
!> Words that the assertions share: numbers as text, and the failure of arrays that differ in shape.
module test_words
    use, intrinsic :: iso_fortran_env, only: int64, real64
    use test_record, only: note_failure, SourceLocation
    implicit none (type, external)
    private
    public :: element, fail_shapes, number, text

contains

    subroutine fail_shapes(expected_shape, found_shape, message, location)
        integer, intent(in) :: expected_shape(:), found_shape(:)
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location
        character(len=128) :: buffer

        write (buffer, "(a, *(i0, :, 1x))") "different shapes: ", expected_shape, found_shape
        call note_failure(trim(buffer), message, location)
    end subroutine fail_shapes

    pure function element(i) result(words)
        integer, intent(in) :: i
        character(len=:), allocatable :: words

        words = "element "//text(int(i, int64))//": "
    end function element

    pure function number(x) result(words)
        real(real64), intent(in) :: x
        character(len=:), allocatable :: words
        character(len=32) :: buffer

        write (buffer, "(es24.16e3)") x
        words = trim(adjustl(buffer))
    end function number

    pure function text(i) result(words)
        integer(int64), intent(in) :: i
        character(len=:), allocatable :: words
        character(len=32) :: buffer

        write (buffer, "(i0)") i
        words = trim(buffer)
    end function text

end module test_words
