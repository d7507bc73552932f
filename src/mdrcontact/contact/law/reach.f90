! SPDX-License-Identifier: GPL-3.0-or-later
!> The part of an adhesive branch that a law needs, so that its states are those of the contact at every depth and force that it
!> answers.
!>
!> Depth and force fall over some radii where a contact jumps: a machine that unloads from far beyond is then on a segment that
!> begins at larger radii than those up to the largest depth, and has depths and forces below it.
module mdrcontact_law_reach
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_adhesive_branch, only: stable_segment_t
    use mdrcontact_contact_control, only: control_t, depth_control, force_control
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_zone_curve, only: coordinate_of, zone_state
    use mdrcontact_error, only: error_t, error_unreachable
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: reach_unloading

    !> By so much in the coordinate it goes beyond what is needed, for rounding.
    real(wp), parameter :: beyond = 1.0e-6_wp

contains

    !> Moves `last` out until no stable segment that begins beyond it has a depth or a force that the law answers below it.
    subroutine reach_unloading(contact, tolerance, last, solutions, error)
        type(contact_t), intent(in) :: contact
        !> of the law, relative: by so much its extrema may be off
        real(wp), intent(in) :: tolerance
        !> the coordinate at which the law would end
        real(wp), intent(inout) :: last
        integer, intent(inout) :: solutions
        type(error_t), allocatable, intent(inout) :: error
        type(stable_segment_t), allocatable :: of_depth(:), of_force(:)
        real(wp) :: before

        if (allocated(error)) return
        call contact%stable_segments(depth_control, of_depth, error)
        if (.not. allocated(error)) call contact%stable_segments(force_control, of_force, error)
        if (size_of(of_depth) <= 1 .and. size_of(of_force) <= 1) return
        do
            if (allocated(error)) return
            before = last
            call reach_under(contact, depth_control, of_depth, tolerance, last, solutions, error)
            if (.not. allocated(error)) call reach_under(contact, force_control, of_force, tolerance, last, solutions, error)
            if (last <= before) return
        end do
    end subroutine reach_unloading

    pure function size_of(list) result(n)
        type(stable_segment_t), allocatable, intent(in) :: list(:)
        integer :: n

        n = 0
        if (allocated(list)) n = size(list)
    end function size_of

    !> The same under one control.
    subroutine reach_under(contact, control, list, tolerance, last, solutions, error)
        type(contact_t), intent(in) :: contact
        type(control_t), intent(in) :: control
        !> its stable segments, by ascending coordinate
        type(stable_segment_t), intent(in) :: list(:)
        real(wp), intent(in) :: tolerance
        real(wp), intent(inout) :: last
        integer, intent(inout) :: solutions
        type(error_t), allocatable, intent(inout) :: error
        type(contact_state_t) :: state
        type(error_t), allocatable :: failed
        real(wp) :: s
        integer :: i

        do i = 1, size(list)
            if (list(i)%last <= last) cycle
            call state_at(contact, last, state, error)
            if (allocated(error)) return
            solutions = solutions + 1
            s = highest_before(list, tolerance, last, control%of(state%depth, state%force))
            if (list(i)%first >= last) then
                if (list(i)%lowest > s) cycle
            else if (control%of(state%depth, state%force) >= s) then
                cycle
            end if
            call contact%state_on_segment(control, list(i), min(s, list(i)%highest), state, failed)
            if (allocated(failed)) then
                if (failed%code /= error_unreachable) then
                    call move_alloc(failed, error)
                    return
                end if
                ! indenter or medium end before: so does the contact
                deallocate (failed)
                last = last_coordinate(contact)
            else
                last = max(last, min(coordinate(contact, state) + beyond, last_coordinate(contact)))
            end if
        end do
    end subroutine reach_under

    !> The largest s on what the stable segments have up to a coordinate, with s there, of the law.
    pure function highest_before(list, tolerance, last, there) result(s)
        type(stable_segment_t), intent(in) :: list(:)
        real(wp), intent(in) :: tolerance, last, there
        real(wp) :: s
        integer :: i

        s = -huge(s)
        do i = 1, size(list)
            if (list(i)%first >= last) cycle
            if (list(i)%last <= last) s = max(s, list(i)%highest + tolerance*abs(list(i)%highest))
            if (list(i)%last > last) s = max(s, there)
        end do
    end function highest_before

    subroutine state_at(contact, x, state, error)
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: x
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(inout) :: error

        if (allocated(contact%equilibrium%cohesion)) then
            call zone_state(contact%equilibrium, x, state, error)
        else
            call contact%equilibrium%at(contact%equilibrium%radius_of(x), state, error)
        end if
    end subroutine state_at

    pure function coordinate(contact, state) result(x)
        type(contact_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        real(wp) :: x

        if (allocated(contact%equilibrium%cohesion)) then
            x = coordinate_of(contact%equilibrium, state%radius, state%zone_radius)
        else
            x = contact%equilibrium%coordinate_of(state%radius)
        end if
    end function coordinate

    !> Where indenter or medium end.
    pure function last_coordinate(contact) result(x)
        type(contact_t), intent(in) :: contact
        real(wp) :: x

        if (allocated(contact%equilibrium%cohesion)) then
            x = coordinate_of(contact%equilibrium, contact%equilibrium%last_radius, 0.0_wp)
        else
            x = contact%equilibrium%coordinate_of(contact%equilibrium%last_radius)
            x = x - 4.0_wp*epsilon(x)*max(1.0_wp, abs(x))
        end if
    end function last_coordinate

end module mdrcontact_law_reach
