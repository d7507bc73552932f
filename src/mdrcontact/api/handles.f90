! SPDX-License-Identifier: GPL-3.0-or-later
!> Opaque handles: what an `mdr_profile *`, `mdr_medium *`, `mdr_contact *` points to, from birth to death.
!>
!> Each handle starts with a tag of its kind, so that a handle of the wrong kind is refused. A freed handle loses
!> its tag, which catches some uses after the end but cannot catch all.
module mdrcontact_api_handles
    use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int, c_int64_t, c_loc, c_null_ptr, c_ptr
    use mdrcontact_api_status, only: check_given, check_memory, status_of
    use mdrcontact_contact, only: contact_t
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_medium, only: medium_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: open_profile, open_medium, open_contact
    public :: check_handle, holds_handle
    public :: deliver_profile, deliver_medium, deliver_contact
    public :: mdr_profile_free, mdr_medium_free, mdr_contact_free

    integer(c_int64_t), parameter :: no_tag = 0_c_int64_t
    integer(c_int64_t), parameter :: profile_tag = 7239381865347100001_c_int64_t
    integer(c_int64_t), parameter :: medium_tag = 7239381865347100002_c_int64_t
    integer(c_int64_t), parameter :: contact_tag = 7239381865347100003_c_int64_t

    ! The tag comes first in all three: it is read before the kind is known.
    type :: profile_handle_t
        integer(c_int64_t) :: tag = profile_tag
        class(profile_t), allocatable :: object
    end type profile_handle_t

    type :: medium_handle_t
        integer(c_int64_t) :: tag = medium_tag
        class(medium_t), allocatable :: object
    end type medium_handle_t

    type :: contact_handle_t
        integer(c_int64_t) :: tag = contact_tag
        type(contact_t) :: object
    end type contact_handle_t

contains

    !> The profile behind a handle, null after an error.
    subroutine open_profile(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        class(profile_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        type(profile_handle_t), pointer :: inside

        nullify (object)
        call check_handle(error, handle, name, "mdr_profile", profile_tag)
        if (allocated(error)) return
        call c_f_pointer(handle, inside)
        object => inside%object
    end subroutine open_profile

    !> The medium behind a handle, null after an error.
    subroutine open_medium(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        class(medium_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        type(medium_handle_t), pointer :: inside

        nullify (object)
        call check_handle(error, handle, name, "mdr_medium", medium_tag)
        if (allocated(error)) return
        call c_f_pointer(handle, inside)
        object => inside%object
    end subroutine open_medium

    !> The contact behind a handle, null after an error.
    subroutine open_contact(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(contact_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        type(contact_handle_t), pointer :: inside

        nullify (object)
        call check_handle(error, handle, name, "mdr_contact", contact_tag)
        if (allocated(error)) return
        call c_f_pointer(handle, inside)
        object => inside%object
    end subroutine open_contact

    !> Puts a copy of a finished profile behind a new handle and writes the handle to `out`, unless there was an error.
    function deliver_profile(object, out, error) result(status)
        class(profile_t), intent(in) :: object
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        type(profile_handle_t), pointer :: inside
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
    end function deliver_profile

    !> The same for a medium.
    function deliver_medium(object, out, error) result(status)
        class(medium_t), intent(in) :: object
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        type(medium_handle_t), pointer :: inside
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
    end function deliver_medium

    !> The same for a contact.
    function deliver_contact(object, out, error) result(status)
        type(contact_t), intent(in) :: object
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        type(contact_handle_t), pointer :: inside
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
    end function deliver_contact

    function mdr_profile_free(p) result(status) bind(C)
        type(c_ptr), intent(inout), optional :: p
        integer(c_int) :: status
        type(profile_handle_t), pointer :: inside
        type(error_t), allocatable :: error

        if (holds_handle(p, "mdr_profile", profile_tag, error)) then
            call c_f_pointer(p, inside)
            inside%tag = no_tag
            deallocate (inside)
            p = c_null_ptr
        end if
        status = status_of(error)
    end function mdr_profile_free

    function mdr_medium_free(m) result(status) bind(C)
        type(c_ptr), intent(inout), optional :: m
        integer(c_int) :: status
        type(medium_handle_t), pointer :: inside
        type(error_t), allocatable :: error

        if (holds_handle(m, "mdr_medium", medium_tag, error)) then
            call c_f_pointer(m, inside)
            inside%tag = no_tag
            deallocate (inside)
            m = c_null_ptr
        end if
        status = status_of(error)
    end function mdr_medium_free

    function mdr_contact_free(c) result(status) bind(C)
        type(c_ptr), intent(inout), optional :: c
        integer(c_int) :: status
        type(contact_handle_t), pointer :: inside
        type(error_t), allocatable :: error

        if (holds_handle(c, "mdr_contact", contact_tag, error)) then
            call c_f_pointer(c, inside)
            inside%tag = no_tag
            deallocate (inside)
            c = c_null_ptr
        end if
        status = status_of(error)
    end function mdr_contact_free

    !> Whether there is a handle to free; nothing to free is no error, a handle of another kind is.
    function holds_handle(handle, kind, tag, error) result(answer)
        type(c_ptr), intent(in), optional :: handle
        character(len=*), intent(in) :: kind
        integer(c_int64_t), intent(in) :: tag
        type(error_t), allocatable, intent(inout) :: error
        logical :: answer

        answer = .false.
        if (.not. present(handle)) return
        if (.not. c_associated(handle)) return
        call check_handle(error, handle, "the handle to free", kind, tag)
        answer = .not. allocated(error)
    end function holds_handle

    subroutine check_handle(error, handle, name, kind, tag)
        type(error_t), allocatable, intent(inout) :: error
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name, kind
        integer(c_int64_t), intent(in) :: tag
        integer(c_int64_t), pointer :: found

        call check_given(error, name, c_associated(handle))
        if (allocated(error)) return
        call c_f_pointer(handle, found)
        if (found /= tag) call raise(error, error_invalid, name//" is not an "//kind//" handle, or it has been freed")
    end subroutine check_handle

end module mdrcontact_api_handles
