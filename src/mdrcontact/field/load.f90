! SPDX-License-Identifier: GPL-3.0-or-later
!> The load on a surface as stresses inside need it: an axisymmetric pressure given by its line load q(x), 0 <= x <= a.
!>
!> p(r) follows from q by equation (6), and its Hankel transform is p_hat(k) = int_0^a p J0(kr) r dr = (1/pi) int_0^a q cos kx dx.
module mdrcontact_field_load
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lapack, only: dgemv
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: load_t

    !> How many wavenumbers share sines, that of the panels of wave_rule.
    integer, parameter :: panel = 16
    !> Positions at which q' is asked for together.
    integer, parameter :: together = 1024
    !> Nodes of a panel of positions, and the largest k times its length.
    integer, parameter :: nodes = 16
    real(wp), parameter :: longest_phase = 15.0_wp

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
    contains
        !> q' [modulus] at distances beyond a position: all digits beside a kink, and +-infinity where it is infinite there
        procedure(slope_beyond), deferred :: slope
        !> p_hat(k) [modulus length^2]
        procedure :: transform
        procedure :: square_integral
        !> positions and weights for integrals over the contact
        procedure :: rule
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

    !> p_hat(k) by parts: (1/pi) [q(a) sin(ka)/k - int_0^a q' sin(kx)/k dx].
    !>
    !> Wavenumbers in equal panels, one after the other, share the sines of their distances from the panel's first.
    subroutine transform(self, k, values, error)
        class(load_t), intent(in) :: self
        !> wavenumbers > 0, ascending [1/length]
        real(wp), intent(in) :: k(:)
        !> same size as k
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: x(:), weight(:), cosine(:, :), sine(:, :), here(:)
        real(wp) :: distance(panel)
        integer :: i, j, last, stat

        call self%rule(maxval(k), x, weight, error)
        if (allocated(error)) return
        allocate (cosine(size(x), panel), sine(size(x), panel), here(size(x)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = 1, size(x), together
            last = min(i + together - 1, size(x))
            weight(i:last) = -weight(i:last)*self%slope(0.0_wp, x(i:last))
        end do
        distance = -1.0_wp
        do i = 1, size(k), panel
            call check_cancelled(error)
            if (allocated(error)) return
            last = min(i + panel - 1, size(k))
            if (any(abs(k(i:last) - k(i) - distance(:last - i + 1)) > 8.0_wp*epsilon(1.0_wp)*k(last))) then
                distance(:last - i + 1) = k(i:last) - k(i)
                do j = 1, last - i + 1
                    cosine(:, j) = cos(distance(j)*x)
                    sine(:, j) = sin(distance(j)*x)
                end do
            end if
            here = weight*sin(k(i)*x)
            call dgemv("T", size(x), last - i + 1, 1.0_wp, cosine, size(x), here, 1, 0.0_wp, values(i:last), 1)
            here = weight*cos(k(i)*x)
            call dgemv("T", size(x), last - i + 1, 1.0_wp, sine, size(x), here, 1, 1.0_wp, values(i:last), 1)
        end do
        values = (self%edge*sin(k*self%radius) + values)/(pi*k)
    end subroutine transform

    !> int_0^a q^2 dx [modulus^2 length^3], with q(x) = q(a) - int_x^a q' dx.
    function square_integral(self, error) result(total)
        class(load_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: total
        real(wp), allocatable :: x(:), weight(:), q(:)
        real(wp) :: node(nodes), w(nodes), inner(nodes), before
        integer :: first, i, stat

        total = 0.0_wp
        call gauss_legendre(node, w, error)
        call self%rule(0.0_wp, x, weight, error)
        if (allocated(error)) return
        allocate (q(size(x)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        before = self%edge
        ! panel by panel from the edge inwards; in a panel q' dx is as smooth in the rule's variable as its nodes say
        do first = size(x) - nodes + 1, 1, -nodes
            associate (here => weight(first:first + nodes - 1), t => x(first:first + nodes - 1))
                inner = here*self%slope(0.0_wp, t)/w
                do i = 1, nodes
                    q(first + i - 1) = before - integral_beyond(node, w, inner, node(i))
                end do
                before = before - sum(w*inner)
            end associate
        end do
        total = sum(weight*q**2)
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

    !> Positions and weights for integrals over [0, a] with q and waves up to k: Gauss-Legendre panels, none longer than the
    !> shortest wave allows, and x = b + s^2 beyond a kink b.
    subroutine rule(self, k, x, weight, error)
        class(load_t), intent(in) :: self
        !> [1/length]
        real(wp), intent(in) :: k
        real(wp), allocatable, intent(out) :: x(:), weight(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: ends(:)
        real(wp) :: node(nodes), w(nodes), low, length
        integer :: i, j, from, stat
        integer, allocatable :: panels(:)
        logical :: from_zero

        call gauss_legendre(node, w, error)
        if (allocated(error)) return
        from_zero = size(self%kinks) > 0
        if (from_zero) from_zero = self%kinks(1) <= 0.0_wp
        i = size(self%kinks) + merge(1, 2, from_zero)
        allocate (ends(i), panels(i - 1), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        ends(1) = 0.0_wp
        ends(size(ends) - size(self%kinks):) = [self%kinks, self%radius]
        panels(:) = 1 + int((k/longest_phase + 1.0_wp/self%analytic)*(ends(2:) - ends(:size(ends) - 1)))
        ! s^2 spreads the last panel to twice its length
        do i = 1, size(panels)
            if (any(self%kinks == ends(i))) panels(i) = 2*panels(i)
        end do
        allocate (x(nodes*sum(panels)), weight(nodes*sum(panels)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        from = 0
        do i = 1, size(panels)
            length = ends(i + 1) - ends(i)
            do j = 1, panels(i)
                associate (t => x(from + 1:from + nodes), dt => weight(from + 1:from + nodes))
                    low = real(j - 1, wp)/real(panels(i), wp)
                    t = low + node/real(panels(i), wp)
                    dt = w*length/real(panels(i), wp)
                    if (any(self%kinks == ends(i))) then
                        dt = 2.0_wp*t*dt
                        t = t**2
                    end if
                    t = ends(i) + length*t
                end associate
                from = from + nodes
            end do
        end do
    end subroutine rule

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
