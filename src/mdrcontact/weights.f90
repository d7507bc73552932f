! SPDX-License-Identifier: GPL-3.0-or-later
!> Weights of a depth z = a xi in the effective modulus of a layered medium (theory 3).
!>
!> I0 weighs the shear modulus, I1 Poisson's ratio; both rise from 0 at the surface to 1 at infinite depth. Each comes with its
!> complement J = 1 - I and its slope dI/dxi, computed directly and not by subtraction, so that all keep full relative
!> precision at both ends: contrasts of 1e6 and a/h from 1e-9 to 1e6 need it.
!> Gao, Chiu, Lee, Int. J. Solids Struct. 29 (1992) 2471; Popov 2014, equations (13)-(18).
module mdrcontact_weights
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: weight_phi, weight_i0, weight_i1, weight_j0, weight_j1, weight_i0_slope, weight_i1_slope, &
              weight_i0_poisson_slope

    !> Beyond these the weights equal their limits' leading term; squares stay inside the range of a double.
    real(wp), parameter :: smallest_xi = 1.0e-150_wp, largest_xi = 1.0e150_wp

contains

    !> Phi(xi) = (1 + 3 xi^2)/(pi (1 + xi^2)^2) = dI0/dxi at nu = 1/2, equation (18); xi = z/a >= 0. Its integral is 1.
    elemental function weight_phi(xi) result(phi)
        !> z/a >= 0 [1]
        real(wp), intent(in) :: xi
        real(wp) :: phi, square

        square = clamped(xi)**2
        phi = (1.0_wp + 3.0_wp*square)/(1.0_wp + square)/(1.0_wp + square)/pi
    end function weight_phi

    !> I0(xi), the weight of the shear modulus between the surface and depth z = a xi, equation (14); xi >= 0, -1 < nu <= 1/2.
    elemental function weight_i0(xi, nu) result(weight)
        !> z/a >= 0 [1], and Poisson's ratio of the medium, -1 < nu <= 1/2 [1]
        real(wp), intent(in) :: xi, nu
        real(wp) :: weight, x

        x = clamped(xi)
        weight = merge((2.0_wp/pi)*atan(x) + compressible_part(x, nu), 0.0_wp, xi > 0.0_wp)
    end function weight_i0

    !> 1 - I0(xi), the weight of everything below depth a xi.
    elemental function weight_j0(xi, nu) result(weight)
        !> as in weight_i0
        real(wp), intent(in) :: xi, nu
        real(wp) :: weight, x

        x = clamped(xi)
        weight = (2.0_wp/pi)*atan(1.0_wp/x) - compressible_part(x, nu)
    end function weight_j0

    !> I1(xi), the weight of Poisson's ratio between the surface and depth z = a xi, equation (15); xi >= 0.
    elemental function weight_i1(xi) result(weight)
        !> z/a >= 0 [1]
        real(wp), intent(in) :: xi
        real(wp) :: weight, x

        x = clamped(xi)
        weight = merge((2.0_wp/pi)*atan(x) + x*log_term(x)/pi, 0.0_wp, xi > 0.0_wp)
    end function weight_i1

    !> 1 - I1(xi).
    elemental function weight_j1(xi) result(weight)
        !> z/a >= 0 [1]
        real(wp), intent(in) :: xi
        real(wp) :: weight, x

        x = clamped(xi)
        weight = (2.0_wp/pi)*atan(1.0_wp/x) - x*log_term(x)/pi
    end function weight_j1

    !> dI0/dxi.
    elemental function weight_i0_slope(xi, nu) result(slope)
        real(wp), intent(in) :: xi, nu
        real(wp) :: slope, x, lorentzian

        x = clamped(xi)
        lorentzian = 1.0_wp/(1.0_wp + x**2)
        slope = (2.0_wp/pi)*lorentzian &
                + ((1.0_wp - 2.0_wp*nu)*(log_term(x) - 2.0_wp*lorentzian) - (1.0_wp - x**2)*lorentzian*lorentzian) &
                /(2.0_wp*pi*(1.0_wp - nu))
    end function weight_i0_slope

    !> dI0/dnu at constant xi.
    elemental function weight_i0_poisson_slope(xi, nu) result(slope)
        real(wp), intent(in) :: xi, nu
        real(wp) :: slope, x

        x = clamped(xi)
        slope = -(x*log_term(x) + x/(1.0_wp + x**2))/(2.0_wp*pi*(1.0_wp - nu)**2)
    end function weight_i0_poisson_slope

    !> dI1/dxi = ln(1 + 1/xi^2)/pi.
    elemental function weight_i1_slope(xi) result(slope)
        real(wp), intent(in) :: xi
        real(wp) :: slope

        slope = log_term(clamped(xi))/pi
    end function weight_i1_slope

    elemental function compressible_part(x, nu) result(part)
        real(wp), intent(in) :: x, nu
        real(wp) :: part

        part = ((1.0_wp - 2.0_wp*nu)*x*log_term(x) - x/(1.0_wp + x**2))/(2.0_wp*pi*(1.0_wp - nu))
    end function compressible_part

    !> ln((1 + x^2)/x^2) to full precision for large x too: the rounding error of 1 + t is put back to first order.
    elemental function log_term(x) result(logarithm)
        real(wp), intent(in) :: x
        real(wp) :: logarithm, t, u

        t = 1.0_wp/x**2
        u = 1.0_wp + t
        logarithm = log(u) - ((u - 1.0_wp) - t)/u
    end function log_term

    elemental function clamped(xi) result(x)
        real(wp), intent(in) :: xi
        real(wp) :: x

        x = min(max(xi, smallest_xi), largest_xi)
    end function clamped

end module mdrcontact_weights
