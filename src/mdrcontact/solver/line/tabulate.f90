! SPDX-License-Identifier: GPL-3.0-or-later
!> Tabulates the kernel X(y) from the surface compliance chi(k).
!>
!> X(y) = Re int chi(k) exp(iky) dk along a ray k = t exp(i theta) in the sector where chi is analytic: the integrand decays and
!> hardly oscillates, at every y. For y > 0 the constant chi(0) contributes nothing, so that chi(k) - chi(0) may represent chi(k): X
!> keeps its relative precision in its tail. Near the origin X(y) - X(0) is integrated instead, along the real axis. Wavenumbers and
!> positions both run in octaves, so one small table of exp(iky) serves all pairs of octaves.
module mdrcontact_line_tabulate
    use mdrcontact_body_compliance, only: compliance_t
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: error_no_convergence, error_t, raise
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lapack, only: dgemv
    use mdrcontact_line_kernel, only: degree, kernel_t, near_degree
    use mdrcontact_line_ray, only: extend_ray, path_holds, ray_t, rest_below, start_ray, take_chi_moments
    use mdrcontact_line_waves, only: first_wave, new_wave_table, order, wave_table_t
    use mdrcontact_numerics_chebyshev, only: series_of_values
    implicit none (type, external)
    private
    public :: tabulate_kernel, attempts, elastic_misfit, powers_from_values, stiff

    !> Largest number of octaves of y.
    integer, parameter :: most_octaves = 128
    !> From this 1 + chi(0) on rounding of X(0) would be seen in d and F; and octaves of y in which X may be X(0) and little less.
    real(wp), parameter :: stiff = 1.0e3_wp
    integer, parameter :: most_plateau = 40
    !> A body deeper than so many octaves of its first layer varies with depth: its X varies all over the plateau.
    integer, parameter :: deepest_plateau = 36
    !> Largest error of chi in the table of an elastic body, in parts of its largest value.
    real(wp), parameter :: elastic_misfit = 1.0e-10_wp
    !> Largest depth, in thicknesses of the first layer, at which a body counts as layered and not as graded.
    real(wp), parameter :: coarse = 100.0_wp
    !> Rays tried in turn, pi/denominator, panels in an octave of wavenumbers on each, and how often halves of octaves are halved.
    !> The last ones are for layers, much stiffer in shear than along their normal, whose waves exp(-lambda k z) oscillate more
    !> than they decay.
    integer, parameter :: ray_denominator(*) = [6, 6, 12, 24, 12, 24, 24, 48], ray_panels(*) = [1, 2, 3, 6, 3, 6, 6, 12], &
                          ray_halvings(*) = [0, 0, 0, 0, 1, 1, 2, 2]
    !> Number of rays.
    integer, parameter :: attempts = size(ray_panels)

