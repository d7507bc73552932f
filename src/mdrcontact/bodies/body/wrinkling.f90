! SPDX-License-Identifier: GPL-3.0-or-later
!> The compression of a layer at which the surface of a body wrinkles (theory/surfaces.md (7.1), (7.4)): Chen, Hutchinson,
!> J. Appl. Mech. 71 (2004) 597 in the limit of a thin stiff film, exact for any layers.
module mdrcontact_body_wrinkling
    use mdrcontact_body_elements_interface, only: bond_t
    use mdrcontact_body_stability, only: softest_wave
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_error, only: check_made, count_text, error_memory, error_t, error_unreachable, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_material, only: material_t
    use mdrcontact_material_transverse, only: transverse_t
    implicit none (type, external)
    private
    public :: find_wrinkling

    !> Relative accuracy of the stress.
    real(wp), parameter :: accuracy = 1.0e-12_wp

contains

    !> The stress of one layer, with everything else unchanged, at which a wave has no stiffness. The stress of that layer itself is
    !> not used. Where a constant of the layer or the stiffness of its surface vanishes first there is no such wave: all short ones
    !> lose their stiffness simultaneously.
    subroutine find_wrinkling(layers, thickness, substrate, rigid_base, bonds, which, stress, wavelength, error)
        !> top to bottom, each free of stress or under one that is stable
        type(material_t), intent(in) :: layers(:)
        !> > 0 [length]
        real(wp), intent(in) :: thickness(:)
        !> the half-space below, unless the base is rigid
        type(material_t), intent(in) :: substrate
        !> instead of the half-space
        logical, intent(in) :: rigid_base
        !> below each layer
        type(bond_t), intent(in) :: bonds(:)
        !> number of the layer top to bottom
        integer, intent(in) :: which
        !> < 0: compression [modulus], and the wavelength of the wrinkles [length]
        real(wp), intent(out) :: stress, wavelength
        type(error_t), allocatable, intent(out) :: error
        type(stack_t) :: body
        real(wp) :: low, high, middle, k, stiffness

        stress = 0.0_wp
        wavelength = 0.0_wp
        call check_made(error, "layers", all(layers%young > 0.0_wp))
        call check_made(error, "substrate", rigid_base .or. substrate%young > 0.0_wp)
        if (allocated(error)) return
        if (.not. allocated(error)) call stretched_stack(0.0_wp, error)
        if (allocated(error)) return
        high = 0.0_wp
        low = -1.0e-15_wp*layers(which)%contact()
        do while (is_stable(low, error))
            high = low
            low = 4.0_wp*low
        end do
        do while (high - low > accuracy*abs(low))
            if (allocated(error)) return
            middle = 0.5_wp*(low + high)
            if (is_stable(middle, error)) then
                high = middle
            else
                low = middle
            end if
        end do
        call check_layer(low, error)
        if (.not. allocated(error)) call stretched_stack(high, error)
        if (.not. allocated(error)) call softest_wave(body, k, stiffness, error)
        if (allocated(error)) return
        stress = high
        wavelength = 2.0_wp*pi/k

    contains

        !> Raises if what is unstable is the layer itself.
        subroutine check_layer(trial, error)
            real(wp), intent(in) :: trial
            type(error_t), allocatable, intent(inout) :: error
            type(transverse_t) :: constants, stressed
            type(error_t), allocatable :: refused
            character(len=:), allocatable :: words

            constants = layers(which)%as_transverse()
            call constants%stretched(trial, stressed, refused, "")
            if (allocated(error) .or. .not. allocated(refused)) return
            call stressed%vanishing(words)
            call raise(error, error_unreachable, "layer "//count_text(which)//" has no wrinkling wavelength: at a stress of "// &
                       to_text(trial)//" "//words//" vanishes first, for all short waves together")
        end subroutine check_layer

        !> Raises where that cannot be known.
        function is_stable(trial, error) result(answer)
            real(wp), intent(in) :: trial
            type(error_t), allocatable, intent(inout) :: error
            logical :: answer
            type(error_t), allocatable :: refused

            call stretched_stack(trial, refused)
            answer = .not. allocated(refused)
            if (answer) return
            if (refused%code == error_memory) call move_alloc(refused, error)
        end function is_stable

        !> The body with the layer under a stress; an error if that is unstable.
        subroutine stretched_stack(trial, refused)
            real(wp), intent(in) :: trial
            type(error_t), allocatable, intent(inout) :: refused
            type(material_t) :: materials(size(layers))
            type(transverse_t) :: constants

            materials = layers
            constants = layers(which)%as_transverse()
            materials(which)%is_plain = .false.
            call constants%stretched(trial, materials(which)%constants, refused, "")
            if (.not. allocated(refused)) call new_stack(body, materials, thickness, substrate, refused, rigid_base, bonds)
        end subroutine stretched_stack

    end subroutine find_wrinkling

end module mdrcontact_body_wrinkling
