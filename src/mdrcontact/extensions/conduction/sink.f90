! SPDX-License-Identifier: GPL-3.0-or-later
!> Layers on an insulating base, whose flux leaves at a sink r = b: the part of the kernel that a sheet of the same conductance
!> along the surface makes,
!>     X_b(y) = [ln(b/(4 H_s)) - Re psi(1 + i y/(2 H_s))]/H_s,
!> exact but for exp(-pi (b - a)/H). Potentials count from the sink: theory/conduction.md (6.1), (6.2).
module mdrcontact_conduction_sink
    use mdrcontact_gsl, only: gsl_sf_psi_1piy
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_kernel, only: degree, kernel_t, near_degree
    use mdrcontact_line_tabulate, only: powers_from_values
    use mdrcontact_numerics_chebyshev, only: node
    implicit none (type, external)
    private
    public :: add_sink

contains

    !> Adds X_b to a kernel, for positions up to 2 b.
    subroutine add_sink(kernel, unit, sheet, b)
        type(kernel_t), intent(inout) :: kernel
        !> thickness of the first layer, H_s and b [length]
        real(wp), intent(in) :: unit, sheet, b
        type(kernel_t) :: before
        real(wp) :: points(degree + 1)
        integer :: octaves, octave, half, i

        before = kernel
        kernel%vanishes = .false.
        kernel%unit = unit
        kernel%plateau = 0
        ! neither of the two constants is taken out: the integral of X_b has no end
        kernel%one_plus_chi_zero = 1.0_wp
        kernel%tail = 0.0_wp
        octaves = max(1, exponent(2.0_wp*b/unit))
        points = node([(i, i=1, size(points))], size(points))
        if (allocated(kernel%coefficients)) deallocate (kernel%coefficients)
        allocate (kernel%coefficients(0:degree, 0:2*octaves))
        kernel%origin = before%origin + at(0.0_wp)
        kernel%coefficients(:, 0) = powers_from_values(sum_at(sqrt(0.5_wp*(1.0_wp + points))) - kernel%origin, near_degree)
        do octave = 0, octaves - 1
            do half = 1, 2
                kernel%coefficients(:, 2*octave + half) = &
                    powers_from_values(sum_at(scale(0.75_wp + 0.5_wp*half + 0.25_wp*points, octave)), degree)
            end do
        end do
        call kernel%integrate()

    contains

        function sum_at(y) result(x)
            real(wp), intent(in) :: y(:)
            real(wp) :: x(size(y))
            integer :: j

            call before%evaluate(y, 0.0_wp, x)
            x = x + [(at(y(j)), j=1, size(y))]
        end function sum_at

        function at(y) result(x)
            real(wp), intent(in) :: y
            real(wp) :: x

            x = unit/sheet*(log(b/(4.0_wp*sheet)) - gsl_sf_psi_1piy(0.5_wp*y*unit/sheet))
        end function at

    end subroutine add_sink

end module mdrcontact_conduction_sink
