! SPDX-License-Identifier: GPL-3.0-or-later
!> Conductance along the loading of a contact, and the heat of its friction, for C.
module mdrcontact_api_conduction_heat
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_results, make_room
    use mdrcontact_api_conduction_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of
    use mdrcontact_api_conduction, only: check_body
    use mdrcontact_codes, only: body_upper, moving => heat_moving, sliding => heat_sliding, spinning => heat_spinning
    use mdrcontact_conduction_bodies, only: conduction_t
    use mdrcontact_conduction_heat, only: friction_heat, heat_field, heat_t
    use mdrcontact_conduction_moving, only: moving_heat
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_choice, check_code, check_memory, error_t, raise_at
    implicit none (type, external)
    private
    public :: mdr_conduction_heat, mdr_conduction_heat_field

    !> Struct mdr_friction_heat.
    type, bind(C) :: record_t
        real(c_double) :: total, share, centre, flux_mean, area_mean, largest, behind
    end type record_t

contains

    function mdr_conduction_heat(p, c, n, states, motion, strength, speed, out) result(status) &
        bind(C, name="mdrcontact_entry_conduction_heat")
        type(c_ptr), value :: p, c
        integer(c_int), value :: n, motion
        type(contact_state_t), intent(in), optional :: states(*)
        real(c_double), value :: strength, speed
        type(record_t), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(conduction_t), pointer :: conduction
        type(contact_t), pointer :: contact
        type(record_t), allocatable :: records(:)
        type(error_t), allocatable :: error
        integer :: i, stat

        call open_handle(p, "p", conduction, error)
        call open_handle(c, "c", contact, error)
        if (.not. allocated(error)) then
            allocate (records(n), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) then
            do i = 1, n
                call take_heat(conduction, contact, states(i), int(motion), strength, speed, records(i), error)
                if (allocated(error)) call raise_at(error, i)
                if (allocated(error)) exit
            end do
        end if
        status = status_of(error)
        if (.not. allocated(error)) out(:n) = records
    end function mdr_conduction_heat

    !> Temperatures of one state.
    subroutine take_heat(conduction, contact, state, motion, strength, speed, record, error)
        type(conduction_t), intent(in) :: conduction
        type(contact_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        integer, intent(in) :: motion
        real(c_double), intent(in) :: strength, speed
        type(record_t), intent(inout) :: record
        type(error_t), allocatable, intent(inout) :: error
        type(heat_t) :: heat

        call check_code(error, "motion", motion, [sliding, spinning, moving])
        if (allocated(error)) return
        if (motion == moving) then
            call moving_heat(conduction, contact, state, strength, speed, heat, error)
        else
            call friction_heat(conduction, contact, state, motion, strength, heat, error)
        end if
        record = record_t(heat%total, heat%share, heat%centre, heat%flux_mean, heat%area_mean, heat%largest, heat%behind)
        if (.not. allocated(error)) call check_results(error, [record%total, record%share, record%centre, record%flux_mean, &
                                                               record%area_mean, record%largest, record%behind])
    end subroutine take_heat

    function mdr_conduction_heat_field(p, c, state, motion, strength, body, below, n, r, z, out) result(status) &
        bind(C, name="mdrcontact_entry_conduction_heat_field")
        type(c_ptr), value :: p, c
        type(contact_state_t), intent(in), optional :: state
        integer(c_int), value :: motion, body, below, n
        real(c_double), value :: strength
        real(c_double), intent(in), optional :: r(*), z(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(conduction_t), pointer :: conduction
        type(contact_t), pointer :: contact
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", conduction, error)
        call open_handle(c, "c", contact, error)
        call check_body(error, conduction, int(body))
        call check_choice(error, "below", int(below), 0, 1, "0 (above an interface) or 1 (below it)")
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            call heat_field(conduction, contact, state, int(motion), strength, merge(2, 1, body == body_upper), r(:n), z(:n), &
                            below == 1, values, error)
            if (.not. allocated(error)) call check_results(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function mdr_conduction_heat_field

end module mdrcontact_api_conduction_heat
