! SPDX-License-Identifier: GPL-3.0-or-later
!> Total pressure and pore pressure under an indenter that was pressed into a gel at time 0, its contact radius being held
!> (theory/poroelastic.md (5.5), (5.6)).
module mdrcontact_poroelastic_pressure
    use mdrcontact_error, only: error_invalid, error_no_convergence, error_t, raise, to_text
    use mdrcontact_gsl, only: gsl_sf_bessel_j0
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_laplace, only: inverse_laplace
    use mdrcontact_numerics_quadrature, only: gauss_legendre, legendre
    use mdrcontact_numerics_waves, only: basis_t, legendre_waves, wave_rule
    use mdrcontact_poroelastic_answers, only: basis_for, nodes
    use mdrcontact_poroelastic_contact, only: solve_contacts
    use mdrcontact_poroelastic_gel, only: drains_by_surface, gel_t, sealed
    use mdrcontact_poroelastic_kernel, only: pore_part
    implicit none (type, external)
    private
    public :: gel_pressure

    !> Under a sealed surface pore pressure is summed over waves up to this k, and this many times sqrt(1/tau).
    real(wp), parameter :: last_wave = 6000.0_wp, last_ratio = 60.0_wp
    !> Largest contribution of the shortest two thirds of them, relative to the largest value.
    real(wp), parameter :: allowed = 1.0e-4_wp

contains

    !> Pressures at radii in units of 4 G d/(pi a).
    subroutine gel_pressure(gel, shape, is_pore, tau, r, values, error)
        type(gel_t), intent(in) :: gel
        !> flat or parabolic
        real(wp), intent(in) :: shape(2)
        logical, intent(in) :: is_pore
        !> > 0; 0 <= r < 1 [a]
        real(wp), intent(in) :: tau, r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        type(basis_t) :: basis
        real(wp), allocatable :: load(:)

        values = 0.0_wp
        if (is_pore .and. gel%drainage == drains_by_surface) return
        if (is_pore .and. gel%ratio > 0.0_wp) then
            call raise(error, error_invalid, "kind: the pore pressure is available on a half-space only, not on a film")
        end if
        call basis_for(gel, tau, tau, basis, error)
        if (allocated(error)) return
        if (is_pore .and. gel%drainage == sealed) then
            call sum_waves(gel, basis, shape, tau, r, values, error)
        else
            allocate (load(basis%order))
            call load_in_time(gel, basis, shape, is_pore, tau, load, error)
            call pressure_of_load(load, r, values, error)
        end if
    end subroutine gel_pressure

    !> Coefficients of q(x), or of m(x), at tau.
    subroutine load_in_time(gel, basis, shape, is_pore, tau, load, error)
        type(gel_t), intent(in) :: gel
        type(basis_t), intent(in) :: basis
        real(wp), intent(in) :: shape(2), tau
        logical, intent(in) :: is_pore
        real(wp), intent(out) :: load(:)
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: s(nodes), weight(nodes, 1)
        complex(wp), dimension(basis%order, nodes) :: q, w

        call inverse_laplace([tau], s, weight)
        call solve_contacts(gel, basis, shape, s, q, w, error)
        if (is_pore) q = q - w
        load = aimag(matmul(q, weight(:, 1)))
    end subroutine load_in_time

    !> p(r) = q(1)/sqrt(1 - r^2) - int_r^1 q'(x)/sqrt(x^2 - r^2) dx, by x^2 = r^2 + (1 - r^2) u^2: q'(x)/x is a polynomial in u^2.
    subroutine pressure_of_load(load, r, values, error)
        real(wp), intent(in) :: load(:), r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: u(size(load) + 2), weight(size(load) + 2), width
        integer :: i

        if (allocated(error)) return
        call gauss_legendre(u, weight, error)
        if (allocated(error)) return
        do i = 1, size(r)
            width = sqrt((1.0_wp - r(i))*(1.0_wp + r(i)))
            values(i) = edge_load(load)/width - width*sum(weight*slope_per_x(load, sqrt(r(i)**2 + (width*u)**2)))
        end do
    end subroutine pressure_of_load

    pure function edge_load(load) result(q)
        real(wp), intent(in) :: load(:)
        real(wp) :: q
        integer :: j

        q = sum([(load(j)*sqrt(4.0_wp*j - 3.0_wp), j=1, size(load))])
    end function edge_load

    !> q'(x)/x, from P'_(l) - P'_(l-2) = (2l - 1) P_(l-1).
    pure function slope_per_x(load, x) result(slope)
        real(wp), intent(in) :: load(:), x(:)
        real(wp) :: slope(size(x))
        real(wp) :: p(size(x), 2*size(load)), rate(size(x))
        integer :: j

        p = legendre(2*size(load), x)
        slope = 0.0_wp
        rate = 0.0_wp
        do j = 2, size(load)
            rate = rate + (4*j - 5)*p(:, 2*j - 2)
            slope = slope + load(j)*sqrt(4.0_wp*j - 3.0_wp)*rate
        end do
        slope = slope/max(x, tiny(1.0_wp))
    end function slope_per_x

    !> Pore pressure int k J_0(kr) part(k) p^(k) dk of a sealed surface.
    subroutine sum_waves(gel, basis, shape, tau, r, values, error)
        type(gel_t), intent(in) :: gel
        type(basis_t), intent(in) :: basis
        real(wp), intent(in) :: shape(2), tau, r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: s(nodes), weight(nodes, 1)
        complex(wp), dimension(basis%order, nodes) :: q, w
        real(wp), allocatable :: k(:), dk(:), b(:, :), part(:), terms(:)
        logical, allocatable :: shorter(:)
        real(wp) :: off
        integer :: i, j

        call wave_rule(min(1.0e-3_wp, 1.0e-3_wp/sqrt(tau)), max(last_wave, last_ratio/sqrt(tau)), 2.0_wp, k, dk, error)
        if (allocated(error)) return
        allocate (b(basis%order, size(k)), part(size(k)))
        call legendre_waves(k, b, error)
        part = 0.0_wp
        call inverse_laplace([tau], s, weight)
        call solve_contacts(gel, basis, shape, s, q, w, error)
        do j = 1, nodes
            part = part + aimag(weight(j, 1)*pore_part(gel, cmplx(k, kind=wp), s(j))*matmul(q(:, j), b))
        end do
        part = dk*k*part
        shorter = k > k(size(k))/3.0_wp
        off = 0.0_wp
        do i = 1, size(r)
            terms = part*bessel(k*r(i))
            values(i) = sum(terms)
            off = max(off, abs(sum(terms, mask=shorter)))
        end do
        if (.not. (allocated(error) .or. off <= allowed*maxval(abs(values)))) then
            call raise(error, error_no_convergence, ": the pore pressure is not accurate this close to the edge of contact, "// &
                       "where the shortest waves add "//to_text(off), "r")
        end if
    end subroutine sum_waves

    impure elemental function bessel(x) result(y)
        real(wp), intent(in) :: x
        real(wp) :: y

        y = gsl_sf_bessel_j0(x)
    end function bessel

end module mdrcontact_poroelastic_pressure
