! SPDX-License-Identifier: GPL-3.0-or-later
!> A body with many numbers of all kinds.
module example_stack
    use mdrcontact_body_elements_interface, only: bond_t
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t, new_material, new_transverse
    use mdrcontact_material_transverse, only: by_engineering, by_stiffness
    use mdrcontact_nonfinite, only: infinity
    implicit none (type, external)
    private
    public :: base, film, make_stack

    !> of the layer and of what lies below all
    real(wp), parameter :: film(5) = [390.0_wp, 145.0_wp, 106.0_wp, 398.0_wp, 105.0_wp], &
                           base(5) = [10.0_wp, 25.0_wp, 0.2_wp, 0.15_wp, 3.0_wp]

contains

    !> A crystalline film under tension on springs, glass that slides, and fibres.
    subroutine make_stack(stack)
        type(stack_t), intent(out) :: stack
        type(material_t) :: layers(2), substrate
        type(error_t), allocatable :: error

        call new_transverse(layers(1), by_stiffness, film, error, "film")
        call layers(1)%stretch(0.5_wp, error, "film")
        call new_material(layers(2), 72.0_wp, 0.17_wp, error)
        call new_transverse(substrate, by_engineering, base, error, "base")
        call new_stack(stack, layers, [0.3_wp, 1.1_wp], substrate, error, &
                       bonds=[bond_t(0.02_wp, 0.05_wp), bond_t(0.0_wp, infinity)])
        if (allocated(error)) error stop "the example stack could not be made"
    end subroutine make_stack

end module example_stack
