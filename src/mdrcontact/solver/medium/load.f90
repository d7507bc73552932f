! SPDX-License-Identifier: GPL-3.0-or-later
!> The load of a state: an axisymmetric pressure and its line load q(x), 0 <= x <= a, from which p(r) follows by equation (6).
!>
!> It is solved once, when it is made, and gives the fields of the state on the surface and the energies of the bodies; stresses
!> inside, wear, friction and heat read it.
module mdrcontact_medium_load
    use mdrcontact_nonfinite, only: quiet_nan
    use mdrcontact_error, only: check_memory, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre, legendre, merge_breaks, new_antiderivative
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: load_t, panel_t, lower_body, upper_body

    !> The bodies of a pair, by their place in arrays.
    integer, parameter :: lower_body = 1, upper_body = 2

    !> Nodes of a panel of positions, and of those the degree up to which a polynomial is far from needing all.
    integer, parameter :: nodes = 16, low_degree = 6
    !> Error of q' in a panel, relative to the largest q' there and to the mean of the load. A misfit below the second number, or
    !> below what rounded positions make of q', is rounding if halves of the panel do not lower it.
    real(wp), parameter :: negligible = 1.0e-13_wp, noise = 1.0e-9_wp
    !> A panel is not made shorter than this [a]; there are at most so many panels, and so many more for each kink.
    real(wp), parameter :: shortest_panel = 1.0e-12_wp
    integer, parameter :: most_panels = 1000, most_beside_kink = 50
    !> Misfit that is left then, relative to the mean of |q'| [1].
    real(wp), parameter :: refused = 1.0e-8_wp
    !> Points between the nodes where the polynomial of a panel is compared with q', and, towards an axis or kink, points each
    !> `step` times as close as the one before.
    real(wp), parameter :: between(3) = [0.0025_wp, 0.5_wp, 0.9975_wp], step = 0.25_wp
    integer, parameter :: closer = 20
    !> Distance from the edge at which q' is compared with a root [a].
    real(wp), parameter :: beside_edge = 1.0e-8_wp

    !> The positions start + low to start + low + length, with start the axis or the last kink.
    type :: panel_t
        real(wp) :: start = 0.0_wp, low = 0.0_wp, length = 0.0_wp
        !> q' goes with the root of the distance from start
        logical :: beside_kink = .false.
        !> the same before the edge of the contact
        logical :: before_edge = .false.
        !> a polynomial of a low degree follows q'
        logical :: is_easy = .false.
        !> its end, from start too: sums of lengths would drift from it
        real(wp), private :: high = 0.0_wp
        !> misfit of the polynomial, the same of the panel of which this one is a half
        real(wp), private :: misfit = huge(1.0_wp), misfit_before = huge(1.0_wp)
    contains
        procedure :: place_nodes
    end type panel_t

    !> A load. Extensions hold what it is known by, and refer to a medium and a profile that outlive it. Once made it never changes:
    !> any number of threads may share it.
    type, abstract :: load_t
        !> a [length], and depth beyond that of the non-adhesive state [length]
        real(wp) :: radius = 0.0_wp, punch_depth = 0.0_wp
        !> q(a) [modulus length]: 0 without adhesion, negative at an adhesive edge, positive under a flat punch
        real(wp) :: edge = 0.0_wp
        !> the indenter
        class(profile_t), pointer :: profile => null()
        !> part of the upper body in each displacement, unless a pair is one of displacement_of_body's own [1]
        real(wp) :: share_of_upper = 0.0_wp
        !> whether q' is known and nothing else loads the body: stresses inside and energies follow from it
        logical :: is_complete = .false.
        !> positions in [0, a) where q is not analytic to the right, ascending; q' may be infinite there as (x - b)^(-1/2); not
        !> allocated before find_kinks
        real(wp), allocatable :: kinks(:)
        !> whether q' is infinite at a as (a - x)^(-1/2): of an imprint that is filled; not known before find_kinks
        logical :: has_steep_edge = .false.
    contains
        !> q(x) [modulus length], 0 <= x <= a
        procedure(field_at), deferred :: line_load
        procedure :: projection
        !> p(r) [modulus], 0 <= r <= a, infinite at r = a where punch_depth is not 0
        procedure(field_at), deferred :: pressure
        !> u(r) of the surface [length], r > a, positive into the medium
        procedure(field_at), deferred :: displacement
        procedure :: displacement_of_body
        procedure :: energies
        procedure :: least_pressure
        procedure :: slope
        !> radii where q is not analytic
        procedure :: add_breaks
        procedure :: find_kinks
        procedure :: square_integral
        !> panels for integrals over the contact
        procedure :: panels
        !> makes the axis a kink where q' behaves as a broken power there
        procedure :: mark_axis
        !> e of q' ~ x^e next to the axis
        procedure :: order_on_axis
    end type load_t

    abstract interface
        subroutine field_at(self, r, values, error)
            import :: error_t, load_t, wp
            class(load_t), intent(in) :: self
            !> positions [length]
            real(wp), intent(in) :: r(:)
            !> same size as r
            real(wp), intent(out) :: values(:)
            type(error_t), allocatable, intent(out) :: error
        end subroutine field_at
    end interface

