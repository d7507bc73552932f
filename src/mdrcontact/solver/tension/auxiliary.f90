! SPDX-License-Identifier: GPL-3.0-or-later
!> The auxiliary functions of sine and cosine integrals at complex arguments w, |arg w| < pi:
!>     f(w) = int_0^inf sin t/(t + w) dt,   g(w) = int_0^inf cos t/(t + w) dt        (DLMF 6.2.17, 6.2.18; theory/surfaces.md (6.9))
!>
!> GSL has sine, cosine and exponential integrals of real arguments only; a plate's poles are complex. With E1,
!>     g - i f = e^{iw} E1(iw),   g + i f = e^{-iw} E1(-iw),
!> by the power series of E1 next to the origin and its negative axis, by its continued fraction elsewhere (DLMF 6.6.2, 6.9.1).
module mdrcontact_tension_auxiliary
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: auxiliary, regular_parts

    real(wp), parameter :: euler = 0.57721566490153286061_wp
    complex(wp), parameter :: i_unit = (0.0_wp, 1.0_wp)
    !> |w| below which the series is used everywhere; |s| from which on the asymptotic series has full accuracy; terms of the rest.
    real(wp), parameter :: near = 2.0_wp, far = 40.0_wp
    integer, parameter :: most_terms = 400

contains

    !> f and g.
    elemental subroutine auxiliary(w, f, g)
        complex(wp), intent(in) :: w
        complex(wp), intent(out) :: f, g
        complex(wp) :: first, second

        if (abs(w) < near) then
            call regular_parts(w, log(w), f, g)
            return
        end if
        first = scaled_e1(i_unit*w)
        second = scaled_e1(-i_unit*w)
        ! E1 is continued across its cut
        if (real(w) < 0.0_wp) then
            if (aimag(w) < 0.0_wp) then
                second = second + 2.0_wp*pi*i_unit*exp(-i_unit*w)
            else
                first = first - 2.0_wp*pi*i_unit*exp(i_unit*w)
            end if
        end if
        g = 0.5_wp*(first + second)
        f = 0.5_wp*i_unit*(first - second)
    end subroutine auxiliary

    !> f and g with another number instead of ln w: they are f - sin w (ln w - logarithm) and g + cos w (ln w - logarithm).
    elemental subroutine regular_parts(w, logarithm, f, g)
        complex(wp), intent(in) :: w, logarithm
        complex(wp), intent(out) :: f, g
        complex(wp) :: first, second

        first = exp(i_unit*w)*entire(i_unit*w)
        second = exp(-i_unit*w)*entire(-i_unit*w)
        g = -cos(w)*(euler + logarithm) + 0.5_wp*pi*sin(w) + 0.5_wp*(first + second)
        f = sin(w)*(euler + logarithm) + 0.5_wp*pi*cos(w) + 0.5_wp*i_unit*(first - second)
    end subroutine regular_parts

    !> Ein(s) = E1(s) + ln s + gamma.
    elemental function entire(s) result(total)
        complex(wp), intent(in) :: s
        complex(wp) :: total
        complex(wp) :: term
        integer :: n

        term = -1.0_wp
        total = 0.0_wp
        do n = 1, most_terms
            term = -term*s/real(n, wp)
            total = total + term/real(n, wp)
            if (abs(term) <= 0.01_wp*epsilon(1.0_wp)*abs(total)) return
        end do
    end function entire

    !> e^s E1(s), |s| >= 2, principal branch.
    elemental function scaled_e1(s) result(value)
        complex(wp), intent(in) :: s
        complex(wp) :: value
        complex(wp) :: term
        integer :: n

        if (abs(s) >= far) then
            value = 0.0_wp
            term = 1.0_wp/s
            do n = 1, int(far)
                value = value + term
                term = -term*real(n, wp)/s
                if (abs(term) <= 0.01_wp*epsilon(1.0_wp)*abs(value)) return
            end do
        else if (real(s) < -abs(aimag(s))) then
            value = exp(s)*(entire(s) - log(s) - euler)
        else
            value = fraction_e1(s)
        end if
    end function scaled_e1

    !> Modified Lentz: e^s E1(s) = 1/(s + 1 - 1/(s + 3 - 4/(s + 5 - ...))).
    elemental function fraction_e1(s) result(value)
        complex(wp), intent(in) :: s
        complex(wp) :: value
        complex(wp) :: b, c, d, factor
        real(wp) :: a
        integer :: n

        b = s + 1.0_wp
        d = 1.0_wp/b
        value = d
        c = 1.0_wp/tiny(1.0_wp)**0.5_wp
        do n = 1, most_terms
            a = -real(n, wp)**2
            b = b + 2.0_wp
            d = 1.0_wp/(a*d + b)
            c = b + a/c
            factor = c*d
            value = value*factor
            if (abs(factor - 1.0_wp) <= 0.5_wp*epsilon(1.0_wp)) return
        end do
    end function fraction_e1

end module mdrcontact_tension_auxiliary
