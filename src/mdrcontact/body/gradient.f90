! SPDX-License-Identifier: GPL-3.0-or-later
!> A layer whose elastic constants vary smoothly with depth, as a power series in k of its transfer matrix.
!>
!> The state y = (u, w, tau/(2 G k), sigma/(2 G k)), G that of the surface, obeys dy/dz = k A(z) y, so that the matrix from
!> the bottom of the layer to its top is a power series in k whose terms are repeated integrals of A over z. They are taken
!> with spectral accuracy: no staircase.
module mdrcontact_body_gradient
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: order, gradient_series, multiply_series, series_value, new_antiderivative

    !> Order of the series: exact to rounding for k times thickness up to 1/2.
    integer, parameter :: order = 20

contains

    !> Gauss-Legendre nodes on [0, 1], and the matrix that takes values there to integrals from 0 to each node (rows 1 to n)
    !> and to 1 (row n + 1).
    subroutine new_antiderivative(nodes, matrix, error)
        real(wp), intent(out) :: nodes(:)
        !> (n + 1, n)
        real(wp), intent(out) :: matrix(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), dimension(size(nodes) + 1) :: ends, u, before, here, next
        real(wp) :: weights(size(nodes))
        integer :: j

        call gauss_legendre(nodes, weights, error)
        ends = [nodes, 1.0_wp]
        u = 2.0_wp*ends - 1.0_wp
        before = 1.0_wp
        here = u
        matrix = spread(ends, 2, size(nodes))*spread(weights, 1, size(ends))
        do j = 1, size(nodes) - 1
            ! (2 j + 1) int_0^t P_j(2 s - 1) ds = (P_(j+1) - P_(j-1))/2, times what takes values to the coefficient of P_j
            next = (real(2*j + 1, wp)*u*here - real(j, wp)*before)/real(j + 1, wp)
            matrix = matrix + spread(0.5_wp*(next - before), 2, size(nodes))*spread(weights*here(:size(nodes)), 1, size(ends))
            before = here
            here = next
        end do
    end subroutine new_antiderivative

    !> The series (4, 4, 0:order) of the transfer matrix from the bottom to the top of a layer.
    subroutine gradient_series(antiderivative, thickness, shear, poisson, series)
        real(wp), intent(in) :: antiderivative(:, :)
        real(wp), intent(in) :: thickness
        !> G relative to the surface, and nu, at the nodes
        real(wp), intent(in) :: shear(:), poisson(:)
        real(wp), intent(out) :: series(4, 4, 0:order)
        real(wp) :: rate(4, 4, size(shear)), term(4, 4, size(shear)), product(16, size(shear)), integral(16, size(shear) + 1)
        integer :: i, n

        do i = 1, size(shear)
            rate(:, :, i) = rate_at(shear(i), poisson(i))
        end do
        term = 0.0_wp
        series = 0.0_wp
        do i = 1, 4
            term(i, i, :) = 1.0_wp
            series(i, i, 0) = 1.0_wp
        end do
        do n = 1, order
            do i = 1, size(shear)
                product(:, i) = reshape(matmul(term(:, :, i), rate(:, :, i)), [16])
            end do
            integral = -thickness*matmul(product, transpose(antiderivative))
            term = reshape(integral(:, :size(shear)), shape(term))
            series(:, :, n) = reshape(integral(:, size(shear) + 1), [4, 4])
        end do
    end subroutine gradient_series

    pure function rate_at(shear, poisson) result(rate)
        real(wp), intent(in) :: shear, poisson
        real(wp) :: rate(4, 4)
        real(wp) :: ratio

        ratio = poisson/(1.0_wp - poisson)
        rate = 0.0_wp
        rate(1, 2) = 1.0_wp
        rate(1, 3) = 2.0_wp/shear
        rate(2, 1) = -ratio
        rate(2, 4) = (1.0_wp - 2.0_wp*poisson)/((1.0_wp - poisson)*shear)
        rate(3, 1) = shear/(1.0_wp - poisson)
        rate(3, 4) = ratio
        rate(4, 3) = -1.0_wp
    end function rate_at

    !> product = product times factor.
    pure subroutine multiply_series(product, factor)
        real(wp), intent(inout) :: product(4, 4, 0:order)
        real(wp), intent(in) :: factor(4, 4, 0:order)
        real(wp) :: result(4, 4, 0:order)
        integer :: i, n

        result = 0.0_wp
        do n = 0, order
            do i = 0, n
                result(:, :, n) = result(:, :, n) + matmul(product(:, :, i), factor(:, :, n - i))
            end do
        end do
        product = result
    end subroutine multiply_series

    !> The series at k.
    pure function series_value(series, k) result(value)
        real(wp), intent(in) :: series(4, 4, 0:order)
        complex(wp), intent(in) :: k
        complex(wp) :: value(4, 4)
        integer :: n

        value = series(:, :, order)
        do n = order - 1, 0, -1
            value = series(:, :, n) + k*value
        end do
    end function series_value

end module mdrcontact_body_gradient
