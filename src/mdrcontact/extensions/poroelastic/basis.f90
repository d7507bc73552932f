! SPDX-License-Identifier: GPL-3.0-or-later
!> Even Legendre polynomials p_j(x) = sqrt(4j + 1) P_2j(x), orthonormal on [0, 1], in Fourier space:
!> b_j(k) = int_0^1 p_j cos(kx) dx = (-1)^j sqrt(4j + 1) j_2j(k), at the nodes of a rule in k, and the integrals of functions of k
!> that fall as k^-2 with products of them: theory/poroelastic.md (6.1).
!>
!> Beyond the last node, an odd multiple of pi, cos^2 and sin^2 of the products are replaced by their mean.
module mdrcontact_poroelastic_basis
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lapack, only: dgemm
    use mdrcontact_numerics_even_waves, only: even_waves
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: basis_t, new_basis

    !> Nodes of a panel of one octave below pi, and of 2 pi above it.
    integer, parameter :: per_panel = 14

    !> A rule in k and the b_j at its nodes.
    type :: basis_t
        !> how many j, and nodes
        integer :: order = 0, count = 0
        !> nodes and weights, with the 2/pi of the cosine transform [1/a]
        real(wp), allocatable :: k(:), weight(:)
        !> (order, count): b_j, and the same with b_0 - cos k for b_0, what is left beside the value at the edge
        real(wp), allocatable :: b(:, :), inner(:, :)
        !> abscissae K/t beyond the last node, and their weights; factors of the products there
        real(wp), allocatable :: far(:), far_weight(:)
        real(wp), allocatable :: tail(:, :), inner_tail(:, :)
    contains
        procedure :: project
    end type basis_t

contains

    !> For waves from `shortest`, below which functions of k hardly change, up to `longest`.
    subroutine new_basis(self, order, shortest, longest, error)
        type(basis_t), intent(out) :: self
        integer, intent(in) :: order
        real(wp), intent(in) :: shortest, longest
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: node(per_panel), weight(per_panel), left, right
        integer :: octaves, turns, i

        if (allocated(error)) return
        octaves = max(4, ceiling(log(pi/shortest)/log(2.0_wp)))
        turns = ceiling((longest/pi - 1.0_wp)/2.0_wp)
        self%order = order
        self%count = per_panel*(octaves + 1 + turns)
        allocate (self%k(self%count), self%weight(self%count), self%b(order, self%count), self%inner(order, self%count), &
                  self%far(per_panel), self%far_weight(per_panel), self%tail(order, order), self%inner_tail(order, order))
        call gauss_legendre(node, weight, error)
        if (allocated(error)) return
        right = 0.0_wp
        do i = 0, octaves + turns
            left = right
            right = merge(pi*0.5_wp**(octaves - i), pi*(2*(i - octaves) + 1), i <= octaves)
            self%k(i*per_panel + 1:(i + 1)*per_panel) = left + (right - left)*node
            self%weight(i*per_panel + 1:(i + 1)*per_panel) = (2.0_wp/pi)*(right - left)*weight
        end do
        ! int_K^inf f(k)/k^2 dk = (1/K) int_0^1 f(K/t) dt
        self%far = right/node
        self%far_weight = (2.0_wp/pi)*weight/right
        call fill(self, error)
        call fill_tails(self)
    end subroutine new_basis

    subroutine fill(self, error)
        type(basis_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: waves(self%order)
        integer :: i, j

        do i = 1, self%count
            call even_waves(self%k(i), waves, error)
            if (allocated(error)) return
            self%b(:, i) = waves*sqrt([(4.0_wp*j - 3.0_wp, j=1, self%order)])
            self%inner(:, i) = self%b(:, i)
            self%inner(1, i) = waves(1) - cos(self%k(i))
        end do
    end subroutine fill

    !> b_j = s_j [sin k/k + l_j cos k/k^2], s_j = sqrt(4j + 1), l_j = j (2j + 1), up to terms of k^-3.
    pure subroutine fill_tails(self)
        type(basis_t), intent(inout) :: self
        real(wp) :: s(self%order), l(self%order)
        integer :: i, j

        do j = 1, self%order
            s(j) = sqrt(4.0_wp*j - 3.0_wp)
            l(j) = (j - 1.0_wp)*(2.0_wp*j - 1.0_wp)
        end do
        do j = 1, self%order
            do i = 1, self%order
                self%tail(i, j) = 0.5_wp*s(i)*s(j)
            end do
        end do
        self%inner_tail = self%tail
        ! -cos k times b_j: of sin 2k/k the end at K, 3/(4 K) of a function that falls as k^-2, of cos^2 k/k^2 its mean
        self%inner_tail(1, :) = s*(0.5_wp - 0.75_wp - 0.5_wp*l)
    end subroutine fill_tails

    !> The matrix (2/pi) int f b_i b_j dk of a function at the nodes and far ones.
    subroutine project(self, f, far, is_inner, matrix, error)
        class(basis_t), intent(in) :: self
        complex(wp), intent(in) :: f(:), far(:)
        !> with b_0 - cos k on the left
        logical, intent(in) :: is_inner
        !> (order, order)
        complex(wp), intent(out) :: matrix(:, :)
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: beyond
        real(wp) :: product(2*self%order, self%order)
        real(wp), allocatable :: scaled(:, :)
        integer :: i, n

        matrix = 0.0_wp
        if (allocated(error)) return
        n = self%order
        allocate (scaled(2*n, self%count))
        do i = 1, self%count
            if (is_inner) then
                scaled(:n, i) = self%inner(:, i)*(self%weight(i)*real(f(i), wp))
                scaled(n + 1:, i) = self%inner(:, i)*(self%weight(i)*aimag(f(i)))
            else
                scaled(:n, i) = self%b(:, i)*(self%weight(i)*real(f(i), wp))
                scaled(n + 1:, i) = self%b(:, i)*(self%weight(i)*aimag(f(i)))
            end if
        end do
        call dgemm("N", "T", 2*n, n, self%count, 1.0_wp, scaled, 2*n, self%b, n, 0.0_wp, product, 2*n)
        matrix = cmplx(product(:n, :), product(n + 1:, :), wp)
        beyond = sum(far*self%far_weight)
        if (is_inner) then
            matrix = matrix + beyond*self%inner_tail
        else
            matrix = matrix + beyond*self%tail
        end if
    end subroutine project

end module mdrcontact_poroelastic_basis
