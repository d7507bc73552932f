! SPDX-License-Identifier: GPL-3.0-or-later
!> Temperatures under the heat of friction: w = (1 + K_1) q_1/(2 S_1) on the line, for any heat q_1 that enters the lower body.
!>
!> Of two bodies on both of which the source rests (small amplitudes or speeds), each takes what makes the temperatures equal all
!> over the contact: (C_1 + C_2) q_1 = C_2 q. One body takes it all
!> (theory/conduction.md (5.3), (10.2), (10.3)).
module mdrcontact_conduction_heat
    use mdrcontact_conduction_bodies, only: conduction_t, tolerance
    use mdrcontact_conduction_inside, only: fields_inside
    use mdrcontact_conduction_source, only: centre_and_arc, new_source, source_t, spinning
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_choice, check_made, error_invalid, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_line_legendre, only: interaction_matrix, normalisation
    use mdrcontact_line_moments, only: is_smooth
    use mdrcontact_line_solve, only: factorize, first_unknowns, nodes_of_film, solve_lower, solve_upper
    implicit none (type, external)
    private
    public :: heat_t, friction_heat, heat_field

    !> Terms of a series for temperatures inside under an indenter that is not smooth.
    integer, parameter :: terms_of_kinked = 200
    !> Relative limit of the last terms of a temperature on the line, and largest number of terms.
    real(wp), parameter :: settled = 1.0e-10_wp
    integer, parameter :: most_unknowns = 1500

    !> Per the strength of the source.
    type :: heat_t
        !> Q, and the part of it that the lower body takes
        real(wp) :: total = 0.0_wp, share = 1.0_wp
        !> temperature rise in the centre, its mean over the flux, and over the area of the contact
        real(wp) :: centre = 0.0_wp, flux_mean = 0.0_wp, area_mean = 0.0_wp
        !> of a source that moves, along the line through the centre: the largest temperature rise, and its distance behind the
        !> centre
        real(wp) :: largest = 0.0_wp, behind = 0.0_wp
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
        type(error_t), allocatable, intent(out) :: error
        !> coefficients of P_2j(x/a) (term, body)
        real(wp), allocatable, intent(out), optional :: loads(:, :)
        type(source_t) :: source
        real(wp), allocatable :: flux_into_lower(:), temperature(:)
        real(wp) :: reached
        integer :: n, terms
        logical :: is_kinked

        call check_made(error, "conduction", conduction%is_made)
        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        call conduction%check_steady(error)
        call conduction%check_radius(state%radius, error)
        if (conduction%film > 0.0_wp .and. size(conduction%bodies) > 1 .and. .not. allocated(error)) then
            call raise(error, error_invalid, "film: frictional heat of two bodies is not available with a film. Omit the film")
        end if
        if (allocated(error)) return
        n = unknowns_for(conduction, state%radius)
        ! the pressure under a tension ends by a jump
        is_kinked = motion == spinning .or. .not. is_smooth(contact%equilibrium%profile) .or. &
                    contact%equilibrium%medium%sheet%tension > 0.0_wp
        ! coefficients that fall slowly
        if (is_kinked) n = 2*n
        terms = 4*n
        if (is_kinked .and. present(loads)) terms = max(terms, terms_of_kinked)
        call new_source(source, contact, state, motion, strength, terms, present(loads), error)
        if (allocated(error)) return
        do
            if (allocated(flux_into_lower)) deallocate (flux_into_lower, temperature)
            allocate (flux_into_lower(n), temperature(n))
            call share_out(conduction, source, n, flux_into_lower, temperature, reached, error)
            if (allocated(error)) return
            if (reached <= settled) exit
            if (n >= most_unknowns) then
                call raise(error, error_no_convergence, "the temperature due to frictional heat at contact radius "// &
                           to_text(state%radius)//" has an error of about "//to_text(reached))
                return
            end if
            n = n + n/2
        end do
        call take_means(conduction, source, flux_into_lower, temperature, heat)
        if (present(loads)) call split(conduction, source, flux_into_lower, loads)
    end subroutine friction_heat

    !> Coefficients of P_2j(x/a) of what enters each body.
    subroutine split(conduction, source, flux_into_lower, loads)
        type(conduction_t), intent(in) :: conduction
        type(source_t), intent(in) :: source
        real(wp), intent(in) :: flux_into_lower(:)
        real(wp), allocatable, intent(out) :: loads(:, :)
        integer :: i, m, n

        n = size(flux_into_lower)
        m = max(size(source%t), n)
        allocate (loads(m, size(conduction%bodies)))
        loads(:, 1) = source%series(m)
        if (size(loads, 2) > 1) then
            loads(:, 2) = conduction%share(1)*loads(:, 1)
            loads(:n, 2) = loads(:n, 2) - flux_into_lower
            loads(:, 1) = conduction%share(2)*loads(:, 1)
            loads(:n, 1) = loads(:n, 1) + flux_into_lower
        end if
        do i = 1, size(loads, 2)
            loads(:, i) = loads(:, i)*normalisation(m)
        end do
    end subroutine split

    !> Terms that the kernels take.
    pure function unknowns_for(conduction, a) result(n)
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a
        integer :: n
        integer :: i

        n = 6
        do i = 1, size(conduction%bodies)
            associate (kernel => conduction%kernels(i))
                n = max(n, 3 + ceiling(1.4_wp*first_unknowns(kernel, tolerance, a/kernel%unit, .false., .false.)))
            end associate
        end do
    end function unknowns_for

    !> Flux into the lower body in addition to its part S_0/S_2 of the source, (1 + H) c' = (S_0/S_2) (H_2 - H) t, and what the
    !> layers of the lower body add to the line's temperature, c' + H_1 c.
    subroutine share_out(conduction, source, n, flux_into_lower, temperature, reached, error)
        type(conduction_t), intent(in) :: conduction
        type(source_t), intent(in) :: source
        !> terms
        integer, intent(in) :: n
        real(wp), intent(out) :: flux_into_lower(n)
        real(wp), intent(out) :: temperature(n)
        !> how large their last terms are, relative to the source
        real(wp), intent(out) :: reached
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: lower(:, :), upper(:, :), c(:, :)
        real(wp) :: t(n)
        integer :: i
        logical :: done

        reached = 0.0_wp
        flux_into_lower = 0.0_wp
        temperature = 0.0_wp
        call springs_of(conduction, 1, source%radius, n, lower, error)
        if (allocated(error)) return
        t = source%series(n)
        if (size(conduction%bodies) == 1) then
            temperature = matmul(lower, t)
        else
            call springs_of(conduction, 2, source%radius, n, upper, error)
            if (allocated(error)) return
            allocate (c(n, 1))
            c(:, 1) = conduction%share(2)*conduction%share(1)*(matmul(upper, t) - matmul(lower, t))
            upper = conduction%share(1)*lower + conduction%share(2)*upper
            do i = 1, n
                upper(i, i) = upper(i, i) + 1.0_wp
            end do
            call factorize(n, n, upper, done)
            if (.not. done) then
                call raise(error, error_no_convergence, "the partition of the frictional heat between the bodies was not found")
                return
            end if
            call solve_lower(n, n, 1, upper, c)
            call solve_upper(n, n, 1, upper, c)
            flux_into_lower = c(:, 1)
            temperature = flux_into_lower + matmul(lower, conduction%share(2)*t + flux_into_lower)
        end if
        if (source%total > 0.0_wp) reached = 3.0_wp*maxval(abs(temperature(n - 1:)))/(norm2(t) + norm2(temperature))
    end subroutine share_out

    !> H of a body.
    subroutine springs_of(conduction, body, a, n, matrix, error)
        type(conduction_t), intent(in) :: conduction
        integer, intent(in) :: body
        real(wp), intent(in) :: a
        integer, intent(in) :: n
        real(wp), allocatable, intent(out) :: matrix(:, :)
        type(error_t), allocatable, intent(inout) :: error
        integer :: nodes

        associate (kernel => conduction%kernels(body))
            nodes = 0
            if (.not. kernel%vanishes) nodes = max(ceiling(nodes_of_film(tolerance, a/kernel%unit)), 2*n)
            call interaction_matrix(kernel, a, n, nodes, matrix, error)
        end associate
    end subroutine springs_of

    !> Results for w = (part q + sum of temperature)/(2 S_1).
    pure subroutine take_means(conduction, source, flux_into_lower, temperature, heat)
        type(conduction_t), intent(in) :: conduction
        type(source_t), intent(in) :: source
        real(wp), intent(in) :: flux_into_lower(:), temperature(:)
        type(heat_t), intent(out) :: heat
        real(wp) :: part, own(2), s, a

        a = source%radius
        part = 1.0_wp
        if (size(conduction%bodies) > 1) part = conduction%share(2)
        s = conduction%bodies(1)%s(1)
        heat%total = source%total
        if (.not. source%total > 0.0_wp) return
        own = centre_and_arc(temperature)
        heat%share = part + sqrt(2.0_wp)*a*flux_into_lower(1)/source%total
        heat%flux_mean = (part*source%square + 0.5_wp*a*sum(source%series(size(temperature))*temperature))/(s*source%total)
        heat%centre = 0.5_wp*(part*source%centre + own(1))/s
        ! (4/(pi a^2)) int_0^a w sqrt(a^2 - x^2) dx
        heat%area_mean = 2.0_wp/(pi*s)*(part*source%arc/a + own(2))
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
        type(error_t), allocatable, intent(out) :: error
        type(heat_t) :: heat
        real(wp), allocatable :: loads(:, :)
        real(wp) :: flux_z(size(r)), flux_r(size(r))

        temperature = 0.0_wp
        call check_made(error, "conduction", conduction%is_made)
        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        call check_choice(error, "body", body, 1, size(conduction%bodies), &
                          merge("1     ", "1 or 2", size(conduction%bodies) == 1))
        if (.not. allocated(error)) call friction_heat(conduction, contact, state, motion, strength, heat, error, loads)
        if (allocated(error)) return
        call fields_inside(conduction%bodies(body), state%radius, loads(:, body), r, z, lower, temperature, flux_z, flux_r, error)
    end subroutine heat_field

end module mdrcontact_conduction_heat
