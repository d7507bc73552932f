! SPDX-License-Identifier: GPL-3.0-or-later
!> Temperatures under the heat of friction: w = (1 + K_1) q_1/(2 S_1) on the line, whatever heat q_1 enters the lower body.
!>
!> Of two bodies on both of which the source rests (small amplitudes or speeds), each takes what makes the temperatures equal all
!> over the contact: (C_1 + C_2) q_1 = C_2 q. One body takes it all.
module mdrcontact_conduction_heat
    use mdrcontact_conduction_bodies, only: conduction_t, tolerance
    use mdrcontact_conduction_conductors, only: conductors_t
    use mdrcontact_conduction_inside, only: fields_inside
    use mdrcontact_conduction_source, only: new_source, source_t, spinning
    use mdrcontact_conduction_waves, only: wave_rule
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_choice, check_memory, check_positive, error_invalid, error_no_convergence, error_t, raise
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_layered_kernel, only: kernel_t
    use mdrcontact_layered_legendre, only: moments_t, new_interaction, normalisation
    use mdrcontact_layered_moments, only: is_smooth
    use mdrcontact_layered_series, only: add_projections, even_sum
    use mdrcontact_layered_solve, only: factorize, first_unknowns, solve_lower, solve_upper
    use mdrcontact_numerics_even_waves, only: even_waves
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: heat_t, friction_heat, heat_field, moving_heat

    !> Nodes of a panel of directions, and the angle below which nothing is left.
    integer, parameter :: direction_nodes = 10
    real(wp), parameter :: shortest_panel = 1.0e-9_wp
    !> Terms of a series for temperatures inside under an indenter that is not smooth.
    integer, parameter :: terms_of_kinked = 200

    !> Per the strength of the source.
    type :: heat_t
        !> Q, and the part of it that the lower body takes
        real(wp) :: total = 0.0_wp, share = 1.0_wp
        !> temperature rise in the centre, its mean over the flux, and over the area of the contact
        real(wp) :: centre = 0.0_wp, flux_mean = 0.0_wp, area_mean = 0.0_wp
    end type heat_t

