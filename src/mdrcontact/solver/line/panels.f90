! SPDX-License-Identifier: GPL-3.0-or-later
!> The springs under a kink of the indenter on a body whose constants vary with depth.
!>
!> There chi falls as 1/k only and X is a logarithm near y = 0: v = K q/E0* is one degree smoother than q, no more, and its Legendre
!> series over the contact falls slowly. On panels that shrink towards every kink and the edge it is a polynomial on each: v + K v =
!> K (d - g) at Gauss nodes. A constant in X is one in v: it is left out, and d without it follows from F, which the series gives
!> with full accuracy. That the last spring then carries what the edge does is a check of the whole.
module mdrcontact_line_panels
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_numerics_one_thread, only: solve
    use mdrcontact_numerics_quadrature, only: gauss_legendre, legendre, merge_breaks
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: panels_t, new_panels

    !> Nodes of a panel, and how a panel grows with its distance from a kink.
    integer, parameter :: nodes = 20
    real(wp), parameter :: growth = 4.0_wp
    !> The same towards the logarithm of X, in addition to polynomials of degree nodes - 1.
    real(wp), parameter :: near_growth = 3.0_wp
    !> Length of the shortest panel over the contact radius; next to a square root that starts at a kink its error is of order 3/2.
    real(wp), parameter :: shortest = 1.0e-8_wp
    !> The same for the quadrature of X.
    real(wp), parameter :: shortest_near = 1.0e-13_wp
    !> A place as close to the axis, relative to the contact radius, represents it.
    real(wp), parameter :: on_axis = 1.0e-12_wp
    !> More panels are not tried.
    integer, parameter :: most_panels = 75
    !> Errors are estimated for places that far from a kink, relative to the contact radius: closer to one, rounding of v shows more
    !> in p, as the root of the distance falls.
    real(wp), parameter :: near = 1.0e-2_wp

    !> v on the panels of a contact.
    type :: panels_t
        private
        !> ends of the panels, from 0 to the contact radius [length]
        real(wp), allocatable :: edges(:)
        !> d less the constant that v is without [length]
        real(wp), public :: level = 0.0_wp
        !> coefficients of P_0 ... in v, but for a constant, [length] and in v' [1] on each panel
        real(wp), allocatable :: v(:, :), rise(:, :)
        !> Gauss's rule on [-1, 1], and Legendre coefficients of the polynomials that are 1 at one of its nodes
        real(wp) :: u(nodes) = 0.0_wp, weights(nodes) = 0.0_wp, transform(nodes, nodes) = 0.0_wp
        !> the nodes of each panel and their weights [length], and q/E0* there [length]: (nodes, panel)
        real(wp), allocatable :: x(:, :), dx(:, :), q(:, :)
    contains
        procedure :: value
        procedure :: slope
        procedure :: smooth_pressure
        procedure :: interaction_beyond
    end type panels_t

