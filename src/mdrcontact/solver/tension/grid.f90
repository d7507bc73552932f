! SPDX-License-Identifier: GPL-3.0-or-later
!> Nodes of an angle in (0, pi/2) for functions P(sin) + Q(sin) ln sin times waves: a panel next to 0 whose rule has weights for the
!> logarithm as well, and panels that double away from it.
module mdrcontact_tension_grid
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre, legendre
    implicit none (type, external)
    private
    public :: grid_t, new_grid, order_for

    !> Nodes of a panel without waves, and more of them for each radian of a wave; next to 0, where weights for the logarithm hold
    !> for polynomials of the degree n - 1 only, instead of 2 n - 1, for twice as many.
    real(wp), parameter :: fewest = 14.0_wp, per_radian = 0.29_wp, per_radian_beside = 2.0_wp*per_radian

    !> Numbers of nodes for which GSL has them to machine precision; others it computes to ten.
    integer, parameter :: orders(*) = [16, 20, 32, 64, 96, 128, 256, 512, 1024]

    !> Made by new_grid.
    type :: grid_t
        !> angles and their sines
        real(wp), allocatable :: angle(:), sine(:)
        !> weights of int h d(angle) and of int h ln(sin) d(angle)
        real(wp), allocatable :: weight(:), log_weight(:)
        !> how many nodes lie in the panel next to 0
        integer :: beside = 0
    end type grid_t

contains

    !> A grid that resolves waves cos(wave angle), its first panel `first` long.
    subroutine new_grid(self, first, wave, error)
        type(grid_t), intent(out) :: self
        real(wp), intent(in) :: first, wave
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: low, length, more

        allocate (self%angle(0), self%sine(0), self%weight(0), self%log_weight(0))
        low = 0.0_wp
        length = min(first, half_pi)
        more = per_radian_beside
        do while (low < half_pi)
            if (low + 1.5_wp*length > half_pi) length = half_pi - low
            call add_panel(self, low, length, order_for(nint(fewest + more*wave*length)), error)
            if (allocated(error)) return
            low = low + length
            if (.not. low < half_pi*(1.0_wp - 1.0e-12_wp)) return
            length = low
            more = per_radian
        end do
    end subroutine new_grid

    !> The next larger number of nodes that is known to machine precision.
    pure function order_for(wanted) result(order)
        integer, intent(in) :: wanted
        integer :: order

        order = minval(orders, mask=orders >= min(wanted, maxval(orders)))
    end function order_for

    subroutine add_panel(self, low, length, n, error)
        type(grid_t), intent(inout) :: self
        real(wp), intent(in) :: low, length
        integer, intent(in) :: n
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: t(n), w(n), angle(n), logarithm(n)

        call gauss_legendre(t, w, error)
        if (allocated(error)) return
        angle = low + length*t
        logarithm = w*log(sin(angle))
        if (.not. low > 0.0_wp) then
            logarithm = log_weights(t, w) + w*log(sin(angle)/t)
            self%beside = n
        end if
        self%angle = [self%angle, angle]
        self%sine = [self%sine, sin(angle)]
        self%weight = [self%weight, length*w]
        self%log_weight = [self%log_weight, length*logarithm]
    end subroutine add_panel

    !> Weights of int_0^1 h ln t dt at Gauss nodes, from int_0^1 ln t P_j(2t - 1) dt = (-1)^(j+1)/(j (j + 1)), -1 for j = 0.
    pure function log_weights(t, w) result(weights)
        real(wp), intent(in) :: t(:), w(:)
        real(wp) :: weights(size(t))
        real(wp) :: p(size(t), 0:size(t) - 1), moment
        integer :: j

        p = legendre(size(t), 2.0_wp*t - 1.0_wp)
        weights = -p(:, 0)
        do j = 1, size(t) - 1
            moment = (-1)**(j + 1)/(real(j, wp)*real(j + 1, wp))
            weights = weights + real(2*j + 1, wp)*moment*p(:, j)
        end do
        weights = w*weights
    end function log_weights

end module mdrcontact_tension_grid
