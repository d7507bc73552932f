! SPDX-License-Identifier: GPL-3.0-or-later
!> Scatter of the computed values of a function about a smooth one: rounding, cancellation, an inner iteration.
!>
!> High differences of values at close points keep the scatter and lose the shape. Hamming, Introduction to Applied Numerical
!> Analysis (1971), 6; More, Wild, SIAM J. Sci. Comput. 33 (2011) 1292.
module mdrcontact_numerics_scatter
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: scatter_at

    !> Points, order of the differences, and the factor by which they enlarge the scatter: the root of binomial(12, 6).
    integer, parameter :: points = 12, order = 6
    real(wp), parameter :: enlarged = sqrt(924.0_wp)
    !> Distances of the points relative to x: a corner or a ripple at the widest is smooth at a narrower one, scatter remains.
    real(wp), parameter :: distances(3) = [1.0e-3_wp, 1.0e-5_wp, 1.0e-7_wp]

contains

    !> Standard deviation of the values of f just below x, the middle one of those at the three distances, in the unit of f.
    function scatter_at(f, x, enough) result(deviation)
        class(scalar_function_t), intent(inout) :: f
        !> > 0
        real(wp), intent(in) :: x
        !> relative to f(x): a scatter below it at the widest distance is not considered more closely
        real(wp), intent(in) :: enough
        real(wp) :: deviation
        real(wp) :: values(points), found(size(distances))
        integer :: i, j

        found = 0.0_wp
        do i = 1, size(distances)
            do j = 1, points
                values(j) = f%value(x*(1.0_wp - (j - 1)*distances(i)))
                if (allocated(f%error)) exit
            end do
            deviation = maxval(found)
            if (allocated(f%error)) return
            ! too close for values that stand on steps, as those of R - sqrt(R^2 - r^2) near the axis
            if (i > 1 .and. any(values(2:) == values(:points - 1))) return
            found(i) = scatter_of(values)
            deviation = found(i)
            if (i == 1 .and. deviation <= enough*abs(values(1))) return
        end do
        deviation = sum(found) - maxval(found) - minval(found)
    end function scatter_at

    pure function scatter_of(values) result(deviation)
        real(wp), intent(in) :: values(points)
        real(wp) :: deviation
        real(wp) :: differences(points)
        integer :: i, n

        differences = values
        do i = 1, order
            n = points - i
            differences(:n) = differences(2:n + 1) - differences(:n)
        end do
        deviation = norm2(differences(:points - order))/sqrt(real(points - order, wp))/enlarged
    end function scatter_of

end module mdrcontact_numerics_scatter
