! SPDX-License-Identifier: GPL-3.0-or-later
!> Normal matrices by their spectrum: inverses, weak directions and the gain of a Newton step, however nearly singular.
module mdrcontact_fit_spectrum
    use mdrcontact_kinds, only: wp
    use mdrcontact_lapack, only: dsyev
    implicit none (type, external)
    private
    public :: spectrum_t, new_spectrum, newton_decrement, products

    !> Eigenvalues of the scaled matrix below this are rounding: the direction is not determined at all.
    real(wp), parameter :: smallest_eigenvalue = 1.0e-15_wp
    !> A step along directions below this one is left out of the gain: the data do not determine them.
    real(wp), parameter :: undetermined = 1.0e-12_wp

    !> A symmetric positive semidefinite matrix, scaled to a unit diagonal, by eigenvalues and eigenvectors.
    type :: spectrum_t
        !> square roots of the diagonal
        real(wp), allocatable :: scale(:)
        !> ascending
        real(wp), allocatable :: eigenvalues(:)
        !> columns
        real(wp), allocatable :: vectors(:, :)
    contains
        procedure :: inverse
    end type spectrum_t

contains

    !> Eigenvalues and eigenvectors, the matrix scaled to a unit diagonal beforehand.
    function new_spectrum(matrix) result(self)
        real(wp), intent(in) :: matrix(:, :)
        type(spectrum_t) :: self
        real(wp), allocatable :: work(:)
        integer :: i, j, n, info

        n = size(matrix, 1)
        allocate (self%scale(n), self%eigenvalues(n), self%vectors(n, n), work(max(1, 34*n)))
        do i = 1, n
            self%scale(i) = sqrt(matrix(i, i))
            if (.not. self%scale(i) > 0.0_wp) self%scale(i) = 1.0_wp
        end do
        do j = 1, n
            self%vectors(:, j) = matrix(:, j)/(self%scale*self%scale(j))
        end do
        call dsyev("V", "U", n, self%vectors, n, self%eigenvalues, work, size(work), info)
        if (info /= 0) self%eigenvalues = 0.0_wp
    end function new_spectrum

    !> The inverse. A direction that is not determined gets a variance beyond all measure instead of none.
    pure function inverse(self) result(matrix)
        class(spectrum_t), intent(in) :: self
        real(wp) :: matrix(size(self%scale), size(self%scale))
        integer :: i, j, k

        matrix = 0.0_wp
        do k = 1, size(self%scale)
            do j = 1, size(self%scale)
                do i = 1, size(self%scale)
                    matrix(i, j) = matrix(i, j) + self%vectors(i, k)*self%vectors(j, k) &
                                   /(max(self%eigenvalues(k), smallest_eigenvalue)*self%scale(i)*self%scale(j))
                end do
            end do
        end do
    end function inverse

    !> J^T J of a tall J. matmul takes memory for a copy of it, without a status.
    pure function products(jacobian) result(matrix)
        real(wp), intent(in) :: jacobian(:, :)
        real(wp) :: matrix(size(jacobian, 2), size(jacobian, 2))
        integer :: i, j

        do j = 1, size(matrix, 2)
            do i = 1, j
                matrix(i, j) = dot_product(jacobian(:, i), jacobian(:, j))
                matrix(j, i) = matrix(i, j)
            end do
        end do
    end function products

    !> g (J^T J)^-1 g with g = J^T r: how much a Newton step lowers |r|^2.
    function newton_decrement(jacobian, r) result(gain)
        real(wp), intent(in) :: jacobian(:, :), r(:)
        real(wp) :: gain
        type(spectrum_t) :: spectrum
        real(wp) :: g(size(jacobian, 2))
        integer :: i

        spectrum = new_spectrum(products(jacobian))
        do i = 1, size(g)
            g(i) = dot_product(jacobian(:, i), r)/spectrum%scale(i)
        end do
        g = matmul(transpose(spectrum%vectors), g)
        gain = sum(g**2/max(spectrum%eigenvalues, smallest_eigenvalue), mask=spectrum%eigenvalues > undetermined)
    end function newton_decrement

end module mdrcontact_fit_spectrum
