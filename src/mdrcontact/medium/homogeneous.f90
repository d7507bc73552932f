! SPDX-License-Identifier: GPL-3.0-or-later
!> The homogeneous half-space (theory 2): the same modulus at every contact radius, and closed forms for every indenter.
module mdrcontact_medium_homogeneous
    use, intrinsic :: iso_c_binding, only: c_int
    use mdrcontact_base_nonfinite, only: infinity
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_error, only: check_positive, error_invalid, error_t, raise
    use mdrcontact_gsl, only: gsl_sf_ellint_ecomp, gsl_sf_ellint_kcomp
    use mdrcontact_kinds, only: wp
    use mdrcontact_layered_kernel, only: kernel_t
    use mdrcontact_layered_moments, only: is_smooth, profile_moments
    use mdrcontact_material, only: in_series, material_t
    use mdrcontact_medium_solver, only: set_pair, solver_t
    use mdrcontact_medium_effective, only: effective_medium_t
    use mdrcontact_medium_shear_moduli, only: moduli_under_shear
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: homogeneous_t, new_homogeneous, new_homogeneous_from_modulus, new_homogeneous_pair, new_rigid

    !> Terms of a series: a paraboloid has two.
    integer, parameter :: terms = 12

    !> A half-space of one material, or two of them pressed together.
    type, extends(effective_medium_t) :: homogeneous_t
        private
        !> E* [modulus]
        real(wp) :: contact_modulus = 0.0_wp
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
        procedure :: depth_and_force
        procedure :: line_load_series
        procedure :: half_space_modulus
        procedure :: new_tangential
        procedure :: disc_products
        procedure :: interaction
        procedure :: torsional_stiffness
        procedure :: springs
    end type homogeneous_t

