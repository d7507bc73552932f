! SPDX-License-Identifier: GPL-3.0-or-later
!> Normal matrices by their spectrum: inverses, weak directions and the gain of a Newton step, however nearly singular.
module mdrcontact_fit_spectrum
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_one_thread, only: find_eigenvalues
    implicit none (type, external)
    private
    public :: spectrum_t, new_spectrum, newton_decrement, products

    !> Eigenvalues of the scaled matrix below this are rounding of the derivatives: the data do not determine that direction.
    real(wp), parameter :: smallest_eigenvalue = 1.0e-12_wp
    !> Least variance, of unknowns of order one, in a direction that is not determined.
    real(wp), parameter :: beyond_measure = 1.0e6_wp

    !> A symmetric positive semidefinite matrix, scaled to a unit diagonal, by eigenvalues and eigenvectors.
    type :: spectrum_t
        !> square roots of the diagonal
        real(wp), allocatable :: scale(:)
        !> ascending
        real(wp), allocatable :: eigenvalues(:)
        !> columns
        real(wp), allocatable :: vectors(:, :)
    contains
        procedure :: weakest
        procedure :: inverse
        procedure :: undetermined_spread
    end type spectrum_t

contains

    !> Eigenvalues and eigenvectors, the matrix scaled to a unit diagonal beforehand.
    function new_spectrum(matrix) result(self)
        real(wp), intent(in) :: matrix(:, :)
        type(spectrum_t) :: self
        integer :: i, j, n, info

        n = size(matrix, 1)
        allocate (self%scale(n), self%eigenvalues(n), self%vectors(n, n))
        do i = 1, n
            self%scale(i) = sqrt(matrix(i, i))
            if (.not. self%scale(i) > 0.0_wp) self%scale(i) = 1.0_wp
        end do
        do j = 1, n
            self%vectors(:, j) = matrix(:, j)/(self%scale*self%scale(j))
        end do
        call find_eigenvalues(.true., self%vectors, self%eigenvalues, info)
        if (info /= 0) self%eigenvalues = 0.0_wp
    end function new_spectrum

    !> The smallest eigenvalue, 0 where a direction is not determined.
    pure function weakest(self) result(eigenvalue)
        class(spectrum_t), intent(in) :: self
        real(wp) :: eigenvalue

        eigenvalue = merge(self%eigenvalues(1), 0.0_wp, self%eigenvalues(1) > smallest_eigenvalue)
    end function weakest

    !> The inverse over the directions that are determined.
    pure function inverse(self) result(matrix)
        class(spectrum_t), intent(in) :: self
        real(wp) :: matrix(size(self%scale), size(self%scale))
        integer :: j, k

        matrix = 0.0_wp
        do k = 1, size(self%scale)
            if (.not. self%eigenvalues(k) > smallest_eigenvalue) cycle
            associate (direction => self%vectors(:, k)/self%scale)
                do j = 1, size(self%scale)
                    matrix(:, j) = matrix(:, j) + direction*direction(j)/self%eigenvalues(k)
                end do
            end associate
        end do
    end function inverse

    !> A variance not determined, of unknowns of order one, along the directions that are not determined. Their eigenvalues show
    !> none: they are rounding, and noise that is estimated from too few data isalso.
    pure function undetermined_spread(self) result(matrix)
        class(spectrum_t), intent(in) :: self
        real(wp) :: matrix(size(self%scale), size(self%scale))
        integer :: j, k

        matrix = 0.0_wp
        do k = 1, size(self%scale)
            if (self%eigenvalues(k) > smallest_eigenvalue) cycle
            associate (direction => self%vectors(:, k)/self%scale)
                do j = 1, size(self%scale)
                    matrix(:, j) = matrix(:, j) + direction*direction(j) &
                                   *max(1.0_wp/smallest_eigenvalue, beyond_measure/maxval(abs(direction))**2)
                end do
            end associate
        end do
    end function undetermined_spread

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

    !> g (J^T J)^-1 g with g = J^T r: how much a Newton step along the directions that are determined lowers |r|^2.
    function newton_decrement(jacobian, r, is_held) result(gain)
        real(wp), intent(in) :: jacobian(:, :), r(:)
        !> unknowns that do not move
        logical, intent(in), optional :: is_held(:)
        real(wp) :: gain
        type(spectrum_t) :: spectrum
        real(wp) :: g(size(jacobian, 2)), matrix(size(jacobian, 2), size(jacobian, 2))
        integer :: i

        matrix = products(jacobian)
        do i = 1, size(g)
            g(i) = dot_product(jacobian(:, i), r)
            if (.not. present(is_held)) cycle
            if (.not. is_held(i)) cycle
            g(i) = 0.0_wp
            matrix(i, :) = 0.0_wp
            matrix(:, i) = 0.0_wp
        end do
        spectrum = new_spectrum(matrix)
        g = g/spectrum%scale
        g = matmul(transpose(spectrum%vectors), g)
        gain = sum(g**2/max(spectrum%eigenvalues, smallest_eigenvalue), mask=spectrum%eigenvalues > smallest_eigenvalue)
    end function newton_decrement

end module mdrcontact_fit_spectrum
