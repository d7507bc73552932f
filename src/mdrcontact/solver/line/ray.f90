! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface compliance chi(k) of one body on a ray of complex wavenumbers, octave by octave, downwards as far as it matters.
module mdrcontact_line_ray
    use mdrcontact_kinds, only: wp
    use mdrcontact_body_compliance, only: compliance_t
    use mdrcontact_line_waves, only: first_wave, order, panel_nodes, wave_table_t
    implicit none (type, external)
    private
    public :: ray_t, start_ray, extend_ray, path_holds, rest_below, take_chi_moments

    !> Octaves below this one (k in units of 1/unit) contribute nothing to positions up to the unit.
    integer, parameter :: negligible_octave = -56
    !> Contribution of an octave, relative to the largest one, below which a power of k represents the smaller wavenumbers.
    real(wp), parameter :: negligible_part = 2.0_wp**(-44)
    !> Octaves in which the resolution of chi is watched.
    integer, parameter :: watched_octave = -30

    !> chi(k) of one body on a ray, octave by octave.
    type :: ray_t
        integer :: top = 0, bottom = 1
        !> the bottom that positions up to the unit need
        integer :: lowest = 0
        !> weight times chi for octaves from lowest on, and weight times (chi - chi(0)), (node, octave); above top chi = 0
        complex(wp), allocatable :: weighted_chi(:, :), weighted_change(:, :)
        !> (n, octave): integral of (i k)^n/n! (chi - chi(0)) over the octave, k in units of 2^octave but dk
        complex(wp), allocatable :: moments(:, :)
        !> the same of chi itself, from the octave `lowest` on, below which chi is chi(0)
        complex(wp), allocatable :: chi_moments(:, :)
        real(wp) :: chi_zero = 0.0_wp
        !> weight times chi on the real axis, (node, octave) from lowest to top, and X(0), the integral of chi
        real(wp), allocatable :: on_axis(:, :)
        real(wp) :: origin = 0.0_wp
        !> largest relative size of the highest Legendre coefficients of chi - chi(0) in a panel
        real(wp) :: roughness = 0.0_wp
        !> largest |chi| on the real axis
        real(wp) :: largest = 0.0_wp
    end type ray_t

