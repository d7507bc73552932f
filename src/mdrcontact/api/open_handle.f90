! SPDX-License-Identifier: GPL-3.0-or-later
!> The object behind a handle, by the type of the pointer that is to hold it. Written by tools/generate.py.
module mdrcontact_api_open_handle
    use, intrinsic :: iso_c_binding, only: c_ptr
    use mdrcontact_api_handles, only: look_inside, refuse_kind
    use mdrcontact_api_any_body, only: any_body_t
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_contact_loop, only: loop_t
    use mdrcontact_contact_relaxing_contact, only: relaxing_contact_t
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_friction_history, only: friction_history_t
    use mdrcontact_friction_partial_slip, only: first_shear_t, friction_t
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_material_rheology, only: rheology_t
    use mdrcontact_medium, only: medium_t, refuse_states
    use mdrcontact_medium_response, only: response_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: open_handle

    !> The object behind a handle; null after an error. `name` is the argument's.
    interface open_handle
        module procedure &
            open_profile, &
            open_any_body, &
            open_response, &
            open_medium, &
            open_contact, &
            open_relaxing_contact, &
            open_contact_load, &
            open_loop, &
            open_contact_law, &
            open_friction, &
            open_first_shear, &
            open_friction_history, &
            open_rheology
    end interface open_handle

contains

    subroutine open_profile(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        class(profile_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_profile", inside, error)
        if (allocated(error)) return
        select type (inside)
        class is (profile_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_profile", error)
        end select
    end subroutine open_profile

    subroutine open_any_body(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(any_body_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_body", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (any_body_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_body", error)
        end select
    end subroutine open_any_body

    subroutine open_response(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(response_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_response", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (response_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_response", error)
        end select
    end subroutine open_response

    subroutine open_medium(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(medium_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_medium", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (medium_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_medium", error)
        end select
    end subroutine open_medium

    subroutine open_contact(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(contact_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_contact", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (contact_t)
            object => inside
        type is (relaxing_contact_t)
            call refuse_states(error)
        class default
            call refuse_kind(name, "mdr_contact", error)
        end select
    end subroutine open_contact

    subroutine open_relaxing_contact(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(relaxing_contact_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_contact", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (relaxing_contact_t)
            object => inside
        type is (contact_t)
            call raise(error, error_invalid, "the body is elastic: its states do not depend on time")
        class default
            call refuse_kind(name, "mdr_contact", error)
        end select
    end subroutine open_relaxing_contact

    subroutine open_contact_load(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(contact_load_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_load", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (contact_load_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_load", error)
        end select
    end subroutine open_contact_load

    subroutine open_loop(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(loop_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_loop", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (loop_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_loop", error)
        end select
    end subroutine open_loop

    subroutine open_contact_law(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(contact_law_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_law", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (contact_law_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_law", error)
        end select
    end subroutine open_contact_law

    subroutine open_friction(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(friction_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_friction", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (friction_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_friction", error)
        end select
    end subroutine open_friction

    subroutine open_first_shear(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(first_shear_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_shear", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (first_shear_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_shear", error)
        end select
    end subroutine open_first_shear

    subroutine open_friction_history(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(friction_history_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_friction_history", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (friction_history_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_friction_history", error)
        end select
    end subroutine open_friction_history

    subroutine open_rheology(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(rheology_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, "mdr_material", inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (rheology_t)
            object => inside
        class default
            call refuse_kind(name, "mdr_material", error)
        end select
    end subroutine open_rheology

end module mdrcontact_api_open_handle
