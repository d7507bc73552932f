! SPDX-License-Identifier: GPL-3.0-or-later
!> Torque of the springs beyond a radius c as a paraboloid's contact of radius a slips about its axis under
!> Coulomb's law (theory/friction.md (7.12)). Springs slip at the twist, over mu and in units of that by which it falls at the edge,
!>     phi(c) = (2 a/pi) [K - E],    K, E of the modulus sqrt(1 - (c/a)^2)
!> (Lubkin, J. Appl. Mech. 18 (1951) 183), and carry M - k phi, k = k_a (c/a)^3, dM = k dphi:
!>     P(c) = k_a a p(c/a),    p(y) = (6/pi) int_y^1 t^2 [K - E] dt,
!> p(0) = 3 pi/32. The integral is not an elliptic one: p is a table of cubic pieces that have its derivativesalso.
module mdrcontact_law_twist
    use, intrinsic :: iso_c_binding, only: c_int
    use mdrcontact_gsl, only: gsl_sf_ellint_rd
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: new_twist_loads, twist_load

    !> Pieces of the table; its error is at most 1e-9.
    integer, parameter :: pieces = 256
    !> Nodes and weights of Gauss in a piece, of -1 to 1.
    real(wp), parameter :: near = sqrt(3.0_wp/7.0_wp - 2.0_wp/7.0_wp*sqrt(1.2_wp)), &
                           far = sqrt(3.0_wp/7.0_wp + 2.0_wp/7.0_wp*sqrt(1.2_wp)), &
                           nodes(4) = [-far, -near, near, far], light = (18.0_wp - sqrt(30.0_wp))/36.0_wp, &
                           heavy = (18.0_wp + sqrt(30.0_wp))/36.0_wp, weights(4) = [light, heavy, heavy, light]

contains

    !> p and its derivative by 1 - y, times the length of a piece, at the ends of pieces of 1 - y (2, 0:pieces).
    pure subroutine new_twist_loads(table)
        !> p [1], and the derivative times the length of a piece
        real(wp), allocatable, intent(out) :: table(:, :)
        real(wp), parameter :: width = 1.0_wp/pieces
        integer :: i, j

        allocate (table(2, 0:pieces), source=0.0_wp)
        do i = 1, pieces
            table(1, i) = table(1, i - 1)
            do j = 1, size(nodes)
                table(1, i) = table(1, i) + 0.5_wp*width*weights(j)*density(width*(i - 0.5_wp + 0.5_wp*nodes(j)))
            end do
            if (i < pieces) table(2, i) = width*density(width*i)
        end do
    end subroutine new_twist_loads

    !> -dp/dy at y = 1 - v > 0. With m = 1 - y^2, K - E = m R_D(0, y^2, 1)/3 (Carlson).
    pure function density(v) result(value)
        real(wp), intent(in) :: v
        real(wp) :: value
        integer(c_int), parameter :: double_precision_mode = 0_c_int
        real(wp) :: y

        y = 1.0_wp - v
        value = 2.0_wp/pi*y**2*v*(1.0_wp + y)*gsl_sf_ellint_rd(0.0_wp, y**2, 1.0_wp, double_precision_mode)
    end function density

    !> P of a radius c <= a over k_a a, and its derivative by a over k_a.
    pure subroutine twist_load(table, c, a, load, slope)
        !> of new_twist_loads
        real(wp), intent(in), contiguous :: table(:, 0:)
        !> the radius, and that of the contact, 0 <= c <= a [length]
        real(wp), intent(in) :: c
        !> see c
        real(wp), intent(in) :: a
        !> P/(k_a a) [1], and dP/da/k_a [1]
        real(wp), intent(out) :: load
        !> see load
        real(wp), intent(out) :: slope
        real(wp) :: v, x, rise, bend(2)
        integer :: i

        v = (a - c)/a*pieces
        i = min(int(v), pieces - 1)
        x = v - i
        rise = table(1, i + 1) - table(1, i)
        bend = [3.0_wp*rise - 2.0_wp*table(2, i) - table(2, i + 1), table(2, i) + table(2, i + 1) - 2.0_wp*rise]
        load = table(1, i) + x*(table(2, i) + x*(bend(1) + x*bend(2)))
        slope = 4.0_wp*load + pieces*(table(2, i) + x*(2.0_wp*bend(1) + 3.0_wp*x*bend(2)))*(c/a)
    end subroutine twist_load

end module mdrcontact_law_twist
