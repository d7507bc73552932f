! SPDX-License-Identifier: GPL-3.0-or-later
!> The opaque handle `mdr_structure *`, from birth to death.
module mdrcontact_api_structure_handle
    use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int, c_int64_t, c_loc, c_null_ptr, c_ptr
    use mdrcontact_api_status, only: check_given, check_memory, status_of
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_lateral_structure, only: structure_t
    implicit none (type, external)
    private
    public :: open_structure, deliver_structure, mdr_structure_free

    integer(c_int64_t), parameter :: no_tag = 0_c_int64_t
    integer(c_int64_t), parameter :: structure_tag = 7239381865347100014_c_int64_t

    type :: structure_handle_t
        integer(c_int64_t) :: tag = structure_tag
        class(structure_t), allocatable :: object
    end type structure_handle_t

contains

    !> The structure behind a handle, null after an error.
    subroutine open_structure(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        class(structure_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        type(structure_handle_t), pointer :: inside

        nullify (object)
        call check_handle(error, handle, name)
        if (allocated(error)) return
        call c_f_pointer(handle, inside)
        object => inside%object
    end subroutine open_structure

    !> Puts a copy of a finished structure behind a new handle and writes the handle to `out`, unless there was an error.
    function deliver_structure(object, out, error) result(status)
        class(structure_t), intent(in) :: object
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        type(structure_handle_t), pointer :: inside
        integer :: stat

        nullify (inside)
        call check_given(error, "out", present(out))
        if (.not. allocated(error)) then
            allocate (inside, stat=stat)
            if (stat == 0) allocate (inside%object, source=object, stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) then
            out = c_loc(inside)
        else if (associated(inside)) then
            deallocate (inside)
        end if
        status = status_of(error)
    end function deliver_structure

    function mdr_structure_free(s) result(status) bind(C)
        type(c_ptr), intent(inout), optional :: s
        integer(c_int) :: status
        type(structure_handle_t), pointer :: inside
        type(error_t), allocatable :: error

        status = status_of(error)
        if (.not. present(s)) return
        if (.not. c_associated(s)) return
        call check_handle(error, s, "the handle to free")
        if (.not. allocated(error)) then
            call c_f_pointer(s, inside)
            inside%tag = no_tag
            deallocate (inside)
            s = c_null_ptr
        end if
        status = status_of(error)
    end function mdr_structure_free

    subroutine check_handle(error, handle, name)
        type(error_t), allocatable, intent(inout) :: error
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        integer(c_int64_t), pointer :: found

        call check_given(error, name, c_associated(handle))
        if (allocated(error)) return
        call c_f_pointer(handle, found)
        if (found /= structure_tag) then
            call raise(error, error_invalid, name//" is not an mdr_structure handle, or it has been freed")
        end if
    end subroutine check_handle

end module mdrcontact_api_structure_handle
