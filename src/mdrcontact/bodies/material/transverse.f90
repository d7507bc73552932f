! SPDX-License-Identifier: GPL-3.0-or-later
!> The elastic constants of a layer that is isotropic in its plane, with another stiffness along its normal z, and under a stress
!> in its plane.
!>
!> Six numbers, all finite for incompressible media: s44 = 1/C44, s33 = 1/C33, c = C13/C33, H = C11 - C13^2/C33,
!> C66 = (C11 - C12)/2 and the equibiaxial stress sigma_0, tension > 0. An isotropic medium has H = 2 G/(1 - nu), c = nu/(1 - nu),
!> s33 = (1 - 2 nu)/(2 G (1 - nu)), s44 = 1/G and C66 = G. With z into the body, derivatives with respect to kz and the amplitudes
!> v = (k U, S), w = (k W, T) of displacements U, W and stresses T = sigma_rz, S = sigma_zz: v' = A w, w' = B v,
!>     A = (1, s44; sigma_0, -1),   B = (-c, s33; H + sigma_0, c).
!> theory/surfaces.md (1.1)-(1.7); Elliott 1948, Proc. Camb. Phil. Soc. 44, 522; of a prestressed layer Biot 1965, Mechanics of
!> Incremental Deformations.
module mdrcontact_material_transverse
    use mdrcontact_parameter, only: nature_signed, parameter_t
    use mdrcontact_error, only: check_positive, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: transverse_t, from_given, from_stiffness, from_engineering, given_parameters, of_isotropic
    public :: by_stiffness, by_engineering

    !> Forms of the constants: C11, C12, C13, C33, C44; E_t, E_z, nu_t, nu_tz, G_z. 0 is an isotropic material.
    integer, parameter :: by_stiffness = 1, by_engineering = 2

    !> The six numbers. Made by the procedures of this module, never changed.
    type :: transverse_t
        !> 1/C44 and 1/C33 [1/modulus], C13/C33 [1]
        real(wp) :: s44 = 0.0_wp, s33 = 0.0_wp, c = 0.0_wp
        !> H, C66 and sigma_0 [modulus]
        real(wp) :: h = 0.0_wp, c66 = 0.0_wp, prestress = 0.0_wp
    contains
        procedure :: stretched
        procedure :: vanishing
        procedure :: root_product
        procedure :: root_square_sum
        procedure :: root_sum
        procedure :: decay
        procedure :: contact
        procedure :: along
        procedure :: shear
        procedure :: shear_decay
        procedure :: scaled
    end type transverse_t

