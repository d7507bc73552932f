! SPDX-License-Identifier: GPL-3.0-or-later
!> Response of the surface of a body to a wave of load: C(k) = displacement over traction.
module mdrcontact_medium_compliance
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_body, only: body_t
    use mdrcontact_body_chain, only: chain_t
    use mdrcontact_body_compliance, only: compliance_t, normal_load, twist_load
    use mdrcontact_error, only: error_domain, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    use mdrcontact_body_membrane, only: membrane_t, new_membrane
    use mdrcontact_tension_stability, only: check_stability
    use mdrcontact_tension_surface, only: check_surface, is_bare, surface_t
    implicit none (type, external)
    private
    public :: check_body_surface, surface_compliance

    !> C(k) of an elastic body, or of one that relaxes.
    interface surface_compliance
        module procedure of_elastic, of_relaxing
    end interface surface_compliance

contains

    !> Raise an error for impossible surfaces, and if the surface of the body wrinkles.
    subroutine check_body_surface(body, surface, error)
        class(body_t), intent(in) :: body
        type(surface_t), intent(in) :: surface
        type(error_t), allocatable, intent(inout) :: error
        class(compliance_t), allocatable :: compliance
        type(membrane_t) :: membrane

        call check_surface(surface, error)
        if (allocated(error) .or. .not. surface%tension < 0.0_wp) return
        call body%compliance(normal_load, compliance, error)
        if (allocated(error)) return
        if (surface%stretching > 0.0_wp) then
            call new_membrane(membrane, surface%stretching, compliance, error, has_springs=.false.)
            call check_stability(surface, membrane, error)
        else
            call check_stability(surface, compliance, error)
        end if
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
        !> wavenumbers > 0 [1/length]
        real(wp), intent(in) :: k(:)
        !> same size as k [length/modulus]
        complex(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        values = 0.0_wp
        call add_body(body, load, k, values, error, surface%stretching)
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
        !> wavenumbers > 0 [1/length]
        real(wp), intent(in) :: k(:)
        !> same size as k [length/modulus]
        complex(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(chain_t) :: chain

        values = 0.0_wp
        call body%chain_at(load, cmplx(0.0_wp, omega, wp), chain, error)
        if (.not. allocated(error)) call add(chain, load, k, values)
        call check_values(error, values)
    end subroutine of_relaxing

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

    subroutine add_body(body, load, k, values, error, stretching)
        class(body_t), intent(in) :: body
        integer, intent(in) :: load
        real(wp), intent(in) :: k(:)
        complex(wp), intent(inout) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        !> of a sheet on it, in its plane [modulus length]
        real(wp), intent(in) :: stretching
        class(compliance_t), allocatable :: compliance
        type(membrane_t) :: membrane

        if (.not. allocated(error)) call body%compliance(load, compliance, error)
        if (allocated(error)) return
        if (stretching > 0.0_wp .and. load == normal_load) then
            call new_membrane(membrane, stretching, compliance, error, has_springs=.false.)
            if (.not. allocated(error)) call add(membrane, load, k, values)
        else
            call add(compliance, load, k, values)
        end if
    end subroutine add_body

    !> The scale of a twist is 4 G0, so that M/phi of a punch is to it as dF/dd is to E*; a wave has half of it.
    subroutine add(compliance, load, k, values)
        class(compliance_t), intent(in) :: compliance
        integer, intent(in) :: load
        real(wp), intent(in) :: k(:)
        complex(wp), intent(inout) :: values(:)
        complex(wp) :: one_plus_chi(1), chi(1)
        integer :: i

        do i = 1, size(k)
            call compliance%chi([cmplx(k(i), kind=wp)], one_plus_chi, chi)
            values(i) = values(i) + merge(4.0_wp, 2.0_wp, load == twist_load)*one_plus_chi(1)/(compliance%scale*k(i))
        end do
    end subroutine add

end module mdrcontact_medium_compliance
