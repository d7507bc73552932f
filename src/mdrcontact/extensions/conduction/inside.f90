! SPDX-License-Identifier: GPL-3.0-or-later
!> Potential and flux density in a conductor under a steady flux through a contact area, whose line load is a Legendre series:
!> the closed ones of a half-space of the surface material, and as an integral over wavenumbers what the layers below it add
!> (theory/conduction.md (7.1)-(7.5)).
module mdrcontact_conduction_inside
    use mdrcontact_conduction_conductors, only: conductors_t, half_space_base, insulating_base, layer_at, perfect_base
    use mdrcontact_conduction_oblate, only: oblate_sum
    use mdrcontact_error, only: check_not_negative, error_domain, error_invalid, error_t, raise, raise_at, to_text
    use mdrcontact_gsl, only: gsl_sf_bessel_j0, gsl_sf_bessel_j1
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_even_waves, only: even_waves
    use mdrcontact_numerics_waves, only: wave_rule
    implicit none (type, external)
    private
    public :: fields_inside

    !> exp(-faded) is negligible.
    real(wp), parameter :: faded = 40.0_wp
    !> Octaves of wavenumbers below the scales of the body and of the points.
    integer, parameter :: octaves = 44

contains

    !> Potential, j_z and j_r at points.
    subroutine fields_inside(body, a, q, r, z, lower, potential, flux_z, flux_r, error)
        type(conductors_t), intent(in) :: body
        !> [length]
        real(wp), intent(in) :: a
        !> coefficients of P_2j(x/a) of the line load of the flux into this body [flux/length]
        real(wp), intent(in) :: q(:)
        !> >= 0 [length]
        real(wp), intent(in) :: r(:), z(:)
        !> at an interface: below it
        logical, intent(in) :: lower
        !> same size as r
        real(wp), intent(out) :: potential(:), flux_z(:), flux_r(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: k(:), hat(:), amplitude(:, :)
        real(wp) :: distance
        integer :: i, layer, made
        logical :: in_base

        call check_points(body, r, z, error)
        if (allocated(error)) return
        call find_waves(body, a, q, maxval(r), k, hat, error)
        if (allocated(error)) return
        allocate (amplitude(size(k), 2))
        made = 0
        do i = 1, size(r)
            call layer_at(body, z(i), lower .and. z(i) > 0.0_wp, layer, distance)
            potential(i) = 0.0_wp
            flux_z(i) = 0.0_wp
            flux_r(i) = 0.0_wp
            in_base = layer > size(body%s)
            if (in_base) then
                layer = body%layers
                distance = body%h(layer)
            end if
            if (layer == 1) call add_half_space(body, a, q, r(i), distance, potential(i), flux_z(i), flux_r(i))
            if (size(k) == 0) cycle
            if (layer /= made) then
                call find_amplitudes(body, layer, k, hat, amplitude)
                made = layer
            end if
            call add_waves(body, layer, r(i), distance, k, amplitude, potential(i), flux_z(i), flux_r(i))
            if (.not. in_base) cycle
            ! a perfect conductor has the potential 0, takes the flux across its surface, and gives no information on that along it
            potential(i) = 0.0_wp
            flux_r(i) = 0.0_wp
        end do
    end subroutine fields_inside

    !> Wavenumbers, none where there are no layers, and j_hat times their weights.
    subroutine find_waves(body, a, q, farthest, k, hat, error)
        type(conductors_t), intent(in) :: body
        real(wp), intent(in) :: a, q(:), farthest
        real(wp), allocatable, intent(out) :: k(:), hat(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: weight(:)
        real(wp) :: waves(size(q))
        integer :: i

        if (body%layers == 0) then
            allocate (k(0), hat(0))
            return
        end if
        call wave_rule(scale(1.0_wp, -octaves)/max(body%depth(), a, farthest), faded/body%h(1), a + farthest, k, weight, error)
        if (allocated(error)) return
        allocate (hat(size(k)))
        do i = 1, size(k)
            call even_waves(k(i)*a, waves, error)
            if (allocated(error)) return
            hat(i) = a/pi*sum(q*waves)*weight(i)
        end do
    end subroutine find_waves

    pure subroutine check_points(body, r, z, error)
        type(conductors_t), intent(in) :: body
        real(wp), intent(in) :: r(:), z(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: distance
        integer :: i, layer

        if (allocated(error)) return
        if (body%base == insulating_base) then
            call raise(error, error_invalid, "field: it is not available in layers on an insulating base, whose potential is "// &
                       "relative to the sink")
            return
        end if
        do i = 1, size(r)
            call check_not_negative(error, "r", r(i), i)
            call check_not_negative(error, "z", z(i), i)
            if (allocated(error)) return
            call layer_at(body, z(i), .false., layer, distance)
            if (layer <= size(body%s)) cycle
            call raise(error, error_domain, " = "//to_text(z(i))//": the layers end at "//to_text(sum(body%h/body%stretch)), "z", i)
            return
        end do
    end subroutine check_points

    !> The closed part in the surface material.
    pure subroutine add_half_space(body, a, q, r, z, potential, flux_z, flux_r)
        type(conductors_t), intent(in) :: body
        real(wp), intent(in) :: a, q(:), r, z
        real(wp), intent(inout) :: potential, flux_z, flux_r
        real(wp) :: value, slope_r, slope_z

        call oblate_sum(q, r/a, z/a, value, slope_r, slope_z)
        potential = potential + value/(pi*body%s(1))
        flux_z = flux_z - slope_z/(pi*a)
        flux_r = flux_r - slope_r/(pi*a)*body%stretch(1)
    end subroutine add_half_space

    !> Parts of the potential that fall downward from the top of a layer and upward from its bottom, less in the surface layer
    !> those of a half-space, times j_hat, k and the rule's weights: what a flux through the contact area makes of each wave.
    pure subroutine find_amplitudes(body, layer, k, hat, amplitude)
        type(conductors_t), intent(in) :: body
        integer, intent(in) :: layer
        real(wp), intent(in) :: k(:), hat(:)
        real(wp), intent(out) :: amplitude(:, :)
        complex(wp), parameter :: steady = (0.0_wp, 0.0_wp)
        real(wp) :: flux, y, rho, fall, part
        integer :: i, l

        do i = 1, size(k)
            flux = 1.0_wp
            do l = 1, layer
                y = body%s(l)*k(i)
                if (l > body%layers) then
                    amplitude(i, :) = [flux/y, 0.0_wp]
                    exit
                end if
                rho = y*real(body%below(l, cmplx(k(i), 0.0_wp, wp), steady), wp)
                rho = (rho - 1.0_wp)/(rho + 1.0_wp)
                fall = exp(-k(i)*body%h(l))
                part = flux/(y*(1.0_wp - rho*fall**2))
                if (l == layer) then
                    amplitude(i, :) = [part, part*rho*fall]
                    if (layer == 1) amplitude(i, 1) = part*rho*fall**2
                end if
                flux = part*y*fall*(1.0_wp - rho)
            end do
            amplitude(i, :) = amplitude(i, :)*hat(i)*k(i)
        end do
    end subroutine find_amplitudes

    subroutine add_waves(body, layer, r, z, k, amplitude, potential, flux_z, flux_r)
        type(conductors_t), intent(in) :: body
        integer, intent(in) :: layer
        real(wp), intent(in) :: r, z, k(:), amplitude(:, :)
        real(wp), intent(inout) :: potential, flux_z, flux_r
        real(wp) :: down, up, j0, s, height
        integer :: i

        s = body%s(layer)
        height = 0.0_wp
        if (layer <= body%layers) height = body%h(layer) - z
        do i = 1, size(k)
            down = amplitude(i, 1)*exp(-k(i)*z)
            up = amplitude(i, 2)*exp(-k(i)*height)
            j0 = gsl_sf_bessel_j0(k(i)*r)
            potential = potential + (down + up)*j0
            flux_z = flux_z + s*k(i)*(down - up)*j0
            flux_r = flux_r + s*body%stretch(layer)*k(i)*(down + up)*gsl_sf_bessel_j1(k(i)*r)
        end do
    end subroutine add_waves

end module mdrcontact_conduction_inside
