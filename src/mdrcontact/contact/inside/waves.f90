! SPDX-License-Identifier: GPL-3.0-or-later
!> Which wavenumbers the Hankel integrals of stresses need.
module mdrcontact_inside_waves
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: faded, first_panel, part_of_waves

    !> exp(-faded) is negligible.
    real(wp), parameter :: faded = 42.0_wp
    !> Nodes times layers that are worked on together, of 50 bytes each, and nodes at least.
    integer, parameter :: most_amplitudes = 2000000, least_part = 256
    !> Where the octaves of wavenumbers begin, relative to the longest length on which the layers' state varies, or a + r.
    real(wp), parameter :: first_panel = 1.0e-3_wp

contains

    !> Number of nodes in a block for a given number of layers: memory for all nodes would grow with both.
    pure function part_of_waves(layers) result(number)
        integer, intent(in) :: layers
        integer :: number

        number = max(least_part, most_amplitudes/layers)
    end function part_of_waves

end module mdrcontact_inside_waves
