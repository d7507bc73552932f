! SPDX-License-Identifier: GPL-3.0-or-later
!> An elastic material: Young's modulus E and Poisson's ratio nu, or another stiffness along z, or a stress in its plane.
module mdrcontact_material
    use mdrcontact_parameter, only: nature_poisson, parameter_t
    use mdrcontact_error, only: check_made, check_poisson, check_positive, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material_transverse, only: from_given, given_parameters, of_isotropic, transverse_t
    implicit none (type, external)
    private
    public :: material_t, moduli_t, new_material, new_transverse, in_series
    public :: isotropic

    !> A material that was given by E and nu; the other forms are those of mdrcontact_material_transverse.
    integer, parameter :: isotropic = 0

    !> Moduli of a material: real for an elastic one, complex for a viscoelastic one.
    type :: moduli_t
        !> G of waves across their plane and E* [modulus]; of an isotropic material E* = 2 G/(1 - nu)
        complex(wp) :: shear = 0.0_wp, contact = 0.0_wp
        !> nu [1]
        complex(wp) :: poisson = 0.0_wp
        !> whether it is isotropic and free of stress
        logical :: is_plain = .true.
        !> its six numbers where it is not
        type(transverse_t) :: constants = transverse_t()
    contains
        procedure :: in_plane
    end type moduli_t

    !> E and nu, checked when it is made.
    type :: material_t
        !> Young's modulus E > 0 [modulus], of one that is not isotropic in its plane
        real(wp) :: young = 0.0_wp
        !> Poisson's ratio, -1 < nu <= 1/2, likewise
        real(wp) :: poisson = 0.0_wp
        !> whether it is isotropic and free of stress
        logical :: is_plain = .true.
        !> its six numbers where it is not
        type(transverse_t) :: constants = transverse_t()
        !> isotropic, or by_stiffness and the like
        integer :: form = isotropic
        !> the five numbers of the latter
        real(wp) :: given(5) = 0.0_wp
    contains
        procedure :: parameters
        procedure :: with_parameters
        procedure :: as_transverse
        procedure :: stretch
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
        !> name of the body in error messages
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

    !> A material that is isotropic in its plane; raises unless every strain costs energy.
    pure subroutine new_transverse(self, form, numbers, error, role)
        type(material_t), intent(out) :: self
        !> by_stiffness and the like
        integer, intent(in) :: form
        !> in the order of `parameters`
        real(wp), intent(in) :: numbers(5)
        type(error_t), allocatable, intent(out) :: error
        !> name of the body in error messages
        character(len=*), intent(in) :: role
        type(transverse_t) :: constants

        call from_given(constants, form, numbers, error, role//" ")
        if (allocated(error)) return
        self%form = form
        self%given = numbers
        self%is_plain = .false.
        self%constants = constants
        ! H = E/(1 - nu^2), C66 = E/(2 (1 + nu))
        self%poisson = 1.0_wp - 2.0_wp*constants%c66/constants%h
        self%young = 2.0_wp*constants%c66*(1.0_wp + self%poisson)
    end subroutine new_transverse

    !> Its numbers, as they were given, without a stress in its plane.
    pure subroutine parameters(self, list)
        class(material_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)

        if (self%form == isotropic) then
            list = [parameter_t("E", self%young), parameter_t("nu", self%poisson, nature_poisson)]
        else
            call given_parameters(self%form, self%given, list)
        end if
    end subroutine parameters

    !> The same kind of material, free of stress, with other numbers.
    pure subroutine with_parameters(self, values, material, error, role)
        class(material_t), intent(in) :: self
        !> in the order of `parameters`
        real(wp), intent(in) :: values(:)
        type(material_t), intent(out) :: material
        type(error_t), allocatable, intent(out) :: error
        !> name of the body in error messages
        character(len=*), intent(in) :: role

        call check_made(error, "material", self%young > 0.0_wp)
        if (allocated(error)) return
        if (self%form == isotropic) then
            call new_material(material, values(1), values(2), error, role)
        else
            call new_transverse(material, self%form, values, error, role)
        end if
    end subroutine with_parameters

    !> Its six numbers, isotropic or not.
    elemental function as_transverse(self) result(constants)
        class(material_t), intent(in) :: self
        type(transverse_t) :: constants

        constants = self%constants
        if (self%is_plain) constants = of_isotropic(self%shear(), self%poisson)
    end function as_transverse

    !> Puts it under an equibiaxial stress in its plane; its constants are the tangent ones of the stressed state.
    pure subroutine stretch(self, prestress, error, role)
        class(material_t), intent(inout) :: self
        !> tension > 0 [modulus]
        real(wp), intent(in) :: prestress
        type(error_t), allocatable, intent(out) :: error
        !> name of the layer in error messages
        character(len=*), intent(in) :: role
        type(transverse_t) :: constants

        call check_made(error, "material", self%young > 0.0_wp)
        if (allocated(error)) return
        if (prestress == 0.0_wp) return
        constants = self%as_transverse()
        call constants%stretched(prestress, self%constants, error, role//" ")
        self%is_plain = .false.
    end subroutine stretch

    !> G = E/(2 (1 + nu)), or that of waves across their plane [modulus]
    elemental function shear(self) result(modulus)
        class(material_t), intent(in) :: self
        real(wp) :: modulus

        if (self%is_plain) then
            modulus = 0.5_wp*self%young/(1.0_wp + self%poisson)
        else
            modulus = self%constants%shear()
        end if
    end function shear

    !> Contact (plane-strain) modulus E* = E/(1 - nu^2), equation (2), or that of a half-space of six numbers [modulus]
    elemental function contact(self) result(modulus)
        class(material_t), intent(in) :: self
        real(wp) :: modulus

        if (self%is_plain) then
            modulus = self%young/((1.0_wp - self%poisson)*(1.0_wp + self%poisson))
        else
            modulus = self%constants%contact()
        end if
    end function contact

    !> G* = 4 G/(2 - nu), which takes the place of E* where a contact is sheared: k_t = 2 a G* [modulus]. Of six numbers
    !> 4/(k C_L + k C_T).
    elemental function tangential(self) result(modulus)
        class(material_t), intent(in) :: self
        real(wp) :: modulus

        type(moduli_t) :: moduli

        if (self%is_plain) then
            modulus = 4.0_wp*self%shear()/(2.0_wp - self%poisson)
        else
            moduli = self%moduli()
            modulus = real(4.0_wp/(1.0_wp/moduli%in_plane() + 1.0_wp/moduli%shear), wp)
        end if
    end function tangential

    !> G, E* and nu.
    elemental function moduli(self) result(values)
        class(material_t), intent(in) :: self
        type(moduli_t) :: values

        values = moduli_t(cmplx(self%shear(), kind=wp), cmplx(self%contact(), kind=wp), cmplx(self%poisson, kind=wp), &
                          self%is_plain, self%constants)
    end function moduli

    !> 1/(k C_L), what a half-space opposes to a traction along the wave: G/(1 - nu) of an isotropic one [modulus]
    elemental function in_plane(self) result(modulus)
        class(moduli_t), intent(in) :: self
        complex(wp) :: modulus
        type(transverse_t) :: six

        if (self%is_plain) then
            modulus = 0.5_wp*self%contact
        else
            six = self%constants
            modulus = six%along()
        end if
    end function in_plane

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
