! SPDX-License-Identifier: GPL-3.0-or-later
!> Quadrature panels over depth and radius for the weights of theory/lateral.md (2.4), (2.5). Lengths in units of the contact
!> radius.
!>
!> Between breaks (interfaces, touching circles) the integrands are analytic but for square roots at the breaks and the
!> singular ring at rho = 1, z = 0. Panels no longer than their distance from the ring, each with nodes that crowd at both
!> its ends, suit both.
module mdrcontact_lateral_panels
    use, intrinsic :: iso_c_binding, only: c_size_t
    use mdrcontact_gsl, only: gsl_sort
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: rule_t, depth_rule, radius_rule

    !> A quadrature rule.
    type :: rule_t
        real(wp), allocatable :: nodes(:), weights(:)
    end type rule_t

    !> Panels beyond those between breaks.
    integer, parameter :: most_halvings = 4096
    !> Breaks closer than this are merged.
    real(wp), parameter :: same = 1.0e-12_wp

contains

    !> Nodes over all depths z > 0, given Gauss nodes x and weights w on [0, 1].
    pure subroutine depth_rule(breaks, x, w, rule)
        !> any order; those outside 0 < z < infinity are ignored
        real(wp), intent(in) :: breaks(:), x(:), w(:)
        type(rule_t), intent(out) :: rule
        real(wp) :: edges(0:size(breaks) + 2 + most_halvings), first, last
        integer :: count

        call sorted_breaks([breaks, 0.5_wp, 2.0_wp], edges, count)
        last = edges(count)
        call refine_to_ring(edges, count, 0.0_wp, is_depth=.true.)
        first = edges(1)
        call fill(edges(:count), x, w, rule)
        ! the logarithm at the surface: z = first u^4 in the first panel
        associate (n => size(x))
            rule%nodes(:n) = first*x**4
            rule%weights(:n) = 4.0_wp*first*x**3*w
        end associate
        call add_infinite(last, x, w, rule)
    end subroutine depth_rule

    !> Nodes over all radii at depth z.
    pure subroutine radius_rule(breaks, z, x, w, rule)
        real(wp), intent(in) :: breaks(:), z, x(:), w(:)
        type(rule_t), intent(out) :: rule
        real(wp) :: edges(0:size(breaks) + 2 + most_halvings), last
        integer :: count

        call sorted_breaks([breaks, 1.0_wp, 2.0_wp*max(1.0_wp, z)], edges, count)
        last = edges(count)
        call refine_to_ring(edges, count, z, is_depth=.false.)
        call fill(edges(:count), x, w, rule)
        call add_infinite(last, x, w, rule)
    end subroutine radius_rule

    !> Ascending edges from 0 on, without repetitions.
    pure subroutine sorted_breaks(breaks, edges, count)
        real(wp), intent(in) :: breaks(:)
        real(wp), intent(inout) :: edges(0:)
        integer, intent(out) :: count
        real(wp) :: sorted(size(breaks))
        integer :: i

        sorted = breaks
        call gsl_sort(sorted, 1_c_size_t, size(sorted, kind=c_size_t))
        count = 0
        edges(0) = 0.0_wp
        do i = 1, size(sorted)
            if (sorted(i) <= edges(count) + same*(1.0_wp + edges(count)) .or. sorted(i) >= 1.0e15_wp) cycle
            count = count + 1
            edges(count) = sorted(i)
        end do
    end subroutine sorted_breaks

    !> Halves panels until none is longer than its distance from the ring (and, over depth, than its own upper end's depth).
    pure subroutine refine_to_ring(edges, count, z, is_depth)
        real(wp), intent(inout) :: edges(0:)
        integer, intent(inout) :: count
        real(wp), intent(in) :: z
        logical, intent(in) :: is_depth
        real(wp) :: low, high, distance
        integer :: i

        i = merge(2, 1, is_depth)
        do while (i <= count)
            low = edges(i - 1)
            high = edges(i)
            if (is_depth) then
                distance = 1.5_wp*low
            else
                distance = hypot(min(max(1.0_wp, low), high) - 1.0_wp, z)
            end if
            if (high - low > distance .and. high - low > 1.0e-9_wp .and. count < ubound(edges, 1)) then
                edges(i + 1:count + 1) = edges(i:count)
                edges(i) = 0.5_wp*(low + high)
                count = count + 1
            else
                i = i + 1
            end if
        end do
    end subroutine refine_to_ring

    !> In each panel u -> 3 u^2 - 2 u^3: square roots at its ends become analytic.
    pure subroutine fill(edges, x, w, rule)
        real(wp), intent(in) :: edges(0:), x(:), w(:)
        type(rule_t), intent(out) :: rule
        integer :: panel, first, n

        n = size(x)
        allocate (rule%nodes(n*ubound(edges, 1)), rule%weights(n*ubound(edges, 1)))
        do panel = 1, ubound(edges, 1)
            first = (panel - 1)*n
            associate (length => edges(panel) - edges(panel - 1))
                rule%nodes(first + 1:first + n) = edges(panel - 1) + length*x**2*(3.0_wp - 2.0_wp*x)
                rule%weights(first + 1:first + n) = length*6.0_wp*x*(1.0_wp - x)*w
            end associate
        end do
    end subroutine fill

    !> From `last` to infinity, in last/u.
    pure subroutine add_infinite(last, x, w, rule)
        real(wp), intent(in) :: last, x(:), w(:)
        type(rule_t), intent(inout) :: rule

        associate (u => x**2*(3.0_wp - 2.0_wp*x))
            rule%weights = [rule%weights, 6.0_wp*x*(1.0_wp - x)*w*last/u**2]
            rule%nodes = [rule%nodes, last/u]
        end associate
    end subroutine add_infinite

end module mdrcontact_lateral_panels
