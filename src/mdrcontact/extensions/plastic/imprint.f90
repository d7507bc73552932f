! SPDX-License-Identifier: GPL-3.0-or-later
!> The imprint of a plastic contact (theory/plastic.md (1.2), (2.1)): while nothing yields, unloading and reloading are those of an
!> elastic contact of another profile on the same body.
module mdrcontact_plastic_imprint
    use mdrcontact_error, only: check_finite, check_not_negative, check_positive, error_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_medium, only: check_elastic, medium_t
    use mdrcontact_medium_solver, only: check_springs
    use mdrcontact_plastic_profile, only: imprint_profile_t, new_imprint_profile
    implicit none (type, external)
    private
    public :: imprint_t, new_imprint

    !> A body and what the largest load has left on it. Immutable once created.
    type :: imprint_t
        type(medium_t) :: medium
        !> the effective indenter; its depth counts from the end of contact
        type(imprint_profile_t) :: profile
        !> A [length], F [modulus length^2] and the depth [length] at the largest load
        real(wp) :: radius = 0.0_wp, force = 0.0_wp, depth = 0.0_wp
    end type imprint_t

contains

    !> The imprint of the pressure uniform + hertz sqrt(1 - r^2/A^2) at the largest load.
    subroutine new_imprint(self, medium, radius, uniform, hertz, depth, error)
        type(imprint_t), intent(out) :: self
        !> copied
        type(medium_t), intent(in) :: medium
        !> A > 0 [length]
        real(wp), intent(in) :: radius
        !> [modulus]
        real(wp), intent(in) :: uniform, hertz
        !> at the largest load [length]
        real(wp), intent(in) :: depth
        type(error_t), allocatable, intent(out) :: error

        call check_elastic(medium, error)
        call check_positive(error, "radius", radius)
        call check_not_negative(error, "uniform", uniform)
        call check_finite(error, "hertz", hertz)
        call check_finite(error, "depth", depth)
        if (allocated(error)) return
        call check_springs(medium%solver, "an imprint is", error)
        if (allocated(error)) return
        self%medium = medium
        self%radius = radius
        self%depth = depth
        self%force = pi*radius**2*(uniform + 2.0_wp/3.0_wp*hertz)
        call new_imprint_profile(self%profile, radius, [2.0_wp*uniform, 0.5_wp*pi*hertz]*(radius/medium%solver%springs%modulus), &
                                 error)
    end subroutine new_imprint

end module mdrcontact_plastic_imprint
