! SPDX-License-Identifier: GPL-3.0-or-later
!> Nodes of a cohesive zone a < x < c, in which the springs carry q = -2 sigma_0 sqrt(c^2 - x^2): integrals of what is analytic but
!> for this root, the kinks of the indenter's g, and the scale of the body's kernel.
!>
!> The panel at c has x = c - L y^2, so that root and pole are analytic in y; one behind a kink of g has x = b + L t^2.
module mdrcontact_line_zone_rule
    use mdrcontact_error, only: check_memory, error_no_convergence, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: zone_rule_t, new_zone_rule, rule_breaks

    !> Nodes of a panel, at most and at least.
    integer, parameter :: most_nodes = 20, least_nodes = 6
    !> Panels of so many thicknesses of the first layer at most, with a root at an end and without one; the layer has its nearest
    !> pole at twice its thickness [unit].
    real(wp), parameter :: longest_panel = 2.0_wp, longest_plain = 4.0_wp, pole = 2.0_wp
    !> Towards the axis, where g may be a broken power, panels shrink by this factor, down to this part of the zone's end.
    real(wp), parameter :: shrinking = 0.125_wp, nearest_axis = 1.0e-8_wp
    integer, parameter :: most_panels = 200
    !> Where the kernel varies at all lengths, panels are at most so many times as long as they are away from a.
    real(wp), parameter :: fastest_growth = 3.0_wp

    !> Nodes of one zone.
    type :: zone_rule_t
        !> x, and x - a without cancellation [length]
        real(wp), allocatable :: x(:), beyond(:)
        !> sqrt(c^2 - x^2) [length], dx [length], dx/sqrt(c^2 - x^2) [1]
        real(wp), allocatable :: root(:), dx(:), over_root(:)
    end type zone_rule_t

