! SPDX-License-Identifier: GPL-3.0-or-later
!> The states of layers under a contact: of plain ones, and of those with an axis or with interfaces that give.
module mdrcontact_field_states_of_layers
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_field_layered_states, only: layered_states_t, new_layered_states
    use mdrcontact_field_states, only: states_t
    use mdrcontact_field_transverse_states, only: new_transverse_states, transverse_states_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: new_states, displacement_unit

contains

    !> Of layers under a contact of radius a.
    subroutine new_states(states, layers, radius, error)
        class(states_t), allocatable, intent(out) :: states
        type(layers_t), intent(in) :: layers
        !> [length]
        real(wp), intent(in) :: radius
        type(error_t), allocatable, intent(inout) :: error
        type(layered_states_t), allocatable :: plain
        type(transverse_states_t), allocatable :: transverse
        type(layers_t) :: scaled
        integer :: stat

        allocate (plain, transverse, stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        if (layers%is_plain()) then
            call layers%in_units_of(radius, scaled, error)
            if (.not. allocated(error)) call new_layered_states(plain, scaled, error)
            call move_alloc(plain, states)
        else
            call new_transverse_states(transverse, layers, radius, error)
            call move_alloc(transverse, states)
        end if
    end subroutine new_states

    !> G of which 1/(2 G) is the unit of a layer's states' displacements [modulus]
    pure function displacement_unit(layers, layer) result(shear)
        type(layers_t), intent(in) :: layers
        integer, intent(in) :: layer
        real(wp) :: shear

        shear = layers%shear(merge(layer, 1, layers%is_plain()))
    end function displacement_unit

end module mdrcontact_field_states_of_layers
