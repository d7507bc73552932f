! SPDX-License-Identifier: GPL-3.0-or-later
!> Whole files as text; file.c states the guarantees of writing and reading.
module mdrcontact_file
    use, intrinsic :: iso_c_binding, only: c_char, c_int, c_long_long, c_null_char, c_size_t
    use mdrcontact_error, only: check_memory, error_file, error_t, raise
    implicit none (type, external)
    private
    public :: read_file, write_file, path_length

    integer, parameter :: reason_space = 256

    interface
        function mdrcontact_open_file(path, size, reason, space) result(file) bind(C)
            import :: c_char, c_int, c_long_long, c_size_t
            character(kind=c_char), intent(in) :: path(*)
            integer(c_long_long), intent(inout) :: size
            character(kind=c_char), intent(inout) :: reason(*)
            integer(c_size_t), value :: space
            integer(c_int) :: file
        end function mdrcontact_open_file

        function mdrcontact_read_file(file, bytes, size, reason, space) result(status) bind(C)
            import :: c_char, c_int, c_size_t
            integer(c_int), value :: file
            character(kind=c_char), intent(inout), optional :: bytes(*)
            integer(c_size_t), value :: size
            character(kind=c_char), intent(inout) :: reason(*)
            integer(c_size_t), value :: space
            integer(c_int) :: status
        end function mdrcontact_read_file

        function mdrcontact_write_file(path, bytes, size, reason, space) result(status) bind(C)
            import :: c_char, c_int, c_size_t
            character(kind=c_char), intent(in) :: path(*), bytes(*)
            integer(c_size_t), value :: size
            character(kind=c_char), intent(inout) :: reason(*)
            integer(c_size_t), value :: space
            integer(c_int) :: status
        end function mdrcontact_write_file
    end interface

contains

    !> Makes or replaces the file `path`; if that fails, the old file stays.
    subroutine write_file(path, text, error)
        !> up to its trailing blanks, or up to a null character before which blanks count
        character(len=*), intent(in) :: path, text
        type(error_t), allocatable, intent(inout) :: error
        character(len=reason_space) :: reason

        if (mdrcontact_write_file(trim(path)//c_null_char, text, len(text, c_size_t), reason, len(reason, c_size_t)) /= 0) then
            call refuse(path, " cannot be written", reason, error)
        end if
    end subroutine write_file

    !> The content of the file `path`.
    subroutine read_file(path, text, error)
        !> as in write_file
        character(len=*), intent(in) :: path
        character(len=:), allocatable, intent(out) :: text
        type(error_t), allocatable, intent(inout) :: error
        character(len=reason_space) :: reason
        integer(c_long_long) :: length
        integer(c_int) :: file, status
        integer :: stat

        length = 0_c_long_long
        file = mdrcontact_open_file(trim(path)//c_null_char, length, reason, len(reason, c_size_t))
        status = min(file, 0_c_int)
        if (file >= 0) then
            stat = 1
            if (length <= huge(1)) allocate (character(len=length) :: text, stat=stat)
            if (stat == 0) then
                status = mdrcontact_read_file(file, text, len(text, c_size_t), reason, len(reason, c_size_t))
            else
                status = mdrcontact_read_file(file, size=0_c_size_t, reason=reason, space=len(reason, c_size_t))
                call check_memory(error, stat)
                return
            end if
        end if
        if (status /= 0) call refuse(path, " cannot be read", reason, error)
    end subroutine read_file

    subroutine refuse(path, what, reason, error)
        character(len=*), intent(in) :: path, what
        !> from C, with a null character at its end
        character(len=*), intent(in) :: reason
        type(error_t), allocatable, intent(inout) :: error

        ! a path may be longer than the text that C returns
        call raise(error, error_file, reason(:path_length(reason))//": the file "//path(:path_length(path))//what)
    end subroutine refuse

    !> Where a path ends: before its null character or its trailing blanks.
    pure function path_length(path) result(length)
        character(len=*), intent(in) :: path
        integer :: length

        length = index(path, c_null_char) - 1
        if (length < 0) length = len_trim(path)
    end function path_length

end module mdrcontact_file
