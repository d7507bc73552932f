! SPDX-License-Identifier: GPL-3.0-or-later
!> C(k) of a gel's surface under a pressure that oscillates as exp(i omega t), for codes that solve contacts by Fourier transforms
!> (theory/poroelastic.md (2.1), (2.2)).
module mdrcontact_poroelastic_compliance
    use mdrcontact_error, only: check_not_negative, check_positive, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_poroelastic_gel, only: gel_t, new_gel, sealed_by_indenter
    use mdrcontact_poroelastic_kernel, only: relative_compliance
    implicit none (type, external)
    private
    public :: poroelastic_compliance

    !> Representation of 0 in the units of the gel.
    real(wp), parameter :: lowest_frequency = 1.0e-30_wp

contains

    !> (1 + r)/(2 G k): 1/(2 G k) of an incompressible half-space, (1 - nu)/(G k) of one that has drained.
    subroutine poroelastic_compliance(poisson, drainage, thickness, shear_modulus, diffusivity, omega, k, values, error)
        !> drained Poisson's ratio
        real(wp), intent(in) :: poisson
        !> drains_by_surface or sealed: under the third drainage the surface responds to no single wave
        integer, intent(in) :: drainage
        !> of a film on a rigid base that lets no fluid through; 0: half-space [length]
        real(wp), intent(in) :: thickness
        !> G > 0 [modulus], D > 0 [length^2/time]
        real(wp), intent(in) :: shear_modulus, diffusivity
        !> angular frequencies of either sign; 0: drained, as at a frequency that is next to nothing [1/time]
        real(wp), intent(in) :: omega(:)
        !> wavenumbers > 0, same size [1/length]
        real(wp), intent(in) :: k(:)
        !> same size as k [length/modulus]
        complex(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(gel_t) :: gel
        real(wp) :: unit
        complex(wp) :: frequency(size(k))

        values = 0.0_wp
        call new_gel(gel, poisson, drainage, 0.0_wp, error)
        if (allocated(error)) return
        call check_not_negative(error, "thickness", thickness)
        call check_positive(error, "shear_modulus", shear_modulus)
        call check_positive(error, "diffusivity", diffusivity)
        if (.not. allocated(error) .and. drainage == sealed_by_indenter) then
            call raise(error, error_invalid, "drainage = 3 (indenter): a compliance needs drainage that does not depend on "// &
                       "the contact. Use 1 (surface) or 2 (sealed)")
        end if
        if (allocated(error)) return
        ! relative_compliance() takes lengths in units of the thickness
        unit = 1.0_wp
        if (thickness > 0.0_wp) then
            gel%ratio = 1.0_wp
            unit = thickness
        end if
        frequency = cmplx(0.0_wp, max(abs(omega)*unit**2/diffusivity, lowest_frequency), wp)
        values = (1.0_wp + relative_compliance(gel, cmplx(k*unit, kind=wp), frequency))/(2.0_wp*shear_modulus*k)
        where (omega < 0.0_wp) values = conjg(values)
    end subroutine poroelastic_compliance

end module mdrcontact_poroelastic_compliance
