! SPDX-License-Identifier: GPL-3.0-or-later
!> Coating after Doerner and Nix (theory/paper.md (3.8)): the compliances of coating and substrate with an exponential weight.
!> Doerner, Nix, J. Mater. Res. 1 (1986) 601; Popov 2014, equation (11).
module mdrcontact_medium_doerner_nix
    use mdrcontact_error, only: check_made, check_positive, error_t
    use mdrcontact_numerics_exponential, only: one_minus_exp, transition_exponents
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_coated, only: coated_t
    use mdrcontact_numerics_quadrature, only: merge_breaks
    implicit none (type, external)
    private
    public :: doerner_nix_t, new_doerner_nix

    !> 1/E_eff = (1 - exp(-alpha h/a))/E*_0 + exp(-alpha h/a)/E*_1.
    type, extends(coated_t) :: doerner_nix_t
        private
        real(wp) :: alpha = 1.0_wp
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
        procedure :: add_breaks
    end type doerner_nix_t

contains

    !> A coating after Doerner and Nix.
    subroutine new_doerner_nix(self, coating, thickness, substrate, error, alpha)
        type(doerner_nix_t), intent(out) :: self
        type(material_t), intent(in) :: coating, substrate
        !> h > 0 [length]
        real(wp), intent(in) :: thickness
        type(error_t), allocatable, intent(out) :: error
        !> decay constant > 0 of the exponential, about 1; default 1
        real(wp), intent(in), optional :: alpha

        call check_made(error, "coating", coating%young > 0.0_wp)
        call check_made(error, "substrate", substrate%young > 0.0_wp)
        if (allocated(error)) return
        call self%set_bodies(coating, thickness, substrate, error)
        if (present(alpha)) then
            call check_positive(error, "alpha", alpha)
            self%alpha = alpha
        end if
        self%is_made = .not. allocated(error)
    end subroutine new_doerner_nix

    elemental function effective_modulus(self, a) result(value)
        class(doerner_nix_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: y

        y = self%alpha*self%thickness/a
        value = 1.0_wp/(one_minus_exp(y)/self%coating%contact() + exp(-y)/self%substrate%contact())
    end function effective_modulus

    elemental function effective_modulus_slope(self, a) result(value)
        class(doerner_nix_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: y

        y = self%alpha*self%thickness/a
        value = -self%effective_modulus(a)**2*(1.0_wp/self%substrate%contact() - 1.0_wp/self%coating%contact()) &
                *exp(-y)*(y/a)
    end function effective_modulus_slope

    !> At a large contrast the exponential switches from one body to the other within a small range of radii.
    pure subroutine add_breaks(self, radii, error)
        class(doerner_nix_t), intent(in) :: self
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: y(:)

        allocate (y, source=transition_exponents(self%coating%contact()/self%substrate%contact()))
        call merge_breaks(radii, self%alpha*self%thickness/y(size(y):1:-1), error)
    end subroutine add_breaks

end module mdrcontact_medium_doerner_nix
