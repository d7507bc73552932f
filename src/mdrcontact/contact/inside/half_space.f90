! SPDX-License-Identifier: GPL-3.0-or-later
!> Stresses and displacements inside a homogeneous half-space under a line load q(x), by closed kernels integrated by parts.
!>
!> A wave exp(-lambda k z) represents a function f of zeta = lambda z + i x under the integral I[f] = (1/pi) int_0^a q Re f dx, and
!> I[f] = (1/pi) {q(a) Im P(lambda z + i a) - int_0^a q' Im P dx} with dP/dzeta = f (theory/stress.md (4.1), (4.8)): no factor a/z
!> is lost near the surface. The extensions provide the functions P: mdrcontact_inside_isotropic, mdrcontact_inside_transverse.
module mdrcontact_inside_half_space
    use mdrcontact_medium_load, only: load_t, panel_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: half_space_t, half_space_rule_t, new_half_space_rule, integrate, on_surface
    public :: normal_sums, shear_sums

    !> Number of sums for the field of a normal and of a shear load, see add_normal and add_shear.
    integer, parameter :: normal_sums = 5, shear_sums = 8

    !> Nodes of a panel no longer than its distance to the nearest singularity: 1e-15 of the integral.
    integer, parameter :: nodes = 10
    !> Nodes that are worked on together.
    integer, parameter :: chunk = 64*nodes
    !> A panel is not made shorter than this part of a.
    real(wp), parameter :: shortest = 1.0e-18_wp

    !> Length of the panel next to an axis where q' is a broken power, relative to the distance of the point, and, for the point at
    !> the apex itself, of the part that is integrated as a power.
    real(wp), parameter :: first_beside_axis = 1.0e-6_wp, first_at_apex = 1.0e-17_wp

    !> The nodes of a panel on [0, 1], and the panels in which a polynomial follows q', from the axis and from each kink.
    type :: half_space_rule_t
        real(wp) :: node(nodes) = 0.0_wp, weight(nodes) = 0.0_wp
        !> distances of their ends from the axis or the last kink, and how long a panel of this rule in them may be [a]
        real(wp), allocatable :: last(:), longest(:)
        !> where those of the axis, 0, and of each kink begin in these lists
        integer, allocatable :: first(:)
    end type half_space_rule_t

    !> Positions between two neighbouring places where the integrand is not analytic, relative to r [a]. They are differences of
    !> lengths, so that they keep their digits where r is close to a kink or to the edge.
    type :: segment_t
        !> r [a]
        real(wp) :: r = 0.0_wp
        !> its ends
        real(wp) :: low = 0.0_wp, high = 0.0_wp
        !> the last kink up to its beginning and the one before; far away if it does not exist
        real(wp) :: kink = -0.5_wp*huge(1.0_wp), kink_before = -0.5_wp*huge(1.0_wp)
        !> whether q' is infinite at its end
        logical :: steep_end = .false.
        !> from where distances are given to the load, that kink or the axis [length], and relative to r
        real(wp) :: start = 0.0_wp, origin = 0.0_wp
        !> panels of the rule: the one where the next panel begins, and the last one before the end
        integer :: first_panel = 1, last_panel = 0
        !> the largest distance from there [length]: rounding must not pass a kink at its end, beyond which q' may be infinite
        real(wp) :: last = 0.0_wp
    end type segment_t

    !> A material below a plane surface.
    type, abstract :: half_space_t
        !> the least real part of lambda, and the largest imaginary one
        real(wp) :: decay = 1.0_wp, turn = 0.0_wp
        !> how many functions have an integral, and how many of them a normal load takes
        integer :: functions = 0, normal_functions = 0
        !> -s_rr/p, -s_tt/p and, on the axis, either of them on the surface where p is infinite
        real(wp) :: singular(3) = 1.0_wp
    contains
        !> adds this body's part to the sums of a normal load, and of one that shears
        procedure(add_sums), deferred :: add_normal
        procedure(add_sums), deferred :: add_shear
        !> adds sums of weight Im P(lambda z + i (r + t)) for its functions
        procedure(add_kernel_sums), deferred :: add_kernels
    end type half_space_t

    abstract interface
        pure subroutine add_sums(self, z, i, sums)
            import :: half_space_t, wp
            class(half_space_t), intent(in) :: self
            !> depth of a point [a], and I[f] there
            real(wp), intent(in) :: z, i(:)
            real(wp), intent(inout) :: sums(:)
        end subroutine add_sums

        pure subroutine add_kernel_sums(self, r, z, t, weight, integrals)
            import :: half_space_t, wp
            class(half_space_t), intent(in) :: self
            real(wp), intent(in) :: r, z, t(:), weight(:)
            real(wp), intent(inout) :: integrals(:)
        end subroutine add_kernel_sums
    end interface

contains

    !> The rule that all points under a load share.
    subroutine new_half_space_rule(self, load, error)
        type(half_space_rule_t), intent(out) :: self
        class(load_t), intent(in) :: load
        type(error_t), allocatable, intent(inout) :: error
        type(panel_t), allocatable :: panels(:)
        integer :: i, stat

        call gauss_legendre(self%node, self%weight, error)
        call load%panels(load%radius, panels, error)
        if (allocated(error)) return
        allocate (self%last(size(panels)), self%longest(size(panels)), self%first(0:size(load%kinks) + 1), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%last(:) = (panels%low + panels%length)/load%radius
        self%longest(:) = panels%length/load%radius*merge(2.0_wp, 1.0_wp, panels%is_easy)
        self%first(0) = 1
        do i = 1, size(load%kinks)
            self%first(i) = count(panels%start < load%kinks(i)) + 1
        end do
        self%first(size(load%kinks) + 1) = size(panels) + 1
    end subroutine new_half_space_rule

    !> I[f] for the first functions of a half-space, or for all; at z = 0 those that only occur with a factor z are left 0.
    pure subroutine integrate(half_space, rule, load, r, z, integrals)
        class(half_space_t), intent(in) :: half_space
        type(half_space_rule_t), intent(in) :: rule
        class(load_t), intent(in) :: load
        !> distance from the axis [length] and depth [a] of the point
        real(wp), intent(in) :: r, z
        real(wp), intent(out) :: integrals(:)
        type(segment_t) :: segment
        !> where the integrand is not analytic in x, ascending [length]
        real(wp) :: ends(size(load%kinks) + 3)
        real(wp) :: t(chunk), distance(chunk), weight(chunk), low, length
        integer :: i, before, filled

        before = count(load%kinks < r)
        ends = [0.0_wp, load%kinks(:before), min(r, load%radius), load%kinks(before + 1:), load%radius]
        integrals = 0.0_wp
        do i = 1, size(ends) - 1
            if (.not. ends(i + 1) > ends(i)) cycle
            segment = new_segment(rule, load, r, ends(i), ends(i + 1), i - merge(1, 2, i <= before + 1))
            filled = 0
            low = segment%low
            do while (low < segment%high)
                length = segment%high - low
                call enter_panel(rule, segment, low)
                do while (length > shortest)
                    if (length <= reach(segment, z*half_space%decay, z*half_space%turn, low, length)) then
                        if (is_smooth(rule, segment, z, low, length)) exit
                    end if
                    length = 0.5_wp*length
                end do
                if (.not. low + length > low) exit
                call place_nodes(rule, load, segment, low, length, z <= 0.0_wp, t(filled + 1:filled + nodes), &
                                 distance(filled + 1:filled + nodes), weight(filled + 1:filled + nodes))
                filled = filled + nodes
                low = low + length
                if (filled < chunk .and. low < segment%high) cycle
                weight(:filled) = weight(:filled) &
                                  *load%slope(segment%start, min(load%radius*distance(:filled), segment%last))
                call half_space%add_kernels(segment%r, z, t(:filled), weight(:filled), integrals)
                filled = 0
            end do
        end do
        if (load%edge /= 0.0_wp) then
            call half_space%add_kernels(segment%r, z, [(load%radius - r)/load%radius], [-load%edge/load%radius], integrals)
        end if
        integrals = -integrals/pi
    end subroutine integrate

    pure function new_segment(rule, load, r, from, to, passed) result(segment)
        type(half_space_rule_t), intent(in) :: rule
        class(load_t), intent(in) :: load
        !> the point, and two neighbouring ends [length]
        real(wp), intent(in) :: r, from, to
        !> how many kinks lie at or before the beginning
        integer, intent(in) :: passed
        type(segment_t) :: segment

        segment%r = r/load%radius
        segment%low = (from - r)/load%radius
        segment%high = (to - r)/load%radius
        if (passed > 0) segment%start = load%kinks(passed)
        segment%origin = (segment%start - r)/load%radius
        segment%last = nearest(to - segment%start, -1.0_wp)
        segment%steep_end = load%has_steep_edge .and. to >= load%radius
        if (passed > 0) segment%kink = segment%origin
        if (passed > 1) segment%kink_before = (load%kinks(passed - 1) - r)/load%radius
        segment%first_panel = rule%first(passed)
        segment%last_panel = rule%first(passed + 1) - 1
        if (segment%first_panel /= segment%last_panel) return
        ! one polynomial for the whole: no search is needed
        if (2.0_wp*(segment%high - segment%low) <= rule%longest(segment%first_panel)) segment%last_panel = segment%first_panel - 1
    end function new_segment

    !> To the panel of the rule where what begins at `low` lies.
    pure subroutine enter_panel(rule, segment, low)
        type(half_space_rule_t), intent(in) :: rule
        type(segment_t), intent(inout) :: segment
        !> relative to r [a]
        real(wp), intent(in) :: low

        do while (segment%first_panel < segment%last_panel)
            if (rule%last(segment%first_panel) > low - segment%origin) exit
            segment%first_panel = segment%first_panel + 1
        end do
    end subroutine enter_panel

    !> Whether q' is a polynomial from `low` on, as far as `length`: no longer than any panel of the rule that it meets.
    pure function is_smooth(rule, segment, z, low, length) result(is)
        type(half_space_rule_t), intent(in) :: rule
        type(segment_t), intent(in) :: segment
        !> depth of the point, beginning relative to r [a]
        real(wp), intent(in) :: z, low, length
        logical :: is
        real(wp) :: degree
        integer :: i

        is = .true.
        if (segment%first_panel > segment%last_panel) return
        ! s^2 at one end doubles the degree
        degree = merge(2.0_wp, 1.0_wp, low <= segment%kink .or. at_steep_end(segment, low, length) .or. &
                       (z <= 0.0_wp .and. (low == 0.0_wp .or. low + length == 0.0_wp)))
        do i = segment%first_panel, segment%last_panel
            is = degree*length <= rule%longest(i)
            if (.not. is .or. low + length - segment%origin <= rule%last(i)) return
        end do
    end function is_smooth

    !> Whether a panel ends where q' is infinite.
    pure function at_steep_end(segment, low, length) result(answer)
        type(segment_t), intent(in) :: segment
        real(wp), intent(in) :: low, length
        logical :: answer

        answer = segment%steep_end .and. low + length >= segment%high
    end function at_steep_end

    !> Largest length of a panel, `whole` at first: its distance to the nearest singularity.
    pure function reach(segment, z, aside, low, whole) result(length)
        type(segment_t), intent(in) :: segment
        !> distance of singularities from the real axis, and at most from r along it, and ends of the panel relative to r [a]
        real(wp), intent(in) :: z, aside, low, whole
        real(wp) :: length
        real(wp) :: high
        logical :: at_kink, at_r, ends_at_r

        high = low + whole
        at_kink = low <= segment%kink
        at_r = z <= 0.0_wp .and. (low == 0.0_wp .or. high == 0.0_wp)
        ends_at_r = at_r .and. low < 0.0_wp
        length = hypot(max(low - aside, -high - aside, 0.0_wp), z)
        if (at_r) then
            ! x = r -+ s^2 there: what remains is singular at x = -r
            length = 0.4_wp*segment%r
            if (at_kink .and. ends_at_r) length = 0.0_wp
            if (segment%r <= 0.0_wp) length = huge(1.0_wp)
        end if
        ! s^2 at one end brings singularities elsewhere nearer
        if (at_kink .or. at_steep_end(segment, low, whole)) length = length/3.0_wp
        if (at_kink) then
            ! equal intervals stay whole in spite of rounding
            length = min(length, 1.5_wp*(low - segment%kink_before))
        else
            length = min(length, (low - segment%kink)/merge(3.0_wp, 1.0_wp, ends_at_r))
        end if
        ! next to the axis a broken power, which s^2 alone does not cure
        if (at_kink .and. segment%start <= 0.0_wp) then
            length = min(length, merge(first_at_apex, first_beside_axis*min(1.0_wp, hypot(segment%r, z)), &
                                       segment%r <= 0.0_wp .and. z <= 0.0_wp))
        end if
        ! s^2 at both ends is not possible, unless r is the edge
        if (at_steep_end(segment, low, whole) .and. high > 0.0_wp .and. (at_kink .or. at_r)) length = 0.0_wp
    end function reach

    !> Nodes and weights of a panel relative to r and their distances from the segment's `start`; s^2 instead of s next to a kink or
    !> a steep edge, and next to r where the point is on the surface.
    pure subroutine place_nodes(rule, load, segment, low, length, on_surface, t, distance, weight)
        type(half_space_rule_t), intent(in) :: rule
        class(load_t), intent(in) :: load
        type(segment_t), intent(in) :: segment
        real(wp), intent(in) :: low, length
        logical, intent(in) :: on_surface
        real(wp), intent(out) :: t(nodes), distance(nodes), weight(nodes)

        if (low <= segment%kink .or. (on_surface .and. low == 0.0_wp)) then
            t = low + length*rule%node**2
            weight = 2.0_wp*length*rule%weight*rule%node
        else if (on_surface .and. low + length == 0.0_wp) then
            t = low*rule%node**2
            weight = 2.0_wp*length*rule%weight*rule%node
        else if (at_steep_end(segment, low, length)) then
            t = low + length*(1.0_wp - rule%node**2)
            weight = 2.0_wp*length*rule%weight*rule%node
        else
            t = low + length*rule%node
            weight = length*rule%weight
        end if
        distance = t - segment%origin
        if (low > segment%kink) return
        distance = length*rule%node**2
        if (.not. on_surface .or. segment%r > 0.0_wp .or. segment%start > 0.0_wp) return
        ! at the apex of a broken power, int_0^x q'(s)/s ds = q'(x)/e
        t = length
        distance = length
        weight = 0.0_wp
        weight(1) = length/load%order_on_axis()
    end subroutine place_nodes

    !> The limits on the surface of Im P of ln(rho + zeta), -1/rho, -1/(rho + zeta), -1/(rho (rho + zeta)), -1/(2 (rho + zeta)^2),
    !> summed over nodes, with zeta = i (r + t).
    pure function on_surface(r, t, weight) result(sums)
        real(wp), intent(in) :: r, t(:), weight(:)
        real(wp) :: sums(5)
        real(wp) :: x, root
        integer :: i

        sums = 0.0_wp
        do i = 1, size(t)
            x = r + t(i)
            root = sqrt(abs(t(i))*(2.0_wp*r + t(i)))
            if (t(i) > 0.0_wp) then
                sums(1) = sums(1) + weight(i)*half_pi
                sums(2) = sums(2) + weight(i)/root
                sums(3) = sums(3) + weight(i)/(x + root)
            else
                sums(1) = sums(1) + weight(i)*atan2(x, root)
                sums(3) = sums(3) + weight(i)*x/r**2
                if (root > 0.0_wp) sums(4) = sums(4) + weight(i)*x/(root*r**2)
                sums(5) = sums(5) + weight(i)*x*root/r**4
            end if
        end do
    end function on_surface

end module mdrcontact_inside_half_space
