! SPDX-License-Identifier: GPL-3.0-or-later
!> F(d) of a contact with a cohesive zone at many depths: the stable states, with contact and without, inverted on their samples.
module mdrcontact_fit_zone_force
    use mdrcontact_contact_adhesive_branch, only: stable_segment_t
    use mdrcontact_contact_control, only: depth_control
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_zone_branch, only: new_zone_branch, zone_branch_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: zone_forces

contains

    !> F and a at depths on loading or unloading; for separated bodies, `apart` is true. Below pull-off F continues as above it, up
    !> to 0: readings of bodies that still touch there show a search where pull-off should be.
    subroutine zone_forces(equilibrium, depth, is_loading, force, radius, apart, error)
        type(equilibrium_t), intent(in), target :: equilibrium
        !> [length], and the same size: whether the bodies approach, F [modulus length^2], a [length], whether they are separated
        real(wp), intent(in) :: depth(:)
        logical, intent(in) :: is_loading(:)
        real(wp), intent(out) :: force(:), radius(:)
        logical, intent(out) :: apart(:)
        type(error_t), allocatable, intent(inout) :: error
        type(zone_branch_t) :: branch
        type(stable_segment_t), allocatable :: list(:)
        real(wp) :: slope
        integer :: i, chosen

        force = 0.0_wp
        radius = 0.0_wp
        apart = .true.
        call new_zone_branch(branch, equilibrium, error)
        if (.not. allocated(error)) call branch%stable_segments(equilibrium, depth_control, list, error)
        if (allocated(error)) return
        if (size(list) == 0) return
        do i = 1, size(depth)
            chosen = findloc(list%lowest <= depth(i) .and. depth(i) <= list%highest, .true., dim=1, back=.not. is_loading(i))
            apart(i) = chosen == 0 .or. (is_loading(i) .and. depth(i) < branch%first_attraction(depth_control))
            if (chosen == 0) chosen = minloc(list%lowest, dim=1)
            call branch%sampled(equilibrium, depth_control, list(chosen), depth(i), force(i), radius(i), error)
            if (allocated(error)) return
            if (depth(i) >= list(chosen)%lowest .or. is_loading(i)) cycle
            slope = mean_slope(list(chosen))
            if (allocated(error)) return
            force(i) = min(0.0_wp, force(i) - slope*(list(chosen)%lowest - depth(i)))
        end do

    contains

        !> From pull-off to a fifth of its depth above.
        function mean_slope(segment) result(slope)
            type(stable_segment_t), intent(in) :: segment
            real(wp) :: slope
            real(wp) :: lowest, above, unused, rise

            slope = 0.0_wp
            rise = 0.2_wp*abs(segment%lowest)
            call branch%sampled(equilibrium, depth_control, segment, segment%lowest, lowest, unused, error)
            if (.not. allocated(error)) call branch%sampled(equilibrium, depth_control, segment, segment%lowest + rise, above, &
                                                            unused, error)
            if (.not. allocated(error) .and. rise > 0.0_wp) slope = (above - lowest)/rise
        end function mean_slope

    end subroutine zone_forces

end module mdrcontact_fit_zone_force
