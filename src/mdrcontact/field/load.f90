! SPDX-License-Identifier: GPL-3.0-or-later
!> The load on a surface as stresses inside need it: an axisymmetric pressure given by its line load q(x), 0 <= x <= a.
!>
!> p(r) follows from q by equation (6).
module mdrcontact_field_load
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: load_t, panel_t

    !> Nodes of a panel of positions.
    integer, parameter :: nodes = 16
    !> Length of the panel beside the axis at most, where q' may be a broken power or vary as thin layers do [a].
    real(wp), parameter :: first_beside_axis = 2.0_wp**(-14)
    !> How much of its angle times its degree a polynomial may go through in a panel.
    real(wp), parameter :: longest_turn = 5.0_wp
    !> A panel is not made shorter than this [a].
    real(wp), parameter :: shortest_panel = 1.0e-12_wp

    !> The positions start + low to start + low + length, with start the axis or the last kink.
    type :: panel_t
        real(wp) :: start = 0.0_wp, low = 0.0_wp, length = 0.0_wp
        !> q' goes with the root of the distance from start
        logical :: beside_kink = .false.
    contains
        procedure :: place_nodes
    end type panel_t

    !> A line load. Extensions hold its parameters; it never changes once made.
    type, abstract :: load_t
        !> a > 0 [length]
        real(wp) :: radius = 0.0_wp
        !> q(a) [modulus length]: 0 without adhesion, negative at an adhesive edge, positive under a flat punch
        real(wp) :: edge = 0.0_wp
        !> positions in [0, a) where q is not analytic to the right, ascending; q' may be infinite there as (x - b)^(-1/2)
        real(wp), allocatable :: kinks(:)
        !> position beyond a where q is singular [length]; huge() if nowhere
        real(wp) :: singular_end = huge(1.0_wp)
        !> how far from +-a in the complex plane q is analytic [length]
        real(wp) :: analytic = huge(1.0_wp)
        !> degree of the polynomial of x/a that is a part of q
        integer :: degree = 0
    contains
        !> q' [modulus] at distances beyond a position: all digits beside a kink, and +-infinity where it is infinite there
        procedure(slope_beyond), deferred :: slope
        procedure :: square_integral
        !> panels for integrals over the contact
        procedure :: panels
        !> makes the axis a kink where q' behaves as a broken power there; for constructors
        procedure :: mark_axis
        !> e of q' ~ x^e beside the axis
        procedure :: order_on_axis
    end type load_t

    abstract interface
        pure function slope_beyond(self, start, distance) result(y)
            import :: load_t, wp
            class(load_t), intent(in) :: self
            !> 0 <= start <= start + distance <= a [length]
            real(wp), intent(in) :: start, distance(:)
            real(wp) :: y(size(distance))
        end function slope_beyond
    end interface

