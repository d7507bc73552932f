! SPDX-License-Identifier: GPL-3.0-or-later
!> A spot with a film of constant area resistance R_c in it: R_c j + phi = V.
!>
!>     j(r) = sum c_n P_n(1 - 2 r^2/a^2),  j_hat = a^2 sum c_n J_(2n+1)(ka)/(ka),  A c = V (a^2/2) e_0,  G = pi a^2 c_0/V
!>     A_mn = (a^3/S_0) [N_mn + int_0^inf chi(z/a) J_(2m+1)(z) J_(2n+1)(z) z^-2 dz] + R_c (a^2/2) delta_mn/(2n + 1)
!> The flux is finite at the edge with (a - r) ln(a - r), so that G by n terms is off by n^-6, which one extrapolation removes:
!> theory/conduction.md (4.1)-(4.8).
module mdrcontact_conduction_film
    use, intrinsic :: iso_c_binding, only: c_int
    use mdrcontact_conduction_bodies, only: conduction_t, tolerance
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_gsl, only: disable_gsl_abort, gsl_sf_bessel_j0, gsl_sf_bessel_jn_array
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_lapack, only: dgemm
    use mdrcontact_line_rule, only: largest_rule, new_rule, rule_t
    use mdrcontact_line_series, only: add_projections
    use mdrcontact_line_solve, only: factorize, solve_lower
    use mdrcontact_numerics_even_waves, only: highest_order
    use mdrcontact_numerics_waves, only: wave_rule
    implicit none (type, external)
    private
    public :: film_spot_t, new_film_spot, of_half_space, odd_waves

    !> Terms at first and at most.
    integer, parameter :: first_terms = 40, most_terms = 1280
    !> Terms from which on values of the flux, off by n^-4, are right.
    integer, parameter, public :: terms_of_flux = 320
    !> Where exp(-2 k H) is nothing.
    real(wp), parameter :: faded = 20.0_wp
    integer, parameter :: octaves = 44
    complex(wp), parameter :: steady = (0.0_wp, 0.0_wp)
    !> Terms of the Legendre series of the line load.
    integer, parameter :: line_terms = 256

    !> The flux through a spot at potential 1.
    type :: film_spot_t
        real(wp) :: radius = 0.0_wp
        !> G and dG/da
        real(wp) :: conductance = 0.0_wp, slope = 0.0_wp
        !> c_n, n = 0, 1, ...
        real(wp), allocatable :: c(:)
    contains
        procedure :: line_load
        procedure :: flux
    end type film_spot_t

