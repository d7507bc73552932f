! SPDX-License-Identifier: GPL-3.0-or-later
!> Potentials of line loads P_2j(x/a) on a homogeneous half-space, in closed form. With oblate coordinates
!> r = a sqrt((1 + zeta^2)(1 - mu^2)), z = a zeta mu,
!>     int_0^a P_2j(x/a) Re[1/sqrt(r^2 + (z + i x)^2)] dx = (-1)^j P_2j(mu) q_2j(zeta),  Q_n(i zeta) = (-i)^(n+1) q_n(zeta)
!> (theory/conduction.md (7.4); Neumann's integral on the focal disc; Hobson, Spherical and Ellipsoidal Harmonics, 1931).
module mdrcontact_conduction_oblate
    use mdrcontact_kinds, only: half_pi, wp
    implicit none (type, external)
    private
    public :: oblate_sum

    !> Forward recurrence loses exp of this many digits (natural logarithm) at most; backward, as many are gained.
    real(wp), parameter :: forward_loss = 2.0_wp, gained = 40.0_wp
    !> Largest number of backward steps beyond the last order.
    integer, parameter :: most_steps = 100000

contains

    !> The sum of c_j times these integrals, and its slopes along r and z.
    pure subroutine oblate_sum(c, r, z, value, slope_r, slope_z)
        !> j = 0, 1, ...
        real(wp), intent(in) :: c(0:)
        !> in units of a; the slopes are infinite at r = 1, z = 0
        real(wp), intent(in) :: r, z
        real(wp), intent(out) :: value, slope_r, slope_z
        real(wp) :: q(-1:2*size(c)), zeta, mu, d, even, odd, even_slope, by_zeta, by_mu, rise
        integer :: j, n

        call coordinates(r, z, zeta, mu)
        call second_kind(zeta, q)
        d = zeta**2 + mu**2
        value = 0.0_wp
        by_zeta = 0.0_wp
        by_mu = 0.0_wp
        even = 1.0_wp
        odd = mu
        even_slope = 0.0_wp
        do j = 0, ubound(c, 1)
            n = 2*j
            value = value + c(j)*(-1)**j*even*q(n)
            rise = n*(zeta*q(n) - q(n - 1))
            if (n == 0) rise = -1.0_wp
            by_zeta = by_zeta + c(j)*(-1)**j*even*rise/(1.0_wp + zeta**2)
            by_mu = by_mu + c(j)*(-1)**j*even_slope*q(n)
            even = (real(2*n + 3, wp)*mu*odd - real(n + 1, wp)*even)/real(n + 2, wp)
            even_slope = even_slope + real(2*n + 3, wp)*odd
            odd = (real(2*n + 5, wp)*mu*even - real(n + 2, wp)*odd)/real(n + 3, wp)
        end do
        slope_r = 0.0_wp
        slope_z = 0.0_wp
        if (.not. d > 0.0_wp) return
        slope_r = r/d*(zeta*by_zeta - mu*by_mu)
        slope_z = (mu*(1.0_wp + zeta**2)*by_zeta + zeta*(1.0_wp - mu**2)*by_mu)/d
    end subroutine oblate_sum

    !> zeta >= 0 and 0 <= mu <= 1.
    pure subroutine coordinates(r, z, zeta, mu)
        real(wp), intent(in) :: r, z
        real(wp), intent(out) :: zeta, mu
        real(wp) :: half, root

        half = 0.5_wp*((r - 1.0_wp)*(r + 1.0_wp) + z**2)
        root = hypot(half, z)
        if (half >= 0.0_wp) then
            zeta = sqrt(half + root)
            mu = 0.0_wp
            if (zeta > 0.0_wp) mu = min(z/zeta, 1.0_wp)
        else
            mu = min(sqrt(root - half), 1.0_wp)
            zeta = z/mu
        end if
    end subroutine coordinates

    !> q_0 ... from (n + 1) q_(n+1) = n q_(n-1) - (2n + 1) zeta q_n, of which q is the falling solution.
    pure subroutine second_kind(zeta, q)
        real(wp), intent(in) :: zeta
        real(wp), intent(out) :: q(-1:)
        real(wp) :: rate, above, here, below
        integer :: n, last, first

        last = ubound(q, 1)
        q(-1) = 0.0_wp
        q(0) = half_pi - atan(zeta)
        if (zeta > 1.0_wp) q(0) = atan(1.0_wp/zeta)
        rate = asinh(zeta)
        if (2*last*rate < forward_loss) then
            q(1) = 1.0_wp - zeta*q(0)
            do n = 1, last - 1
                q(n + 1) = (n*q(n - 1) - (2*n + 1)*zeta*q(n))/(n + 1)
            end do
            return
        end if
        first = last + 2 + int(min(gained/rate, real(most_steps, wp)))
        above = 0.0_wp
        here = tiny(1.0_wp)/epsilon(1.0_wp)
        do n = first, 1, -1
            below = ((n + 1)*above + (2*n + 1)*zeta*here)/n
            above = here
            here = below
            if (n <= last) q(n) = above
            if (here > 1.0e100_wp) then
                here = here*1.0e-200_wp
                above = above*1.0e-200_wp
                if (n <= last) q(n:last) = q(n:last)*1.0e-200_wp
            end if
        end do
        q(1:) = q(1:)*(q(0)/here)
    end subroutine second_kind

end module mdrcontact_conduction_oblate
