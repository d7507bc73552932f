! SPDX-License-Identifier: GPL-3.0-or-later
!> Weights of a depth z = a xi in the effective modulus of a layered medium (theory/paper.md (3.3), (3.4), (3.7)).
!>
!> I0 weighs the shear modulus, I1 Poisson's ratio; both rise from 0 at the surface to 1 at infinite depth. Each comes with its
!> complement J = 1 - I and its slope dI/dxi, computed directly and not by subtraction, so that all keep full relative
!> precision at both ends: contrasts of 1e6 and a/h from 1e-9 to 1e6 need it.
!> Gao, Chiu, Lee, Int. J. Solids Struct. 29 (1992) 2471; Popov 2014, equations (12)-(18).
module mdrcontact_weights
    use mdrcontact_batch, only: map_t
    use mdrcontact_codes, only: of_i0 => weight_i0, of_i0_slope => weight_phi, of_i0_tangential => weight_i0_tangential, &
                                of_i1 => weight_i1, of_j0 => weight_j0, of_j0_tangential => weight_j0_tangential, &
                                of_j1 => weight_j1
    use mdrcontact_kinds, only: half_pi, pi, wp
    implicit none (type, external)
    private
    public :: weight_phi, weight_i0, weight_i1, weight_j0, weight_j1, weight_i0_slope, weight_i1_slope, &
              weight_i0_poisson_slope
    public :: weight_i0_tangential, weight_j0_tangential, weight_i0_tangential_slope, weight_i0_tangential_poisson_slope
    public :: all_weights
    public :: weight_map_t, of_i0_slope, of_i0, of_i1, of_j0, of_j1, of_i0_tangential, of_j0_tangential

    !> Beyond these the weights equal their limits' leading term; squares stay inside the range of a double.
    real(wp), parameter :: smallest_xi = 1.0e-150_wp, largest_xi = 1.0e150_wp

    !> One of the weights for arrays of xi, vectorised.
    type, extends(map_t) :: weight_map_t
        !> of_...
        integer :: weight = of_i0
        real(wp) :: nu = 0.5_wp
    contains
        procedure :: values => weight_values
    end type weight_map_t

    !> Depths taken at a time. They are filled up to a whole number of vectors, so that every value comes from the same
    !> instructions, at any index of an array.
    integer, parameter :: chunk = 64, widest_vector = 8

