! SPDX-License-Identifier: GPL-3.0-or-later
!> Linear algebra of small matrices on one thread. OpenBLAS shares the factors of any complex matrix, and products of 2^18
!> multiplications, among threads, which wait for each other longer than they compute.
module mdrcontact_numerics_one_thread
    use mdrcontact_kinds, only: wp
    use mdrcontact_lapack, only: dgemm
    implicit none (type, external)
    private
    public :: add_product, solve_complex

    !> Multiplications of a call that OpenBLAS does not share, and the fewest terms of a sum that a call adds: products of larger
    !> matrices gain from threads.
    integer, parameter :: unshared = 2**18, fewest_terms = 16

contains

    !> Solves a x = b by Gaussian elimination with row interchanges; b becomes x. Small imaginary parts, the derivatives of complex
    !> steps, keep their digits.
    pure subroutine solve_complex(n, a, b, info)
        integer, intent(in) :: n
        !> overwritten by its factors
        complex(wp), intent(inout) :: a(:, :)
        complex(wp), intent(inout) :: b(:)
        !> not 0: the matrix is singular
        integer, intent(out) :: info
        complex(wp) :: factor(n)
        integer :: i, j, pivot

        do info = 1, n
            i = info
            pivot = i - 1 + maxloc(abs(real(a(i:n, i), wp)) + abs(aimag(a(i:n, i))), dim=1)
            if (.not. abs(a(pivot, i)) > 0.0_wp) return
            a([i, pivot], i:n) = a([pivot, i], i:n)
            b([i, pivot]) = b([pivot, i])
            factor(i + 1:) = a(i + 1:n, i)/a(i, i)
            do j = i + 1, n
                a(i + 1:n, j) = a(i + 1:n, j) - factor(i + 1:)*a(i, j)
            end do
            b(i + 1:n) = b(i + 1:n) - factor(i + 1:)*b(i)
        end do
        info = 0
        do i = n, 1, -1
            b(i) = b(i)/a(i, i)
            b(:i - 1) = b(:i - 1) - b(i)*a(:i - 1, i)
        end do
    end subroutine solve_complex

    !> C becomes alpha A B + beta C, with the arguments of dgemm. The sums are in parts, so that their last digits differ from its.
    subroutine add_product(transa, transb, m, n, k, alpha, a, lda, b, ldb, beta, c, ldc)
        character(len=1), intent(in) :: transa, transb
        integer, intent(in) :: m, n, k, lda, ldb, ldc
        real(wp), intent(in) :: alpha, a(lda, *), b(ldb, *), beta
        real(wp), intent(inout) :: c(ldc, *)
        integer :: first, terms

        terms = k
        if (real(m, wp)*real(n, wp)*real(fewest_terms, wp) <= real(unshared, wp)) terms = min(k, unshared/max(m*n, 1))
        do first = 1, max(k, 1), max(terms, 1)
            call dgemm(transa, transb, m, n, min(terms, k - first + 1), alpha, &
                       a(merge(1, first, transa == "N"), merge(first, 1, transa == "N")), lda, &
                       b(merge(first, 1, transb == "N"), merge(1, first, transb == "N")), ldb, &
                       merge(beta, 1.0_wp, first == 1), c, ldc)
        end do
    end subroutine add_product

end module mdrcontact_numerics_one_thread
