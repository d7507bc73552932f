! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact area between rough surfaces, whose area resistance depends on the pressure of the contact: R_c(r) = kappa/p(r), or that
!> of plastic micro-contacts (rough_law.f90).
!>
!> With j = w sum c_n P_n(1 - 2 r^2/a^2), w = sqrt(1 - r^2/a^2), line loads are polynomials times 1 - u^2, and with their Legendre
!> coefficients T_nj and the springs' matrix H
!>     [(a/(4 pi S_0)) T (1 + H) T^t + int R_c j_m j_n r dr] c = f = (a sqrt(2)/(2 pi)) T_.0,  G = 2 pi (f, c)   (V = 1)
!> (theory/conduction.md (4.9), (4.10)).
!> Where R_c is small, or p not smooth, its terms do not fall: then by panels (rough_panels.f90).
module mdrcontact_conduction_rough
    use mdrcontact_conduction_bodies, only: conduction_t, tolerance
    use mdrcontact_conduction_rough_law, only: micro_contacts_t, new_micro_contacts, proportional_t, rough_law_t
    use mdrcontact_conduction_rough_panels, only: conductance_by_panels, solve_flux
    use mdrcontact_conduction_source, only: has_line_force
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_made, check_positive, error_domain, error_invalid, error_no_convergence, error_t, raise, &
                                to_text
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_line_legendre, only: interaction_matrix, normalisation
    use mdrcontact_line_rule, only: new_rule, rule_t
    use mdrcontact_line_series, only: add_projections
    use mdrcontact_line_solve, only: first_unknowns
    use mdrcontact_numerics_quadrature, only: legendre
    implicit none (type, external)
    private
    public :: rough_conductance, joint_conductance

    !> Terms of the series, fewer of them that must agree, and nodes of the rules.
    integer, parameter :: terms = 28, fewer = 20, nodes = 96
    !> Largest relative difference of two results, for the series (panels are used otherwise) and for panels.
    real(wp), parameter :: settled = 1.0e-9_wp, allowed = 1.0e-6_wp

