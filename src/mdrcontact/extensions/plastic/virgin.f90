! SPDX-License-Identifier: GPL-3.0-or-later
!> First loading of a paraboloid on an elastic and perfectly plastic half-space, for any Poisson's ratio
!> (theory/plastic.md (4.1), (4.5)-(4.7)).
!>
!> With L = a E*/(R Y): F = pi a^2 Y P(L), d = (a^2/R) D(L), and the line load on the axis is q(0) = S(L) F/(pi a). Below first
!> yield, L <= L_y, these are Hertz's P = 4 L/(3 pi), D = 1, S = 3 pi/4. Beyond it they are series through finite elements.
module mdrcontact_plastic_virgin
    use mdrcontact_error, only: check_within, error_t
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_numerics_chebyshev, only: chebyshev_sum
    use mdrcontact_numerics_exponential, only: one_minus_exp
    implicit none (type, external)
    private
    public :: virgin_t, new_virgin, first_yield, largest_load, largest_poisson

    !> Largest L and Poisson's ratio of the finite elements [1].
    real(wp), parameter :: largest_load = 250.0_wp, largest_poisson = 0.49_wp

    !> Terms of the series in L, and powers of 4 nu - 1 in each coefficient.
    integer, parameter :: terms = 13, powers = 4
    !> x = t/(t + tau), t = ln(L/L_y), runs from 0 to the last one.
    real(wp), parameter :: tau = 2.5_wp, last_x = 0.66009203343558065_wp

    !> Coefficients of y_P, y_D and y_S, (power, term) in the order of the terms for each power.
    real(wp), parameter :: pressure_terms(terms, powers) = reshape([ &
        -9.8156_wp, 0.4124_wp, -0.8669_wp, -0.4368_wp, 0.0679_wp, -0.1279_wp, 0.0646_wp, &
        0.0502_wp, -0.0452_wp, -0.0045_wp, 0.0470_wp, -0.0512_wp, 0.0216_wp, &
        -0.7865_wp, 0.4027_wp, -0.2809_wp, 0.0905_wp, 0.1018_wp, -0.0275_wp, 0.0033_wp, &
        0.0239_wp, -0.0624_wp, 0.0824_wp, -0.0988_wp, 0.0759_wp, -0.0204_wp, &
        -0.4098_wp, 0.4591_wp, -0.0388_wp, -0.0492_wp, 0.0406_wp, -0.0075_wp, -0.0351_wp, &
        0.0334_wp, -0.0602_wp, 0.0836_wp, -0.0806_wp, 0.0598_wp, -0.0265_wp, &
        -0.1537_wp, 0.2483_wp, -0.1285_wp, 0.0264_wp, 0.0109_wp, -0.0475_wp, 0.0603_wp, &
        -0.0692_wp, 0.0721_wp, -0.0724_wp, 0.0662_wp, -0.0496_wp, 0.0141_wp], [terms, powers])
    real(wp), parameter :: depth_terms(terms, powers) = reshape([ &
        -3.8615_wp, 1.2641_wp, -0.0985_wp, -0.0490_wp, 0.0142_wp, -0.0704_wp, 0.0922_wp, &
        -0.0107_wp, 0.0247_wp, -0.0450_wp, 0.0507_wp, -0.0448_wp, 0.0166_wp, &
        -0.4436_wp, 0.3205_wp, -0.0687_wp, 0.0316_wp, 0.1121_wp, -0.0512_wp, 0.0424_wp, &
        -0.0291_wp, -0.0013_wp, 0.0103_wp, -0.0376_wp, 0.0404_wp, -0.0075_wp, &
        -0.2253_wp, 0.3008_wp, -0.0321_wp, -0.0126_wp, 0.0096_wp, -0.0089_wp, -0.0083_wp, &
        -0.0028_wp, -0.0138_wp, 0.0329_wp, -0.0298_wp, 0.0298_wp, -0.0154_wp, &
        -0.0893_wp, 0.1412_wp, -0.0742_wp, 0.0307_wp, -0.0301_wp, 0.0171_wp, -0.0114_wp, &
        0.0051_wp, 0.0081_wp, -0.0202_wp, 0.0325_wp, -0.0330_wp, 0.0095_wp], [terms, powers])
    real(wp), parameter :: line_terms(terms, powers) = reshape([ &
        -2.1656_wp, 2.5130_wp, -0.8695_wp, 0.2130_wp, 0.1306_wp, -0.2419_wp, 0.1939_wp, &
        -0.1508_wp, 0.0949_wp, -0.0355_wp, 0.0031_wp, 0.0091_wp, -0.0062_wp, &
        0.2060_wp, -0.3784_wp, 0.3202_wp, -0.1687_wp, 0.0115_wp, -0.0004_wp, 0.0042_wp, &
        0.0047_wp, 0.0102_wp, -0.0197_wp, 0.0180_wp, -0.0174_wp, 0.0044_wp, &
        -0.0615_wp, 0.1177_wp, -0.0924_wp, 0.0375_wp, -0.0007_wp, -0.0186_wp, 0.0407_wp, &
        -0.0361_wp, 0.0270_wp, -0.0283_wp, 0.0221_wp, -0.0145_wp, 0.0079_wp, &
        -0.0355_wp, 0.0828_wp, -0.0932_wp, 0.0897_wp, -0.0699_wp, 0.0609_wp, -0.0512_wp, &
        0.0424_wp, -0.0365_wp, 0.0302_wp, -0.0185_wp, 0.0135_wp, -0.0043_wp], [terms, powers])

    !> The curve of one Poisson's ratio.
    type :: virgin_t
        !> L at first yield [1]
        real(wp) :: first_yield = 0.0_wp
        !> series of y_P, y_D and y_S in x
        real(wp), private :: pressure(terms) = 0.0_wp, depth(terms) = 0.0_wp, line(terms) = 0.0_wp
    contains
        procedure :: at
    end type virgin_t

