! SPDX-License-Identifier: GPL-3.0-or-later
!> What an `mdr_law *` points to, from birth to death.
module mdrcontact_api_law_handle
    use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int, c_int64_t, c_loc, c_null_ptr, c_ptr
    use mdrcontact_api_status, only: check_given, check_memory, status_of
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_law, only: contact_law_t
    implicit none (type, external)
    private
    public :: open_law, deliver_law, mdr_law_free

    integer(c_int64_t), parameter :: no_tag = 0_c_int64_t
    integer(c_int64_t), parameter :: law_tag = 7239381865347100007_c_int64_t

    ! The tag comes first, as in every handle.
    type :: law_handle_t
        integer(c_int64_t) :: tag = law_tag
        type(contact_law_t) :: object
    end type law_handle_t

contains

    !> The law behind a handle, null after an error.
    subroutine open_law(handle, object, error)
        type(c_ptr), intent(in) :: handle
        type(contact_law_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        type(law_handle_t), pointer :: inside

        nullify (object)
        call check_given(error, "law", c_associated(handle))
        if (allocated(error)) return
        call c_f_pointer(handle, inside)
        if (inside%tag == law_tag) then
            object => inside%object
        else
            call raise(error, error_invalid, "law is not an mdr_law handle, or it has been freed")
        end if
    end subroutine open_law

    !> Puts a copy of a finished law behind a new handle and writes the handle to `out`, unless there was an error.
    function deliver_law(object, out, error) result(status)
        type(contact_law_t), intent(in) :: object
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        type(law_handle_t), pointer :: inside
        integer :: stat

        nullify (inside)
        call check_given(error, "out", present(out))
        if (.not. allocated(error)) then
            allocate (inside, stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) then
            inside%object = object
            out = c_loc(inside)
        end if
        status = status_of(error)
    end function deliver_law

    function mdr_law_free(law) result(status) bind(C)
        type(c_ptr), intent(inout), optional :: law
        integer(c_int) :: status
        type(law_handle_t), pointer :: inside
        type(contact_law_t), pointer :: object
        type(error_t), allocatable :: error

        status = 0_c_int
        if (.not. present(law)) return
        if (.not. c_associated(law)) return
        call open_law(law, object, error)
        if (associated(object)) then
            call c_f_pointer(law, inside)
            inside%tag = no_tag
            deallocate (inside)
            law = c_null_ptr
        end if
        status = status_of(error)
    end function mdr_law_free

end module mdrcontact_api_law_handle
