! SPDX-License-Identifier: GPL-3.0-or-later
!> Gauss-Legendre nodes as a basis on a panel [0, 1]: quadrature, Legendre coefficients, interpolation.
module mdrcontact_layered_rule
    use mdrcontact_kinds, only: wp
    use mdrcontact_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: rule_t, new_rule, legendre

    !> n nodes.
    type :: rule_t
        integer :: n = 0
        real(wp), allocatable :: nodes(:), weights(:)
        !> coefficients of P_0 ... P_(n-1) (rows) from values at the nodes (columns)
        real(wp), allocatable :: to_legendre(:, :)
        !> extra nodes and weights for integrals of products over a piece of the panel's differences
        real(wp), allocatable :: fine_nodes(:), fine_weights(:)
    end type rule_t

contains

    function new_rule(n) result(self)
        !> 2 to 20, or 32
        integer, intent(in) :: n
        type(rule_t) :: self
        integer :: i, fine

        self%n = n
        ! sizes that GSL has to full precision; those that it computes are good to 1e-10 only
        fine = n + 8
        if (fine > 20) fine = merge(32, 64, fine <= 32)
        allocate (self%nodes(n), self%weights(n), self%to_legendre(n, n), self%fine_nodes(fine), self%fine_weights(fine))
        call gauss_legendre(self%nodes, self%weights)
        call gauss_legendre(self%fine_nodes, self%fine_weights)
        call legendre(self%nodes, self%to_legendre)
        do i = 1, n
            self%to_legendre(i, :) = real(2*i - 1, wp)*self%to_legendre(i, :)*self%weights
        end do
    end function new_rule

    !> P_0 ... P_(m-1) (rows) at positions x (columns) of the panel [0, 1].
    pure subroutine legendre(x, values)
        real(wp), intent(in) :: x(:)
        real(wp), intent(out) :: values(:, :)
        integer :: i, j
        real(wp) :: t

        do j = 1, size(x)
            t = 2.0_wp*x(j) - 1.0_wp
            values(1, j) = 1.0_wp
            if (size(values, 1) > 1) values(2, j) = t
            do i = 2, size(values, 1) - 1
                values(i + 1, j) = (real(2*i - 1, wp)*t*values(i, j) - real(i - 1, wp)*values(i - 1, j))/real(i, wp)
            end do
        end do
    end subroutine legendre

end module mdrcontact_layered_rule
