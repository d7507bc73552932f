! SPDX-License-Identifier: GPL-3.0-or-later
!> The LAPACK and BLAS calls that the library uses, as explicit interfaces and nothing more.
module mdrcontact_lapack
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: dgeev, dgels, dgemm, dgemv, dgetf2, dgetrf, dpotf2, dpotrs, dspev, dsyev, dtrsm, dtrsv, zgetf2, zgetrf

    interface
        !> Cholesky factor of a symmetric positive definite matrix, column by column.
        subroutine dpotf2(uplo, n, a, lda, info)
            import :: wp
            character(len=1), intent(in) :: uplo
            integer, intent(in) :: n, lda
            real(wp), intent(inout) :: a(lda, *)
            integer, intent(out) :: info
        end subroutine dpotf2

        !> Solves with Cholesky's factor.
        subroutine dpotrs(uplo, n, nrhs, a, lda, b, ldb, info)
            import :: wp
            character(len=1), intent(in) :: uplo
            integer, intent(in) :: n, nrhs, lda, ldb
            real(wp), intent(in) :: a(lda, *)
            real(wp), intent(inout) :: b(ldb, *)
            integer, intent(out) :: info
        end subroutine dpotrs

        !> Eigenvalues, ascending, and eigenvectors of a symmetric matrix.
        subroutine dsyev(jobz, uplo, n, a, lda, w, work, lwork, info)
            import :: wp
            character(len=1), intent(in) :: jobz, uplo
            integer, intent(in) :: n, lda, lwork
            real(wp), intent(inout) :: a(lda, *), work(*)
            real(wp), intent(out) :: w(*)
            integer, intent(out) :: info
        end subroutine dsyev

        !> The same of a matrix whose triangle is packed by columns; z are the eigenvectors.
        subroutine dspev(jobz, uplo, n, ap, w, z, ldz, work, info)
            import :: wp
            character(len=1), intent(in) :: jobz, uplo
            integer, intent(in) :: n, ldz
            real(wp), intent(inout) :: ap(*)
            real(wp), intent(out) :: w(*), z(ldz, *), work(*)
            integer, intent(out) :: info
        end subroutine dspev

        !> Eigenvalues of a matrix, wr + i wi, pairs with the positive imaginary part first.
        subroutine dgeev(jobvl, jobvr, n, a, lda, wr, wi, vl, ldvl, vr, ldvr, work, lwork, info)
            import :: wp
            character(len=1), intent(in) :: jobvl, jobvr
            integer, intent(in) :: n, lda, ldvl, ldvr, lwork
            real(wp), intent(inout) :: a(lda, *), work(*)
            real(wp), intent(out) :: wr(*), wi(*), vl(ldvl, *), vr(ldvr, *)
            integer, intent(out) :: info
        end subroutine dgeev

        !> Least squares for a full-rank a of m >= n rows; the solutions are the first n rows of b.
        subroutine dgels(trans, m, n, nrhs, a, lda, b, ldb, work, lwork, info)
            import :: wp
            character(len=1), intent(in) :: trans
            integer, intent(in) :: m, n, nrhs, lda, ldb, lwork
            real(wp), intent(inout) :: a(lda, *), b(ldb, *), work(*)
            integer, intent(out) :: info
        end subroutine dgels

        !> Triangular factors of a matrix with row interchanges.
        subroutine dgetrf(m, n, a, lda, ipiv, info)
            import :: wp
            integer, intent(in) :: m, n, lda
            real(wp), intent(inout) :: a(lda, *)
            integer, intent(out) :: ipiv(*), info
        end subroutine dgetrf

        !> The same column by column.
        subroutine dgetf2(m, n, a, lda, ipiv, info)
            import :: wp
            integer, intent(in) :: m, n, lda
            real(wp), intent(inout) :: a(lda, *)
            integer, intent(out) :: ipiv(*), info
        end subroutine dgetf2

        !> Triangular factors of a complex matrix with row interchanges.
        subroutine zgetrf(m, n, a, lda, ipiv, info)
            import :: wp
            integer, intent(in) :: m, n, lda
            complex(wp), intent(inout) :: a(lda, *)
            integer, intent(out) :: ipiv(*), info
        end subroutine zgetrf

        !> The same column by column.
        subroutine zgetf2(m, n, a, lda, ipiv, info)
            import :: wp
            integer, intent(in) :: m, n, lda
            complex(wp), intent(inout) :: a(lda, *)
            integer, intent(out) :: ipiv(*), info
        end subroutine zgetf2

        !> Solves with a triangle; x is the right side before.
        subroutine dtrsv(uplo, trans, diag, n, a, lda, x, incx)
            import :: wp
            character(len=1), intent(in) :: uplo, trans, diag
            integer, intent(in) :: n, lda, incx
            real(wp), intent(in) :: a(lda, *)
            real(wp), intent(inout) :: x(*)
        end subroutine dtrsv

        !> Solves with a triangle on the left or on the right of m x n unknowns.
        subroutine dtrsm(side, uplo, transa, diag, m, n, alpha, a, lda, b, ldb)
            import :: wp
            character(len=1), intent(in) :: side, uplo, transa, diag
            integer, intent(in) :: m, n, lda, ldb
            real(wp), intent(in) :: alpha, a(lda, *)
            real(wp), intent(inout) :: b(ldb, *)
        end subroutine dtrsm

        !> Product of matrices, alpha A B + beta C.
        subroutine dgemm(transa, transb, m, n, k, alpha, a, lda, b, ldb, beta, c, ldc)
            import :: wp
            character(len=1), intent(in) :: transa, transb
            integer, intent(in) :: m, n, k, lda, ldb, ldc
            real(wp), intent(in) :: alpha, beta, a(lda, *), b(ldb, *)
            real(wp), intent(inout) :: c(ldc, *)
        end subroutine dgemm

        !> y = alpha a x + beta y, or with a transposed.
        subroutine dgemv(trans, m, n, alpha, a, lda, x, incx, beta, y, incy)
            import :: wp
            character(len=1), intent(in) :: trans
            integer, intent(in) :: m, n, lda, incx, incy
            real(wp), intent(in) :: alpha, beta, a(lda, *), x(*)
            real(wp), intent(inout) :: y(*)
        end subroutine dgemv
    end interface

end module mdrcontact_lapack