contains

    !> Share and temperatures of a state, and on request the line loads of both bodies.
    subroutine friction_heat(conduction, contact, state, motion, strength, heat, error, loads)
        type(conduction_t), intent(in) :: conduction
        type(contact_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        !> sliding or spinning
        integer, intent(in) :: motion
        !> mu v or mu omega, >= 0
        real(wp), intent(in) :: strength
        type(heat_t), intent(out) :: heat
        type(error_t), allocatable, intent(inout) :: error
        !> coefficients of P_2j(x/a) (term, body)
        real(wp), allocatable, intent(out), optional :: loads(:, :)
        type(source_t) :: source
        real(wp), allocatable :: t(:), given(:), taken(:)
        integer :: n, m

        call conduction%check_steady(error)
        call conduction%check_radius(state%radius, error)
        if (conduction%film > 0.0_wp .and. size(conduction%bodies) > 1 .and. .not. allocated(error)) then
            call raise(error, error_invalid, "friction heat that two bodies share through a film in the spot is not offered: "// &
                       "leave the film out")
        end if
        if (allocated(error)) return
        n = unknowns_for(conduction, state%radius)
        ! the load of a spinning contact has a kink on the axis
        if (motion == spinning) n = 3*n
        m = n
        if (present(loads) .and. .not. is_smooth(contact%equilibrium%profile)) m = max(n, terms_of_kinked)
        call new_source(source, contact, state, motion, strength, max(64, m + 8), error)
        if (allocated(error)) return
        allocate (t(m), taken(n), given(n))
        t = 0.0_wp
        call add_projections(size(source%u), source%u, 2.0_wp*source%dx*source%q/source%radius, t)
        t = t*normalisation(m)
        call share_out(conduction, source, t(:n), taken, given, error)
        if (.not. allocated(error)) call take_means(conduction, source, taken, given, heat)
        if (allocated(error) .or. .not. present(loads)) return
        allocate (loads(m, size(conduction%bodies)))
        loads(:, 1) = t
        if (size(conduction%bodies) > 1) then
            loads(:, 1) = conduction%share(2)*t
            loads(:n, 1) = loads(:n, 1) + taken
            loads(:, 2) = t - loads(:, 1)
        end if
        do n = 1, size(loads, 2)
            loads(:, n) = loads(:, n)*normalisation(m)
        end do
    end subroutine friction_heat

    !> Terms that the kernels take.
    pure function unknowns_for(conduction, a) result(n)
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a
        integer :: n
        integer :: i

        n = 16
        do i = 1, size(conduction%bodies)
            associate (kernel => conduction%kernels(i))
                n = max(n, 8 + ceiling(1.5_wp*first_unknowns(kernel, tolerance, a/kernel%unit, .false., .true.)))
            end associate
        end do
    end function unknowns_for

    !> What the lower body takes beside its part S_0/S_2 of the source, (1 + H) c' = (S_0/S_2) (H_2 - H) t, and what the layers of
    !> the lower body add to the line's temperature, c' + H_1 c.
    subroutine share_out(conduction, source, t, taken, given, error)
        type(conduction_t), intent(in) :: conduction
        type(source_t), intent(in) :: source
        real(wp), intent(in) :: t(:)
        real(wp), intent(out) :: taken(:)
        real(wp), intent(out) :: given(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: lower(:, :), upper(:, :), both(:, :), c(:, :)
        integer :: i, n, stat
        logical :: done

        n = size(t)
        taken = 0.0_wp
        given = 0.0_wp
        call new_interactions(conduction%kernels(1), source%radius, n, lower, error)
        if (allocated(error)) return
        if (size(conduction%bodies) == 1) then
            given = matmul(lower, t)
            return
        end if
        call new_interactions(conduction%kernels(2), source%radius, n, upper, error)
        if (allocated(error)) return
        allocate (both(n, n), c(n, 1), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        both = conduction%share(1)*lower + conduction%share(2)*upper
        c(:, 1) = conduction%share(2)*(matmul(upper, t) - matmul(both, t))
        do i = 1, n
            both(i, i) = both(i, i) + 1.0_wp
        end do
        call factorize(n, n, both, done)
        if (.not. done) then
            call raise(error, error_no_convergence, "the heat of friction could not be shared out between these bodies")
            return
        end if
        call solve_lower(n, n, 1, both, c)
        call solve_upper(n, n, 1, both, c)
        taken = c(:, 1)
        given = taken + matmul(lower, conduction%share(2)*t + taken)
    end subroutine share_out

    !> The whole matrix H of a kernel.
    subroutine new_interactions(kernel, a, n, matrix, error)
        type(kernel_t), intent(in) :: kernel
        real(wp), intent(in) :: a
        integer, intent(in) :: n
        real(wp), allocatable, intent(out) :: matrix(:, :)
        type(error_t), allocatable, intent(inout) :: error
        type(moments_t) :: moments
        real(wp), allocatable :: h(:, :)
        integer :: i, stat

        allocate (matrix(n, n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        matrix = 0.0_wp
        if (kernel%vanishes) return
        call new_interaction(moments, h, kernel, a, n, n, 4*n + 4, 4*n, error)
        if (allocated(error)) return
        do i = 1, n
            matrix(i:, i) = h(i:, i)
            matrix(i, i:) = h(i:, i)
            matrix(i, i) = matrix(i, i) + moments%diagonal - 1.0_wp
        end do
    end subroutine new_interactions

    !> Of w = (part q + sum of given)/(2 S_1).
    pure subroutine take_means(conduction, source, taken, given, heat)
        type(conduction_t), intent(in) :: conduction
        type(source_t), intent(in) :: source
        real(wp), intent(in) :: taken(:), given(:)
        type(heat_t), intent(out) :: heat
        real(wp) :: part, at_zero, s, a, series(size(given)), w(size(source%q))
        integer :: j

        a = source%radius
        part = 1.0_wp
        if (size(conduction%bodies) > 1) part = conduction%share(2)
        series = given*normalisation(size(given))
        w = part*source%q + even_sum(series, source%u)
        s = conduction%bodies(1)%s(1)
        heat%total = source%total
        if (.not. source%total > 0.0_wp) return
        heat%share = part + sqrt(2.0_wp)*a*taken(1)/source%total
        heat%flux_mean = sum(source%dx*source%q*w)/(s*source%total)
        ! (4/(pi a^2)) int_0^a w sqrt(a^2 - x^2) dx
        heat%area_mean = part*4.0_wp/(pi*a)*sum(source%dx*source%q*source%cosine)
        heat%centre = part*source%centre
        at_zero = 1.0_wp
        do j = 0, size(series) - 1
            heat%centre = heat%centre + series(j + 1)*at_zero
            heat%area_mean = heat%area_mean + series(j + 1)*at_zero**2/((1 - 2*j)*(j + 1))
            at_zero = -at_zero*(2*j + 1)/(2*j + 2)
        end do
        heat%centre = 0.5_wp*heat%centre/s
        heat%area_mean = 0.5_wp*heat%area_mean/s
    end subroutine take_means

    !> Temperature rise at points of a body.
    subroutine heat_field(conduction, contact, state, motion, strength, body, r, z, lower, temperature, error)
        type(conduction_t), intent(in) :: conduction
        type(contact_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        !> sliding or spinning
        integer, intent(in) :: motion
        !> mu v or mu omega, >= 0
        real(wp), intent(in) :: strength
        !> 1 or 2
        integer, intent(in) :: body
        !> >= 0 [length]
        real(wp), intent(in) :: r(:), z(:)
        !> at an interface: below it
        logical, intent(in) :: lower
        !> same size as r
        real(wp), intent(out) :: temperature(:)
        type(error_t), allocatable, intent(inout) :: error
        type(heat_t) :: heat
        real(wp), allocatable :: loads(:, :)
        real(wp) :: flux_z(size(r)), flux_r(size(r))

        temperature = 0.0_wp
        call check_choice(error, "body", body, 1, size(conduction%bodies), &
                          merge("1     ", "1 or 2", size(conduction%bodies) == 1))
        if (.not. allocated(error)) call friction_heat(conduction, contact, state, motion, strength, heat, error, loads)
        if (allocated(error)) return
        call fields_inside(conduction%bodies(body), state%radius, loads(:, body), r, z, lower, temperature, flux_z, flux_r, error)
    end subroutine heat_field

    !> The same of a source that moves over the lower body at any speed, all heat entering it: its mean over
    !> all directions of C(k, s = i v k cos phi).
    subroutine moving_heat(conduction, contact, state, strength, speed, heat, error)
        type(conduction_t), intent(in) :: conduction
        type(contact_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        !> mu v >= 0 with the speed of sliding
        real(wp), intent(in) :: strength
        !> v > 0 of the source over the body [length/time]
        real(wp), intent(in) :: speed
        !> without the mean over the area
        type(heat_t), intent(out) :: heat
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: loads(:, :), z(:), weight(:), waves(:)
        real(wp) :: last, waves_of_speed, hat, less, node(direction_nodes), rule(direction_nodes)
        integer :: i

        call check_positive(error, "speed", speed)
        if (size(conduction%bodies) > 1 .and. .not. allocated(error)) then
            call raise(error, error_invalid, "a source that moves over one of two bodies has no axisymmetric field: give one "// &
                       "body, and its share of the heat")
        end if
        if (allocated(error)) return
        call friction_heat(conduction, contact, state, 1, strength, heat, error, loads)
        if (allocated(error) .or. .not. heat%total > 0.0_wp) return
        associate (body => conduction%bodies(1), a => state%radius)
            waves_of_speed = speed*a*maxval(body%rate)
            last = max(60.0_wp, 2000.0_wp*sqrt(max(waves_of_speed, 1.0e-4_wp)))
            if (body%layers > 0) last = max(last, 20.0_wp*a/body%h(1))
            call gauss_legendre(node, rule, error)
            call wave_rule(1.0e-8_wp, last, 1.0_wp, z, weight, error)
            if (allocated(error)) return
            allocate (waves(size(loads, 1)))
            do i = 1, size(z)
                call even_waves(z(i), waves, error)
                if (allocated(error)) return
                hat = a/pi*sum(waves*loads(:, 1))
                less = weight(i)/a*mean_less_rest(body, z(i)/a, speed, node, rule)/body%s(1)
                heat%centre = heat%centre + hat*less
                heat%flux_mean = heat%flux_mean + 2.0_wp*pi/heat%total*hat**2*less
            end do
        end associate
        heat%area_mean = 0.0_wp
    end subroutine moving_heat

    !> The mean of Re chi(k, i v k cos phi) over all directions, less chi(k, 0): S_0 k (Cbar - C_0). Panels are halved towards
    !> cos phi = 0, near which lies the branch point cos phi = i k/(v c/sigma_r).
    pure function mean_less_rest(body, k, speed, node, weight) result(mean)
        type(conductors_t), intent(in) :: body
        real(wp), intent(in) :: k, speed
        !> of a rule on [0, 1]
        real(wp), intent(in) :: node(:), weight(:)
        real(wp) :: mean
        complex(wp) :: sigma, chi, rest
        real(wp) :: left, right, near
        integer :: j

        mean = 0.0_wp
        call body%response(cmplx(k, 0.0_wp, wp), (0.0_wp, 0.0_wp), sigma, rest)
        near = min(k, 1.0_wp/max(body%depth(), tiny(k)))/max(speed*maxval(body%rate), tiny(k))
        right = half_pi
        do while (right > 0.0_wp)
            left = 0.5_wp*right
            if (right <= near .or. right < shortest_panel) left = 0.0_wp
            do j = 1, size(node)
                call body%response(cmplx(k, 0.0_wp, wp), cmplx(0.0_wp, speed*k*sin(left + (right - left)*node(j)), wp), sigma, chi)
                mean = mean + (right - left)*weight(j)*real(chi - rest, wp)
            end do
            right = left
        end do
        mean = mean/half_pi
    end function mean_less_rest

end module mdrcontact_conduction_heat
