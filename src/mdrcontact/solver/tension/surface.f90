! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface of a body: a tension of its own, and a sheet on it that bends, or that is stiff in its plane
!> (theory/surfaces.md (5.1), (5.2)).
module mdrcontact_tension_surface
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_error, only: check_finite, check_not_negative, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: surface_t, check_surface, has_springs, is_bare

    !> Effect of a surface on the compliance C(k) of its body: 1/C + tau k^2 + B k^4 instead of 1/C, of a body whose surface moves
    !> sideways against K_m k^2.
    type, bind(C) :: surface_t
        !> tau, tension > 0 [modulus length]; less than 0 with a plate only
        real(c_double) :: tension = 0.0_wp
        !> B >= 0, bending stiffness of a plate without stiffness in its plane [modulus length^3]
        real(c_double) :: bending = 0.0_wp
        !> K_m >= 0, stiffness in its plane of a sheet that is bonded to the body, E h/(1 - nu^2) [modulus length]
        real(c_double) :: stretching = 0.0_wp
    end type surface_t

contains

    !> Whether it adds nothing; false if a number is NaN.
    elemental function is_bare(self) result(answer)
        type(surface_t), intent(in) :: self
        logical :: answer

        answer = has_springs(self) .and. self%stretching == 0.0_wp
    end function is_bare

    !> Whether short waves meet springs: it has neither tension nor a plate; false if a number is NaN.
    elemental function has_springs(self) result(answer)
        type(surface_t), intent(in) :: self
        logical :: answer

        answer = self%tension == 0.0_wp .and. self%bending == 0.0_wp
    end function has_springs

    !> Raises unless all numbers are finite, B and K_m >= 0, and tau >= 0 where there is no plate.
    pure subroutine check_surface(self, error)
        type(surface_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error

        call check_finite(error, "surface tension", self%tension)
        call check_not_negative(error, "surface bending", self%bending)
        call check_not_negative(error, "surface stretching", self%stretching)
        if (allocated(error)) return
        if (self%tension < 0.0_wp .and. .not. self%bending > 0.0_wp) then
            call raise(error, error_invalid, "surface tension: it must not be negative without a plate (bending > 0), because "// &
                       "the surface wrinkles under any compression")
        end if
    end subroutine check_surface

end module mdrcontact_tension_surface