contains

    !> int p dy along the line x [modulus length]; here q, from which p follows by equation (6).
    subroutine projection(self, r, values, error)
        class(load_t), intent(in) :: self
        !> 0 <= x <= a [length]
        real(wp), intent(in) :: r(:)
        !> same size as r
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call self%line_load(r, values, error)
    end subroutine projection

    !> Displacement of the surface of one body; here the same share everywhere.
    subroutine displacement_of_body(self, body, r, values, error)
        class(load_t), intent(in) :: self
        !> lower_body or upper_body
        integer, intent(in) :: body
        !> positions r >= 0 [length]
        real(wp), intent(in) :: r(:)
        !> u(r) of both surfaces together, each positive into its body; then of the requested one [length]
        real(wp), intent(inout) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        associate (unused => r, also_unused => error)
        end associate
        values = merge(self%share_of_upper, 1.0_wp - self%share_of_upper, body == upper_body)*values
    end subroutine displacement_of_body

    !> Elastic energies; here they are not known.
    subroutine energies(self, values, error)
        class(load_t), intent(in) :: self
        !> (2) of the lower and the upper body [modulus length^3]; not allocated where they are not known
        real(wp), allocatable, intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        associate (unused => self, also_unused => values, unused_too => error)
        end associate
    end subroutine energies

    !> Lower bounds of p at some positions; not available here.
    pure subroutine least_pressure(self, r, values)
        class(load_t), intent(in) :: self
        !> 0 <= r < a, ascending [length]
        real(wp), intent(in) :: r(:)
        !> same size as r [modulus]
        real(wp), intent(out) :: values(:)

        associate (unused => self, also_unused => r)
        end associate
        values = -huge(1.0_wp)
    end subroutine least_pressure

    !> q' [modulus] at distances beyond a position: full accuracy next to a kink, and +-infinity where it is infinite there. Here it
    !> is not known: see is_complete.
    pure function slope(self, start, distance) result(y)
        class(load_t), intent(in) :: self
        !> 0 <= start <= start + distance <= a [length]
        real(wp), intent(in) :: start, distance(:)
        real(wp) :: y(size(distance))

        associate (unused => self, also_unused => start)
        end associate
        y = quiet_nan
    end function slope

    pure subroutine add_breaks(self, radii, error)
        class(load_t), intent(in) :: self
        !> ascending [length]; others already in it stay
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error

        call self%profile%add_breaks(radii, error)
    end subroutine add_breaks

    !> Data for integrals over q', not needed for a load that is evaluated only on the surface.
    subroutine find_kinks(self, error)
        class(load_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: breaks(:)

        call self%add_breaks(breaks, error)
        if (allocated(error)) return
        call merge_breaks(self%kinks, breaks(:count(breaks < self%radius)), error)
        if (allocated(error)) return
        call self%mark_axis()
        self%has_steep_edge = is_steep(self%slope(0.0_wp, self%radius*(1.0_wp - [4.0_wp, 1.0_wp, 0.0_wp]*beside_edge)))
    end subroutine find_kinks

    !> Whether q' at four times a distance from the edge, at the distance and at the edge is that of a root.
    pure function is_steep(slopes) result(answer)
        real(wp), intent(in) :: slopes(3)
        logical :: answer

        answer = abs(slopes(3)) > huge(1.0_wp) .and. abs(slopes(2) - 2.0_wp*slopes(1)) <= 0.01_wp*abs(slopes(2))
    end function is_steep

    !> int_0^a q^2 dx [modulus^2 length^3], with q(x) = q(a) - int_x^a q' dx.
    function square_integral(self, error) result(total)
        class(load_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: total
        type(panel_t), allocatable :: list(:)
        real(wp) :: node(nodes), w(nodes), distance(nodes), dx(nodes), integral(nodes + 1), to_node(nodes + 1, nodes), before
        integer :: i

        total = 0.0_wp
        call gauss_legendre(node, w, error)
        call new_antiderivative(node, to_node, error)
        call self%panels(self%radius, list, error)
        if (allocated(error)) return
        before = self%edge
        ! panel by panel from the edge inwards; in a panel q' dx is as smooth in the rule's variable as its nodes indicate
        do i = size(list), 1, -1
            call list(i)%place_nodes(node, w, distance, dx)
            integral = matmul(to_node, dx*self%slope(list(i)%start, distance)/w)
            total = total + sum(dx*(before - integral(nodes + 1) + integral(:nodes))**2)
            before = before - integral(nodes + 1)
        end do
    end function square_integral

    !> Panels for integrals over [0, a] with q', ascending: halved until in each a polynomial of degree 15 follows q', in s of x = b
    !> + s^2 next to a kink b, at its nodes and between them.
    subroutine panels(self, first, list, error)
        class(load_t), intent(in) :: self
        !> the longest panel next to a kink [length]
        real(wp), intent(in) :: first
        type(panel_t), allocatable, intent(out) :: list(:)
        type(error_t), allocatable, intent(inout) :: error
        type(panel_t) :: panel
        type(panel_t), allocatable :: waiting(:)
        real(wp) :: node(nodes), weight(nodes), polynomials(nodes, 0:nodes - 1), mean, missed
        integer :: kink, n, left
        logical :: fits

        call gauss_legendre(node, weight, error)
        if (allocated(error)) return
        polynomials = legendre(nodes, 2.0_wp*node - 1.0_wp)
        mean = mean_slope(self, node, weight)
        allocate (list(16), waiting(16))
        n = 0
        missed = 0.0_wp
        do kink = 0, size(self%kinks)
            left = 1
            waiting(1) = whole_segment(self, kink)
            do while (left > 0)
                panel = waiting(left)
                left = left - 1
                if (.not. panel%length > 0.0_wp) cycle
                call examine(self, panel, first, mean, node, weight, polynomials, fits)
                if (.not. fits .and. n >= most_panels + most_beside_kink*kink) then
                    missed = missed + panel%misfit*panel%length
                    fits = .true.
                end if
                if (fits) then
                    call append(list, n, panel, error)
                else
                    ! the lower half comes next
                    call append(waiting, left, upper_half(panel), error)
                    call append(waiting, left, lower_half(panel), error)
                end if
                if (allocated(error)) return
            end do
        end do
        list = list(:n)
        if (missed > refused*mean*self%radius) then
            call raise(error, error_no_convergence, "stresses and energies under this indenter have an error of about "// &
                       to_text(missed/(mean*self%radius))//": the slope of its line load is not smooth on "//to_text(real(n, &
                       wp))//" panels")
        end if
    end subroutine panels

    !> From the axis or a kink to the next one or to a.
    pure function whole_segment(self, kink) result(panel)
        class(load_t), intent(in) :: self
        integer, intent(in) :: kink
        type(panel_t) :: panel

        if (kink > 0) panel%start = self%kinks(kink)
        panel%beside_kink = kink > 0
        panel%length = self%radius - panel%start
        if (kink < size(self%kinks)) panel%length = self%kinks(kink + 1) - panel%start
        panel%before_edge = self%has_steep_edge .and. kink == size(self%kinks)
        panel%high = panel%length
    end function whole_segment

    pure function lower_half(panel) result(half)
        type(panel_t), intent(in) :: panel
        type(panel_t) :: half

        half = panel
        half%high = panel%low + 0.5_wp*panel%length
        half%length = half%high - panel%low
        half%before_edge = .false.
        half%misfit_before = panel%misfit
    end function lower_half

    pure function upper_half(panel) result(half)
        type(panel_t), intent(in) :: panel
        type(panel_t) :: half

        half = panel
        half%low = panel%low + 0.5_wp*panel%length
        half%length = panel%high - half%low
        half%beside_kink = .false.
        half%misfit_before = panel%misfit
    end function upper_half

    !> Appends to the first n of a list.
    pure subroutine append(list, n, panel, error)
        type(panel_t), allocatable, intent(inout) :: list(:)
        integer, intent(inout) :: n
        type(panel_t), intent(in) :: panel
        type(error_t), allocatable, intent(inout) :: error
        type(panel_t), allocatable :: longer(:)
        integer :: stat

        if (n == size(list)) then
            allocate (longer(2*n), stat=stat)
            call check_memory(error, stat)
            if (stat /= 0) return
            longer(:n) = list
            call move_alloc(longer, list)
        end if
        n = n + 1
        list(n) = panel
    end subroutine append

    !> Mean of |q'| over the contact.
    pure function mean_slope(self, node, weight) result(mean)
        class(load_t), intent(in) :: self
        real(wp), intent(in) :: node(nodes), weight(nodes)
        real(wp) :: mean
        type(panel_t) :: panel
        real(wp) :: distance(nodes), dx(nodes)
        integer :: kink

        mean = 0.0_wp
        do kink = 0, size(self%kinks)
            panel = whole_segment(self, kink)
            call panel%place_nodes(node, weight, distance, dx)
            if (panel%length > 0.0_wp) mean = mean + sum(dx*abs(self%slope(panel%start, distance)))
        end do
        mean = mean/self%radius
    end function mean_slope

    !> Whether q' is a polynomial in a panel; one that does not become smoother by halving is taken for it.
    pure subroutine examine(self, panel, first, mean, node, weight, polynomials, fits)
        class(load_t), intent(in) :: self
        type(panel_t), intent(inout) :: panel
        real(wp), intent(in) :: first, mean, node(nodes), weight(nodes), polynomials(nodes, 0:nodes - 1)
        logical, intent(out) :: fits
        real(wp) :: t(nodes + size(between) + closer), values(size(t)), series(0:nodes - 1), size_of, rounding
        integer :: n, i

        fits = .false.
        if ((panel%beside_kink .or. panel%before_edge) .and. panel%length > first) return
        if (panel%beside_kink .and. panel%before_edge) return
        t(:nodes) = node
        t(nodes + 1:nodes + size(between)) = between
        n = nodes + size(between)
        if (.not. panel%low > 0.0_wp) then
            t(n + 1:) = [(node(1)*step**i, i=1, closer)]
            n = size(t)
        end if
        ! q' dx/dt over the length
        if (panel%beside_kink) then
            values(:n) = 2.0_wp*t(:n)*self%slope(panel%start, panel%low + panel%length*t(:n)**2)
        else if (panel%before_edge) then
            values(:n) = 2.0_wp*(1.0_wp - t(:n))*self%slope(panel%start, panel%high - panel%length*(1.0_wp - t(:n))**2)
        else
            values(:n) = self%slope(panel%start, panel%low + panel%length*t(:n))
        end if
        do i = 0, nodes - 1
            series(i) = real(2*i + 1, wp)*sum(weight*values(:nodes)*polynomials(:, i))
        end do
        size_of = max(mean, maxval(abs(values(:n))))
        ! what rounding of the positions makes of q'
        rounding = epsilon(1.0_wp)*(panel%start + panel%low + panel%length)/panel%length &
                   *maxval(abs(values(2:nodes) - values(:nodes - 1))/(node(2:) - node(:nodes - 1)))
        associate (others => t(nodes + 1:n))
            panel%misfit = max(maxval(abs(series(nodes - 2:))), &
                               maxval(abs(values(nodes + 1:n) - matmul(legendre(nodes, 2.0_wp*others - 1.0_wp), series))))
        end associate
        panel%is_easy = maxval(abs(series(low_degree + 1:))) <= negligible*size_of
        fits = panel%misfit <= negligible*size_of .or. panel%length <= shortest_panel*self%radius
        if (panel%misfit <= max(noise*size_of, rounding)) fits = fits .or. panel%misfit > 0.5_wp*panel%misfit_before
    end subroutine examine

    !> Positions beyond panel%start, and weights, of a Gauss rule for [0, 1] in a panel.
    pure subroutine place_nodes(self, node, weight, distance, dx)
        class(panel_t), intent(in) :: self
        real(wp), intent(in) :: node(:), weight(:)
        !> same size as node [length]
        real(wp), intent(out) :: distance(:), dx(:)

        if (self%beside_kink) then
            distance = self%low + self%length*node**2
            dx = 2.0_wp*self%length*node*weight
        else if (self%before_edge) then
            distance = self%high - self%length*(1.0_wp - node)**2
            dx = 2.0_wp*self%length*(1.0_wp - node)*weight
        else
            distance = self%low + self%length*node
            dx = self%length*weight
        end if
    end subroutine place_nodes

    !> Makes the axis a kink where q' is a broken power there.
    subroutine mark_axis(self)
        class(load_t), intent(inout) :: self
        real(wp) :: order

        if (size(self%kinks) > 0) then
            if (self%kinks(1) <= 0.0_wp) return
        end if
        order = self%order_on_axis()
        if (order >= huge(1.0_wp)) return
        if (abs(order - anint(order)) > merge(1.0e-6_wp, 1.0e-4_wp, order < 0.5_wp)) self%kinks = [0.0_wp, self%kinks]
    end subroutine mark_axis

    !> e of q' ~ x^e next to the axis: 0 also where q' does not vary, huge() where it is so flat that it underflows.
    pure function order_on_axis(self) result(order)
        class(load_t), intent(in) :: self
        real(wp) :: order
        real(wp) :: slope(2)

        slope = self%slope(0.0_wp, self%radius*[1.0e-11_wp, 4.0e-11_wp])
        order = 0.0_wp
        if (maxval(abs(slope)) > 0.0_wp .and. minval(abs(slope)) <= tiny(1.0_wp)) then
            order = huge(1.0_wp)
        else if (sign(1.0_wp, slope(1))*slope(2) > 0.0_wp) then
            order = log(slope(2)/slope(1))/log(4.0_wp)
        end if
    end function order_on_axis

end module mdrcontact_medium_load