contains

    !> Radii where a rule must be split for any zone: the kinks of g, and where g is a broken power at the axis some more towards
    !> it.
    pure subroutine rule_breaks(profile, is_power, breaks, error)
        class(profile_t), intent(in) :: profile
        !> g is analytic next to the axis
        logical, intent(in) :: is_power
        !> ascending [length]; the first is 0, from which panels shrink if g is not analytic there, else negative
        real(wp), allocatable, intent(out) :: breaks(:)
        type(error_t), allocatable, intent(inout) :: error

        call profile%add_breaks(breaks, error)
        if (allocated(error)) return
        breaks = [merge(-1.0_wp, 0.0_wp, is_power), breaks]
    end subroutine rule_breaks

    !> The nodes of the zone of length `length` beyond the contact radius a.
    subroutine new_zone_rule(self, a, length, breaks, unit, tolerance, error, loaded, graded)
        type(zone_rule_t), intent(out) :: self
        !> a >= 0, c - a > 0 [length]
        real(wp), intent(in) :: a, length
        !> of rule_breaks
        real(wp), intent(in) :: breaks(:)
        !> thickness of the first layer; huge() without layers [length]
        real(wp), intent(in) :: unit
        !> relative, of the integrals
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(inout) :: error
        !> the distance from a at which the load ends, beyond which panels may grow; default: they stay short [length]
        real(wp), intent(in), optional :: loaded
        !> the kernel varies at all lengths, and panels grow from a on; default false
        logical, intent(in), optional :: graded
        !> ends of the panels, from a
        real(wp) :: ends(0:most_panels), node(most_nodes), weight(most_nodes), last
        logical :: behind_kink(most_panels)
        integer :: panels, nodes(most_panels), i, first, stat
        real(wp) :: growth

        growth = 0.0_wp
        if (present(graded)) growth = merge(fastest_growth, 0.0_wp, graded)
        last = length
        if (present(loaded)) last = loaded
        call find_panels(a, length, last, breaks, unit, growth, ends, behind_kink, panels)
        if (panels > most_panels) then
            call raise(error, error_no_convergence, "the cohesive zone spans too many thicknesses of the first layer, or kinks "// &
                       "of the indenter: a larger cohesive_stress makes it shorter")
            return
        end if
        do i = 1, panels
            nodes(i) = nodes_for(a + length, length - ends(i), ends(i) - ends(i - 1), i == panels .or. behind_kink(i), &
                                 behind(breaks, a + ends(i - 1)), unit, merge(ends(i - 1), 0.0_wp, growth > 0.0_wp), &
                                 merge(tolerance*(length/(ends(i) - ends(i - 1))), tolerance, growth > 0.0_wp))
        end do
        i = sum(nodes(:panels))
        allocate (self%x(i), self%beyond(i), self%root(i), self%dx(i), self%over_root(i), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        first = 1
        do i = 1, panels
            call gauss_legendre(node(:nodes(i)), weight(:nodes(i)), error)
            if (allocated(error)) return
            associate (last => first + nodes(i) - 1)
                call place(a, length, ends(i - 1), ends(i), behind_kink(i), i == panels, node(:nodes(i)), weight(:nodes(i)), &
                           self%beyond(first:last), self%dx(first:last), self%root(first:last), self%over_root(first:last))
            end associate
            first = first + nodes(i)
        end do
        self%x = a + self%beyond
    end subroutine new_zone_rule

    !> Number of nodes that meet the tolerance on a panel: errors fall as rho^(-2n) for the ellipse through the nearest singularity,
    !> that of the kernel next to the panel, the root at the end of the zone, or a kink of g behind the panel.
    pure function nodes_for(end, left, long, has_root, passed, unit, away, tolerance) result(nodes)
        !> c, what is left of the zone behind the panel, its own length
        real(wp), intent(in) :: end, left, long
        !> the panel is one in y, with y^2 the distance from an end
        logical, intent(in) :: has_root
        !> distance of the last kink behind the panel, 0 at its beginning
        real(wp), intent(in) :: passed
        real(wp), intent(in) :: unit
        !> distance behind the panel at which the kernel may be singular, in addition to the unit
        real(wp), intent(in) :: away
        real(wp), intent(in) :: tolerance
        integer :: nodes
        real(wp) :: z, rho, digits

        if (has_root) then
            z = 2.0_wp*sqrt(max(2.0_wp*min(end, max(pole*unit, 0.5_wp*(long + away)))/long, 1.0_wp)) - 1.0_wp
            if (passed > 0.0_wp .and. passed < end) z = min(z, 2.0_wp*sqrt(1.0_wp + passed/long) - 1.0_wp)
            if (left > 0.0_wp) z = min(z, 2.0_wp*sqrt(1.0_wp + left/long) - 1.0_wp)
        else
            z = min(max(hypot(1.0_wp, 2.0_wp*pole*(unit/long)), 1.0_wp + 2.0_wp*away/long), 1.0_wp + 2.0_wp*left/long)
            if (passed < end) z = min(z, 1.0_wp + 2.0_wp*passed/long)
        end if
        rho = z + sqrt((z - 1.0_wp)*(z + 1.0_wp))
        digits = 2.0_wp - 0.5_wp*log(min(tolerance, 1.0_wp))
        nodes = least_nodes
        ! rho is 1 where a singularity lies at the panel itself
        if (rho < huge(1.0_wp)) nodes = max(nodes, min(ceiling(digits/max(log(rho), digits/most_nodes)), most_nodes))
    end function nodes_for

    !> Distance from x to the last point at which g is not analytic; huge() where it is on all that is before.
    pure function behind(breaks, x) result(distance)
        real(wp), intent(in) :: breaks(:), x
        real(wp) :: distance

        distance = huge(x)
        if (any(breaks >= 0.0_wp .and. breaks <= x*(1.0_wp + 4.0_wp*epsilon(x)))) distance = &
            x - min(x, maxval(breaks, mask=breaks <= x*(1.0_wp + 4.0_wp*epsilon(x))))
    end function behind

    !> Ends of the panels by their distance from a.
    pure subroutine find_panels(a, length, loaded, breaks, unit, growth, ends, behind_kink, panels)
        real(wp), intent(in) :: a, length, loaded, breaks(:), unit
        !> a panel is so many times as long as it is away from a, if that is more; one with a root at its end as long as that
        real(wp), intent(in) :: growth
        real(wp), intent(out) :: ends(0:)
        !> whether g may have a root at the beginning of the panel
        logical, intent(out) :: behind_kink(:)
        !> more than there is room for: too many
        integer, intent(out) :: panels
        real(wp) :: here, next, step
        integer :: k
        logical :: kinked

        panels = 0
        here = 0.0_wp
        ends(0) = 0.0_wp
        kinked = any(abs(breaks(2:) - a) <= 4.0_wp*epsilon(a)*a)
        do
            next = length
            k = findloc(breaks(2:) > (a + here)*(1.0_wp + 4.0_wp*epsilon(a)), .true., dim=1)
            if (k > 0) next = min(next, breaks(k + 1) - a)
            step = longest_panel*unit + min(growth, 1.0_wp)*here
            ! a root at c is left to a panel that is not long
            if (.not. kinked .and. next - here > 1.2_wp*step) then
                step = min(longest_plain*unit + growth*here, max(next - here - step, 0.5_wp*step))
            end if
            step = step + max(here - loaded, 0.0_wp)
            ! away from a kink just passed, and from the axis
            if (k == 0) k = size(breaks)
            if (a + here > breaks(k) .and. breaks(k) > 0.0_wp .and. .not. kinked) step = min(step, 3.0_wp*(a + here - breaks(k)))
            if (.not. breaks(1) < 0.0_wp) step = min(step, max(a + here, nearest_axis*(a + length))*(1.0_wp/shrinking - 1.0_wp))
            ! a root at either end of a panel, not at both, and panels up to a kink shrink towards that of c beyond it
            if (kinked .or. next < length) step = min(step, 0.5_wp*(length - here))
            if (here + 1.2_wp*step < next) next = here + step
            panels = panels + 1
            if (panels > size(behind_kink)) return
            behind_kink(panels) = kinked
            ends(panels) = next
            if (next >= length) return
            here = next
            kinked = any(abs(breaks(2:) - (a + here)) <= 4.0_wp*epsilon(a)*(a + here))
        end do
    end subroutine find_panels

    !> The nodes of one panel.
    pure subroutine place(a, length, from, to, behind_kink, is_last, node, weight, beyond, dx, root, over_root)
        real(wp), intent(in) :: a, length, from, to
        logical, intent(in) :: behind_kink, is_last
        real(wp), intent(in) :: node(:), weight(:)
        real(wp), intent(out) :: beyond(:), dx(:), root(:), over_root(:)
        real(wp) :: left(size(node))

        if (is_last) then
            ! distances from c, and dx over the root of them
            left = (to - from)*node**2
            beyond = from + (to - from)*((1.0_wp - node)*(1.0_wp + node))
            over_root = 2.0_wp*sqrt(to - from)*weight/sqrt(2.0_wp*(a + length) - left)
            root = node*sqrt((to - from)*(2.0_wp*(a + length) - left))
            dx = over_root*root
            return
        else if (behind_kink) then
            beyond = from + (to - from)*node**2
            dx = 2.0_wp*(to - from)*node*weight
        else
            beyond = from + (to - from)*node
            dx = (to - from)*weight
        end if
        left = length - beyond
        root = sqrt(left*(2.0_wp*(a + length) - left))
        over_root = dx/root
    end subroutine place

end module mdrcontact_line_zone_rule