contains

    !> Fills the octaves that positions up to the unit need; `more` octaves may follow below them.
    subroutine start_ray(ray, surface, unit, table, more)
        type(ray_t), intent(out) :: ray
        class(compliance_t), intent(in) :: surface
        real(wp), intent(in) :: unit
        type(wave_table_t), intent(in) :: table
        integer, intent(in) :: more
        complex(wp) :: one_plus_chi(1), chi(1)
        real(wp) :: largest
        integer :: i, latest

        ray%chi_zero = real(surface%at_zero, wp) - 1.0_wp
        do i = -2, 1000
            call surface%chi([table%direction*(scale(1.0_wp, i)/unit)], one_plus_chi, chi)
            if (abs(chi(1))*scale(1.0_wp, i) < 1.0e-20_wp) exit
        end do
        ray%top = i
        ray%bottom = i + 1
        allocate (ray%weighted_chi(size(table%nodes), negligible_octave:ray%top), &
                  ray%weighted_change(size(table%nodes), negligible_octave - more:ray%top), &
                  ray%moments(0:order, negligible_octave - more:ray%top))
        ! structure of the size of the whole body must have been seen
        latest = min(first_wave, floor(log(unit/surface%last_depth)/log(2.0_wp))) - 2
        largest = 0.0_wp
        do i = ray%top, negligible_octave, -1
            call extend_ray(ray, surface, unit, table, i)
            largest = max(largest, abs(sum(ray%weighted_chi(:, i))))
            if (i <= latest .and. abs(ray%moments(0, i)) <= negligible_part*largest) exit
        end do
        ray%lowest = ray%bottom
    end subroutine start_ray

    !> Fills octaves down to `bottom`.
    subroutine extend_ray(ray, surface, unit, table, bottom)
        type(ray_t), intent(inout) :: ray
        class(compliance_t), intent(in) :: surface
        real(wp), intent(in) :: unit
        type(wave_table_t), intent(in) :: table
        integer, intent(in) :: bottom
        complex(wp), dimension(size(table%nodes)) :: one_plus_chi, chi, change
        real(wp) :: base, one_plus_chi_zero
        integer :: i, octave

        one_plus_chi_zero = real(surface%at_zero, wp)
        do octave = ray%bottom - 1, bottom, -1
            base = scale(1.0_wp, octave)
            call surface%chi(table%direction*(base*table%nodes/unit), one_plus_chi, chi)
            change = one_plus_chi - one_plus_chi_zero
            if (octave >= negligible_octave) ray%weighted_chi(:, octave) = base*table%weights*table%direction*chi
            ray%weighted_change(:, octave) = base*table%weights*table%direction*change
            do i = 0, order
                ray%moments(i, octave) = sum(table%powers(:, i)*ray%weighted_change(:, octave))
            end do
            if (octave >= watched_octave) ray%roughness = max(ray%roughness, roughness_of(change, table%last, one_plus_chi_zero))
        end do
        ray%bottom = min(ray%bottom, bottom)
    end subroutine extend_ray

    !> Fills chi_moments, which stiff films alone take.
    pure subroutine take_chi_moments(ray, table)
        type(ray_t), intent(inout) :: ray
        type(wave_table_t), intent(in) :: table
        integer :: i, octave

        allocate (ray%chi_moments(0:order, ray%lowest:ray%top))
        do octave = ray%lowest, ray%top
            do i = 0, order
                ray%chi_moments(i, octave) = sum(table%powers(:, i)*ray%weighted_chi(:, octave))
            end do
        end do
    end subroutine take_chi_moments

    !> The integral of chi - chi(0) below an octave, from its power of k there: the octaves' parts are a geometric series.
    pure function rest_below(ray, octave) result(rest)
        type(ray_t), intent(in) :: ray
        integer, intent(in) :: octave
        complex(wp) :: rest
        complex(wp) :: ratio

        rest = ray%moments(0, octave)
        ! a first power unless the values are clearly of a higher one; rounding alone is of no consequence here
        ratio = 0.25_wp
        if (3.0_wp*abs(rest) < abs(ray%moments(0, octave + 1))) ratio = rest/ray%moments(0, octave + 1)
        rest = rest*ratio/(1.0_wp - ratio)
    end function rest_below

    !> Resolution error of values on an octave: the larger of their two last Legendre coefficients on any panel, relative to the
    !> largest value, or to what rounding of one_plus_chi leaves of it.
    pure function roughness_of(values, last, one_plus_chi_zero) result(roughness)
        complex(wp), intent(in) :: values(:)
        real(wp), intent(in) :: last(:, :), one_plus_chi_zero
        real(wp) :: roughness
        integer :: first

        roughness = 0.0_wp
        do first = 1, size(values), panel_nodes
            associate (on_panel => values(first:first + panel_nodes - 1))
                roughness = max(roughness, abs(sum(last(:, 1)*on_panel)), abs(sum(last(:, 2)*on_panel)))
            end associate
        end do
        roughness = roughness/max(maxval(abs(values)), 1.0e-4_wp*abs(one_plus_chi_zero), tiny(1.0_wp))
    end function roughness_of

    !> Whether the integral of chi along the ray equals that along the real axis: no pole lies between them.
    subroutine path_holds(ray, surface, unit, table, holds)
        type(ray_t), intent(inout) :: ray
        class(compliance_t), intent(in) :: surface
        real(wp), intent(in) :: unit
        type(wave_table_t), intent(in) :: table
        logical, intent(out) :: holds
        complex(wp) :: one_plus_chi(size(table%nodes)), chi(size(table%nodes)), along_ray
        real(wp) :: magnitude, base
        integer :: octave

        along_ray = sum(ray%weighted_chi(:, ray%lowest:ray%top)) + ray%chi_zero*scale(1.0_wp, ray%lowest)*table%direction
        allocate (ray%on_axis(size(table%nodes), ray%lowest:ray%top))
        do octave = ray%lowest, ray%top
            base = scale(1.0_wp, octave)
            call surface%chi(cmplx(base*table%nodes/unit, 0.0_wp, wp), one_plus_chi, chi)
            ray%on_axis(:, octave) = base*table%weights*real(chi, wp)
            ray%largest = max(ray%largest, maxval(abs(real(chi, wp))))
        end do
        ray%origin = ray%chi_zero*scale(1.0_wp, ray%lowest) + sum(ray%on_axis)
        magnitude = sum(abs(ray%on_axis))
        holds = abs(along_ray - ray%origin) <= 1.0e-12_wp*magnitude + 1.0e-13_wp
    end subroutine path_holds

end module mdrcontact_line_ray
