! SPDX-License-Identifier: GPL-3.0-or-later
!> The flat punch on a half-space with surface tension, tabulated: c/l is a function of a/l alone and serves all indenters, and as
!> A c = pi e does not depend on a, v = A^-1 (dA/da) c = -dc/da.
module mdrcontact_tension_table
    use mdrcontact_body_compliance, only: compliance_t
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_chebyshev, only: node
    use mdrcontact_tension_green, only: green_t, new_green
    use mdrcontact_tension_solution, only: cosines_for, extrapolated, solution_t, solve_punch
    implicit none (type, external)
    private
    public :: punch_table_t, new_punch_table

    !> Decades of a/l, one a panel: from 10^first on, so many.
    integer, parameter :: first_decade = -3, decades = 5
    !> Values in a panel, analytic for |Im ln(a/l)| < pi, and its largest error between the samples, relative.
    integer, parameter :: terms = 18
    real(wp), parameter :: allowed = 1.0e-10_wp, between = 0.31_wp

    !> Series over ln(a/l) of a decade: (coefficient, term).
    type :: panel_t
        real(wp), allocatable :: punch(:, :)
    end type panel_t

    !> Made by new_punch_table.
    type :: punch_table_t
        private
        type(panel_t), allocatable :: panels(:)
        !> the largest relative difference from the solver where it was not sampled
        real(wp), public :: error = 0.0_wp
    contains
        procedure :: covers
        procedure :: at
    end type punch_table_t

contains

    !> The table; error_no_convergence where it misses the solver between its nodes.
    subroutine new_punch_table(self, half_space, error)
        type(punch_table_t), intent(out) :: self
        !> the compliance of any half-space without layers
        class(compliance_t), intent(in) :: half_space
        type(error_t), allocatable, intent(inout) :: error
        type(green_t) :: green
        type(solution_t) :: solution, again
        integer :: i

        call new_green(green, 1.0_wp, 0.0_wp, 2.0_wp*10.0_wp**(first_decade + decades), error)
        allocate (self%panels(decades))
        do i = 1, decades
            call fill_panel(self%panels(i), green, half_space, first_decade + i - 1, error)
            if (allocated(error)) return
            call solve_punch(solution, green, half_space, 10.0_wp**(first_decade + i - 1 + between), error)
            if (allocated(error)) return
            call self%at(1.0_wp, solution%radius, again)
            self%error = max(self%error, abs(again%punch(1)/extrapolated(solution%punch(1), solution%fewer_punch(1)) - 1.0_wp), &
                             abs(again%rate(1)/extrapolated(solution%rate(1), solution%fewer_rate(1)) - 1.0_wp))
        end do
        if (self%error > allowed) then
            call raise(error, error_no_convergence, "the table of flat punches under surface tension has an error of "// &
                       to_text(self%error))
        end if
    end subroutine new_punch_table

    subroutine fill_panel(panel, green, half_space, decade, error)
        type(panel_t), intent(out) :: panel
        type(green_t), intent(in) :: green
        class(compliance_t), intent(in) :: half_space
        integer, intent(in) :: decade
        type(error_t), allocatable, intent(inout) :: error
        type(solution_t) :: solution
        real(wp), allocatable :: punch(:, :)
        real(wp) :: waves(terms, terms), a
        integer :: i, j, n, fewer

        n = cosines_for(green, 10.0_wp**(decade + 1), 0.0_wp)
        fewer = (2*n)/3
        allocate (punch(n, terms))
        do i = 1, terms
            a = 10.0_wp**(decade + 0.5_wp*(1.0_wp + node(i, terms)))
            call solve_punch(solution, green, half_space, a, error, n, rates=.false.)
            if (allocated(error)) return
            punch(:, i) = solution%punch
            punch(:fewer, i) = extrapolated(solution%punch(:fewer), solution%fewer_punch)
            do j = 1, terms
                waves(i, j) = merge(1.0_wp, 2.0_wp, j == 1)/terms*cos(pi*(j - 1)*(i - 0.5_wp)/terms)
            end do
        end do
        punch(fewer + 1:, :) = extrapolated(punch(fewer + 1:, :), 0.0_wp)
        panel%punch = matmul(punch, waves)
    end subroutine fill_panel

    !> Whether a contact of this a/l lies in the table.
    elemental function covers(self, ratio) result(answer)
        class(punch_table_t), intent(in) :: self
        real(wp), intent(in) :: ratio
        logical :: answer

        answer = allocated(self%panels) .and. ratio >= 10.0_wp**first_decade .and. ratio < 10.0_wp**(first_decade + decades)
    end function covers

    !> The flat punch of radius a on a surface with length l = 2 tau/E0*.
    pure subroutine at(self, length, a, solution)
        class(punch_table_t), intent(in) :: self
        !> l and a [length], a/l in the table
        real(wp), intent(in) :: length, a
        type(solution_t), intent(out) :: solution
        real(wp) :: x, wave(terms), slope(terms)
        integer :: i, j

        x = log10(a/length) - first_decade
        i = min(int(x) + 1, decades)
        x = 2.0_wp*(x - (i - 1)) - 1.0_wp
        wave(1) = 1.0_wp
        wave(2) = x
        slope(:2) = [0.0_wp, 1.0_wp]
        do j = 3, terms
            wave(j) = 2.0_wp*x*wave(j - 1) - wave(j - 2)
            slope(j) = 2.0_wp*wave(j - 1) + 2.0_wp*x*slope(j - 1) - slope(j - 2)
        end do
        solution%radius = a
        solution%punch = length*matmul(self%panels(i)%punch, wave)
        ! x = 2 log10(a/l) + ...
        solution%rate = -length/a*2.0_wp/log(10.0_wp)*matmul(self%panels(i)%punch, slope)
    end subroutine at

end module mdrcontact_tension_table
