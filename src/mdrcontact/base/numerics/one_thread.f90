! SPDX-License-Identifier: GPL-3.0-or-later
!> Products, systems, factors and eigenvalues of matrices on one thread. OpenBLAS shares dgesv from 24 unknowns on, zgesv from 8,
!> and products of more than 2^18 multiplications among threads, which wait for each other longer than they compute. On 2 processors
!> none of up to 1500 unknowns is faster by that, and the processor time is 1.1 to 100 times as large. The calls below are not
!> shared, and their results do not depend on the number of threads.
module mdrcontact_numerics_one_thread
    use mdrcontact_kinds, only: wp
    use mdrcontact_lapack, only: dgemm, dgemv, dgetf2, dgetrf, dpotf2, dspev, dsyev, dtrsm, dtrsv, zgetf2, zgetrf
    use mdrcontact_nonfinite, only: is_finite
    implicit none (type, external)
    private
    public :: add_product, add_times, factorize_positive, find_eigenvalues, solve

    !> Solves a x = b; b becomes x, and a its factors.
    interface solve
        module procedure :: solve_complex, solve_real, solve_sides
    end interface solve

    !> The most that OpenBLAS does not share: multiplications of a product of matrices and of one with a vector, elements of a
    !> matrix to be factorized, right sides of a triangle, and rows of a symmetric matrix.
    integer, parameter :: unshared = 2**18, unshared_times = 9215, unshared_elements = 9999, unshared_sides = 7, unshared_rows = 5
    !> The fewest terms of a sum that a call adds, and rows and terms of a part where that is too many.
    integer, parameter :: fewest_terms = 16, part = 64
    !> Columns of a panel: of the triangular factors, the fewest, and of Cholesky's.
    integer, parameter :: fewest_columns = 16, columns_of_root = 32