contains

    !> The spot by as many terms as its conductance takes.
    subroutine new_film_spot(self, conduction, a, error, fewest)
        type(film_spot_t), intent(out) :: self
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error
        !> terms at least
        integer, intent(in), optional :: fewest
        real(wp) :: reached
        integer :: n

        if (allocated(error)) return
        n = first_terms
        if (present(fewest)) n = fewest
        do
            call solve_with(self, conduction, a, n, reached, error)
            if (allocated(error) .or. reached <= 50.0_wp*tolerance) return
            if (n >= most_terms) exit
            n = 2*n
        end do
        call raise(error, error_no_convergence, "the flux through a film of resistance "//to_text(conduction%film)// &
                   " in a spot of radius "//to_text(a)//" is off by about "//to_text(reached)//": its edge is too thin; "// &
                   "without a film the spot has almost the same conductance")
    end subroutine new_film_spot

    subroutine solve_with(self, conduction, a, n, reached, error)
        type(film_spot_t), intent(inout) :: self
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a
        integer, intent(in) :: n
        !> what the extrapolation changed, relative: more than what is left
        real(wp), intent(out) :: reached
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: matrix(:, :), slope(:, :), y(:, :), c(:, :)
        real(wp) :: of_half(2), of_all(2)
        logical :: done

        reached = huge(reached)
        allocate (matrix(n, n), slope(n, n), y(n, 1), c(n, 1))
        call fill(conduction, a, matrix, slope, error)
        if (allocated(error)) return
        call factorize(n, n, matrix, done)
        if (.not. done) then
            call raise(error, error_no_convergence, "the layers of these bodies nearly cancel at spot radius "//to_text(a))
            return
        end if
        y = 0.0_wp
        y(1, 1) = 0.5_wp*a**2
        call solve_lower(n, n, 1, matrix, y)
        of_half = numbers(n/2)
        of_all = numbers(n)
        of_half = (of_all - of_half)/63.0_wp
        reached = maxval(abs(of_half/of_all))
        self%radius = a
        self%conductance = of_all(1) + of_half(1)
        self%slope = of_all(2) + of_half(2)
        self%c = c(:, 1)

    contains

        !> G and dG/da = 4 G/a - 2 pi (c, A' c) with the first m terms.
        function numbers(m) result(values)
            integer, intent(in) :: m
            real(wp) :: values(2)
            integer :: i

            c = 0.0_wp
            c(:m, 1) = y(:m, 1)
            call solve_leading(m, n, matrix, c)
            values(1) = 2.0_wp*pi*sum(y(:m, 1)**2)
            values(2) = 4.0_wp*values(1)/a
            do i = 1, m
                values(2) = values(2) - 2.0_wp*pi*c(i, 1)*sum(slope(:m, i)*c(:m, 1))
            end do
        end function numbers

    end subroutine solve_with

    !> Replaces x by inv(transpose(L)) x of the leading m unknowns.
    pure subroutine solve_leading(m, n, a, x)
        integer, intent(in) :: m, n
        real(wp), intent(in) :: a(n, n)
        real(wp), intent(inout) :: x(n, 1)
        integer :: j

        do j = m, 1, -1
            x(j, 1) = (x(j, 1) - sum(a(j + 1:m, j)*x(j + 1:m, 1)))/a(j, j)
        end do
    end subroutine solve_leading

    !> A, and dA/da by the slope of chi, which a step into the complex plane gives without a difference.
    subroutine fill(conduction, a, matrix, slope, error)
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a
        real(wp), intent(out) :: matrix(:, :), slope(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: z(:), weight(:), waves(:, :), scaled(:, :)
        complex(wp) :: chi
        real(wp), parameter :: tiny_step = 1.0e-30_wp
        integer :: i, m, n

        n = size(matrix, 1)
        matrix = 0.0_wp
        slope = 0.0_wp
        if (.not. conduction%kernel%vanishes) then
            call rule_of(conduction, a, z, weight, error)
            if (allocated(error)) return
            allocate (waves(n, size(z)), scaled(n, size(z)))
            do i = 1, size(z)
                call odd_waves(z(i), waves(:, i))
                chi = conduction%chi(cmplx(z(i)/a, tiny_step*z(i)/a, wp), steady)
                ! of d chi/d ln k
                scaled(:, i) = waves(:, i)*(weight(i)/z(i)**2*real(chi, wp))
                weight(i) = weight(i)/z(i)**2*aimag(chi)/tiny_step
            end do
            call dgemm("N", "T", n, n, size(z), 1.0_wp, scaled, n, waves, n, 0.0_wp, matrix, n)
            do i = 1, size(z)
                scaled(:, i) = waves(:, i)*weight(i)
            end do
            call dgemm("N", "T", n, n, size(z), -1.0_wp, scaled, n, waves, n, 0.0_wp, slope, n)
        end if
        do i = 1, n
            do m = 1, n
                matrix(m, i) = matrix(m, i) + of_half_space(m - 1, i - 1)
            end do
        end do
        slope = a**2/conduction%scale*(3.0_wp*matrix + slope)
        matrix = a**3/conduction%scale*matrix
        do i = 1, n
            matrix(i, i) = matrix(i, i) + 0.5_wp*a**2*conduction%film/(2*i - 1)
            slope(i, i) = slope(i, i) + a*conduction%film/(2*i - 1)
        end do
    end subroutine fill

    !> N_mn = int_0^inf J_(2m+1) J_(2n+1) z^-2 dz.
    pure function of_half_space(m, n) result(value)
        integer, intent(in) :: m, n
        real(wp) :: value

        value = (-1)**(m - n)/(4.0_wp*pi*(m + n + 0.5_wp)*(m + n + 1.5_wp)*(0.25_wp - real(m - n, wp)**2))
    end function of_half_space

    !> J_1, J_3, ... at z > 0; those that are nothing beside the others are 0.
    subroutine odd_waves(z, values)
        real(wp), intent(in) :: z
        real(wp), intent(out) :: values(:)
        real(wp) :: bessel(2*size(values))
        integer :: status

        call disable_gsl_abort()
        bessel = 0.0_wp
        status = int(gsl_sf_bessel_jn_array(1_c_int, int(max(1, highest_order(z, 2*size(values) - 1)), c_int), z, bessel))
        values = bessel(1::2)
    end subroutine odd_waves

    !> The line load q as coefficients of P_2j(x/a), cos theta = x/a: q = a sum c_n (2 (-1)^n/(2n + 1)) sin((2n + 1) theta).
    subroutine line_load(self, q, error)
        class(film_spot_t), intent(in) :: self
        real(wp), allocatable, intent(out) :: q(:)
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp), allocatable :: theta(:), values(:)
        integer :: j

        call new_rule(rule, 1024, error)
        if (allocated(error)) return
        theta = 0.5_wp*half_pi*rule%distance
        values = line_at(self, theta)
        values = values*sin(theta)*0.5_wp*half_pi*rule%weights
        allocate (q(line_terms))
        q = 0.0_wp
        call add_projections(size(theta), cos(theta), values, q)
        q = q*[(real(4*j + 1, wp), j=0, line_terms - 1)]
    end subroutine line_load

    !> q at theta.
    pure function line_at(self, theta) result(q)
        type(film_spot_t), intent(in) :: self
        real(wp), intent(in) :: theta(:)
        real(wp) :: q(size(theta))
        integer :: n

        q = 0.0_wp
        do n = 0, size(self%c) - 1
            q = q + self%radius*self%c(n + 1)*2*(-1)**n/real(2*n + 1, wp)*sin((2*n + 1)*theta)
        end do
    end function line_at

    !> j(r) = (V - phi)/R_c at V = 1, which keeps n^-4 of what the series leaves:
    !>     phi(r) = (1/(pi S_0)) int_0^(pi/2) q(r sin t) dt + (1/S_0) int_0^inf j_hat chi J_0(kr) dk.
    subroutine flux(self, conduction, r, density, error)
        class(film_spot_t), intent(in) :: self
        type(conduction_t), intent(in) :: conduction
        !> 0 <= r <= a [length]
        real(wp), intent(in) :: r(:)
        !> same size as r
        real(wp), intent(out) :: density(:)
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp), allocatable :: z(:), weight(:), waves(:)
        integer :: i, j

        density = 0.0_wp
        call new_rule(rule, min(4*size(self%c), largest_rule), error)
        if (allocated(error)) return
        do i = 1, size(r)
            density(i) = 0.25_wp/conduction%scale*sum(rule%weights*line_at(self, acos(min(r(i)/self%radius &
                                                                                     *sin(0.5_wp*half_pi*rule%distance), 1.0_wp))))
        end do
        if (.not. conduction%kernel%vanishes) then
            call rule_of(conduction, self%radius, z, weight, error)
            if (allocated(error)) return
            allocate (waves(size(self%c)))
            do j = 1, size(z)
                call odd_waves(z(j), waves)
                weight(j) = weight(j)*self%radius/conduction%scale*sum(waves*self%c)/z(j) &
                            *real(conduction%chi(cmplx(z(j)/self%radius, 0.0_wp, wp), steady), wp)
                density = density + weight(j)*[(gsl_sf_bessel_j0(z(j)*r(i)/self%radius), i=1, size(r))]
            end do
        end if
        density = (1.0_wp - density)/conduction%film
    end subroutine flux

    !> For integrals of chi over z = ka.
    subroutine rule_of(conduction, a, z, weight, error)
        type(conduction_t), intent(in) :: conduction
        !> [length]
        real(wp), intent(in) :: a
        real(wp), allocatable, intent(out) :: z(:), weight(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: thinnest
        integer :: i

        thinnest = huge(thinnest)
        do i = 1, size(conduction%bodies)
            if (conduction%bodies(i)%layers > 0) thinnest = min(thinnest, conduction%bodies(i)%h(1))
        end do
        call wave_rule(scale(1.0_wp, -octaves)*min(1.0_wp, a/thinnest), faded*a/thinnest, 2.0_wp, z, weight, error)
    end subroutine rule_of

end module mdrcontact_conduction_film
