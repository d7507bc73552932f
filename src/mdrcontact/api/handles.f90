! SPDX-License-Identifier: GPL-3.0-or-later
!> Opaque handles: what an `mdr_profile *`, `mdr_medium *` and so on points to, from birth to death.
!>
!> All handles are of one kind: a tag, and an object whose type says what it is. A pointer to something else is refused by its tag,
!> a handle of another object by its type. A freed handle loses its tag, which catches some uses after the end but cannot catch all.
module mdrcontact_api_handles
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_int, c_int64_t, c_loc, c_null_char, c_ptr
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_contact, only: contact_t, on_unloading
    use mdrcontact_contact_loop, only: loop_t
    use mdrcontact_error, only: check_memory, error_invalid, error_t, raise
    use mdrcontact_history_friction, only: first_shear_t, friction_t
    use mdrcontact_history_friction_history, only: friction_history_t
    use mdrcontact_history_rate_contact, only: rate_contact_t
    use mdrcontact_history_relaxing_contact, only: relaxing_contact_t
    use mdrcontact_lateral_structure, only: structure_t
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_evaluate, only: law_view_t
    use mdrcontact_law_pack, only: pack_table, packed_size
    use mdrcontact_material_rheology, only: rheology_t
    use mdrcontact_medium, only: medium_t, refuse_states
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_conduction_bodies, only: conduction_t
    use mdrcontact_poroelastic_table, only: poroelastic_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_wear, only: wear_t
    use mdrcontact_wear_history, only: wear_history_t
    implicit none (type, external)
    private
    public :: deliver, description_of, deliver_solver, hand_over, hand_over_solver, open_handle
    public :: mdr_free

    integer(c_int64_t), parameter :: no_tag = 0_c_int64_t, live_tag = 7239381865347100001_c_int64_t

    ! The tag comes first: it is read before it is known that there is anything else. It and the view of a law, empty for all
    ! others, are read by law_force.c too.
    type :: handle_t
        integer(c_int64_t) :: tag = live_tag
        type(law_view_t) :: view
        class(*), allocatable :: object
        !> of a law: what the view reads
        real(c_double), allocatable :: numbers(:)
        !> and its description, with C's end
        character(kind=c_char), allocatable :: description(:)
    end type handle_t

    interface
        !> Of law_force.c; 0.
        function mdrcontact_law_view_from(buffer, branch, view) result(status) bind(C)
            import :: c_double, c_int, law_view_t
            real(c_double), intent(in) :: buffer(*)
            integer(c_int), intent(in), value :: branch
            type(law_view_t), intent(inout) :: view
            integer(c_int) :: status
        end function mdrcontact_law_view_from
    end interface

    integer, parameter :: is_other = 0, is_profile = 1, is_medium = 2, is_contact = 3, is_loop = 4, is_structure = 5, is_law = 6, &
                          is_friction = 7, is_material = 8, is_friction_history = 9, is_poroelastic = 10, is_conduction = 11, &
                          is_rate = 12, is_wear = 13, is_wear_history = 14, is_shear = 15
    character(len=*), parameter :: kinds(*) = [character(len=20) :: "mdr_profile", "mdr_medium", "mdr_contact", "mdr_loop", &
                                               "mdr_structure", "mdr_law", "mdr_friction", "mdr_material", &
                                               "mdr_friction_history", "mdr_poroelastic", "mdr_conduction", "mdr_rate", &
                                               "mdr_wear", "mdr_wear_history", "mdr_shear"]

    !> The object behind a handle, by the type of the pointer that is to hold it; null after an error. `name` is the argument's.
    interface open_handle
        module procedure open_profile, open_medium, open_contact, open_loop, open_structure, open_law, open_friction, &
                         open_material, open_friction_history, open_relaxing_contact, open_poroelastic, open_conduction, &
                         open_rate, open_wear, open_wear_history, open_shear
    end interface open_handle

