! SPDX-License-Identifier: GPL-3.0-or-later
!> One coating of thickness h on an elastic half-space: what all the effective-modulus models of a coating share (theory/paper.md
!> (3.1)).
module mdrcontact_medium_coated
    use mdrcontact_error, only: check_positive, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_effective, only: effective_medium_t
    implicit none (type, external)
    private
    public :: coated_t

    !> A coated half-space. Each extension is one published model of E_eff(a).
    type, abstract, extends(effective_medium_t) :: coated_t
        !> index 0 and 1 of Popov (2014)
        type(material_t) :: coating, substrate
        !> h > 0 [length]
        real(wp) :: thickness = 0.0_wp
    contains
        procedure, non_overridable :: set_bodies
    end type coated_t

contains

    !> Check and store the data that every model needs; the materials have been checked when they were made.
    pure subroutine set_bodies(self, coating, thickness, substrate, error)
        class(coated_t), intent(inout) :: self
        type(material_t), intent(in) :: coating, substrate
        real(wp), intent(in) :: thickness
        type(error_t), allocatable, intent(inout) :: error

        call check_positive(error, "thickness", thickness)
        self%coating = coating
        self%substrate = substrate
        self%thickness = thickness
    end subroutine set_bodies

end module mdrcontact_medium_coated
