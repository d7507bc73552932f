! SPDX-License-Identifier: GPL-3.0-or-later
!> A gel under an indenter, and what the pore fluid may do at its surface.
!>
!> Biot's theory with incompressible constituents: the skeleton has a shear modulus G and a drained Poisson's ratio nu, the fluid
!> diffuses with D. A sudden load finds an incompressible body (nu = 1/2), one that has lasted the drained one (nu). Here G = 1,
!> D = 1 and the contact radius is 1: times are tau = D t/a^2.
module mdrcontact_poroelastic_gel
    use mdrcontact_codes, only: drains_by_surface => drainage_surface, sealed => drainage_sealed, &
                                sealed_by_indenter => drainage_indenter
    use mdrcontact_error, only: check_code, check_not_negative, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: gel_t, new_gel, drains_by_surface, sealed, sealed_by_indenter

    !> The stiffness of thinner films is not followed by the polynomials of a contact.
    real(wp), parameter :: largest_ratio = 4.0_wp

    !> A half-space, or a film bonded to a rigid base that lets no fluid through.
    type :: gel_t
        !> drained Poisson's ratio
        real(wp) :: poisson = 0.0_wp
        !> one of the three above
        integer :: drainage = drains_by_surface
        !> a/h, contact radius over thickness; 0: half-space
        real(wp) :: ratio = 0.0_wp
    contains
        procedure :: local
    end type gel_t

contains

    !> Checks what a gel is made of.
    subroutine new_gel(self, poisson, drainage, ratio, error)
        type(gel_t), intent(out) :: self
        !> -1 < nu < 1/2
        real(wp), intent(in) :: poisson
        integer, intent(in) :: drainage
        !> a/h, 0 <= a/h <= 4
        real(wp), intent(in) :: ratio
        type(error_t), allocatable, intent(out) :: error

        if (.not. (poisson > -1.0_wp .and. poisson < 0.5_wp)) then
            call raise(error, error_invalid, " = "//to_text(poisson)//": the drained Poisson's ratio of a gel must lie in "// &
                       "(-1, 0.5)", "nu")
        end if
        call check_code(error, "drainage", drainage, [drains_by_surface, sealed, sealed_by_indenter])
        call check_not_negative(error, "ratio", ratio)
        if (allocated(error)) return
        if (ratio > largest_ratio) then
            call raise(error, error_invalid, " = "//to_text(ratio)//": it must be at most "//to_text(largest_ratio), "ratio")
        else if (ratio > 0.0_wp .and. drainage == sealed_by_indenter) then
            call raise(error, error_invalid, "drainage = indenter: it is available on a half-space only. On a film use "// &
                       "surface and sealed, which bound the result")
        end if
        self = gel_t(poisson, drainage, ratio)
    end subroutine new_gel

    !> Additional compliance of a drained body, relative to an incompressible one: (1 - nu)/(1/2) - 1.
    elemental function local(self) result(part)
        class(gel_t), intent(in) :: self
        real(wp) :: part

        part = 1.0_wp - 2.0_wp*self%poisson
    end function local

end module mdrcontact_poroelastic_gel
