! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact radii between which a law must be sampled to cover a range of depths.
module mdrcontact_law_range
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_no_convergence, error_t, error_unreachable, raise, to_text
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: coordinate_beyond, coordinate_before

    !> The depth found may be this much farther out than the one asked for: more costs samples, less costs solutions.
    real(wp), parameter :: margin = 1.03_wp
    integer, parameter :: most_steps = 80
    real(wp), parameter :: widest_step = 4.0_wp
    !> From the last coordinate with a depth too small, when adhesion bends the branch.
    real(wp), parameter :: adhesive_step = 0.25_wp

contains

    !> A coordinate x = ln(a - end radius) at which the depth is at least `depth` > 0.
    subroutine coordinate_beyond(contact, end_radius, largest, depth, x, solutions, error)
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: end_radius, largest, depth
        real(wp), intent(out) :: x
        integer, intent(inout) :: solutions
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        real(wp) :: last
        integer :: step

        last = log(largest - end_radius)
        last = last - 4.0_wp*epsilon(1.0_wp)*max(1.0_wp, abs(last))
        call touch_coordinate(contact, end_radius, -700.0_wp, last, depth, depth*margin, x, solutions, error)
        if (allocated(error) .or. .not. contact%is_adhesive()) return
        do step = 1, most_steps
            call contact%at_radius(end_radius + exp(x), state, error)
            if (allocated(error)) return
            solutions = solutions + 1
            if (state%depth >= depth) return
            if (x >= last) exit
            x = min(x + adhesive_step, last)
        end do
        call raise(error, error_unreachable, "largest_depth = "//to_text(depth)//" cannot be reached: indenter or "// &
                   "medium end at depth "//to_text(state%depth))
    end subroutine coordinate_beyond

    !> A coordinate at which the depth, without adhesion, is at most `depth` > 0.
    subroutine coordinate_before(contact, end_radius, smallest, depth, x, solutions, error)
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: end_radius, smallest, depth
        real(wp), intent(out) :: x
        integer, intent(inout) :: solutions
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: first

        first = -700.0_wp
        if (smallest > end_radius) first = log(smallest - end_radius) + 8.0_wp*epsilon(1.0_wp)
        call touch_coordinate(contact, end_radius, first, 230.0_wp, depth/margin, depth, x, solutions, error)
    end subroutine coordinate_before

    !> A coordinate at which the depth of first touch lies between low and high: secants of ln d over ln a.
    subroutine touch_coordinate(contact, end_radius, first, last, low, high, x, solutions, error)
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: end_radius, first, last, low, high
        real(wp), intent(out) :: x
        integer, intent(inout) :: solutions
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        real(wp) :: touch, mismatch, mismatch_before, x_before, slope, next
        integer :: step

        slope = 2.0_wp
        x = max(first, min(last, 0.5_wp*log(high)))
        do step = 1, most_steps
            call contact%at_radius(end_radius + exp(x), state, error)
            if (allocated(error)) return
            solutions = solutions + 1
            touch = state%depth - state%excess
            if (touch >= low .and. touch <= high) return
            mismatch = log(touch/sqrt(low*high))
            if (step > 1 .and. x /= x_before) slope = max((mismatch - mismatch_before)/(x - x_before), 0.2_wp)
            mismatch_before = mismatch
            x_before = x
            next = max(first, min(last, x - max(-widest_step, min(widest_step, mismatch/slope))))
            if (next == x) then
                call raise(error, error_unreachable, "depth "//to_text(sqrt(low*high))//" cannot be reached: indenter or "// &
                           "medium end at depth "//to_text(touch)//", radius "//to_text(state%radius))
                return
            end if
            x = next
        end do
        call raise(error, error_no_convergence, "no contact radius found for depth "//to_text(sqrt(low*high)))
    end subroutine touch_coordinate

end module mdrcontact_law_range
