! SPDX-License-Identifier: GPL-3.0-or-later
!> Coating after Perriot and Barthel (theory/paper.md (3.12)): a fit to their own exact solution.
!> Perriot, Barthel, J. Mater. Res. 19 (2004) 600.
module mdrcontact_medium_perriot_barthel
    use mdrcontact_error, only: check_made, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_coated, only: coated_t
    implicit none (type, external)
    private
    public :: perriot_barthel_t, new_perriot_barthel

    !> E' = E'_0 + (E'_1 - E'_0)/(1 + (x0/x)^n), x = a/h, log10 x0 = -0.093 + 0.792 L + 0.05 L^2, L = log10(E'_1/E'_0), n = 1.27.
    type, extends(coated_t) :: perriot_barthel_t
        private
        real(wp) :: transition = 1.0_wp
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
    end type perriot_barthel_t

    !> n of the fit
    real(wp), parameter :: exponent = 1.27_wp

contains

    !> A coating after Perriot and Barthel.
    subroutine new_perriot_barthel(self, coating, thickness, substrate, error)
        type(perriot_barthel_t), intent(out) :: self
        type(material_t), intent(in) :: coating, substrate
        !> h > 0 [length]
        real(wp), intent(in) :: thickness
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: contrast

        call check_made(error, "coating", coating%young > 0.0_wp)
        call check_made(error, "substrate", substrate%young > 0.0_wp)
        if (allocated(error)) return
        call self%set_bodies(coating, thickness, substrate, error)
        if (allocated(error)) return
        contrast = log10(substrate%contact()/coating%contact())
        self%transition = 10.0_wp**(-0.093_wp + 0.792_wp*contrast + 0.05_wp*contrast**2)
        self%is_made = .not. allocated(error)
    end subroutine new_perriot_barthel

    elemental function effective_modulus(self, a) result(value)
        class(perriot_barthel_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: ratio

        ratio = (a/(self%thickness*self%transition))**exponent
        value = self%coating%contact()/(1.0_wp + ratio) + self%substrate%contact()*(ratio/(1.0_wp + ratio))
    end function effective_modulus

    elemental function effective_modulus_slope(self, a) result(value)
        class(perriot_barthel_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: ratio

        ratio = (a/(self%thickness*self%transition))**exponent
        value = (self%substrate%contact() - self%coating%contact())*(exponent/a)*(ratio/(1.0_wp + ratio))/(1.0_wp + ratio)
    end function effective_modulus_slope

end module mdrcontact_medium_perriot_barthel
