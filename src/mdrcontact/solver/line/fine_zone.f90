! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact of radius a with a cohesive zone on a body whose constants vary with depth (see `zone`). X is nearly singular, and with
!> it what contact and zone do to each other next to the edge a.
!>
!> Depth, force and gap are sums of products <x, y> of right-hand sides of the equation (see `remainder`): 1, values at the edge e,
!> the indenter's g, the zone's effect t = K q_zone on the contact, and o, which gives the gap: o_j is the integral of
!> [(K p_j)(x) - (K p_j)(a)]/sqrt(c^2 - x^2) over the zone. The series of <e, g>, <e, t> and <o, t> fall slowly, but what they are
!> without interaction is an integral over the contact.
module mdrcontact_line_fine_zone
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_line_edge_panels, only: edge_panels_t, new_edge_panels
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_legendre, only: contact_rule, edge_kernel, normalisation
    use mdrcontact_line_moments, only: edge_moment, is_smooth
    use mdrcontact_line_remainder, only: new_remainder, remainder_t
    use mdrcontact_line_rule, only: rule_t
    use mdrcontact_line_series, only: weigh_even
    use mdrcontact_line_solve, only: equation_t, needed, new_equation, nodes_of_film, solve_lower, solve_upper
    use mdrcontact_line_zone_rule, only: zone_rule_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: fine_springs_t, new_fine_springs, fine_zone_t

    !> The columns of forward and rest.
    integer, parameter :: one = 1, edge = 2, of_g = 3
    !> Orders of the polynomials that the rule over the contact takes beyond those in the series: what it is multiplied with.
    integer, parameter :: more_orders = 8
    !> What the zone does to the contact is found at so many places of panels that shrink by this factor towards the edge, down to
    !> the unit of the kernel; through the mirror image of the zone at so many on one panel, which is as far away as it is long.
    integer, parameter :: places_of_panel = 24, places_of_image = 20
    real(wp), parameter :: shrinking = 0.25_wp
    !> Sums that are taken side by side.
    integer, parameter :: at_once = 4

    !> The springs at one contact radius.
    type :: fine_springs_t
        type(equation_t) :: equation
        !> depth of the non-adhesive state [length], 2 a E_eff/E0* [length], and their relative error
        real(wp) :: depth = 0.0_wp, stiffness = 0.0_wp, error = 0.0_wp
        !> unknowns; contact radius and unit of the kernel [length]
        integer, private :: n = 0
        real(wp), private :: a = 0.0_wp, unit = 1.0_wp
        type(remainder_t), private :: remainder
        !> the first right-hand sides times the inverse of the factor
        real(wp), allocatable, private :: forward(:, :)
        !> K p_j at the edge, the main part of the terms of <e, g>, and the sum of it beyond n
        real(wp), allocatable, private :: edge_kernel(:), known_g(:)
        real(wp), private :: whole_g = 0.0_wp
        !> <1, 1>, <e, 1>, <e, g>, <1, g>
        real(wp), private :: one_one = 1.0_wp, edge_one = 1.0_wp, edge_g = 0.0_wp, one_g = 0.0_wp
        !> nodes on half of the contact by their distance from the edge over a, their weights, and the polynomials times these
        real(wp), allocatable, private :: from_edge(:), weights(:), polynomials(:, :)
        !> places next to the edge and of the mirror image, their distances from the edge and from its image [unit], and X there
        type(edge_panels_t), private :: near, image
        real(wp), allocatable, private :: away(:), x_away(:)
        !> X from the nodes and their mirror images to the edge
        real(wp), allocatable, private :: x_edge(:)
    contains
        procedure :: with_zone
    end type fine_springs_t

    !> Effect of a zone on the contact; loads are per E0*.
    type :: fine_zone_t
        !> mean of K q_zone over the contact, and d less that and less the mean of g [length]
        real(wp) :: mean = 0.0_wp, beyond = 0.0_wp
        !> F/E0* of the contact [length^2]
        real(wp) :: force = 0.0_wp
        !> int [(K q)(x) - (K q)(a)]/sqrt(c^2 - x^2) dx of the contact's load [length]
        real(wp) :: opening = 0.0_wp
        !> errors of d, F and that integral
        real(wp) :: errors(3) = 0.0_wp
        !> (K q)(x) - (K q)(a) of the contact's load at the first node of the zone [length]
        real(wp) :: at_first = 0.0_wp
    end type fine_zone_t

