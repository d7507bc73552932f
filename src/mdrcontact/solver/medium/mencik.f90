! SPDX-License-Identifier: GPL-3.0-or-later
!> Coating after Mencik (theory/paper.md (3.10)): moduli, or compliances, with a weight that decays with a/h.
!> Mencik, Munz, Quandt, Weppelmann, Swain, J. Mater. Res. 12 (1997) 2475.
module mdrcontact_medium_mencik
    use mdrcontact_error, only: check_made, check_positive, error_t
    use mdrcontact_numerics_exponential, only: one_minus_exp, transition_exponents
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_coated, only: coated_t
    use mdrcontact_numerics_quadrature, only: merge_breaks
    implicit none (type, external)
    private
    public :: mencik_t, new_mencik

    !> E' = E'_1 + (E'_0 - E'_1) exp(-alpha a/h), or the same in 1/E' (reciprocal), with E' = E*.
    type, extends(coated_t) :: mencik_t
        private
        logical :: reciprocal = .false.
        real(wp) :: alpha = 1.0_wp
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
        procedure :: add_breaks
    end type mencik_t

contains

    !> A coating after Mencik.
    subroutine new_mencik(self, coating, thickness, substrate, error, reciprocal, alpha)
        type(mencik_t), intent(out) :: self
        type(material_t), intent(in) :: coating, substrate
        !> h > 0 [length]
        real(wp), intent(in) :: thickness
        type(error_t), allocatable, intent(out) :: error
        !> interpolate 1/E' instead of E'; default false
        logical, intent(in), optional :: reciprocal
        !> decay constant > 0, usually fitted; default 1
        real(wp), intent(in), optional :: alpha

        call check_made(error, "coating", coating%young > 0.0_wp)
        call check_made(error, "substrate", substrate%young > 0.0_wp)
        if (allocated(error)) return
        call self%set_bodies(coating, thickness, substrate, error)
        if (present(reciprocal)) self%reciprocal = reciprocal
        if (present(alpha)) then
            call check_positive(error, "alpha", alpha)
            self%alpha = alpha
        end if
        self%is_made = .not. allocated(error)
    end subroutine new_mencik

    elemental function effective_modulus(self, a) result(value)
        class(mencik_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: y

        y = self%alpha*a/self%thickness
        if (self%reciprocal) then
            value = 1.0_wp/(exp(-y)/self%coating%contact() + one_minus_exp(y)/self%substrate%contact())
        else
            value = exp(-y)*self%coating%contact() + one_minus_exp(y)*self%substrate%contact()
        end if
    end function effective_modulus

    elemental function effective_modulus_slope(self, a) result(value)
        class(mencik_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: decay

        decay = -self%alpha/self%thickness*exp(-self%alpha*a/self%thickness)
        if (self%reciprocal) then
            value = -self%effective_modulus(a)**2*(1.0_wp/self%coating%contact() - 1.0_wp/self%substrate%contact())*decay
        else
            value = (self%coating%contact() - self%substrate%contact())*decay
        end if
    end function effective_modulus_slope

    !> At a large contrast the exponential switches from one body to the other within a small range of radii.
    pure subroutine add_breaks(self, radii, error)
        class(mencik_t), intent(in) :: self
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: y(:)

        allocate (y, source=transition_exponents(self%coating%contact()/self%substrate%contact()))
        call merge_breaks(radii, y*self%thickness/self%alpha, error)
    end subroutine add_breaks

end module mdrcontact_medium_mencik
