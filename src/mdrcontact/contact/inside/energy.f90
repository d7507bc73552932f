! SPDX-License-Identifier: GPL-3.0-or-later
!> Elastic energy that each layer of a body stores under a load.
!>
!> Below depth z lies the work of the tractions there, W_e(z) = -pi int p_hat^2 (y1 y3 + y2 y4)/(2 G) dk (theory/stress.md (5.3)),
!> continuous across bonded interfaces. At the surface the half-space of the first material gives (1/E0*) int_0^a q^2 dx, and the
!> layers below add an integral that converges exponentially. What an interface stores that gives belongs to the layer above it.
module mdrcontact_inside_energy
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_error, only: error_t
    use mdrcontact_inside_layer_states, only: layer_states_t, new_layer_states
    use mdrcontact_inside_states, only: depth_t, normal_rows
    use mdrcontact_inside_transform, only: hankel_transform
    use mdrcontact_inside_waves, only: faded, first_panel, part_of_waves
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_waves, only: wave_rule
    implicit none (type, external)
    private
    public :: layer_energies

contains

    !> Energy of every layer top to bottom, the half-space last (0 where the base is rigid) [modulus length^3].
    function layer_energies(load, layers, error) result(energies)
        class(load_t), intent(in) :: load
        type(layers_t), intent(in) :: layers
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: energies(size(layers%thickness) + 1)
        type(layer_states_t) :: states
        real(wp), allocatable :: k(:), weight(:), transform(:)
        real(wp) :: below(size(layers%thickness) + 2)
        integer :: i, waves, first, last

        energies = 0.0_wp
        below = 0.0_wp
        below(1) = load%square_integral(error)/layers%contact_modulus()
        if (allocated(error)) return
        if (size(layers%thickness) > 0) then
            call new_layer_states(states, layers, load%radius, error)
            if (allocated(error)) return
            ! p_hat^2 holds waves up to 2 a, and the states e^(-2 k z)
            call wave_rule(first_panel/max(2.0_wp, states%structure), &
                           0.5_wp*faded*load%radius/layers%decays_to(layers%top(2), .false.), 2.0_wp, k, weight, error)
            if (allocated(error)) return
            allocate (transform(size(k)))
            call hankel_transform(load, k/load%radius, transform, error)
            if (allocated(error)) return
            weight(:) = pi/(2.0_wp*load%radius)*weight*transform**2
            waves = part_of_waves(size(layers%thickness) + 1)
            do first = 1, size(k), waves
                last = min(first + waves - 1, size(k))
                call check_cancelled(error)
                if (.not. allocated(error)) call states%prepare(k(first:last), error)
                if (allocated(error)) return
                do i = 1, size(layers%thickness) + merge(0, 1, layers%rigid_base)
                    below(i) = below(i) + energy_below(states, layers, load%radius, i, k(first:last), weight(first:last))
                end do
            end do
        end if
        energies = below(:size(energies)) - below(2:)
    end function layer_energies

    !> W at the upper face of a layer; for the first one what the layers below add to a half-space of its material.
    pure function energy_below(states, layers, radius, layer, k, weight) result(energy)
        type(layer_states_t), intent(in) :: states
        type(layers_t), intent(in) :: layers
        !> a [length]
        real(wp), intent(in) :: radius
        integer, intent(in) :: layer
        !> waves, and pi p_hat^2 dk/(2 a)
        real(wp), intent(in) :: k(:), weight(:)
        real(wp) :: energy
        type(depth_t) :: depth
        real(wp), allocatable :: y(:, :)
        integer :: last

        last = count(k*layers%decays_to(layers%top(max(layer, 2)), .false.) <= 0.5_wp*faded*radius)
        allocate (y(last, normal_rows))
        depth%layer = layer
        depth%z = layers%top(layer)/radius
        depth%less = layer == 1
        call states%state(depth, 1, last, y)
        if (layer == 1) then
            energy = sum(weight(:last)*y(:, 2))
        else
            energy = -sum(weight(:last)*(y(:, 1)*y(:, 3) + y(:, 2)*y(:, 4)))
        end if
        energy = energy/layers%shear(1)
    end function energy_below

end module mdrcontact_inside_energy
