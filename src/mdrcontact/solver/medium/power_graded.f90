! SPDX-License-Identifier: GPL-3.0-or-later
!> The power-law graded half-space E(z) = E0 (z/z0)^m, -1 < m < 1, exactly (theory/paper.md (3.15)-(3.19); Hess,
!> Int. J. Eng. Sci. 104 (2016) 20).
!>
!> The springs c(x) = c1 x^m stiffen or soften with their distance from the axis and the MDR profile has a kernel of its own:
!>     g(x) = x^{1-m} int_0^x f'(r) (x^2 - r^2)^{(m-1)/2} dr,      d = g(a),      F = 2 int_0^a c(x) (d - g(x)) dx.
module mdrcontact_medium_power_graded
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_parameter, only: nature_poisson, nature_signed, parameter_t
    use mdrcontact_error, only: check_made, check_poisson, check_positive, error_invalid, error_t, raise, to_text
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_material, only: in_series
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_medium_solver, only: set_pair, solved_t, solver_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_numerics_quadrature, only: gauss_jacobi, gauss_legendre, graded_rule, smallest_panel_ratio
    use mdrcontact_numerics_sampled_function, only: new_sampled_function, sampled_function_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: power_graded_t, new_power_graded, new_power_graded_pair, power_law_parameters

    !> Nodes from the edge half of the way to a corner, and from there.
    integer, parameter :: panel_nodes = 20

    !> E(z) = E0 (z/z0)^m by its springs.
    type, extends(solver_t) :: power_graded_t
        private
        !> m
        real(wp) :: exponent = 0.0_wp
        !> c1 [modulus length^-m]
        real(wp) :: spring = 0.0_wp
        !> nodes and weights of int_0^1 f(t) t^{(m-1)/2} dt, and of int_0^1 f(t) dt for an f that depends on sqrt(t)
        real(wp), dimension(panel_nodes, 2) :: edge_rule = 0.0_wp, corner_rule = 0.0_wp
    contains
        procedure :: modulus
        procedure :: solve
        procedure :: load => new_load
        procedure :: compliance
    end type power_graded_t

    !> A load on it. What it does inside the body is not known.
    type, extends(load_t) :: power_graded_load_t
        private
        class(power_graded_t), pointer :: medium => null()
    contains
        procedure :: line_load
        procedure :: projection
        procedure :: pressure
        procedure :: displacement
    end type power_graded_load_t

    !> g(x) of one indenter in this medium.
    type, extends(scalar_function_t) :: transform_t
        class(profile_t), pointer :: profile => null()
        class(power_graded_t), pointer :: medium => null()
    contains
        procedure :: value => transform_at
    end type transform_t

    !> Radii below this part of the contact radius add f(r) to the depth and nothing to the force, but for a part of 1e-16.
    real(wp), parameter :: nearest_axis = 1.0e-8_wp
    !> Distance from a singular end, relative to the radius, below which the integrand is its leading power.
    real(wp), parameter :: closest = 1.0e-15_wp
    !> The same behind an edge or kink at b, where g' needs digits of x - b: least and most, relative to b, and a part of the
    !> distance of r from b.
    real(wp), parameter :: behind_corner(3) = [1.0e-13_wp, 1.0e-10_wp, 1.0e-3_wp]
    !> At the edge itself, where g' is taken as the power that it is.
    real(wp), parameter :: at_edge = 1.0e-9_wp
    real(wp), parameter :: sampling_tolerance = 1.0e-13_wp
    !> accuracy of g from the f' of a sampled profile
    real(wp), parameter :: roughness = 3.0e-11_wp
    integer, parameter :: octaves = 34

