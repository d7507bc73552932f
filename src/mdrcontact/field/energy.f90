! SPDX-License-Identifier: GPL-3.0-or-later
!> Elastic energy that each layer of a body stores under a load.
!>
!> Below depth z lies the work of the tractions there, W(z) = -pi int p_hat^2 (y1 y3 + y2 y4)/(2 mu) dk, continuous across
!> interfaces. At the surface the half-space of the first material gives (1/E0*) int_0^a q^2 dx, and the layers below add an
!> integral that converges exponentially.
module mdrcontact_field_energy
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_field_load, only: load_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_field_sweep, only: layer_state, new_sweep, normal_rows, sweep_t
    use mdrcontact_field_waves, only: faded, wave_rule
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: layer_energies

contains

    !> Energy of every layer from the surface down, the half-space last (0 where the base is rigid) [modulus length^3].
    function layer_energies(load, layers, error) result(energies)
        class(load_t), intent(in) :: load
        type(layers_t), intent(in) :: layers
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: energies(size(layers%thickness) + 1)
        real(wp) :: below(size(layers%thickness) + 2)
        integer :: i, n

        n = size(layers%thickness)
        associate (modulus => 2.0_wp*layers%shear(1)/(1.0_wp - layers%poisson(1)))
            below(1) = load%square_integral(error)/modulus
        end associate
        if (n > 0) below(1) = below(1) + energy_below(load, layers, 1, error)
        do i = 2, n + 1
            below(i) = energy_below(load, layers, i, error)
        end do
        below(n + 2) = 0.0_wp
        energies = below(:n + 1) - below(2:)
    end function layer_energies

    !> W at the upper face of a layer; for the first one what the layers below add to a half-space of its material.
    function energy_below(load, layers, layer, error) result(energy)
        class(load_t), intent(in) :: load
        type(layers_t), intent(in) :: layers
        integer, intent(in) :: layer
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: energy
        type(layers_t) :: scaled
        type(sweep_t) :: sweep
        real(wp), allocatable :: k(:), weight(:), transform(:), y(:, :)
        real(wp) :: total, contrast
        integer :: n, stat

        energy = 0.0_wp
        n = size(layers%thickness) + 1
        if (layers%rigid_base) n = n - 1
        if (layer > n) return
        scaled = layers
        scaled%thickness = layers%thickness/load%radius
        total = sum(scaled%thickness)
        contrast = maxval(layers%shear(:n))/minval(layers%shear(:n))
        ! p_hat^2 holds waves up to 2 a, and the states e^(-2 k z)
        call wave_rule(2.0_wp, total*contrast, faded/(2.0_wp*scaled%top(max(layer, 2))), k, weight, error)
        if (allocated(error)) return
        allocate (transform(size(k)), y(size(k), normal_rows), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        call load%transform(k/load%radius, transform, error)
        if (allocated(error)) return
        call new_sweep(sweep, scaled, k, .false., error)
        if (allocated(error)) return
        call layer_state(sweep, scaled, layer, scaled%top(layer), scaled%top(layer), layer == 1, 1, size(k), y)
        if (layer == 1) then
            energy = sum(weight*transform**2*y(:, 2))
        else
            energy = -sum(weight*transform**2*(y(:, 1)*y(:, 3) + y(:, 2)*y(:, 4)))
        end if
        energy = pi*energy/(2.0_wp*layers%shear(layer)*load%radius)
    end function energy_below

end module mdrcontact_field_energy
