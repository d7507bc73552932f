! SPDX-License-Identifier: GPL-3.0-or-later
!> Interface between two layers: springs per area, normal and along the surface. Tractions pass unchanged, displacements jump by
!> traction over stiffness (theory/surfaces.md (3.1), (3.2)).
module mdrcontact_body_elements_interface
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_parameter, only: parameter_t
    use mdrcontact_body_elements_element, only: element_t
    use mdrcontact_error, only: check_not_negative, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: interface_t, bond_t, bond_of, check_bond, new_interface

    !> Contribution of a sliding interface to the compliance along the surface: all other terms are negligible compared with it, so
    !> that the result equals the limit to the last digit.
    real(wp), parameter :: sliding_compliance = 1.0e100_wp

    !> Bond of two layers: compliances per area, 0 if they are bonded rigidly.
    type :: bond_t
        !> 1/K_n and 1/K_t; an infinite second one slides without friction [length/modulus]
        real(wp) :: normal = 0.0_wp, tangential = 0.0_wp
    contains
        procedure :: parameters
        procedure :: is_bonded
        procedure :: slides
        procedure :: has_springs
        procedure :: per_length
    end type bond_t

    !> An interface.
    type, extends(element_t) :: interface_t
        private
        !> 2 G/K_t and 2 G/K_n [length]
        complex(wp) :: jump(2) = 0.0_wp
        logical :: slides = .false.
    contains
        procedure :: above
        procedure :: reflected
        procedure :: above_across
        procedure :: reflected_across
        procedure :: softness
    end type interface_t

contains

    !> K_n and K_t [modulus/length]: infinite where it is bonded, 0 where it slides.
    pure function parameters(self) result(list)
        class(bond_t), intent(in) :: self
        type(parameter_t) :: list(2)

        list = [parameter_t("interface.normal", inverse(self%normal)), &
                parameter_t("interface.tangential", inverse(self%tangential))]
    end function parameters

    !> The bond of springs.
    pure function bond_of(stiffnesses) result(bond)
        !> K_n and K_t, as `parameters` has them [modulus/length]
        real(wp), intent(in) :: stiffnesses(2)
        type(bond_t) :: bond

        bond = bond_t(inverse(stiffnesses(1)), inverse(stiffnesses(2)))
    end function bond_of

    !> 1/x, without a flag.
    elemental function inverse(x) result(y)
        !> >= 0
        real(wp), intent(in) :: x
        real(wp) :: y

        y = infinity
        if (abs(x) > 0.0_wp) y = 1.0_wp/x
    end function inverse

    !> Whether nothing gives.
    elemental function is_bonded(self) result(answer)
        class(bond_t), intent(in) :: self
        logical :: answer

        answer = .not. max(self%normal, self%tangential) > 0.0_wp
    end function is_bonded

    !> Whether there is no stiffness along the surface.
    elemental function slides(self) result(answer)
        class(bond_t), intent(in) :: self
        logical :: answer

        answer = self%tangential > huge(1.0_wp)
    end function slides

    !> Whether it gives, and has a stiffness: what slides has no unit.
    elemental function has_springs(self) result(answer)
        class(bond_t), intent(in) :: self
        logical :: answer

        answer = self%normal > 0.0_wp .or. (self%tangential > 0.0_wp .and. .not. self%slides())
    end function has_springs

    !> The same with another unit of length.
    elemental function per_length(self, unit) result(scaled)
        class(bond_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: unit
        type(bond_t) :: scaled

        scaled = bond_t(self%normal/unit, self%tangential/unit)
    end function per_length

    !> Raises unless compliances are at least 0, and the normal one is finite.
    pure subroutine check_bond(bond, error)
        type(bond_t), intent(in) :: bond
        type(error_t), allocatable, intent(inout) :: error

        call check_not_negative(error, "normal_compliance", bond%normal)
        if (.not. bond%slides()) call check_not_negative(error, "tangential_compliance", bond%tangential)
    end subroutine check_bond

    !> The interface of a bond.
    pure subroutine new_interface(self, bond, surface_shear)
        type(interface_t), intent(out) :: self
        type(bond_t), intent(in) :: bond
        !> G of the body's surface [modulus]
        complex(wp), intent(in) :: surface_shear

        self%slides = bond%slides()
        self%jump = 2.0_wp*surface_shear*[merge(0.0_wp, bond%tangential, self%slides), bond%normal]
        ! below waves that do not reach it stands what they do not see
        self%half_space(1, 1) = -1.0_wp
        self%half_space(2, 2) = -1.0_wp
        self%half_space_across = 1.0_wp
    end subroutine new_interface

    !> The longer one of 2 G/K_n and, where it does not slide, 2 G/K_t [length]
    pure function softness(self) result(length)
        class(interface_t), intent(in) :: self
        real(wp) :: length

        length = maxval(abs(self%jump))
    end function softness

    pure function above(self, k, below) result(compliance)
        class(interface_t), intent(in) :: self
        complex(wp), intent(in) :: k, below(2, 2)
        complex(wp) :: compliance(2, 2)

        compliance = below
        compliance(1, 1) = compliance(1, 1) - k*self%jump(1)
        compliance(2, 2) = compliance(2, 2) - k*self%jump(2)
        if (self%slides) compliance(1, 1) = compliance(1, 1) - sliding_compliance
    end function above

    !> Compliances of what is no half-space are taken whole.
    pure function reflected(self, k, below) result(compliance)
        class(interface_t), intent(in) :: self
        complex(wp), intent(in) :: k, below(2, 2)
        complex(wp) :: compliance(2, 2)

        compliance = self%above(k, below) - self%half_space
    end function reflected

    pure function above_across(self, k, below) result(compliance)
        class(interface_t), intent(in) :: self
        complex(wp), intent(in) :: k, below
        complex(wp) :: compliance

        compliance = below + 0.5_wp*k*self%jump(1)
        if (self%slides) compliance = compliance + sliding_compliance
    end function above_across

    pure function reflected_across(self, k, below) result(compliance)
        class(interface_t), intent(in) :: self
        complex(wp), intent(in) :: k, below
        complex(wp) :: compliance

        compliance = self%above_across(k, below) - self%half_space_across
    end function reflected_across

end module mdrcontact_body_elements_interface