contains

    !> int_0^a q^2 dx [modulus^2 length^3], with q(x) = q(a) - int_x^a q' dx.
    function square_integral(self, error) result(total)
        class(load_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: total
        type(panel_t), allocatable :: list(:)
        real(wp) :: node(nodes), w(nodes), distance(nodes), dx(nodes), inner(nodes), q(nodes), before
        integer :: i, j

        total = 0.0_wp
        call gauss_legendre(node, w, error)
        call self%panels(self%radius, list, error)
        if (allocated(error)) return
        before = self%edge
        ! panel by panel from the edge inwards; in a panel q' dx is as smooth in the rule's variable as its nodes say
        do i = size(list), 1, -1
            call list(i)%place_nodes(node, w, distance, dx)
            inner = dx*self%slope(list(i)%start, distance)/w
            do j = 1, nodes
                q(j) = before - integral_beyond(node, w, inner, node(j))
            end do
            before = before - sum(w*inner)
            total = total + sum(dx*q**2)
        end do
    end function square_integral

    !> Integral over [from, 1] of the polynomial through values at the Gauss nodes.
    pure function integral_beyond(node, weight, values, from) result(total)
        real(wp), intent(in) :: node(:), weight(:), values(:), from
        real(wp) :: total
        real(wp) :: t, factor
        integer :: i, j, l

        total = 0.0_wp
        do i = 1, size(node)
            t = from + (1.0_wp - from)*node(i)
            do j = 1, size(node)
                factor = values(j)
                do l = 1, size(node)
                    if (l /= j) factor = factor*(t - node(l))/(node(j) - node(l))
                end do
                total = total + (1.0_wp - from)*weight(i)*factor
            end do
        end do
    end function integral_beyond

    !> Panels for integrals over [0, a] with q', ascending: each at most as long as its distance from the axis or kink before it and
    !> from a singular place beyond a. A polynomial of degree 15 follows q' in them to 1e-14, in s of x = b + s^2 beside a kink b.
    subroutine panels(self, first, list, error)
        class(load_t), intent(in) :: self
        !> the longest panel beside the axis or a kink [length]
        real(wp), intent(in) :: first
        type(panel_t), allocatable, intent(out) :: list(:)
        type(error_t), allocatable, intent(inout) :: error
        type(panel_t) :: panel
        integer :: kink, n, pass, stat
        real(wp) :: width

        do pass = 1, 2
            n = 0
            do kink = 0, size(self%kinks)
                panel = panel_t()
                if (kink > 0) panel%start = self%kinks(kink)
                panel%beside_kink = kink > 0
                width = self%radius - panel%start
                if (kink < size(self%kinks)) width = self%kinks(kink + 1) - panel%start
                ! distances from start: a sum with it may be rounded below the end for good
                do while (panel%low < width)
                    panel%length = min(longest_panel(self, panel, first), width - panel%low)
                    n = n + 1
                    if (pass == 2) list(n) = panel
                    panel%low = panel%low + panel%length
                    panel%beside_kink = .false.
                end do
            end do
            if (pass == 2) return
            allocate (list(n), stat=stat)
            call check_memory(error, stat)
            if (stat /= 0) return
        end do
    end subroutine panels

    !> How long a panel may be that begins at panel%low.
    pure function longest_panel(self, panel, first) result(length)
        class(load_t), intent(in) :: self
        type(panel_t), intent(in) :: panel
        real(wp), intent(in) :: first
        real(wp) :: length
        real(wp) :: here, turn

        here = panel%start + panel%low
        length = panel%low
        if (.not. panel%low > 0.0_wp) then
            length = first
            if (.not. panel%start > 0.0_wp) length = min(length, first_beside_axis*self%radius)
        end if
        length = min(length, 0.5_wp*(self%singular_end - here))
        if (self%degree > 0) then
            ! a polynomial of x/a turns in steps of 1/degree of the angle whose cosine is x/a
            turn = (longest_turn/real(self%degree, wp))**2
            here = (self%radius - here)/self%radius
            length = min(length, max(0.5_wp*self%analytic, &
                                     self%radius*2.0_wp*turn*here/(turn + sqrt(turn*(turn + 2.0_wp*here)))))
        end if
        length = max(length, shortest_panel*self%radius)
    end function longest_panel

    !> Positions beyond panel%start, and weights, of a Gauss rule for [0, 1] in a panel.
    pure subroutine place_nodes(self, node, weight, distance, dx)
        class(panel_t), intent(in) :: self
        real(wp), intent(in) :: node(:), weight(:)
        !> same size as node [length]
        real(wp), intent(out) :: distance(:), dx(:)

        if (self%beside_kink) then
            distance = self%low + self%length*node**2
            dx = 2.0_wp*self%length*node*weight
        else
            distance = self%low + self%length*node
            dx = self%length*weight
        end if
    end subroutine place_nodes

    !> Makes the axis a kink where q' is a broken power there; constructors call it.
    subroutine mark_axis(self)
        class(load_t), intent(inout) :: self
        real(wp) :: order

        if (size(self%kinks) > 0) then
            if (self%kinks(1) <= 0.0_wp) return
        end if
        order = self%order_on_axis()
        if (abs(order - anint(order)) > merge(1.0e-6_wp, 1.0e-4_wp, order < 0.5_wp)) self%kinks = [0.0_wp, self%kinks]
    end subroutine mark_axis

    !> e of q' ~ x^e beside the axis: 0 also where q' does not vary.
    pure function order_on_axis(self) result(order)
        class(load_t), intent(in) :: self
        real(wp) :: order
        real(wp) :: slope(2)

        slope = self%slope(0.0_wp, self%radius*[1.0e-11_wp, 4.0e-11_wp])
        order = 0.0_wp
        if (slope(1)*slope(2) > 0.0_wp) order = log(slope(2)/slope(1))/log(4.0_wp)
    end function order_on_axis

end module mdrcontact_field_load
