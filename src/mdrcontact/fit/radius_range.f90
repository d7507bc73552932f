! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact radii that belong to a range of depths, roughly: by steps in ln a from a guess.
module mdrcontact_fit_radius_range
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_error, only: error_t, error_unreachable, raise, to_text
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: radius_range, last_coordinate

    real(wp), parameter :: first_step = 0.15_wp, largest_step = 2.0_wp
    integer, parameter :: most_steps = 400
    !> Depths below this part of the largest one are extrapolated.
    real(wp), parameter :: smallest_depth_ratio = 1.0e-6_wp
    !> The ends lie so far, in ln a, beyond where the depths should.
    real(wp), parameter :: margin = 0.02_wp

contains

    !> ln(a - end radius) of two radii between which all depths from `smallest` to `largest` occur, the lower one at or below
    !> pull-off if there is adhesion.
    subroutine radius_range(equilibrium, smallest, largest, first, last, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: smallest, largest
        real(wp), intent(out) :: first, last
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: d, d_before, before, last_depth, below, below_depth, step, lowest
        logical :: adhesive
        integer :: i

        first = 0.0_wp
        last = 0.0_wp
        if (.not. (abs(smallest) + abs(largest) <= huge(1.0_wp) .and. max(abs(smallest), largest) > 0.0_wp)) then
            call raise(error, error_unreachable, "depths from "//to_text(smallest)//" to "//to_text(largest)//" make no curve")
            return
        end if
        ! an adhesive contact may lie below depth 0 altogether
        last = guess(equilibrium, max(largest, abs(smallest)))
        call depth_at(equilibrium, last, d, error)
        if (allocated(error)) return
        step = first_step
        do i = 1, most_steps
            if (d >= largest) exit
            if (last >= last_coordinate(equilibrium)) exit
            last = min(last + step, last_coordinate(equilibrium))
            step = min(2.0_wp*step, largest_step)
            call depth_at(equilibrium, last, d, error)
            if (allocated(error)) return
        end do
        if (d < largest .and. .not. equilibrium%profile%has_wall()) then
            call raise(error, error_unreachable, "depth = "//to_text(largest)//" cannot be reached: the indenter or the medium "// &
                       "ends at depth "//to_text(d))
            return
        end if
        adhesive = equilibrium%work_of_adhesion > 0.0_wp
        lowest = max(smallest, smallest_depth_ratio*largest)
        if (adhesive) lowest = smallest
        first = last
        step = first_step
        last_depth = d
        below = last
        below_depth = d
        do i = 1, most_steps
            before = first
            d_before = d
            first = first - step
            call depth_at(equilibrium, first, d, error)
            if (allocated(error)) return
            if (d > largest) then
                last = first
                last_depth = d
            else if (.not. below < last) then
                below = first
                below_depth = d
            end if
            if (d <= lowest) exit
            if (adhesive) then
                if (d > d_before) exit
            else
                step = min(2.0_wp*step, largest_step)
            end if
        end do
        if (adhesive .or. .not. (d > 0.0_wp .and. d < d_before)) return
        call tighten(equilibrium, lowest, -margin, before, d_before, first, d, error)
        if (.not. allocated(error) .and. last_depth > largest) then
            call tighten(equilibrium, largest, margin, below, below_depth, last, last_depth, error)
        end if
    end subroutine radius_range

    !> Moves the end x with depth d towards the coordinate where the depth is `wanted`, as the straight line in ln d says that
    !> begins at the other end, but for a margin; only if the depth is still beyond `wanted` there.
    subroutine tighten(equilibrium, wanted, beyond, other, other_depth, x, d, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: wanted
        !> the margin, negative at the lower end
        real(wp), intent(in) :: beyond
        real(wp), intent(in) :: other, other_depth
        real(wp), intent(inout) :: x, d
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: candidate, candidate_depth

        candidate = x + (other - x)*log(wanted/d)/log(other_depth/d) + beyond
        if (.not. abs(candidate - other) < abs(x - other) - abs(beyond)) return
        call depth_at(equilibrium, candidate, candidate_depth, error)
        if (allocated(error) .or. (candidate_depth - wanted)*beyond < 0.0_wp) return
        x = candidate
        d = candidate_depth
    end subroutine tighten

    !> The coordinate of the largest radius of this contact.
    pure function last_coordinate(equilibrium) result(x)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp) :: x

        x = equilibrium%coordinate_of(equilibrium%last_radius)
    end function last_coordinate

    !> Where to begin: the radius at which a homogeneous body has that depth, or a step beyond the flat end.
    function guess(equilibrium, depth) result(x)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: depth
        real(wp) :: x
        real(wp) :: radius, lower, upper
        integer :: i

        radius = equilibrium%profile%radius_from_mdr(depth)
        if (radius > equilibrium%profile%end_radius()) then
            x = equilibrium%coordinate_of(radius)
        else
            ! bisection in the coordinate: g rises with the radius
            lower = log(depth) - 20.0_wp
            upper = min(log(depth) + 20.0_wp, last_coordinate(equilibrium))
            do i = 1, 30
                x = 0.5_wp*(lower + upper)
                if (equilibrium%profile%mdr(equilibrium%radius_of(x)) < depth) then
                    lower = x
                else
                    upper = x
                end if
            end do
        end if
        x = min(x, last_coordinate(equilibrium))
    end function guess

    subroutine depth_at(equilibrium, x, d, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: x
        real(wp), intent(out) :: d
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state

        d = 0.0_wp
        call equilibrium%at(equilibrium%radius_of(x), state, error)
        if (.not. allocated(error)) d = state%depth
    end subroutine depth_at

end module mdrcontact_fit_radius_range
