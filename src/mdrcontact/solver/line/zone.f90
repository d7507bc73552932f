! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact of radius a with a cohesive zone a < r < c, in which the bodies attract each other with a constant stress sigma_0
!> (Dugdale 1960, Maugis 1992), on any layered body: theory/adhesion.md (2.1)-(2.6). The zone's line load is known,
!> q = -2 sigma_0 sqrt(c^2 - x^2), and the pressure is finite at a if q is continuous there:
!>     x < a:  q + K_a q = E0* (d - g) - K q_zone,     q(a) = -2 sigma_0 sqrt(c^2 - a^2)
!>     gap at c:  h(c) = (2/pi) int_a^c [w - (d - g)]/sqrt(c^2 - x^2) dx,     E0* w = q + K q on the zone.
!> The matrix of the left-hand side belongs to a alone: it is factorized once, and each length of the zone costs products with the
!> kernel at its nodes.
module mdrcontact_line_zone
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_line_fields, only: line_load_t
    use mdrcontact_line_fine_zone, only: fine_springs_t, fine_zone_t, new_fine_springs
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_legendre, only: contact_rule, is_fine, normalisation
    use mdrcontact_line_moments, only: is_smooth
    use mdrcontact_line_rule, only: rule_t
    use mdrcontact_line_series, only: weigh_even
    use mdrcontact_line_solve, only: equation_t, first_unknowns, new_equation, next_unknowns, raise_missed, solve_lower, &
                                       solve_upper
    use mdrcontact_line_zone_effect, only: effect_of_zone, effect_on_gap
    use mdrcontact_line_zone_rule, only: new_zone_rule, rule_breaks, zone_rule_t
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: zoned_springs_t, new_zoned_springs, zone_state_t, zone_load_t

    !> Largest number of unknowns, and the surplus at the start over those of a state without a zone.
    integer, parameter :: most_unknowns = 1500, more = 2
    !> Part of the tolerance that the last terms of a series and the integrals may leave.
    real(wp), parameter :: share = 0.01_wp
    !> Neighbouring states by different numbers of unknowns are to differ by less than a curve through them shows.
    real(wp), parameter :: loosest = 1.0e-9_wp
    !> Rules of all sizes up to this are known to machine precision.
    integer, parameter :: largest_small_rule = 20
    !> Errors on bodies whose constants vary with depth fall about as this power of the unknowns, of which a few more are taken; one
    !> error tells no more than these factors.
    real(wp), parameter :: order = 4.0_wp, to_spare = 1.03_wp, least_change = 0.7_wp, largest_change = 2.0_wp
    !> Sums that are taken side by side.
    integer, parameter :: at_once = 8
    !> Accuracy of integrals that end nowhere near it.
    real(wp), parameter :: all_digits = epsilon(1.0_wp)

    !> Results for one length of the zone; loads are per E0*.
    type :: zone_state_t
        !> d if q is continuous at a, and h(c): the gap at the end of the zone [length]
        real(wp) :: depth = 0.0_wp, gap = 0.0_wp
        !> F/E0* [length^2]
        real(wp) :: force = 0.0_wp
        !> w - (d - g) next to the contact: where it is below 0 the surfaces meet there [length]
        real(wp) :: first_opening = 0.0_wp
        !> q(a)/E0* [length]
        real(wp) :: edge = 0.0_wp
        !> estimated error of depth, force and gap, relative to their parts
        real(wp) :: error = 0.0_wp
    end type zone_state_t

    !> The load of a state over E0*.
    type :: zone_load_t
        !> on the contact
        type(line_load_t) :: contact
        !> on the zone: x, and z dx at its nodes [length], [length^2]
        real(wp), allocatable :: x(:), dz(:)
        !> int_a^c q w dx/E0* [length^3]
        real(wp) :: work = 0.0_wp
    end type zone_load_t

    !> The springs at one contact radius, 0 without contact.
    type :: zoned_springs_t
        !> contact radius [length]
        real(wp) :: a = 0.0_wp
        !> depth of the non-adhesive state [length], 2 a E_eff/E0* [length]
        real(wp) :: depth = 0.0_wp, stiffness = 0.0_wp
        type(kernel_t), pointer, private :: kernel => null()
        class(profile_t), pointer, private :: profile => null()
        !> where the body's constants vary with depth; all up to `breaks` is for other bodies
        type(fine_springs_t), allocatable, private :: fine
        !> the factorized equation, and its solutions for 1 and g less its mean
        type(equation_t), private :: equation
        real(wp), allocatable, private :: of_one(:), of_profile(:)
        !> g(a) and q_1(a)
        real(wp), private :: height = 0.0_wp, punch_edge = 1.0_wp
        !> nodes on the contact by their distance from the edge over a, and there the polynomials times the weights
        real(wp), allocatable, private :: from_edge(:), polynomials(:, :)
        !> where rules over the zone are split [length]
        real(wp), allocatable, private :: breaks(:)
        !> thickness of the first layer, huge() without layers [length]
        real(wp), private :: unit = huge(1.0_wp)
        !> relative, of what is integrated over the zone
        real(wp), private :: tolerance = 0.0_wp
        !> of numbers of a state
        real(wp), private :: wanted = 0.0_wp
        !> and estimated of those without a zone
        real(wp), private :: reached = 0.0_wp
        integer, private :: unknowns = 0
    contains
        procedure :: with_zone
        procedure :: beyond
        procedure :: check_convergence
    end type zoned_springs_t

