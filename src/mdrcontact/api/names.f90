! SPDX-License-Identifier: GPL-3.0-or-later
!> The codes of names, for C; the names of codes are in names.c.
module mdrcontact_api_names
    use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_ptr
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_api_text, only: read_text
    use mdrcontact_error, only: error_t
    use mdrcontact_words, only: code_of
    implicit none (type, external)
    private
    public :: mdr_code_of

contains

    function mdr_code_of(enumeration, name, code) result(status) bind(C)
        integer(c_int), value :: enumeration
        type(c_ptr), value :: name
        integer(c_int), intent(inout), optional :: code
        integer(c_int) :: status
        character(len=:), allocatable :: word
        type(error_t), allocatable :: error
        integer :: found

        call check_given(error, "name", c_associated(name))
        call check_given(error, "code", present(code))
        if (.not. allocated(error)) call read_text(name, word, error)
        if (.not. allocated(error)) call code_of(int(enumeration), word, found, error)
        if (.not. allocated(error)) code = int(found, c_int)
        status = status_of(error)
    end function mdr_code_of

end module mdrcontact_api_names
