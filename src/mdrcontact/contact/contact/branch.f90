! SPDX-License-Identifier: GPL-3.0-or-later
!> The whole branch of adhesive equilibria d(a), F(a), its extrema, and the stable states on it (theory/paper.md (5.1)).
!>
!> Equilibria are stable where what the machine controls grows with the contact radius; a coated body can have several such
!> segments.
module mdrcontact_contact_branch
    use mdrcontact_contact_adhesive_branch, only: adhesive_branch_t, search_t, stable_segment_t
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_contact_curve, only: curve_point_t, curve_t, new_curve
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_range, only: adhesive_range, coordinates_between, smallest_log
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: branch_t, new_branch

    !> The equilibria in the JKR limit, from adhesion alone to elasticity alone.
    type, extends(adhesive_branch_t) :: branch_t
        private
        !> not allocated if there is a single radius (flat punch): there are wall states only
        type(curve_t), allocatable :: curve
    contains
        procedure :: find_segments
        procedure :: begin_search
        procedure :: state_at
        procedure :: at_radius
        procedure :: work_between
        procedure :: smooth_range
    end type branch_t

    real(wp), parameter :: tolerance = 1.0e-8_wp
    !> Half width of the interval around an extremum on which the equilibria are sampled again to find it to full precision.
    real(wp), parameter :: extremum_width = 0.1_wp
    !> The largest load of an imprint is solved for: what is given may be this part above it.
    real(wp), parameter :: largest_rounding = 1.0e-9_wp

