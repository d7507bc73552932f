! SPDX-License-Identifier: GPL-3.0-or-later
!> The stable states of a contact with a cohesive zone, with and without contact, and those in which it is entered and left.
module mdrcontact_contact_zone_branch
    use mdrcontact_contact_adhesive_branch, only: adhesive_branch_t, stable_segment_t
    use mdrcontact_contact_cohesion, only: zone_guess_t
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_range, only: adhesive_range
    use mdrcontact_contact_samples, only: curve_point_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_zone_curve, only: coordinate_of, new_zone_curve, zone_curve_t, zone_state
    use mdrcontact_error, only: error_t, error_unreachable, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_roots, only: solve_increasing
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: zone_branch_t, new_zone_branch, zone_is_resolved

    !> The equilibria of a contact with a cohesive zone.
    type, extends(adhesive_branch_t) :: zone_branch_t
        private
        type(zone_curve_t) :: curve
    contains
        procedure :: find_segments
        procedure :: state_on
        procedure :: at_radius
        procedure :: work_between
        procedure :: sampled
    end type zone_branch_t

    !> s - offset of an equilibrium as a function of the coordinate.
    type, extends(scalar_function_t) :: quantity_t
        type(equilibrium_t), pointer :: equilibrium => null()
        type(zone_curve_t), pointer :: curve => null()
        type(control_t) :: control
        real(wp) :: offset = 0.0_wp
        !> ln(s/offset) in place of s - offset
        logical :: is_logarithmic = .false.
    contains
        procedure :: value => quantity_at
    end type quantity_t

    !> A zone shorter than this part of the radius at which adhesion hands over to elasticity changes no digit of a state: what it
    !> changes falls with its length.
    real(wp), parameter :: shortest_zone = 1.0e-12_wp
    !> Sampled up to so many radii of the zone at touch: beyond, depth and force grow.
    real(wp), parameter :: far_from_touch = 10.0_wp
    !> and to so many of the radius at which adhesion without a range hands over to elasticity: extrema lie where dl/d0 >= n/4 for a
    !> shape r^n, and d0/dl grows as a^(n - 1/2).
    real(wp), parameter :: far_from_handover = 20.0_wp
    !> Where indenter or medium end before, the samples end at this part of the radius, so many times.
    real(wp), parameter :: nearer = 0.7_wp
    integer, parameter :: most_tries = 12

