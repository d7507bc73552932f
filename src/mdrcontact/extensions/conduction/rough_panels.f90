! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact area whose area resistance R_c(p(r)) is small, or not smooth: by polynomials on panels that shrink towards
!> the edge, where the flux changes within a width of about a (S_0 R_c/a)^(2/3), and towards kinks of the pressure.
!>
!> The unknown is the line load q as a function of s, x^2 = a^2 - s^2, continuous; at r^2 = a^2 - t^2 it is the flux density
!>     j = (1/pi) [q(0)/t + int_0^(pi/2) q'(s) d beta],  s = t sin beta,
!> and G the largest value of 2 f - A over all q, G = 2 pi f.inv(A).f, with
!>     A = (1/(2 pi S_0)) int_0^a q (1 + H) q dx + int R_c j^2 r dr,  f = (1/pi) int_0^a q dx.
!> For any q, G is too small: more polynomials come from below, and the error is the square of that of q:
!> theory/conduction.md (4.11), (4.12).
module mdrcontact_conduction_rough_panels
    use mdrcontact_conduction_bodies, only: conduction_t, tolerance
    use mdrcontact_conduction_rough_law, only: rough_law_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_error, only: error_domain, error_no_convergence, error_t, raise
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_line_legendre, only: interaction_matrix, normalisation
    use mdrcontact_line_moments, only: is_smooth
    use mdrcontact_line_rule, only: new_rule, rule_t
    use mdrcontact_line_series, only: add_projections
    use mdrcontact_line_solve, only: factorize, first_unknowns, solve_lower
    use mdrcontact_numerics_one_thread, only: add_product
    use mdrcontact_numerics_quadrature, only: legendre
    implicit none (type, external)
    private
    public :: conductance_by_panels, solve_flux

    !> Degree of the polynomials, and a smaller one that must agree.
    integer, parameter :: degree = 12, lower_degree = 9
    !> Panels next to each other, the longest one over the radius, and the shortest one at the edge, at kinks, and at the axis,
    !> where x^2 = 1 - s^2.
    real(wp), parameter :: growth = 0.35_wp, longest = 0.25_wp, shortest = 1.0e-6_wp, shortest_inside = 1.0e-4_wp, &
                           shortest_axis = 1.0e-7_wp
    !> Kinks of the pressure around which panels shrink; of more those of the medium are only ends of panels.
    integer, parameter :: most_kinks = 4
    !> Nodes of a panel, and of what it gives to a flux, a polynomial of s.
    integer, parameter :: nodes = 32, nodes_of_flux = 20
    !> Beyond this distance t/a from the edge the pressure is taken as it comes: r gives no information on smaller ones, over which
    !> the pressure is a power. One that grows by this power of t at most is infinite at the edge.
    real(wp), parameter :: from_edge = 1.0e-4_wp, singular = -0.05_wp

    !> The panels, at a = 1, and their polynomials: one for each end of a panel, which the next shares, and bubbles.
    type :: panels_t
        !> s, from 0 to 1
        real(wp), allocatable :: ends(:)
        !> 1 where q may differ from 0 at the edge, else 0
        integer :: first = 0
    contains
        procedure :: number
        procedure :: place
        procedure :: size_with
    end type panels_t

contains

    !> G of a state, from below, and its relative decrease with fewer polynomials.
    subroutine conductance_by_panels(conduction, load, law, conductance, reached, error)
        type(conduction_t), intent(in) :: conduction
        type(contact_load_t), intent(in) :: load
        class(rough_law_t), intent(in) :: law
        !> [conductance]
        real(wp), intent(out) :: conductance
        real(wp), intent(out) :: reached
        type(error_t), allocatable, intent(inout) :: error
        type(panels_t) :: panels
        real(wp), allocatable :: t(:), weight(:), resistance(:), matrix(:, :), f(:, :), scaling(:)
        integer :: i, n

        conductance = 0.0_wp
        reached = 0.0_wp
        call place_ends(panels, load%equilibrium, load%state%radius, error)
        if (allocated(error)) return
        n = nodes*panels%number()
        allocate (t(n), weight(n), resistance(n))
        call place_nodes(panels, t, weight, error)
        if (.not. allocated(error)) call resistances(panels, load, law, t, resistance, error)
        if (allocated(error)) return
        n = panels%size_with(degree)
        allocate (matrix(n, n), f(n, 1))
        call fill_springs(panels, conduction, load%state%radius, matrix, f(:, 1), error)
        if (.not. allocated(error)) then
            call add_resistance(panels, t, load%state%radius**2*law%scale*weight*t*resistance, matrix, error)
        end if
        if (allocated(error)) return
        scaling = [(1.0_wp/sqrt(matrix(i, i)), i=1, n)]
        f(:, 1) = scaling*f(:, 1)
        do i = 1, n
            matrix(:, i) = scaling*matrix(:, i)*scaling(i)
        end do
        call solve_flux(matrix, f, error)
        if (allocated(error)) return
        conductance = 2.0_wp*pi*sum(f**2)
        reached = sum(f(panels%size_with(lower_degree) + 1:, 1)**2)/sum(f**2)
    end subroutine conductance_by_panels

    !> L^-1 f of A = L L^t: the sum of its squares is the flux at potential 1, over 2 pi.
    subroutine solve_flux(matrix, f, error)
        !> A, symmetric, both sizes those of f
        real(wp), intent(inout) :: matrix(:, :)
        !> one column
        real(wp), intent(inout) :: f(:, :)
        type(error_t), allocatable, intent(inout) :: error
        logical :: done

        call factorize(size(f, 1), size(f, 1), matrix, done)
        if (.not. done) then
            call raise(error, error_no_convergence, "the flux through a rough contact could not be solved for")
            return
        end if
        call solve_lower(size(f, 1), size(f, 1), 1, matrix, f)
    end subroutine solve_flux

    !> Number of panels.
    pure integer function number(self)
        class(panels_t), intent(in) :: self

        number = size(self%ends) - 1
    end function number

    !> The unknown of a panel's polynomial: 1 and 2 of its ends, 3 ... bubbles; 0: none, q vanishes at the edge.
    pure integer function place(self, panel, polynomial)
        class(panels_t), intent(in) :: self
        integer, intent(in) :: panel, polynomial

        if (polynomial <= 2) then
            place = panel + polynomial - 2 + self%first
        else
            place = self%number()*(polynomial - 2) + self%first + panel
        end if
    end function place

    !> Unknowns of polynomials up to a degree.
    pure integer function size_with(self, highest)
        class(panels_t), intent(in) :: self
        integer, intent(in) :: highest

        size_with = self%number()*highest + self%first
    end function size_with

    !> Where panels end: at kinks of the pressure, and closer and closer to those of the indenter, to the edge, and to an axis at
    !> which the pressure is not known to be smooth.
    subroutine place_ends(self, equilibrium, a, error)
        type(panels_t), intent(inout) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: sharp(:), kinks(:), bounds(:)
        logical, allocatable :: near(:)
        integer :: i, n

        call equilibrium%profile%add_breaks(sharp, error)
        call equilibrium%add_breaks(kinks, error)
        if (allocated(error)) return
        kinks = pack(kinks, kinks > shortest_inside*a .and. kinks < (1.0_wp - shortest)*a)
        ! ascending, as s are then the other way round
        n = size(kinks)
        bounds = [0.0_wp, [(sqrt((1.0_wp - kinks(i)/a)*(1.0_wp + kinks(i)/a)), i=n, 1, -1)], 1.0_wp]
        near = [.true., [(n <= most_kinks .or. any(abs(sharp - kinks(i)) <= shortest*a), i=n, 1, -1)], &
                .not. (is_smooth(equilibrium%profile) .and. equilibrium%medium%is_exact)]
        self%ends = bounds(:1)
        do i = 1, n + 1
            if (bounds(i + 1) > bounds(i)*(1.0_wp + shortest)) then
                call add_ends(self%ends, bounds(i), bounds(i + 1), near(i), near(i + 1))
            end if
        end do
        self%ends(size(self%ends)) = 1.0_wp
        call split_long(self%ends)
    end subroutine place_ends

    !> Halves panels until none is longer than `longest`.
    pure subroutine split_long(ends)
        real(wp), allocatable, intent(inout) :: ends(:)
        integer :: i

        i = 1
        do while (i < size(ends))
            if (ends(i + 1) - ends(i) > longest) then
                ends = [ends(:i), 0.5_wp*(ends(i) + ends(i + 1)), ends(i + 1:)]
            else
                i = i + 1
            end if
        end do
    end subroutine split_long

    !> Ends between two of them, closer and closer to one of these or to both.
    pure subroutine add_ends(ends, left, right, to_left, to_right)
        real(wp), allocatable, intent(inout) :: ends(:)
        real(wp), intent(in) :: left, right
        logical, intent(in) :: to_left, to_right
        real(wp), allocatable :: up(:), down(:)
        real(wp) :: length, least, last

        length = right - left
        if (to_left .and. to_right) length = 0.5_wp*length
        least = merge(shortest, shortest_inside, left <= 0.0_wp)
        last = merge(shortest_axis, shortest_inside, right >= 1.0_wp)
        allocate (up(0), down(0))
        if (to_left) then
            up = [left + length]
            do while (up(1) - left > least)
                up = [left + growth*(up(1) - left), up]
            end do
        end if
        if (to_right) then
            down = [right - length]
            do while (right - down(size(down)) > last)
                down = [down, right - growth*(right - down(size(down)))]
            end do
            if (to_left) down = down(2:)
        end if
        if (to_left .and. .not. to_right) up = up(:size(up) - 1)
        if (to_right .and. .not. to_left) down = down(2:)
        ends = [ends, up, down, right]
    end subroutine add_ends

    !> Nodes t and weights of int dt: j has a root behind the lower end of each panel.
    subroutine place_nodes(self, t, weight, error)
        type(panels_t), intent(in) :: self
        real(wp), intent(out) :: t(:), weight(:)
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        integer :: i

        t = 0.0_wp
        weight = 0.0_wp
        call new_rule(rule, nodes, error)
        if (allocated(error)) return
        do i = 1, self%number()
            associate (left => self%ends(i), length => self%ends(i + 1) - self%ends(i), first => (i - 1)*nodes + 1, &
                       last => i*nodes)
                t(first:last) = left + length*(0.5_wp*rule%distance)**2
                weight(first:last) = 0.5_wp*length*rule%distance*rule%weights
            end associate
        end do
    end subroutine place_nodes

    !> R_c/scale at the nodes; q may differ from 0 at the edge where p is infinite there.
    subroutine resistances(self, load, law, t, values, error)
        type(panels_t), intent(inout) :: self
        type(contact_load_t), intent(in) :: load
        class(rough_law_t), intent(in) :: law
        real(wp), intent(in) :: t(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: pressure(size(t) + 2), taken(size(t) + 2), power

        values = 0.0_wp
        taken = max([from_edge, 2.0_wp*from_edge, t], from_edge)
        call load%pressure(load%state%radius*sqrt((1.0_wp - taken)*(1.0_wp + taken)), pressure, error)
        if (allocated(error)) return
        if (.not. all(pressure > 0.0_wp)) then
            call raise(error, error_domain, "the pressure of this contact is not greater than 0 everywhere: a conductance "// &
                       "that depends on it is not defined")
            return
        end if
        power = log(pressure(2)/pressure(1))/log(2.0_wp)
        if (power < singular) self%first = 1
        where (t < from_edge) pressure(3:) = pressure(3:)*(t/from_edge)**power
        call law%check(maxval(pressure(3:)), error)
        if (.not. allocated(error)) values = 1.0_wp/law%conductance(pressure(3:))
    end subroutine resistances

    !> A of the bodies, and f.
    subroutine fill_springs(self, conduction, a, matrix, f, error)
        type(panels_t), intent(in) :: self
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a
        real(wp), intent(out) :: matrix(:, :), f(:)
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp), allocatable :: whole(:, :), spectrum(:, :), values(:, :), angle(:), dx(:), row(:)
        real(wp) :: from, to
        integer :: at, beside, i, j, k, m

        matrix = 0.0_wp
        f = 0.0_wp
        m = 30 + ceiling(1.5_wp*first_unknowns(conduction%kernel, tolerance, a/conduction%kernel%unit, .false., .true.))
        call interaction_matrix(conduction%kernel, a, m, 4*m + 4, whole, error)
        if (.not. allocated(error)) call new_rule(rule, m + 2*nodes, error)
        if (allocated(error)) return
        allocate (spectrum(m, size(f)), source=0.0_wp)
        allocate (row(m))
        do k = 1, self%number()
            from = asin(self%ends(k))
            to = asin(self%ends(k + 1))
            angle = from + 0.5_wp*(to - from)*rule%distance
            dx = 0.5_wp*(to - from)*rule%weights*sin(angle)
            values = polynomials(self%ends(k:k + 1), sin(angle))
            do i = 1, degree + 1
                at = self%place(k, i)
                if (at == 0) cycle
                row = 0.0_wp
                call add_projections(size(angle), cos(angle), 2.0_wp*dx*values(:, i), row)
                spectrum(:, at) = spectrum(:, at) + row*normalisation(m)
                f(at) = f(at) + a**2/pi*sum(dx*values(:, i))
                do j = 1, degree + 1
                    beside = self%place(k, j)
                    if (beside > 0) matrix(beside, at) = matrix(beside, at) + 2.0_wp*sum(dx*values(:, i)*values(:, j))
                end do
            end do
        end do
        if (.not. conduction%kernel%vanishes) matrix = matrix + matmul(transpose(spectrum), matmul(whole, spectrum))
        matrix = a**3/(4.0_wp*pi*conduction%scale)*matrix
    end subroutine fill_springs

    !> (place, polynomial): of the ends, and of degrees 2, ...
    pure function polynomials(ends, s) result(values)
        real(wp), intent(in) :: ends(2), s(:)
        real(wp) :: values(size(s), degree + 1)
        real(wp) :: u(size(s)), p(size(s), degree + 1)
        integer :: i

        u = ((s - ends(1)) - (ends(2) - s))/(ends(2) - ends(1))
        p = legendre(degree + 1, u)
        values(:, 1) = 0.5_wp*(1.0_wp - u)
        values(:, 2) = 0.5_wp*(1.0_wp + u)
        do i = 2, degree
            values(:, i + 1) = p(:, i + 1) - p(:, i - 1)
        end do
    end function polynomials

    !> Their slopes.
    pure function slopes(ends, s) result(values)
        real(wp), intent(in) :: ends(2), s(:)
        real(wp) :: values(size(s), degree + 1)
        real(wp) :: p(size(s), degree)
        integer :: i

        p = legendre(degree, ((s - ends(1)) - (ends(2) - s))/(ends(2) - ends(1)))
        values(:, 1) = -0.5_wp
        values(:, 2) = 0.5_wp
        do i = 2, degree
            values(:, i + 1) = (2*i - 1)*p(:, i)
        end do
        values = 2.0_wp/(ends(2) - ends(1))*values
    end function slopes

    !> Adds int R_c j_m j_n r dr.
    subroutine add_resistance(self, t, weight, matrix, error)
        type(panels_t), intent(in) :: self
        !> nodes, and weights with a^2 R_c t
        real(wp), intent(in) :: t(:), weight(:)
        real(wp), intent(inout) :: matrix(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: flux(:, :), scaled(:, :)
        integer :: i

        allocate (flux(self%size_with(degree), size(t)), source=0.0_wp)
        call fill_flux(self, t, flux, error)
        if (allocated(error)) return
        scaled = flux
        do i = 1, size(t)
            scaled(:, i) = weight(i)*flux(:, i)
        end do
        call add_product("N", "T", size(flux, 1), size(flux, 1), size(t), 1.0_wp, scaled, size(flux, 1), flux, size(flux, 1), &
                         1.0_wp, matrix, size(flux, 1))
    end subroutine add_resistance

    !> j of each polynomial at each node.
    subroutine fill_flux(self, t, flux, error)
        type(panels_t), intent(in) :: self
        real(wp), intent(in) :: t(:)
        !> 0 at first
        real(wp), intent(inout) :: flux(:, :)
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp) :: of_panel(degree + 1), from, to
        real(wp), allocatable :: values(:, :)
        integer :: i, at, k, l

        call new_rule(rule, nodes_of_flux, error)
        if (allocated(error)) return
        do i = 1, size(t)
            if (self%first == 1) flux(1, i) = 1.0_wp/(pi*t(i))
            do k = 1, self%number()
                if (self%ends(k) >= t(i)) exit
                from = asin(self%ends(k)/t(i))
                to = half_pi
                if (self%ends(k + 1) < t(i)) to = asin(self%ends(k + 1)/t(i))
                values = slopes(self%ends(k:k + 1), t(i)*sin(from + 0.5_wp*(to - from)*rule%distance))
                of_panel = 0.5_wp*(to - from)/pi*matmul(rule%weights, values)
                do l = 1, degree + 1
                    at = self%place(k, l)
                    if (at > 0) flux(at, i) = flux(at, i) + of_panel(l)
                end do
            end do
        end do
    end subroutine fill_flux

end module mdrcontact_conduction_rough_panels
