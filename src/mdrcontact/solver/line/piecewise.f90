! SPDX-License-Identifier: GPL-3.0-or-later
!> Legendre coefficients of g for indenters with piecewise linear f', flat-ended and rounded ones, without quadrature.
!>
!> With g(x) = x int_0^x f'(r)/sqrt(x^2 - r^2) dr, equation (3), and cosine = sqrt(1 - (r/a)^2):
!>
!>     int_r^a P_(2k+1)(x/a)/sqrt(x^2 - r^2) dx = c_k P_(2k+1)(cosine),   c_0 = 1,   c_(k+1) = -c_k (2k + 2)/(2k + 3),
!>
!> so that int_-1^1 g(a |u|) P_2j(u) du is 2/(4j + 1) times (2j + 1) c_j S_j + 2j c_(j-1) S_(j-1), where
!> S_k = int_0^a f'(r) P_(2k+1)(cosine) dr.
module mdrcontact_line_piecewise
    use mdrcontact_kinds, only: half_pi, wp
    implicit none (type, external)
    private
    public :: piecewise_moments

contains

    !> int_-1^1 g(a |u|) P_2j(u) du, j = 0 ... [length].
    pure subroutine piecewise_moments(radii, slopes, curvatures, a, g)
        !> f'(r) = slopes(i) + curvatures(i) r from radii(i), ascending from 0, to the next [length], [1], [1/length]
        real(wp), intent(in) :: radii(:), slopes(:), curvatures(:)
        !> contact radius [length]
        real(wp), intent(in) :: a
        real(wp), intent(out) :: g(0:)
        real(wp) :: sums(0:ubound(g, 1)), c, here, before
        integer :: i, j, last

        sums = 0.0_wp
        ! of the last piece int_0^1 s P_(2k+1)(s) ds is left
        last = count(radii < a)
        sums(0) = curvatures(last)*a/3.0_wp
        call add_piece(radii(1)/a, slopes(1), curvatures(1)*a, sums)
        do i = 2, last
            call add_piece(radii(i)/a, slopes(i) - slopes(i - 1), (curvatures(i) - curvatures(i - 1))*a, sums)
        end do
        c = 2.0_wp*a
        before = 0.0_wp
        do j = 0, ubound(g, 1)
            here = c*sums(j)
            g(j) = (real(2*j + 1, wp)*here + real(2*j, wp)*before)/real(4*j + 1, wp)
            before = here
            c = -c*real(2*j + 2, wp)/real(2*j + 3, wp)
        end do
    end subroutine piecewise_moments

    !> Adds slope int_b^1 P_(2k+1)(cosine) dr - curvature int_0^b r P_(2k+1)(cosine) dr.
    !>
    !> With e_n = int_b^1 P_n(cosine) dr/cosine, n even: (n + 2)^2 e_(n+2) = (n + 1)^2 e_n - (2n + 3) b P_(n+1)(cosine). The second
    !> integral is one over cosine, taken by differences of P_n, so that its small values under a small b keep their digits.
    pure subroutine add_piece(b, slope, curvature, sums)
        !> [a]
        real(wp), intent(in) :: b
        real(wp), intent(in) :: slope, curvature
        real(wp), intent(inout) :: sums(0:)
        real(wp) :: cosine, rest, odd, even, rise, even_rise, around, e, next_e, over, next_over
        integer :: k, n

        cosine = sqrt((1.0_wp - b)*(1.0_wp + b))
        rest = b**2/(1.0_wp + cosine)
        ! P_(n-1), P_n and the differences to the one before of n = 1
        even = 1.0_wp
        odd = cosine
        rise = -rest
        e = half_pi - asin(b)
        ! int_cosine^1 P_(n-1)
        over = rest
        do k = 0, ubound(sums, 1)
            n = 2*k + 1
            next_e = (real(n*n, wp)*e - real(2*n + 1, wp)*b*odd)/real((n + 1)**2, wp)
            even_rise = (real(n, wp)*rise - real(2*n + 1, wp)*rest*odd)/real(n + 1, wp)
            even = even + (rise + even_rise)
            rise = (real(n + 1, wp)*even_rise - real(2*n + 3, wp)*rest*even)/real(n + 2, wp)
            ! int_cosine^1 P_(n+1) = (P_n - P_(n+2))/(2n + 3)
            around = even_rise + rise
            next_over = -around/real(2*n + 3, wp)
            odd = odd + around
            sums(k) = sums(k) + (slope*(real(n + 1, wp)*next_e + real(n, wp)*e) &
                                 - curvature*(real(n + 1, wp)*next_over + real(n, wp)*over))/real(2*n + 1, wp)
            e = next_e
            over = next_over
        end do
    end subroutine add_piece

end module mdrcontact_line_piecewise
