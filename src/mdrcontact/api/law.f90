! SPDX-License-Identifier: GPL-3.0-or-later
!> Compiled contact laws for C: creation, evaluation at one point, and properties.
module mdrcontact_api_law
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_loc, c_ptr, c_size_t, c_sizeof
    use mdrcontact_api_handles, only: description_of, return_object, look_inside, refuse_kind
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_options, only: check_size, read_options, write_facts
    use mdrcontact_api_records, only: c_law_facts_t, c_law_options_t
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_api_text, only: read_text
    use mdrcontact_contact, only: check_branch, contact_t, on_unloading
    use mdrcontact_error, only: count_text, error_invalid, error_t, raise
    use mdrcontact_friction_partial_slip, only: friction_t
    use mdrcontact_law, only: contact_law_t, law_point_t
    use mdrcontact_law_conducting, only: conductance_function_t, conducting_t
    use mdrcontact_law_evaluate, only: law_view_t
    use mdrcontact_law_friction, only: default_sliders, friction_law_t
    use mdrcontact_friction_law, only: new_contact_law
    use mdrcontact_law_from_contact, only: law_options_t
    use mdrcontact_law_pack, only: packed_size
    implicit none (type, external)
    private
    public :: mdr_law_new, mdrcontact_law_at_depth, mdr_law_view_of, mdr_law_buffer, mdr_law_follow, mdr_law_about

    interface
        !> The view of an open handle's law, of law_force.c.
        subroutine mdrcontact_law_view(law, branch, view) bind(C)
            import :: c_int, c_ptr, law_view_t
            type(c_ptr), intent(in), value :: law
            integer(c_int), intent(in), value :: branch
            type(law_view_t), intent(inout) :: view
        end subroutine mdrcontact_law_view
    end interface

