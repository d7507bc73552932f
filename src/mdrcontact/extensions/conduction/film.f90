! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact area with a film of constant area resistance R_c in it, R_c j + phi = V, steady or at one Laplace variable.
!>
!>     j(r) = sum c_n P_n(1 - 2 r^2/a^2),  j_hat = a^2 sum c_n J_(2n+1)(ka)/(ka),  A c = V (a^2/2) e_0,  G = pi a^2 c_0/V
!>     A_mn = (a^3/S_0) [N_mn + int_0^inf chi(z/a) J_(2m+1)(z) J_(2n+1)(z) z^-2 dz] + R_c (a^2/2) delta_mn/(2n + 1)
!> The flux is finite at the edge with (a - r) ln(a - r), so that the error of G by n terms is n^-6, which one extrapolation
!> removes: theory/conduction.md (4.1)-(4.8).
module mdrcontact_conduction_film
    use, intrinsic :: iso_c_binding, only: c_int
    use mdrcontact_conduction_bodies, only: conduction_t, tolerance
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_gsl, only: disable_gsl_abort, gsl_sf_bessel_j0, gsl_sf_bessel_jn_array
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_line_rule, only: largest_rule, new_rule, rule_t
    use mdrcontact_line_series, only: add_projections
    use mdrcontact_numerics_even_waves, only: highest_order
    use mdrcontact_numerics_one_thread, only: add_product, solve_system => solve
    use mdrcontact_numerics_waves, only: wave_rule
    implicit none (type, external)
    private
    public :: film_spot_t, new_film_spot, film_basis_t, new_film_basis, film_spot_at

    !> Terms of the steady solution at the start and at most, and in time.
    integer, parameter :: first_terms = 40, most_terms = 1280, terms_in_time = 96
    !> Terms from which on values of the flux, with an error n^-4, are accurate.
    integer, parameter, public :: terms_of_flux = 320
    !> Largest relative change by the extrapolation.
    real(wp), parameter :: allowed = 50.0_wp*tolerance, allowed_in_time = 1.0e-8_wp
    !> Exponent 2 k H beyond which exp(-2 k H) is negligible.
    real(wp), parameter :: faded = 20.0_wp
    !> A step of the radius into the complex plane, relative, which gives slopes without a difference.
    real(wp), parameter :: tiny_step = 1.0e-30_wp
    complex(wp), parameter :: steady = (0.0_wp, 0.0_wp)
    !> Terms of the Legendre series of the line load.
    integer, parameter :: line_terms = 256

    !> J_1, J_3, ... (term, node) at the nodes z of a rule, whose weights are divided by z^2.
    type :: film_basis_t
        real(wp), allocatable :: z(:), weight(:), waves(:, :)
    end type film_basis_t

    !> The flux through a steady contact area at potential 1.
    type :: film_spot_t
        real(wp) :: radius = 0.0_wp
        !> G and dG/da
        real(wp) :: conductance = 0.0_wp, slope = 0.0_wp
        !> c_n, n = 0, 1, ...
        real(wp), allocatable :: c(:)
        type(film_basis_t) :: basis
    contains
        procedure :: line_load
        procedure :: flux
    end type film_spot_t