contains

    !> Small imaginary parts, the derivatives of complex steps, keep their digits.
    subroutine solve_complex(a, b, info)
        !> overwritten by its factors
        complex(wp), intent(inout), contiguous :: a(:, :)
        complex(wp), intent(inout), contiguous :: b(:)
        !> not 0: the matrix is singular, or the solution is not finite
        integer, intent(out) :: info
        integer :: pivots(size(b)), i, n

        n = size(b)
        if (n*n <= unshared_elements) then
            call zgetrf(n, n, a, size(a, 1), pivots, info)
        else
            call zgetf2(n, n, a, size(a, 1), pivots, info)
        end if
        if (info /= 0) return
        do i = 1, n
            b([i, pivots(i)]) = b([pivots(i), i])
        end do
        ! not by ztrsv: that of OpenBLAS 0.3.21 reads beyond the end of b from 65 unknowns on
        do i = 1, n
            b(i + 1:) = b(i + 1:) - b(i)*a(i + 1:n, i)
        end do
        do i = n, 1, -1
            b(i) = b(i)/a(i, i)
            b(:i - 1) = b(:i - 1) - b(i)*a(:i - 1, i)
        end do
        if (.not. all(is_finite(real(b, wp)) .and. is_finite(aimag(b)))) info = n + 1
    end subroutine solve_complex

    subroutine solve_real(a, b, info)
        !> overwritten by its factors
        real(wp), intent(inout), contiguous :: a(:, :)
        real(wp), intent(inout), contiguous, target :: b(:)
        !> not 0: the matrix is singular, or the solution is not finite
        integer, intent(out) :: info
        real(wp), pointer, contiguous :: sides(:, :)

        sides(1:size(b), 1:1) => b
        call solve_sides(a, sides, info)
    end subroutine solve_real

    !> Of several right sides.
    subroutine solve_sides(a, b, info)
        !> overwritten by its factors
        real(wp), intent(inout), contiguous :: a(:, :)
        !> (unknown, side)
        real(wp), intent(inout), contiguous :: b(:, :)
        !> not 0: the matrix is singular, or a solution is not finite
        integer, intent(out) :: info
        integer :: pivots(size(b, 1)), j, n

        n = size(b, 1)
        call factorize(n, a, size(a, 1), pivots, info)
        if (info /= 0) return
        do j = 1, size(b, 2)
            call interchange(pivots, 1, b(:, j))
            call dtrsv("L", "N", "U", n, a, size(a, 1), b(:, j), 1)
            call dtrsv("U", "N", "N", n, a, size(a, 1), b(:, j), 1)
        end do
        if (.not. all(is_finite(b))) info = n + 1
    end subroutine solve_sides

    !> Triangular factors with row interchanges, by panels of columns; a matrix that OpenBLAS does not share is one panel.
    subroutine factorize(n, a, rows, pivots, info)
        integer, intent(in) :: n, rows
        real(wp), intent(inout) :: a(rows, *)
        integer, intent(out) :: pivots(:), info
        integer :: i, j, left, next, width

        next = 1
        do
            i = next
            left = n - i + 1
            width = min(left, max(unshared_elements/max(left, 1), fewest_columns))
            if (left*width <= unshared_elements) then
                call dgetrf(left, width, a(i, i), rows, pivots(i:), info)
            else
                call dgetf2(left, width, a(i, i), rows, pivots(i:), info)
            end if
            next = i + width
            pivots(i:next - 1) = pivots(i:next - 1) + i - 1
            if (info /= 0 .or. (width == left .and. i == 1)) return
            do j = 1, n
                if (j < i .or. j >= next) call interchange(pivots(i:next - 1), i, a(:n, j))
            end do
            if (width == left) return
            do j = next, n, unshared_sides
                call dtrsm("L", "L", "N", "U", width, min(unshared_sides, n - j + 1), 1.0_wp, a(i, i), rows, a(i, j), rows)
            end do
            call add_product("N", "N", n - next + 1, n - next + 1, width, -1.0_wp, a(next, i), rows, a(i, next), rows, 1.0_wp, &
                             a(next, next), rows)
        end do
    end subroutine factorize

    !> Row first + i - 1 and row pivots(i), one after another.
    pure subroutine interchange(pivots, first, x)
        integer, intent(in) :: pivots(:), first
        real(wp), intent(inout) :: x(:)
        real(wp) :: kept
        integer :: i

        do i = 1, size(pivots)
            kept = x(first + i - 1)
            x(first + i - 1) = x(pivots(i))
            x(pivots(i)) = kept
        end do
    end subroutine interchange

    !> Cholesky's factor of a positive definite matrix, the first n of its rows, in its lower triangle, by halves.
    recursive subroutine factorize_positive(n, rows, a, info)
        integer, intent(in) :: n, rows
        real(wp), intent(inout) :: a(rows, *)
        !> not 0: the matrix is not positive definite
        integer, intent(out) :: info
        integer :: i, half

        if (n <= columns_of_root) then
            call dpotf2("L", n, a, rows, info)
            return
        end if
        half = n/2
        call factorize_positive(half, rows, a, info)
        if (info /= 0) return
        call divide(n - half, half, rows, a, a(half + 1, 1))
        do i = half + 1, n, part
            call add_product("N", "T", n - i + 1, min(part, n - i + 1), half, -1.0_wp, a(i, 1), rows, a(i, 1), rows, &
                             1.0_wp, a(i, i), rows)
        end do
        call factorize_positive(n - half, rows, a(half + 1, half + 1), info)
    end subroutine factorize_positive

    !> B becomes B inv(L)^T, L the lower triangle of a matrix; both are parts of matrices with so many rows.
    recursive subroutine divide(m, n, rows, l, b)
        integer, intent(in) :: m, n, rows
        real(wp), intent(in) :: l(rows, *)
        real(wp), intent(inout) :: b(rows, *)
        integer :: half

        if (n <= unshared_sides) then
            call dtrsm("R", "L", "T", "N", m, n, 1.0_wp, l, rows, b, rows)
            return
        end if
        half = n/2
        call divide(m, half, rows, l, b)
        call add_product("N", "T", m, n - half, half, -1.0_wp, b, rows, l(half + 1, 1), rows, 1.0_wp, b(1, half + 1), rows)
        call divide(m, n - half, rows, l(half + 1, half + 1), b(1, half + 1))
    end subroutine divide

    !> Eigenvalues, ascending, of a symmetric matrix, of which the upper triangle is read. Packed, matrices of up to 50 rows are not
    !> shared.
    subroutine find_eigenvalues(with_vectors, a, eigenvalues, info)
        logical, intent(in) :: with_vectors
        !> becomes the eigenvectors, or is lost
        real(wp), intent(inout) :: a(:, :)
        real(wp), intent(out) :: eigenvalues(:)
        !> not 0: no convergence
        integer, intent(out) :: info
        real(wp) :: packed(size(a, 1)*(size(a, 1) + 1)/2), vectors(size(a, 1), size(a, 1)), work(34*size(a, 1))
        integer :: j, n

        n = size(a, 1)
        if (n <= unshared_rows) then
            call dsyev(merge("V", "N", with_vectors), "U", n, a, n, eigenvalues, work, size(work), info)
            return
        end if
        do j = 1, n
            packed(j*(j - 1)/2 + 1:j*(j + 1)/2) = a(:j, j)
        end do
        call dspev(merge("V", "N", with_vectors), "U", n, packed, eigenvalues, vectors, n, work, info)
        if (with_vectors) a(:, :) = vectors
    end subroutine find_eigenvalues

    !> y becomes y + alpha A x, or with A transposed, with the arguments of dgemv.
    subroutine add_times(trans, m, n, alpha, a, lda, x, y)
        character(len=1), intent(in) :: trans
        integer, intent(in) :: m, n, lda
        real(wp), intent(in) :: alpha, a(lda, *), x(*)
        real(wp), intent(inout) :: y(*)
        integer :: columns, j

        columns = max(1, unshared_times/max(m, 1))
        do j = 1, n, columns
            call dgemv(trans, m, min(columns, n - j + 1), alpha, a(1, j), lda, x(merge(j, 1, trans == "N")), 1, 1.0_wp, &
                       y(merge(1, j, trans == "N")), 1)
        end do
    end subroutine add_times

    !> C becomes alpha A B + beta C, with the arguments of dgemm. The sums are in parts, so that their last digits differ from its.
    subroutine add_product(transa, transb, m, n, k, alpha, a, lda, b, ldb, beta, c, ldc)
        character(len=1), intent(in) :: transa, transb
        integer, intent(in) :: m, n, k, lda, ldb, ldc
        real(wp), intent(in) :: alpha, a(lda, *), b(ldb, *), beta
        real(wp), intent(inout) :: c(ldc, *)
        integer :: i, j, first, rows, columns, terms

        rows = max(m, 1)
        columns = max(n, 1)
        if (real(m, wp)*real(n, wp)*real(min(k, fewest_terms), wp) > real(unshared, wp)) then
            columns = min(columns, part)
            rows = min(rows, unshared/(columns*min(k, part)))
        end if
        terms = max(min(k, unshared/(rows*columns)), 1)
        do first = 1, max(k, 1), terms
            do j = 1, n, columns
                do i = 1, m, rows
                    call dgemm(transa, transb, min(rows, m - i + 1), min(columns, n - j + 1), min(terms, k - first + 1), alpha, &
                               a(merge(i, first, transa == "N"), merge(first, i, transa == "N")), lda, &
                               b(merge(first, j, transb == "N"), merge(j, first, transb == "N")), ldb, &
                               merge(beta, 1.0_wp, first == 1), c(i, j), ldc)
                end do
            end do
        end do
    end subroutine add_product

end module mdrcontact_numerics_one_thread
