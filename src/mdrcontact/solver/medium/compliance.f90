! SPDX-License-Identifier: GPL-3.0-or-later
!> Response of the surface of a body to a wave of load: C(k) = displacement over traction.
module mdrcontact_medium_compliance
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_body, only: body_t
    use mdrcontact_body_chain, only: chain_t
    use mdrcontact_body_compliance, only: compliance_t, normal_load, twist_load
    use mdrcontact_error, only: check_made, error_domain, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
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

    !> C(k) of an elastic body, or of one that relaxes.
    interface surface_compliance
        module procedure of_elastic, of_relaxing
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
    !> a twist consists of. Under a load along the wave it is twice the second less the third.
    subroutine of_elastic(body, surface, load, k, values, error)
        class(body_t), intent(in) :: body
        !> properties of its surface
        type(surface_t), intent(in) :: surface
        !> normal_load, shear_load or twist_load
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
            call body%compliance(load, compliance, error)
        end if
        if (.not. allocated(error)) call add(compliance, load, k, values, error)
        if (.not. is_bare(surface)) call add_sheet(surface, load, k, values, error)
        call check_values(error, values)
    end subroutine of_elastic

    !> The same of a viscoelastic body, at an angular frequency.
    subroutine of_relaxing(body, load, omega, k, values, error)
        type(viscoelastic_t), intent(in) :: body
        !> as above
        integer, intent(in) :: load
        !> >= 0; 0: when it has relaxed [1/time]
        real(wp), intent(in) :: omega
        !> wavenumbers > 0, or 0 on a rigid base [1/length]
        real(wp), intent(in) :: k(:)
        !> same size as k [length/modulus]
        complex(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(chain_t) :: chain

        values = 0.0_wp
        call check_made(error, "body", body%is_made)
        if (.not. allocated(error)) call body%chain_at(load, cmplx(0.0_wp, omega, wp), chain, error)
        if (.not. allocated(error)) call add(chain, load, k, values, error)
        call check_values(error, values)
    end subroutine of_relaxing

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

    !> The same of a viscoelastic body at an angular frequency.
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

        if (allocated(error) .or. all(is_finite(abs(values)))) return
        call raise(error, error_domain, ": the body flows, or its compliance exceeds the range of double precision", "omega or k")
    end subroutine check_values

    !> The scale of a twist is 4 G0, so that M/phi of a punch is to it as dF/dd is to E*; a wave has half of it. At k = 0 the value
    !> of a rigid base.
    subroutine add(compliance, load, k, values, error)
        class(compliance_t), intent(in) :: compliance
        integer, intent(in) :: load
        real(wp), intent(in) :: k(:)
        complex(wp), intent(inout) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: one_plus_chi(1), chi(1), at_zero
        real(wp) :: factor
        integer :: i

        at_zero = 0.0_wp
        factor = merge(2.0_wp, 1.0_wp, load == twist_load)
        if (any(k == 0.0_wp)) then
            call value_at_zero(compliance, at_zero, findloc(k == 0.0_wp, .true., dim=1), error)
            if (allocated(error)) return
        end if
        do i = 1, size(k)
            if (k(i) == 0.0_wp) then
                values(i) = values(i) + factor*at_zero
                cycle
            end if
            call compliance%chi([cmplx(k(i), kind=wp)], one_plus_chi, chi)
            values(i) = values(i) + 2.0_wp*factor*one_plus_chi(1)/(compliance%scale*k(i))
        end do
    end subroutine add

    !> C at k = 0, if it is finite.
    subroutine value_at_zero(compliance, value, entry, error)
        class(compliance_t), intent(in) :: compliance
        complex(wp), intent(out) :: value
        !> of k, for the error
        integer, intent(in) :: entry
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: one_plus_chi(1), chi(1)
        type(compliance_limits_t) :: limits
        real(wp) :: length

        value = 0.0_wp
        length = maxval(compliance%lengths())
        if (.not. abs(compliance%at_zero) > 0.0_wp .and. length > 0.0_wp) then
            call compliance%chi([cmplx(1.0e-15_wp/length, kind=wp)], one_plus_chi, chi)
            if (abs(one_plus_chi(1)) < 1.0e-3_wp) then
                limits = limits_of(compliance)
                value = limits%rest
                return
            end if
        end if
        call raise(error, error_invalid, " = 0: the compliance is infinite there. Give k > 0; only a body that is bonded to a "// &
                   "rigid base has a value at 0", "k", entry)
    end subroutine value_at_zero

end module mdrcontact_medium_compliance