contains

    function mdr_law_new(contact, largest_depth, options, out) result(status) bind(C, name="mdrcontact_entry_law_new")
        type(c_ptr), value :: contact, options
        real(c_double), value :: largest_depth
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(contact_t), pointer :: inside
        type(contact_law_t), allocatable :: law
        class(*), allocatable :: object
        type(c_law_options_t) :: given
        type(law_options_t) :: chosen
        type(friction_t), pointer :: friction
        type(conductance_function_t), target :: conductance
        type(error_t), allocatable :: error
        integer :: sliders

        allocate (law)
        call open_handle(contact, "contact", inside, error)
        call read_law_options(options, given, chosen, error)
        if (c_associated(given%conduction)) then
            call open_conductors(given%conduction, conductance%conductors, error)
            chosen%conductance => conductance
        end if
        sliders = merge(default_sliders, int(given%sliders), given%sliders == 0_c_int)
        if (c_associated(given%friction)) then
            call open_handle(given%friction, "options.friction", friction, error)
            if (given%shear_strength /= 0.0_c_double) then
                call raise(error, error_invalid, ": it excludes options.friction. Give one of the two", "options.shear_strength")
            end if
            if (.not. allocated(error)) then
                call new_contact_law(law, inside, friction, largest_depth, error, chosen, sliders, given%twist /= 0_c_int)
            end if
        else if (given%twist /= 0_c_int) then
            call raise(error, error_invalid, ": it needs options.friction", "options.twist")
        else if (given%shear_strength /= 0.0_c_double .and. .not. allocated(error)) then
            call new_contact_law(law, inside, largest_depth, given%shear_strength, error, chosen, sliders)
        else if (.not. allocated(error)) then
            call new_contact_law(law, inside, largest_depth, error, chosen)
        end if
        call move_alloc(law, object)
        status = return_object(object, out, error)
    end function mdr_law_new

    !> The object of options.conduction, of any extension.
    subroutine open_conductors(handle, conductors, error)
        type(c_ptr), intent(in) :: handle
        class(conducting_t), pointer, intent(out) :: conductors
        type(error_t), allocatable, intent(inout) :: error
        class(*), pointer :: inside

        nullify (conductors)
        call look_inside(handle, "options.conduction", "mdr_conduction", inside, error)
        if (allocated(error)) return
        select type (inside)
        class is (conducting_t)
            conductors => inside
        class default
            call refuse_kind("options.conduction", "mdr_conduction", error)
        end select
    end subroutine open_conductors

    !> struct mdr_law_options, or NULL: as it is, and in the core's words.
    subroutine read_law_options(options, given, chosen, error)
        type(c_ptr), intent(in) :: options
        type(c_law_options_t), intent(out), target :: given
        type(law_options_t), intent(out) :: chosen
        type(error_t), allocatable, intent(inout) :: error

        call read_options(error, "options", options, c_loc(given), c_sizeof(given))
        chosen%smallest_depth = given%smallest_depth
        if (given%tolerance /= 0.0_c_double) chosen%tolerance = given%tolerance
        chosen%continue_beyond = given%continue_beyond /= 0_c_int
        if (.not. allocated(error)) call read_text(given%description, chosen%description, error)
    end subroutine read_law_options

    !> Cases that law_force.c passes to Fortran.
    function mdrcontact_law_at_depth(law, branch, d, point) result(status) bind(C)
        type(c_ptr), value :: law
        integer(c_int), value :: branch
        real(c_double), value :: d
        type(law_point_t), intent(inout), optional :: point
        integer(c_int) :: status
        type(contact_law_t), pointer :: inside
        type(law_point_t) :: found
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        call check_given(error, "point", present(point))
        if (.not. allocated(error)) call inside%at_depth(d, found, error, int(branch))
        status = status_of(error)
        if (.not. allocated(error)) point = found
    end function mdrcontact_law_at_depth

    function mdr_law_view_of(law, branch, view) result(status) bind(C)
        type(c_ptr), value :: law
        integer(c_int), value :: branch
        type(law_view_t), intent(inout), optional :: view
        integer(c_int) :: status
        type(contact_law_t), pointer :: inside
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        call check_branch(error, int(branch))
        call check_given(error, "view", present(view))
        status = status_of(error)
        if (allocated(error)) return
        call mdrcontact_law_view(law, branch, view)
    end function mdr_law_view_of

    function mdr_law_buffer(law, size, buffer) result(status) bind(C, name="mdrcontact_entry_law_buffer")
        type(c_ptr), value :: law
        integer(c_int), value :: size
        real(c_double), intent(inout), optional :: buffer(*)
        integer(c_int) :: status
        type(contact_law_t), pointer :: inside
        type(law_view_t) :: view
        real(c_double), pointer, contiguous :: numbers(:)
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        if (.not. allocated(error)) then
            if (size < packed_size(inside%by_depth)) then
                call raise(error, error_invalid, " = "//count_text(int(size))//": the law has "// &
                           count_text(packed_size(inside%by_depth))//" numbers. Use buffer_size of mdr_law_facts", "size")
            end if
        end if
        status = status_of(error)
        if (allocated(error)) return
        call mdrcontact_law_view(law, int(on_unloading, c_int), view)
        call c_f_pointer(view%buffer, numbers, [packed_size(inside%by_depth)])
        buffer(:packed_size(inside%by_depth)) = numbers
    end function mdr_law_buffer

    function mdr_law_follow(law, d, segment, point) result(status) bind(C)
        type(c_ptr), value :: law
        real(c_double), value :: d
        integer(c_int), intent(inout), optional :: segment
        type(law_point_t), intent(inout), optional :: point
        integer(c_int) :: status
        type(contact_law_t), pointer :: inside
        type(law_point_t) :: found
        type(error_t), allocatable :: error
        integer :: place

        call open_handle(law, "law", inside, error)
        call check_given(error, "segment", present(segment))
        call check_given(error, "point", present(point))
        if (.not. allocated(error)) then
            place = segment
            call inside%follow(d, place, found, error)
        end if
        status = status_of(error)
        if (allocated(error)) return
        segment = int(place, c_int)
        point = found
    end function mdr_law_follow

    function mdr_law_about(law, facts) result(status) bind(C, name="mdrcontact_entry_law_about")
        type(c_ptr), value :: law
        type(c_ptr), value :: facts
        integer(c_int) :: status
        type(contact_law_t), pointer :: inside
        type(c_law_facts_t), target :: made
        integer(c_size_t) :: used
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        call check_size(error, "facts", facts, c_sizeof(made), used)
        status = status_of(error)
        if (allocated(error)) return
        made%size = used
        made%lowest_depth = inside%by_depth%lowest
        made%highest_depth = inside%by_depth%highest
        made%lowest_force = inside%by_force%lowest
        made%highest_force = inside%by_force%highest
        made%tolerance = inside%tolerance
        made%error = inside%error
        made%solutions = int(inside%solutions, c_int)
        made%adhesive = merge(1_c_int, 0_c_int, inside%by_depth%adhesive)
        made%segments = size(inside%by_depth%segments, kind=c_int)
        made%description = description_of(law)
        made%continue_beyond = merge(1_c_int, 0_c_int, inside%by_depth%continued)
        made%buffer_size = int(packed_size(inside%by_depth), c_int)
        made%conducts = merge(1_c_int, 0_c_int, allocated(inside%by_depth%conductance))
        if (allocated(inside%friction)) call add_friction(inside%friction, made)
        call write_facts(facts, c_loc(made), used)
    end function mdr_law_about

    !> Additional data of a law with friction.
    subroutine add_friction(friction, facts)
        type(friction_law_t), intent(in) :: friction
        type(c_law_facts_t), intent(inout) :: facts

        facts%sliders = int(friction%sliders, c_int)
        facts%memory_size = int(friction%memory_size(), c_int)
        facts%coefficient = friction%coefficient
        facts%shear_strength = friction%shear_strength
        facts%twists = merge(1_c_int, 0_c_int, friction%cubic > 0.0_c_double)
        facts%highest_sliding_shift = friction%sliding_shift()
        facts%first_shear_error = friction%first_shear_error
        facts%path_error = friction%path_error
    end subroutine add_friction

end module mdrcontact_api_law
