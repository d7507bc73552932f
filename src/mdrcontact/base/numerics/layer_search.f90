! SPDX-License-Identifier: GPL-3.0-or-later
!> Which of some layers holds a depth.
module mdrcontact_numerics_layer_search
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: find_layer, rounding

    !> A depth is at the bottom of the n-th layer within n times this part of it: it is a sum of n thicknesses in any
    !> order, each with the rounding of a change of units.
    real(wp), parameter :: rounding = 4.0_wp*epsilon(1.0_wp)

contains

    !> The layer at a depth, and the distance from its top; an interface belongs to the layer below it if `below`.
    pure subroutine find_layer(thickness, z, below, layer, distance)
        !> top to bottom, > 0 [length]
        real(wp), intent(in) :: thickness(:)
        !> >= 0 [length]
        real(wp), intent(in) :: z
        logical, intent(in) :: below
        !> size(thickness) + 1: what lies below all layers
        integer, intent(out) :: layer
        !> 0 and the thickness itself at an interface [length]
        real(wp), intent(out) :: distance
        real(wp) :: bottom

        bottom = 0.0_wp
        distance = z
        do layer = 1, size(thickness)
            bottom = bottom + thickness(layer)
            if (abs(z - bottom) <= rounding*layer*bottom) then
                distance = thickness(layer)
                if (.not. below) return
                distance = 0.0_wp
            else if (z < bottom) then
                return
            else
                distance = distance - thickness(layer)
            end if
        end do
    end subroutine find_layer

end module mdrcontact_numerics_layer_search
