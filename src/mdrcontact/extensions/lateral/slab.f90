! SPDX-License-Identifier: GPL-3.0-or-later
!> The weights of theory/lateral.md (2.9) between two depths: how much of them lies outside each radius. Lengths in units of the
!> contact radius.
module mdrcontact_lateral_slab
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: error_memory, error_t, raise
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lateral_density, only: lateral_density
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_weights, only: weight_i0, weight_i1, weight_j0, weight_j1
    implicit none (type, external)
    private
    public :: slab_t, in_radii, new_slab, outside, slab_distance

    !> nodes of a panel; the running integral is a polynomial of this degree there
    integer, parameter :: order = 8
    !> Panels end this close to the edge of the contact, where the weight of a slab at the surface has a logarithm.
    real(wp), parameter :: finest = 1.0e-7_wp

    !> The slab z_top < z < z_bottom. `outside` gives int W rho drho dz over all radii beyond rho: without the factor 2 pi of
    !> the angle.
    type :: slab_t
        !> whole weights of the slab over 2 pi, exactly: (shear, poisson)
        real(wp) :: whole(2) = 0.0_wp
        real(wp) :: top = 0.0_wp
        !> panels [edges(i-1), edges(i)], edges(0) = 0, and the polynomials there: (2, 0:order, panel)
        real(wp), allocatable :: edges(:), polynomials(:, :, :)
        !> beyond the last edge: the value there, falling as rho^-2 and faster; (2)
        real(wp) :: tail(2) = 0.0_wp
    end type slab_t

