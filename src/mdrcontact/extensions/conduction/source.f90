! SPDX-License-Identifier: GPL-3.0-or-later
!> The heat that friction makes in a contact, as a line load: mu v q(x) of a contact that slides, and of one that spins the
!> line load of mu omega r p(r), under Hertz's pressure those of theory/conduction.md (10.1), (10.4), else (10.9). As a Legendre
!> series: the medium's own where it has one, else by sampling.
module mdrcontact_conduction_source
    use mdrcontact_codes, only: sliding => heat_sliding, spinning => heat_spinning
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_load, only: check_state, contact_load_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_code, check_not_negative, error_invalid, error_t, raise
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_line_legendre, only: normalisation
    use mdrcontact_line_moments, only: is_smooth
    use mdrcontact_line_rule, only: new_rule, rule_t
    use mdrcontact_line_series, only: add_projections
    use mdrcontact_medium_solver, only: solved_t
    use mdrcontact_numerics_elliptic, only: complete_b
    use mdrcontact_numerics_quadrature, only: gauss_legendre, graded_edges, mark_breaks, new_antiderivative
    implicit none (type, external)
    private
    public :: source_t, new_source, centre_and_arc, has_line_force, sliding, spinning

    !> Nodes of a panel, and the phase 2 n theta of the last of n polynomials that a panel follows to machine precision.
    integer, parameter :: panel_nodes = 20
    real(wp), parameter :: longest_phase = 14.0_wp
    !> Panels shrink towards the axis down to this part of the first break, and towards the edge down to this part of a.
    real(wp), parameter :: nearest_axis = 0.25_wp**23, nearest_edge = 1.0e-5_wp
    !> Limit of the last coefficients of a series, relative to their mean square.
    real(wp), parameter :: negligible = 1.0e-5_wp

    !> A line load of heat, and what is made of it alone.
    type :: source_t
        !> a [length], and the heat Q [conductance potential]
        real(wp) :: radius = 0.0_wp, total = 0.0_wp
        !> coefficients of s_j P_2j(x/a), s_j = sqrt((4j + 1)/2); further ones of smooth loads are negligible
        real(wp), allocatable :: t(:)
        !> q(0), int_0^a q^2 dx, int_0^a q sqrt(a^2 - x^2) dx/a
        real(wp) :: centre = 0.0_wp, square = 0.0_wp, arc = 0.0_wp
    contains
        procedure :: series
    end type source_t

    !> Nodes for a line load that has no series, ascending: sin theta, the weights of int_0^a dx, cos theta.
    type :: places_t
        real(wp), allocatable :: u(:), dx(:), cosine(:)
    end type places_t

