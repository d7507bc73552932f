! SPDX-License-Identifier: GPL-3.0-or-later
!> Chebyshev interpolation of several functions that are known at the same nodes, panel by panel.
module mdrcontact_fit_chebyshev
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: nodes, node_positions, to_coefficients, tail, value_and_slope

    !> Nodes in a panel.
    integer, parameter :: nodes = 12

contains

    !> The nodes in [-1, 1].
    pure function node_positions() result(z)
        real(wp) :: z(nodes)
        integer :: i

        z = cos(pi*([(real(i, wp), i=1, nodes)] - 0.5_wp)/nodes)
    end function node_positions

    !> Coefficients of T_0, T_1, ... from the values at the nodes.
    pure function to_coefficients(values) result(c)
        real(wp), intent(in) :: values(nodes)
        real(wp) :: c(nodes)
        integer :: i, j
        !> (node, j): T_(j-1) at the node
        real(wp), parameter :: cosines(nodes, nodes) = &
                               reshape([((cos(pi*(j - 1)*(i - 0.5_wp)/nodes), i=1, nodes), j=1, nodes)], [nodes, nodes])

        c = (2.0_wp/nodes)*matmul(values, cosines)
        c(1) = 0.5_wp*c(1)
    end function to_coefficients

    !> What the last coefficients say of the error.
    pure function tail(c) result(size)
        real(wp), intent(in) :: c(nodes)
        real(wp) :: size

        size = maxval(abs(c(nodes - 1:)))
    end function tail

    !> The sum at z and its slope in z, by Clenshaw's recurrence.
    pure subroutine value_and_slope(c, z, value, slope)
        real(wp), intent(in) :: c(nodes), z
        real(wp), intent(out) :: value, slope
        real(wp) :: b1, b2, b3, s1, s2, s3
        integer :: j

        b1 = 0.0_wp
        b2 = 0.0_wp
        s1 = 0.0_wp
        s2 = 0.0_wp
        do j = nodes, 2, -1
            s3 = s2
            s2 = s1
            s1 = 2.0_wp*z*s2 - s3 + 2.0_wp*b1
            b3 = b2
            b2 = b1
            b1 = 2.0_wp*z*b2 - b3 + c(j)
        end do
        value = z*b1 - b2 + c(1)
        slope = z*s1 - s2 + b1
    end subroutine value_and_slope

end module mdrcontact_fit_chebyshev