contains

    !> With n unknowns and n coefficients more.
    subroutine new_fine_springs(self, kernel, tolerance, profile, a, n, solved, error)
        type(fine_springs_t), intent(out) :: self
        type(kernel_t), intent(in) :: kernel
        real(wp), intent(in) :: tolerance
        class(profile_t), intent(in) :: profile
        !> > 0 [length]
        real(wp), intent(in) :: a
        integer, intent(in) :: n
        !> the matrix was positive definite
        logical, intent(out) :: solved
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: x(:, :), terms(:)
        real(wp) :: edge_load, missed(4)
        integer :: m, nodes

        m = 2*n
        nodes = max(ceiling(nodes_of_film(tolerance, a/kernel%unit)*merge(1.0_wp, 1.4_wp, is_smooth(profile))), m)
        call new_equation(self%equation, kernel, a, m, n, nodes, ceiling(needed*2*(m + n)), solved, error, profile)
        if (allocated(error) .or. .not. solved) return
        self%n = n
        self%a = a
        self%unit = kernel%unit
        allocate (self%forward(n, 3), x(m, 3), self%edge_kernel(m), self%known_g(m), terms(n))
        call new_remainder(self%remainder, n, m, self%equation%h)
        associate (h => self%equation%h, rhs => self%equation%rhs)
            call edge_kernel(self%equation%moments, self%edge_kernel)
            self%known_g = 0.0_wp
            if (any(abs(rhs(n + 1:, of_g)) > 0.0_wp)) then
                call edge_moment(profile, kernel, a, self%equation%moments%shift, self%equation%profile_mean, edge_load, error)
                if (allocated(error)) return
                self%known_g = -self%edge_kernel*rhs(:, of_g)
                self%whole_g = -edge_load - sum(self%known_g(:n))
            end if
            self%known_g = self%known_g(n + 1:)
            call split(self, rhs, self%forward, x)
            associate (forward => self%forward, rest => rhs(n + 1:, :), remainder => self%remainder)
                self%one_one = remainder%product(forward(:, one), forward(:, one), rest(:, one), rest(:, one))
                self%edge_one = remainder%product(forward(:, edge), forward(:, one), rest(:, edge), rest(:, one))
                self%one_g = remainder%product(forward(:, one), forward(:, of_g), rest(:, one), rest(:, of_g))
                self%edge_g = remainder%product(forward(:, edge), forward(:, of_g), rest(:, edge), rest(:, of_g), &
                                                self%known_g, self%whole_g)
                call remainder%truncation_error(n, rest(:, one), rest(:, one), terms, missed(1))
                call remainder%truncation_error(n, rest(:, edge), rest(:, one), terms, missed(2))
                call remainder%truncation_error(n, rest(:, edge), rest(:, of_g), terms, missed(3), -self%known_g)
            end associate
        end associate
        self%stiffness = a*self%one_one
        self%depth = self%equation%profile_mean + (self%equation%edge_above_mean + self%edge_g)/self%edge_one
        self%error = max(missed(1)/self%one_one, missed(2)/abs(self%edge_one))
        if (self%depth > 0.0_wp) self%error = max(self%error, missed(3)/abs(self%edge_one*self%depth))
        call place_nodes(self, kernel, m, error)
    end subroutine new_fine_springs

    !> Right-hand sides times the inverse of the factor, their solutions by n unknowns, and what is left of them beyond n.
    subroutine split(self, rhs, forward, x)
        class(fine_springs_t), intent(in) :: self
        !> in the rows beyond n: the coefficients, then what is left of them
        real(wp), intent(inout) :: rhs(:, :)
        !> solutions in as many rows as rhs
        real(wp), intent(out) :: forward(:, :), x(:, :)

        associate (n => self%n, h => self%equation%h)
            forward = rhs(:n, :)
            call solve_lower(n, size(h, 1), size(rhs, 2), h, forward)
            x(:n, :) = forward
            call solve_upper(n, size(h, 1), size(rhs, 2), h, x)
            rhs(n + 1:, :) = rhs(n + 1:, :) - matmul(h(n + 1:, :), x(:n, :))
        end associate
    end subroutine split

    !> Nodes on half of the contact, closest at its edge, for m even polynomials.
    subroutine place_nodes(self, kernel, m, error)
        type(fine_springs_t), intent(inout) :: self
        type(kernel_t), intent(in) :: kernel
        integer, intent(in) :: m
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp) :: s(m)
        integer :: j, stat

        call contact_rule(rule, self%a/self%unit, m, m + more_orders, .true., error)
        if (allocated(error)) return
        allocate (self%polynomials(size(rule%weights), m), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%from_edge = 0.5_wp*rule%distance
        self%weights = 0.5_wp*rule%weights
        call weigh_even(1.0_wp - self%from_edge, self%weights, self%polynomials)
        s = normalisation(m)
        do j = 1, m
            self%polynomials(:, j) = s(j)*self%polynomials(:, j)
        end do
        call place_panels(self, kernel)
    end subroutine place_nodes

    !> Places at which the effect of a zone is found, and what the contact does to its edge.
    subroutine place_panels(self, kernel)
        type(fine_springs_t), intent(inout) :: self
        type(kernel_t), intent(in) :: kernel
        real(wp) :: image(size(self%from_edge))
        integer :: i, panels

        panels = max(ceiling(log(self%a/self%unit)/log(1.0_wp/shrinking)), 0)
        call new_edge_panels(self%near, [0.0_wp, (shrinking**i, i=panels, 0, -1)], places_of_panel, self%from_edge)
        call new_edge_panels(self%image, [0.0_wp, 1.0_wp], places_of_image, self%from_edge)
        self%away = self%a/self%unit*[self%near%places, 2.0_wp - self%image%places]
        allocate (self%x_away(size(self%away)), self%x_edge(size(self%from_edge)))
        associate (shift => self%equation%moments%shift, a => self%a/self%unit)
            call kernel%evaluate(self%away, shift, self%x_away)
            call kernel%evaluate(a*self%from_edge, shift, self%x_edge)
            call kernel%evaluate(a*(2.0_wp - self%from_edge), shift, image)
        end associate
        self%x_edge = self%x_edge + image
    end subroutine place_panels

    !> Effect of a zone on the contact.
    subroutine with_zone(self, kernel, rule, load, at_edge, among_edge, found)
        class(fine_springs_t), intent(in) :: self
        type(kernel_t), intent(in) :: kernel
        type(zone_rule_t), intent(in) :: rule
        !> q dx/E0* at the nodes of the zone [length^2]
        real(wp), intent(in) :: load(:)
        !> q(a)/E0*, and what the zone itself adds to the displacement at a, X(0) left out as in the moments [length]
        real(wp), intent(in) :: at_edge, among_edge
        type(fine_zone_t), intent(out) :: found
        real(wp), allocatable :: sums(:, :), rhs(:, :), forward(:, :), solution(:, :), known(:, :), rest(:)
        real(wp), allocatable :: total(:), terms(:), of_zone(:), of_first(:)
        real(wp) :: whole(2), edge_t, one_t, gap_t, gap_one, gap_g, of_edge, missed(3)
        integer :: m

        m = 2*self%n
        allocate (rhs(m, 2), forward(self%n, 2), solution(m, 2), known(m, 2), total(self%n), rest(self%n), terms(self%n))
        allocate (sums(size(self%weights), 3), of_first(m))
        call sum_over_zone(self, kernel, rule, load, sums(:, 1), sums(:, 2), sums(:, 3))
        call project(sums, self%polynomials, rhs(:, 1), rhs(:, 2), of_first)
        rhs(:, 1) = 2.0_wp*rhs(:, 1)
        found%mean = sqrt(0.5_wp)*rhs(1, 1)
        rhs(1, 1) = 0.0_wp
        of_zone = self%weights*(sums(:, 1) - found%mean)
        ! of the zone's effect: at the edge, and in the gap
        of_edge = self%a/(pi*self%unit)*sum(of_zone*self%x_edge)
        known(:, 1) = -self%edge_kernel*rhs(:, 1)
        known(:, 2) = rhs(:, 2)*rhs(:, 1)
        whole(1) = -of_edge - sum(known(:self%n, 1))
        whole(2) = sum(of_zone*sums(:, 2)) - sum(known(:self%n, 2))
        call split(self, rhs, forward, solution)
        associate (n => self%n, remainder => self%remainder, of_t => forward(:, 1), of_o => forward(:, 2), &
                   t => rhs(self%n + 1:, 1), o => rhs(self%n + 1:, 2), first => self%forward, &
                   rest_of => self%equation%rhs(self%n + 1:, :))
            edge_t = remainder%product(first(:, edge), of_t, rest_of(:, edge), t, known(n + 1:, 1), whole(1))
            one_t = remainder%product(first(:, one), of_t, rest_of(:, one), t)
            gap_one = remainder%product(of_o, first(:, one), o, rest_of(:, one))
            gap_g = remainder%product(of_o, first(:, of_g), o, rest_of(:, of_g))
            gap_t = remainder%product(of_o, of_t, o, t, known(n + 1:, 2), whole(2))
            found%beyond = (at_edge + self%equation%edge_above_mean + (among_edge - found%mean) + self%edge_g + edge_t) &
                           /self%edge_one
            found%force = self%a*(found%beyond*self%one_one - self%one_g - one_t)
            found%opening = found%beyond*gap_one - gap_g - gap_t
            ! the load, less what the unknowns are changed by the coefficients beyond them
            total = found%beyond*first(:, one) - first(:, of_g) - of_t
            rest = found%beyond*rest_of(:, one) - rest_of(:, of_g) - t
            call remainder%truncation_error(n, rest_of(:, edge), rest, terms, missed(1), known(n + 1:, 1) + self%known_g)
            call remainder%truncation_error(n, rest_of(:, one), rest, terms, missed(2))
            call remainder%truncation_error(n, o, rest, terms, missed(3), known(n + 1:, 2))
            found%errors(1) = missed(1)/abs(self%edge_one)
            found%errors(2) = self%a*(missed(2) + self%one_one*found%errors(1))
            found%errors(3) = missed(3) + abs(gap_one)*found%errors(1)
            rest = remainder%inverse*rest
            call find_load(self, total, rest, solution(:, 1))
        end associate
        found%at_first = sum(solution(:, 1)*of_first)
    end subroutine with_zone

    !> The coefficients of the load.
    subroutine find_load(self, forward, rest, q)
        class(fine_springs_t), intent(in) :: self
        !> of its right-hand side, and its coefficients beyond n
        real(wp), intent(in) :: forward(:), rest(:)
        real(wp), intent(out) :: q(:)

        associate (n => self%n, h => self%equation%h)
            q(:n) = matmul(rest, h(n + 1:, :))
            q(n + 1:) = rest
            call solve_lower(n, size(h, 1), 1, h, q)
            q(:n) = forward - q(:n)
            call solve_upper(n, size(h, 1), 1, h, q)
        end associate
    end subroutine find_load

    !> At the nodes of the contact: the displacement by the zone's load, and what loads there add to the gap and to the opening at
    !> the first node of the zone, all over E0*.
    subroutine sum_over_zone(self, kernel, rule, load, of_zone, to_gap, to_first)
        class(fine_springs_t), intent(in) :: self
        type(kernel_t), intent(in) :: kernel
        type(zone_rule_t), intent(in) :: rule
        real(wp), intent(in) :: load(:)
        real(wp), intent(out) :: of_zone(:), to_gap(:), to_first(:)
        real(wp), dimension(size(self%away)) :: x, of_load, of_gap, of_first
        integer :: i, nearest

        nearest = minloc(rule%beyond, dim=1)
        of_load = 0.0_wp
        of_gap = 0.0_wp
        do i = 1, size(load)
            call kernel%evaluate(self%away + rule%beyond(i)/self%unit, self%equation%moments%shift, x)
            of_load = of_load + load(i)*x
            x = x - self%x_away
            of_gap = of_gap + rule%over_root(i)*x
            if (i == nearest) of_first = x
        end do
        of_zone = at_contact(self, of_load)/(pi*self%unit)
        to_gap = self%a/(pi*self%unit)*at_contact(self, of_gap)
        to_first = self%a/(pi*self%unit)*at_contact(self, of_first)
    end subroutine sum_over_zone

    !> A function at the nodes of the contact, from its parts at the places next to the edge and of the mirror image.
    pure function at_contact(self, parts) result(values)
        type(fine_springs_t), intent(in) :: self
        real(wp), intent(in) :: parts(:)
        real(wp) :: values(size(self%weights))

        associate (near => size(self%near%places))
            values = self%near%at_nodes(parts(:near)) + self%image%at_nodes(parts(near + 1:))
        end associate
    end function at_contact

    !> sum_i v_i m_ij of three v, in sums side by side.
    pure subroutine project(v, m, first, second, third)
        real(wp), intent(in) :: v(:, :), m(:, :)
        real(wp), intent(out) :: first(:), second(:), third(:)
        real(wp) :: part(at_once, 3)
        integer :: i, j, k, whole

        whole = size(v, 1) - mod(size(v, 1), at_once)
        do j = 1, size(m, 2)
            part = 0.0_wp
            do i = 1, whole, at_once
                do k = 1, 3
                    part(:, k) = part(:, k) + v(i:i + at_once - 1, k)*m(i:i + at_once - 1, j)
                end do
            end do
            first(j) = sum(part(:, 1)) + sum(v(whole + 1:, 1)*m(whole + 1:, j))
            second(j) = sum(part(:, 2)) + sum(v(whole + 1:, 2)*m(whole + 1:, j))
            third(j) = sum(part(:, 3)) + sum(v(whole + 1:, 3)*m(whole + 1:, j))
        end do
    end subroutine project

end module mdrcontact_line_fine_zone
