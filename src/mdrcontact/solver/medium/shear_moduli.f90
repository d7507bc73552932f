! SPDX-License-Identifier: GPL-3.0-or-later
!> Effective moduli of homogeneous half-spaces in contact for a twist and for a shift.
module mdrcontact_medium_shear_moduli
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: in_series, material_t
    use mdrcontact_medium_solver, only: solver_t
    implicit none (type, external)
    private
    public :: moduli_under_shear

contains

    !> G and G*; of two bodies in series, 1/G = 1/G1 + 1/G2.
    pure subroutine moduli_under_shear(medium, moduli, error)
        !> of homogeneous bodies
        class(solver_t), intent(in) :: medium
        !> G and G* [modulus]
        real(wp), intent(out) :: moduli(2)
        type(error_t), allocatable, intent(out) :: error

        moduli = infinity
        if (allocated(medium%pressed)) moduli = of(medium%pressed%surface_material)
        if (allocated(medium%counterbody)) moduli = in_series(moduli, of(medium%counterbody%surface_material))
        if ((.not. allocated(medium%pressed) .and. medium%share_of_upper < 1.0_wp) .or. &
            (.not. allocated(medium%counterbody) .and. medium%share_of_upper > 0.0_wp)) then
            call raise(error, error_invalid, "medium: the tangential stiffness needs E and nu")
        end if

    contains

        pure function of(material) result(moduli)
            type(material_t), intent(in) :: material
            real(wp) :: moduli(2)

            moduli = [material%shear(), material%tangential()]
        end function of

    end subroutine moduli_under_shear

end module mdrcontact_medium_shear_moduli
