! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of plastic that convert, call and deliver, for C. Written by tools/generate.py.
module mdrcontact_api_plastic_entries
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_results, make_room
    use mdrcontact_api_handles, only: return_object
    use mdrcontact_api_plastic_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of
    use mdrcontact_contact, only: contact_t
    use mdrcontact_error, only: check_count_from, check_memory, error_t
    use mdrcontact_medium, only: medium_t
    use mdrcontact_plastic_cap, only: cap_state_t, cap_t, new_cap, truncated_hertz
    use mdrcontact_plastic_imprint, only: imprint_t, new_imprint, new_imprint_from_pressure, new_imprint_of_two_terms
    use mdrcontact_plastic_law, only: plastic_law_t
    use mdrcontact_plastic_law_new, only: with_radius
    use mdrcontact_plastic_overload, only: new_overload, overload_state_t, overload_t
    use mdrcontact_plastic_profile, only: imprint_profile_t
    implicit none (type, external)
    private
    public :: mdr_imprint_new
    public :: mdr_imprint_two_terms
    public :: mdr_imprint_from_pressure
    public :: mdr_imprint_profile
    public :: mdr_plastic_law_with_radius
    public :: mdr_overload_new
    public :: mdr_overload_states
    public :: mdr_cap_new
    public :: mdr_cap_states
    public :: mdr_cap_pressure
    public :: mdr_truncated_hertz

