! SPDX-License-Identifier: GPL-3.0-or-later
!> The LAPACK and BLAS calls that the library uses, as explicit interfaces and nothing more.
module mdrcontact_lapack
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: dgeev, dgels, dgemm, dgemv, dgesv, dpotrf, dpotrs, dsyev

    interface
        !> Cholesky factor of a symmetric positive definite matrix.
        subroutine dpotrf(uplo, n, a, lda, info)
            import :: wp
            character(len=1), intent(in) :: uplo
            integer, intent(in) :: n, lda
            real(wp), intent(inout) :: a(lda, *)
            integer, intent(out) :: info
        end subroutine dpotrf

        !> Solves with that factor.
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

        !> Solves a x = b; b becomes x.
        subroutine dgesv(n, nrhs, a, lda, ipiv, b, ldb, info)
            import :: wp
            integer, intent(in) :: n, nrhs, lda, ldb
            real(wp), intent(inout) :: a(lda, *), b(ldb, *)
            integer, intent(out) :: ipiv(*), info
        end subroutine dgesv

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
