! SPDX-License-Identifier: GPL-3.0-or-later
!> The homogeneous half-space (theory/paper.md (2.1)): the same modulus at every contact radius, and closed forms for every
!> indenter.
module mdrcontact_medium_homogeneous
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_body_compliance, only: twist_load
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_error, only: check_made, check_positive, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_moments, only: is_smooth, profile_moments
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
        procedure :: half_space_modulus
        procedure :: find_series
        procedure :: for_load
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
        self%is_made = material%young > 0.0_wp
    end subroutine new_homogeneous

    !> A rigid half-space: one body of a pair, not a medium alone.
    subroutine new_rigid(self)
        type(homogeneous_t), intent(out) :: self

        call set_modulus(self, infinity)
        self%is_made = .true.
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
        self%is_made = .not. allocated(error)
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
        allocate (self%springs)
        self%springs%modulus = modulus
        self%springs%tolerance = epsilon(modulus)
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
        self%is_made = .not. allocated(error)
    end subroutine new_homogeneous_from_modulus

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

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        depth = profile%mdr(a)
        force = 2.0_wp*self%contact_modulus*profile%mdr_moment(a)
    end subroutine depth_and_force

    !> q = E* (g(a) + punch_depth - g(x)) under smooth profiles.
    subroutine find_series(self, profile, a, series, error)
        class(homogeneous_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        real(wp), allocatable, intent(out) :: series(:, :)
        type(error_t), allocatable, intent(inout) :: error

        if (allocated(error) .or. .not. is_smooth(profile)) return
        allocate (series(terms, 2), source=0.0_wp)
        call profile_moments(profile, a, series(:, 2), error)
        series(:, 2) = -self%contact_modulus*series(:, 2)
        series(1, 1) = sqrt(2.0_wp)*self%contact_modulus
        series(1, 2) = series(1, 2) + series(1, 1)*profile%mdr(a)
    end subroutine find_series

    !> The half-space of modulus G*, or 4 G under a twist; of two, 1/G* = 1/G1* + 1/G2*.
    subroutine for_load(self, load, other, error)
        class(homogeneous_t), intent(in) :: self
        integer, intent(in) :: load
        class(solver_t), allocatable, intent(out) :: other
        type(error_t), allocatable, intent(out) :: error
        type(homogeneous_t) :: own
        real(wp) :: moduli(2)

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        call moduli_under_shear(self, moduli, error)
        if (allocated(error)) return
        call set_modulus(own, merge(4.0_wp*moduli(1), moduli(2), load == twist_load))
        own%is_made = .true.
        allocate (other, source=own)
    end subroutine for_load

end module mdrcontact_medium_homogeneous
