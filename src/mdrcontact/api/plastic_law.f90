! SPDX-License-Identifier: GPL-3.0-or-later
!> Laws of contacts that yield, for C.
module mdrcontact_api_plastic_law
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_loc, c_ptr, c_size_t, c_sizeof
    use mdrcontact_api_handles, only: return_object
    use mdrcontact_api_options, only: check_size, read_options, write_facts
    use mdrcontact_api_plastic_open_handle, only: open_handle
    use mdrcontact_api_records, only: c_plastic_law_facts_t, c_plastic_law_options_t
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_error, only: check_memory, count_text, error_invalid, error_t, raise, raise_at
    use mdrcontact_material, only: material_t, new_material
    use mdrcontact_plastic_law, only: plastic_law_t, plastic_steps_t
    use mdrcontact_plastic_law_coated, only: new_plastic_law_from_overload
    use mdrcontact_plastic_law_new, only: new_plastic_law, new_plastic_law_from_points, plastic_options_t
    use mdrcontact_plastic_overload, only: overload_t
    use mdrcontact_plastic_yielding, only: new_elastic, new_yielding, yield_stress_from_hardness, yielding_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: mdr_yielding_new, mdr_yield_stress_from_hardness, mdr_plastic_law_new, mdr_plastic_law_from_points, &
              mdr_plastic_law_from_overload, &
              mdr_plastic_law_about, mdr_plastic_law_advance, mdr_plastic_law_energies, mdr_plastic_law_loading, &
              mdr_plastic_law_restitution, mdr_plastic_law_buffer

