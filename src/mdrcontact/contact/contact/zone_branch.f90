! SPDX-License-Identifier: GPL-3.0-or-later
!> The stable states of a contact with a cohesive zone, with and without contact, and those in which it is entered and left.
module mdrcontact_contact_zone_branch
    use mdrcontact_contact_adhesive_branch, only: adhesive_branch_t, search_t, stable_segment_t
    use mdrcontact_contact_cohesion, only: new_cohesion, zone_guess_t
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_range, only: adhesive_range
    use mdrcontact_contact_samples, only: curve_point_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_zone_curve, only: coordinate_of, new_zone_curve, sample_tolerance, zone_curve_t, zone_state
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: zone_branch_t, new_zone_branch, add_cohesion

    !> The equilibria of a contact with a cohesive zone.
    type, extends(adhesive_branch_t) :: zone_branch_t
        private
        type(zone_curve_t) :: curve
    contains
        procedure :: find_segments
        procedure :: begin_search
        procedure :: state_at
        procedure :: at_radius
        procedure :: work_between
        procedure :: sampled
        procedure :: smooth_range
    end type zone_branch_t

    !> A zone shorter than this part of the radius at which adhesion hands over to elasticity changes no digit of a state: what it
    !> changes falls with its length.
    real(wp), parameter :: shortest_zone = 1.0e-12_wp
    !> Sampled up to so many radii of the zone at touch: beyond, depth and force grow.
    real(wp), parameter :: far_from_touch = 10.0_wp
    !> and to so many of the radius at which elasticity exceeds JKR adhesion: extrema lie where dl/d0 >= n/4 for a shape r^n, and
    !> d0/dl grows as a^(n - 1/2).
    real(wp), parameter :: far_from_handover = 20.0_wp
    !> Where indenter or medium end before, the samples end at this part of the radius, so many times.
    real(wp), parameter :: nearer = 0.7_wp
    integer, parameter :: most_tries = 12