contains

    !> G of a state with R_c = kappa/p.
    subroutine rough_conductance(conduction, contact, state, kappa, conductance, error)
        type(conduction_t), intent(in) :: conduction
        type(contact_t), intent(in), target :: contact
        !> of that contact, a > 0, nowhere with tension
        type(contact_state_t), intent(in) :: state
        !> > 0: area resistance times pressure [modulus length^2/conductance]
        real(wp), intent(in) :: kappa
        !> [conductance]
        real(wp), intent(out) :: conductance
        type(error_t), allocatable, intent(out) :: error

        conductance = 0.0_wp
        call check_made(error, "conduction", conduction%is_made)
        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        call check_positive(error, "kappa", kappa)
        if (.not. allocated(error)) call conductance_with(conduction, contact, state, proportional_t(kappa), conductance, error)
    end subroutine rough_conductance

    !> G of a state with plastic micro-contacts and gas between the surfaces.
    subroutine joint_conductance(conduction, contact, state, roughness, slope, hardness, gas, jump, conductance, error)
        type(conduction_t), intent(in) :: conduction
        type(contact_t), intent(in), target :: contact
        !> see rough_conductance
        type(contact_state_t), intent(in) :: state
        !> see new_micro_contacts
        real(wp), intent(in) :: roughness, slope, hardness, gas, jump
        !> [conductance]
        real(wp), intent(out) :: conductance
        type(error_t), allocatable, intent(out) :: error
        type(micro_contacts_t) :: law

        conductance = 0.0_wp
        call check_made(error, "conduction", conduction%is_made)
        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        call new_micro_contacts(law, conduction, roughness, slope, hardness, gas, jump, error)
        if (.not. allocated(error)) call conductance_with(conduction, contact, state, law, conductance, error)
    end subroutine joint_conductance

    !> G of a state.
    subroutine conductance_with(conduction, contact, state, law, conductance, error)
        type(conduction_t), intent(in) :: conduction
        type(contact_t), intent(in), target :: contact
        type(contact_state_t), intent(in) :: state
        class(rough_law_t), intent(in) :: law
        real(wp), intent(out) :: conductance
        type(error_t), allocatable, intent(inout) :: error
        type(contact_load_t) :: load
        real(wp) :: by_panels, left, reached

        conductance = 0.0_wp
        call conduction%check_steady(error)
        call conduction%check_radius(state%radius, error)
        if (allocated(error)) return
        if (has_line_force(contact%equilibrium, state)) then
            call raise(error, error_invalid, "contact: a conductance that depends on the pressure is not available with a "// &
                       "line force at the edge, as under a plate or a flat end on a surface with tension. Omit the plate or "// &
                       "the tension")
            return
        end if
        call contact%load(state, load, error)
        if (.not. allocated(error)) call conductance_by_series(conduction, load, law, conductance, reached, error)
        if (allocated(error) .or. reached <= settled) return
        call conductance_by_panels(conduction, load, law, by_panels, left, error)
        if (allocated(error)) return
        if (left < reached) conductance = by_panels
        reached = min(left, reached)
        if (reached <= allowed) return
        call raise(error, error_no_convergence, "the flux through this rough contact has an error of about "//to_text(reached)// &
                   ", because its pressure is not smooth")
    end subroutine conductance_with

    !> G by the series, and its relative decrease with fewer terms.
    subroutine conductance_by_series(conduction, load, law, conductance, reached, error)
        type(conduction_t), intent(in) :: conduction
        type(contact_load_t), intent(in) :: load
        class(rough_law_t), intent(in) :: law
        real(wp), intent(out) :: conductance, reached
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: matrix(:, :), spectrum(:, :)
        real(wp) :: f(terms, 1), few
        integer :: i, m

        conductance = 0.0_wp
        reached = 0.0_wp
        m = terms + 2 + ceiling(1.5_wp*first_unknowns(conduction%kernel, tolerance, load%state%radius/conduction%kernel%unit, &
                                                      .false., .true.))
        allocate (matrix(terms, terms), spectrum(terms, m))
        call fill_spectrum(spectrum, error)
        call fill_springs(conduction, load%state%radius, spectrum, matrix, error)
        call add_resistance(load, law, matrix, error)
        if (allocated(error)) return
        f(:, 1) = load%state%radius**2*sqrt(2.0_wp)/(2.0_wp*pi)*spectrum(:, 1)
        call solve_flux(matrix, f, error)
        if (allocated(error)) return
        conductance = 2.0_wp*pi*sum(f**2)
        few = 2.0_wp*pi*sum([(f(i, 1)**2, i=1, fewer)])
        reached = abs(conductance - few)/conductance
    end subroutine conductance_by_series

    !> T_nj at a = 1: q_n(u) = 2 sqrt(1 - u^2) int_0^1 j_n dt at r^2 = u^2 + (1 - u^2) t^2, by Gauss in angles.
    subroutine fill_spectrum(spectrum, error)
        real(wp), intent(out) :: spectrum(:, :)
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp), allocatable :: angle(:), weight(:), p(:, :), q(:, :), row(:)
        integer :: i, j, n

        spectrum = 0.0_wp
        call new_rule(rule, nodes, error)
        if (allocated(error)) return
        angle = 0.5_wp*half_pi*rule%distance
        weight = 0.5_wp*half_pi*rule%weights
        n = size(spectrum, 1)
        allocate (p(size(angle), n), q(size(angle), n), row(size(spectrum, 2)))
        do i = 1, size(angle)
            associate (root => cos(angle(i)), u => sin(angle(i)))
                p = legendre(n, 1.0_wp - 2.0_wp*(u**2 + (root*sin(angle))**2))
                ! w = root cos, dt = cos
                q(i, :) = [(2.0_wp*root**2*sum(weight*cos(angle)**2*p(:, j)), j=1, n)]
            end associate
        end do
        do j = 1, n
            row = 0.0_wp
            call add_projections(size(angle), sin(angle), 2.0_wp*weight*cos(angle)*q(:, j), row)
            spectrum(j, :) = row*normalisation(size(row))
        end do
    end subroutine fill_spectrum

    !> (a/(4 pi S_0)) T (1 + H) T^t, T of a contact area of radius a being a times that of radius 1.
    subroutine fill_springs(conduction, a, spectrum, matrix, error)
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a, spectrum(:, :)
        real(wp), intent(out) :: matrix(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: whole(:, :)
        integer :: i, m

        matrix = 0.0_wp
        m = size(spectrum, 2)
        call interaction_matrix(conduction%kernel, a, m, 4*m + 4, whole, error)
        if (allocated(error)) return
        do i = 1, m
            whole(i, i) = whole(i, i) + 1.0_wp
        end do
        matrix = a**3/(4.0_wp*pi*conduction%scale)*matmul(spectrum, matmul(whole, transpose(spectrum)))
    end subroutine fill_springs

    !> int R_c j_m j_n r dr.
    subroutine add_resistance(load, law, matrix, error)
        type(contact_load_t), intent(in) :: load
        class(rough_law_t), intent(in) :: law
        real(wp), intent(inout) :: matrix(:, :)
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp), allocatable :: angle(:), weight(:), pressure(:), p(:, :)
        integer :: i, j

        call new_rule(rule, nodes, error)
        if (allocated(error)) return
        angle = 0.5_wp*half_pi*rule%distance
        allocate (pressure(size(angle)), p(size(angle), size(matrix, 1)))
        call load%pressure(min(load%state%radius*sin(angle), load%state%radius), pressure, error)
        if (allocated(error)) return
        if (.not. all(pressure > 0.0_wp)) then
            call raise(error, error_domain, "the pressure of this contact is not greater than 0 everywhere: a conductance "// &
                       "that depends on it is not defined")
            return
        end if
        call law%check(maxval(pressure), error)
        if (allocated(error)) return
        p = legendre(size(p, 2), 1.0_wp - 2.0_wp*sin(angle)**2)
        weight = 0.5_wp*half_pi*rule%weights*law%scale*load%state%radius**2*cos(angle)**3*sin(angle)/law%conductance(pressure)
        do j = 1, size(matrix, 1)
            do i = 1, size(matrix, 1)
                matrix(i, j) = matrix(i, j) + sum(weight*p(:, i)*p(:, j))
            end do
        end do
    end subroutine add_resistance

end module mdrcontact_conduction_rough
