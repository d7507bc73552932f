! SPDX-License-Identifier: GPL-3.0-or-later
!> Coating by wave interpolation (theory/paper.md (3.9)): the surface stiffness of a coated body under a shear wave of wavenumber
!> q ~ 1/a. Popov 2014, equations (19) and (20).
module mdrcontact_medium_wave
    use mdrcontact_error, only: check_made, check_positive, error_t
    use mdrcontact_numerics_exponential, only: one_minus_exp
    use mdrcontact_weights, only: weight_i1, weight_i1_slope, weight_j1
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_coated, only: coated_t
    implicit none (type, external)
    private
    public :: wave_t, new_wave

    !> G_eff = G0 [(G0 + G1) - (G0 - G1) e]/[(G0 + G1) + (G0 - G1) e] with e = exp(-2 q h), nu_eff by I1.
    type, extends(coated_t) :: wave_t
        private
        !> q a
        real(wp) :: wave_factor = half_pi
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
    end type wave_t

contains

    !> A coating by wave interpolation.
    subroutine new_wave(self, coating, thickness, substrate, error, wave_factor)
        type(wave_t), intent(out) :: self
        type(material_t), intent(in) :: coating, substrate
        !> h > 0 [length]
        real(wp), intent(in) :: thickness
        type(error_t), allocatable, intent(out) :: error
        !> q a > 0, the wavenumber in units of 1/a; default pi/2
        real(wp), intent(in), optional :: wave_factor

        call check_made(error, "coating", coating%young > 0.0_wp)
        call check_made(error, "substrate", substrate%young > 0.0_wp)
        if (allocated(error)) return
        call self%set_bodies(coating, thickness, substrate, error)
        if (present(wave_factor)) then
            call check_positive(error, "wave_factor", wave_factor)
            self%wave_factor = wave_factor
        end if
        self%is_made = .not. allocated(error)
    end subroutine new_wave

    elemental function effective_modulus(self, a) result(value)
        class(wave_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: shear, nu

        call shear_and_poisson(self, a, shear, nu)
        value = 2.0_wp*shear/(1.0_wp - nu)
    end function effective_modulus

    elemental function effective_modulus_slope(self, a) result(value)
        class(wave_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: shear, nu, xi, nu_slope, y, g0, g1, denominator, shear_slope

        call shear_and_poisson(self, a, shear, nu)
        xi = self%thickness/a
        nu_slope = -xi/a*(self%coating%poisson - self%substrate%poisson)*weight_i1_slope(xi)
        ! dG_eff/dy, y = 2 q h, follows from G_eff = G0 (D - 2 (G0 - G1) e)/D with D the denominator.
        y = 2.0_wp*self%wave_factor*xi
        g0 = self%coating%shear()
        g1 = self%substrate%shear()
        denominator = g0*(1.0_wp + exp(-y)) + g1*one_minus_exp(y)
        shear_slope = 2.0_wp*g0*((g0 - g1)/denominator)*((g0 + g1)/denominator)*exp(-y)*(-y/a)
        value = 2.0_wp*(shear_slope + shear*nu_slope/(1.0_wp - nu))/(1.0_wp - nu)
    end function effective_modulus_slope

    pure subroutine shear_and_poisson(self, a, shear, nu)
        class(wave_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp), intent(out) :: shear, nu
        real(wp) :: xi, y, g0, g1

        xi = self%thickness/a
        y = 2.0_wp*self%wave_factor*xi
        g0 = self%coating%shear()
        g1 = self%substrate%shear()
        shear = g0*(g0*one_minus_exp(y) + g1*(1.0_wp + exp(-y)))/(g0*(1.0_wp + exp(-y)) + g1*one_minus_exp(y))
        nu = self%coating%poisson*weight_i1(xi) + self%substrate%poisson*weight_j1(xi)
    end subroutine shear_and_poisson

end module mdrcontact_medium_wave