contains

    !> A half-space of one material, pressed by a rigid indenter.
    subroutine new_homogeneous(self, material)
        type(homogeneous_t), intent(out) :: self
        type(material_t), intent(in) :: material
        type(stack_t) :: body
        type(error_t), allocatable :: error

        call set_modulus(self, material%contact())
        call new_stack(body, [material_t ::], [real(wp) ::], material, error)
        if (.not. allocated(error)) allocate (self%pressed, source=body)
    end subroutine new_homogeneous

    !> A rigid half-space: one body of a pair, no medium by itself.
    subroutine new_rigid(self)
        type(homogeneous_t), intent(out) :: self

        call set_modulus(self, infinity)
    end subroutine new_rigid

    !> Two half-spaces pressed together, exactly: 1/E* = 1/E1* + 1/E2*.
    subroutine new_homogeneous_pair(self, lower, upper, error)
        type(homogeneous_t), intent(out) :: self
        !> not pairs, not both rigid
        type(homogeneous_t), intent(in) :: lower, upper
        type(error_t), allocatable, intent(inout) :: error

        call set_modulus(self, in_series(lower%contact_modulus, upper%contact_modulus))
        self%share_of_upper = self%contact_modulus/upper%contact_modulus
        call set_pair(self, lower, upper, error)
    end subroutine new_homogeneous_pair

    !> E* [modulus]; infinite for a rigid body.
    pure function half_space_modulus(self) result(modulus)
        class(homogeneous_t), intent(in) :: self
        real(wp) :: modulus

        modulus = self%contact_modulus
    end function half_space_modulus

    !> The modulus, and what every half-space is.
    pure subroutine set_modulus(self, modulus)
        type(homogeneous_t), intent(inout) :: self
        real(wp), intent(in) :: modulus

        self%contact_modulus = modulus
        self%is_formula = .true.
        self%has_free_springs = .true.
        self%is_rigid = modulus > huge(1.0_wp)
    end subroutine set_modulus

    !> A half-space of given contact modulus E*.
    subroutine new_homogeneous_from_modulus(self, contact_modulus, error)
        type(homogeneous_t), intent(out) :: self
        !> E* > 0 [modulus]
        real(wp), intent(in) :: contact_modulus
        type(error_t), allocatable, intent(out) :: error

        call check_positive(error, "contact_modulus", contact_modulus)
        if (allocated(error)) return
        call set_modulus(self, contact_modulus)
    end subroutine new_homogeneous_from_modulus

    !> The springs of a half-space are not coupled.
    subroutine springs(self, kernel, modulus, tolerance, error)
        class(homogeneous_t), intent(in) :: self
        type(kernel_t), intent(out) :: kernel
        real(wp), intent(out) :: modulus, tolerance
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => error)
        end associate
        kernel%vanishes = .true.
        modulus = self%contact_modulus
        tolerance = epsilon(1.0_wp)
    end subroutine springs

    elemental function effective_modulus(self, a) result(value)
        class(homogeneous_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value

        associate (unused => a)
        end associate
        value = self%contact_modulus
    end function effective_modulus

    elemental function effective_modulus_slope(self, a) result(value)
        class(homogeneous_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value

        associate (unused => self, also_unused => a)
        end associate
        value = 0.0_wp
    end function effective_modulus_slope

    !> d = g(a), F = 2 E* int_0^a s g'(s) ds, equations (3) and (5).
    subroutine depth_and_force(self, profile, a, depth, force, error)
        class(homogeneous_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        real(wp), intent(out) :: depth, force
        type(error_t), allocatable, intent(out) :: error

        depth = profile%mdr(a)
        force = 2.0_wp*self%contact_modulus*profile%mdr_moment(a)
    end subroutine depth_and_force

    !> q = E* (g(a) + excess - g(x)).
    subroutine line_load_series(self, profile, a, excess, series, error)
        class(homogeneous_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a, excess
        real(wp), allocatable, intent(out) :: series(:)
        type(error_t), allocatable, intent(inout) :: error

        if (.not. is_smooth(profile)) return
        allocate (series(terms))
        call profile_moments(profile, a, series, error)
        series = -self%contact_modulus*series
        series(1) = series(1) + sqrt(2.0_wp)*self%contact_modulus*(profile%mdr(a) + excess)
    end subroutine line_load_series

    !> (16/3) G a^3.
    subroutine torsional_stiffness(self, a, values, error)
        class(homogeneous_t), intent(in) :: self
        real(wp), intent(in) :: a(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: moduli(2)

        call moduli_under_shear(self, moduli, error)
        values = 16.0_wp/3.0_wp*moduli(1)*a**3
    end subroutine torsional_stiffness

    !> The half-space of modulus G*; of two, 1/G* = 1/G1* + 1/G2*.
    subroutine new_tangential(self, tangential, error)
        class(homogeneous_t), intent(in) :: self
        class(solver_t), allocatable, intent(out) :: tangential
        type(error_t), allocatable, intent(out) :: error
        type(homogeneous_t) :: own
        real(wp) :: moduli(2)

        call moduli_under_shear(self, moduli, error)
        if (allocated(error)) return
        call set_modulus(own, moduli(2))
        allocate (tangential, source=own)
    end subroutine new_tangential

    !> int of 4 sqrt(a^2 - x^2) sqrt(b^2 - x^2) dx over the smaller disc, by complete elliptic integrals of modulus b/a.
    subroutine disc_products(self, radius, radii, products, error)
        class(homogeneous_t), intent(in) :: self
        real(wp), intent(in) :: radius
        real(wp), intent(in) :: radii(:)
        real(wp), intent(out) :: products(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: a, b
        integer :: i

        associate (unused => error)
        end associate
        do i = 1, size(radii)
            a = max(radius, radii(i))
            b = min(radius, radii(i))
            products(i) = a**2 + b**2
            if (b < a) products(i) = (a**2 + b**2)*gsl_sf_ellint_ecomp(b/a, 0_c_int) &
                                     - (a**2 - b**2)*gsl_sf_ellint_kcomp(b/a, 0_c_int)
            products(i) = 8.0_wp/3.0_wp*a/self%contact_modulus*products(i)
        end do
    end subroutine disc_products

    !> None: springs are free.
    subroutine interaction(self, a, most, modulus, matrix, error)
        class(homogeneous_t), intent(in) :: self
        real(wp), intent(in) :: a
        integer, intent(in) :: most
        real(wp), intent(out) :: modulus
        real(wp), allocatable, intent(out) :: matrix(:, :)
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => a, also_unused => most, unused_too => error)
        end associate
        modulus = self%contact_modulus
        allocate (matrix(0, 0))
    end subroutine interaction

end module mdrcontact_medium_homogeneous
