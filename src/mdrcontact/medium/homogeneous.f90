! SPDX-License-Identifier: GPL-3.0-or-later
!> The homogeneous half-space (theory 2): the same modulus at every contact radius, and closed forms for every indenter.
module mdrcontact_medium_homogeneous
    use mdrcontact_error, only: check_positive, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_effective, only: effective_medium_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: homogeneous_t, new_homogeneous, new_homogeneous_from_modulus

    !> A half-space of one material, or of the contact modulus of two bodies.
    type, extends(effective_medium_t) :: homogeneous_t
        private
        !> E* [modulus]
        real(wp) :: contact_modulus = 0.0_wp
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
        procedure :: depth_and_force
        procedure :: is_cheap
    end type homogeneous_t

contains

    !> A half-space of one material, pressed by a rigid indenter.
    pure subroutine new_homogeneous(self, material)
        type(homogeneous_t), intent(out) :: self
        type(material_t), intent(in) :: material

        self%contact_modulus = material%contact()
    end subroutine new_homogeneous

    !> A half-space of given contact modulus E*, for instance 1/E* = 1/E*_1 + 1/E*_2 for two elastic bodies.
    pure subroutine new_homogeneous_from_modulus(self, contact_modulus, error)
        type(homogeneous_t), intent(out) :: self
        !> E* > 0 [modulus]
        real(wp), intent(in) :: contact_modulus
        type(error_t), allocatable, intent(out) :: error

        call check_positive(error, "contact_modulus", contact_modulus)
        if (allocated(error)) return
        self%contact_modulus = contact_modulus
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

        depth = profile%mdr(a)
        force = 2.0_wp*self%contact_modulus*profile%mdr_moment(a)
    end subroutine depth_and_force

    pure function is_cheap(self) result(answer)
        class(homogeneous_t), intent(in) :: self
        logical :: answer

        associate (unused => self)
        end associate
        answer = .true.
    end function is_cheap

end module mdrcontact_medium_homogeneous