contains

    function mdr_imprint_new(medium, radius, force, residual_depth, depth, out) result(status) &
        bind(C, name="mdrcontact_entry_imprint_new")
        type(c_ptr), value :: medium
        real(c_double), value :: radius, force, residual_depth, depth
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(imprint_t), allocatable :: made
        class(*), allocatable :: object
        type(medium_t), pointer :: medium_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(medium, "medium", medium_inside, error)
        if (.not. allocated(error)) call new_imprint(made, medium_inside, radius, force, residual_depth, depth, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_imprint_new

    function mdr_imprint_two_terms(medium, radius, uniform, hertz, depth, out) result(status) &
        bind(C, name="mdrcontact_entry_imprint_two_terms")
        type(c_ptr), value :: medium
        real(c_double), value :: radius, uniform, hertz, depth
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(imprint_t), allocatable :: made
        class(*), allocatable :: object
        type(medium_t), pointer :: medium_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(medium, "medium", medium_inside, error)
        if (.not. allocated(error)) call new_imprint_of_two_terms(made, medium_inside, radius, uniform, hertz, depth, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_imprint_two_terms

    function mdr_imprint_from_pressure(medium, n, r, p, depth, out) result(status) &
        bind(C, name="mdrcontact_entry_imprint_from_pressure")
        type(c_ptr), value :: medium
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*), p(*)
        real(c_double), value :: depth
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(imprint_t), allocatable :: made
        class(*), allocatable :: object
        type(medium_t), pointer :: medium_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(medium, "medium", medium_inside, error)
        if (.not. allocated(error)) call check_count_from(error, "n", n, 1)
        if (.not. allocated(error) .and. n > 0) call new_imprint_from_pressure(made, medium_inside, r(:n), p(:n), depth, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_imprint_from_pressure

    function mdr_imprint_profile(i, out) result(status) &
        bind(C, name="mdrcontact_entry_imprint_profile")
        type(c_ptr), value :: i
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(imprint_profile_t), allocatable :: made
        class(*), allocatable :: object
        type(imprint_t), pointer :: i_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(i, "i", i_inside, error)
        if (.not. allocated(error)) made = i_inside%profile
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_imprint_profile

    function mdr_plastic_law_with_radius(law, radius, out) result(status) &
        bind(C, name="mdrcontact_entry_plastic_law_with_radius")
        type(c_ptr), value :: law
        real(c_double), value :: radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(plastic_law_t), allocatable :: made
        class(*), allocatable :: object
        type(plastic_law_t), pointer :: law_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(law, "law", law_inside, error)
        if (.not. allocated(error)) call with_radius(law_inside, radius, made, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_plastic_law_with_radius

    function mdr_overload_new(c, n, yield_stress, out) result(status) &
        bind(C, name="mdrcontact_entry_overload_new")
        type(c_ptr), value :: c
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: yield_stress(*)
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(overload_t), allocatable :: made
        class(*), allocatable :: object
        type(contact_t), pointer :: c_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(c, "c", c_inside, error)
        if (.not. allocated(error)) call check_count_from(error, "n", n, 1)
        if (.not. allocated(error) .and. n > 0) call new_overload(made, c_inside, yield_stress(:n), error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_overload_new

    function mdr_overload_states(rule, given, n, value, out) result(status) &
        bind(C, name="mdrcontact_entry_overload_states")
        type(c_ptr), value :: rule
        integer(c_int), value :: given, n
        real(c_double), intent(in), optional :: value(*)
        type(overload_state_t), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(overload_t), pointer :: rule_inside
        type(overload_state_t), allocatable :: out_values(:)
        integer :: stat
        type(error_t), allocatable :: error

        call open_handle(rule, "rule", rule_inside, error)
        if (.not. allocated(error)) then
            allocate (out_values(n), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error) .and. n > 0) call rule_inside%states(given, value(:n), out_values, error)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_overload_states

    function mdr_cap_new(c, hardness, out) result(status) &
        bind(C, name="mdrcontact_entry_cap_new")
        type(c_ptr), value :: c
        real(c_double), value :: hardness
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(cap_t), allocatable :: made
        class(*), allocatable :: object
        type(contact_t), pointer :: c_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(c, "c", c_inside, error)
        if (.not. allocated(error)) call new_cap(made, c_inside, hardness, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_cap_new

    function mdr_cap_states(cap, given, n, value, out) result(status) &
        bind(C, name="mdrcontact_entry_cap_states")
        type(c_ptr), value :: cap
        integer(c_int), value :: given, n
        real(c_double), intent(in), optional :: value(*)
        type(cap_state_t), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(cap_t), pointer :: cap_inside
        type(cap_state_t), allocatable :: out_values(:)
        integer :: stat
        type(error_t), allocatable :: error

        call open_handle(cap, "cap", cap_inside, error)
        if (.not. allocated(error)) then
            allocate (out_values(n), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error) .and. n > 0) call cap_inside%states(given, value(:n), out_values, error)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_cap_states

    function mdr_cap_pressure(cap, radius, n, r, pressure, residual) result(status) &
        bind(C, name="mdrcontact_entry_cap_pressure")
        type(c_ptr), value :: cap
        real(c_double), value :: radius
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: pressure(*), residual(*)
        integer(c_int) :: status
        type(cap_t), pointer :: cap_inside
        real(c_double), allocatable :: pressure_values(:), residual_values(:)
        type(error_t), allocatable :: error

        call open_handle(cap, "cap", cap_inside, error)
        call make_room(error, n, pressure_values)
        call make_room(error, n, residual_values)
        if (.not. allocated(error) .and. n > 0) call cap_inside%pressure_at(radius, r(:n), pressure_values, residual_values, &
            error)
        if (.not. allocated(error)) call check_results(error, pressure_values)
        if (.not. allocated(error)) call check_results(error, residual_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(pressure)) pressure(:n) = pressure_values
        if (present(residual)) residual(:n) = residual_values
    end function mdr_cap_pressure

    function mdr_truncated_hertz(a, largest, hardness, n, x, out) result(status) &
        bind(C, name="mdrcontact_entry_truncated_hertz")
        real(c_double), value :: a, largest, hardness
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        real(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) call truncated_hertz(a, largest, hardness, x(:n), out_values, error)
        if (.not. allocated(error)) call check_results(error, out_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_truncated_hertz

end module mdrcontact_api_plastic_entries