contains

    function mdr_yielding_new(e, nu, n, strain, yield_stress, out) result(status) bind(C, name="mdrcontact_entry_yielding_new")
        real(c_double), value :: e, nu
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: strain(n), yield_stress(n)
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(material_t) :: material
        type(yielding_t), allocatable :: made
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call new_material(material, e, nu, error)
        if (allocated(error)) then
            continue
        else if (present(yield_stress)) then
            call new_yielding(made, material, strain, yield_stress, error)
        else
            call new_elastic(made, material, error)
        end if
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_yielding_new

    function mdr_yield_stress_from_hardness(e, nu, hardness, radius_ratio, yield_stress, error) result(status) &
        bind(C, name="mdrcontact_entry_yield_stress_from_hardness")
        real(c_double), value :: e, nu, hardness, radius_ratio
        real(c_double), intent(inout), optional :: yield_stress, error
        integer(c_int) :: status
        type(material_t) :: material
        real(c_double) :: stress, uncertain
        type(error_t), allocatable :: failure

        call new_material(material, e, nu, failure)
        if (.not. allocated(failure)) then
            call yield_stress_from_hardness(material, hardness, radius_ratio, stress, uncertain, failure)
        end if
        status = status_of(failure)
        if (allocated(failure)) return
        yield_stress = stress
        error = uncertain
    end function mdr_yield_stress_from_hardness

    function mdr_plastic_law_new(profile, metal, largest_depth, options, out) result(status) &
        bind(C, name="mdrcontact_entry_plastic_law_new")
        type(c_ptr), value :: profile, metal, options
        real(c_double), value :: largest_depth
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        class(profile_t), pointer :: indenter
        type(yielding_t), pointer :: body
        type(plastic_options_t) :: chosen
        type(plastic_law_t), allocatable :: law
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (law)
        call open_handle(profile, "profile", indenter, error)
        call open_handle(metal, "metal", body, error)
        call read_law_options(options, chosen, error)
        if (.not. allocated(error)) call new_plastic_law(law, indenter, body, largest_depth, error, chosen)
        call move_alloc(law, object)
        status = return_object(object, out, error)
    end function mdr_plastic_law_new

    function mdr_plastic_law_from_points(n, d, force, a, residual, modulus, options, out) result(status) &
        bind(C, name="mdrcontact_entry_plastic_law_from_points")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: d(n), force(n), a(n), residual(n), modulus(n)
        type(c_ptr), value :: options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(plastic_options_t) :: chosen
        type(plastic_law_t), allocatable :: law
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (law)
        call read_law_options(options, chosen, error)
        if (n == 0) call raise(error, error_invalid, "d: the array is empty. Give at least 3 points")
        if (.not. allocated(error)) call new_plastic_law_from_points(law, d, force, a, residual, modulus, error, chosen)
        call move_alloc(law, object)
        status = return_object(object, out, error)
    end function mdr_plastic_law_from_points

    function mdr_plastic_law_from_overload(rule, largest_depth, options, out) result(status) &
        bind(C, name="mdrcontact_entry_plastic_law_from_overload")
        type(c_ptr), value :: rule, options
        real(c_double), value :: largest_depth
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(overload_t), pointer :: inside
        type(plastic_options_t) :: chosen
        type(plastic_law_t), allocatable :: law
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (law)
        call open_handle(rule, "rule", inside, error)
        call read_law_options(options, chosen, error)
        if (.not. allocated(error)) call new_plastic_law_from_overload(law, inside, largest_depth, error, chosen)
        call move_alloc(law, object)
        status = return_object(object, out, error)
    end function mdr_plastic_law_from_overload

    !> struct mdr_plastic_law_options, or NULL, in the core's words.
    subroutine read_law_options(options, chosen, error)
        type(c_ptr), intent(in) :: options
        type(plastic_options_t), intent(out) :: chosen
        type(error_t), allocatable, intent(inout) :: error
        type(c_plastic_law_options_t), target :: given
        type(yielding_t), pointer :: other

        call read_options(error, "options", options, c_loc(given), c_sizeof(given))
        if (allocated(error)) return
        chosen%work_of_adhesion = given%work_of_adhesion
        if (given%tolerance /= 0.0_c_double) chosen%tolerance = given%tolerance
        if (.not. c_associated(given%other)) return
        call open_handle(given%other, "options.other", other, error)
        if (.not. allocated(error)) chosen%other = other
    end subroutine read_law_options

    function mdr_plastic_law_about(law, facts) result(status) bind(C, name="mdrcontact_entry_plastic_law_about")
        type(c_ptr), value :: law, facts
        integer(c_int) :: status
        type(plastic_law_t), pointer :: inside
        type(c_plastic_law_facts_t), target :: made
        integer(c_size_t) :: used
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        call check_size(error, "facts", facts, c_sizeof(made), used)
        status = status_of(error)
        if (allocated(error)) return
        made%size = used
        made%yield_depth = inside%yield_depth
        made%yield_force = inside%yield_force
        made%first_yield = inside%first_yield
        made%largest_depth = inside%largest_depth
        made%largest_force = inside%largest_force
        made%largest_radius = inside%largest_radius
        made%radius = inside%radius
        made%modulus = inside%modulus
        made%work_of_adhesion = inside%work_of_adhesion
        made%tolerance = inside%tolerance
        made%error = inside%error
        made%memory_size = int(inside%memory_size(), c_int)
        made%buffer_size = size(inside%buffer, kind=c_int)
        call write_facts(facts, c_loc(made), used)
    end function mdr_plastic_law_about

    function mdr_plastic_law_advance(law, n, d, is_trial, memory, force, slope, a) result(status) &
        bind(C, name="mdrcontact_entry_plastic_law_advance")
        type(c_ptr), value :: law, memory, force, slope, a
        integer(c_int), value :: n, is_trial
        real(c_double), intent(in), optional, target :: d(n)
        integer(c_int) :: status
        type(plastic_law_t), pointer :: inside
        type(plastic_steps_t) :: steps
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        if (.not. allocated(error) .and. n > 0) then
            call c_f_pointer(c_loc(d), steps%depth, [int(n)])
            call c_f_pointer(memory, steps%memory, [inside%memory_size(), int(n)])
            if (c_associated(force)) call c_f_pointer(force, steps%force, [int(n)])
            if (c_associated(slope)) call c_f_pointer(slope, steps%slope, [int(n)])
            if (c_associated(a)) call c_f_pointer(a, steps%radius, [int(n)])
            steps%is_trial = is_trial /= 0_c_int
            call inside%steps(steps, wanted_threads(), error)
        end if
        status = status_of(error)
    end function mdr_plastic_law_advance

    function mdr_plastic_law_energies(law, n, d, memory, stored, dissipated) result(status) &
        bind(C, name="mdrcontact_entry_plastic_law_energies")
        type(c_ptr), value :: law, memory
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: d(n)
        real(c_double), intent(inout), optional :: stored(n), dissipated(n)
        integer(c_int) :: status
        type(plastic_law_t), pointer :: inside
        real(c_double), pointer, contiguous :: records(:, :)
        real(c_double), allocatable :: kept(:), lost(:)
        type(error_t), allocatable :: error
        integer :: stat

        call open_handle(law, "law", inside, error)
        if (.not. allocated(error) .and. n > 0) then
            call c_f_pointer(memory, records, [inside%memory_size(), int(n)])
            allocate (kept(n), lost(n), stat=stat)
            call check_memory(error, stat)
            if (.not. allocated(error)) call inside%energies(d, records, kept, lost, error)
            if (.not. allocated(error)) then
                stored(:) = kept
                dissipated(:) = lost
            end if
        end if
        status = status_of(error)
    end function mdr_plastic_law_energies

    function mdr_plastic_law_loading(law, n, d, force, a, residual, work) result(status) &
        bind(C, name="mdrcontact_entry_plastic_law_loading")
        type(c_ptr), value :: law
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: d(n)
        real(c_double), intent(inout), optional :: force(n), a(n), residual(n), work(n)
        integer(c_int) :: status
        type(plastic_law_t), pointer :: inside
        real(c_double), allocatable :: found(:, :)
        type(error_t), allocatable :: error
        integer :: i, stat

        call open_handle(law, "law", inside, error)
        allocate (found(4, max(n, 0_c_int)), stat=stat)
        call check_memory(error, stat)
        do i = 1, n
            if (allocated(error)) exit
            call inside%first_loading(d(i), found(1, i), found(2, i), found(3, i), found(4, i), error)
            if (allocated(error)) call raise_at(error, i)
        end do
        status = status_of(error)
        if (allocated(error)) return
        if (present(force)) force(:) = found(1, :)
        if (present(a)) a(:) = found(2, :)
        if (present(residual)) residual(:) = found(3, :)
        if (present(work)) work(:) = found(4, :)
    end function mdr_plastic_law_loading

    function mdr_plastic_law_restitution(law, mass, n, speed, e) result(status) &
        bind(C, name="mdrcontact_entry_plastic_law_restitution")
        type(c_ptr), value :: law
        real(c_double), value :: mass
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: speed(n)
        real(c_double), intent(inout), optional :: e(n)
        integer(c_int) :: status
        type(plastic_law_t), pointer :: inside
        real(c_double), allocatable :: found(:)
        type(error_t), allocatable :: error
        integer :: i, stat

        call open_handle(law, "law", inside, error)
        allocate (found(max(n, 0_c_int)), stat=stat)
        call check_memory(error, stat)
        do i = 1, n
            if (allocated(error)) exit
            call inside%restitution(mass, speed(i), found(i), error)
            if (allocated(error)) then
                if (error%argument == "speed") call raise_at(error, i)
            end if
        end do
        status = status_of(error)
        if (allocated(error) .or. n < 1) return
        e(:) = found
    end function mdr_plastic_law_restitution

    function mdr_plastic_law_buffer(law, size, buffer) result(status) bind(C, name="mdrcontact_entry_plastic_law_buffer")
        type(c_ptr), value :: law
        integer(c_int), value :: size
        real(c_double), intent(inout), optional :: buffer(*)
        integer(c_int) :: status
        type(plastic_law_t), pointer :: inside
        type(error_t), allocatable :: error
        integer :: count

        call open_handle(law, "law", inside, error)
        if (.not. allocated(error)) then
            count = ubound(inside%buffer, 1)
            if (size < count) then
                call raise(error, error_invalid, " = "//count_text(int(size))//": the law has "//count_text(count)// &
                           " numbers. Use buffer_size of mdr_plastic_law_facts", "size")
            end if
        end if
        status = status_of(error)
        if (.not. allocated(error)) buffer(:count) = inside%buffer
    end function mdr_plastic_law_buffer

end module mdrcontact_api_plastic_law
