! SPDX-License-Identifier: GPL-3.0-or-later
!> Whether residuals along a curve are random. Few of them: the exact distribution of the ratio of squared successive differences
!> to squares, given the derivatives of the model, for independent normal noise. J. Durbin, G. S. Watson, Biometrika 37 (1950) 409;
!> J. P. Imhof, Biometrika 48 (1961) 419. Many: Bartels' rank version of von Neumann's ratio. R. Bartels, J. Am. Stat. Assoc. 77
!> (1982) 40; its beta approximation, section 3.
module mdrcontact_fit_pattern
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_fit_order, only: ascending
    use mdrcontact_fit_spectrum, only: new_spectrum, products, spectrum_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_one_thread, only: find_eigenvalues
    implicit none (type, external)
    private
    public :: difference_test, pattern_test

    !> With fewer points no order of the residuals is improbable.
    integer, parameter :: fewest_points = 8

    !> Eigenvalues of a quadratic form that are smaller, relative to the largest, are rounding.
    real(wp), parameter :: smallest_form = 1.0e-12_wp
    !> Trapezoidal rule in the logarithm of Imhof's variable: step, start, end, and a negligible integrand.
    real(wp), parameter :: step = 0.25_wp, begin = -40.0_wp, end = 200.0_wp, negligible = 1.0e-17_wp

    interface
        pure function gsl_cdf_beta_p(x, a, b) result(p) bind(C, name="gsl_cdf_beta_P")
            import :: c_double
            real(c_double), value :: x, a, b
            real(c_double) :: p
        end function gsl_cdf_beta_p
    end interface

contains

    !> The probability that independent normal noise leaves residuals that follow each other as smoothly; 1 where fewer than two
    !> directions of them are left.
    subroutine difference_test(residuals, jacobian, prior_jacobian, probability)
        !> in their order along the curve, in their standard deviations
        real(wp), intent(in) :: residuals(:)
        !> (residuals, parameters) and (priors, parameters): the derivatives
        real(wp), intent(in) :: jacobian(:, :), prior_jacobian(:, :)
        real(wp), intent(out) :: probability
        real(wp) :: root(size(residuals), size(residuals)), form(size(residuals), size(residuals)), eigenvalues(size(residuals))
        real(wp) :: ratio
        type(spectrum_t) :: spectrum
        integer :: i, n, info

        probability = 1.0_wp
        n = size(residuals)
        if (n < 3 .or. .not. sum(residuals**2) > 0.0_wp) return
        ratio = sum((residuals(2:) - residuals(:n - 1))**2)/sum(residuals**2)
        ! the covariance of the residuals, and its root
        spectrum = new_spectrum(products(jacobian) + products(prior_jacobian))
        root = -matmul(jacobian, matmul(spectrum%inverse(), transpose(jacobian)))
        do i = 1, n
            root(i, i) = root(i, i) + 1.0_wp
        end do
        call find_eigenvalues(.true., root, eigenvalues, info)
        if (info /= 0) return
        do i = 1, n
            root(:, i) = root(:, i)*sqrt(max(eigenvalues(i), 0.0_wp))
        end do
        form = products(root(2:, :) - root(:n - 1, :)) - ratio*products(root)
        call find_eigenvalues(.false., form, eigenvalues, info)
        if (info /= 0) return
        associate (left => pack(eigenvalues, abs(eigenvalues) > smallest_form*maxval(abs(eigenvalues))))
            if (size(left) >= 2) probability = negative_form(left)
        end associate
    end subroutine difference_test

    !> The probability that a sum of squares of independent normal variates, times these factors, is less than 0.
    pure function negative_form(factors) result(probability)
        real(wp), intent(in) :: factors(:)
        real(wp) :: probability
        real(wp) :: x, u(size(factors)), damping, total

        total = 0.0_wp
        x = begin
        do while (x < end)
            u = factors/maxval(abs(factors))*exp(x)
            damping = exp(-0.25_wp*sum(log(1.0_wp + u**2)))
            total = total + sin(0.5_wp*sum(atan(u)))*damping
            if (damping < negligible) exit
            x = x + step
        end do
        probability = min(max(0.5_wp - step*total/pi, 0.0_wp), 1.0_wp)
    end function negative_form

    !> The probability that random residuals follow each other as smoothly as these; 1 for fewer than 8.
    pure subroutine pattern_test(residuals, probability, error)
        !> in their order along the curve
        real(wp), contiguous, intent(in) :: residuals(:)
        real(wp), intent(out) :: probability
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: rank(:)
        real(wp) :: n, shape, x

        probability = 1.0_wp
        if (size(residuals) < fewest_points .or. maxval(residuals) <= minval(residuals)) return
        n = real(size(residuals), wp)
        call find_ranks(residuals, rank, error)
        if (allocated(error)) return
        x = 0.25_wp*sum((rank(2:) - rank(:size(rank) - 1))**2)/sum((rank - 0.5_wp*(n + 1.0_wp))**2)
        ! x is distributed like beta(shape, shape)
        shape = 2.5_wp*n*(n + 1.0_wp)*(n - 1.0_wp)**2/((n - 2.0_wp)*(5.0_wp*n**2 - 2.0_wp*n - 9.0_wp)) - 0.5_wp
        if ((4.0_wp*x*max(1.0_wp - x, 0.0_wp))**shape > tiny(x)) then
            probability = gsl_cdf_beta_p(x, shape, shape)
        else
            ! GSL would divide by a density of 0
            probability = merge(0.0_wp, 1.0_wp, x < 0.5_wp)
        end if
    end subroutine pattern_test

    !> Ranks from 1; equal values share the mean of theirs.
    pure subroutine find_ranks(values, rank, error)
        real(wp), contiguous, intent(in) :: values(:)
        real(wp), allocatable, intent(out) :: rank(:)
        type(error_t), allocatable, intent(inout) :: error
        integer, allocatable :: order(:)
        integer :: first, last, stat

        allocate (rank(size(values)), stat=stat)
        call check_memory(error, stat)
        if (.not. allocated(error)) call ascending(values, order, error)
        if (allocated(error)) return
        first = 1
        do while (first <= size(values))
            last = first
            do while (last < size(values))
                if (values(order(last + 1)) > values(order(first))) exit
                last = last + 1
            end do
            rank(order(first:last)) = 0.5_wp*(first + last)
            first = last + 1
        end do
    end subroutine find_ranks

end module mdrcontact_fit_pattern
