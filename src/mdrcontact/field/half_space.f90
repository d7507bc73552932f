! SPDX-License-Identifier: GPL-3.0-or-later
!> Stresses and displacements inside a homogeneous half-space under a line load q(x), by closed kernels integrated by parts.
!>
!> With zeta = z + i x and rho = sqrt(r^2 + zeta^2), Re rho >= 0, each field is a sum of I[f] = (1/pi) int_0^a q Re f dx with
!>     A0 = 1/rho   A1 = zeta/rho^3   A2 = (2 zeta^2 - r^2)/rho^5                                   (Hankel integrals with J0)
!>     b0 = 1/(rho (rho + zeta))   b1 = 1/rho^3   b2 = 3 zeta/rho^5                                 (J1/r)
!>     c0 = 1/(rho (rho + zeta)^2)   c1 = (zeta + 2 rho)/(rho^3 (rho + zeta)^2)                     (J2/r^2)
!> and I[f] = (1/pi) {q(a) Im P(z + i a) - int_0^a q' Im P dx} with dP/dzeta = f: no factor a/z is lost near the surface.
module mdrcontact_field_half_space
    use mdrcontact_medium_load, only: load_t, panel_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: half_space_rule_t, new_half_space_rule, add_normal_sums, add_shear_sums, &
              add_normal_image, add_shear_image
    public :: normal_sums, shear_sums

    !> How many sums describe the field of a normal and of a shear load, see add_normal_sums and add_shear_sums.
    integer, parameter :: normal_sums = 5, shear_sums = 8
    !> The integrals I[f] by their place in a list.
    integer, parameter :: a0 = 1, a1 = 2, a2 = 3, b0 = 4, b1 = 5, b2 = 6, c0 = 7, c1 = 8, kernels = 8

    !> Nodes of a panel no longer than its distance to the nearest singularity: 1e-15 of the integral.
    integer, parameter :: nodes = 10
    !> Nodes that are worked on together.
    integer, parameter :: chunk = 64*nodes
    !> A panel is not made shorter than this part of a.
    real(wp), parameter :: shortest = 1.0e-18_wp

    !> Length of the panel beside an axis where q' is a broken power, relative to the distance of the point, and, for the point at
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
        !> the last kink up to its beginning and the one before; far away if there is none
        real(wp) :: kink = -0.5_wp*huge(1.0_wp), kink_before = -0.5_wp*huge(1.0_wp)
        !> from where distances are given to the load, that kink or the axis [length], and relative to r
        real(wp) :: start = 0.0_wp, origin = 0.0_wp
        !> panels of the rule: the one where the next panel begins, and the last one before the end
        integer :: first_panel = 1, last_panel = 0
        !> the largest distance from there [length]: rounding must not pass a kink at its end, beyond which q' may be infinite
        real(wp) :: last = 0.0_wp
    end type segment_t

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

    !> Adds the homogeneous body's part to the five sums of a normal load at one point:
    !>     2 mu u_z, sigma_zz, int p_hat y1 k J0 dk, 2 mu u_r/r, sigma_rz/r                               (lengths in units of a)
    pure subroutine add_normal_sums(rule, load, poisson, r, z, sums)
        type(half_space_rule_t), intent(in) :: rule
        class(load_t), intent(in) :: load
        real(wp), intent(in) :: poisson
        !> distance from the axis [length] and depth [a] of the point
        real(wp), intent(in) :: r, z
        real(wp), intent(inout) :: sums(normal_sums)
        real(wp) :: i(kernels)

        call integrate(rule, load, r, z, i)
        sums = sums + [2.0_wp*(1.0_wp - poisson)*i(a0) + z*i(a1), -i(a1) - z*i(a2), &
                       -(1.0_wp - 2.0_wp*poisson)*i(a1) + z*i(a2), -(1.0_wp - 2.0_wp*poisson)*i(b0) + z*i(b1), -z*i(b2)]
    end subroutine add_normal_sums

    !> Adds the homogeneous body's part to the eight sums of a load that shears, p(r) in +x: the Hankel integrals of
    !>     (y5 - y1) J0, (N - T) k J0, y2 J1/r, S k J1/r, y1 k J1/r, y5 k J1/r, (y5 + y1) J2/r^2, (N + T) k J2
    pure subroutine add_shear_sums(rule, load, poisson, r, z, sums)
        type(half_space_rule_t), intent(in) :: rule
        class(load_t), intent(in) :: load
        real(wp), intent(in) :: poisson
        !> distance from the axis [length] and depth [a] of the point
        real(wp), intent(in) :: r, z
        real(wp), intent(inout) :: sums(shear_sums)
        real(wp) :: i(kernels)

        call integrate(rule, load, r, z, i)
        sums = sums + [(4.0_wp - 2.0_wp*poisson)*i(a0) - z*i(a1), -2.0_wp*i(a1) + z*i(a2), &
                       (1.0_wp - 2.0_wp*poisson)*i(b0) + z*i(b1), -z*i(b2), -2.0_wp*(1.0_wp - poisson)*i(b1) + z*i(b2), &
                       2.0_wp*i(b1), 2.0_wp*poisson*i(c0) + z*i(c1), z*(i(a2) - 2.0_wp*i(b1))]
    end subroutine add_shear_sums

    !> Adds the normal load's sums of a state (alpha + beta k z) e^(-k (z + shift)).
    pure subroutine add_normal_image(rule, load, shift, alpha, beta, r, z, sums)
        type(half_space_rule_t), intent(in) :: rule
        class(load_t), intent(in) :: load
        !> [a], and y1 to y4
        real(wp), intent(in) :: shift, alpha(:), beta(:)
        !> distance from the axis [length] and depth [a] of the point
        real(wp), intent(in) :: r, z
        real(wp), intent(inout) :: sums(normal_sums)
        real(wp) :: i(kernels)

        call integrate(rule, load, r, z + shift, i)
        associate (b => z*beta)
            sums = sums + [alpha(2)*i(a0) + b(2)*i(a1), alpha(4)*i(a1) + b(4)*i(a2), alpha(1)*i(a1) + b(1)*i(a2), &
                           alpha(1)*i(b0) + b(1)*i(b1), alpha(3)*i(b1) + b(3)*i(b2)]
        end associate
    end subroutine add_normal_image

    !> The same under a load that shears; k J2 = 2 J1/r - k J0.
    pure subroutine add_shear_image(rule, load, shift, alpha, beta, r, z, sums)
        type(half_space_rule_t), intent(in) :: rule
        class(load_t), intent(in) :: load
        !> [a], and y1 to y5 and N
        real(wp), intent(in) :: shift, alpha(:), beta(:)
        !> distance from the axis [length] and depth [a] of the point
        real(wp), intent(in) :: r, z
        real(wp), intent(inout) :: sums(shear_sums)
        real(wp) :: i(kernels)

        call integrate(rule, load, r, z + shift, i)
        associate (b => z*beta)
            sums = sums + [(alpha(5) - alpha(1))*i(a0) + (b(5) - b(1))*i(a1), (alpha(6) - alpha(3))*i(a1) + (b(6) - b(3))*i(a2), &
                           alpha(2)*i(b0) + b(2)*i(b1), alpha(4)*i(b1) + b(4)*i(b2), alpha(1)*i(b1) + b(1)*i(b2), &
                           alpha(5)*i(b1) + b(5)*i(b2), (alpha(5) + alpha(1))*i(c0) + (b(5) + b(1))*i(c1), &
                           (alpha(6) + alpha(3))*(2.0_wp*i(b0) - i(a1)) + (b(6) + b(3))*(2.0_wp*i(b1) - i(a2))]
        end associate
    end subroutine add_shear_image

    !> I[f] for all kernels; at z = 0 those that only occur with a factor z are left 0.
    pure subroutine integrate(rule, load, r, z, integrals)
        type(half_space_rule_t), intent(in) :: rule
        class(load_t), intent(in) :: load
        real(wp), intent(in) :: r, z
        real(wp), intent(out) :: integrals(kernels)
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
                    if (length <= reach(segment, z, low, low + length)) then
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
                call add_kernels(segment%r, z, t(:filled), weight(:filled), integrals)
                filled = 0
            end do
        end do
        if (load%edge /= 0.0_wp) then
            call add_kernels(segment%r, z, [(load%radius - r)/load%radius], [-load%edge/load%radius], integrals)
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
        if (passed > 0) segment%kink = segment%origin
        if (passed > 1) segment%kink_before = (load%kinks(passed - 1) - r)/load%radius
        segment%first_panel = rule%first(passed)
        segment%last_panel = rule%first(passed + 1) - 1
        if (segment%first_panel /= segment%last_panel) return
        ! one polynomial for all of it: there is nothing to look for
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
        degree = merge(2.0_wp, 1.0_wp, low <= segment%kink .or. &
                       (z <= 0.0_wp .and. (low == 0.0_wp .or. low + length == 0.0_wp)))
        do i = segment%first_panel, segment%last_panel
            is = degree*length <= rule%longest(i)
            if (.not. is .or. low + length - segment%origin <= rule%last(i)) return
        end do
    end function is_smooth

    !> How long a panel from `low` to `high` may be: its distance to the nearest singularity.
    pure function reach(segment, z, low, high) result(length)
        type(segment_t), intent(in) :: segment
        !> depth of the point, and ends of the panel relative to r [a]
        real(wp), intent(in) :: z, low, high
        real(wp) :: length
        logical :: at_kink, at_r, ends_at_r

        at_kink = low <= segment%kink
        at_r = z <= 0.0_wp .and. (low == 0.0_wp .or. high == 0.0_wp)
        ends_at_r = at_r .and. low < 0.0_wp
        length = hypot(max(low, -high, 0.0_wp), z)
        if (at_r) then
            ! x = r -+ s^2 there: what remains is singular at x = -r
            length = 0.4_wp*segment%r
            if (at_kink .and. ends_at_r) length = 0.0_wp
            if (segment%r <= 0.0_wp) length = huge(1.0_wp)
        end if
        ! s^2 at one end brings singularities elsewhere nearer
        if (at_kink) length = length/3.0_wp
        if (at_kink) then
            ! equal intervals stay whole in spite of rounding
            length = min(length, 1.5_wp*(low - segment%kink_before))
        else
            length = min(length, (low - segment%kink)/merge(3.0_wp, 1.0_wp, ends_at_r))
        end if
        ! beside the axis a broken power, which s^2 alone does not cure
        if (at_kink .and. segment%start <= 0.0_wp) then
            length = min(length, merge(first_at_apex, first_beside_axis*min(1.0_wp, hypot(segment%r, z)), &
                                       segment%r <= 0.0_wp .and. z <= 0.0_wp))
        end if
    end function reach

    !> Nodes and weights of a panel relative to r and their distances from the segment's `start`; s^2 instead of s beside a kink,
    !> and beside r where the point is on the surface.
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

    !> Adds sum of weight Im P(z + i (r + t)) for all kernels.
    pure subroutine add_kernels(r, z, t, weight, integrals)
        real(wp), intent(in) :: r, z, t(:), weight(:)
        real(wp), intent(inout) :: integrals(kernels)

        if (z > 0.0_wp) then
            call add_inside(r, z, t, weight, integrals)
        else
            call add_on_surface(r, t, weight, integrals)
        end if
    end subroutine add_kernels

    pure subroutine add_inside(r, z, t, weight, integrals)
        real(wp), intent(in) :: r, z, t(:), weight(:)
        real(wp), intent(inout) :: integrals(kernels)
        real(wp), dimension(size(t)) :: im_a0, im_a1, im_a2, im_b0, im_b1, im_b2, im_c0, im_c1
        real(wp) :: x, square, cross, modulus, root, rho_re, rho_im, g_re, g_im, inv_re, inv_im, inv2_re, inv2_im, inv3_re, &
                    inv3_im, h_re, h_im, b_re, b_im
        integer :: i

        do i = 1, size(t)
            x = r + t(i)
            ! rho^2 without the cancellation of r^2 + zeta^2
            square = z**2 - t(i)*(2.0_wp*r + t(i))
            cross = 2.0_wp*z*x
            modulus = sqrt(square**2 + cross**2)
            root = sqrt(0.5_wp*(modulus + abs(square)))
            rho_re = merge(root, 0.5_wp*cross/root, square >= 0.0_wp)
            rho_im = merge(0.5_wp*cross/root, root, square >= 0.0_wp)
            inv_re = rho_re/modulus
            inv_im = -rho_im/modulus
            h_re = rho_re + z
            h_im = rho_im + x
            root = 1.0_wp/(h_re**2 + h_im**2)
            g_re = h_re*root
            g_im = -h_im*root
            inv2_re = inv_re**2 - inv_im**2
            inv2_im = 2.0_wp*inv_re*inv_im
            inv3_re = inv2_re*inv_re - inv2_im*inv_im
            inv3_im = inv2_re*inv_im + inv2_im*inv_re
            b_re = inv_re*g_re - inv_im*g_im
            b_im = inv_re*g_im + inv_im*g_re
            im_a0(i) = atan2(h_im, h_re)
            im_a1(i) = -inv_im
            im_a2(i) = -(z*inv3_im + x*inv3_re)
            im_b0(i) = -g_im
            im_b1(i) = -b_im
            im_b2(i) = -inv3_im
            im_c0(i) = -g_re*g_im
            im_c1(i) = -(b_re*g_im + b_im*g_re)
        end do
        integrals = integrals + [sum(weight*im_a0), sum(weight*im_a1), sum(weight*im_a2), sum(weight*im_b0), sum(weight*im_b1), &
                                 sum(weight*im_b2), sum(weight*im_c0), sum(weight*im_c1)]
    end subroutine add_inside

    !> The limits for z = 0 of the kernels that do not occur with a factor z; the others do not matter there.
    pure subroutine add_on_surface(r, t, weight, integrals)
        real(wp), intent(in) :: r, t(:), weight(:)
        real(wp), intent(inout) :: integrals(kernels)
        real(wp) :: x, root
        integer :: i

        do i = 1, size(t)
            x = r + t(i)
            root = sqrt(abs(t(i))*(2.0_wp*r + t(i)))
            if (t(i) > 0.0_wp) then
                integrals(a0) = integrals(a0) + weight(i)*half_pi
                integrals(a1) = integrals(a1) + weight(i)/root
                integrals(b0) = integrals(b0) + weight(i)/(x + root)
            else
                integrals(a0) = integrals(a0) + weight(i)*atan2(x, root)
                integrals(b0) = integrals(b0) + weight(i)*x/r**2
                if (root > 0.0_wp) integrals(b1) = integrals(b1) + weight(i)*x/(root*r**2)
                integrals(c0) = integrals(c0) + weight(i)*x*root/r**4
            end if
        end do
    end subroutine add_on_surface

end module mdrcontact_field_half_space
