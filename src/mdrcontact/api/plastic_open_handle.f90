! SPDX-License-Identifier: GPL-3.0-or-later
!> The object behind a handle, by the type of the pointer that is to hold it. Written by tools/generate.py.
module mdrcontact_api_plastic_open_handle
    use, intrinsic :: iso_c_binding, only: c_ptr
    use mdrcontact_api_handles, only: look_inside, refuse_kind
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_error, only: error_t
    use mdrcontact_plastic_cap, only: cap_t
    use mdrcontact_plastic_imprint, only: imprint_t
    use mdrcontact_plastic_law, only: plastic_law_t
    use mdrcontact_plastic_overload, only: overload_t
    use mdrcontact_plastic_yielding, only: yielding_t
    implicit none (type, external)
    private
    public :: open_handle

    !> The object behind a handle; null after an error. `name` is the argument's.
    interface open_handle
        module procedure &
            open_imprint, &
            open_yielding, &
            open_plastic_law, &
            open_overload, &
            open_cap
    end interface open_handle

contains

    subroutine open_imprint(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(imprint_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_imprint", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (imprint_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_imprint", error)
        end select
    end subroutine open_imprint

    subroutine open_yielding(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(yielding_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_yielding", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (yielding_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_yielding", error)
        end select
    end subroutine open_yielding

    subroutine open_plastic_law(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(plastic_law_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_plastic_law", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (plastic_law_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_plastic_law", error)
        end select
    end subroutine open_plastic_law

    subroutine open_overload(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(overload_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_overload", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (overload_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_overload", error)
        end select
    end subroutine open_overload

    subroutine open_cap(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(cap_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_cap", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (cap_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_cap", error)
        end select
    end subroutine open_cap

end module mdrcontact_api_plastic_open_handle
