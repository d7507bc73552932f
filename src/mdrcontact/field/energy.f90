! SPDX-License-Identifier: GPL-3.0-or-later
!> Elastic energy that each layer of a body stores under a load.
!>
!> Below depth z lies the work of the tractions there, W(z) = -pi int p_hat^2 (y1 y3 + y2 y4)/(2 mu) dk, continuous across
!> interfaces. At the surface the half-space of the first material gives (1/E0*) int_0^a q^2 dx, and the layers below add an
!> integral that converges exponentially.
module mdrcontact_field_energy
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_field_sweep, only: layer_state, new_sweep, normal_rows, sweep_t
    use mdrcontact_field_transform, only: hankel_transform
    use mdrcontact_field_waves, only: faded, part_of_waves, wave_rule
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
        type(layers_t) :: scaled
        type(sweep_t) :: sweep
        real(wp), allocatable :: k(:), weight(:), transform(:)
        real(wp) :: below(size(layers%thickness) + 2), contrast
        integer :: i, n, waves, first, last, stat

        energies = 0.0_wp
        below = 0.0_wp
        associate (modulus => 2.0_wp*layers%shear(1)/(1.0_wp - layers%poisson(1)))
            below(1) = load%square_integral(error)/modulus
        end associate
        if (allocated(error)) return
        if (size(layers%thickness) > 0) then
            n = size(layers%thickness) + merge(0, 1, layers%rigid_base)
            call layers%in_units_of(load%radius, scaled, error)
            if (allocated(error)) return
            contrast = maxval(layers%shear(:n))/minval(layers%shear(:n))
            ! p_hat^2 holds waves up to 2 a, and the states e^(-2 k z)
            call wave_rule(2.0_wp, sum(scaled%thickness)*contrast, faded/(2.0_wp*scaled%top(2)), k, weight, error)
            if (allocated(error)) return
            allocate (transform(size(k)), stat=stat)
            call check_memory(error, stat)
            if (stat /= 0) return
            call hankel_transform(load, k/load%radius, transform, error)
            if (allocated(error)) return
            weight(:) = pi/(2.0_wp*load%radius)*weight*transform**2
            waves = part_of_waves(size(scaled%thickness) + 1)
            do first = 1, size(k), waves
                last = min(first + waves - 1, size(k))
                call check_cancelled(error)
                if (.not. allocated(error)) call new_sweep(sweep, scaled, k(first:last), .false., error)
                if (allocated(error)) return
                do i = 1, n
                    below(i) = below(i) + energy_below(sweep, scaled, i, k(first:last), weight(first:last), error)
                    if (allocated(error)) return
                end do
            end do
        end if
        energies = below(:size(energies)) - below(2:)
    end function layer_energies

    !> W at the upper face of a layer; for the first one what the layers below add to a half-space of its material.
    function energy_below(sweep, layers, layer, k, weight, error) result(energy)
        type(sweep_t), intent(in) :: sweep
        !> thicknesses in units of the contact radius
        type(layers_t), intent(in) :: layers
        integer, intent(in) :: layer
        !> waves, and pi p_hat^2 dk/(2 a)
        real(wp), intent(in) :: k(:), weight(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: energy
        real(wp), allocatable :: y(:, :)
        integer :: last, stat

        energy = 0.0_wp
        last = count(k*layers%top(max(layer, 2)) <= 0.5_wp*faded)
        allocate (y(last, normal_rows), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        call layer_state(sweep, layers, layer, layers%top(layer), layers%top(layer), layer == 1, 1, last, y)
        if (layer == 1) then
            energy = sum(weight(:last)*y(:, 2))
        else
            energy = -sum(weight(:last)*(y(:, 1)*y(:, 3) + y(:, 2)*y(:, 4)))
        end if
        energy = energy/layers%shear(layer)
    end function energy_below

end module mdrcontact_field_energy
