! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface of a body: a tension of its own, and a plate that slides on it (theory_surfaces 5).
module mdrcontact_tension_surface
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_error, only: check_finite, check_not_negative, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: surface_t, check_surface, is_bare

    !> What a surface adds to the compliance C(k) of its body: 1/C + tau k^2 + B k^4 in place of 1/C.
    type, bind(C) :: surface_t
        !> tau, tension > 0 [modulus length]; less than 0 with a plate only
        real(c_double) :: tension = 0.0_wp
        !> B >= 0, bending stiffness of a plate without stiffness in its plane [modulus length^3]
        real(c_double) :: bending = 0.0_wp
    end type surface_t

contains

    !> Whether it adds nothing; not so where a number is none.
    elemental function is_bare(self) result(answer)
        type(surface_t), intent(in) :: self
        logical :: answer

        answer = self%tension == 0.0_wp .and. self%bending == 0.0_wp
    end function is_bare

    !> Raises unless both numbers are finite, B >= 0, and tau >= 0 where there is no plate.
    pure subroutine check_surface(self, error)
        type(surface_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error

        call check_finite(error, "surface tension", self%tension)
        call check_not_negative(error, "surface bending", self%bending)
        if (allocated(error)) return
        if (self%tension < 0.0_wp .and. .not. self%bending > 0.0_wp) then
            call raise(error, error_invalid, "surface tension < 0 is not allowed without a plate (bending > 0): under any "// &
                       "compression the surface wrinkles, tau_c = 0 at k_c = infinity")
        end if
    end subroutine check_surface

end module mdrcontact_tension_surface
