! SPDX-License-Identifier: GPL-3.0-or-later
!> What stands behind the handle of a body.
module mdrcontact_api_any_body
    use mdrcontact_body, only: body_t
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    use mdrcontact_tension_surface, only: surface_t
    implicit none (type, external)
    private
    public :: any_body_t

    !> One of three; the other two are not allocated.
    type :: any_body_t
        !> an elastic body, whose constants are known at every depth
        class(body_t), allocatable :: elastic
        !> and its surface
        type(surface_t) :: surface
        !> one that relaxes, under no model yet
        type(viscoelastic_t), allocatable :: relaxing
        !> one that has one solution only: of a power of the depth, or rigid
        class(solver_t), allocatable :: solved
    end type any_body_t

end module mdrcontact_api_any_body
