! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts whose work of adhesion depends on the speed of their edge, for C.
module mdrcontact_api_adhesion_rate
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int, c_loc, c_ptr, c_sizeof
    use mdrcontact_api_arrays, only: check_each_finite, check_results, make_room
    use mdrcontact_api_handles, only: hand_over
    use mdrcontact_api_adhesion_open_handle, only: open_handle
    use mdrcontact_api_loop, only: choose_control
    use mdrcontact_api_options, only: read_options
    use mdrcontact_api_records, only: c_rate_options_t
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_error, only: check_memory, error_invalid, error_t, raise
    use mdrcontact_adhesion_rate_contact, only: new_rate_contact, rate_contact_t
    use mdrcontact_adhesion_rate_history, only: columns, rate_history
    use mdrcontact_adhesion_rate_law, only: new_rate_law, new_surface_law, rate_law_t
    use mdrcontact_adhesion_rate_state, only: rate_state_t
    use mdrcontact_material_rheology, only: rheology_t
    implicit none (type, external)
    private
    public :: mdr_rate_new, mdr_rate_work, mdr_rate_history

contains

    function mdr_rate_new(c, options, out) result(status) bind(C, name="mdrcontact_entry_rate_new")
        type(c_ptr), value :: c, options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(contact_t), pointer :: contact
        type(c_rate_options_t) :: given
        type(rate_law_t) :: law
        type(rate_contact_t), allocatable :: made
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        call open_handle(c, "c", contact, error)
        call read_law(options, given, law, error)
        allocate (made)
        if (.not. allocated(error)) call new_rate_contact(made, contact, law, given%largest_radius, error, given%smallest_radius)
        call move_alloc(made, object)
        status = hand_over(object, out, error)
    end function mdr_rate_new

    !> The law of some options.
    subroutine read_law(options, given, law, error)
        type(c_ptr), intent(in) :: options
        type(c_rate_options_t), target, intent(out) :: given
        type(rate_law_t), intent(out) :: law
        type(error_t), allocatable, intent(inout) :: error
        type(rheology_t), pointer :: material
        real(c_double) :: speeds(5)

        call check_given(error, "options", c_associated(options))
        call read_options(error, "options", options, c_loc(given), c_sizeof(given))
        if (allocated(error)) return
        speeds = [given%speed, given%exponent, given%closing_work, given%closing_speed, given%closing_exponent]
        if (.not. c_associated(given%material) .and. given%cohesive_stress /= 0.0_c_double) then
            call raise(error, error_invalid, " is not allowed without a material: it is of the crack that follows from one", &
                       "cohesive_stress")
        else if (.not. c_associated(given%material)) then
            call new_rate_law(law, given%work, given%speed, given%exponent, error, given%closing_work, given%closing_speed, &
                              given%closing_exponent)
        else if (any(speeds /= 0.0_c_double)) then
            call raise(error, error_invalid, " is not allowed beside speeds, exponents or a closing_work: it determines them", &
                       "material")
        else
            call open_handle(given%material, "material", material, error)
            if (.not. allocated(error)) call new_surface_law(law, material, given%work, given%cohesive_stress, error)
        end if
    end subroutine read_law

    function mdr_rate_work(options, n, v, out, time, zone) result(status) bind(C, name="mdrcontact_entry_rate_work")
        type(c_ptr), value :: options
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: v(*)
        real(c_double), intent(inout), optional :: out(*), time, zone
        integer(c_int) :: status
        type(c_rate_options_t) :: given
        type(rate_law_t) :: law
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error
        real(c_double) :: longest

        call read_law(options, given, law, error)
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            call check_each_finite(error, "v", v(:n))
            if (.not. allocated(error)) values(:) = law%work_at(v(:n))
            if (.not. allocated(error)) call check_results(error, values)
        end if
        status = status_of(error)
        if (allocated(error)) return
        longest = 0.0_c_double
        if (allocated(law%crack)) longest = law%crack%longest
        if (n > 0) out(:n) = values
        if (present(time)) time = longest
        if (present(zone)) zone = law%zone()
    end function mdr_rate_work

    function mdr_rate_history(r, control, spring_stiffness, tolerance, start, n, time, in, d, a, f, v, dissipated, work, end) &
        result(status) bind(C, name="mdrcontact_entry_rate_history")
        type(c_ptr), value :: r
        integer(c_int), value :: control, n
        real(c_double), value :: spring_stiffness, tolerance
        type(rate_state_t), intent(in), optional :: start
        real(c_double), intent(in), optional :: time(*), in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), f(*), v(*), dissipated(*), work(*)
        type(rate_state_t), intent(inout), optional :: end
        integer(c_int) :: status
        type(rate_contact_t), pointer :: contact
        type(control_t) :: chosen
        type(rate_state_t) :: state
        real(c_double), allocatable :: path(:, :)
        type(error_t), allocatable :: error
        integer :: i, stat

        call open_handle(r, "r", contact, error)
        call choose_control(chosen, control, spring_stiffness, .true., error)
        status = status_of(error)
        if (allocated(error)) return
        state = start
        allocate (path(columns, n), stat=stat)
        call check_memory(error, stat)
        if (.not. allocated(error) .and. n > 0) then
            call rate_history(contact, chosen, time(:n), in(:n), state, path, error, tolerance)
        end if
        do i = 1, columns
            if (.not. allocated(error)) call check_results(error, path(i, :))
        end do
        status = status_of(error)
        if (allocated(error)) return
        if (present(d)) d(:n) = path(1, :)
        if (present(a)) a(:n) = path(2, :)
        if (present(f)) f(:n) = path(3, :)
        if (present(v)) v(:n) = path(4, :)
        if (present(dissipated)) dissipated(:n) = path(5, :)
        if (present(work)) work(:n) = path(6, :)
        end = state
    end function mdr_rate_history

end module mdrcontact_api_adhesion_rate
