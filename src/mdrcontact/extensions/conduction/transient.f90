! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact area at one Laplace variable s, or at i omega: conductance of an equipotential contact area, and potentials under a
!> given flux (theory/conduction.md (5.1), (5.2), (9.1), (9.2), (9.6)).
module mdrcontact_conduction_transient
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_codes, only: gaussian => gaussian_potential, uniform_centre => centre_potential, &
                                uniform_mean => mean_potential
    use mdrcontact_conduction_bodies, only: conduction_t
    use mdrcontact_error, only: error_domain, error_no_convergence, error_t, raise, to_text
    use mdrcontact_gsl, only: gsl_sf_bessel_j1
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_one_thread, only: solve
    use mdrcontact_numerics_waves, only: basis_t, new_basis, wave_rule
    implicit none (type, external)
    private
    public :: basis_for, given_flux, spot_at, uniform_mean, uniform_centre, gaussian

    !> Products of a polynomial, another and a wave for each Laplace variable: 0.3 s. A step takes up to 28 variables.
    real(wp), parameter :: most_products = 1.5e9_wp
    !> Waves between two questions whether to go on.
    integer, parameter :: between_questions = 10000
    !> Waves under a uniform flux fade as erfc(z/fade) from -reach to reach, of which exp(-fade^2/4) shows in an integral over J_1
    !> and a smooth function, erfc(reach) at its ends; at least so many before.
    real(wp), parameter :: fade = 11.0_wp, reach = 5.5_wp, fewest_waves = 100.0_wp

contains

    !> The polynomials and waves for Laplace variables of sizes between two.
    subroutine basis_for(conduction, a, smallest, largest, basis, error)
        type(conduction_t), intent(in) :: conduction
        !> contact area's radius [length]; |s| [1/time]
        real(wp), intent(in) :: a, smallest, largest
        type(basis_t), intent(out) :: basis
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: depth, deepest, waves, first, last
        integer :: i, order

        depth = conduction%radius_in_layers(a)
        waves = conduction%waves_in(a, largest)
        deepest = 1.0_wp
        first = 1.0_wp
        do i = 1, size(conduction%bodies)
            associate (body => conduction%bodies(i))
                if (body%layers > 0) deepest = max(deepest, body%depth()/a)
                first = min(first, sqrt(smallest*minval(body%rate))*a)
            end associate
        end do
        order = 8 + ceiling(3.5_wp*sqrt(depth) + 2.5_wp*sqrt(waves))
        first = max(min(first, 1.0_wp/deepest), 1.0e-9_wp)
        last = max(4.0_wp*order, 20.0_wp*depth, 1.5_wp*waves, 40.0_wp)
        ! 32/15 waves for each unit of k a
        if (2.1_wp*last*real(order, wp)**2 > most_products .and. .not. allocated(error)) then
            call raise(error, error_domain, " = "//to_text(a)//": it is "//to_text(depth)//" thicknesses of the surface "// &
                       "layer, and in time about 1500 are possible. Omit layers that are thinner", "radius")
            return
        end if
        call new_basis(basis, order, 0.05_wp*first, last, error)
    end subroutine basis_for

    !> G of an equipotential contact area without a film, and on request the series of its flux.
    subroutine spot_at(conduction, a, s, basis, conductance, error, series)
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a
        complex(wp), intent(in) :: s
        type(basis_t), intent(in) :: basis
        complex(wp), intent(out) :: conductance
        type(error_t), allocatable, intent(inout) :: error
        !> coefficients of P_2j(x/a) of q at potential 1
        complex(wp), intent(out), optional :: series(:)
        complex(wp), allocatable :: matrix(:, :)
        complex(wp) :: c(basis%order)
        integer :: i, n, info

        conductance = 0.0_wp
        if (allocated(error)) return
        n = basis%order
        allocate (matrix(n, n))
        call basis%project(conduction%chi(basis%k/a, s), matrix)
        do i = 1, n
            matrix(i, i) = matrix(i, i) + 1.0_wp
        end do
        c = 0.0_wp
        c(1) = 1.0_wp
        call solve(matrix, c, info)
        if (info /= 0) then
            call raise(error, error_no_convergence, "the transient conductance of a contact area was not found")
            return
        end if
        conductance = 4.0_wp*conduction%scale*a*c(1)
        if (present(series)) series = 2.0_wp*conduction%scale*[(sqrt(4.0_wp*i - 3.0_wp)*c(i), i=1, n)]
    end subroutine spot_at

    !> Potential per total flux under a given flux, by waves up to where nothing is left.
    subroutine given_flux(conduction, what, a, s, value, error)
        type(conduction_t), intent(in) :: conduction
        !> uniform_mean, uniform_centre or gaussian
        integer, intent(in) :: what
        real(wp), intent(in) :: a
        complex(wp), intent(in) :: s
        complex(wp), intent(out) :: value
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: z(:), weight(:)
        complex(wp) :: chi
        real(wp) :: last, waves, first, bessel, from
        integer :: i

        value = 0.0_wp
        last = 20.0_wp*conduction%radius_in_layers(a)
        waves = conduction%waves_in(a, abs(s))
        first = 1.0_wp
        do i = 1, size(conduction%bodies)
            if (conduction%bodies(i)%layers > 0) first = min(first, a/conduction%bodies(i)%depth())
        end do
        if (waves > 0.0_wp) first = min(first, waves)
        ! chi falls as waves^2/k^2
        if (what == uniform_mean) last = max(last, 1200.0_wp*sqrt(waves))
        from = huge(1.0_wp)
        if (what == uniform_centre .and. waves > 0.0_wp) then
            ! J_1 averages to 0 where chi is smooth: the integral ends by a fade instead of at a wave
            from = max(last, 2.0_wp*waves, fewest_waves)
            last = from + 2.0_wp*reach*fade
        end if
        if (what == gaussian) last = 18.0_wp
        if (what /= gaussian) value = merge(8.0_wp/(3.0_wp*pi), 1.0_wp, what == uniform_mean)
        if (last > 0.0_wp) then
            call wave_rule(1.0e-9_wp*min(first, last), last, 2.0_wp, z, weight, error)
            if (allocated(error)) return
            do i = 1, size(z)
                if (modulo(i, between_questions) == 0) call check_cancelled(error)
                if (allocated(error)) return
                chi = conduction%chi(cmplx(z(i)/a, 0.0_wp, wp), s)
                if (what == gaussian) then
                    value = value + weight(i)*(1.0_wp + chi)*exp(-z(i)**2/8.0_wp)
                else
                    bessel = gsl_sf_bessel_j1(z(i))/z(i)
                    if (z(i) > from) bessel = 0.5_wp*erfc((z(i) - from)/fade - reach)*bessel
                    value = value + weight(i)*chi*merge(2.0_wp*bessel**2, bessel, what == uniform_mean)
                end if
            end do
        end if
        value = value/(pi*conduction%scale*a)
        if (what == gaussian) value = 0.5_wp*value
    end subroutine given_flux

end module mdrcontact_conduction_transient
