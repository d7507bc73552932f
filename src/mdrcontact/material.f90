! SPDX-License-Identifier: GPL-3.0-or-later
!> An isotropic elastic material: Young's modulus E and Poisson's ratio nu.
module mdrcontact_material
    use mdrcontact_error, only: check_poisson, check_positive, error_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: material_t, moduli_t, new_material, in_series

    !> What an isotropic material opposes to a load: real of an elastic one, complex of one that relaxes.
    type :: moduli_t
        !> G and E* = 2 G/(1 - nu) [modulus]
        complex(wp) :: shear = 0.0_wp, contact = 0.0_wp
        !> nu [1]
        complex(wp) :: poisson = 0.0_wp
    end type moduli_t

    !> E and nu, checked when it is made.
    type :: material_t
        !> Young's modulus E > 0 [modulus]
        real(wp) :: young = 0.0_wp
        !> Poisson's ratio, -1 < nu <= 1/2
        real(wp) :: poisson = 0.0_wp
    contains
        procedure :: shear
        procedure :: contact
        procedure :: tangential
        procedure :: moduli
    end type material_t

contains

    !> A material of Young's modulus E and Poisson's ratio nu. `role` names the body in an error message ("coating", ...).
    pure subroutine new_material(self, young, poisson, error, role)
        type(material_t), intent(out) :: self
        !> E > 0 [modulus], and -1 < nu <= 1/2 [1]
        real(wp), intent(in) :: young, poisson
        type(error_t), allocatable, intent(out) :: error
        !> what the body is called in an error message
        character(len=*), intent(in), optional :: role
        character(len=:), allocatable :: prefix

        prefix = ""
        if (present(role)) prefix = role//" "
        call check_positive(error, prefix//"E", young)
        call check_poisson(error, prefix//"nu", poisson)
        if (allocated(error)) return
        self%young = young
        self%poisson = poisson
    end subroutine new_material

    !> G = E/(2 (1 + nu)) [modulus]
    elemental function shear(self) result(modulus)
        class(material_t), intent(in) :: self
        real(wp) :: modulus

        modulus = 0.5_wp*self%young/(1.0_wp + self%poisson)
    end function shear

    !> Contact (plane-strain) modulus E* = E/(1 - nu^2), equation (2) [modulus]
    elemental function contact(self) result(modulus)
        class(material_t), intent(in) :: self
        real(wp) :: modulus

        modulus = self%young/((1.0_wp - self%poisson)*(1.0_wp + self%poisson))
    end function contact

    !> G* = 4 G/(2 - nu), which takes the place of E* where a contact is sheared: k_t = 2 a G* [modulus]
    elemental function tangential(self) result(modulus)
        class(material_t), intent(in) :: self
        real(wp) :: modulus

        modulus = 4.0_wp*self%shear()/(2.0_wp - self%poisson)
    end function tangential

    !> G, E* and nu.
    elemental function moduli(self) result(values)
        class(material_t), intent(in) :: self
        type(moduli_t) :: values

        values = moduli_t(cmplx(self%shear(), kind=wp), cmplx(self%contact(), kind=wp), cmplx(self%poisson, kind=wp))
    end function moduli

    !> The modulus of two bodies under the same pressure, 1/E* = 1/E1* + 1/E2*. An infinite one is a rigid body and leaves the other
    !> as it is, to the last digit.
    elemental function in_series(first, second) result(modulus)
        !> > 0, not both infinite [modulus]
        real(wp), intent(in) :: first, second
        real(wp) :: modulus

        modulus = min(first, second)
        modulus = modulus/(1.0_wp + modulus/max(first, second))
    end function in_series

end module mdrcontact_material
