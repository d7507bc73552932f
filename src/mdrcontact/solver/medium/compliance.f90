! SPDX-License-Identifier: GPL-3.0-or-later
!> Response of the surface of a body to a wave of load: C(k) = displacement over traction.
module mdrcontact_medium_compliance
    use, intrinsic :: iso_c_binding, only: c_size_t
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_body, only: body_t
    use mdrcontact_body_chain, only: chain_t
    use mdrcontact_body_compliance, only: compliance_t, coupling_load, normal_load, twist_load
    use mdrcontact_error, only: check_made, check_memory, error_domain, error_invalid, error_t, raise, raise_at
    use mdrcontact_gsl, only: gsl_sort_index
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_compliance_table, only: tabulated_compliance
    use mdrcontact_medium_power_graded, only: power_graded_t
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    use mdrcontact_body_membrane, only: membrane_t, new_membrane
    use mdrcontact_tension_stability, only: check_stability
    use mdrcontact_tension_surface, only: check_surface, has_springs, is_bare, surface_t
    implicit none (type, external)
    private
    public :: check_body_surface, compliance_limits, compliance_limits_t, normal_compliance, &
              surface_compliance

    !> The compliance of a body under a pressure for very short and very long waves (theory/exact.md (6.1)).
    type :: compliance_limits_t
        !> 1/E0*, k C/2 of short waves: 0 under a surface with tension or a plate [1/modulus]
        complex(wp) :: short = 0.0_wp
        !> 1/E*, k C/2 of long waves: 0 on a rigid base [1/modulus]
        complex(wp) :: long = 0.0_wp
        !> C - 2/(E* k) at k = 0, C itself on a rigid base [length/modulus]
        complex(wp) :: rest = 0.0_wp
    end type compliance_limits_t

    !> Wavenumbers from which a table of them takes less time than each of a costly compliance.
    integer, parameter :: table_from = 2000

    !> C(k) of an elastic body, of one that relaxes, or of one that has one solution.
    interface surface_compliance
        module procedure of_elastic, of_relaxing, of_solved
    end interface surface_compliance

    !> The limits of its compliance under a pressure.
    interface compliance_limits
        module procedure limits_of_elastic, limits_of_relaxing
    end interface compliance_limits