contains

    !> Whether the zone is long enough to change the states of the equilibrium, whose cohesion is that of these numbers.
    subroutine zone_is_resolved(equilibrium, answer, error)
        type(equilibrium_t), intent(in) :: equilibrium
        logical, intent(out) :: answer
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: first, last, equal

        answer = .true.
        call adhesive_range(equilibrium, first, last, error, equal)
        if (.not. allocated(error)) answer = equilibrium%cohesion%small_zone > shortest_zone*equilibrium%radius_of(equal)
    end subroutine zone_is_resolved

    !> Samples the branch.
    subroutine new_zone_branch(self, equilibrium, error)
        type(zone_branch_t), intent(out) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: first, last, equal

        self%range = equilibrium%cohesion%range
        call adhesive_range(equilibrium, first, last, error, equal)
        if (allocated(error)) return
        call last_coordinate(equilibrium, min(equilibrium%radius_of(last), far_from_handover*equilibrium%radius_of(equal)), last, &
                             error)
        if (.not. allocated(error)) call new_zone_curve(self%curve, equilibrium, last, error)
        if (.not. allocated(error)) call self%keep_segments(equilibrium, error)
    end subroutine new_zone_branch

    !> Up to where adhesion is over, with or without a range, or the last state that indenter and medium allow.
    subroutine last_coordinate(equilibrium, over, last, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: over
        real(wp), intent(out) :: last
        type(error_t), allocatable, intent(inout) :: error
        type(error_t), allocatable :: refused
        type(contact_state_t) :: state
        real(wp) :: radius
        integer :: i

        radius = min(max(over, far_from_touch*equilibrium%cohesion%touching_zone), equilibrium%last_radius)
        do i = 1, most_tries
            last = coordinate_of(equilibrium, radius, 0.0_wp)
            if (allocated(refused)) deallocate (refused)
            call zone_state(equilibrium, last, state, refused)
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
        type(contact_state_t) :: state
        real(wp), allocatable :: turns(:), s(:)
        type(zone_guess_t) :: guess
        integer :: i

        allocate (list(0))
        call self%curve%extrema(control, turns, error)
        if (allocated(error)) return
        allocate (s(size(turns)))
        do i = 1, size(turns)
            guess = self%curve%guess_at(turns(i))
            call zone_state(equilibrium, turns(i), state, error, guess)
            if (allocated(error)) return
            s(i) = control%of(state%depth, state%force)
        end do
        do i = 1, size(turns) - 1
            if (s(i + 1) > s(i)) list = [list, stable_segment_t(turns(i), turns(i + 1), s(i), s(i + 1))]
        end do
        if (size(list) == 0) return
        if (list(size(list))%last < turns(size(turns))) return
        list(size(list))%last = max(turns(size(turns)), coordinate_of(equilibrium, equilibrium%last_radius, 0.0_wp))
        list(size(list))%highest = huge(1.0_wp)
    end subroutine find_segments

    !> Begins on the samples where they reach, then solves on the equilibrium itself.
    subroutine state_on(self, equilibrium, control, segment, s, state, error)
        class(zone_branch_t), intent(in) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        type(stable_segment_t), intent(in) :: segment
        real(wp), intent(in) :: s
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        type(zone_guess_t) :: guess
        real(wp) :: x
        logical :: found

        found = .true.
        if (s <= segment%lowest) then
            x = segment%first
        else if (s >= segment%highest) then
            x = segment%last
        else
            call find_coordinate(self%curve, equilibrium, control, segment, s, x, found, error)
            if (allocated(error)) return
        end if
        if (.not. found) then
            call raise(error, error_unreachable, "no state found up to radius = "//to_text(equilibrium%last_radius)// &
                       ", where the indenter or the medium ends")
            return
        end if
        guess = self%curve%guess_at(x)
        call zone_state(equilibrium, x, state, error, guess)
    end subroutine state_on

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

    subroutine find_coordinate(curve, equilibrium, control, segment, s, x, found, error)
        type(zone_curve_t), intent(in), target :: curve
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        type(stable_segment_t), intent(in) :: segment
        real(wp), intent(in) :: s
        real(wp), intent(out) :: x
        logical, intent(out) :: found
        type(error_t), allocatable, intent(out) :: error
        type(quantity_t) :: quantity
        type(curve_point_t) :: point
        real(wp) :: guess, last, there, slope, highest, unused

        quantity%equilibrium => equilibrium
        quantity%curve => curve
        quantity%control = control
        quantity%offset = s
        last = min(segment%last, curve%edges(size(curve%edges)))
        point = curve%find(control, segment%lowest, 1.0_wp, .true., s - segment%lowest, segment%first, last)
        guess = point%x
        call curve%control_at(control, guess, there, slope)
        ! beyond the samples s follows a power of the radius
        call curve%control_at(control, last, highest, unused)
        quantity%is_logarithmic = s > highest .and. highest > 0.0_wp
        if (quantity%is_logarithmic) slope = slope/there
        if (.not. slope > 0.0_wp) slope = merge(2.0_wp, tiny(1.0_wp) + abs(s), quantity%is_logarithmic)
        call solve_increasing(quantity, guess, slope, segment%first, segment%last, x, found, error, &
                              distance=merge(1.0_wp, 1.0e-4_wp, quantity%is_logarithmic))
    end subroutine find_coordinate

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

    function quantity_at(self, x) result(y)
        class(quantity_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        type(contact_state_t) :: state
        type(zone_guess_t) :: guess

        guess = self%curve%guess_at(x)
        call zone_state(self%equilibrium, x, state, self%error, guess)
        y = self%control%distance(state%depth, state%force, self%offset, self%is_logarithmic)
    end function quantity_at

end module mdrcontact_contact_zone_branch
