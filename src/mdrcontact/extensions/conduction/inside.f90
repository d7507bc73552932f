! SPDX-License-Identifier: GPL-3.0-or-later
!> Potential and flux density in a conductor under a steady flux through a contact area, whose line load is a Legendre series:
!> the closed ones of a half-space of the surface material, and as an integral over wavenumbers what the layers below it add
!> (theory/conduction.md (7.1)-(7.5)).
module mdrcontact_conduction_inside
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_conduction_conductors, only: conductors_t, half_space_base, insulating_base, layer_at, perfect_base
    use mdrcontact_conduction_oblate, only: oblate_sum
    use mdrcontact_error, only: check_memory, check_not_negative, error_domain, error_invalid, error_t, raise, to_text
    use mdrcontact_gsl, only: gsl_sf_bessel_j0, gsl_sf_bessel_j1
    use mdrcontact_inside_lattice, only: distinct
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
    !> Points taken together, numbers in their tables of waves, and the fewest waves that are tabulated together.
    integer, parameter :: most_points = 65536, most_numbers = 1000000, fewest_waves = 16

    !> Where a depth is.
    type :: depth_t
        integer :: layer = 0
        !> scaled, from the top of the layer
        real(wp) :: distance = 0.0_wp
        !> at the perfect conductor below the layers: the bottom of the last layer instead
        logical :: in_base = .false.
    end type depth_t