contains

    !> Factorizes the springs' equation at contact radius a.
    subroutine new_zoned_springs(self, kernel, tolerance, profile, a, error, at_points, least)
        type(zoned_springs_t), intent(out) :: self
        !> referred to, not copied
        type(kernel_t), intent(in), target :: kernel
        !> relative, of the last coefficients of a load
        real(wp), intent(in) :: tolerance
        !> referred to, not copied
        class(profile_t), intent(in), target :: profile
        !> >= 0; 0: the bodies attract each other without contact [length]
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(out) :: error
        !> for values of the load at points, not for the numbers of a state, in which last terms show by their squares; default
        !> false
        logical, intent(in), optional :: at_points
        !> of check_convergence, of a state that is alike, 0: not known; default: as many as the contact takes without a zone
        real(wp), intent(in), optional :: least
        real(wp), allocatable :: exponents(:), coefficients(:)
        logical :: for_points

        self%a = a
        self%kernel => kernel
        self%profile => profile
        self%tolerance = share*tolerance
        ! panels that move with a must not show in a curve of states
        if (kernel%is_graded()) self%tolerance = all_digits
        self%wanted = min(tolerance, loosest)
        if (.not. kernel%vanishes) self%unit = kernel%unit
        call profile%powers(exponents, coefficients)
        call rule_breaks(profile, is_smooth(profile) .or. (size(exponents) > 0 .and. &
                                                           all(modulo(exponents, 1.0_wp) == 0.0_wp)), self%breaks, error)
        if (allocated(error)) return
        self%height = profile%mdr(a)
        self%depth = self%height
        self%stiffness = 2.0_wp*a
        if (.not. a > 0.0_wp .or. kernel%vanishes) return
        for_points = .false.
        if (present(at_points)) for_points = at_points
        if (kernel%is_graded()) then
            self%unknowns = 0
            if (present(least)) self%unknowns = unknowns_for(least, self%wanted)
            call factorize_fine(self, self%wanted, error)
        else
            call factorize_equation(self, tolerance, for_points, error)
        end if
    end subroutine new_zoned_springs

    subroutine factorize_equation(self, tolerance, at_points, error)
        type(zoned_springs_t), intent(inout) :: self
        !> see new_zoned_springs
        real(wp), intent(in) :: tolerance
        logical, intent(in) :: at_points
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: reached, last_term
        integer :: n
        logical :: solved

        reached = huge(reached)
        last_term = merge(share*tolerance, sqrt(share*tolerance), at_points)
        n = min(first_unknowns(self%kernel, tolerance, self%a/self%kernel%unit, .not. is_smooth(self%profile), .true.) + more, &
                most_unknowns)
        do
            call check_cancelled(error)
            if (allocated(error)) return
            call factorize_with(self, n, at_points, reached, solved, error)
            if (allocated(error)) return
            if (.not. solved) exit
            if (reached <= last_term) then
                call place_nodes(self, n, error)
                return
            end if
            if (n >= most_unknowns) exit
            n = min(next_unknowns(n, reached/last_term), most_unknowns)
        end do
        call raise_missed(error, "a cohesive zone", tolerance, self%a, reached)
    end subroutine factorize_equation

    !> Where the body's constants vary with depth.
    subroutine factorize_fine(self, tolerance, error)
        type(zoned_springs_t), intent(inout) :: self
        !> see new_zoned_springs
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: reached
        integer :: n
        logical :: solved

        reached = huge(reached)
        n = max(self%unknowns, first_unknowns(self%kernel, tolerance, self%a/self%kernel%unit, .not. is_smooth(self%profile), &
                                              .true.))
        do
            n = min(n, most_unknowns)
            call check_cancelled(error)
            if (allocated(error)) return
            allocate (self%fine)
            call new_fine_springs(self%fine, self%kernel, tolerance, self%profile, self%a, n, solved, error)
            if (allocated(error)) return
            if (.not. solved) exit
            reached = self%fine%error
            if (reached <= tolerance) then
                self%unknowns = n
                self%reached = reached
                self%depth = self%fine%depth
                self%stiffness = self%fine%stiffness
                return
            end if
            if (n >= most_unknowns) exit
            n = max(next_unknowns(n, 1.0_wp), enough_unknowns(n, reached/tolerance))
            deallocate (self%fine)
        end do
        call raise_missed(error, "a cohesive zone", tolerance, self%a, reached)
    end subroutine factorize_fine

    !> Whether the unknowns were enough for a state; raises where there cannot be more.
    subroutine check_convergence(self, state, met, unknowns, error)
        class(zoned_springs_t), intent(in) :: self
        type(zone_state_t), intent(in) :: state
        logical, intent(out) :: met
        !> that would be enough, 0 for bodies whose springs find their number themselves: see unknowns_for
        real(wp), intent(out) :: unknowns
        type(error_t), allocatable, intent(inout) :: error
        integer :: enough

        met = .not. state%error > self%wanted
        unknowns = 0.0_wp
        if (self%unknowns == 0) return
        enough = enough_unknowns(self%unknowns, max(state%error, self%reached)/self%wanted)
        if (.not. met) enough = max(enough, next_unknowns(self%unknowns, 1.0_wp))
        unknowns = enough*self%wanted**(1.0_wp/order)
        if (met .or. self%unknowns < most_unknowns) return
        call raise_missed(error, "a cohesive zone", self%wanted, self%a, state%error)
    end subroutine check_convergence

    !> Unknowns that meet a tolerance, from how many would meet a tolerance of 1 if errors fell as they do for many.
    pure function unknowns_for(scale, tolerance) result(n)
        real(wp), intent(in) :: scale, tolerance
        integer :: n

        n = nint(min(max(scale, 0.0_wp)/tolerance**(1.0_wp/order), real(most_unknowns, wp)))
    end function unknowns_for

    !> Unknowns of which the error is smaller than that of n by a factor.
    pure function enough_unknowns(n, factor) result(enough)
        integer, intent(in) :: n
        real(wp), intent(in) :: factor
        integer :: enough

        enough = ceiling(n*to_spare*min(max(factor**(1.0_wp/order), least_change), largest_change))
        enough = min(enough, most_unknowns)
    end function enough_unknowns

    !> With n unknowns.
    subroutine factorize_with(self, n, at_points, reached, solved, error)
        type(zoned_springs_t), intent(inout) :: self
        integer, intent(in) :: n
        !> see new_zoned_springs
        logical, intent(in) :: at_points
        !> how large the last coefficients of K q still are
        real(wp), intent(out) :: reached
        logical, intent(out) :: solved
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: x(n, 3), of_edge(n), part(2)
        integer :: nodes

        reached = 0.0_wp
        nodes = max(2*n + 2, ceiling(16.0_wp*sqrt(self%a/self%kernel%unit)) + 14)
        call new_equation(self%equation, self%kernel, self%a, n, n, nodes, 4*n, solved, error, self%profile)
        if (allocated(error) .or. .not. solved) return
        x = self%equation%rhs
        call solve_lower(n, n, 3, self%equation%h, x)
        call solve_upper(n, n, 3, self%equation%h, x)
        self%of_one = x(:, 1)
        self%of_profile = x(:, 3)
        of_edge = self%equation%rhs(:, 2)
        self%punch_edge = sum(of_edge*x(:, 1))
        self%depth = self%equation%profile_mean + (self%equation%edge_above_mean + sum(of_edge*x(:, 3)))/self%punch_edge
        self%stiffness = self%a*sqrt(2.0_wp)*x(1, 1)
        part(1) = last_terms(self%equation%rhs(:, 1), x(:, 1))
        part(2) = last_terms(self%equation%rhs(:, 3), x(:, 3))
        ! numbers of a state miss products of last terms, of which a zone's fall as those of the punch
        reached = max(part(1), merge(part(2), sqrt(part(1)*part(2)), at_points))
    end subroutine factorize_with

    !> Size of the last coefficients of K q relative to q.
    pure function last_terms(rhs, q) result(part)
        real(wp), intent(in) :: rhs(:), q(:)
        real(wp) :: part

        associate (n => size(q))
            part = maxval(abs(rhs(n - 1:) - q(n - 1:)))*sqrt(real(n, wp))/sqrt(sum(q**2) + tiny(1.0_wp))
        end associate
    end function last_terms

    !> Nodes on the contact for what it does to the zone and the zone to it.
    subroutine place_nodes(self, n, error)
        type(zoned_springs_t), intent(inout) :: self
        integer, intent(in) :: n
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp) :: a, s(n)
        integer :: j

        a = self%a/self%kernel%unit
        if (2*n > largest_small_rule .or. is_fine(self%kernel, a, n)) then
            call contact_rule(rule, a, 2*n, 4*n, is_fine(self%kernel, a, n), error)
        else
            allocate (rule%distance(2*n), rule%weights(2*n))
            call gauss_legendre(rule%distance, rule%weights, error)
            rule%distance = 2.0_wp*rule%distance
            rule%weights = 2.0_wp*rule%weights
        end if
        if (allocated(error)) return
        call move_alloc(rule%distance, self%from_edge)
        allocate (self%polynomials(size(self%from_edge), n))
        call weigh_even(1.0_wp - self%from_edge, rule%weights, self%polynomials)
        s = normalisation(n)
        do j = 1, n
            self%polynomials(:, j) = s(j)*self%polynomials(:, j)
        end do
    end subroutine place_nodes

    !> The state with a zone of length c - a under a cohesive stress.
    subroutine with_zone(self, length, stress, state, error, load)
        class(zoned_springs_t), intent(in) :: self
        !> c - a > 0 [length]
        real(wp), intent(in) :: length
        !> 2 sigma_0/E0* [1]
        real(wp), intent(in) :: stress
        type(zone_state_t), intent(out) :: state
        type(error_t), allocatable, intent(inout) :: error
        !> the load on the contact too
        type(zone_load_t), intent(out), optional :: load
        type(zone_rule_t) :: rule
        real(wp), allocatable :: opening(:), z(:), height(:)

        call new_zone_rule(rule, self%a, length, self%breaks, self%unit, self%tolerance, error, graded=self%kernel%is_graded())
        if (allocated(error)) return
        state%edge = -stress*sqrt(length*(2.0_wp*self%a + length))
        z = -stress*rule%root
        height = self%profile%mdr_at(rule%x)
        opening = z - state%edge + (height - self%height)
        if (self%kernel%vanishes) then
            state%depth = self%height + state%edge
            state%force = 2.0_wp*(self%a*state%edge + self%profile%mdr_moment(self%a))
            if (present(load)) call bare_load(self, state, load%contact)
        else if (self%kernel%is_graded()) then
            call interact_finely(self, rule, length, stress, z, state, opening, error)
            if (allocated(error)) return
        else
            call interact(self, rule, z, state, opening, load)
        end if
        state%force = state%force + 2.0_wp*sum(rule%dx*z)
        if (.not. self%kernel%is_graded()) state%gap = (2.0_wp/pi)*sum(rule%over_root*opening)
        state%first_opening = opening(minloc(rule%beyond, dim=1))
        if (.not. present(load)) return
        load%x = rule%x
        load%dz = rule%dx*z
        load%work = sum(load%dz*(opening + (state%depth - height)))
    end subroutine with_zone

    !> On a half-space: q = E* (d - g).
    subroutine bare_load(self, state, load)
        class(zoned_springs_t), intent(in) :: self
        type(zone_state_t), intent(in) :: state
        type(line_load_t), intent(out) :: load

        load%a = self%a
        load%depth = state%depth
        load%level = state%depth
        allocate (load%q(1), load%v(1), source=0.0_wp)
    end subroutine bare_load

    !> Contributions of the kernel: to the depth, the force of the contact, and the zone's opening.
    subroutine interact(self, rule, z, state, opening, load)
        class(zoned_springs_t), intent(in) :: self
        type(zone_rule_t), intent(in) :: rule
        !> q/E0* at the nodes of the zone [length]
        real(wp), intent(in) :: z(:)
        type(zone_state_t), intent(inout) :: state
        !> w - (d - g) without the interaction, then with it [length]
        real(wp), intent(inout) :: opening(:)
        type(zone_load_t), intent(inout), optional :: load
        real(wp), allocatable :: among(:), x(:, :), t(:, :), q(:)
        real(wp) :: shift, mean, beyond
        integer :: n

        shift = self%equation%moments%shift
        allocate (among(0:size(z)))
        call within_zone(self, rule, rule%dx*z, shift, among)
        if (.not. self%a > 0.0_wp) then
            ! no contact: w at the axis represents the depth
            opening = opening + (among(1:) - among(0))
            state%depth = state%edge + among(0)
            return
        end if
        n = size(self%of_one)
        call between(self, rule, shift, x)
        allocate (t(n, 1))
        t(:, 1) = 2.0_wp/(pi*self%unit)*each_sum(matmul(x(:, 1:), rule%dx*z), self%polynomials)
        mean = sqrt(0.5_wp)*t(1, 1)
        t(1, 1) = 0.0_wp
        call solve_lower(n, n, 1, self%equation%h, t)
        call solve_upper(n, n, 1, self%equation%h, t)
        associate (row => self%equation%rhs(:, 2))
            beyond = (state%edge + self%equation%edge_above_mean + (among(0) - mean) &
                      + sum(row*(self%of_profile + t(:, 1))))/self%punch_edge
        end associate
        q = beyond*self%of_one - self%of_profile - t(:, 1)
        among = among + self%a/(pi*self%unit)*each_sum(matmul(self%polynomials, q), x)
        opening = opening + (among(1:) - among(0))
        ! the constant that was left out of the kernel is a uniform displacement under the zone's load
        mean = mean + 2.0_wp*shift/(pi*self%unit)*sum(rule%dx*z)
        state%depth = self%equation%profile_mean + mean + beyond
        state%force = self%a*sqrt(2.0_wp)*q(1)
        if (present(load)) call contact_load(self, q, mean + beyond, state, load%contact)
    end subroutine interact

    !> The same where the body's constants vary with depth, with the gap; of the opening only at the first node.
    subroutine interact_finely(self, rule, length, stress, z, state, opening, error)
        class(zoned_springs_t), intent(in) :: self
        type(zone_rule_t), intent(in) :: rule
        !> c - a [length], 2 sigma_0/E0* [1]
        real(wp), intent(in) :: length, stress
        real(wp), intent(in) :: z(:)
        type(zone_state_t), intent(inout) :: state
        real(wp), intent(inout) :: opening(:)
        type(error_t), allocatable, intent(inout) :: error
        type(fine_zone_t) :: found
        real(wp) :: among(0:1), shift, gap, mean, part
        integer :: first

        shift = 0.0_wp
        if (allocated(self%fine)) shift = self%fine%equation%moments%shift
        first = minloc(rule%beyond, dim=1)
        call effect_of_zone(self%kernel, self%a, length, stress, [0.0_wp, rule%beyond(first)], shift, among, error)
        if (.not. allocated(error)) call effect_on_gap(self%kernel, self%a, length, stress, shift, gap, error)
        if (allocated(error)) return
        gap = sum(rule%over_root*opening) + (gap - among(0)*sum(rule%over_root))
        opening(first) = opening(first) + (among(1) - among(0))
        if (.not. self%a > 0.0_wp) then
            state%gap = (2.0_wp/pi)*gap
            state%depth = state%edge + among(0)
            return
        end if
        call self%fine%with_zone(self%kernel, rule, rule%dx*z, state%edge, among(0), found)
        state%gap = (2.0_wp/pi)*(gap + found%opening)
        opening(first) = opening(first) + found%at_first
        mean = found%mean + 2.0_wp*shift/(pi*self%unit)*sum(rule%dx*z)
        state%depth = self%fine%equation%profile_mean + mean + found%beyond
        state%force = found%force
        part = abs(self%fine%equation%profile_mean) + abs(mean) + abs(found%beyond)
        state%error = max(found%errors(1)/part, found%errors(2)/(self%stiffness*part), (2.0_wp/pi)*found%errors(3)/state%gap)
    end subroutine interact_finely

    !> The load as a series, with the displacement that the kernel adds.
    subroutine contact_load(self, q, mean, state, load)
        class(zoned_springs_t), intent(in) :: self
        !> coefficients of the normalised polynomials, and d less the mean of g [length]
        real(wp), intent(in) :: q(:), mean
        type(zone_state_t), intent(in) :: state
        type(line_load_t), intent(out) :: load
        real(wp) :: s(size(q))

        s = normalisation(size(q))
        load%a = self%a
        load%depth = state%depth
        load%q = s*q
        load%v = -s*self%equation%rhs(:, 3) - load%q
        load%level = self%equation%profile_mean - load%v(1)
        load%v(1) = load%v(1) + mean
    end subroutine contact_load

    !> (K z)(x) at the edge of the contact, and at the nodes of the zone, of the zone's own load.
    subroutine within_zone(self, rule, load, shift, values)
        class(zoned_springs_t), intent(in) :: self
        type(zone_rule_t), intent(in) :: rule
        !> z dx [length^2]
        real(wp), intent(in) :: load(:)
        real(wp), intent(in) :: shift
        real(wp), intent(out) :: values(0:)
        real(wp) :: x(2*size(load))
        integer :: i, m, n

        n = size(load)
        call self%kernel%evaluate([rule%beyond, 2.0_wp*self%a + rule%beyond]/self%unit, shift, x)
        values = 0.0_wp
        values(0) = sum(load*(x(:n) + x(n + 1:)))
        ! each pair of nodes once
        do i = 1, n
            m = n - i + 1
            associate (others => rule%beyond(i:), here => rule%beyond(i))
                call self%kernel%evaluate([abs(others - here), 2.0_wp*self%a + here + others]/self%unit, shift, x(:2*m))
            end associate
            x(:m) = x(:m) + x(m + 1:2*m)
            values(i) = values(i) + product_sum(load(i:), x(:m))
            values(i + 1:) = values(i + 1:) + load(i)*x(2:m)
        end do
        values = values/(pi*self%unit)
    end subroutine within_zone

    !> Contribution of the kernel and the zone's load to the displacement of the surface at r > a:
    !> (2/pi) int_a^r (K z)(x)/sqrt(r^2 - x^2) dx [length].
    function beyond(self, load, r, error) result(displacement)
        class(zoned_springs_t), intent(in) :: self
        type(zone_load_t), intent(in) :: load
        real(wp), intent(in) :: r
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: displacement
        type(zone_rule_t) :: rule
        real(wp) :: x(2*size(load%x)), total
        integer :: i, n

        displacement = 0.0_wp
        if (self%kernel%vanishes .or. .not. r > self%a) return
        call new_zone_rule(rule, self%a, r - self%a, [-1.0_wp], self%unit, all_digits, error, maxval(load%x) - self%a)
        if (allocated(error)) return
        n = size(load%x)
        do i = 1, size(rule%x)
            call self%kernel%evaluate([abs(rule%x(i) - load%x), rule%x(i) + load%x]/self%unit, 0.0_wp, x)
            total = sum(load%dz*(x(:n) + x(n + 1:)))/(pi*self%unit)
            displacement = displacement + (2.0_wp/pi)*rule%over_root(i)*total
        end do
    end function beyond

    !> X from the nodes on the contact to its edge (0) and to the nodes of the zone, (contact, 0:zone).
    subroutine between(self, rule, shift, x)
        class(zoned_springs_t), intent(in) :: self
        type(zone_rule_t), intent(in) :: rule
        real(wp), intent(in) :: shift
        real(wp), allocatable, intent(out) :: x(:, :)
        integer :: i

        allocate (x(size(self%from_edge), 0:size(rule%beyond)))
        call self%kernel%evaluate(self%a/self%unit*self%from_edge, shift, x(:, 0))
        do i = 1, size(rule%beyond)
            call self%kernel%evaluate((rule%beyond(i) + self%a*self%from_edge)/self%unit, shift, x(:, i))
        end do
    end subroutine between

    !> sum_i v_i m_ij.
    pure function each_sum(v, m) result(sums)
        real(wp), intent(in) :: v(:), m(:, :)
        real(wp) :: sums(size(m, 2))
        integer :: j

        do j = 1, size(m, 2)
            sums(j) = product_sum(v, m(:, j))
        end do
    end function each_sum

    !> sum_i u_i v_i, in sums side by side.
    pure function product_sum(u, v) result(total)
        real(wp), intent(in) :: u(:), v(:)
        real(wp) :: total
        real(wp) :: part(at_once)
        integer :: i, whole

        whole = size(u) - mod(size(u), at_once)
        part = 0.0_wp
        do i = 1, whole, at_once
            part = part + u(i:i + at_once - 1)*v(i:i + at_once - 1)
        end do
        total = sum(part) + sum(u(whole + 1:)*v(whole + 1:))
    end function product_sum

end module mdrcontact_line_zone