contains

    !> Raise an error for impossible surfaces, and if the surface of the body wrinkles.
    subroutine check_body_surface(body, surface, error)
        class(body_t), intent(in) :: body
        type(surface_t), intent(in) :: surface
        type(error_t), allocatable, intent(inout) :: error
        class(compliance_t), allocatable :: compliance
        type(error_t), allocatable :: failure

        call check_surface(surface, error)
        if (allocated(error) .or. .not. surface%tension < 0.0_wp) return
        call normal_compliance(body, surface, compliance, failure)
        if (allocated(failure)) call move_alloc(failure, error)
        if (.not. allocated(error)) call check_stability(surface, compliance, error)
    end subroutine check_body_surface

    !> C(k), for any model of the contact (theory/exact.md (1.1)): 2/(E* k) of a half-space under a pressure, (2 -
    !> nu)/(2 G k) under a load of one direction averaged over the directions of the wave, 1/(G k) under one across the wave, which
    !> a twist consists of. Under a load along the wave it is twice the second less the third. The coupling of the first with that
    !> load, (1 - 2 nu)/(2 G k) of a half-space, is i C of displacements along waves exp(i k x), -i C of those along the normal.
    subroutine of_elastic(body, surface, load, k, values, error)
        class(body_t), intent(in) :: body
        !> properties of its surface
        type(surface_t), intent(in) :: surface
        !> normal_load, shear_load, twist_load or coupling_load
        integer, intent(in) :: load
        !> wavenumbers > 0, or 0 on a rigid base [1/length]
        real(wp), intent(in) :: k(:)
        !> same size as k [length/modulus]
        complex(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        class(compliance_t), allocatable :: compliance

        values = 0.0_wp
        call check_made(error, "body", body%is_made)
        if (allocated(error)) return
        if (load == normal_load) then
            call normal_compliance(body, surface, compliance, error)
        else
            call body%compliance(merge(normal_load, load, load == coupling_load), compliance, error)
        end if
        if (.not. allocated(error)) call set_values(compliance, load, k, values, error, is_real=.true.)
        if (.not. is_bare(surface)) call add_sheet(surface, load, k, values, error)
        call check_values(error, values)
    end subroutine of_elastic

    !> The same of a viscoelastic body under a load that oscillates as exp(i omega t).
    subroutine of_relaxing(body, load, omega, k, values, error)
        type(viscoelastic_t), intent(in) :: body
        !> as above
        integer, intent(in) :: load
        !> angular frequencies of either sign, same size as k; 0: when it has relaxed [1/time]
        real(wp), intent(in) :: omega(:)
        !> wavenumbers > 0, or 0 on a rigid base [1/length]
        real(wp), intent(in) :: k(:)
        !> same size as k [length/modulus]
        complex(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        integer(c_size_t), allocatable :: order(:)
        type(chain_t) :: chain
        integer :: first, last, stat

        values = 0.0_wp
        call check_made(error, "body", body%is_made)
        if (allocated(error)) return
        allocate (order(size(k)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        ! a chain for each frequency, of either sign
        if (size(k) > 0) call gsl_sort_index(order, abs(omega), 1_c_size_t, size(k, kind=c_size_t))
        order = order + 1
        last = 0
        do while (last < size(k))
            first = last + 1
            last = last_of_frequency(order, omega, first)
            call body%chain_at(merge(normal_load, load, load == coupling_load), &
                               cmplx(0.0_wp, abs(omega(order(first))), wp), chain, error)
            if (.not. allocated(error)) call set_group(chain, load, order(first:last), k, values, error)
            if (allocated(error)) return
        end do
        where (omega < 0.0_wp) values = conjg(values)
        call check_values(error, values)
    end subroutine of_relaxing

    !> The last of those places in ascending order that have the size of the frequency of the first.
    pure function last_of_frequency(order, omega, first) result(last)
        integer(c_size_t), intent(in) :: order(:)
        real(wp), intent(in) :: omega(:)
        integer, intent(in) :: first
        integer :: last

        do last = first, size(order) - 1
            if (abs(omega(order(last + 1))) > abs(omega(order(first)))) return
        end do
        last = size(order)
    end function last_of_frequency

    !> Values of one frequency.
    subroutine set_group(chain, load, places, k, values, error)
        type(chain_t), intent(in) :: chain
        integer, intent(in) :: load
        integer(c_size_t), intent(in) :: places(:)
        real(wp), intent(in) :: k(:)
        complex(wp), intent(inout) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        complex(wp), allocatable :: of_group(:)
        integer :: stat

        allocate (of_group(size(places)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        call set_values(chain, load, k(places), of_group, error, is_real=.false.)
        values(places) = of_group
        if (allocated(error)) call raise_at(error, findloc(k == 0.0_wp, .true., dim=1))
    end subroutine set_group

    !> Compliance of a body that has one solution: under a pressure on one that is graded by a power of the depth.
    subroutine of_solved(body, load, k, values, error)
        class(solver_t), intent(in) :: body
        integer, intent(in) :: load
        !> wavenumbers > 0 [1/length]
        real(wp), intent(in) :: k(:)
        !> same size as k [length/modulus]
        complex(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        values = 0.0_wp
        call check_made(error, "body", body%is_made)
        if (allocated(error)) return
        select type (body)
        type is (power_graded_t)
            if (load /= normal_load) then
                call raise(error, error_invalid, ": of a power-law graded body the compliance is available for a pressure only", &
                           "load")
            else if (any(k == 0.0_wp)) then
                call raise_infinite(error, findloc(k == 0.0_wp, .true., dim=1))
            else
                values = body%compliance(k)
                call check_values(error, values)
            end if
        class default
            call raise(error, error_invalid, ": it is rigid and has no compliance. Use a deformable body", "body")
        end select
    end subroutine of_solved

    !> Limits of an elastic body under its surface.
    subroutine limits_of_elastic(body, surface, limits, error)
        class(body_t), intent(in) :: body
        type(surface_t), intent(in) :: surface
        type(compliance_limits_t), intent(out) :: limits
        type(error_t), allocatable, intent(out) :: error
        class(compliance_t), allocatable :: compliance

        call check_made(error, "body", body%is_made)
        if (.not. allocated(error)) call normal_compliance(body, surface, compliance, error)
        if (allocated(error)) return
        limits = limits_of(compliance)
        limits%rest = limits%rest - surface%tension*(2.0_wp*limits%long)**2
        if (.not. has_springs(surface)) limits%short = 0.0_wp
    end subroutine limits_of_elastic

    !> The same of a viscoelastic body at an angular frequency of either sign.
    subroutine limits_of_relaxing(body, omega, limits, error)
        type(viscoelastic_t), intent(in) :: body
        real(wp), intent(in) :: omega
        type(compliance_limits_t), intent(out) :: limits
        type(error_t), allocatable, intent(out) :: error
        type(chain_t) :: chain

        call check_made(error, "body", body%is_made)
        if (.not. allocated(error)) call body%chain_at(normal_load, cmplx(0.0_wp, omega, wp), chain, error)
        if (.not. allocated(error)) limits = limits_of(chain)
        call check_values(error, [limits%short, limits%long, limits%rest])
    end subroutine limits_of_relaxing

    !> Of a compliance that is analytic at k = 0.
    function limits_of(compliance) result(limits)
        class(compliance_t), intent(in) :: compliance
        type(compliance_limits_t) :: limits
        real(wp) :: lengths(2)

        limits%short = 1.0_wp/compliance%scale
        limits%long = compliance%at_zero/compliance%scale
        lengths = compliance%lengths()
        if (.not. lengths(2) > 0.0_wp) return
        if (abs(aimag(compliance%scale)) + abs(aimag(compliance%at_zero)) > 0.0_wp) then
            limits%rest = 2.0_wp*slope_by_differences(compliance, lengths(2))/compliance%scale
        else
            limits%rest = 2.0_wp*slope_of_real(compliance, lengths(2))/compliance%scale
        end if
    end function limits_of

    !> Slope of one_plus_chi at k = 0, where it is real for real k. The step is too short to change the real part, so that its
    !> imaginary part has no rounding error of the constant.
    function slope_of_real(compliance, length) result(slope)
        class(compliance_t), intent(in) :: compliance
        real(wp), intent(in) :: length
        real(wp) :: slope
        real(wp), parameter :: step = 1.0e-20_wp
        complex(wp) :: one_plus_chi(1), chi(1)

        call compliance%chi([cmplx(step/length, step/length, wp)], one_plus_chi, chi)
        slope = aimag(one_plus_chi(1))/(step/length)
        ! what is left of the curvature
        if (abs(slope) < 1.0e-18_wp*length) slope = 0.0_wp
    end function slope_of_real

    !> The same where it is complex: of the polynomial through values at equal steps, to about 1e-10 of k C/2 of long waves.
    function slope_by_differences(compliance, length) result(slope)
        class(compliance_t), intent(in) :: compliance
        real(wp), intent(in) :: length
        complex(wp) :: slope
        real(wp), parameter :: step = 1.0e-4_wp, weights(6) = [6.0_wp, -7.5_wp, 20.0_wp/3.0_wp, -3.75_wp, 1.2_wp, -1.0_wp/6.0_wp]
        complex(wp) :: one_plus_chi(6), chi(6), k(6)
        integer :: i

        k = [(cmplx(i*step/length, kind=wp), i=1, 6)]
        call compliance%chi(k, one_plus_chi, chi)
        slope = sum(weights*(one_plus_chi - compliance%at_zero))/(step/length)
    end function slope_by_differences

    !> The compliance of a body under a pressure, with the in-plane stiffness of its surface but without tension and plate.
    subroutine normal_compliance(body, surface, compliance, error)
        class(body_t), intent(in) :: body
        type(surface_t), intent(in) :: surface
        class(compliance_t), allocatable, intent(out) :: compliance
        type(error_t), allocatable, intent(out) :: error
        class(compliance_t), allocatable :: bare
        type(membrane_t), allocatable :: membrane

        call check_made(error, "body", body%is_made)
        if (.not. allocated(error)) call body%compliance(normal_load, bare, error)
        if (allocated(error)) return
        if (surface%stretching > 0.0_wp) then
            allocate (membrane)
            call new_membrane(membrane, surface%stretching, bare, error, has_springs=.false.)
            call move_alloc(membrane, compliance)
        else
            call move_alloc(bare, compliance)
        end if
    end subroutine normal_compliance

    !> Compliance of the body under the in-plane stiffness of the sheet, 1/C + tau k^2 + B k^4 instead of 1/C (theory/surfaces.md
    !> (5.1)).
    pure subroutine add_sheet(sheet, load, k, values, error)
        type(surface_t), intent(in) :: sheet
        integer, intent(in) :: load
        real(wp), intent(in) :: k(:)
        complex(wp), intent(inout) :: values(:)
        type(error_t), allocatable, intent(inout) :: error

        if (load == normal_load) then
            values = values/(1.0_wp + (sheet%tension + sheet%bending*k**2)*k**2*values)
        else if (.not. allocated(error)) then
            call raise(error, error_invalid, ": under a surface with tension or a sheet the compliance is available for a "// &
                       "pressure only", "load")
        end if
    end subroutine add_sheet

    pure subroutine check_values(error, values)
        type(error_t), allocatable, intent(inout) :: error
        complex(wp), intent(in) :: values(:)

        if (allocated(error) .or. all(is_finite(real(values)) .and. is_finite(aimag(values)))) return
        call raise(error, error_domain, ": the body flows, or its compliance exceeds the range of double precision", "omega or k")
    end subroutine check_values

    !> The scale of a twist is 4 G0, so that M/phi of a punch is to it as dF/dd is to E*; a wave has half of it. At k = 0 the value
    !> of a rigid base, where a uniform load has no coupling.
    subroutine set_values(compliance, load, k, values, error, is_real)
        class(compliance_t), intent(in) :: compliance
        integer, intent(in) :: load
        real(wp), intent(in) :: k(:)
        complex(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        !> whether C is real and may be interpolated in a table
        logical, intent(in) :: is_real
        complex(wp) :: at_zero
        real(wp) :: factor
        integer :: i

        at_zero = 0.0_wp
        values = 0.0_wp
        if (any(k == 0.0_wp)) call value_at_zero(compliance, load, at_zero, findloc(k == 0.0_wp, .true., dim=1), error)
        if (allocated(error)) return
        call set_one_plus_chi(compliance, load, k, values, is_real .and. load /= coupling_load, error)
        factor = merge(4.0_wp, 2.0_wp, load == twist_load)
        do i = 1, size(k)
            if (k(i) == 0.0_wp) then
                values(i) = 0.5_wp*factor*at_zero
            else if (is_real) then
                values(i) = factor*real(values(i), wp)/(real(compliance%scale, wp)*k(i))
            else
                values(i) = factor*values(i)/(compliance%scale*k(i))
            end if
        end do
    end subroutine set_values

    !> 1 + chi, or under a traction along the wave what the coupling has instead of it.
    subroutine set_one_plus_chi(compliance, load, k, values, may_interpolate, error)
        class(compliance_t), intent(in) :: compliance
        integer, intent(in) :: load
        real(wp), intent(in) :: k(:)
        complex(wp), intent(inout) :: values(:)
        logical, intent(in) :: may_interpolate
        type(error_t), allocatable, intent(inout) :: error
        type(error_t), allocatable :: not_smooth
        integer, parameter :: block = 64
        complex(wp) :: waves(block), one_plus_chi(block), chi(block)
        real(wp), allocatable :: interpolated(:)
        integer :: i, n, first, last, stat

        if (compliance%is_costly .and. may_interpolate .and. count(k > 0.0_wp) >= table_from) then
            allocate (interpolated(count(k > 0.0_wp)), stat=stat)
            call check_memory(error, stat)
            if (stat /= 0) return
            call tabulated_compliance(compliance, pack(k, k > 0.0_wp), interpolated, not_smooth)
            values = unpack(cmplx(interpolated, kind=wp), k > 0.0_wp, values)
            if (.not. allocated(not_smooth)) return
        end if
        do first = 1, size(k), block
            last = min(first + block - 1, size(k))
            n = last - first + 1
            ! at k = 0 any number
            waves(:n) = merge(k(first:last), 1.0_wp, k(first:last) > 0.0_wp)
            if (load == coupling_load) then
                do i = first, last
                    call compliance%coupling(waves(i - first + 1), values(i), error)
                    values(i) = -values(i)
                end do
                if (allocated(error)) return
            else
                call compliance%chi(waves(:n), one_plus_chi(:n), chi(:n))
                values(first:last) = one_plus_chi(:n)
            end if
        end do
    end subroutine set_one_plus_chi

    !> C at k = 0, if it is finite.
    subroutine value_at_zero(compliance, load, value, entry, error)
        class(compliance_t), intent(in) :: compliance
        integer, intent(in) :: load
        complex(wp), intent(out) :: value
        !> of k, for the error
        integer, intent(in) :: entry
        type(error_t), allocatable, intent(inout) :: error
        !> k C/2 of waves so much longer than the body is thick is less than this where C is finite
        real(wp), parameter :: long_wave = 1.0e-15_wp, small = 1.0e-3_wp
        complex(wp) :: nearly(1)
        type(compliance_limits_t) :: limits
        real(wp) :: length

        value = 0.0_wp
        length = maxval(compliance%lengths())
        if (.not. abs(compliance%at_zero) > 0.0_wp .and. length > 0.0_wp) then
            nearly = 0.0_wp
            call set_one_plus_chi(compliance, load, [long_wave/length], nearly, .false., error)
            if (allocated(error)) return
            if (abs(nearly(1)) < small) then
                limits = limits_of(compliance)
                if (load /= coupling_load) value = limits%rest
                return
            end if
        end if
        call raise_infinite(error, entry)
    end subroutine value_at_zero

    pure subroutine raise_infinite(error, entry)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: entry

        call raise(error, error_invalid, " = 0: the compliance is infinite there. Give k > 0; only a body on a rigid base "// &
                   "has a value at 0", "k", entry)
    end subroutine raise_infinite

end module mdrcontact_medium_compliance
