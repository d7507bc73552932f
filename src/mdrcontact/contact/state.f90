! SPDX-License-Identifier: GPL-3.0-or-later
!> One state of a contact: contact radius, depth, force and stiffness.
module mdrcontact_contact_state
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: contact_state_t

    !> A point of F(d): what a contact tells of itself. All zero is first touch.
    type :: contact_state_t
        !> a [length]
        real(wp) :: radius = 0.0_wp
        !> d, positive into the medium [length]
        real(wp) :: depth = 0.0_wp
        !> F, positive in compression [modulus length^2]
        real(wp) :: force = 0.0_wp
        !> k = dF/dd at constant radius = 2 a E_eff(a) [modulus length]
        real(wp) :: stiffness = 0.0_wp
        !> depth beyond that of first touch at this radius [length]: 0 for a non-adhesive contact, -dl(a) at an adhesive edge,
        !> anything above it at a vertical wall of the indenter
        real(wp) :: excess = 0.0_wp
    end type contact_state_t

end module mdrcontact_contact_state
