! SPDX-License-Identifier: GPL-3.0-or-later
!> Coating after Bec et al. (theory/paper.md (3.11)): the coating as an elastic column above a substrate that is loaded over
!> a wider disc, springs in series.
!> Bec, Tonck, Loubet, Philos. Mag. 86 (2006) 5347.
module mdrcontact_medium_bec
    use mdrcontact_error, only: check_made, error_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_coated, only: coated_t
    implicit none (type, external)
    private
    public :: bec_t, new_bec

    !> 1/(2 a E') = h/((pi a^2 + 2 h a) E'_0) + 1/(2 (a + 2h/pi) E'_1), that is E' = (pi a + 2h)/(2h/E'_0 + pi a/E'_1).
    type, extends(coated_t) :: bec_t
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
    end type bec_t

contains

    !> A coating after Bec.
    subroutine new_bec(self, coating, thickness, substrate, error)
        type(bec_t), intent(out) :: self
        type(material_t), intent(in) :: coating, substrate
        !> h > 0 [length]
        real(wp), intent(in) :: thickness
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "coating", coating%young > 0.0_wp)
        call check_made(error, "substrate", substrate%young > 0.0_wp)
        if (allocated(error)) return
        call self%set_bodies(coating, thickness, substrate, error)
        self%is_made = .not. allocated(error)
    end subroutine new_bec

    elemental function effective_modulus(self, a) result(value)
        class(bec_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value

        value = (pi*a + 2.0_wp*self%thickness)/(2.0_wp*self%thickness/self%coating%contact() + pi*a/self%substrate%contact())
    end function effective_modulus

    elemental function effective_modulus_slope(self, a) result(value)
        class(bec_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: compliance

        compliance = 2.0_wp*self%thickness/self%coating%contact() + pi*a/self%substrate%contact()
        value = 2.0_wp*pi*self%thickness*(1.0_wp/self%coating%contact() - 1.0_wp/self%substrate%contact())/compliance/compliance
    end function effective_modulus_slope

end module mdrcontact_medium_bec
