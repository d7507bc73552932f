! SPDX-License-Identifier: GPL-3.0-or-later
!> Coating after Hay and Crawford (theory/paper.md (3.13)): Gao's weights with a film that can also act in parallel with the
!> substrate. Hay, Crawford, J. Mater. Res. 26 (2011) 727.
module mdrcontact_medium_hay_crawford
    use mdrcontact_error, only: check_made, error_t
    use mdrcontact_weights, only: weight_i0, weight_i0_slope, weight_i1, weight_i1_slope, weight_j0, weight_j1
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_coated, only: coated_t
    implicit none (type, external)
    private
    public :: hay_crawford_t, new_hay_crawford

    !> 1/G_eff = (1 - I0)/(G1 + 0.0626 I0 G0) + I0/G0, nu_eff = 1 - (1 - nu1)(1 - nu0)/(1 - (1 - I1) nu0 - I1 nu1).
    type, extends(coated_t) :: hay_crawford_t
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
    end type hay_crawford_t

    !> how much of the film acts in parallel with the substrate, fitted to finite elements by Hay and Crawford
    real(wp), parameter :: mixing = 0.0626_wp

contains

    !> A coating after Hay and Crawford; the nu in I0 is that of the coating.
    subroutine new_hay_crawford(self, coating, thickness, substrate, error)
        type(hay_crawford_t), intent(out) :: self
        type(material_t), intent(in) :: coating, substrate
        !> h > 0 [length]
        real(wp), intent(in) :: thickness
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "coating", coating%young > 0.0_wp)
        call check_made(error, "substrate", substrate%young > 0.0_wp)
        if (allocated(error)) return
        call self%set_bodies(coating, thickness, substrate, error)
        self%is_made = .not. allocated(error)
    end subroutine new_hay_crawford

    elemental function effective_modulus(self, a) result(value)
        class(hay_crawford_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: xi

        xi = self%thickness/a
        value = 2.0_wp/(shear_compliance(self, xi)*one_minus_nu(self, xi))
    end function effective_modulus

    elemental function effective_modulus_slope(self, a) result(value)
        class(hay_crawford_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: xi, i0, mixed, compliance_slope, log_slope

        xi = self%thickness/a
        i0 = weight_i0(xi, self%coating%poisson)
        mixed = self%substrate%shear() + mixing*i0*self%coating%shear()
        compliance_slope = weight_i0_slope(xi, self%coating%poisson) &
                           *(1.0_wp/self%coating%shear() - 1.0_wp/mixed &
                             - weight_j0(xi, self%coating%poisson)/mixed*(mixing*self%coating%shear()/mixed))
        ! 1 - nu_eff is a constant over m(xi) = 1 - J1 nu0 - I1 nu1.
        log_slope = weight_i1_slope(xi)*(self%coating%poisson - self%substrate%poisson) &
                    *one_minus_nu(self, xi)/((1.0_wp - self%substrate%poisson)*(1.0_wp - self%coating%poisson))
        value = self%effective_modulus(a)*(-compliance_slope/shear_compliance(self, xi) + log_slope)*(-xi/a)
    end function effective_modulus_slope

    pure function shear_compliance(self, xi) result(compliance)
        class(hay_crawford_t), intent(in) :: self
        real(wp), intent(in) :: xi
        real(wp) :: compliance, i0

        i0 = weight_i0(xi, self%coating%poisson)
        compliance = weight_j0(xi, self%coating%poisson)/(self%substrate%shear() + mixing*i0*self%coating%shear()) &
                     + i0/self%coating%shear()
    end function shear_compliance

    pure function one_minus_nu(self, xi) result(value)
        class(hay_crawford_t), intent(in) :: self
        real(wp), intent(in) :: xi
        real(wp) :: value

        value = (1.0_wp - self%substrate%poisson)*(1.0_wp - self%coating%poisson) &
                /(1.0_wp - weight_j1(xi)*self%coating%poisson - weight_i1(xi)*self%substrate%poisson)
    end function one_minus_nu

end module mdrcontact_medium_hay_crawford