contains

    !> From the numbers of a form; raises unless every strain costs energy.
    pure subroutine from_given(self, form, numbers, error, prefix)
        type(transverse_t), intent(out) :: self
        !> by_stiffness or by_engineering
        integer, intent(in) :: form
        !> in the order of `given_parameters`
        real(wp), intent(in) :: numbers(5)
        type(error_t), allocatable, intent(inout) :: error
        !> name of the body in error messages, with a blank behind it, or nothing
        character(len=*), intent(in) :: prefix

        associate (n => numbers)
            if (form == by_stiffness) then
                call from_stiffness(self, n(1), n(2), n(3), n(4), n(5), error, prefix)
            else
                call from_engineering(self, n(1), n(2), n(3), n(4), n(5), error, prefix)
            end if
        end associate
    end subroutine from_given

    !> The numbers of a form, by their names.
    pure subroutine given_parameters(form, numbers, list)
        !> by_stiffness or by_engineering
        integer, intent(in) :: form
        real(wp), intent(in) :: numbers(5)
        type(parameter_t), allocatable, intent(out) :: list(:)

        associate (n => numbers)
            if (form == by_stiffness) then
                list = [parameter_t("C11", n(1)), parameter_t("C12", n(2), nature_signed, n(1)), &
                        parameter_t("C13", n(3), nature_signed, n(4)), parameter_t("C33", n(4)), parameter_t("C44", n(5))]
            else
                list = [parameter_t("E_t", n(1)), parameter_t("E_z", n(2)), parameter_t("nu_t", n(3), nature_signed, 1.0_wp), &
                        parameter_t("nu_tz", n(4), nature_signed, 1.0_wp), parameter_t("G_z", n(5))]
            end if
        end associate
    end subroutine given_parameters

    !> From the stiffness matrix; raises unless every strain costs energy.
    pure subroutine from_stiffness(self, c11, c12, c13, c33, c44, error, prefix)
        type(transverse_t), intent(out) :: self
        !> C44 > 0, C11 > |C12|, C33 > 0, C33 (C11 + C12) > 2 C13^2 [modulus]
        real(wp), intent(in) :: c11, c12, c13, c33, c44
        type(error_t), allocatable, intent(out) :: error
        !> name of the body in error messages, with a blank behind it, or nothing
        character(len=*), intent(in) :: prefix

        call check_positive(error, prefix//"C11", c11)
        call check_positive(error, prefix//"C33", c33)
        call check_positive(error, prefix//"C44", c44)
        call check_condition(error, abs(c12) < c11, prefix//"C12", c12, "|C12| < C11 = "//to_text(c11))
        call check_condition(error, 2.0_wp*c13**2 < c33*(c11 + c12), prefix//"C13", c13, "2 C13^2 < C33 (C11 + C12), which is "// &
                             to_text(c33*(c11 + c12)))
        if (allocated(error)) return
        self%s44 = 1.0_wp/c44
        self%s33 = 1.0_wp/c33
        self%c = c13/c33
        self%h = c11 - self%c*c13
        self%c66 = 0.5_wp*(c11 - c12)
    end subroutine from_stiffness

    !> From Young's moduli, Poisson's ratios and the shear modulus of planes that hold z.
    pure subroutine from_engineering(self, e_t, e_z, nu_t, nu_tz, g_z, error, prefix)
        type(transverse_t), intent(out) :: self
        !> in the plane and along z, > 0 [modulus]
        real(wp), intent(in) :: e_t, e_z
        !> in the plane, |nu_t| < 1; and -strain along z over strain in the plane under a stress in the plane, with
        !> 2 nu_tz^2 E_z/E_t <= 1 - nu_t (equal: incompressible) [1]
        real(wp), intent(in) :: nu_t, nu_tz
        !> > 0 [modulus]
        real(wp), intent(in) :: g_z
        type(error_t), allocatable, intent(out) :: error
        !> name of the body in error messages, with a blank behind it, or nothing
        character(len=*), intent(in) :: prefix
        real(wp) :: rest

        call check_positive(error, prefix//"E_t", e_t)
        call check_positive(error, prefix//"E_z", e_z)
        call check_positive(error, prefix//"G_z", g_z)
        call check_condition(error, abs(nu_t) < 1.0_wp, prefix//"nu_t", nu_t, "-1 < nu_t < 1")
        if (allocated(error)) return
        rest = 1.0_wp - nu_t - 2.0_wp*nu_tz*nu_tz*e_z/e_t
        ! an incompressible medium has no rest but for rounding
        if (abs(rest) <= 4.0_wp*epsilon(1.0_wp)) rest = 0.0_wp
        call check_condition(error, rest >= 0.0_wp, prefix//"nu_tz", nu_tz, "2 nu_tz^2 E_z/E_t <= 1 - nu_t = "// &
                             to_text(1.0_wp - nu_t))
        if (allocated(error)) return
        self%h = e_t/((1.0_wp - nu_t)*(1.0_wp + nu_t))
        self%c = nu_tz/(1.0_wp - nu_t)
        self%s33 = rest/(e_z*(1.0_wp - nu_t))
        self%s44 = 1.0_wp/g_z
        self%c66 = 0.5_wp*e_t/(1.0_wp + nu_t)
    end subroutine from_engineering

    pure subroutine check_condition(error, holds, name, value, condition)
        type(error_t), allocatable, intent(inout) :: error
        logical, intent(in) :: holds
        character(len=*), intent(in) :: name, condition
        real(wp), intent(in) :: value

        if (allocated(error) .or. holds) return
        call raise(error, error_invalid, name//" = "//to_text(value)//": a positive strain energy needs "//condition)
    end subroutine check_condition

    !> Constants of an isotropic medium.
    elemental function of_isotropic(shear, poisson) result(self)
        !> G > 0 [modulus], and nu [1]
        real(wp), intent(in) :: shear, poisson
        type(transverse_t) :: self

        self%s44 = 1.0_wp/shear
        self%s33 = (1.0_wp - 2.0_wp*poisson)/(2.0_wp*shear*(1.0_wp - poisson))
        self%c = poisson/(1.0_wp - poisson)
        self%h = 2.0_wp*shear/(1.0_wp - poisson)
        self%c66 = shear
    end function of_isotropic

    !> The same under an equibiaxial stress in the plane; the constants are the tangent ones of the stressed state.
    pure subroutine stretched(self, prestress, stressed, error, prefix)
        class(transverse_t), intent(in) :: self
        !> tension > 0 [modulus]
        real(wp), intent(in) :: prestress
        type(transverse_t), intent(out) :: stressed
        type(error_t), allocatable, intent(out) :: error
        !> name of the layer in error messages, with a blank behind it, or nothing
        character(len=*), intent(in) :: prefix
        character(len=:), allocatable :: words
        logical :: is_stable

        stressed = transverse_t(self%s44, self%s33, self%c, self%h, self%c66, prestress)
        is_stable = abs(prestress) <= huge(1.0_wp)
        if (is_stable) is_stable = 1.0_wp + prestress*self%s44 > 0.0_wp .and. self%c66 + prestress > 0.0_wp .and. &
                                   self%c**2 + (self%h + prestress)*self%s33 > 0.0_wp .and. self%h + prestress > 0.0_wp
        if (is_stable) is_stable = stressed%root_square_sum() + 2.0_wp*stressed%root_product() > 0.0_wp
        if (is_stable) is_stable = stressed%contact() > 0.0_wp
        if (is_stable) return
        words = ": a surface of this material is unstable under this compression"
        if (.not. abs(prestress) <= huge(1.0_wp)) words = ": it must be finite"
        call raise(error, error_invalid, prefix//"prestress = "//to_text(prestress)//words)
    end subroutine stretched

    !> Text that names the invalid constants, which are 0 or less.
    pure subroutine vanishing(self, words)
        class(transverse_t), intent(in) :: self
        !> which stiffness, as part of a sentence
        character(len=:), allocatable, intent(out) :: words

        if (.not. self%c66 + self%prestress > 0.0_wp) then
            words = "C66 + prestress, its stiffness in shear in its plane,"
        else if (.not. 1.0_wp + self%prestress*self%s44 > 0.0_wp) then
            words = "C44 + prestress, its stiffness in shear along its normal,"
        else if (.not. self%h + self%prestress > 0.0_wp) then
            words = "C11 - C13^2/C33 + prestress, its stiffness in its plane,"
        else if (.not. self%c**2 + (self%h + self%prestress)*self%s33 > 0.0_wp) then
            words = "C11 + prestress, its stiffness in its plane,"
        else if (.not. self%root_square_sum() + 2.0_wp*self%root_product() > 0.0_wp) then
            words = "the stiffness of shear bands in it"
        else
            words = "the stiffness of a surface of it"
        end if
    end subroutine vanishing

    !> P, the product of the two roots lambda of the waves exp(-lambda k z): 1 of an isotropic medium.
    elemental function root_product(self) result(p)
        class(transverse_t), intent(in) :: self
        real(wp) :: p

        p = sqrt((1.0_wp + self%prestress*self%s44)*(self%c**2 + (self%h + self%prestress)*self%s33))
    end function root_product

    !> m, the sum of their squares.
    elemental function root_square_sum(self) result(m)
        class(transverse_t), intent(in) :: self
        real(wp) :: m

        m = (self%h + self%prestress)*self%s44 - 2.0_wp*self%c + self%prestress*self%s33
    end function root_square_sum

    !> Their sum.
    elemental function root_sum(self) result(total)
        class(transverse_t), intent(in) :: self
        real(wp) :: total

        total = sqrt(self%root_square_sum() + 2.0_wp*self%root_product())
    end function root_sum

    !> The smallest real part of lambda, that of waves across the plane included.
    elemental function decay(self) result(smallest)
        class(transverse_t), intent(in) :: self
        real(wp) :: smallest
        real(wp) :: total, p, difference

        total = self%root_sum()
        p = self%root_product()
        smallest = 0.5_wp*total
        difference = self%root_square_sum() - 2.0_wp*p
        if (difference > 0.0_wp) smallest = 2.0_wp*p/(total + sqrt(difference))
        smallest = min(smallest, self%shear_decay())
    end function decay

    !> 1/(k C_L) of a half-space, which a traction along the wave displaces by that traction over it times k [modulus]
    elemental function along(self) result(modulus)
        class(transverse_t), intent(in) :: self
        real(wp) :: modulus
        real(wp) :: q(2, 2), z(2, 2)

        call square_root(self, q, z)
        modulus = z(2, 1)
    end function along

    !> Contact modulus E* of a half-space: its surface sinks by 2 p/(E* k) under a wave of pressure [modulus]. Delafargue, Ulm 2004,
    !> Int. J. Solids Struct. 41, 7351.
    elemental function contact(self) result(modulus)
        class(transverse_t), intent(in) :: self
        real(wp) :: modulus
        real(wp) :: q(2, 2), z(2, 2)

        if (self%prestress == 0.0_wp) then
            modulus = 2.0_wp*self%h/(self%root_product()*self%root_sum())
        else
            call square_root(self, q, z)
            modulus = -2.0_wp*z(2, 1)/(z(1, 1)*z(2, 2) - z(1, 2)*z(2, 1))
        end if
    end function contact

    !> Q = sqrt(A B) and Z = A^-1 Q.
    pure subroutine square_root(self, q, z)
        class(transverse_t), intent(in) :: self
        real(wp), intent(out) :: q(2, 2), z(2, 2)
        real(wp) :: p, sigma, stiff

        sigma = self%prestress
        stiff = self%h + sigma
        p = self%root_product()
        q(1, :) = [-self%c + self%s44*stiff + p, self%s33 + self%s44*self%c]
        q(2, :) = [-sigma*self%c - stiff, sigma*self%s33 - self%c + p]
        q = q/self%root_sum()
        z(1, :) = (q(1, :) + self%s44*q(2, :))/(1.0_wp + sigma*self%s44)
        z(2, :) = (sigma*q(1, :) - q(2, :))/(1.0_wp + sigma*self%s44)
    end subroutine square_root

    !> G = sqrt((C66 + sigma_0) C44) of waves across the plane, k C_T = 1/G [modulus]
    elemental function shear(self) result(modulus)
        class(transverse_t), intent(in) :: self
        real(wp) :: modulus

        modulus = sqrt((self%c66 + self%prestress)/self%s44)
    end function shear

    !> lambda of waves across the plane.
    elemental function shear_decay(self) result(root)
        class(transverse_t), intent(in) :: self
        real(wp) :: root

        root = sqrt((self%c66 + self%prestress)*self%s44)
    end function shear_decay

    !> Moduli in units of another.
    elemental function scaled(self, unit) result(relative)
        class(transverse_t), intent(in) :: self
        !> > 0 [modulus]
        real(wp), intent(in) :: unit
        type(transverse_t) :: relative

        relative = transverse_t(self%s44*unit, self%s33*unit, self%c, self%h/unit, self%c66/unit, self%prestress/unit)
    end function scaled

end module mdrcontact_material_transverse