contains

    !> Phi(xi) = (1 + 3 xi^2)/(pi (1 + xi^2)^2) = dI0/dxi at nu = 1/2, equation (18); xi = z/a >= 0. Its integral is 1.
    elemental function weight_phi(xi) result(phi)
        !> z/a >= 0 [1]
        real(wp), intent(in) :: xi
        real(wp) :: phi, square

        square = clamped(xi)**2
        phi = (1.0_wp + 3.0_wp*square)/(1.0_wp + square)/(1.0_wp + square)/pi
    end function weight_phi

    !> I0(xi), the weight of the shear modulus between the surface and depth z = a xi, equations (12)-(15); xi >= 0, -1 < nu <= 1/2.
    elemental function weight_i0(xi, nu) result(weight)
        !> z/a >= 0 [1], and Poisson's ratio of the medium, -1 < nu <= 1/2 [1]
        real(wp), intent(in) :: xi, nu
        real(wp) :: weight, x

        x = clamped(xi)
        weight = merge(i0_inside(x, nu), 0.0_wp, xi > 0.0_wp)
    end function weight_i0

    !> 1 - I0(xi), the weight of everything below depth a xi.
    elemental function weight_j0(xi, nu) result(weight)
        !> as in weight_i0
        real(wp), intent(in) :: xi, nu
        real(wp) :: weight, x

        x = clamped(xi)
        weight = j0_inside(x, nu)
    end function weight_j0

    !> I1(xi), the weight of Poisson's ratio between the surface and depth z = a xi, equations (12)-(15); xi >= 0.
    elemental function weight_i1(xi) result(weight)
        !> z/a >= 0 [1]
        real(wp), intent(in) :: xi
        real(wp) :: weight, x

        x = clamped(xi)
        weight = merge(i1_inside(x), 0.0_wp, xi > 0.0_wp)
    end function weight_i1

    !> 1 - I1(xi).
    elemental function weight_j1(xi) result(weight)
        !> z/a >= 0 [1]
        real(wp), intent(in) :: xi
        real(wp) :: weight, x

        x = clamped(xi)
        weight = j1_inside(x)
    end function weight_j1

    !> I0 and I1 with their complements, for the price of one arctangent and one logarithm.
    elemental subroutine all_weights(xi, nu, tangential, i0, j0, i1, j1)
        !> xi >= 0, -1 < nu <= 1/2
        real(wp), intent(in) :: xi, nu
        !> the weights of a load along the surface
        logical, intent(in) :: tangential
        real(wp), intent(out) :: i0, j0, i1, j1
        real(wp) :: x, above, below, logarithm, part

        x = clamped(xi)
        ! Whichever angle is small is computed, the other is large enough to be its complement.
        if (x < 1.0_wp) then
            above = atan(x)
            below = half_pi - above
        else
            below = atan(1.0_wp/x)
            above = half_pi - below
        end if
        logarithm = x*log_term(x)
        if (tangential) then
            part = logarithm/pi + (logarithm - x/(1.0_wp + x**2))/(2.0_wp*pi*(2.0_wp - nu))
        else
            part = ((1.0_wp - 2.0_wp*nu)*logarithm - x/(1.0_wp + x**2))/(2.0_wp*pi*(1.0_wp - nu))
        end if
        i0 = (2.0_wp/pi)*above + part
        j0 = (2.0_wp/pi)*below - part
        i1 = ((2.0_wp*above) + logarithm)/pi
        j1 = ((2.0_wp*below) - logarithm)/pi
        if (xi > 0.0_wp) return
        i0 = 0.0_wp
        i1 = 0.0_wp
    end subroutine all_weights

    !> I0 of a load along the surface, the weight of the shear modulus in the tangential stiffness: I1 + [xi L - xi/(1 + xi^2)]/(2
    !> pi (2 - nu)), L = ln(1 + 1/xi^2) (theory/friction.md (4.1)). Poisson's ratio has the weight I1 also there.
    elemental function weight_i0_tangential(xi, nu) result(weight)
        !> as in weight_i0
        real(wp), intent(in) :: xi, nu
        real(wp) :: weight, x

        x = clamped(xi)
        weight = merge(i1_inside(x) + tangential_part(x, nu), 0.0_wp, xi > 0.0_wp)
    end function weight_i0_tangential

    !> 1 less that.
    elemental function weight_j0_tangential(xi, nu) result(weight)
        !> as in weight_i0
        real(wp), intent(in) :: xi, nu
        real(wp) :: weight, x

        x = clamped(xi)
        weight = j1_inside(x) - tangential_part(x, nu)
    end function weight_j0_tangential

    elemental function tangential_part(x, nu) result(part)
        real(wp), intent(in) :: x, nu
        real(wp) :: part

        part = (x*log_term(x) - x/(1.0_wp + x**2))/(2.0_wp*pi*(2.0_wp - nu))
    end function tangential_part

    !> dI0/dxi of a load along the surface.
    elemental function weight_i0_tangential_slope(xi, nu) result(slope)
        real(wp), intent(in) :: xi, nu
        real(wp) :: slope, x, lorentzian

        x = clamped(xi)
        lorentzian = 1.0_wp/(1.0_wp + x**2)
        slope = log_term(x)/pi + (log_term(x) - 2.0_wp*lorentzian - (1.0_wp - x**2)*lorentzian*lorentzian) &
                /(2.0_wp*pi*(2.0_wp - nu))
    end function weight_i0_tangential_slope

    !> dI0/dnu of a load along the surface, at constant xi.
    elemental function weight_i0_tangential_poisson_slope(xi, nu) result(slope)
        real(wp), intent(in) :: xi, nu
        real(wp) :: slope

        slope = tangential_part(clamped(xi), nu)/(2.0_wp - nu)
    end function weight_i0_tangential_poisson_slope

    !> dI0/dxi.
    elemental function weight_i0_slope(xi, nu) result(slope)
        real(wp), intent(in) :: xi, nu
        real(wp) :: slope

        slope = i0_slope_inside(clamped(xi), nu)
    end function weight_i0_slope

    elemental function i0_slope_inside(x, nu) result(slope)
        real(wp), intent(in) :: x, nu
        real(wp) :: slope, lorentzian

        lorentzian = 1.0_wp/(1.0_wp + x**2)
        slope = (2.0_wp/pi)*lorentzian &
                + ((1.0_wp - 2.0_wp*nu)*(log_term(x) - 2.0_wp*lorentzian) - (1.0_wp - x**2)*lorentzian*lorentzian) &
                /(2.0_wp*pi*(1.0_wp - nu))
    end function i0_slope_inside

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

    elemental function i0_inside(x, nu) result(weight)
        real(wp), intent(in) :: x, nu
        real(wp) :: weight

        weight = (2.0_wp/pi)*atan(x) + compressible_part(x, nu)
    end function i0_inside

    elemental function j0_inside(x, nu) result(weight)
        real(wp), intent(in) :: x, nu
        real(wp) :: weight

        weight = (2.0_wp/pi)*atan(1.0_wp/x) - compressible_part(x, nu)
    end function j0_inside

    elemental function i1_inside(x) result(weight)
        real(wp), intent(in) :: x
        real(wp) :: weight

        weight = (2.0_wp/pi)*atan(x) + x*log_term(x)/pi
    end function i1_inside

    elemental function j1_inside(x) result(weight)
        real(wp), intent(in) :: x
        real(wp) :: weight

        weight = (2.0_wp/pi)*atan(1.0_wp/x) - x*log_term(x)/pi
    end function j1_inside

    !> Clamping and the value at 0 are in loops of their own: a branch would keep atan and log from being vectorised.
    pure subroutine weight_values(self, x, y)
        class(weight_map_t), intent(in) :: self
        !> xi >= 0
        real(wp), intent(in) :: x(:)
        real(wp), intent(out) :: y(:)
        real(wp) :: inside(chunk), weights(chunk)
        integer :: first, n, i

        do first = 1, size(x), chunk
            n = min(chunk, size(x) - first + 1)
            inside(:n) = clamped(x(first:first + n - 1))
            inside(n + 1:) = 1.0_wp
            call fill(self%weight, self%nu, ((n - 1)/widest_vector + 1)*widest_vector, inside, weights)
            if (any(self%weight == [of_i0, of_i1, of_i0_tangential])) then
                do i = 1, n
                    if (.not. x(first + i - 1) > 0.0_wp) weights(i) = 0.0_wp
                end do
            end if
            y(first:first + n - 1) = weights(:n)
        end do
    end subroutine weight_values

    pure subroutine fill(weight, nu, n, x, y)
        integer, intent(in) :: weight, n
        real(wp), intent(in) :: nu, x(chunk)
        real(wp), intent(out) :: y(chunk)
        integer :: i

        select case (weight)
        case (of_i0_slope)
            do i = 1, n
                y(i) = i0_slope_inside(x(i), nu)
            end do
        case (of_i0)
            do i = 1, n
                y(i) = i0_inside(x(i), nu)
            end do
        case (of_i1)
            do i = 1, n
                y(i) = i1_inside(x(i))
            end do
        case (of_j0)
            do i = 1, n
                y(i) = j0_inside(x(i), nu)
            end do
        case (of_i0_tangential)
            do i = 1, n
                y(i) = i1_inside(x(i)) + tangential_part(x(i), nu)
            end do
        case (of_j0_tangential)
            do i = 1, n
                y(i) = j1_inside(x(i)) - tangential_part(x(i), nu)
            end do
        case default
            do i = 1, n
                y(i) = j1_inside(x(i))
            end do
        end select
    end subroutine fill

    elemental function clamped(xi) result(x)
        real(wp), intent(in) :: xi
        real(wp) :: x

        x = min(max(xi, smallest_xi), largest_xi)
    end function clamped

end module mdrcontact_weights
