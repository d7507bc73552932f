! SPDX-License-Identifier: GPL-3.0-or-later
!> Opaque handles: what an `mdr_profile *`, `mdr_medium *` and so on points to, from birth to death.
!>
!> All handles are of one kind: a tag, and an object whose type identifies it. A pointer to something else is refused by its tag, a
!> handle of another object by its type. A freed handle loses its tag, which catches some uses after the end but cannot catch all.
module mdrcontact_api_handles
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_int, c_int64_t, c_intptr_t, c_loc, &
                                           c_null_char, c_null_ptr, c_ptr
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_contact, only: on_unloading
    use mdrcontact_error, only: check_memory, error_invalid, error_t, raise
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_evaluate, only: law_view_t
    use mdrcontact_law_pack, only: pack_table, packed_size
    use mdrcontact_medium, only: medium_t
    use mdrcontact_medium_solver, only: solver_t
    implicit none (type, external)
    private
    public :: description_of, return_object, return_solver, look_inside, refuse_kind
    public :: mdr_free

    integer(c_int64_t), parameter :: no_tag = 0_c_int64_t, live_tag = 7239381865347100001_c_int64_t

    ! The tag comes first: it is read before it is known that there is anything else. It, the copy and the view of a law, empty for
    ! all others, are read by law_force.c too.
    type :: handle_t
        integer(c_int64_t) :: tag = live_tag
        !> the copy of the library that made it: a process may contain several
        integer(c_intptr_t) :: copy = 0_c_intptr_t
        type(law_view_t) :: view
        class(*), allocatable :: object
        !> of a law: what the view reads
        real(c_double), allocatable :: numbers(:)
        !> and its description, with C's end
        character(kind=c_char), allocatable :: description(:)
        !> how many need the object: the caller, and the handles whose objects refer to it
        integer(c_int) :: owners = 1_c_int
        !> the handle whose object this one's refers to
        type(c_ptr) :: held = c_null_ptr
    end type handle_t

    interface
        !> Change the number of owners, see owners.c; returns the new number.
        function mdrcontact_count_owners(owners, change) result(count) bind(C)
            import :: c_int
            integer(c_int), intent(inout) :: owners
            integer(c_int), intent(in), value :: change
            integer(c_int) :: count
        end function mdrcontact_count_owners

        !> What tells this copy of the library from others in the process, see law_force.c.
        function mdrcontact_this_copy() result(copy) bind(C)
            import :: c_intptr_t
            integer(c_intptr_t) :: copy
        end function mdrcontact_this_copy

        !> Create a view of a law, see law_force.c; returns 0.
        function mdrcontact_law_view_from(buffer, branch, view) result(status) bind(C)
            import :: c_double, c_int, law_view_t
            real(c_double), intent(in) :: buffer(*)
            integer(c_int), intent(in), value :: branch
            type(law_view_t), intent(inout) :: view
            integer(c_int) :: status
        end function mdrcontact_law_view_from
    end interface

contains

    !> Puts a finished object behind a new handle, and the handle into `out`, unless there was an error. Its arrays, which may be
    !> large, are not copied: gfortran ends the process where there is no memory for the copy of a component.
    function return_object(object, out, error, held) result(status)
        class(*), allocatable, intent(inout) :: object
        type(c_ptr), intent(inout) :: out
        type(error_t), allocatable, intent(inout) :: error
        !> an open handle whose object the new one refers to: it lasts as long
        type(c_ptr), intent(in), optional :: held
        integer(c_int) :: status
        type(handle_t), pointer :: inside, other
        integer(c_int) :: unused
        integer :: stat

        nullify (inside)
        if (.not. allocated(error)) then
            allocate (inside, stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) then
            inside%copy = mdrcontact_this_copy()
            call move_alloc(object, inside%object)
            select type (law => inside%object)
            type is (contact_law_t)
                call add_view(law, inside, error)
            end select
            if (allocated(error)) deallocate (inside)
        end if
        status = status_of(error)
        if (allocated(error)) return
        if (present(held)) then
            call c_f_pointer(held, other)
            unused = mdrcontact_count_owners(other%owners, 1_c_int)
            inside%held = held
        end if
        out = c_loc(inside)
    end function return_object

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

    !> Puts a solver behind the handle of a medium.
    function return_solver(solver, out, error) result(status)
        class(solver_t), allocatable, intent(inout) :: solver
        type(c_ptr), intent(inout) :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        type(medium_t), allocatable :: medium
        class(*), allocatable :: object

        allocate (medium)
        call move_alloc(solver, medium%solver)
        call move_alloc(medium, object)
        status = return_object(object, out, error)
    end function return_solver

    !> Free an object of any kind.
    function mdr_free(handle) result(status) bind(C)
        type(c_ptr), value :: handle
        integer(c_int) :: status
        type(handle_t), pointer :: inside
        type(error_t), allocatable :: error

        status = status_of(error)
        if (.not. c_associated(handle)) return
        call c_f_pointer(handle, inside)
        if (inside%tag /= live_tag) then
            call raise(error, error_invalid, ": it is not a handle, or it has been freed", "handle")
        else
            call check_copy(inside, "handle", error)
        end if
        status = status_of(error)
        if (allocated(error)) return
        inside%tag = no_tag
        inside%view = law_view_t()
        call let_go(inside)
    end function mdr_free

    !> Frees an object that nothing needs any more, and then lets go of the one that it refers to.
    recursive subroutine let_go(inside)
        type(handle_t), pointer, intent(inout) :: inside
        type(handle_t), pointer :: other

        if (mdrcontact_count_owners(inside%owners, -1_c_int) > 0_c_int) return
        nullify (other)
        if (c_associated(inside%held)) call c_f_pointer(inside%held, other)
        deallocate (inside)
        if (associated(other)) call let_go(other)
    end subroutine let_go

    !> The object behind a handle that `word`, the name of its kind in C, represents; null after an error. Which type it has is not
    !> considered. `name` is the argument's.
    subroutine look_inside(handle, name, word, object, error)
        type(c_ptr), intent(in) :: handle
        character(len=*), intent(in) :: name, word
        class(*), pointer, intent(out) :: object
        type(error_t), allocatable, intent(inout) :: error
        type(handle_t), pointer :: inside

        nullify (object)
        call check_given(error, name, c_associated(handle))
        if (allocated(error)) return
        call c_f_pointer(handle, inside)
        if (inside%tag == live_tag) then
            call check_copy(inside, name, error)
            if (.not. allocated(error)) object => inside%object
        else
            call refuse_kind(name, word, error)
        end if
    end subroutine look_inside

    !> Raises for a handle of another copy of the library, which may be of another version.
    subroutine check_copy(inside, name, error)
        type(handle_t), intent(in) :: inside
        character(len=*), intent(in) :: name
        type(error_t), allocatable, intent(inout) :: error

        if (inside%copy == mdrcontact_this_copy()) return
        call raise(error, error_invalid, ": another copy of the library in this process made it. Use the functions of that copy", &
                   name)
    end subroutine check_copy

    !> Raises for a handle of another kind than `word`.
    subroutine refuse_kind(name, word, error)
        character(len=*), intent(in) :: name, word
        type(error_t), allocatable, intent(inout) :: error

        call raise(error, error_invalid, ": it is not a handle of type "//word//", or it has been freed", name)
    end subroutine refuse_kind

end module mdrcontact_api_handles
