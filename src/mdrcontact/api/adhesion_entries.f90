! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of adhesion that convert, call and deliver, for C. Written by tools/generate.py.
module mdrcontact_api_adhesion_entries
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_adhesion_cohesive_history, only: cohesive_columns, cohesive_history
    use mdrcontact_adhesion_rate_contact, only: new_rate_contact, rate_contact_t
    use mdrcontact_adhesion_rate_history, only: columns, rate_history
    use mdrcontact_adhesion_rate_law, only: rate_law_t
    use mdrcontact_adhesion_rate_state, only: rate_state_t
    use mdrcontact_api_adhesion_open_handle, only: open_handle
    use mdrcontact_api_adhesion_rate, only: read_law
    use mdrcontact_api_arrays, only: check_each_finite, check_results, make_room
    use mdrcontact_api_handles, only: return_object
    use mdrcontact_api_loop, only: choose_control
    use mdrcontact_api_records, only: c_rate_options_t
    use mdrcontact_api_status, only: status_of
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_contact_relaxing_contact, only: relaxing_contact_t
    use mdrcontact_error, only: check_memory, error_invalid, error_t, raise, to_text
    implicit none (type, external)
    private
    public :: mdr_rate_new
    public :: mdr_rate_work
    public :: mdr_rate_history
    public :: mdr_contact_adhesive_history

