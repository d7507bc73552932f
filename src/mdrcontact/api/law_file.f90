! SPDX-License-Identifier: GPL-3.0-or-later
!> Compiled laws for C: files, and the same content in memory.
module mdrcontact_api_law_file
    use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_null_char, c_ptr
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_api_text, only: read_characters, read_text, write_characters
    use mdrcontact_error, only: check_count_from, error_t
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_file, only: law_to_text
    implicit none (type, external)
    private
    public :: mdr_law_write, read_content, read_name

contains

    function mdr_law_write(law, buffer, length, full_length) result(status) bind(C, name="mdrcontact_entry_law_write")
        type(c_ptr), value :: law, buffer
        integer(c_int), value :: length
        integer(c_int), intent(inout), optional :: full_length
        integer(c_int) :: status
        type(contact_law_t), pointer :: inside
        character(len=:), allocatable :: text
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        text = ""
        if (.not. allocated(error)) call law_to_text(inside, text, error)
        status = write_content(text, buffer, length, full_length, error)
    end function mdr_law_write

    !> A file's name, blanks at its end included.
    subroutine read_name(path, name, error)
        type(c_ptr), intent(in) :: path
        character(len=:), allocatable, intent(out) :: name
        type(error_t), allocatable, intent(inout) :: error

        name = "" ! gfortran 12 would call its length uninitialized
        if (.not. allocated(error)) call read_text(path, name, error)
        if (.not. allocated(error)) name = name//c_null_char
    end subroutine read_name

    !> Writes nothing but the length where the buffer is too short.
    function write_content(text, buffer, length, full_length, error) result(status)
        character(len=*), intent(in) :: text
        type(c_ptr), intent(in) :: buffer
        integer(c_int), intent(in) :: length
        integer(c_int), intent(inout), optional :: full_length
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status

        call check_given(error, "buffer", c_associated(buffer) .or. length < 1)
        status = status_of(error)
        if (allocated(error)) return
        full_length = len(text, kind=c_int)
        if (length < full_length) return
        call write_characters(text, buffer)
    end function write_content

    subroutine read_content(buffer, length, text, error)
        type(c_ptr), intent(in) :: buffer
        integer(c_int), intent(in) :: length
        character(len=:), allocatable, intent(out) :: text
        type(error_t), allocatable, intent(inout) :: error

        text = "" ! see above
        call check_count_from(error, "length", int(length), 0)
        if (.not. allocated(error)) call read_characters(buffer, int(length), text, error)
    end subroutine read_content

end module mdrcontact_api_law_file