contains

    !> A power-law graded half-space.
    subroutine new_power_graded(self, young, reference_depth, exponent, poisson, error)
        type(power_graded_t), intent(out) :: self
        !> E0 > 0, Young's modulus at depth z0 [modulus]
        real(wp), intent(in) :: young
        !> z0 > 0 [length]
        real(wp), intent(in) :: reference_depth
        !> m, -1 < m < 1
        real(wp), intent(in) :: exponent
        !> nu, the same at all depths
        real(wp), intent(in) :: poisson
        type(error_t), allocatable, intent(out) :: error
        real(wp), dimension(panel_nodes) :: roots, weights

        call disable_gsl_abort()
        call check_positive(error, "E0", young)
        call check_positive(error, "z0", reference_depth)
        call check_poisson(error, "nu", poisson)
        if (.not. (exponent > -1.0_wp .and. exponent < 1.0_wp)) then
            call raise(error, error_invalid, "exponent = "//to_text(exponent)//": it must be greater than -1 and less than 1")
        end if
        if (allocated(error)) return
        self%power_law = [young, reference_depth, exponent, poisson]
        self%exponent = exponent
        self%is_exact = .true.
        call gauss_jacobi(0.5_wp*(exponent - 1.0_wp), self%edge_rule(:, 1), self%edge_rule(:, 2), error)
        call gauss_legendre(roots, weights, error)
        self%corner_rule(:, 1) = roots**2
        self%corner_rule(:, 2) = 2.0_wp*roots*weights
        self%spring = spring_factor(exponent, poisson)*young/((1.0_wp - poisson)*(1.0_wp + poisson))*reference_depth**(-exponent)
        self%is_made = .not. allocated(error)
    end subroutine new_power_graded

    !> C(k) under a pressure, (3.20): a point force displaces the surface by cos(m pi/2)/(pi c1 r^(1 + m)).
    elemental function compliance(self, k)
        class(power_graded_t), intent(in) :: self
        !> > 0 [1/length]
        real(wp), intent(in) :: k
        real(wp) :: compliance

        associate (m => self%exponent)
            compliance = 2.0_wp*cos(half_pi*m)/self%spring*gamma(0.5_wp*(1.0_wp - m))/gamma(0.5_wp*(1.0_wp + m)) &
                         *(0.5_wp*k)**m/k
        end associate
    end function compliance

    !> The arguments of new_power_graded.
    pure function power_law_parameters(n) result(list)
        !> E0, z0, m and nu
        real(wp), intent(in) :: n(4)
        type(parameter_t) :: list(4)

        list = [parameter_t("E0", n(1)), parameter_t("z0", n(2)), parameter_t("exponent", n(3), nature_signed), &
                parameter_t("nu", n(4), nature_poisson)]
    end function power_law_parameters

    !> Two of them pressed together: their springs, of one power of x, add in series.
    subroutine new_power_graded_pair(self, lower, upper, error)
        type(power_graded_t), intent(out) :: self
        !> not pairs
        type(power_graded_t), intent(in) :: lower, upper
        type(error_t), allocatable, intent(out) :: error

        if (lower%exponent /= upper%exponent) then
            call raise(error, error_invalid, "upper: two power-law graded bodies need equal exponents, here "// &
                       to_text(lower%exponent)//" and "//to_text(upper%exponent))
            return
        end if
        self%exponent = lower%exponent
        self%is_exact = .true.
        self%edge_rule = lower%edge_rule
        self%corner_rule = lower%corner_rule
        self%spring = in_series(lower%spring, upper%spring)
        self%share_of_upper = self%spring/upper%spring
        call set_pair(self, lower, upper, error)
        self%is_made = .not. allocated(error)
    end subroutine new_power_graded_pair

    !> H(m, nu), 1 for a homogeneous body.
    pure function spring_factor(m, nu) result(h)
        real(wp), intent(in) :: m, nu
        real(wp) :: h, beta, c

        beta = sqrt((1.0_wp + m)*(1.0_wp - m*nu/(1.0_wp - nu)))
        c = 2.0_wp**(1.0_wp + m)*gamma(0.5_wp*(3.0_wp + m + beta))*gamma(0.5_wp*(3.0_wp + m - beta))/(pi*gamma(2.0_wp + m))
        h = 2.0_wp*(1.0_wp + m)*cos(half_pi*m)*gamma(1.0_wp + 0.5_wp*m) &
            /(sqrt(pi)*c*beta*sin(half_pi*beta)*gamma(0.5_wp*(1.0_wp + m)))
    end function spring_factor

    !> E_eff = c1 a^m/(1 + m), from k = 2 int_0^a c(x) dx.
    subroutine modulus(self, a, values, error, slopes)
        class(power_graded_t), intent(in) :: self
        real(wp), intent(in) :: a(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), intent(out), optional :: slopes(:)

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        values = self%spring*a**self%exponent/(1.0_wp + self%exponent)
        if (present(slopes)) slopes = self%spring*self%exponent*a**(self%exponent - 1.0_wp)/(1.0_wp + self%exponent)
    end subroutine modulus

    !> d = g(a); exchanging the order of integration, F = 2 c1/(1+m) int_0^a f'(r) r^2 (a^2 - r^2)^{(m-1)/2} dr.
    subroutine solve(self, profile, a, solved, error, adhesive, accuracy, series)
        class(power_graded_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        type(solved_t), intent(out) :: solved
        type(error_t), allocatable, intent(out) :: error
        logical, intent(in), optional :: adhesive
        real(wp), intent(inout), optional :: accuracy
        real(wp), allocatable, intent(out), optional :: series(:, :)
        real(wp) :: moments(2), value(1), slope(1)
        type(error_t), allocatable :: never

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        if (present(adhesive) .or. present(series)) continue
        if (present(accuracy)) accuracy = 0.0_wp
        moments = slope_moments(self, profile, a, error)
        solved%depth = a**(1.0_wp - self%exponent)*moments(1)
        solved%force = 2.0_wp*self%spring/(1.0_wp + self%exponent)*moments(2)
        call self%modulus([a], value, never, slope)
        solved%modulus = value(1)
        solved%stiffness_slope = 2.0_wp*(solved%modulus + a*slope(1))
    end subroutine solve

    subroutine new_load(self, profile, a, punch_depth, load, error)
        class(power_graded_t), intent(in), target :: self
        class(profile_t), intent(in), target :: profile
        real(wp), intent(in) :: a, punch_depth
        class(load_t), allocatable, intent(out) :: load
        type(error_t), allocatable, intent(out) :: error
        type(power_graded_load_t), allocatable :: own

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        if (allocated(error)) continue
        allocate (own)
        own%medium => self
        own%profile => profile
        own%radius = a
        own%punch_depth = punch_depth
        own%edge = self%spring*a**self%exponent*punch_depth
        own%share_of_upper = self%share_of_upper
        call move_alloc(own, load)
    end subroutine new_load

    !> q(x) = c(x) (d - g(x)).
    subroutine line_load(self, r, values, error)
        class(power_graded_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: depth
        integer :: i

        associate (medium => self%medium, profile => self%profile, a => self%radius, punch_depth => self%punch_depth)
            depth = mdr(medium, profile, a, error) + punch_depth
            if (allocated(error)) return
            do i = 1, size(r)
                values(i) = depth - mdr(medium, profile, r(i), error)
                if (r(i) > 0.0_wp .or. medium%exponent >= 0.0_wp) then
                    values(i) = values(i)*medium%spring*r(i)**medium%exponent
                else
                    values(i) = infinity
                end if
            end do
        end associate
    end subroutine line_load

    !> p(r) = (c1/pi) [punch_depth (a^2 - r^2)^{(m-1)/2} + int_r^a g'(x) (x^2 - r^2)^{(m-1)/2} dx].
    subroutine pressure(self, r, values, error)
        class(power_graded_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call add_powers(self, r, 0.5_wp*(self%medium%exponent - 1.0_wp), values, error)
        if (.not. allocated(error)) values = values*self%medium%spring/pi
    end subroutine pressure

    !> int p dy = (c1/pi) B((1+m)/2, 1/2) [punch_depth (a^2 - x^2)^{m/2} + int_x^a g'(s) (s^2 - x^2)^{m/2} ds], for
    !> 2 int_x^s r (s^2 - r^2)^{(m-1)/2} (r^2 - x^2)^{-1/2} dr = B((1+m)/2, 1/2) (s^2 - x^2)^{m/2}:
    !> theory/conduction.md (10.10).
    subroutine projection(self, r, values, error)
        class(power_graded_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call add_powers(self, r, 0.5_wp*self%medium%exponent, values, error)
        if (allocated(error)) return
        associate (m => self%medium%exponent)
            values = values*self%medium%spring/sqrt(pi)*gamma(0.5_wp*(1.0_wp + m))/gamma(1.0_wp + 0.5_wp*m)
        end associate
    end subroutine projection

    !> punch_depth (a^2 - r^2)^power + int_r^a g'(x) (x^2 - r^2)^power dx.
    subroutine add_powers(self, r, power, values, error)
        class(power_graded_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        !> (m - 1)/2 or m/2
        real(wp), intent(in) :: power
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(sampled_function_t) :: g
        real(wp), allocatable :: breaks(:), corners(:)
        real(wp) :: start
        integer :: i, k

        associate (medium => self%medium, profile => self%profile, a => self%radius, punch_depth => self%punch_depth)
            if (profile%end_radius < a) call sample_transform(medium, profile, a, g, error)
            if (allocated(error)) return
            call profile%add_breaks(breaks, error)
            breaks = breaks(:count(breaks < a))
            do i = 1, size(r)
                values(i) = 0.0_wp
                if (punch_depth /= 0.0_wp) then
                    values(i) = punch_depth*infinity
                    if (r(i) < a .or. power >= 0.0_wp) values(i) = punch_depth*((a - r(i))*(a + r(i)))**power
                end if
                start = max(r(i), profile%end_radius)
                if (medium%exponent + 0.5_wp*added(medium, power) <= 0.0_wp .and. r(i) > 0.0_wp .and. &
                    r(i) == profile%end_radius .and. a > start) then
                    values(i) = infinity
                else if (a > start) then
                    corners = [start, pack(breaks, breaks > start), a]
                    do k = 1, size(corners) - 1
                        values(i) = values(i) + powers_between(medium, profile, g, corners(k), corners(k + 1), r(i), power, error)
                    end do
                end if
            end do
        end associate
    end subroutine add_powers

    !> u(r) = (2 cos(m pi/2)/pi) int_0^a x^m w(x) (r^2 - x^2)^{-(1+m)/2} dx, r > a, w = d - g.
    subroutine displacement(self, r, values, error)
        class(power_graded_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(sampled_function_t) :: g
        real(wp), allocatable :: x(:), dx(:), w(:), breaks(:)
        real(wp) :: depth, lowest
        integer :: i

        associate (medium => self%medium, profile => self%profile, a => self%radius, punch_depth => self%punch_depth)
            if (size(r) == 0) return
            if (profile%end_radius < a) call sample_transform(medium, profile, a, g, error)
            if (allocated(error)) return
            depth = mdr(medium, profile, a, error) + punch_depth
            if (allocated(error)) return
            lowest = smallest_panel_ratio*a
            call profile%add_breaks(breaks, error)
            do i = 1, size(r)
                call graded_rule(lowest, a, breaks, min(r(i), profile%singular_radius), x, dx, error)
                if (allocated(error)) return
                w = spread(depth, 1, size(x))
                if (profile%end_radius < a) w = depth - merge(g%value(x), 0.0_wp, x > profile%end_radius)
                values(i) = sum(x**medium%exponent*w*((r(i) - x)*(r(i) + x))**(-0.5_wp*(1.0_wp + medium%exponent))*dx) &
                            + depth*(lowest/r(i))**(1.0_wp + medium%exponent)/(1.0_wp + medium%exponent)
                values(i) = values(i)*cos(half_pi*medium%exponent)/half_pi
            end do
        end associate
    end subroutine displacement

    !> g(x) = x^{1-m} int_0^x f'(r) (x^2 - r^2)^{(m-1)/2} dr.
    function mdr(self, profile, x, error) result(g)
        class(power_graded_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: x
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: g
        real(wp) :: moments(2)

        g = 0.0_wp
        if (x <= profile%end_radius) return
        moments = slope_moments(self, profile, x, error)
        g = x**(1.0_wp - self%exponent)*moments(1)
    end function mdr

    !> int_0^a f'(r) {1, r^2} (a^2 - r^2)^{(m-1)/2} dr. Next to a f' is smooth, and a rule of its own has the power of s = a - r as
    !> its weight; at the corner below, the last break of the profile, f' may begin as a broken power of r - corner. Close to a the
    !> distance s is what varies, towards the axis r.
    function slope_moments(self, profile, a, error) result(moments)
        class(power_graded_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: moments(2)
        real(wp), allocatable :: r(:), dr(:), s(:), breaks(:)
        real(wp) :: axis, corner, length, middle, power, reach
        real(wp), parameter :: no_breaks(0) = [real(wp) ::]

        moments = 0.0_wp
        power = 0.5_wp*(self%exponent - 1.0_wp)
        call profile%add_breaks(breaks, error)
        if (allocated(error)) return
        axis = max(nearest_axis*a, profile%end_radius)
        corner = max(axis, maxval(breaks, mask=breaks < a))

        length = max(closest*a, 0.5_wp*min(a - corner, profile%singular_radius - a))
        s = length*self%edge_rule(:, 1)
        moments = moments_of(a - s, (2.0_wp*a - s)**power*length**(power + 1.0_wp)*self%edge_rule(:, 2))
        reach = length
        if (corner > 0.5_wp*a .and. a - corner > length .and. .not. profile%singular_radius < huge(1.0_wp)) then
            reach = a - corner
            s = reach - (reach - length)*self%corner_rule(:, 1)
            moments = moments + moments_of(a - s, (s*(2.0_wp*a - s))**power*(reach - length)*self%corner_rule(:, 2))
        end if
        middle = a - reach
        if (reach < 0.125_wp*a .and. axis < middle) then
            middle = 0.5_wp*(middle + max(axis, maxval(breaks, mask=breaks < middle)))
            call graded_rule(reach, a - middle, no_breaks, huge(1.0_wp), s, dr, error)
            if (allocated(error)) return
            moments = moments + moments_of(a - s, (s*(2.0_wp*a - s))**power*dr)
        end if
        if (axis < middle) then
            call graded_rule(axis, middle, breaks, min(a, profile%singular_radius), r, dr, error)
            if (allocated(error)) return
            moments = moments + moments_of(r, ((a - r)*(a + r))**power*dr)
        end if
        if (axis > profile%end_radius) moments(1) = moments(1) + profile%height(axis)*a**(2.0_wp*power)

    contains

        pure function moments_of(r, weights) result(sums)
            real(wp), intent(in) :: r(:), weights(:)
            real(wp) :: sums(2)
            real(wp) :: f(size(r))

            f = profile%slope(r)*weights
            sums = [sum(f), sum(f*r**2)]
        end function moments_of

    end function slope_moments

    !> g on (0, a], to differentiate and integrate.
    subroutine sample_transform(self, profile, a, g, error)
        class(power_graded_t), intent(in), target :: self
        class(profile_t), intent(in), target :: profile
        real(wp), intent(in) :: a
        type(sampled_function_t), intent(out) :: g
        type(error_t), allocatable, intent(out) :: error
        type(transform_t) :: transform
        real(wp), allocatable :: edges(:), breaks(:), corners(:)
        integer :: i, k

        transform%profile => profile
        transform%medium => self
        call profile%add_breaks(breaks, error)
        if (allocated(error)) return
        corners = [profile%end_radius, breaks(count(breaks <= profile%end_radius) + 1:count(breaks < a)), a]
        allocate (edges(0))
        do k = 1, size(corners) - 1
            edges = [edges, [(corners(k) + (corners(k + 1) - corners(k))*0.5_wp**i, i=octaves, 1, -1)], corners(k + 1)]
        end do
        if (corners(1) > 0.0_wp) edges = [corners(1), edges]
        call new_sampled_function(g, transform, edges, spread(.false., 1, size(edges) - 1), sampling_tolerance, error, &
                                  noise=merge(sampling_tolerance, 0.0_wp, size(corners) > 2 .or. corners(1) > 0.0_wp) &
                                  *transform%value(a), roughness=roughness)
    end subroutine sample_transform

    function transform_at(self, x) result(y)
        class(transform_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = mdr(self%medium, self%profile, x, self%error)
    end function transform_at

    !> int g'(x) (x^2 - r^2)^power dx from one corner of the profile to the next, r <= from. Behind a corner g rises as a broken
    !> power of x - from: panels are graded towards it, and what lies within `near` of it is the rise of g there.
    function powers_between(self, profile, g, from, to, r, power, error) result(integral)
        class(power_graded_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        type(sampled_function_t), intent(in) :: g
        real(wp), intent(in) :: from, to, r, power
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: integral
        real(wp), allocatable :: beyond(:), dx(:)
        real(wp), parameter :: no_breaks(0) = [real(wp) ::]
        real(wp) :: near

        near = closest*from
        if (from <= 0.0_wp) near = 4.0_wp*g%lower()
        if (r == from .and. from == profile%end_radius .and. from > 0.0_wp) near = at_edge*from
        if (r < from) near = max(behind_corner(1)*from, min(behind_corner(2)*from, behind_corner(3)*(from - r)))
        integral = 0.0_wp
        if (near >= to - from) return
        call graded_rule(near, to - from, no_breaks, huge(1.0_wp), beyond, dx, error)
        if (allocated(error)) return
        ! in this order powers of the smallest radii stay numbers
        integral = sum(slope_of(profile, g, from + beyond)*dx*(beyond + (from - r))**power*((from + r) + beyond)**power) &
                   + near_start(self, profile, g, from, near, r, power, error)
    end function powers_between

    !> The part of the pressure integral within `near` of its singular start, where g' is constant or, at the axis, a power of x.
    function near_start(self, profile, g, start, near, r, power, error) result(integral)
        class(power_graded_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        type(sampled_function_t), intent(in) :: g
        real(wp), intent(in) :: start, near, r, power
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: integral
        real(wp) :: growth

        if (start <= 0.0_wp) then
            growth = exponent_at(g, 0.5_wp*near) + self%exponent + added(self, power)
            if (growth > 1.0e-6_wp) then
                integral = g%slope(near)*near**(self%exponent + added(self, power))/growth
            else
                integral = infinity
            end if
        else if (r < start) then
            integral = (mdr(self, profile, start + near, error) - mdr(self, profile, start, error))*((start - r)*(start + r))**power
        else
            integral = slope_of(profile, g, start + near)*(2.0_wp*start)**power*near**(power + 1.0_wp)
            ! at the edge of a flat end g' itself goes as (x - start)^{(m-1)/2}
            integral = integral/merge(self%exponent + 0.5_wp*added(self, power), power + 1.0_wp, &
                                      start == profile%end_radius .and. start > 0.0_wp)
        end if
    end function near_start

    !> 2 power of x more than in the pressure integral: 0 there.
    pure function added(self, power) result(difference)
        class(power_graded_t), intent(in) :: self
        real(wp), intent(in) :: power
        real(wp) :: difference

        difference = 2.0_wp*(power - 0.5_wp*(self%exponent - 1.0_wp))
    end function added

    !> g'(x); nearer to an axis than g is sampled it is a power of x.
    elemental function slope_of(profile, g, x) result(slope)
        class(profile_t), intent(in) :: profile
        type(sampled_function_t), intent(in) :: g
        real(wp), intent(in) :: x
        real(wp) :: slope
        real(wp) :: lowest

        lowest = 2.0_wp*g%lower()
        if (x >= lowest .or. profile%end_radius > 0.0_wp) then
            slope = g%slope(x)
        else
            slope = g%slope(lowest)*(x/lowest)**exponent_at(g, lowest)
        end if
    end function slope_of

    !> The power of x that g' follows between x and 2 x.
    pure function exponent_at(g, x) result(exponent)
        type(sampled_function_t), intent(in) :: g
        real(wp), intent(in) :: x
        real(wp) :: exponent

        exponent = log(g%slope(2.0_wp*x)/g%slope(x))/log(2.0_wp)
    end function exponent_at

end module mdrcontact_medium_power_graded
