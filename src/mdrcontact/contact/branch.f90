! SPDX-License-Identifier: GPL-3.0-or-later
!> The whole branch of adhesive equilibria d(a), F(a), its extrema, and the stable states on it (theory 5).
!>
!> Equilibria are stable where what the machine controls grows with the contact radius; a coated body can have several such
!> segments.
module mdrcontact_contact_branch
    use mdrcontact_contact_adhesive_branch, only: adhesive_branch_t, stable_segment_t
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_contact_curve, only: curve_point_t, curve_t, new_curve
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_range, only: adhesive_range, coordinates_between, smallest_log
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_t, error_unreachable, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_roots, only: solve_increasing
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: branch_t, new_branch

    !> The equilibria of adhesion without a range from where it is all to where it is nothing.
    type, extends(adhesive_branch_t) :: branch_t
        private
        !> not allocated without a range of radii (flat punch): there are wall states only
        type(curve_t), allocatable :: curve
    contains
        procedure :: find_segments
        procedure :: state_on
        procedure :: at_radius
        procedure :: work_between
    end type branch_t

    !> s - offset of an equilibrium as a function of the coordinate.
    type, extends(scalar_function_t) :: quantity_t
        type(equilibrium_t), pointer :: equilibrium => null()
        type(control_t) :: control
        real(wp) :: offset = 0.0_wp
        !> ln(s/offset) in place of s - offset
        logical :: is_logarithmic = .false.
    contains
        procedure :: value => quantity_at
    end type quantity_t

    real(wp), parameter :: tolerance = 1.0e-8_wp
    !> Half width of the interval around an extremum on which the equilibria are sampled again to find it to full precision.
    real(wp), parameter :: extremum_width = 0.1_wp

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
    !> indenter or medium, or climbs its vertical wall without end.
    subroutine find_segments(self, equilibrium, control, list, error)
        class(branch_t), intent(in) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        type(stable_segment_t), allocatable, intent(out) :: list(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: turns(:), s(:)
        type(contact_state_t) :: end_state
        type(stable_segment_t) :: wall
        real(wp) :: end_coordinate
        integer :: i, n

        allocate (list(0))
        if (allocated(self%curve)) then
            call turning_points(self%curve, equilibrium, control, turns, s, error)
            if (allocated(error)) return
            n = size(turns)
            do i = 1, n - 1
                if (s(i + 1) > s(i)) list = [list, stable_segment_t(turns(i), turns(i + 1), s(i), s(i + 1))]
            end do
            end_coordinate = equilibrium%coordinate_of(equilibrium%last_radius)
            if (size(list) > 0) then
                if (list(size(list))%last >= turns(n) .and. end_coordinate > turns(n)) then
                    ! Beyond the samples s goes on to grow, to the end of the indenter or medium if there is one.
                    list(size(list))%last = end_coordinate
                    list(size(list))%highest = huge(1.0_wp)
                end if
            end if
        end if
        if (.not. equilibrium%profile%has_wall) return
        if (equilibrium%last_radius < equilibrium%profile%largest_radius*(1.0_wp - 1.0e-12_wp)) return
        wall%at_wall = .true.
        wall%first = equilibrium%coordinate_of(equilibrium%last_radius)
        wall%last = wall%first
        call equilibrium%at(equilibrium%last_radius, end_state, error)
        wall%lowest = control%of(end_state%depth, end_state%force)
        wall%highest = huge(1.0_wp)
        if (size(list) > 0) then
            if (list(size(list))%last >= wall%first) list(size(list))%highest = wall%lowest
        end if
        list = [list, wall]
    end subroutine find_segments

    !> Ends and extrema of s along the sampled branch, with s there.
    subroutine turning_points(curve, equilibrium, control, turns, s, error)
        type(curve_t), intent(in) :: curve
        type(equilibrium_t), intent(in) :: equilibrium
        type(control_t), intent(in) :: control
        real(wp), allocatable, intent(out) :: turns(:), s(:)
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        real(wp), allocatable :: brackets(:, :)
        integer :: i

        allocate (brackets, source=curve%turns(control))
        allocate (turns(size(brackets, 2) + 2), s(size(brackets, 2) + 2))
        turns(1) = curve%edges(1)
        turns(size(turns)) = curve%edges(size(curve%edges))
        ! Behind a flat end s rises with the root of a - b: the branch begins at the rim itself.
        if (equilibrium%profile%end_radius > 0.0_wp) turns(1) = smallest_log
        do i = 1, size(brackets, 2)
            turns(i + 1) = refined_extremum(equilibrium, control, brackets(1, i), brackets(2, i), error)
            if (allocated(error)) return
        end do
        do i = 1, size(turns)
            call equilibrium%at(equilibrium%radius_of(turns(i)), state, error)
            if (allocated(error)) return
            s(i) = control%of(state%depth, state%force)
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

    !> The state with a given s on a segment that contains it.
    subroutine state_on(self, equilibrium, control, segment, s, state, error)
        class(branch_t), intent(in) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        type(stable_segment_t), intent(in) :: segment
        real(wp), intent(in) :: s
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: x, more
        logical :: found

        if (segment%at_wall) then
            call equilibrium%at(equilibrium%last_radius, state, error)
            if (allocated(error)) return
            more = (s - segment%lowest)/control%of(1.0_wp, state%stiffness)
            state%punch_depth = state%punch_depth + more
            state%depth = state%depth + more
            state%force = state%force + state%stiffness*more
            return
        end if
        if (s <= segment%lowest) then
            x = segment%first
        else if (s >= segment%highest) then
            x = segment%last
        else
            call find_coordinate(self%curve, equilibrium, control, segment, s, x, found, error)
            if (allocated(error)) return
            if (.not. found) then
                call raise(error, error_unreachable, "no state found up to radius = "//to_text(equilibrium%radius_of(x))// &
                           ", where the indenter or the medium ends")
                return
            end if
        end if
        call equilibrium%at(equilibrium%radius_of(x), state, error)
    end subroutine state_on

    !> Begins on the samples where they reach, then solves on the equilibrium itself.
    subroutine find_coordinate(curve, equilibrium, control, segment, s, x, found, error)
        type(curve_t), intent(in) :: curve
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        type(stable_segment_t), intent(in) :: segment
        real(wp), intent(in) :: s
        real(wp), intent(out) :: x
        logical, intent(out) :: found
        type(error_t), allocatable, intent(out) :: error
        type(quantity_t) :: quantity
        type(curve_point_t) :: point
        real(wp) :: low, high, slope, s_high

        quantity%equilibrium => equilibrium
        quantity%control = control
        quantity%offset = s
        quantity%is_rough = equilibrium%profile%end_radius > 0.0_wp
        low = max(segment%first, curve%edges(1))
        high = min(segment%last, curve%edges(size(curve%edges)))
        point = curve%at(high)
        s_high = control%of(point%depth, point%force)
        if (s_high > s) then
            point = curve%find(control, segment%lowest, 1.0_wp, .true., s - segment%lowest, low, high)
            slope = curve%slope(control, point%x)
        else
            slope = curve%slope(control, point%x)
            ! Beyond the samples s follows a power of the radius.
            quantity%is_logarithmic = s_high > 0.0_wp
            if (quantity%is_logarithmic) slope = slope/s_high
        end if
        if (.not. slope > 0.0_wp) slope = merge(2.0_wp, tiny(1.0_wp) + abs(s), quantity%is_logarithmic)
        call solve_increasing(quantity, point%x, slope, segment%first, segment%last, x, found, error)
    end subroutine find_coordinate

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

        if (equilibrium%profile%has_wall .and. min(from%radius, to%radius) >= equilibrium%last_radius) then
            work = 0.5_wp*(from%force + to%force)*(to%depth - from%depth)
        else
            work = self%curve%work_between(equilibrium%coordinate_of(from%radius), equilibrium%coordinate_of(to%radius))
        end if
    end function work_between

    function quantity_at(self, x) result(y)
        class(quantity_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        type(contact_state_t) :: state

        call self%equilibrium%at(self%equilibrium%radius_of(x), state, self%error)
        y = self%control%distance(state%depth, state%force, self%offset, self%is_logarithmic)
    end function quantity_at

end module mdrcontact_contact_branch
