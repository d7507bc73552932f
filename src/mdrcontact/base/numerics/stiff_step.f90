! SPDX-License-Identifier: GPL-3.0-or-later
!> One step of a stiff equation dy/dt = f(t, y) of one unknown, by the L-stable diagonally implicit Runge-Kutta method of order 4
!> with 5 stages and an error estimate of order 3 (Hairer, Wanner, Solving Ordinary Differential Equations II, 1996, section IV.6).
!>
!> Each stage is one equation of one unknown, solved by Newton's method within a bracket: f may be constant, jump in its slope or
!> grow by powers of 10, as the speed of a contact's edge does. GSL's implicit methods solve their stages without a bracket.
module mdrcontact_numerics_stiff_step
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: equation_t, stages, places, weights, stiff_step

    !> Number of stages of a step.
    integer, parameter :: stages = 5
    real(wp), parameter :: diagonal = 0.25_wp
    !> Where in the step the stages lie, the last at its end.
    real(wp), parameter :: places(stages) = [0.25_wp, 0.75_wp, 0.55_wp, 0.5_wp, 1.0_wp]
    !> Weights of the stages in the step.
    real(wp), parameter :: weights(stages) = [25.0_wp/24.0_wp, -49.0_wp/48.0_wp, 125.0_wp/16.0_wp, -85.0_wp/12.0_wp, diagonal]
    !> Column i: how much of the slopes before it stage i takes.
    real(wp), parameter :: taken(stages, stages) = reshape([ &
        0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, &
        0.5_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, &
        17.0_wp/50.0_wp, -1.0_wp/25.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, &
        371.0_wp/1360.0_wp, -137.0_wp/2720.0_wp, 15.0_wp/544.0_wp, 0.0_wp, 0.0_wp, &
        25.0_wp/24.0_wp, -49.0_wp/48.0_wp, 125.0_wp/16.0_wp, -85.0_wp/12.0_wp, 0.0_wp], [stages, stages])
    !> Weights less those of the method of order 3.
    real(wp), parameter :: excess(stages) = [-3.0_wp/16.0_wp, -27.0_wp/32.0_wp, 25.0_wp/32.0_wp, 0.0_wp, diagonal]
    integer, parameter :: most_iterations = 100
    !> A Newton step below this is the last; a root closer to an end of the range is not used.
    real(wp), parameter :: negligible = 1.0e-8_wp, smallest = 4.0_wp*epsilon(1.0_wp), margin = 1.0e-9_wp

    !> dy/dt = f(t, y) for lowest <= y <= highest.
    type, abstract :: equation_t
        real(wp) :: lowest = 0.0_wp, highest = 0.0_wp
    contains
        procedure(rate_of), deferred :: rate
    end type equation_t

    abstract interface
        !> f and df/dy.
        pure subroutine rate_of(self, t, y, f, slope)
            import :: equation_t, wp
            class(equation_t), intent(in) :: self
            real(wp), intent(in) :: t, y
            real(wp), intent(out) :: f, slope
        end subroutine rate_of
    end interface

contains

    !> The step from y at time t over a time h > 0.
    pure subroutine stiff_step(equation, t, h, y, slope_before, reached, slopes, deviation, found)
        class(equation_t), intent(in) :: equation
        real(wp), intent(in) :: t, h, y
        !> dy/dt at the beginning, from which stages are guessed
        real(wp), intent(in) :: slope_before
        !> y and dy/dt at the stages
        real(wp), intent(out) :: reached(stages), slopes(stages)
        !> estimate of the error of the last
        real(wp), intent(out) :: deviation
        !> false: a stage has no root between the lowest and the highest y
        logical, intent(out) :: found
        real(wp) :: base, stiffness
        integer :: i

        reached = y
        slopes = 0.0_wp
        deviation = 0.0_wp
        do i = 1, stages
            base = y + h*dot_product(taken(:i - 1, i), slopes(:i - 1))
            reached(i) = min(max(y + h*places(i)*slope_before, equation%lowest), equation%highest)
            call solve_stage(equation, t + places(i)*h, diagonal*h, base, reached(i), stiffness, found)
            if (.not. found) return
            slopes(i) = (reached(i) - base)/(diagonal*h)
        end do
        ! what is fast dies out: the estimate is taken through the same filter (Hairer and Wanner, (8.20))
        deviation = abs(h*dot_product(excess, slopes))/max(1.0_wp, stiffness)
    end subroutine stiff_step

    !> The root of y - base - h f(t, y), a function that grows where y is stable.
    pure subroutine solve_stage(equation, t, h, base, y, stiffness, found)
        class(equation_t), intent(in) :: equation
        real(wp), intent(in) :: t, h, base
        !> a guess, then the root
        real(wp), intent(inout) :: y
        !> 1 - h df/dy there
        real(wp), intent(out) :: stiffness
        logical, intent(out) :: found
        real(wp) :: low, high, f, slope, missed, step, before
        integer :: i

        low = equation%lowest
        high = equation%highest
        before = high - low
        do i = 1, most_iterations
            call equation%rate(t, y, f, slope)
            missed = y - base - h*f
            stiffness = 1.0_wp - h*slope
            if (missed > 0.0_wp) then
                high = y
            else
                low = y
            end if
            step = 0.5_wp*(low + high) - y
            if (stiffness > 0.0_wp) then
                ! as Newton's method may creep along a high power: halving the bracket is at least as fast
                if (abs(2.0_wp*missed) <= abs(before*stiffness) .and. y - missed/stiffness >= low &
                    .and. y - missed/stiffness <= high) step = -missed/stiffness
            end if
            y = y + step
            before = step
            found = abs(step) <= smallest*max(1.0_wp, abs(y))
            ! errors of Newton's method are of the order of the square of its step
            if (abs(step) <= negligible .and. stiffness > 0.0_wp) found = found .or. step == -missed/stiffness
            if (found) exit
        end do
        found = found .and. y > equation%lowest + margin .and. y < equation%highest - margin
    end subroutine solve_stage

end module mdrcontact_numerics_stiff_step