contains

    !> The table of X for a compliance that is real on the real axis.
    subroutine tabulate_kernel(kernel, surface, tables, allowed, error)
        type(kernel_t), intent(out) :: kernel
        class(compliance_t), intent(in) :: surface
        !> what bodies share; filled as far as it is needed
        type(wave_table_t), intent(inout) :: tables(attempts)
        !> largest error of chi, in parts of its largest value
        real(wp), intent(in) :: allowed
        type(error_t), allocatable, intent(out) :: error
        type(ray_t) :: ray
        integer :: attempt
        logical :: holds

        kernel%vanishes = .not. surface%first_depth > 0.0_wp
        if (kernel%vanishes) return
        kernel%unit = surface%first_depth
        kernel%resolved = merge(1.0_wp, huge(1.0_wp), surface%last_depth <= coarse*kernel%unit)
        kernel%one_plus_chi_zero = real(surface%at_zero, wp)
        do attempt = 1, attempts
            call check_cancelled(error)
            if (allocated(error)) return
            if (.not. tables(attempt)%is_made()) then
                call new_wave_table(tables(attempt), pi/real(ray_denominator(attempt), wp), ray_panels(attempt), &
                                    ray_halvings(attempt), error)
                if (allocated(error)) return
            end if
            call start_ray(ray, surface, kernel%unit, tables(attempt), most_octaves)
            call path_holds(ray, surface, kernel%unit, tables(attempt), holds)
            if (.not. holds) cycle
            call fill_table(kernel, ray, surface, tables(attempt))
            if (ray%roughness < 3.0e-8_wp .and. max(abs(kernel%defect()), kernel%misfit()) < allowed*(1.0_wp + ray%largest)) return
        end do
        call raise(error, error_no_convergence, "the surface compliance of this body could not be integrated over all wavelengths")
    end subroutine tabulate_kernel

    subroutine fill_table(kernel, ray, surface, table)
        type(kernel_t), intent(inout) :: kernel
        type(ray_t), intent(inout) :: ray
        class(compliance_t), intent(in) :: surface
        type(wave_table_t), intent(in) :: table
        integer, parameter :: n = degree + 1
        real(wp), dimension(size(table%far_y)) :: x, inverse
        real(wp), allocatable :: coefficients(:, :)
        integer :: octave, part, parts
        logical :: on_plateau
        real(wp) :: level, slope, spread, middle

        kernel%halvings = table%halvings
        parts = kernel%parts()
        allocate (coefficients(0:degree, 0:parts*most_octaves))
        kernel%origin = ray%origin
        call near_values(ray, table, table%near_y, x(:n))
        coefficients(:, 0) = powers_from_values(x(:n), near_degree)
        kernel%plateau = 0
        middle = sum(1.0_wp/table%far_y**2)/real(size(x), wp)
        inverse = 1.0_wp/table%far_y**2 - middle
        on_plateau = kernel%one_plus_chi_zero > stiff .and. surface%last_depth < scale(kernel%unit, deepest_plateau)
        if (on_plateau) call take_chi_moments(ray, table)
        do octave = 0, most_octaves - 1
            call extend_ray(ray, surface, kernel%unit, table, ray%lowest - octave)
            if (on_plateau) then
                if (octave < 2) then
                    call near_values(ray, table, scale(table%far_y, octave), x)
                else
                    call plateau_values(ray, table, octave, x)
                end if
                on_plateau = maxval(abs(x)) <= 0.5_wp*ray%origin .and. octave < most_plateau
            end if
            if (on_plateau) then
                kernel%plateau = octave + 1
            else
                call far_values(ray, table, octave, x)
            end if
            do part = 1, parts
                coefficients(:, parts*octave + part) = powers_from_values(x((part - 1)*n + 1:part*n), degree)
            end do
            if (on_plateau) cycle
            ! the straight line in 1/y^2 that y^2 X becomes, chi being a power series at long waves
            x = x*table%far_y**2
            slope = sum(inverse*x)/sum(inverse**2)
            level = sum(x)/real(size(x), wp)
            spread = maxval(abs(x - level - slope*inverse))
            level = level - slope*middle
            kernel%tail = [level*scale(1.0_wp, 2*octave), slope*scale(1.0_wp, 4*octave)]
            ! not before the whole body has shown
            if (scale(kernel%unit, octave) < surface%last_depth) cycle
            if (spread <= 1.0e-13_wp*maxval(abs(x)) .or. spread <= 1.0e-14_wp*scale(abs(kernel%one_plus_chi_zero), -octave)) exit
        end do
        octave = min(octave, most_octaves - 1)
        if (allocated(kernel%coefficients)) deallocate (kernel%coefficients)
        allocate (kernel%coefficients(0:degree, 0:parts*(octave + 1)))
        kernel%coefficients(:, :) = coefficients(:, :parts*(octave + 1))
        call kernel%integrate()
    end subroutine fill_table

    !> X - X(0) near the origin, along the real axis: cos(ky) - 1 = -2 sin^2(ky/2).
    subroutine near_values(ray, table, y, x)
        type(ray_t), intent(in) :: ray
        type(wave_table_t), intent(in) :: table
        !> positions up to 4, in which chi fades before the nodes do not resolve the cosine
        real(wp), intent(in) :: y(:)
        real(wp), intent(out) :: x(:)
        real(wp) :: moments(3)
        integer :: i, octave, kept

        ! below the lowest octave chi is chi(0)
        moments = [(ray%chi_zero*scale(1.0_wp, (2*i + 1)*ray%lowest)/real(2*i + 1, wp), i=1, 3)]
        do octave = ray%lowest, min(first_wave, ray%top + 1) - 1
            do i = 1, 3
                moments(i) = moments(i) + scale(1.0_wp, 2*i*octave)*sum(table%nodes**(2*i)*ray%on_axis(:, octave))
            end do
        end do
        x = -y**2*(moments(1)/2.0_wp - y**2*(moments(2)/24.0_wp - y**2*moments(3)/720.0_wp))
        kept = first_wave - 1
        if (size(y) == size(table%near_y)) kept = min(ray%top, ubound(table%near, 3))
        do octave = first_wave, kept
            call dgemv("N", size(x), size(table%nodes), 1.0_wp, table%near(:, :, octave), size(x), ray%on_axis(:, octave), 1, &
                       1.0_wp, x, 1)
        end do
        do octave = kept + 1, ray%top
            do i = 1, size(table%nodes)
                x = x - 2.0_wp*ray%on_axis(i, octave)*sin(0.5_wp*scale(table%nodes(i), octave)*y)**2
            end do
        end do
    end subroutine near_values

    !> X - X(0) on one octave of y >= 1: Re int chi (exp(iky) - 1) dk.
    subroutine plateau_values(ray, table, octave, x)
        type(ray_t), intent(in) :: ray
        type(wave_table_t), intent(in) :: table
        integer, intent(in) :: octave
        real(wp), intent(out) :: x(:)
        complex(wp) :: moments(0:order), constant
        real(wp) :: parts(2, size(table%nodes))
        integer :: i, m, first

        moments = 0.0_wp
        first = min(ray%lowest, first_wave - octave)
        constant = ray%chi_zero*table%direction*scale(1.0_wp, first)
        do i = 1, order
            do m = first, first_wave - octave - 1
                moments(i) = moments(i) + scale(1.0_wp, i*(m + octave))*ray%chi_moments(i, m)
            end do
            constant = constant*(0.0_wp, 1.0_wp)*table%direction*scale(1.0_wp, first + octave)/real(i, wp)
            moments(i) = moments(i) + constant/real(i + 1, wp)
        end do
        x = power_series(moments, table%far_y)
        do m = first_wave, ray%top + octave
            parts(1, :) = real(ray%weighted_chi(:, m - octave), wp)
            parts(2, :) = -aimag(ray%weighted_chi(:, m - octave))
            if (m <= ubound(table%far, 4)) call add_waves(table, m, parts, x)
            if (m >= 0) x = x - sum(parts(1, :))
        end do
    end subroutine plateau_values

    !> X on one octave of y >= 1, from chi - chi(0).
    subroutine far_values(ray, table, octave, x)
        type(ray_t), intent(in) :: ray
        type(wave_table_t), intent(in) :: table
        integer, intent(in) :: octave
        real(wp), intent(out) :: x(:)
        complex(wp) :: moments(0:order), factor(size(table%nodes))
        real(wp) :: parts(2, size(table%nodes), first_wave:ubound(table%far, 4)), base
        integer :: i, m

        moments = 0.0_wp
        do m = ray%lowest, first_wave - 1
            base = 1.0_wp
            do i = 0, order
                moments(i) = moments(i) + base*ray%moments(i, m - octave)
                base = base*scale(1.0_wp, m)
            end do
        end do
        moments(0) = moments(0) + rest_below(ray, ray%lowest - octave)
        do m = first_wave, ubound(parts, 3)
            if (m - octave > ray%top) then
                factor = -ray%chi_zero*scale(table%weights, m - octave)*table%direction
            else
                factor = ray%weighted_change(:, m - octave)
            end if
            parts(1, :, m) = real(factor, wp)
            parts(2, :, m) = -aimag(factor)
        end do
        moments(0) = moments(0) + sum(parts(1, :, :-1))
        x = power_series(moments, table%far_y)
        do m = first_wave, ubound(parts, 3)
            call add_waves(table, m, parts(:, :, m), x)
        end do
    end subroutine far_values

    !> One octave at a time: products so small that no BLAS starts threads for them. From the first element on: gfortran copies an
    !> octave of the table that is handed over as a section.
    subroutine add_waves(table, octave, parts, x)
        type(wave_table_t), intent(in) :: table
        integer, intent(in) :: octave
        real(wp), intent(in) :: parts(2, size(table%nodes))
        real(wp), intent(inout) :: x(size(table%far_y))

        call dgemv("N", size(x), size(parts), 1.0_wp, table%far(1, 1, 1, octave), size(x), parts, 1, 1.0_wp, x, 1)
    end subroutine add_waves

    !> Re sum_n moments(n) y^n.
    pure function power_series(moments, y) result(x)
        complex(wp), intent(in) :: moments(0:)
        real(wp), intent(in) :: y(:)
        real(wp) :: x(size(y))
        integer :: n

        x = real(moments(ubound(moments, 1)), wp)
        do n = ubound(moments, 1) - 1, 0, -1
            x = x*y + real(moments(n), wp)
        end do
    end function power_series

    !> Coefficients of powers of u from values at the Chebyshev points. By way of Chebyshev coefficients: those of high degree are
    !> small, and so are the rounding errors of the powers that they make.
    pure function powers_from_values(values, highest) result(powers)
        real(wp), intent(in) :: values(0:)
        !> degree of the polynomial
        integer, intent(in) :: highest
        real(wp) :: powers(0:degree)
        real(wp) :: series(1, 0:degree), before(0:degree), here(0:degree), next(0:degree)
        integer :: j

        series = series_of_values(reshape(values, [1, degree + 1]))
        before = 0.0_wp
        before(0) = 1.0_wp
        here = 0.0_wp
        here(1) = 1.0_wp
        powers = series(1, 0)*before + series(1, 1)*here
        do j = 2, highest
            next(0) = -before(0)
            next(1:) = 2.0_wp*here(:degree - 1) - before(1:)
            powers = powers + series(1, j)*next
            before = here
            here = next
        end do
    end function powers_from_values

end module mdrcontact_line_tabulate
