! SPDX-License-Identifier: GPL-3.0-or-later
!> The states of a body in Hankel space under a traction on its surface, as the integrals of stresses need them: see
!> mdrcontact_inside_layer_states for what a state is, and theory/stress.md (1.2)-(1.5).
module mdrcontact_inside_states
    use mdrcontact_error, only: error_t
    use mdrcontact_inside_half_space, only: half_space_rule_t, half_space_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material_transverse, only: transverse_t
    use mdrcontact_medium_load, only: load_t
    implicit none (type, external)
    private
    public :: states_t, depth_t, normal_rows, shear_rows

    !> Numbers of a state under a normal load, y1 to y4, and of one under a shear load, y1 to y5 and N.
    integer, parameter :: normal_rows = 4, shear_rows = 6

    !> Rule of integration for the state at a depth.
    type :: depth_t
        !> [a]
        real(wp) :: z = 0.0_wp
        !> which layer, or which of the depths that the states were made for
        integer :: layer = 1
        !> without the homogeneous half-space of the surface material, and without its images
        logical :: less = .false.
        !> largest wavenumber needed [1/a]
        real(wp) :: last = 0.0_wp
        !> G to which the state's displacements are referred [modulus]
        real(wp) :: shear = 1.0_wp
        !> the constants at the depth, in units of 2 G
        type(transverse_t) :: constants
    end type depth_t

    !> A body with its lengths in units of a.
    type, abstract :: states_t
        !> of the material at the surface
        class(half_space_t), allocatable :: half_space
        !> the longest length on which the states vary [a]; 0 for a homogeneous body, whose field is closed
        real(wp) :: structure = 0.0_wp
        !> steps from the surface to the base
        integer :: steps = 1
        !> whether the load shears the surface instead of pressing it
        logical :: along_surface = .false.
    contains
        !> to the load in one direction, before anything else
        procedure :: turn
        !> what has a closed form in addition to the half-space
        procedure :: add_images
        !> the states at wavenumbers k > 0, ascending [1/a]
        procedure(prepare_at), deferred :: prepare
        !> those of the wavenumbers first to last at a depth: (wavenumber, row)
        procedure(state_at), deferred :: state
    end type states_t

    abstract interface
        subroutine prepare_at(self, k, error)
            import :: error_t, states_t, wp
            class(states_t), intent(inout) :: self
            real(wp), intent(in) :: k(:)
            type(error_t), allocatable, intent(inout) :: error
        end subroutine prepare_at

        pure subroutine state_at(self, depth, first, last, y)
            import :: depth_t, states_t, wp
            class(states_t), intent(in) :: self
            type(depth_t), intent(in) :: depth
            integer, intent(in) :: first, last
            real(wp), intent(out) :: y(first:, :)
        end subroutine state_at
    end interface

contains

    !> Extensions that have them add the images of the half-space to the sums of a point.
    pure subroutine add_images(self, rule, load, depth, r, sums)
        class(states_t), intent(in) :: self
        type(half_space_rule_t), intent(in) :: rule
        class(load_t), intent(in) :: load
        type(depth_t), intent(in) :: depth
        !> distance from the axis [length]
        real(wp), intent(in) :: r
        real(wp), intent(inout) :: sums(:)

        associate (unused => self, also_unused => rule, unused_too => load, not_used => depth, nor_used => r, and_not => sums)
        end associate
    end subroutine add_images

    !> Extensions that take images find them here, and say at which depths.
    subroutine turn(self, along_surface, depths, error)
        class(states_t), intent(inout) :: self
        logical, intent(in) :: along_surface
        type(depth_t), intent(inout) :: depths(:)
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => depths, also_unused => error)
        end associate
        self%along_surface = along_surface
    end subroutine turn

end module mdrcontact_inside_states
