! SPDX-License-Identifier: GPL-3.0-or-later
!> One state of a contact: depth, contact radius, force, stiffness, punch_depth, zone.
module mdrcontact_contact_state
    use, intrinsic :: iso_c_binding, only: c_double
    implicit none (type, external)
    private
    public :: contact_state_t

    !> A point of F(d), C's struct mdr_state: a datum that fields read and histories start from. All zero is initial contact.
    type, bind(C) :: contact_state_t
        !> d, positive into the medium [length]
        real(c_double) :: depth = 0.0_c_double
        !> a [length]
        real(c_double) :: radius = 0.0_c_double
        !> F, positive in compression [modulus length^2]
        real(c_double) :: force = 0.0_c_double
        !> k = dF/dd at constant radius = 2 a E_eff(a) [modulus length]
        real(c_double) :: stiffness = 0.0_c_double
        !> depth beyond that of the non-adhesive state at this radius [length]: 0 without adhesion, -dl(a) with it, the whole depth
        !> under a flat punch, anything above 0 at another vertical wall of the indenter
        real(c_double) :: punch_depth = 0.0_c_double
        !> c, outer radius of the cohesive zone [length]: the bodies attract each other where a < r < c; 0 without a cohesive stress
        real(c_double) :: zone_radius = 0.0_c_double
    end type contact_state_t

end module mdrcontact_contact_state