contains

    !> Puts a copy of a finished object of few numbers behind a new handle, and the handle into `out`, unless there was an error.
    function deliver(object, out, error) result(status)
        class(*), intent(in) :: object
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        class(*), allocatable :: copy
        integer :: stat

        if (.not. allocated(error)) then
            allocate (copy, source=object, stat=stat)
            call check_memory(error, stat)
        end if
        status = hand_over(copy, out, error)
    end function deliver

    !> The same with the object itself, whose arrays may be large: they are not copied, since gfortran ends the process where there
    !> is no memory for the copy of a component.
    function hand_over(object, out, error) result(status)
        class(*), allocatable, intent(inout) :: object
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        type(handle_t), pointer :: inside
        integer :: stat

        nullify (inside)
        call check_given(error, "out", present(out))
        if (.not. allocated(error)) then
            allocate (inside, stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) then
            call move_alloc(object, inside%object)
            select type (law => inside%object)
            type is (contact_law_t)
                call add_view(law, inside, error)
            end select
            if (allocated(error)) deallocate (inside)
        end if
        status = status_of(error)
        if (.not. allocated(error)) out = c_loc(inside)
    end function hand_over

    !> The numbers of a law, and the view of them.
    subroutine add_view(law, inside, error)
        type(contact_law_t), intent(in) :: law
        type(handle_t), intent(inout) :: inside
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, stat, unused

        allocate (inside%numbers(packed_size(law%by_depth)), inside%description(len(law%description) + 1), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do i = 1, len(law%description)
            inside%description(i) = law%description(i:i)
        end do
        inside%description(len(law%description) + 1) = c_null_char
        call pack_table(law%by_depth, inside%numbers)
        unused = mdrcontact_law_view_from(inside%numbers, int(on_unloading, c_int), inside%view)
    end subroutine add_view

    !> The description of the law behind an open handle.
    function description_of(handle) result(description)
        type(c_ptr), intent(in) :: handle
        type(c_ptr) :: description
        type(handle_t), pointer :: inside

        call c_f_pointer(handle, inside)
        description = c_loc(inside%description)
    end function description_of

    !> Puts a copy of a solver of few numbers behind the handle of a medium.
    function deliver_solver(solver, out, error) result(status)
        class(solver_t), intent(in) :: solver
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        class(solver_t), allocatable :: copy
        integer :: stat

        if (.not. allocated(error)) then
            allocate (copy, source=solver, stat=stat)
            call check_memory(error, stat)
        end if
        status = hand_over_solver(copy, out, error)
    end function deliver_solver

    !> The same with the solver itself.
    function hand_over_solver(solver, out, error) result(status)
        class(solver_t), allocatable, intent(inout) :: solver
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        type(medium_t), allocatable :: medium
        class(*), allocatable :: object

        allocate (medium)
        call move_alloc(solver, medium%solver)
        call move_alloc(medium, object)
        status = hand_over(object, out, error)
    end function hand_over_solver

    subroutine open_profile(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        class(profile_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_profile, inside, error)
        if (allocated(error)) return
        select type (inside)
        class is (profile_t)
            object => inside
        end select
    end subroutine open_profile

    subroutine open_medium(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(medium_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_medium, inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (medium_t)
            object => inside
        end select
    end subroutine open_medium

    subroutine open_contact(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(contact_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_contact, inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (contact_t)
            object => inside
        class default
            call refuse_states(error)
        end select
    end subroutine open_contact

    subroutine open_relaxing_contact(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(relaxing_contact_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_contact, inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (relaxing_contact_t)
            object => inside
        class default
            call raise(error, error_invalid, "the body is elastic: its states do not depend on time")
        end select
    end subroutine open_relaxing_contact

    subroutine open_loop(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(loop_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_loop, inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (loop_t)
            object => inside
        end select
    end subroutine open_loop

    subroutine open_structure(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        class(structure_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_structure, inside, error)
        if (allocated(error)) return
        select type (inside)
        class is (structure_t)
            object => inside
        end select
    end subroutine open_structure

    subroutine open_law(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(contact_law_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_law, inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (contact_law_t)
            object => inside
        end select
    end subroutine open_law

    subroutine open_friction(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(friction_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_friction, inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (friction_t)
            object => inside
        end select
    end subroutine open_friction

    subroutine open_material(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(rheology_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_material, inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (rheology_t)
            object => inside
        end select
    end subroutine open_material

    subroutine open_friction_history(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(friction_history_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_friction_history, inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (friction_history_t)
            object => inside
        end select
    end subroutine open_friction_history

    subroutine open_shear(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(first_shear_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_shear, inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (first_shear_t)
            object => inside
        end select
    end subroutine open_shear

    subroutine open_wear(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(wear_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_wear, inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (wear_t)
            object => inside
        end select
    end subroutine open_wear

    subroutine open_wear_history(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(wear_history_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_wear_history, inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (wear_history_t)
            object => inside
        end select
    end subroutine open_wear_history

    subroutine open_poroelastic(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(poroelastic_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_poroelastic, inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (poroelastic_t)
            object => inside
        end select
    end subroutine open_poroelastic

    subroutine open_conduction(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(conduction_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_conduction, inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (conduction_t)
            object => inside
        end select
    end subroutine open_conduction

    subroutine open_rate(handle, name, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        type(rate_contact_t), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (object)
        call look_inside(handle, name, is_rate, inside, error)
        if (allocated(error)) return
        select type (inside)
        type is (rate_contact_t)
            object => inside
        end select
    end subroutine open_rate

    !> Frees what there is, of any kind.
    function mdr_free(handle) result(status) bind(C)
        type(c_ptr), value :: handle
        integer(c_int) :: status
        type(handle_t), pointer :: inside
        type(error_t), allocatable :: error

        status = status_of(error)
        if (.not. c_associated(handle)) return
        call c_f_pointer(handle, inside)
        if (inside%tag /= live_tag) then
            call raise(error, error_invalid, " is none, or it has been freed", "the handle to free")
            status = status_of(error)
            return
        end if
        inside%tag = no_tag
        inside%view = law_view_t()
        deallocate (inside)
    end function mdr_free

    !> What a handle of the given kind holds.
    subroutine look_inside(handle, name, kind, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name
        integer, intent(in) :: kind
        class(*), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        type(handle_t), pointer :: inside

        nullify (object)
        call check_given(error, name, c_associated(handle))
        if (allocated(error)) return
        call c_f_pointer(handle, inside)
        if (inside%tag == live_tag) then
            if (kind_of(inside%object) == kind) object => inside%object
        end if
        if (.not. associated(object)) then
            call raise(error, error_invalid, " is not an "//trim(kinds(kind))//" handle, or it has been freed", name)
        end if
    end subroutine look_inside

    pure function kind_of(object) result(kind)
        class(*), intent(in) :: object
        integer :: kind

        select type (object)
        type is (contact_law_t)
            kind = is_law
        type is (contact_t)
            kind = is_contact
        type is (relaxing_contact_t)
            kind = is_contact
        type is (loop_t)
            kind = is_loop
        type is (friction_t)
            kind = is_friction
        type is (friction_history_t)
            kind = is_friction_history
        type is (first_shear_t)
            kind = is_shear
        type is (wear_t)
            kind = is_wear
        type is (wear_history_t)
            kind = is_wear_history
        type is (rheology_t)
            kind = is_material
        type is (poroelastic_t)
            kind = is_poroelastic
        type is (conduction_t)
            kind = is_conduction
        type is (rate_contact_t)
            kind = is_rate
        class is (profile_t)
            kind = is_profile
        type is (medium_t)
            kind = is_medium
        class is (structure_t)
            kind = is_structure
        class default
            kind = is_other
        end select
    end function kind_of

end module mdrcontact_api_handles