contains

    !> Samples the branch of an adhesive equilibrium.
    subroutine new_branch(self, equilibrium, error)
        type(branch_t), intent(out) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: coordinates(:)
        real(wp) :: first, last

        if (equilibrium%profile%end_radius < equilibrium%last_radius*(1.0_wp - 1.0e-12_wp)) then
            call adhesive_range(equilibrium, first, last, error)
            if (allocated(error)) return
            allocate (self%curve)
            call coordinates_between(equilibrium, first, last, coordinates, error)
            if (allocated(error)) return
            call new_curve(self%curve, equilibrium, coordinates, tolerance, error)
            if (allocated(error)) then
                deallocate (self%curve)
                return
            end if
        end if
        call self%keep_segments(equilibrium, error)
    end subroutine new_branch

    !> The stable segments under a control, in ascending order of the contact radius. The last reaches to the end of the
    !> indenter or medium, climbs its vertical wall without end, or rests at the edge of an imprint up to its largest load
    !> (theory/plastic.md (3.1)).
    subroutine find_segments(self, equilibrium, control, list, error)
        class(branch_t), intent(in) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        type(stable_segment_t), allocatable, intent(out) :: list(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: turns(:)
        type(contact_state_t) :: end_state
        type(stable_segment_t) :: wall

        allocate (list(0))
        if (allocated(self%curve)) then
            call turning_points(self%curve, equilibrium, control, turns, error)
            if (.not. allocated(error)) call self%segments_between(equilibrium, control, turns, &
                                                                   equilibrium%coordinate_of(equilibrium%last_radius), list, error)
            if (allocated(error)) return
        end if
        if (.not. (equilibrium%profile%has_wall .or. equilibrium%ends_sharply())) return
        if (equilibrium%last_radius < equilibrium%profile%largest_radius*(1.0_wp - 1.0e-12_wp)) return
        wall%at_wall = .true.
        wall%first = equilibrium%coordinate_of(equilibrium%last_radius)
        wall%last = wall%first
        call equilibrium%at(equilibrium%last_radius, end_state, error)
        wall%lowest = control%of(end_state%depth, end_state%force)
        wall%highest = huge(1.0_wp)
        ! at the edge of an imprint from the largest load on
        if (equilibrium%ends_sharply()) then
            wall%highest = control%of(equilibrium%sharp_end%depth, equilibrium%sharp_end%force)
            wall%highest = wall%highest + largest_rounding*abs(wall%highest)
        end if
        if (size(list) > 0) then
            if (list(size(list))%last >= wall%first) list(size(list))%highest = wall%lowest
        end if
        list = [list, wall]
    end subroutine find_segments

    !> Ends and extrema of s along the sampled branch.
    subroutine turning_points(curve, equilibrium, control, turns, error)
        type(curve_t), intent(in) :: curve
        type(equilibrium_t), intent(in) :: equilibrium
        type(control_t), intent(in) :: control
        real(wp), allocatable, intent(out) :: turns(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: brackets(:, :)
        integer :: i

        allocate (brackets, source=curve%turns(control))
        allocate (turns(size(brackets, 2) + 2))
        turns(1) = curve%edges(1)
        turns(size(turns)) = curve%edges(size(curve%edges))
        ! Behind a flat end s rises with the root of a - b: the branch begins at the edge itself.
        if (equilibrium%profile%end_radius > 0.0_wp) turns(1) = smallest_log
        do i = 1, size(brackets, 2)
            turns(i + 1) = refined_extremum(equilibrium, control, brackets(1, i), brackets(2, i), error)
            if (allocated(error)) return
        end do
    end subroutine turning_points

    !> The extremum of s between two coordinates, from samples close to it.
    function refined_extremum(equilibrium, control, low, high, error) result(x)
        type(equilibrium_t), intent(in) :: equilibrium
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: low, high
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: x
        type(curve_t), target :: near
        real(wp), allocatable :: coordinates(:)
        real(wp) :: from, to

        x = 0.5_wp*(low + high)
        from = min(low, x - extremum_width)
        to = min(max(high, x + extremum_width), equilibrium%coordinate_of(equilibrium%last_radius))
        call coordinates_between(equilibrium, from, to, coordinates, error)
        if (allocated(error)) return
        call new_curve(near, equilibrium, coordinates, tolerance, error)
        if (allocated(error)) return
        if (near%slope(control, from) < 0.0_wp .neqv. near%slope(control, to) < 0.0_wp) then
            call near%turn(control, from, to, x, error)
        end if
    end function refined_extremum

    pure subroutine begin_search(self, equilibrium, control, segment, s, search)
        class(branch_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        type(control_t), intent(in) :: control
        type(stable_segment_t), intent(in) :: segment
        real(wp), intent(in) :: s
        type(search_t), intent(out) :: search
        type(curve_point_t) :: point
        real(wp) :: low, high, s_high

        search%is_rough = equilibrium%profile%end_radius > 0.0_wp
        low = max(segment%first, self%curve%edges(1))
        high = min(segment%last, self%curve%edges(size(self%curve%edges)))
        point = self%curve%at(high)
        s_high = control%of(point%depth, point%force)
        if (s_high > s) point = self%curve%find(control, segment%lowest, 1.0_wp, .true., s - segment%lowest, low, high)
        search%x = point%x
        search%slope = self%curve%slope(control, point%x)
        search%is_logarithmic = s_high > 0.0_wp .and. s_high <= s
        if (search%is_logarithmic) search%slope = search%slope/s_high
    end subroutine begin_search

    subroutine state_at(self, equilibrium, x, state, error)
        class(branch_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: x
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => self)
        end associate
        call equilibrium%at(equilibrium%radius_of(x), state, error)
    end subroutine state_at

    subroutine at_radius(self, equilibrium, radius, state, error)
        class(branch_t), intent(in) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        real(wp), intent(in) :: radius
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        associate (unused => self)
        end associate
        call equilibrium%at(radius, state, error)
    end subroutine at_radius

    !> Between coordinates that are clipped to the sampled range: beyond it adhesion is over, and loading and unloading do the same
    !> work. At a vertical wall the depth alone changes.
    function work_between(self, equilibrium, from, to) result(work)
        class(branch_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        type(contact_state_t), intent(in) :: from, to
        real(wp) :: work

        if ((equilibrium%profile%has_wall .or. equilibrium%ends_sharply()) &
            .and. min(from%radius, to%radius) >= equilibrium%last_radius) then
            work = 0.5_wp*(from%force + to%force)*(to%depth - from%depth)
        else
            work = self%curve%work_between(equilibrium%coordinate_of(from%radius), equilibrium%coordinate_of(to%radius))
        end if
    end function work_between

    subroutine smooth_range(self, equilibrium, state, x, low, high, error)
        class(branch_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        type(contact_state_t), intent(in) :: state
        real(wp), intent(out) :: x, low, high
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: breaks(:)

        associate (unused => self)
        end associate
        x = equilibrium%coordinate_of(state%radius)
        low = equilibrium%coordinate_of(equilibrium%medium%smallest_radius)
        high = equilibrium%coordinate_of(equilibrium%last_radius)
        call equilibrium%add_breaks(breaks, error)
        if (allocated(error)) return
        breaks = log(pack(breaks, breaks > equilibrium%profile%end_radius) - equilibrium%profile%end_radius)
        low = max(low, maxval(breaks, mask=breaks <= x))
        high = min(high, minval(breaks, mask=breaks > x))
    end subroutine smooth_range

end module mdrcontact_contact_branch
