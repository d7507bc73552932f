! SPDX-License-Identifier: GPL-3.0-or-later
!> The line load of a state as a Legendre series, and what follows from it in closed sums (theory/exact.md (3.10), (3.11)):
!> q = E0* (d - g - v).
!>
!> The part d - g belongs to a half-space of the surface material and is left to it; v(x) = (K q)(x)/E0* is smooth at the kernel's
!> width for any g. P_2j(x/a) as a line load is the pressure P_2j(cosine)/(P_2j(0) pi sqrt(a^2 - r^2)), cosine = sqrt(1 - r^2/a^2).
module mdrcontact_line_fields
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_legendre, only: contact_rule, is_fine, moments_t, new_interaction, normalisation
    use mdrcontact_line_moments, only: is_smooth
    use mdrcontact_line_panels, only: new_panels, panels_t
    use mdrcontact_line_rule, only: new_rule, rule_t
    use mdrcontact_line_series, only: add_even_sum, even_sum
    use mdrcontact_line_solve, only: equation_t, first_unknowns, new_equation, next_unknowns, raise_missed, solution_t, &
                                       solve, solve_lower, solve_upper
    use mdrcontact_numerics_quadrature, only: graded_rule, smallest_panel_ratio
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: line_load_t, new_line_load

    !> Unknowns of a line load at most: a profile with a kink on a film h takes 3 a/h.
    integer, parameter :: most_unknowns = 1500
    !> A panel beyond the edge is this long, in units of the kernel, or as long as its distance from the edge.
    real(wp), parameter :: longest_panel = 1.5_wp
    integer, parameter :: panel_nodes = 32
    !> From so far on, in units of the contact radius or the kernel, displacements fall as 1/r.
    real(wp), parameter :: farthest = 1.0e15_wp
    !> The constants of a body whose layers are all thinner than this vary with depth.
    real(wp), parameter :: largest_resolved = 0.5_wp*huge(1.0_wp)

    !> q/E0* on the contact [length].
    type :: line_load_t
        !> contact radius [length], d, and q/E0* at its edge [length]
        real(wp) :: a = 0.0_wp, depth = 0.0_wp, edge = 0.0_wp
        !> d less the mean of v: separate, because on stiff films both are far greater than q/E0* [length]
        real(wp) :: level = 0.0_wp
        !> coefficients of P_2j(x/a), j = 0, 1, ..., in q/E0*, and in v [length]
        real(wp), allocatable :: q(:), v(:)
        !> v where its series falls too slowly for values at points
        type(panels_t), allocatable :: panels
    contains
        procedure :: at
        procedure :: smooth_pressure
        procedure :: punch_pressure
        procedure :: displacement_beyond
        procedure :: interaction_beyond
        procedure :: part_of
        procedure :: displacement_by
        procedure :: work_on
    end type line_load_t