contains

    !> Gives an adhesive equilibrium its range, unless the zone is too short to change a digit.
    subroutine add_cohesion(equilibrium, stress, error)
        type(equilibrium_t), intent(inout) :: equilibrium
        !> sigma_0 > 0 [modulus]
        real(wp), intent(in) :: stress
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: first, last, equal

        allocate (equilibrium%cohesion)
        call new_cohesion(equilibrium%cohesion, equilibrium%profile, equilibrium%medium, equilibrium%last_radius, &
                          equilibrium%work_of_adhesion, stress, error)
        if (.not. allocated(error)) call adhesive_range(equilibrium, first, last, error, equal)
        if (allocated(error)) return
        equilibrium%cohesion%handover_radius = equilibrium%radius_of(equal)
        equilibrium%cohesion%over_radius = equilibrium%radius_of(last)
        if (equilibrium%cohesion%small_zone > shortest_zone*equilibrium%cohesion%handover_radius) return
        deallocate (equilibrium%cohesion)
    end subroutine add_cohesion

    !> Samples the branch.
    subroutine new_zone_branch(self, equilibrium, error)
        type(zone_branch_t), intent(out) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: last

        associate (cohesion => equilibrium%cohesion)
            self%range = cohesion%range
            call last_coordinate(equilibrium, min(cohesion%over_radius, far_from_handover*cohesion%handover_radius), last, error)
        end associate
        if (.not. allocated(error)) call new_zone_curve(self%curve, equilibrium, last, error)
        if (.not. allocated(error)) call self%keep_segments(equilibrium, error)
    end subroutine new_zone_branch

    !> Up to where adhesion is over, of finite or zero range, or the last state that indenter and medium allow.
    subroutine last_coordinate(equilibrium, over, last, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: over
        real(wp), intent(out) :: last
        type(error_t), allocatable, intent(inout) :: error
        type(error_t), allocatable :: refused
        type(contact_state_t) :: state
        type(zone_guess_t) :: guess
        real(wp) :: radius
        integer :: i

        radius = min(max(over, far_from_touch*equilibrium%cohesion%touching_zone), equilibrium%last_radius)
        do i = 1, most_tries
            last = coordinate_of(equilibrium, radius, 0.0_wp)
            if (allocated(refused)) deallocate (refused)
            guess = zone_guess_t(equilibrium%cohesion%likely_zone)
            if (equilibrium%cohesion%kernel%is_graded()) guess%tolerance = sample_tolerance
            call zone_state(equilibrium, last, state, refused, guess)
            if (.not. allocated(refused)) return
            radius = nearer*radius
        end do
        error = refused
    end subroutine last_coordinate

    subroutine find_segments(self, equilibrium, control, list, error)
        class(zone_branch_t), intent(in) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        type(stable_segment_t), allocatable, intent(out) :: list(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: turns(:)
        real(wp) :: last, unused

        call self%curve%extrema(control, turns, error)
        if (allocated(error)) return
        call self%curve%control_at(control, turns(size(turns)), last, unused)
        call self%segments_between(equilibrium, control, turns, coordinate_of(equilibrium, equilibrium%last_radius, 0.0_wp), &
                                   list, error, last)
    end subroutine find_segments

    pure subroutine begin_search(self, equilibrium, control, segment, s, search)
        class(zone_branch_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        type(control_t), intent(in) :: control
        type(stable_segment_t), intent(in) :: segment
        real(wp), intent(in) :: s
        type(search_t), intent(out) :: search
        type(curve_point_t) :: point
        real(wp) :: last, there, highest, unused

        associate (unused_too => equilibrium)
        end associate
        last = min(segment%last, self%curve%edges(size(self%curve%edges)))
        point = self%curve%find(control, segment%lowest, 1.0_wp, .true., s - segment%lowest, segment%first, last)
        search%x = point%x
        call self%curve%control_at(control, point%x, there, search%slope)
        call self%curve%control_at(control, last, highest, unused)
        search%is_logarithmic = s > highest .and. highest > 0.0_wp
        if (search%is_logarithmic) search%slope = search%slope/there
        search%distance = merge(1.0_wp, 1.0e-4_wp, search%is_logarithmic)
    end subroutine begin_search

    !> Begins with the zone of the samples.
    subroutine state_at(self, equilibrium, x, state, error)
        class(zone_branch_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: x
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(inout) :: error
        type(zone_guess_t) :: guess

        guess = self%curve%guess_at(x)
        call zone_state(equilibrium, x, state, error, guess)
    end subroutine state_at

    !> F and a from the samples where they reach: for data, which are never as exact.
    subroutine sampled(self, equilibrium, control, segment, s, force, radius, error)
        class(zone_branch_t), intent(in) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        type(stable_segment_t), intent(in) :: segment
        !> at the lowest or beyond: the state there
        real(wp), intent(in) :: s
        real(wp), intent(out) :: force, radius
        type(error_t), allocatable, intent(inout) :: error
        type(contact_state_t) :: state
        type(error_t), allocatable :: failed
        type(curve_point_t) :: point
        real(wp) :: last, highest, unused

        force = 0.0_wp
        radius = 0.0_wp
        last = min(segment%last, self%curve%edges(size(self%curve%edges)))
        call self%curve%control_at(control, last, highest, unused)
        if (s > highest) then
            call self%state_on(equilibrium, control, segment, s, state, failed)
            if (allocated(failed)) error = failed
            force = state%force
            radius = state%radius
            return
        end if
        point = self%curve%find(control, segment%lowest, 1.0_wp, .true., s - segment%lowest, segment%first, last)
        force = point%force
        radius = point%radius
    end subroutine sampled

    !> Begins with the zone of the samples.
    subroutine at_radius(self, equilibrium, radius, state, error)
        class(zone_branch_t), intent(in) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        real(wp), intent(in) :: radius
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        type(zone_guess_t) :: guess

        guess = self%curve%guess_at(coordinate_of(equilibrium, radius, huge(1.0_wp)))
        call equilibrium%cohesion%at_radius(equilibrium%profile, radius, state, error, guess)
    end subroutine at_radius

    function work_between(self, equilibrium, from, to) result(work)
        class(zone_branch_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        type(contact_state_t), intent(in) :: from, to
        real(wp) :: work

        work = self%curve%work_between(coordinate_of(equilibrium, from%radius, from%zone_radius), &
                                       coordinate_of(equilibrium, to%radius, to%zone_radius))
    end function work_between

    subroutine smooth_range(self, equilibrium, state, x, low, high, error)
        class(zone_branch_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        type(contact_state_t), intent(in) :: state
        real(wp), intent(out) :: x, low, high
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: breaks(:)

        x = coordinate_of(equilibrium, state%radius, state%zone_radius)
        allocate (breaks, source=[-1.0_wp, self%curve%breaks(), coordinate_of(equilibrium, equilibrium%last_radius, 0.0_wp)])
        low = maxval(breaks, mask=breaks <= x)
        high = minval(breaks, mask=breaks > x)
        associate (unused => error)
        end associate
    end subroutine smooth_range

end module mdrcontact_contact_zone_branch