contains

    !> The curve of a Poisson's ratio.
    pure subroutine new_virgin(self, poisson, error)
        type(virgin_t), intent(out) :: self
        !> 0 <= nu <= 0.49 [1]
        real(wp), intent(in) :: poisson
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: weights(powers)
        integer :: m

        call check_within(error, "nu", poisson, 0.0_wp, largest_poisson)
        if (allocated(error)) return
        self%first_yield = first_yield(poisson)
        weights = [((4.0_wp*poisson - 1.0_wp)**m, m=0, powers - 1)]
        self%pressure = matmul(pressure_terms, weights)
        self%depth = matmul(depth_terms, weights)
        self%line = matmul(line_terms, weights)
    end subroutine new_virgin

    !> P, D and S at a load L > 0, and 1 - S/(3 pi/4) without cancellation.
    pure subroutine at(self, load, pressure, depth, line, deficit)
        class(virgin_t), intent(in) :: self
        !> L [1]
        real(wp), intent(in) :: load
        real(wp), intent(out) :: pressure, depth, line, deficit
        real(wp) :: t, x, z, y

        pressure = 4.0_wp*load/(3.0_wp*pi)
        depth = 1.0_wp
        line = 0.75_wp*pi
        deficit = 0.0_wp
        if (load <= self%first_yield) return
        t = log(load/self%first_yield)
        x = t/(t + tau)
        z = 2.0_wp*x/last_x - 1.0_wp
        y = x*x*sqrt(x)
        pressure = pressure*exp(y*chebyshev_sum(self%pressure, z))
        depth = exp(y*chebyshev_sum(self%depth, z))
        deficit = one_minus_exp(-x*x*chebyshev_sum(self%line, z))
        line = line*(1.0_wp - deficit)
    end subroutine at

    !> L = a E*/(R Y) at which a half-space begins to yield below a paraboloid: on the axis at the depth zeta a, by Huber's
    !> stresses (theory/plastic.md (4.2), (4.3)). The polynomial (4.4) is an approximation of this.
    elemental function first_yield(poisson) result(load)
        !> nu [1]
        real(wp), intent(in) :: poisson
        real(wp) :: load
        real(wp) :: low, high, zeta
        integer :: i

        ! the largest stress lies between; it moves down as nu grows
        low = 0.2_wp
        high = 1.0_wp
        do i = 1, 60
            zeta = 0.5_wp*(low + high)
            if (3.0_wp*zeta/(1.0_wp + zeta**2)**2/(atan(1.0_wp/zeta) - zeta/(1.0_wp + zeta**2)) < 1.0_wp + poisson) then
                low = zeta
            else
                high = zeta
            end if
        end do
        load = half_pi/(1.5_wp/(1.0_wp + zeta**2) - (1.0_wp + poisson)*(1.0_wp - zeta*atan(1.0_wp/zeta)))
    end function first_yield

end module mdrcontact_plastic_virgin