contains

    !> Solution with as many terms as its conductance needs.
    subroutine new_film_spot(self, conduction, a, error, fewest)
        type(film_spot_t), intent(out) :: self
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error
        !> terms at least
        integer, intent(in), optional :: fewest
        complex(wp) :: total, change
        complex(wp), allocatable :: c(:)
        integer :: n

        n = first_terms
        if (present(fewest)) n = fewest
        do
            call new_basis(self%basis, conduction, a, n, 0.0_wp, error)
            if (allocated(error)) return
            allocate (c(n))
            call solve(conduction, cmplx(a, tiny_step*a, wp), steady, self%basis, c, total, change, error)
            if (allocated(error)) return
            if (max(abs(real(change, wp)/real(total, wp)), abs(aimag(change)/aimag(total))) <= allowed) exit
            if (n >= most_terms) then
                call raise_missed(conduction, a, change/total, "", "omit the film: the conductance is almost equal", error)
                return
            end if
            n = 2*n
            deallocate (c)
        end do
        self%radius = a
        self%conductance = real(total, wp)
        self%slope = aimag(total)/(tiny_step*a)
        self%c = real(c, wp)
    end subroutine new_film_spot

    !> Data shared by contact areas at Laplace variables up to this size.
    subroutine new_film_basis(self, conduction, a, largest, error)
        type(film_basis_t), intent(out) :: self
        type(conduction_t), intent(in) :: conduction
        !> [length], and |s| > 0 [1/time]
        real(wp), intent(in) :: a, largest
        type(error_t), allocatable, intent(inout) :: error

        call new_basis(self, conduction, a, terms_in_time, largest, error)
    end subroutine new_film_basis

    !> G at a Laplace variable s.
    subroutine film_spot_at(conduction, a, s, basis, conductance, error)
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a
        complex(wp), intent(in) :: s
        type(film_basis_t), intent(in) :: basis
        complex(wp), intent(out) :: conductance
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: c(terms_in_time), change

        call solve(conduction, cmplx(a, 0.0_wp, wp), s, basis, c, conductance, change, error)
        if (allocated(error) .or. abs(change) <= allowed_in_time*abs(conductance)) return
        call raise_missed(conduction, a, change/conductance, " in time", "", error)
    end subroutine film_spot_at

    !> n terms. In time chi falls as k^-2, steady as exp(-2 k H).
    subroutine new_basis(self, conduction, a, n, largest, error)
        type(film_basis_t), intent(out) :: self
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a, largest
        integer, intent(in) :: n
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: ratio, first, last
        integer :: i

        ratio = conduction%radius_in_layers(a)
        first = scale(min(1.0_wp, ratio), -44)
        last = faded*ratio
        if (largest > 0.0_wp) then
            first = 1.0e-9_wp
            last = max(last, 4.0_wp*n, 1200.0_wp*sqrt(conduction%waves_in(a, largest)))
        end if
        if (last > 0.0_wp) then
            call wave_rule(first, last, 2.0_wp, self%z, self%weight, error)
        else
            allocate (self%z(0), self%weight(0))
        end if
        if (allocated(error)) return
        allocate (self%waves(n, size(self%z)))
        do i = 1, size(self%z)
            call odd_waves(self%z(i), self%waves(:, i))
        end do
        self%weight = self%weight/self%z**2
    end subroutine new_basis

    !> c, and G with what the extrapolation changed of it.
    subroutine solve(conduction, a, s, basis, c, total, change, error)
        type(conduction_t), intent(in) :: conduction
        complex(wp), intent(in) :: a, s
        type(film_basis_t), intent(in) :: basis
        complex(wp), intent(out) :: c(:), total, change
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: chi
        complex(wp) :: solution(size(c))
        complex(wp), allocatable :: matrix(:, :), leading(:, :)
        real(wp), allocatable :: scaled(:, :), product(:, :)
        integer :: i, j, m, n, info

        total = 0.0_wp
        change = 0.0_wp
        c = 0.0_wp
        if (allocated(error)) return
        n = size(c)
        allocate (scaled(2*n, size(basis%z)), product(2*n, n), matrix(n, n))
        do i = 1, size(basis%z)
            chi = conduction%chi(basis%z(i)/a, s)*basis%weight(i)
            scaled(:n, i) = real(chi, wp)*basis%waves(:, i)
            scaled(n + 1:, i) = aimag(chi)*basis%waves(:, i)
        end do
        call add_product("N", "T", 2*n, n, size(basis%z), 1.0_wp, scaled, 2*n, basis%waves, n, 0.0_wp, product, 2*n)
        do j = 1, n
            do i = 1, n
                matrix(i, j) = a**3/conduction%scale*(cmplx(product(i, j), product(n + i, j), wp) + of_half_space(i - 1, j - 1))
            end do
            matrix(j, j) = matrix(j, j) + 0.5_wp*a**2*conduction%film/(2*j - 1)
        end do
        ! with half the terms, then with all of them
        do m = n/2, n, n - n/2
            leading = matrix(:m, :m)
            solution = 0.0_wp
            solution(1) = 0.5_wp*a**2
            call solve_system(leading, solution(:m), info)
            if (info /= 0) then
                call raise(error, error_no_convergence, "the contributions of the layers nearly cancel at contact radius "// &
                           to_text(real(a, wp)))
                return
            end if
            change = (pi*a**2*solution(1) - total)/63.0_wp
            total = pi*a**2*solution(1)
        end do
        total = total + change
        c = solution
    end subroutine solve

    pure subroutine raise_missed(conduction, a, change, where, remedy, error)
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a
        complex(wp), intent(in) :: change
        character(len=*), intent(in) :: where, remedy
        type(error_t), allocatable, intent(inout) :: error

        call raise(error, error_no_convergence, "the flux through a film of resistance "//to_text(conduction%film)// &
                   " in a contact area of radius "//to_text(a)//" has an error of about "//to_text(abs(change))//where// &
                   ", because its edge zone is too thin. Remedy: "//remedy)
    end subroutine raise_missed

    !> N_mn = int_0^inf J_(2m+1) J_(2n+1) z^-2 dz.
    pure function of_half_space(m, n) result(value)
        integer, intent(in) :: m, n
        real(wp) :: value

        value = (-1)**(m - n)/(4.0_wp*pi*(m + n + 0.5_wp)*(m + n + 1.5_wp)*(0.25_wp - real(m - n, wp)**2))
    end function of_half_space

    !> J_1, J_3, ... at z > 0; those that are negligible are 0.
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
        real(wp), dimension(size(theta)) :: before, here, next, turn
        integer :: n

        q = 0.0_wp
        here = sin(theta)
        before = sin(-theta)
        turn = 2.0_wp*cos(2.0_wp*theta)
        do n = 0, size(self%c) - 1
            q = q + self%radius*self%c(n + 1)*2*(-1)**n/real(2*n + 1, wp)*here
            next = turn*here - before
            before = here
            here = next
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
        real(wp) :: part
        integer :: i, j

        density = 0.0_wp
        call new_rule(rule, min(4*size(self%c), largest_rule), error)
        if (allocated(error)) return
        do i = 1, size(r)
            density(i) = 0.25_wp/conduction%scale*sum(rule%weights*line_at(self, acos(min(r(i)/self%radius &
                                                                                     *sin(0.5_wp*half_pi*rule%distance), 1.0_wp))))
        end do
        associate (z => self%basis%z)
            do j = 1, size(z)
                part = z(j)*self%basis%weight(j)*self%radius/conduction%scale*sum(self%basis%waves(:, j)*self%c) &
                       *real(conduction%chi(cmplx(z(j)/self%radius, 0.0_wp, wp), steady), wp)
                density = density + part*[(gsl_sf_bessel_j0(z(j)*r(i)/self%radius), i=1, size(r))]
            end do
        end associate
        density = (1.0_wp - density)/conduction%film
    end subroutine flux

end module mdrcontact_conduction_film