contains

    function mdr_rate_new(c, options, out) result(status) &
        bind(C, name="mdrcontact_entry_rate_new")
        type(c_ptr), value :: c, options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(rate_contact_t), allocatable :: made
        class(*), allocatable :: object
        type(contact_t), pointer :: c_inside
        type(c_rate_options_t) :: given
        type(rate_law_t) :: law
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(c, "c", c_inside, error)
        if (.not. allocated(error)) call read_law(options, given, law, error)
        if (.not. allocated(error)) call new_rate_contact(made, c_inside, law, given%largest_radius, error, given%smallest_radius)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_rate_new

    function mdr_rate_work(options, n, v, out, time, zone) result(status) &
        bind(C, name="mdrcontact_entry_rate_work")
        type(c_ptr), value :: options
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: v(*)
        real(c_double), intent(inout), optional :: out(*), time, zone
        integer(c_int) :: status
        type(c_rate_options_t) :: given
        type(rate_law_t) :: law
        real(c_double), allocatable :: out_values(:)
        real(c_double) :: time_value, zone_value
        type(error_t), allocatable :: error

        call read_law(options, given, law, error)
        if (.not. allocated(error) .and. n > 0) call check_each_finite(error, "v", v(:n))
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) out_values = law%work_at(v(:n))
        time_value = 0.0_c_double
        if (.not. allocated(error)) then
            if (allocated(law%crack)) time_value = law%crack%longest
        end if
        zone_value = 0.0_c_double
        if (.not. allocated(error)) zone_value = law%zone()
        if (.not. allocated(error)) call check_results(error, out_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
        if (present(time)) time = time_value
        if (present(zone)) zone = zone_value
    end function mdr_rate_work

    function mdr_rate_history(r, control, spring_stiffness, tolerance, start, n, time, in, d, a, f, v, dissipated, work, end) &
        result(status) &
        bind(C, name="mdrcontact_entry_rate_history")
        type(c_ptr), value :: r
        integer(c_int), value :: control, n
        real(c_double), value :: spring_stiffness, tolerance
        type(rate_state_t), intent(in), optional :: start
        real(c_double), intent(in), optional :: time(*), in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), f(*), v(*), dissipated(*), work(*)
        type(rate_state_t), intent(inout), optional :: end
        integer(c_int) :: status
        type(rate_contact_t), pointer :: r_inside
        type(control_t) :: chosen
        real(c_double), allocatable :: path(:, :), d_values(:), a_values(:), f_values(:), v_values(:), dissipated_values(:), &
            work_values(:)
        integer :: stat
        type(rate_state_t) :: end_value
        type(error_t), allocatable :: error

        call open_handle(r, "r", r_inside, error)
        if (.not. allocated(error)) call choose_control(chosen, control, spring_stiffness, .true., error)
        if (.not. allocated(error)) then
            allocate (path(columns, n), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) end_value = start
        if (.not. allocated(error) .and. n > 0) then
            call rate_history(r_inside, chosen, time(:n), in(:n), end_value, path, error, tolerance)
        end if
        call make_room(error, n, d_values)
        if (.not. allocated(error)) d_values = path(1, :)
        call make_room(error, n, a_values)
        if (.not. allocated(error)) a_values = path(2, :)
        call make_room(error, n, f_values)
        if (.not. allocated(error)) f_values = path(3, :)
        call make_room(error, n, v_values)
        if (.not. allocated(error)) v_values = path(4, :)
        call make_room(error, n, dissipated_values)
        if (.not. allocated(error)) dissipated_values = path(5, :)
        call make_room(error, n, work_values)
        if (.not. allocated(error)) work_values = path(6, :)
        if (.not. allocated(error)) call check_results(error, d_values)
        if (.not. allocated(error)) call check_results(error, a_values)
        if (.not. allocated(error)) call check_results(error, f_values)
        if (.not. allocated(error)) call check_results(error, v_values)
        if (.not. allocated(error)) call check_results(error, dissipated_values)
        if (.not. allocated(error)) call check_results(error, work_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(d)) d(:n) = d_values
        if (present(a)) a(:n) = a_values
        if (present(f)) f(:n) = f_values
        if (present(v)) v(:n) = v_values
        if (present(dissipated)) dissipated(:n) = dissipated_values
        if (present(work)) work(:n) = work_values
        if (present(end)) end = end_value
    end function mdr_rate_history

    function mdr_contact_adhesive_history(c, control, spring_stiffness, tolerance, start, n, time, in, d, a, zone_radius, f, end) &
        result(status) &
        bind(C, name="mdrcontact_entry_contact_adhesive_history")
        type(c_ptr), value :: c
        integer(c_int), value :: control, n
        real(c_double), value :: spring_stiffness, tolerance
        type(rate_state_t), intent(in), optional :: start
        real(c_double), intent(in), optional :: time(*), in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), zone_radius(*), f(*)
        type(rate_state_t), intent(inout), optional :: end
        integer(c_int) :: status
        type(relaxing_contact_t), pointer :: c_inside
        type(control_t) :: chosen
        real(c_double), allocatable :: path(:, :), d_values(:), a_values(:), zone_radius_values(:), f_values(:)
        integer :: stat
        type(rate_state_t) :: end_value
        type(error_t), allocatable :: error

        call open_handle(c, "c", c_inside, error)
        if (.not. allocated(error)) call choose_control(chosen, control, spring_stiffness, .true., error)
        if (.not. allocated(error)) then
            if (start%radius > 0.0_c_double) call raise(error, error_invalid, " = "//to_text(start%radius)// &
                ": it must be 0 (separated bodies) or less than 0 (equilibrium)", "start")
        end if
        if (.not. allocated(error)) then
            allocate (path(cohesive_columns, n), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error) .and. n > 0) then
            call cohesive_history(c_inside, chosen, start%radius < 0.0_c_double, time(:n), in(:n), path, end_value, error, &
                tolerance)
        end if
        call make_room(error, n, d_values)
        if (.not. allocated(error)) d_values = path(1, :)
        call make_room(error, n, a_values)
        if (.not. allocated(error)) a_values = path(2, :)
        call make_room(error, n, zone_radius_values)
        if (.not. allocated(error)) zone_radius_values = path(3, :)
        call make_room(error, n, f_values)
        if (.not. allocated(error)) f_values = path(4, :)
        if (.not. allocated(error)) call check_results(error, d_values)
        if (.not. allocated(error)) call check_results(error, a_values)
        if (.not. allocated(error)) call check_results(error, zone_radius_values)
        if (.not. allocated(error)) call check_results(error, f_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(d)) d(:n) = d_values
        if (present(a)) a(:n) = a_values
        if (present(zone_radius)) zone_radius(:n) = zone_radius_values
        if (present(f)) f(:n) = f_values
        if (present(end)) end = end_value
    end function mdr_contact_adhesive_history

end module mdrcontact_api_adhesion_entries
