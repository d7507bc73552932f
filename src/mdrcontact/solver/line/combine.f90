! SPDX-License-Identifier: GPL-3.0-or-later
!> The kernel of two deformable bodies that touch (theory/exact.md (5.1)): k C = k C_1 + k C_2, so that
!> X = E0* (X_1/E_1* + X_2/E_2*).
!>
!> Each body's kernel belongs to its layers alone: where the moduli of one body change, that body alone is tabulated anew.
module mdrcontact_line_combine
    use mdrcontact_error, only: error_domain, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_kernel, only: degree, kernel_t, near_degree
    use mdrcontact_line_tabulate, only: powers_from_values, stiff
    use mdrcontact_numerics_chebyshev, only: node
    implicit none (type, external)
    private
    public :: add_kernels

    !> Largest number of octaves of y.
    integer, parameter :: most_octaves = 256

contains

    !> The kernel of two bodies, the sum of theirs with these weights. The table of the sum is no longer than theirs and costs no
    !> more to evaluate; it is made of their values alone.
    subroutine add_kernels(first, second, weights, kernel, error)
        type(kernel_t), intent(in) :: first, second
        !> E0*/E_i* of each body: 0 for a rigid one, together 1
        real(wp), intent(in) :: weights(2)
        type(kernel_t), intent(out) :: kernel
        type(error_t), allocatable, intent(inout) :: error

        if (first%vanishes .or. weights(1) <= 0.0_wp) then
            kernel = second
            call scale_kernel(kernel, weights(2), weights(1))
        else if (second%vanishes .or. weights(2) <= 0.0_wp) then
            kernel = first
            call scale_kernel(kernel, weights(1), weights(2))
        else
            call fill_sum(first, second, weights, kernel, error)
        end if
    end subroutine add_kernels

    !> The other body is homogeneous, or rigid.
    pure subroutine scale_kernel(kernel, weight, other)
        type(kernel_t), intent(inout) :: kernel
        real(wp), intent(in) :: weight, other

        kernel%vanishes = kernel%vanishes .or. weight <= 0.0_wp
        if (kernel%vanishes) return
        kernel%origin = weight*kernel%origin
        kernel%one_plus_chi_zero = weight*kernel%one_plus_chi_zero + other
        kernel%coefficients = weight*kernel%coefficients
        kernel%tail = weight*kernel%tail
        kernel%rest = weight*kernel%rest
    end subroutine scale_kernel

    subroutine fill_sum(first, second, weights, kernel, error)
        type(kernel_t), intent(in) :: first, second
        real(wp), intent(in) :: weights(2)
        type(kernel_t), intent(inout) :: kernel
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: x(degree + 1), ratios(2), points(degree + 1)
        real(wp), allocatable :: centred(:, :)
        integer :: octaves, octave, part, parts, i
        logical :: on_plateau

        points = node([(i, i=1, size(points))], size(points))
        kernel%unit = min(first%unit, second%unit)
        kernel%vanishes = .false.
        kernel%halvings = max(first%halvings, second%halvings)
        parts = kernel%parts()
        allocate (centred(degree + 1, parts))
        kernel%resolved = min(first%resolved*(first%unit/kernel%unit), second%resolved*(second%unit/kernel%unit))
        kernel%origin = weights(1)*first%origin*(kernel%unit/first%unit) + weights(2)*second%origin*(kernel%unit/second%unit)
        kernel%one_plus_chi_zero = weights(1)*first%one_plus_chi_zero + weights(2)*second%one_plus_chi_zero
        ! their units in the unit of the sum
        ratios = [first%unit, second%unit]/kernel%unit
        octaves = max(first%octaves() + exponent(nearest(ratios(1), -1.0_wp)), &
                      second%octaves() + exponent(nearest(ratios(2), -1.0_wp)))
        if (octaves > most_octaves) then
            call raise(error, error_domain, "the thinnest layers of the two bodies, "//to_text(first%unit)//" and "// &
                       to_text(second%unit)//", differ by too much. Omit the thinner one")
            return
        end if
        allocate (kernel%coefficients(0:degree, 0:parts*octaves))
        kernel%coefficients(:, 0) = powers_from_values(sum_at(sqrt(0.5_wp*(1.0_wp + points)), .true.), near_degree)
        on_plateau = kernel%one_plus_chi_zero > stiff
        do octave = 0, octaves - 1
            if (on_plateau) then
                do part = 1, parts
                    centred(:, part) = sum_at(positions(part), .true.)
                end do
                on_plateau = maxval(abs(centred)) <= 0.5_wp*kernel%origin
                if (on_plateau) kernel%plateau = octave + 1
            end if
            do part = 1, parts
                x = sum_at(positions(part), on_plateau)
                kernel%coefficients(:, parts*octave + part) = powers_from_values(x, degree)
            end do
        end do
        kernel%tail = weights(1)*first%tail*[ratios(1), ratios(1)**3] + weights(2)*second%tail*[ratios(2), ratios(2)**3]
        call kernel%integrate()

    contains

        !> The nodes of a part of this octave.
        function positions(part) result(y)
            integer, intent(in) :: part
            real(wp) :: y(size(points))

            y = scale((1.0_wp + real(2*part - 1, wp)/real(2*parts, wp)) + points/real(2*parts, wp), octave)
        end function positions

        !> X, or X - X(0).
        function sum_at(y, is_centred) result(values)
            real(wp), intent(in) :: y(:)
            logical, intent(in) :: is_centred
            real(wp) :: values(size(y))
            real(wp) :: one(size(y)), other(size(y))

            call first%evaluate(y/ratios(1), merge(first%origin, 0.0_wp, is_centred), one)
            call second%evaluate(y/ratios(2), merge(second%origin, 0.0_wp, is_centred), other)
            values = weights(1)/ratios(1)*one + weights(2)/ratios(2)*other
        end function sum_at

    end subroutine fill_sum

end module mdrcontact_line_combine
