! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of x on panels, x = low + (high - low) (3 s^2 - 2 s^3), polynomials in s: what goes as the root of the distance from an
!> end, as memories do where an edge has turned and g(x) does next to a flat end, is smooth in s. Gauss-Lobatto nodes of s: the ends
!> are nodes.
module mdrcontact_time_panels
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_quadrature, only: legendre
    implicit none (type, external)
    private
    public :: panels_t, new_panels, interpolate, per_panel, add_turn, cut

    !> Nodes in a panel.
    integer, parameter :: per_panel = 16
    !> Largest number of turns of the radius that end panels.
    integer, parameter :: most_turns = 16
    !> Ends weigh nothing, and what is divided by weights nothing else.
    real(wp), parameter :: no_weight = 1.0e-30_wp

    !> Adjoining panels on which functions are known at Lobatto's nodes.
    type :: panels_t
        !> (0:count) ends; nodes and weights, (per_panel*count)
        real(wp), allocatable :: ends(:), x(:), weights(:)
        !> Lobatto's nodes of s, and the weights of interpolation between them
        real(wp), private :: nodes(per_panel) = 0.0_wp, barycentric(per_panel) = 0.0_wp
    end type panels_t

contains

    !> Nodes between ascending ends.
    pure function new_panels(ends) result(self)
        real(wp), intent(in) :: ends(0:)
        type(panels_t) :: self
        real(wp) :: nodes(per_panel), weights(per_panel)
        integer :: i, j, first

        call lobatto(nodes, weights)
        self%nodes = nodes
        do i = 1, per_panel
            self%barycentric(i) = 1.0_wp
            do j = 1, per_panel
                if (j /= i) self%barycentric(i) = self%barycentric(i)/(nodes(i) - nodes(j))
            end do
        end do
        self%barycentric = self%barycentric/maxval(abs(self%barycentric))
        weights = max(6.0_wp*nodes*(1.0_wp - nodes)*weights, no_weight)
        nodes = nodes**2*(3.0_wp - 2.0_wp*nodes)
        allocate (self%ends(0:ubound(ends, 1)))
        self%ends = ends
        allocate (self%x(per_panel*ubound(ends, 1)), self%weights(per_panel*ubound(ends, 1)))
        do i = 1, ubound(ends, 1)
            first = per_panel*(i - 1)
            self%x(first + 1:first + per_panel) = ends(i - 1) + (ends(i) - ends(i - 1))*nodes
            self%x(first + per_panel) = ends(i)
            self%weights(first + 1:first + per_panel) = (ends(i) - ends(i - 1))*weights
        end do
    end function new_panels

    !> Values (size(x), :) of functions with the given values at the nodes, by each panel's polynomial; 0 beyond the last end.
    pure function interpolate(panels, values, x) result(found)
        type(panels_t), intent(in) :: panels
        real(wp), intent(in) :: values(:, :), x(:)
        real(wp) :: found(size(x), size(values, 2))
        real(wp) :: s, row(per_panel)
        integer :: i, j, panel, first

        found = 0.0_wp
        if (size(panels%x) == 0) return
        panel = 1
        do i = 1, size(x)
            if (x(i) > panels%ends(ubound(panels%ends, 1))) cycle
            if (x(i) < panels%ends(panel - 1)) panel = 1
            do while (x(i) > panels%ends(panel))
                panel = panel + 1
            end do
            s = (x(i) - panels%ends(panel - 1))/(panels%ends(panel) - panels%ends(panel - 1))
            s = 0.5_wp - sin(asin(1.0_wp - 2.0_wp*s)/3.0_wp)
            first = per_panel*(panel - 1)
            j = minloc(abs(s - panels%nodes), dim=1)
            if (abs(s - panels%nodes(j)) < 4.0_wp*epsilon(s)) then
                found(i, :) = values(first + j, :)
            else
                row = panels%barycentric/(s - panels%nodes)
                found(i, :) = matmul(row/sum(row), values(first + 1:first + per_panel, :))
            end if
        end do
    end function interpolate

    !> Add a turn in ascending order. Very near turns are merged, and the two nearest ones if there are too many.
    pure subroutine add_turn(turns, radius, limit)
        real(wp), allocatable, intent(inout) :: turns(:)
        real(wp), intent(in) :: radius, limit
        integer :: n

        if (any(abs(turns - radius) <= 1.0e-6_wp*limit)) return
        turns = [pack(turns, turns < radius), radius, pack(turns, turns > radius)]
        n = size(turns)
        if (n <= most_turns) return
        n = minloc(turns(2:) - turns(:n - 1), dim=1)
        turns = [turns(:n), turns(n + 2:)]
    end subroutine add_turn

    !> Ends of panels, none longer than allowed.
    pure function cut(ends, longest) result(finer)
        real(wp), intent(in) :: ends(:), longest
        real(wp), allocatable :: finer(:)
        integer :: i, j, pieces

        finer = ends(:1)
        do i = 2, size(ends)
            pieces = max(1, ceiling((ends(i) - ends(i - 1))/longest))
            finer = [finer, (ends(i - 1) + (ends(i) - ends(i - 1))*j/pieces, j=1, pieces - 1), ends(i)]
        end do
    end function cut

    !> Gauss-Lobatto nodes and weights on [0, 1].
    pure subroutine lobatto(nodes, weights)
        real(wp), intent(out) :: nodes(per_panel), weights(per_panel)
        integer, parameter :: n = per_panel - 1
        real(wp) :: x, p(1, n + 1), step
        integer :: i, trial

        do i = 0, n
            x = -cos(pi*real(i, wp)/real(n, wp))
            do trial = 1, 50
                p = legendre(n + 1, [x])
                ! zeros of (1 - x^2) P_n'
                step = (x*p(1, n + 1) - p(1, n))/(real(n + 1, wp)*p(1, n + 1))
                if (i == 0 .or. i == n) step = 0.0_wp
                x = x - step
                if (abs(step) < 1.0e-16_wp) exit
            end do
            nodes(i + 1) = 0.5_wp*(1.0_wp + x)
            weights(i + 1) = 1.0_wp/(real(n*(n + 1), wp)*p(1, n + 1)**2)
        end do
        nodes(1) = 0.0_wp
        nodes(per_panel) = 1.0_wp
    end subroutine lobatto

end module mdrcontact_time_panels
