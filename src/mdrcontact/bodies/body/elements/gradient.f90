! SPDX-License-Identifier: GPL-3.0-or-later
!> A layer whose elastic constants vary smoothly with depth, as a power series in k of its transfer matrix.
!>
!> The state y = (u, w, tau/(2 G k), sigma/(2 G k)), G that of the surface, obeys dy/dz = k A(z) y, so that the matrix from
!> the bottom of the layer to its top is a power series in k whose terms are repeated integrals of A over z. They are taken
!> with spectral accuracy: no staircase. Across the plane of the wave the state is (v, tau/(G k)).
module mdrcontact_body_elements_gradient
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: order, gradient_series, in_plane_rate, anti_plane_rate, multiply_series, series_value

    !> Order of the series: exact to machine precision for k times thickness up to 1/2.
    integer, parameter :: order = 20

contains

    !> The series (m, m, 0:order) of the transfer matrix from the bottom to the top of a layer.
    subroutine gradient_series(antiderivative, thickness, rate, series)
        real(wp), intent(in) :: antiderivative(:, :)
        real(wp), intent(in) :: thickness
        !> A at the nodes (m, m, nodes)
        real(wp), intent(in) :: rate(:, :, :)
        real(wp), intent(out) :: series(:, :, 0:)
        real(wp) :: term(size(rate, 1), size(rate, 1), size(rate, 3))
        real(wp) :: product(size(rate, 1)**2, size(rate, 3)), integral(size(rate, 1)**2, size(rate, 3) + 1)
        integer :: i, m, n, count

        m = size(rate, 1)
        count = size(rate, 3)
        term = 0.0_wp
        series = 0.0_wp
        do i = 1, m
            term(i, i, :) = 1.0_wp
            series(i, i, 0) = 1.0_wp
        end do
        do n = 1, order
            do i = 1, count
                product(:, i) = reshape(matmul(term(:, :, i), rate(:, :, i)), [m*m])
            end do
            integral = -thickness*matmul(product, transpose(antiderivative))
            term = reshape(integral(:, :count), shape(term))
            series(:, :, n) = reshape(integral(:, count + 1), [m, m])
        end do
    end subroutine gradient_series

    !> A across the plane of the wave.
    pure function anti_plane_rate(shear) result(rate)
        !> G relative to the surface
        real(wp), intent(in) :: shear
        real(wp) :: rate(2, 2)

        rate = reshape([0.0_wp, shear, 1.0_wp/shear, 0.0_wp], [2, 2])
    end function anti_plane_rate

    !> A in the plane of the wave.
    pure function in_plane_rate(shear, poisson) result(rate)
        !> G relative to the surface, and nu
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
    end function in_plane_rate

    !> product = product times factor.
    pure subroutine multiply_series(product, factor)
        real(wp), contiguous, intent(inout) :: product(:, :, 0:)
        real(wp), contiguous, intent(in) :: factor(:, :, 0:)
        real(wp) :: result(size(product, 1), size(product, 1), 0:order)
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
        real(wp), contiguous, intent(in) :: series(:, :, 0:)
        complex(wp), intent(in) :: k
        complex(wp) :: value(size(series, 1), size(series, 1))
        integer :: n

        value = series(:, :, order)
        do n = order - 1, 0, -1
            value = series(:, :, n) + k*value
        end do
    end function series_value

end module mdrcontact_body_elements_gradient