contains

    !> The heat of a state.
    subroutine new_source(self, contact, state, motion, strength, terms, at_points, error)
        type(source_t), intent(out) :: self
        type(contact_t), intent(in), target :: contact
        !> of that contact, a > 0
        type(contact_state_t), intent(in) :: state
        !> sliding or spinning
        integer, intent(in) :: motion
        !> mu v [flux/force], or mu omega [flux/(force length)], >= 0
        real(wp), intent(in) :: strength
        !> of the series, where the medium has none
        integer, intent(in) :: terms
        !> for values at points too, not for integrals and the centre alone
        logical, intent(in) :: at_points
        type(error_t), allocatable, intent(inout) :: error
        type(solved_t) :: solved
        real(wp), allocatable :: parts(:, :)

        call check_code(error, "motion", motion, [sliding, spinning])
        call check_not_negative(error, "strength", strength)
        call check_rubbing(contact, state, error)
        if (allocated(error)) return
        self%radius = state%radius
        if (motion == sliding .and. .not. at_points) then
            call contact%equilibrium%medium%solve(contact%equilibrium%profile, state%radius, solved, error, &
                                                  abs(state%punch_depth) > 0.0_wp, series=parts)
            if (allocated(error)) return
            if (allocated(parts)) self%t = parts(:, 2) + state%punch_depth*parts(:, 1)
        end if
        if (has_ended(self%t)) then
            call take_series(self, strength)
        else
            call sample(self, contact, state, motion, strength, terms, error)
        end if
    end subroutine new_source

    !> Raises unless the pressure of a state makes heat everywhere, and a temperature that is finite.
    subroutine check_rubbing(contact, state, error)
        type(contact_t), intent(in), target :: contact
        type(contact_state_t), intent(in) :: state
        type(error_t), allocatable, intent(inout) :: error
        type(contact_load_t) :: load

        if (allocated(error)) return
        if (.not. state%radius > 0.0_wp) then
            call raise(error, error_invalid, "state: its radius is 0. Frictional heat needs a contact")
        else if (contact%is_adhesive()) then
            call raise(error, error_invalid, "frictional heat: it is not available with adhesion, because Coulomb's law is "// &
                       "not defined under tension. Set work_of_adhesion = 0")
        else if (has_line_force(contact%equilibrium, state)) then
            call raise(error, error_invalid, "frictional heat: it is not available with a line force at the edge, as under a "// &
                       "plate or a flat end on a surface with tension, because the temperature would be infinite. Omit the "// &
                       "plate or the tension")
        end if
        if (allocated(error)) return
        call check_state(contact%equilibrium, state, error)
        call check_not_negative(error, "punch_depth of the state", state%punch_depth)
        if (allocated(error) .or. .not. contact%equilibrium%medium%is_exact .or. contact%equilibrium%profile%is_spherical()) return
        call contact%load(state, load, error)
        if (.not. allocated(error)) call load%check_one_disc("friction", error)
    end subroutine check_rubbing

    !> Whether a state without adhesion has part of its force in a ring, at its edge.
    pure function has_line_force(equilibrium, state) result(answer)
        type(equilibrium_t), intent(in) :: equilibrium
        type(contact_state_t), intent(in) :: state
        logical :: answer

        associate (sheet => equilibrium%medium%sheet)
            answer = sheet%bending > 0.0_wp .or. (sheet%tension > 0.0_wp .and. state%punch_depth > 0.0_wp)
        end associate
    end function has_line_force

    !> Whether a series is known, and its last terms are negligible.
    pure function has_ended(t) result(answer)
        real(wp), allocatable, intent(in) :: t(:)
        logical :: answer

        answer = allocated(t)
        if (answer) answer = maxval(abs(t(size(t) - 1:))) <= negligible*norm2(t)
    end function has_ended

    !> Quantities derived from the coefficients, which are those of a strength of 1.
    pure subroutine take_series(self, strength)
        type(source_t), intent(inout) :: self
        real(wp), intent(in) :: strength
        real(wp) :: values(2)

        self%t = strength*self%t
        self%total = self%radius*sqrt(2.0_wp)*self%t(1)
        self%square = 0.5_wp*self%radius*sum(self%t**2)
        values = centre_and_arc(self%t)
        self%centre = values(1)
        self%arc = self%radius*values(2)
    end subroutine take_series

    !> For a series in s_j P_2j(u), its value at 0, and int_0^1 of it sqrt(1 - u^2) du.
    pure function centre_and_arc(t) result(values)
        real(wp), intent(in) :: t(:)
        real(wp) :: values(2)
        real(wp) :: c(size(t)), at_zero
        integer :: j

        values = 0.0_wp
        c = t*normalisation(size(t))
        at_zero = 1.0_wp
        do j = 0, size(t) - 1
            values = values + c(j + 1)*at_zero*[1.0_wp, 0.5_wp*half_pi*at_zero/((1 - 2*j)*(j + 1))]
            at_zero = -at_zero*(2*j + 1)/(2*j + 2)
        end do
    end function centre_and_arc

    !> The first n coefficients.
    pure function series(self, n) result(t)
        class(source_t), intent(in) :: self
        integer, intent(in) :: n
        real(wp) :: t(n)

        t = 0.0_wp
        t(:min(n, size(self%t))) = self%t(:min(n, size(self%t)))
    end function series

    !> By a rule in theta, x = a sin theta, that follows kinks of the indenter.
    subroutine sample(self, contact, state, motion, strength, terms, error)
        type(source_t), intent(inout) :: self
        type(contact_t), intent(in), target :: contact
        type(contact_state_t), intent(in) :: state
        integer, intent(in) :: motion
        real(wp), intent(in) :: strength
        integer, intent(in) :: terms
        type(error_t), allocatable, intent(inout) :: error
        type(contact_load_t) :: load
        type(places_t) :: places
        real(wp), allocatable :: x(:), values(:)

        allocate (places%u(0), places%dx(0), places%cosine(0))
        if (motion == sliding .and. is_smooth(contact%equilibrium%profile)) then
            call place_on_arc(places, self%radius, terms + 8, error)
        else
            ! r p(r) of a smooth p has a kink at the axis
            call place_on_panels(places, contact, self%radius, terms, error)
        end if
        if (allocated(error)) return
        x = [0.0_wp, places%u]
        allocate (values, mold=x)
        call contact%load(state, load, error)
        if (.not. allocated(error)) call load%projection(self%radius*x, values, error)
        if (motion == spinning .and. .not. allocated(error)) call spin(self%radius, x(2:), places%dx, values, error)
        if (allocated(error)) return
        values = strength*values
        self%centre = values(1)
        associate (q => values(2:), dx => places%dx)
            self%total = 2.0_wp*sum(dx*q)
            self%square = sum(dx*q**2)
            self%arc = sum(dx*q*places%cosine)
            if (allocated(self%t)) deallocate (self%t)
            allocate (self%t(terms), source=0.0_wp)
            call add_projections(size(q), places%u, 2.0_wp*dx*q/self%radius, self%t)
        end associate
        self%t = self%t*normalisation(terms)
    end subroutine sample

    !> One panel for a smooth load.
    subroutine place_on_arc(self, radius, nodes, error)
        type(places_t), intent(inout) :: self
        !> a [length]
        real(wp), intent(in) :: radius
        integer, intent(in) :: nodes
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule

        call new_rule(rule, max(nodes, 64), error)
        if (allocated(error)) return
        call fill_places(self, radius, half_pi*(0.5_wp*rule%distance), half_pi*(0.5_wp*rule%weights))
    end subroutine place_on_arc

    !> Panels that grow from the axis and from each kink, with room for a root behind it, and shrink towards the edge, where a load
    !> on a body graded by a power is one of cos theta; none is longer than the last polynomial can be followed.
    subroutine place_on_panels(self, contact, radius, terms, error)
        type(places_t), intent(inout) :: self
        type(contact_t), intent(in) :: contact
        !> a [length]
        real(wp), intent(in) :: radius
        integer, intent(in) :: terms
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: edges(:), breaks(:), theta(:), weight(:)
        real(wp) :: t(panel_nodes), w(panel_nodes), start, length
        logical, allocatable :: at_break(:)
        integer, allocatable :: pieces(:)
        integer :: i, k, n

        call contact%equilibrium%add_breaks(breaks, error)
        call gauss_legendre(t, w, error)
        if (allocated(error)) return
        breaks = asin(pack(breaks, breaks > 0.0_wp .and. breaks < radius)/radius)
        call graded_edges(nearest_axis*minval([breaks, half_pi]), half_pi, breaks, half_pi*(1.0_wp + nearest_edge), edges, error)
        if (allocated(error)) return
        edges = [0.0_wp, edges]
        call mark_breaks(edges, breaks, at_break, error)
        if (allocated(error)) return
        pieces = ceiling((edges(2:) - edges(:size(edges) - 1))*(2*terms/longest_phase))
        allocate (theta(panel_nodes*sum(pieces)), weight(panel_nodes*sum(pieces)))
        n = 0
        do i = 1, size(pieces)
            length = (edges(i + 1) - edges(i))/pieces(i)
            do k = 1, pieces(i)
                start = edges(i) + (k - 1)*length
                if (k == 1 .and. at_break(i)) then
                    theta(n + 1:n + panel_nodes) = start + length*t**2
                    weight(n + 1:n + panel_nodes) = 2.0_wp*length*t*w
                else
                    theta(n + 1:n + panel_nodes) = start + length*t
                    weight(n + 1:n + panel_nodes) = length*w
                end if
                n = n + panel_nodes
            end do
        end do
        call fill_places(self, radius, theta, weight)
    end subroutine place_on_panels

    pure subroutine fill_places(self, radius, theta, weight)
        type(places_t), intent(inout) :: self
        real(wp), intent(in) :: radius, theta(:), weight(:)

        self%u = sin(theta)
        self%cosine = cos(theta)
        self%dx = radius*self%cosine*weight
    end subroutine fill_places

    !> From the line load q of p to that of r p, int r p dy = x q + (2/pi) int_x^a q(t) B(x/t) dt: theory/conduction.md (10.9). B is
    !> analytic at t = x, so that all values in the panel of x give the integral over its part beyond x.
    subroutine spin(a, u, dx, values, error)
        !> [length]
        real(wp), intent(in) :: a
        !> of place_on_panels
        real(wp), intent(in) :: u(:), dx(:)
        !> q(0) and those at the nodes, then those of r p
        real(wp), intent(inout) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: node(panel_nodes), to_node(panel_nodes + 1, panel_nodes), q(size(values) - 1), &
                    part(size(values) - 1)
        integer :: i, own, first

        call new_antiderivative(node, to_node, error)
        if (allocated(error)) return
        do i = 1, panel_nodes
            to_node(i, :) = 1.0_wp - to_node(i, :)/to_node(panel_nodes + 1, :)
        end do
        q = values(2:)
        values(1) = sum(dx*q)/half_pi
        do i = 1, size(q)
            own = modulo(i - 1, panel_nodes) + 1
            first = i - own + 1
            part(first:) = dx(first:)*q(first:)*complete_b(u(i)/u(first:))
            part(first:first + panel_nodes - 1) = part(first:first + panel_nodes - 1)*to_node(own, :)
            values(i + 1) = a*u(i)*q(i) + sum(part(first:))/half_pi
        end do
    end subroutine spin

end module mdrcontact_conduction_source