contains

    !> Potential, j_z and j_r at points; a grid of few distinct r and z costs far less than as many scattered points.
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
        real(wp), allocatable :: k(:), hat(:)
        integer :: first, last

        call check_points(body, r, z, error)
        if (allocated(error)) return
        call find_waves(body, a, q, maxval(r), k, hat, error)
        do first = 1, size(r), most_points
            if (allocated(error)) return
            last = min(first + most_points - 1, size(r))
            call add_block(body, a, q, k, hat, r(first:last), z(first:last), lower, potential(first:last), flux_z(first:last), &
                           flux_r(first:last), error)
        end do
    end subroutine fields_inside

    !> The same for at most `most_points` points.
    subroutine add_block(body, a, q, k, hat, r, z, lower, potential, flux_z, flux_r, error)
        type(conductors_t), intent(in) :: body
        real(wp), intent(in) :: a, q(:), k(:), hat(:), r(:), z(:)
        logical, intent(in) :: lower
        real(wp), intent(out) :: potential(:), flux_z(:), flux_r(:)
        type(error_t), allocatable, intent(inout) :: error
        type(depth_t), allocatable :: depths(:)
        integer, allocatable :: first_r(:), first_z(:)
        integer :: row(size(r)), column(size(r)), i

        potential = 0.0_wp
        flux_z = 0.0_wp
        flux_r = 0.0_wp
        call distinct(r, first_r, row, error)
        call distinct(z, first_z, column, error)
        if (.not. allocated(error)) call find_depths(body, z, first_z, lower, depths, error)
        if (allocated(error)) return
        do i = 1, size(r)
            associate (depth => depths(column(i)))
                if (depth%layer /= 1) cycle
                call add_half_space(body, a, q, r(i), depth%distance, potential(i), flux_z(i), flux_r(i))
            end associate
        end do
        call add_waves(body, k, hat, depths, r, first_r, row, column, potential, flux_z, flux_r, error)
        if (allocated(error)) return
        do i = 1, size(r)
            if (.not. depths(column(i))%in_base) cycle
            ! a perfect conductor has the potential 0, takes the flux across its surface, and gives no information on that along it
            potential(i) = 0.0_wp
            flux_r(i) = 0.0_wp
        end do
    end subroutine add_block

    subroutine find_depths(body, z, first, lower, depths, error)
        type(conductors_t), intent(in) :: body
        real(wp), intent(in) :: z(:)
        integer, intent(in) :: first(:)
        logical, intent(in) :: lower
        type(depth_t), allocatable, intent(out) :: depths(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, stat

        allocate (depths(size(first)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = 1, size(first)
            associate (depth => depths(i), here => z(first(i)))
                call layer_at(body, here, lower .and. here > 0.0_wp, depth%layer, depth%distance)
                depth%in_base = depth%layer > size(body%s)
                if (.not. depth%in_base) cycle
                depth%layer = body%layers
                depth%distance = body%h(depth%layer)
            end associate
        end do
    end subroutine find_depths

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

    !> What the layers add. Waves depend on radius and depth by factors, so that each is computed once for all points that share it.
    subroutine add_waves(body, k, hat, depths, r, first_r, row, column, potential, flux_z, flux_r, error)
        type(conductors_t), intent(in) :: body
        real(wp), intent(in) :: k(:), hat(:)
        type(depth_t), intent(in) :: depths(:)
        real(wp), intent(in) :: r(:)
        !> the distinct radii, and of each point its radius and its depth among the distinct ones
        integer, intent(in) :: first_r(:), row(:), column(:)
        real(wp), intent(inout) :: potential(:), flux_z(:), flux_r(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: j0(:, :), j1(:, :), parts(:, :, :)
        integer :: first, last, waves, i, stat

        if (size(k) == 0) return
        waves = min(size(k), max(fewest_waves, most_numbers/(2*size(first_r) + 3*size(depths))))
        allocate (j0(waves, size(first_r)), j1(waves, size(first_r)), parts(waves, 3, size(depths)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do first = 1, size(k), waves
            call check_cancelled(error)
            if (allocated(error)) return
            last = min(first + waves - 1, size(k))
            do i = 1, size(first_r)
                call fill_bessel(k(first:last), r(first_r(i)), j0(:, i), j1(:, i))
            end do
            call fill_parts(body, depths, k(first:last), hat(first:last), parts)
            do i = 1, size(r)
                call add_products(last - first + 1, parts(:, :, column(i)), j0(:, row(i)), j1(:, row(i)), potential(i), flux_z(i), &
                                  flux_r(i))
            end do
        end do
    end subroutine add_waves

    subroutine fill_bessel(k, r, j0, j1)
        real(wp), intent(in) :: k(:), r
        real(wp), intent(inout) :: j0(:), j1(:)
        integer :: i

        do i = 1, size(k)
            j0(i) = gsl_sf_bessel_j0(k(i)*r)
            j1(i) = gsl_sf_bessel_j1(k(i)*r)
        end do
    end subroutine fill_bessel

    !> Factors of the potential, j_z and j_r at depths in ascending order.
    subroutine fill_parts(body, depths, k, hat, parts)
        type(conductors_t), intent(in) :: body
        type(depth_t), intent(in) :: depths(:)
        real(wp), intent(in) :: k(:), hat(:)
        real(wp), intent(inout) :: parts(:, :, :)
        real(wp) :: amplitude(size(k), 2), down, up, s, height
        integer :: i, j, layer

        layer = 0
        do j = 1, size(depths)
            if (depths(j)%layer /= layer) call find_amplitudes(body, depths(j)%layer, k, hat, amplitude)
            layer = depths(j)%layer
            s = body%s(layer)
            height = 0.0_wp
            if (layer <= body%layers) height = body%h(layer) - depths(j)%distance
            ! exp of four numbers together has other last digits
            !GCC$ novector
            do i = 1, size(k)
                down = amplitude(i, 1)*exp(-k(i)*depths(j)%distance)
                up = amplitude(i, 2)*exp(-k(i)*height)
                parts(i, :, j) = [down + up, s*k(i)*(down - up), s*body%stretch(layer)*k(i)*(down + up)]
            end do
        end do
    end subroutine fill_parts

    pure subroutine add_products(waves, parts, j0, j1, potential, flux_z, flux_r)
        integer, intent(in) :: waves
        real(wp), intent(in), contiguous :: parts(:, :), j0(:), j1(:)
        real(wp), intent(inout) :: potential, flux_z, flux_r
        integer :: i

        do i = 1, waves
            potential = potential + parts(i, 1)*j0(i)
            flux_z = flux_z + parts(i, 2)*j0(i)
            flux_r = flux_r + parts(i, 3)*j1(i)
        end do
    end subroutine add_products

end module mdrcontact_conduction_inside
