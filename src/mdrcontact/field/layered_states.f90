! SPDX-License-Identifier: GPL-3.0-or-later
!> The states of homogeneous layers, by the sweep through them.
module mdrcontact_field_layered_states
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_field_isotropic, only: isotropic_half_space_t, new_isotropic_half_space
    use mdrcontact_field_states, only: depth_t, states_t
    use mdrcontact_field_sweep, only: layer_state, new_sweep, sweep_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: layered_states_t, new_layered_states

    !> States of a body of homogeneous layers.
    type, extends(states_t) :: layered_states_t
        private
        !> lengths in units of a
        type(layers_t) :: layers
        real(wp), allocatable :: tops(:)
        type(sweep_t) :: sweep
    contains
        procedure :: prepare
        procedure :: state
    end type layered_states_t

contains

    !> Of layers with lengths in units of a.
    subroutine new_layered_states(self, layers, error)
        type(layered_states_t), intent(out) :: self
        type(layers_t), intent(in) :: layers
        type(error_t), allocatable, intent(inout) :: error
        type(isotropic_half_space_t), allocatable :: surface
        integer :: i, n, stat

        n = size(layers%thickness)
        allocate (surface, stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        call new_isotropic_half_space(surface, layers%poisson(1))
        call move_alloc(surface, self%half_space)
        self%layers = layers
        self%tops = [(layers%top(i), i=1, n + 1)]
        self%steps = n + 1
        if (n > 0) self%structure = sum(layers%thickness)*layers%contrast()
    end subroutine new_layered_states

    subroutine prepare(self, k, error)
        class(layered_states_t), intent(inout) :: self
        real(wp), intent(in) :: k(:)
        type(error_t), allocatable, intent(inout) :: error

        call new_sweep(self%sweep, self%layers, k, self%along_surface, error)
    end subroutine prepare

    pure subroutine state(self, depth, first, last, y)
        class(layered_states_t), intent(in) :: self
        type(depth_t), intent(in) :: depth
        integer, intent(in) :: first, last
        real(wp), intent(out) :: y(first:, :)

        call layer_state(self%sweep, self%layers, depth%layer, self%tops(depth%layer), depth%z, depth%less, first, last, y)
    end subroutine state

end module mdrcontact_field_layered_states
