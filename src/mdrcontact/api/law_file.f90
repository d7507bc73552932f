! SPDX-License-Identifier: GPL-3.0-or-later
!> Compiled contact laws for C: files, and the same content in memory.
module mdrcontact_api_law_file
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_int, c_null_char, c_ptr
    use mdrcontact_api_law, only: read_text
    use mdrcontact_api_handles, only: hand_over, open_handle
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_error, only: check_count_from, check_memory, error_t
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_file, only: law_from_text, law_to_text, load_law, save_law
    implicit none (type, external)
    private
    public :: mdr_law_save, mdr_law_load, mdr_law_write, mdr_law_read

contains

    function mdr_law_save(law, path) result(status) bind(C)
        type(c_ptr), value :: law, path
        integer(c_int) :: status
        type(contact_law_t), pointer :: inside
        character(len=:), allocatable :: name
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        call check_given(error, "path", c_associated(path))
        if (.not. allocated(error)) then
            call read_text(path, name, error)
            if (.not. allocated(error)) call save_law(inside, name//c_null_char, error)
        end if
        status = status_of(error)
    end function mdr_law_save

    function mdr_law_load(path, out) result(status) bind(C)
        type(c_ptr), value :: path
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(contact_law_t), allocatable :: law
        class(*), allocatable :: object
        character(len=:), allocatable :: name
        type(error_t), allocatable :: error

        allocate (law)
        call check_given(error, "path", c_associated(path))
        if (.not. allocated(error)) then
            call read_text(path, name, error)
            if (.not. allocated(error)) call load_law(law, name//c_null_char, error)
        end if
        call move_alloc(law, object)
        status = hand_over(object, out, error)
    end function mdr_law_load

    !> Writes nothing but the length where the buffer is too short.
    function mdr_law_write(law, buffer, length, full_length) result(status) bind(C)
        type(c_ptr), value :: law, buffer
        integer(c_int), value :: length
        integer(c_int), intent(inout), optional :: full_length
        integer(c_int) :: status
        type(contact_law_t), pointer :: inside
        character(kind=c_char), pointer :: characters(:)
        character(len=:), allocatable :: text
        type(error_t), allocatable :: error
        integer :: i

        call open_handle(law, "law", inside, error)
        call check_given(error, "buffer", c_associated(buffer) .or. length < 1)
        call check_given(error, "full_length", present(full_length))
        text = ""
        if (.not. allocated(error)) call law_to_text(inside, text, error)
        status = status_of(error)
        if (allocated(error)) return
        full_length = len(text, kind=c_int)
        if (length < full_length) return
        call c_f_pointer(buffer, characters, [length])
        do i = 1, len(text)
            characters(i) = text(i:i)
        end do
    end function mdr_law_write

    function mdr_law_read(buffer, length, out) result(status) bind(C)
        type(c_ptr), value :: buffer
        integer(c_int), value :: length
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(contact_law_t), allocatable :: law
        class(*), allocatable :: object
        character(len=:), allocatable :: text
        type(error_t), allocatable :: error

        allocate (law)
        call check_given(error, "buffer", c_associated(buffer))
        call check_count_from(error, "length", int(length), 0)
        text = "" ! gfortran 12 would call its length uninitialized
        if (.not. allocated(error)) call read_buffer(buffer, int(length), text, error)
        if (.not. allocated(error)) call law_from_text(law, text, error)
        call move_alloc(law, object)
        status = hand_over(object, out, error)
    end function mdr_law_read

    !> The characters of a buffer as text.
    subroutine read_buffer(buffer, length, text, error)
        type(c_ptr), intent(in) :: buffer
        integer, intent(in) :: length
        character(len=:), allocatable, intent(out) :: text
        type(error_t), allocatable, intent(inout) :: error
        character(kind=c_char), pointer :: characters(:)
        integer :: i, stat

        allocate (character(len=length) :: text, stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        call c_f_pointer(buffer, characters, [length])
        do i = 1, length
            text(i:i) = characters(i)
        end do
    end subroutine read_buffer

end module mdrcontact_api_law_file
