! SPDX-License-Identifier: GPL-3.0-or-later
!> Coating by Gao's weights (theory 3): the shear moduli of coating and substrate averaged in parallel or in series with the weight
!> I0(h/a), Poisson's ratios with I1(h/a). Exact to first order in the contrast.
!> Gao, Chiu, Lee, Int. J. Solids Struct. 29 (1992) 2471; Popov 2014, equations (12)-(15).
module mdrcontact_medium_gao
    use mdrcontact_error, only: check_poisson, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_coated, only: coated_t
    use mdrcontact_weights, only: weight_i0, weight_i0_poisson_slope, weight_i0_slope, weight_i1, weight_i1_slope, &
                                  weight_j0, weight_j1
    implicit none (type, external)
    private
    public :: gao_t, new_gao
    public :: gao_nu_surface, gao_nu_substrate, gao_nu_effective, gao_nu_given

    !> Which Poisson's ratio enters I0, left open by the source: that of the coating (default), the substrate, the effective
    !> one, a number.
    integer, parameter :: gao_nu_surface = 0, gao_nu_substrate = 1, gao_nu_effective = 2, gao_nu_given = 3

    type, extends(coated_t) :: gao_t
        private
        logical :: in_series = .false.
        integer :: weight_nu_choice = gao_nu_surface
        real(wp) :: weight_nu = 0.0_wp
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
    end type gao_t

contains

    subroutine new_gao(self, coating, thickness, substrate, error, in_series, weight_nu_choice, weight_nu)
        type(gao_t), intent(out) :: self
        type(material_t), intent(in) :: coating, substrate
        !> h > 0 [length]
        real(wp), intent(in) :: thickness
        type(error_t), allocatable, intent(out) :: error
        !> average the compliances 1/G instead of the moduli G; far closer to the exact solution at large contrast
        logical, intent(in), optional :: in_series
        !> one of gao_nu_...; gao_nu_given takes weight_nu
        integer, intent(in), optional :: weight_nu_choice
        real(wp), intent(in), optional :: weight_nu

        call self%set_bodies(coating, thickness, substrate, error)
        if (present(in_series)) self%in_series = in_series
        if (present(weight_nu_choice)) self%weight_nu_choice = weight_nu_choice
        select case (self%weight_nu_choice)
        case (gao_nu_surface, gao_nu_effective)
            self%weight_nu = coating%poisson
        case (gao_nu_substrate)
            self%weight_nu = substrate%poisson
        case (gao_nu_given)
            if (present(weight_nu)) then
                self%weight_nu = weight_nu
                call check_poisson(error, "weight_nu", weight_nu)
            else
                call raise(error, error_invalid, "weight_nu is missing: gao_nu_given needs the number itself")
            end if
        case default
            call raise(error, error_invalid, "weight_nu_choice is not one of gao_nu_surface, gao_nu_substrate, "// &
                       "gao_nu_effective, gao_nu_given")
        end select
    end subroutine new_gao

    !> E_eff = 2 G_eff/(1 - nu_eff). Both averages are sums of weight times value with I and 1 - I each to full precision.
    elemental function effective_modulus(self, a) result(value)
        class(gao_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: xi, nu_eff

        xi = self%thickness/a
        nu_eff = self%coating%poisson*weight_i1(xi) + self%substrate%poisson*weight_j1(xi)
        value = 2.0_wp*averaged_shear(self, xi, i0_poisson(self, nu_eff))/(1.0_wp - nu_eff)
    end function effective_modulus

    elemental function effective_modulus_slope(self, a) result(value)
        class(gao_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: xi, nu_eff, nu_eff_slope, nu, weight_slope, shear, shear_slope

        xi = self%thickness/a
        nu_eff = self%coating%poisson*weight_i1(xi) + self%substrate%poisson*weight_j1(xi)
        nu_eff_slope = (self%coating%poisson - self%substrate%poisson)*weight_i1_slope(xi)
        nu = i0_poisson(self, nu_eff)
        weight_slope = weight_i0_slope(xi, nu)
        if (self%weight_nu_choice == gao_nu_effective) then
            weight_slope = weight_slope + weight_i0_poisson_slope(xi, nu)*nu_eff_slope
        end if
        shear = averaged_shear(self, xi, nu)
        if (self%in_series) then
            shear_slope = -shear**2*(1.0_wp/self%coating%shear() - 1.0_wp/self%substrate%shear())*weight_slope
        else
            shear_slope = (self%coating%shear() - self%substrate%shear())*weight_slope
        end if
        value = 2.0_wp*(shear_slope + shear*nu_eff_slope/(1.0_wp - nu_eff))/(1.0_wp - nu_eff)*(-xi/a)
    end function effective_modulus_slope

    pure function averaged_shear(self, xi, nu) result(shear)
        class(gao_t), intent(in) :: self
        real(wp), intent(in) :: xi, nu
        real(wp) :: shear

        if (self%in_series) then
            shear = 1.0_wp/(weight_i0(xi, nu)/self%coating%shear() + weight_j0(xi, nu)/self%substrate%shear())
        else
            shear = weight_i0(xi, nu)*self%coating%shear() + weight_j0(xi, nu)*self%substrate%shear()
        end if
    end function averaged_shear

    pure function i0_poisson(self, nu_eff) result(nu)
        class(gao_t), intent(in) :: self
        real(wp), intent(in) :: nu_eff
        real(wp) :: nu

        if (self%weight_nu_choice == gao_nu_effective) then
            nu = nu_eff
        else
            nu = self%weight_nu
        end if
    end function i0_poisson

end module mdrcontact_medium_gao