contains

    !> v for the state of this force.
    subroutine new_panels(self, kernel, profile, a, force, edge, reached, error)
        type(panels_t), intent(out) :: self
        type(kernel_t), intent(in) :: kernel
        class(profile_t), intent(in) :: profile
        !> [length]
        real(wp), intent(in) :: a
        !> force/E0* [length^2] and q(a)/E0* [length] of that state
        real(wp), intent(in) :: force, edge
        !> estimated error of values of q and p, relative to their mean; huge where there are too many kinks
        real(wp), intent(out) :: reached
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: matrix(:, :), odd(:, :)
        integer :: n, stat

        reached = huge(reached)
        call place_edges(self%edges, profile, a, error)
        call gauss_legendre(self%u, self%weights, error)
        if (allocated(error)) return
        n = size(self%edges) - 1
        if (n > most_panels) return
        allocate (self%v(nodes, n), self%rise(nodes, n), self%q(nodes, n), self%x(nodes, n), self%dx(nodes, n), &
                  matrix(nodes*n, nodes*n), odd(nodes*n, nodes*n), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        call place_nodes(self)
        call solve_springs(self, kernel, profile, a, force, edge, n, matrix, odd, reached, error)
        if (.not. allocated(error)) call find_slopes(self, kernel, profile, a, edge, n, odd)
    end subroutine new_panels

    !> From Gauss's rule on [0, 1].
    pure subroutine place_nodes(self)
        type(panels_t), intent(inout) :: self
        real(wp) :: length
        integer :: j

        self%u = 2.0_wp*self%u - 1.0_wp
        self%weights = 2.0_wp*self%weights
        self%transform = transpose(legendre(nodes, self%u))
        do j = 1, nodes
            self%transform(j, :) = real(2*j - 1, wp)*0.5_wp*self%weights*self%transform(j, :)
        end do
        do j = 1, size(self%edges) - 1
            length = self%edges(j + 1) - self%edges(j)
            self%x(:, j) = self%edges(j) + 0.5_wp*length*(1.0_wp + self%u)
            self%dx(:, j) = 0.5_wp*length*self%weights
        end do
    end subroutine place_nodes

    !> Fills v and q.
    subroutine solve_springs(self, kernel, profile, a, force, edge, count, matrix, odd, reached, error)
        type(panels_t), intent(inout) :: self
        type(kernel_t), intent(in) :: kernel
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a, force, edge
        !> number of panels
        integer, intent(in) :: count
        !> room for 1 + K at the nodes
        real(wp), intent(out) :: matrix(nodes*count, nodes*count)
        !> K of odd functions at the nodes
        real(wp), intent(out) :: odd(nodes*count, nodes*count)
        real(wp), intent(inout) :: reached
        type(error_t), allocatable, intent(inout) :: error
        real(wp), dimension(nodes*count) :: x, dx
        real(wp), dimension(nodes*count, 2) :: known, v
        real(wp) :: even_row(nodes), odd_row(nodes), shift(1), excess, level, tail, length
        integer :: i, j, n, info

        n = nodes*count
        x = reshape(self%x, [n])
        dx = reshape(self%dx, [n])
        call kernel%evaluate([a/kernel%unit], 0.0_wp, shift)
        do j = 1, count
            call check_cancelled(error)
            if (allocated(error)) return
            do i = 1, n
                call rows(self, kernel, shift(1), j, x(i), even_row, odd_row)
                matrix(i, (j - 1)*nodes + 1:j*nodes) = even_row
                odd(i, (j - 1)*nodes + 1:j*nodes) = odd_row
            end do
        end do
        known(:, 1) = 1.0_wp
        do i = 1, n
            known(i, 2) = profile%mdr(a) - profile%mdr(x(i))
        end do
        v = matmul(matrix, known)
        do i = 1, n
            matrix(i, i) = matrix(i, i) + 1.0_wp
        end do
        call solve(matrix, v, info)
        if (info /= 0) return
        v = known - v
        excess = (0.5_wp*force - sum(dx*v(:, 2)))/sum(dx*v(:, 1))
        self%level = profile%mdr(a) + excess
        v(:, 2) = excess*v(:, 1) + v(:, 2)
        self%q = reshape(v(:, 2), [nodes, count])
        self%v = matmul(self%transform, reshape(excess + known(:, 2) - v(:, 2), [nodes, count]))

        level = sqrt(sum(dx*v(:, 2)**2)/a)
        reached = abs(excess - self%value(a) - edge)/level
        do j = 1, count
            ! of Abel's integral over the derivative of the last polynomial; a panel shorter than `near` is seen from afar, by
            ! its area
            length = self%edges(j + 1) - self%edges(j)
            tail = maxval(abs(self%v(nodes - 1:, j)))*min(length/(near*a), 1.0_wp)
            length = max(length, near*a)
            reached = max(reached, tail*real(nodes, wp)*a/(sqrt(length*max(self%edges(j + 1), near*a))*level))
        end do
    end subroutine solve_springs

    !> v' = K q' - (q(a)/(pi unit)) [X(x - a) - X(x + a)], for the slope of v itself has the rounding of v over a panel's length.
    subroutine find_slopes(self, kernel, profile, a, edge, count, odd)
        type(panels_t), intent(inout) :: self
        type(kernel_t), intent(in) :: kernel
        class(profile_t), intent(in) :: profile
        !> contact radius [length] and q(a)/E0* [length]
        real(wp), intent(in) :: a, edge
        integer, intent(in) :: count
        real(wp), intent(in) :: odd(nodes*count, nodes*count)
        real(wp) :: slope(nodes, count), near(nodes), far(nodes), ends(nodes), length
        integer :: j

        ! of the polynomials at the lower end
        ends = [((-1.0_wp)**(j - 1), j=1, nodes)]
        do j = 1, count
            length = self%edges(j + 1) - self%edges(j)
            if (length > 2.0_wp*shortest*a) then
                slope(:, j) = -profile%mdr_slope(self%x(:, j)) - matmul(derivatives(self, j), self%v(:, j))
            else
                ! next to a corner q' may be infinite as a root; from elsewhere its mean is seen
                slope(:, j) = (profile%mdr(self%edges(j)) - profile%mdr(self%edges(j + 1)) &
                               + sum(self%v(:, j)*(ends - 1.0_wp)))/length
            end if
        end do
        slope = reshape(matmul(odd, reshape(slope, [nodes*count])), [nodes, count])
        if (abs(edge) > 0.0_wp) then
            do j = 1, count
                call kernel%evaluate((a - self%x(:, j))/kernel%unit, 0.0_wp, near)
                call kernel%evaluate((a + self%x(:, j))/kernel%unit, 0.0_wp, far)
                slope(:, j) = slope(:, j) - edge/(pi*kernel%unit)*(near - far)
            end do
        end if
        self%rise = matmul(self%transform, slope)
    end subroutine find_slopes

    !> P_0', P_1', ... at the nodes of a panel, over positions [1/length].
    pure function derivatives(self, panel) result(derivative)
        type(panels_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp) :: derivative(nodes, nodes)
        real(wp) :: p(nodes, nodes)
        integer :: k

        p = legendre(nodes, self%u)
        ! P'_(k+1) = P'_(k-1) + (2 k + 1) P_k
        derivative(:, 1) = 0.0_wp
        derivative(:, 2) = 1.0_wp
        do k = 3, nodes
            derivative(:, k) = derivative(:, k - 2) + real(2*k - 3, wp)*p(:, k - 1)
        end do
        derivative = derivative*(2.0_wp/(self%edges(panel + 1) - self%edges(panel)))
    end function derivatives

    !> Contribution of a load 1 at each node of a panel, and 1 or -1 at its mirror image, to K q/E0* at z: (1/(pi unit)) int [X -
    !> shift] l(t) dt, l the polynomial that is 1 at the node.
    subroutine rows(self, kernel, shift, panel, z, even, odd)
        type(panels_t), intent(in) :: self
        type(kernel_t), intent(in) :: kernel
        real(wp), intent(in) :: shift
        integer, intent(in) :: panel
        !> [length]
        real(wp), intent(in) :: z
        real(wp), intent(out) :: even(nodes), odd(nodes)
        real(wp) :: image(nodes)

        even = one_side(self, kernel, shift, panel, z)/(pi*kernel%unit)
        image = one_side(self, kernel, shift, panel, -z)/(pi*kernel%unit)
        odd = even - image
        even = even + image
    end subroutine rows

    !> int [X(|z - t|/unit) - shift] l(t) dt over a panel.
    function one_side(self, kernel, shift, panel, z) result(weights)
        type(panels_t), intent(in) :: self
        type(kernel_t), intent(in) :: kernel
        real(wp), intent(in) :: shift
        integer, intent(in) :: panel
        real(wp), intent(in) :: z
        real(wp) :: weights(nodes)
        real(wp) :: moments(nodes), kernel_at(nodes), low, high

        low = self%edges(panel)
        high = self%edges(panel + 1)
        if (max(low - z, z - high) >= high - low) then
            call kernel%evaluate(abs(z - self%x(:, panel))/kernel%unit, shift, kernel_at)
            weights = self%dx(:, panel)*kernel_at
            return
        end if
        moments = 0.0_wp
        if (high > z) call add_side(self, kernel, shift, panel, z, 1.0_wp, max(low - z, 0.0_wp), high - z, moments)
        if (low < z) call add_side(self, kernel, shift, panel, z, -1.0_wp, max(z - high, 0.0_wp), z - low, moments)
        weights = matmul(moments, self%transform)
    end function one_side

    !> Moments of X - shift with P_0 ... over t = z + side s, low < s < high, in parts that shrink towards s = 0.
    subroutine add_side(self, kernel, shift, panel, z, side, low, high, moments)
        type(panels_t), intent(in) :: self
        type(kernel_t), intent(in) :: kernel
        real(wp), intent(in) :: shift
        integer, intent(in) :: panel
        real(wp), intent(in) :: z, side, low, high
        real(wp), intent(inout) :: moments(nodes)
        real(wp) :: s(nodes), w(nodes), kernel_at(nodes), there, here, closest

        closest = max(shortest_near*self%edges(size(self%edges)), 0.5_wp*kernel%unit)
        there = high
        do
            here = there/near_growth
            if (here <= low .or. here < closest) here = low
            s = here + 0.5_wp*(there - here)*(1.0_wp + self%u)
            w = 0.5_wp*(there - here)*self%weights
            call kernel%evaluate(s/kernel%unit, shift, kernel_at)
            moments = moments + matmul(w*kernel_at, legendre(nodes, local(self, panel, z + side*s)))
            if (here <= low) exit
            there = here
        end do
    end subroutine add_side

    !> (K q)(x)/E0* beyond the contact [length].
    subroutine interaction_beyond(self, kernel, n, distances, values, error)
        class(panels_t), intent(in) :: self
        type(kernel_t), intent(in) :: kernel
        integer, intent(in) :: n
        !> x - a >= 0 [length]
        real(wp), intent(in) :: distances(n)
        real(wp), intent(out) :: values(n)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), dimension(nodes) :: even, odd
        integer :: i, j, last

        last = size(self%edges) - 1
        values = 0.0_wp
        do i = 1, n
            call check_cancelled(error)
            if (allocated(error)) return
            do j = 1, last
                call rows(self, kernel, 0.0_wp, j, self%edges(last + 1) + distances(i), even, odd)
                values(i) = values(i) + dot_product(even, self%q(:, j))
            end do
        end do
    end subroutine interaction_beyond

    !> Ends of panels that grow from both sides of every kink, and from the edge; and from the axis where g may have one.
    subroutine place_edges(edges, profile, a, error)
        real(wp), allocatable, intent(out) :: edges(:)
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: kinks(:), all(:)
        real(wp) :: half
        integer :: i

        call profile%add_breaks(kinks, error)
        call merge_breaks(edges, [0.0_wp], error)
        if (allocated(error)) return
        kinks = [0.0_wp, kinks(:count(kinks > 0.0_wp .and. kinks < a)), a]
        do i = 2, size(kinks)
            half = 0.5_wp*(kinks(i) - kinks(i - 1))
            if (i == 2 .and. profile%end_radius > 0.0_wp) then
                edges = [edges, half]
            else
                edges = [edges, kinks(i - 1) + distances(half)]
            end if
            half = kinks(i) - edges(size(edges))
            all = distances(half)
            edges = [edges, kinks(i) - all(size(all) - 1:1:-1), kinks(i)]
        end do

    contains

        !> Distances from a kink, ascending, up to the length.
        pure function distances(length) result(steps)
            real(wp), intent(in) :: length
            real(wp), allocatable :: steps(:)
            integer :: k, n

            n = max(ceiling(log(length/(shortest*a))/log(growth)), 0)
            steps = [(length*growth**(-k), k=n, 0, -1)]
        end function distances

    end subroutine place_edges

    !> Coordinates on a panel, -1 to 1.
    elemental function local(self, panel, x) result(u)
        type(panels_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: x
        real(wp) :: u

        u = 2.0_wp*(x - self%edges(panel))/(self%edges(panel + 1) - self%edges(panel)) - 1.0_wp
        u = max(min(u, 1.0_wp), -1.0_wp)
    end function local

    !> v(x) [length].
    pure function value(self, x) result(v)
        class(panels_t), intent(in) :: self
        !> 0 <= x <= a [length]
        real(wp), intent(in) :: x
        real(wp) :: v
        integer :: panel

        panel = max(min(count(self%edges <= x), size(self%edges) - 1), 1)
        v = sum(reshape(legendre(nodes, [local(self, panel, x)]), [nodes])*self%v(:, panel))
    end function value

    !> v'(x) [1].
    pure function slope(self, x)
        class(panels_t), intent(in) :: self
        !> 0 <= x <= a [length]
        real(wp), intent(in) :: x
        real(wp) :: slope
        integer :: panel

        panel = max(min(count(self%edges <= x), size(self%edges) - 1), 1)
        slope = dot_product(reshape(legendre(nodes, [local(self, panel, x)]), [nodes]), self%rise(:, panel))
    end function slope

    !> (1/pi) int_r^a v'(x)/sqrt(x^2 - r^2) dx.
    pure function smooth_pressure(self, r) result(pressure)
        class(panels_t), intent(in) :: self
        !> 0 <= r <= a [length]
        real(wp), intent(in) :: r
        real(wp) :: pressure
        real(wp) :: from, low, high, x(nodes), slope(nodes), t(2)
        integer :: panel, part, parts

        pressure = 0.0_wp
        ! x = r cosh(t) = r + 2 r sinh(t/2)^2
        from = max(r, on_axis*self%edges(size(self%edges)))
        do panel = max(count(self%edges <= from), 1), size(self%edges) - 1
            low = angle(max(self%edges(panel), from))
            high = angle(self%edges(panel + 1))
            parts = max(ceiling(high - low), 1)
            do part = 1, parts
                t = low + (high - low)*real([part - 1, part], wp)/real(parts, wp)
                x = t(1) + 0.5_wp*(t(2) - t(1))*(1.0_wp + self%u)
                slope = matmul(legendre(nodes, local(self, panel, from + 2.0_wp*from*sinh(0.5_wp*x)**2)), self%rise(:, panel))
                pressure = pressure + 0.5_wp*(t(2) - t(1))*sum(self%weights*slope)
            end do
        end do
        pressure = pressure/pi

    contains

        pure function angle(x) result(t)
            real(wp), intent(in) :: x
            real(wp) :: t

            t = 2.0_wp*asinh(sqrt(0.5_wp*(x - from)/from))
        end function angle

    end function smooth_pressure

end module mdrcontact_line_panels