contains

    !> The line load of the state at contact radius a with a depth beyond the non-adhesive one.
    subroutine new_line_load(self, kernel, tolerance, profile, a, punch_depth, error, at_points)
        type(line_load_t), intent(out) :: self
        type(kernel_t), intent(in) :: kernel
        !> of values of q and p anywhere, relative to their mean square
        real(wp), intent(in) :: tolerance
        class(profile_t), intent(in) :: profile
        !> [length]
        real(wp), intent(in) :: a, punch_depth
        type(error_t), allocatable, intent(out) :: error
        !> for q, p, what lies beyond the edge, and the work of the whole, not for the series; default false
        logical, intent(in), optional :: at_points
        real(wp) :: reached, on_panels
        integer :: n
        logical :: solved, may_take_panels

        reached = huge(reached)
        may_take_panels = .false.
        if (present(at_points)) may_take_panels = at_points .and. kernel%resolved > largest_resolved
        if (may_take_panels) may_take_panels = abs(punch_depth) > 0.0_wp .or. .not. is_smooth(profile)
        on_panels = huge(on_panels)
        n = min(unknowns_for(kernel, tolerance, a/kernel%unit, is_smooth(profile)), most_unknowns)
        do
            call check_cancelled(error)
            if (allocated(error)) return
            call expand(self, kernel, profile, a, punch_depth, n, reached, solved, error)
            if (allocated(error)) return
            if (.not. solved) exit
            if (reached <= tolerance) return
            if (may_take_panels) then
                call expand_on_panels(self, kernel, tolerance, profile, a, punch_depth, on_panels, error)
                if (allocated(error) .or. on_panels <= tolerance) return
                may_take_panels = .false.
            end if
            if (n >= most_unknowns) exit
            n = min(next_unknowns(n, reached/tolerance), most_unknowns)
        end do
        ! where the profile is not smooth, on films thin against the radius, it would take more unknowns
        call raise_missed(error, "a field", tolerance, a, min(reached, on_panels))
    end subroutine new_line_load

    !> The state by its panels instead of its series.
    subroutine expand_on_panels(self, kernel, tolerance, profile, a, punch_depth, reached, error)
        type(line_load_t), intent(inout) :: self
        type(kernel_t), intent(in) :: kernel
        real(wp), intent(in) :: tolerance
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a, punch_depth
        !> estimated error of values of q and p
        real(wp), intent(out) :: reached
        type(error_t), allocatable, intent(inout) :: error
        type(solution_t) :: solution
        type(error_t), allocatable :: missed

        reached = huge(reached)
        call solve(kernel, tolerance, a, solution, missed, profile, edge=abs(punch_depth) > 0.0_wp)
        ! the series may do yet
        if (allocated(missed)) return
        self%a = a
        self%depth = solution%depth + punch_depth
        self%edge = punch_depth*solution%punch_edge
        allocate (self%panels)
        call new_panels(self%panels, kernel, profile, a, solution%force + 2.0_wp*a*solution%modulus*punch_depth, self%edge, &
                        reached, error)
        if (reached > tolerance) deallocate (self%panels)
    end subroutine expand_on_panels

    !> n such that the series ends at rounding at the first attempt, for films: fitted to what 3 films take.
    pure function unknowns_for(kernel, tolerance, a, smooth) result(n)
        type(kernel_t), intent(in) :: kernel
        !> relative tolerance, and contact radius [unit]
        real(wp), intent(in) :: tolerance, a
        !> see is_smooth
        logical, intent(in) :: smooth
        integer :: n
        real(wp) :: coarse

        n = ceiling(1.5_wp*first_unknowns(kernel, tolerance, a, is_kinked=.false., to_edge=.false.))
        if (kernel%vanishes) return
        coarse = min(a/kernel%resolved, real(most_unknowns, wp))
        n = max(n, ceiling(5.0_wp + 10.0_wp*sqrt(coarse) + merge(0.0_wp, 3.0_wp, smooth)*coarse))
    end function unknowns_for

    !> With n unknowns.
    subroutine expand(self, kernel, profile, a, punch_depth, n, reached, solved, error)
        type(line_load_t), intent(inout) :: self
        type(kernel_t), intent(in) :: kernel
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a, punch_depth
        integer, intent(in) :: n
        !> how large the last coefficients of v still are in a pressure
        real(wp), intent(out) :: reached
        logical, intent(out) :: solved
        type(error_t), allocatable, intent(inout) :: error
        type(equation_t) :: equation
        real(wp) :: x(n, 3), s(n), beyond

        reached = 0.0_wp
        call new_equation(equation, kernel, a, n, n, 4*n + 4, 4*n, solved, error, profile)
        if (allocated(error) .or. .not. solved) return
        x = equation%rhs
        call solve_lower(n, n, 3, equation%h, x)
        call solve_upper(n, n, 3, equation%h, x)
        self%a = a
        associate (row => equation%rhs(:, 2))
            self%edge = punch_depth*sum(row*x(:, 1))
            beyond = (equation%edge_above_mean + self%edge + sum(row*x(:, 3)))/sum(row*x(:, 1))
        end associate
        self%depth = equation%profile_mean + beyond
        s = normalisation(n)
        self%q = s*(beyond*x(:, 1) - x(:, 3))
        self%v = -s*equation%rhs(:, 3) - self%q
        self%level = equation%profile_mean - self%v(1)
        self%v(1) = self%v(1) + beyond
        if (kernel%vanishes) return
        reached = maxval(abs(self%v(n - 3:)))*real(2*n, wp)/sqrt(sum((self%q/s)**2) + tiny(1.0_wp))
    end subroutine expand

    !> q(x)/E0* [length].
    pure subroutine at(self, profile, x, values)
        class(line_load_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        !> 0 <= x <= a [length]
        real(wp), intent(in) :: x(:)
        !> same size as x
        real(wp), intent(out) :: values(:)
        integer :: i

        if (allocated(self%panels)) then
            do i = 1, size(x)
                values(i) = self%panels%level - profile%mdr(x(i)) - self%panels%value(x(i))
            end do
            return
        end if
        do i = 1, size(x)
            values(i) = self%level - profile%mdr(x(i))
        end do
        call add_even_sum([0.0_wp, self%v(2:)], x, self%a, -1.0_wp, values)
    end subroutine at

    !> The pressure over E0* that v takes from the homogeneous one, without what is singular at the edge:
    !> -(cosine/(pi a)) sum v_j B_j(cosine), B_j = [P_2j(cosine)/P_2j(0) - 1]/cosine^2.
    pure function smooth_pressure(self, r) result(pressure)
        class(line_load_t), intent(in) :: self
        !> 0 <= r <= a [length]
        real(wp), intent(in) :: r
        real(wp) :: pressure
        real(wp) :: cosine, square, total, even, odd, b, at_zero
        integer :: j

        if (allocated(self%panels)) then
            pressure = self%panels%smooth_pressure(r)
            return
        end if
        square = (1.0_wp - r/self%a)*(1.0_wp + r/self%a)
        cosine = sqrt(max(square, 0.0_wp))
        ! even: P_2j, odd: P_(2j+1)/cosine
        even = 1.0_wp
        odd = 1.0_wp
        b = 0.0_wp
        at_zero = 1.0_wp
        total = 0.0_wp
        do j = 0, size(self%v) - 2
            b = b - real(4*j + 3, wp)/real(2*j + 1, wp)*odd/at_zero
            at_zero = -at_zero*real(2*j + 1, wp)/real(2*j + 2, wp)
            even = (real(4*j + 3, wp)*square*odd - real(2*j + 1, wp)*even)/real(2*j + 2, wp)
            odd = (real(4*j + 5, wp)*even - real(2*j + 2, wp)*odd)/real(2*j + 3, wp)
            total = total + self%v(j + 2)*b
        end do
        pressure = -cosine/(pi*self%a)*total
    end function smooth_pressure

    !> The pressure over E0* under a flat punch, with what is singular at the edge.
    pure function punch_pressure(self, r) result(pressure)
        class(line_load_t), intent(in) :: self
        !> 0 <= r < a [length]
        real(wp), intent(in) :: r
        real(wp) :: pressure

        pressure = self%smooth_pressure(r) + self%edge/(pi*sqrt((self%a - r)*(self%a + r)))
    end function punch_pressure

    !> (K q)(x)/E0* with the kernel of one of two bodies, as coefficients of P_2j(x/a) [length].
    subroutine part_of(self, kernel, v, error)
        class(line_load_t), intent(in) :: self
        type(kernel_t), intent(in) :: kernel
        !> same size as self%q
        real(wp), intent(out) :: v(:)
        type(error_t), allocatable, intent(inout) :: error
        type(moments_t) :: moments
        real(wp), allocatable :: h(:, :)
        real(wp) :: s(size(v)), q(size(v))
        integer :: i, n

        v = 0.0_wp
        if (kernel%vanishes) return
        n = size(v)
        call new_interaction(moments, h, kernel, self%a, n, n, 4*n + 4, 4*n, error)
        if (allocated(error)) return
        s = normalisation(n)
        q = self%q/s
        do i = 1, n
            v(i) = v(i) + sum(h(i, :i)*q(:i)) + (moments%diagonal - 1.0_wp)*q(i)
            v(:i - 1) = v(:i - 1) + h(i, :i - 1)*q(i)
        end do
        v = s*v
    end subroutine part_of

    !> (2/pi) int_0^min(r,a) of a series in P_2j(x/a) over sqrt(r^2 - x^2) dx [length].
    subroutine displacement_by(self, c, r, values, error)
        class(line_load_t), intent(in) :: self
        !> coefficients [length]
        real(wp), intent(in) :: c(:)
        !> >= 0 [length]
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp) :: steps(size(c)/2 + 1), range
        integer :: i, j

        ! x = r sin(t): even polynomials of degree 2 size(c) - 2 in sin(t). Inside equal steps of t take them exactly.
        steps = [(sin(half_pi*(real(i, wp) - 0.5_wp)/real(size(steps), wp)), i=1, size(steps))]
        call new_rule(rule, size(c) + 16, error)
        values = 0.0_wp
        if (allocated(error)) return
        do j = 1, size(r)
            if (r(j) <= self%a) then
                values(j) = sum(even_sum(c, r(j)/self%a*steps))/real(size(steps), wp)
            else
                range = 0.5_wp*asin(self%a/r(j))
                values(j) = range/half_pi*sum(rule%weights*even_sum(c, min(r(j)/self%a*sin(range*rule%distance), 1.0_wp)))
            end if
        end do
    end subroutine displacement_by

    !> int_0^a q (q + E0* v) dx/E0*^2 with v as coefficients of P_2j(x/a) [length^3]; on panels v is that of the whole.
    function work_on(self, profile, v, error) result(work)
        class(line_load_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: v(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: work
        real(wp), allocatable :: x(:), dx(:), q(:), moved(:), breaks(:)
        integer :: stat

        call profile%add_breaks(breaks, error)
        call graded_rule(smallest_panel_ratio*self%a, self%a, breaks, profile%singular_radius, x, dx, error)
        work = 0.0_wp
        if (allocated(error)) return
        allocate (q(size(x)), moved(size(x)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        call self%at(profile, x, q)
        if (allocated(self%panels)) then
            moved(:) = self%depth - profile%mdr(x)
        else
            moved(:) = q
            call add_even_sum(v, x, self%a, 1.0_wp, moved)
        end if
        work = sum(dx*q*moved)
    end function work_on

    !> Coefficients of P_0, P_1, ... from the nodes of a Gauss rule and values times weights there.
    pure function legendre_series(u, values) result(c)
        real(wp), intent(in) :: u(:), values(:)
        real(wp) :: c(0:size(u) - 1)
        real(wp), dimension(size(u)) :: before, here, next
        integer :: m

        before = 0.0_wp
        here = 1.0_wp
        do m = 0, size(u) - 1
            c(m) = real(2*m + 1, wp)*0.5_wp*sum(values*here)
            next = (real(2*m + 1, wp)*u*here - real(m, wp)*before)/real(m + 1, wp)
            before = here
            here = next
        end do
    end function legendre_series

    !> (K q)(x)/E0* = (1/pi) int_-a^a X(x - s) q(s)/E0* ds beyond the contact [length].
    subroutine interaction_beyond(self, kernel, n, distances, values, error)
        class(line_load_t), intent(in) :: self
        type(kernel_t), intent(in) :: kernel
        integer, intent(in) :: n
        !> x - a >= 0 [length]
        real(wp), intent(in) :: distances(n)
        real(wp), intent(out) :: values(n)
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp), allocatable :: load(:), x(:)
        real(wp) :: a
        integer :: i, terms

        values = 0.0_wp
        if (kernel%vanishes) return
        if (allocated(self%panels)) then
            call self%panels%interaction_beyond(kernel, n, distances, values, error)
            return
        end if
        a = self%a/kernel%unit
        terms = size(self%q)
        ! X does not show beyond the degree at which the series was let end: that of the product is twice as large
        call contact_rule(rule, a, 2*terms + 2, 4*terms, is_fine(kernel, a, terms), error)
        if (allocated(error)) return
        load = a/pi*rule%weights*even_sum(self%q, 1.0_wp - rule%distance)
        allocate (x, mold=load)
        do i = 1, n
            call kernel%evaluate(distances(i)/kernel%unit + a*rule%distance, 0.0_wp, x)
            values(i) = sum(load*x)
        end do
    end subroutine interaction_beyond

    !> Contribution of the layers to the displacement of the surface outside the contact:
    !> (2/pi) int_a^r w(x)/sqrt(r^2 - x^2) dx [length], with w(x) = (1/pi) int_-a^a X(x - s) q(s)/E0* ds.
    subroutine displacement_beyond(self, kernel, r, values, error)
        class(line_load_t), intent(in) :: self
        type(kernel_t), intent(in) :: kernel
        !> > a [length]
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: panel
        real(wp), allocatable :: x(:, :), w(:, :), series(:, :)
        real(wp) :: a, far, start, length, last, y(panel_nodes), root(panel_nodes)
        integer :: j, k, panels

        a = self%a/kernel%unit
        call new_rule(panel, panel_nodes, error)
        values = 0.0_wp
        if (allocated(error) .or. size(r) == 0) return
        last = farthest*max(self%a, kernel%unit)
        ! panel k begins at a distance longest_panel (2^(k-1) - 1) from the edge [unit] and is longest_panel 2^(k-1) long: w at
        ! the nodes, and as Legendre series
        panels = panel_at((min(maxval(r), last) - self%a)/kernel%unit)
        allocate (x(panel_nodes, panels), w(panel_nodes, panels), series(0:panel_nodes - 1, panels))
        do k = 1, panels
            call place(k, start, length)
            x(:, k) = kernel%unit*(start + 0.5_wp*length*panel%distance)
        end do
        call self%interaction_beyond(kernel, size(x), x, w, error)
        if (allocated(error)) return
        do k = 1, panels
            series(:, k) = legendre_series(panel%distance - 1.0_wp, panel%weights*w(:, k))
        end do
        do j = 1, size(r)
            far = (min(r(j), last) - self%a)/kernel%unit
            start = 0.0_wp
            do k = 1, panels
                call place(k, start, length)
                if (start + 2.0_wp*length >= far) exit
                y = start + 0.5_wp*length*panel%distance
                values(j) = values(j) + sum(0.5_wp*length*panel%weights*w(:, k)/sqrt((far - y)*(2.0_wp*a + far + y)))
            end do
            ! the root's pole is next to the panels before r: they are taken together, from the pole
            length = far - start
            y = far - 0.25_wp*length*panel%distance**2
            root = sqrt(length/(2.0_wp*a + far + y))
            values(j) = (2.0_wp/pi)*(values(j) + sum(panel%weights*root*value_at(y)))*min(last/r(j), 1.0_wp)
        end do

    contains

        elemental function panel_at(distance) result(k)
            real(wp), intent(in) :: distance
            integer :: k

            k = exponent(1.0_wp + max(distance, 0.0_wp)/longest_panel)
        end function panel_at

        pure subroutine place(k, start, length)
            integer, intent(in) :: k
            real(wp), intent(out) :: start, length

            length = scale(longest_panel, k - 1)
            start = length - longest_panel
        end subroutine place

        !> w at distances from the edge.
        pure function value_at(y) result(values)
            real(wp), intent(in) :: y(panel_nodes)
            real(wp) :: values(panel_nodes)
            real(wp), dimension(panel_nodes) :: u, before, here, next
            integer :: m, at(panel_nodes)

            at = min(panel_at(y), panels)
            ! 2 (y - start)/length - 1
            u = 2.0_wp*(y/longest_panel + 1.0_wp)*scale(1.0_wp, 1 - at) - 3.0_wp
            before = 0.0_wp
            here = 1.0_wp
            values = 0.0_wp
            do m = 0, panel_nodes - 1
                values = values + series(m, at)*here
                next = (real(2*m + 1, wp)*u*here - real(m, wp)*before)*(1.0_wp/real(m + 1, wp))
                before = here
                here = next
            end do
        end function value_at

    end subroutine displacement_beyond

end module mdrcontact_line_fields