contains

    !> A length in contact radii, at most so many that weights, which fall as 1/z, are negligible there, and products of three of
    !> them still numbers; 0 where halves of it would not be.
    elemental function in_radii(length, a) result(ratio)
        real(wp), intent(in) :: length, a
        real(wp) :: ratio
        real(wp), parameter :: near = 1.0e-300_wp, far = 1.0e90_wp

        ratio = max(-far, min(far, length/a))
        if (abs(ratio) < near) ratio = 0.0_wp
    end function in_radii

    !> The slab between two depths 0 <= top < bottom, known up to distance `reach` from the axis.
    subroutine new_slab(self, nu, top, bottom, reach, error)
        type(slab_t), intent(out) :: self
        !> Poisson's ratio of the reference medium
        real(wp), intent(in) :: nu
        real(wp), intent(in) :: top, bottom, reach
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: x(order), w(order), running(2), samples(2, order), length, matrix(0:order, order), total(2)
        integer :: panel, i, stat

        self%top = top
        ! by the complements where these are the smaller numbers
        if (top > 1.0_wp) then
            self%whole = [weight_j0(top, nu) - weight_j0(bottom, nu), weight_j1(top) - weight_j1(bottom)]/(2.0_wp*pi)
        else
            self%whole = [weight_i0(bottom, nu) - weight_i0(top, nu), weight_i1(bottom) - weight_i1(top)]/(2.0_wp*pi)
        end if
        call panel_edges(top, max(reach, 4.0_wp), self%edges)
        allocate (self%polynomials(2, 0:order, size(self%edges) - 1), stat=stat)
        if (stat /= 0) call raise(error, error_memory, "not enough memory")
        if (allocated(error)) return
        call gauss_legendre(x, w, error)
        if (allocated(error)) return
        matrix = integration_matrix(x, w)
        running = tail_of(nu, top, bottom, self%edges(ubound(self%edges, 1)), x, w)
        self%tail = running
        do panel = ubound(self%edges, 1), 1, -1
            call check_cancelled(error)
            if (allocated(error)) return
            length = self%edges(panel) - self%edges(panel - 1)
            do i = 1, order
                samples(:, i) = length*column(nu, top, bottom, self%edges(panel - 1) + length*x(i), x, w)
            end do
            self%polynomials(:, :, panel) = matmul(samples, transpose(matrix))
            self%polynomials(:, 0, panel) = self%polynomials(:, 0, panel) + running
            running = running + matmul(samples, w)
        end do
        ! what quadrature left of the whole, put right proportionally: a homogeneous slab must count exactly once
        total = merge(self%whole/running, 1.0_wp, running > 0.0_wp)
        do i = 1, 2
            self%polynomials(i, :, :) = total(i)*self%polynomials(i, :, :)
        end do
        self%tail = total*self%tail
    end subroutine new_slab

    !> Weights (shear, poisson) beyond distance rho from the axis. `panel` is where the last call ended: neighbours are found
    !> immediately.
    pure subroutine outside(self, rho, panel, weights)
        type(slab_t), intent(in) :: self
        real(wp), intent(in) :: rho
        integer, intent(inout) :: panel
        real(wp), intent(out) :: weights(2)
        real(wp) :: t
        integer :: last, k

        last = ubound(self%edges, 1)
        if (rho >= self%edges(last)) then
            weights = self%tail*(self%edges(last)/rho)**2
            return
        end if
        panel = min(max(panel, 1), last)
        do while (rho > self%edges(panel))
            panel = panel + 1
        end do
        do while (rho < self%edges(panel - 1))
            panel = panel - 1
        end do
        t = 2.0_wp*(rho - self%edges(panel - 1))/(self%edges(panel) - self%edges(panel - 1)) - 1.0_wp
        weights = self%polynomials(:, order, panel)
        do k = order - 1, 0, -1
            weights = weights*t + self%polynomials(:, k, panel)
        end do
    end subroutine outside

    !> Distance of the ring rho = 1, z = 0, where the weights are singular, from the slab at distance rho from the axis.
    elemental function slab_distance(self, rho) result(distance)
        type(slab_t), intent(in) :: self
        real(wp), intent(in) :: rho
        real(wp) :: distance

        distance = hypot(rho - 1.0_wp, self%top)
    end function slab_distance

    !> Panels half as long as they are far from the singular ring, (0:).
    pure subroutine panel_edges(top, reach, edges)
        real(wp), intent(in) :: top, reach
        real(wp), allocatable, intent(out) :: edges(:)
        real(wp) :: found(0:400), here
        integer :: count, inner, i

        ! inwards from the ring first
        found(0) = 1.0_wp
        count = 0
        here = 1.0_wp
        do while (here > 0.0_wp)
            here = here - max(0.5_wp*hypot(1.0_wp - here, top), finest)
            if (here < 0.3_wp*hypot(1.0_wp - here, top)) here = 0.0_wp
            count = count + 1
            found(count) = here
        end do
        inner = count
        found(0:inner) = [(found(inner - i), i=0, inner)]
        here = 1.0_wp
        do while (here < reach .and. count < ubound(found, 1))
            here = here + max(0.5_wp*hypot(here - 1.0_wp, top), finest)
            count = count + 1
            found(count) = here
        end do
        allocate (edges(0:count))
        edges(0:count) = found(0:count)
    end subroutine panel_edges

    !> rho int W dz over the slab, at rho.
    pure function column(nu, top, bottom, rho, x, w) result(values)
        real(wp), intent(in) :: nu, top, bottom, rho, x(:), w(:)
        real(wp) :: values(2)
        real(wp) :: z, next, shear, poisson
        integer :: i

        values = 0.0_wp
        z = top
        do while (z < bottom)
            next = z + hypot(rho - 1.0_wp, z)
            if (next > bottom - 0.25_wp*(next - z)) next = bottom
            do i = 1, size(x)
                call lateral_density(rho, z + (next - z)*x(i), nu, shear, poisson)
                values = values + (next - z)*w(i)*rho*[shear, poisson]
            end do
            z = next
        end do
    end function column

    !> int of column from rho to infinity, in 1/rho.
    pure function tail_of(nu, top, bottom, rho, x, w) result(values)
        real(wp), intent(in) :: nu, top, bottom, rho, x(:), w(:)
        real(wp) :: values(2)
        real(wp) :: low, high
        integer :: i, part

        values = 0.0_wp
        do part = 1, 4
            low = 0.25_wp*(part - 1)
            high = 0.25_wp*part
            do i = 1, size(x)
                associate (u => low + (high - low)*x(i))
                    values = values + (high - low)*w(i)*rho/u**2*column(nu, top, bottom, rho/u, x, w)
                end associate
            end do
        end do
    end function tail_of

    !> From samples at Gauss nodes on [0, 1] to the coefficients, in t = 2 x - 1, of the integral from x to 1.
    pure function integration_matrix(x, w) result(matrix)
        real(wp), intent(in) :: x(order), w(order)
        real(wp) :: matrix(0:order, order)
        real(wp) :: legendre(0:order, 0:order), at_node(0:order), rest(0:order)
        integer :: k, i

        ! monomial coefficients (power, degree)
        legendre = 0.0_wp
        legendre(0, 0) = 1.0_wp
        legendre(1, 1) = 1.0_wp
        do k = 1, order - 1
            legendre(1:, k + 1) = (2*k + 1)*legendre(:order - 1, k)/(k + 1)
            legendre(:, k + 1) = legendre(:, k + 1) - k*legendre(:, k - 1)/(k + 1)
        end do
        do i = 1, order
            at_node = matmul([((2.0_wp*x(i) - 1.0_wp)**k, k=0, order)], legendre)
            matrix(:, i) = 0.0_wp
            do k = 0, order - 1
                ! int_t^1 P_k = (P_(k-1) - P_(k+1))/(2 k + 1)
                if (k == 0) then
                    rest = legendre(:, 0) - legendre(:, 1)
                else
                    rest = (legendre(:, k - 1) - legendre(:, k + 1))/(2*k + 1)
                end if
                ! half: dx = dt/2; 2 k + 1: norm of P_k on [0, 1]
                matrix(:, i) = matrix(:, i) + 0.5_wp*(2*k + 1)*w(i)*at_node(k)*rest
            end do
        end do
    end function integration_matrix

end module mdrcontact_lateral_slab
