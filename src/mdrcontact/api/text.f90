! SPDX-License-Identifier: GPL-3.0-or-later
!> Text that crosses the C boundary.
module mdrcontact_api_text
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_null_char, c_ptr
    use mdrcontact_error, only: check_memory, error_t
    implicit none (type, external)
    private
    public :: read_text, read_characters, write_text, write_characters

contains

    !> The text at a C pointer, up to its null character; empty for null.
    subroutine read_text(pointer, text, error)
        type(c_ptr), intent(in) :: pointer
        character(len=:), allocatable, intent(out) :: text
        type(error_t), allocatable, intent(inout) :: error
        character(kind=c_char), pointer :: characters(:)
        integer :: length

        length = 0
        if (c_associated(pointer)) then
            call c_f_pointer(pointer, characters, [huge(1)])
            do while (characters(length + 1) /= c_null_char)
                length = length + 1
            end do
        end if
        call read_characters(pointer, length, text, error)
    end subroutine read_text

    !> So many characters at a C pointer.
    subroutine read_characters(pointer, length, text, error)
        type(c_ptr), intent(in) :: pointer
        integer, intent(in) :: length
        character(len=:), allocatable, intent(out) :: text
        type(error_t), allocatable, intent(inout) :: error
        character(kind=c_char), pointer :: characters(:)
        integer :: i, stat

        allocate (character(len=length) :: text, stat=stat)
        call check_memory(error, stat)
        if (allocated(error) .or. length == 0) return
        call c_f_pointer(pointer, characters, [length])
        do i = 1, length
            text(i:i) = characters(i)
        end do
    end subroutine read_characters

    !> As much of the text as there is room for, at least 1, and a null character.
    subroutine write_text(text, room, pointer)
        character(len=*), intent(in) :: text
        integer, intent(in) :: room
        type(c_ptr), intent(in) :: pointer
        character(kind=c_char), pointer :: characters(:)
        integer :: copied

        copied = min(len(text), room - 1)
        call write_characters(text(:copied), pointer)
        call c_f_pointer(pointer, characters, [room])
        characters(copied + 1) = c_null_char
    end subroutine write_text

    !> Write the whole text.
    subroutine write_characters(text, pointer)
        character(len=*), intent(in) :: text
        type(c_ptr), intent(in) :: pointer
        character(kind=c_char), pointer :: characters(:)
        integer :: i

        call c_f_pointer(pointer, characters, [len(text)])
        do i = 1, len(text)
            characters(i) = text(i:i)
        end do
    end subroutine write_characters

end module mdrcontact_api_text
