! SPDX-License-Identifier: GPL-3.0-or-later
!> The inverse Laplace transform by nodes on a parabola (Weideman, Trefethen, Math. Comp. 76 (2007) 1341), for transforms whose
!> singularities lie on the negative axis (theory/conduction.md (9.4), theory/poroelastic.md (6.2), theory/time.md (4.3)).
module mdrcontact_numerics_laplace
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: inverse_laplace

contains

    !> Nodes and weights: f(t) = Im sum w_j F(s_j) of the transform F(s)/s, with an error of exp(-2 pi n/sqrt(8 r + 1)) by n nodes
    !> for times up to a factor r apart.
    pure subroutine inverse_laplace(time, s, weight)
        !> > 0
        real(wp), intent(in) :: time(:)
        complex(wp), intent(out) :: s(:)
        !> (node, time)
        complex(wp), intent(out) :: weight(:, :)
        real(wp) :: last, root, width, opening
        complex(wp) :: turn, z
        integer :: j, n

        n = size(s)
        last = maxval(time)
        root = sqrt(8.0_wp*(last/minval(time)) + 1.0_wp)
        width = root/real(n, wp)
        opening = pi*real(n, wp)/(4.0_wp*root)
        do j = 1, n
            turn = cmplx(1.0_wp, (real(j, wp) - 0.5_wp)*width, wp)
            z = opening*turn**2
            s(j) = z/last
            weight(j, :) = exp(z*(time/last))/z*(0.0_wp, 2.0_wp)*opening*turn*(width/pi)
        end do
    end subroutine inverse_laplace

end module mdrcontact_numerics_laplace
