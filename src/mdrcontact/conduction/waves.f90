! SPDX-License-Identifier: GPL-3.0-or-later
!> Rules for integrals over wavenumbers, and even Legendre polynomials in Fourier space:
!> int_0^1 P_2j(x) cos(kx) dx = (-1)^j j_2j(k).
module mdrcontact_conduction_waves
    use, intrinsic :: iso_c_binding, only: c_int
    use mdrcontact_error, only: check_memory, error_domain, error_no_convergence, error_t, raise
    use mdrcontact_gsl, only: disable_gsl_abort, gsl_sf_bessel_jl_steed_array, gsl_success
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: wave_rule, even_waves, highest_order

    !> Nodes of a panel of one octave, or of 2 pi of the phase.
    integer, parameter :: per_panel = 16
    !> Panels at most.
    integer, parameter :: most_panels = 30000

contains

    !> Nodes and weights for integrals from 0 to `last` of what varies over octaves from `first` on and oscillates as cos(length k).
    subroutine wave_rule(first, last, length, k, weight, error)
        !> 0 < first < last [1/length]
        real(wp), intent(in) :: first, last
        !> > 0 [length]
        real(wp), intent(in) :: length
        real(wp), allocatable, intent(out) :: k(:), weight(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: node(per_panel), w(per_panel), left, right
        real(wp), allocatable :: edge(:)
        integer :: i, n, stat

        if (allocated(error)) return
        call gauss_legendre(node, w, error)
        if (allocated(error)) return
        allocate (edge(0:most_panels))
        n = 1
        edge(:1) = [0.0_wp, min(first, last)]
        do while (edge(n) < last)
            if (n == most_panels) then
                call raise(error, error_domain, "a point or a spot so many thicknesses of the first layer away, or wide, "// &
                           "takes more waves than are offered")
                return
            end if
            edge(n + 1) = min(2.0_wp*edge(n), edge(n) + 2.0_wp*pi/length)
            n = n + 1
        end do
        edge(n) = last
        allocate (k(n*per_panel), weight(n*per_panel), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = 1, n
            left = edge(i - 1)
            right = edge(i)
            k((i - 1)*per_panel + 1:i*per_panel) = left + (right - left)*node
            weight((i - 1)*per_panel + 1:i*per_panel) = (right - left)*w
        end do
    end subroutine wave_rule

    !> (-1)^j j_2j(k), j = 0, 1, ...
    subroutine even_waves(k, values, error)
        !> >= 0
        real(wp), intent(in) :: k
        real(wp), intent(out) :: values(0:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: bessel(0:2*ubound(values, 1))
        integer :: j

        values = 0.0_wp
        if (allocated(error)) return
        call disable_gsl_abort()
        bessel = 0.0_wp
        if (gsl_sf_bessel_jl_steed_array(int(highest_order(k, ubound(bessel, 1)), c_int), k, bessel) /= gsl_success) then
            call raise(error, error_no_convergence, "Bessel functions of a spot could not be computed")
            return
        end if
        do j = 0, ubound(values, 1)
            values(j) = (-1)**j*bessel(2*j)
        end do
    end subroutine even_waves

    !> The highest l <= order for which j_l(k) ~ k^l/(2l + 1)!! is not far below all others.
    pure function highest_order(k, order) result(l)
        real(wp), intent(in) :: k
        integer, intent(in) :: order
        integer :: l
        real(wp) :: size_of

        size_of = 1.0_wp
        do l = 0, order - 1
            size_of = size_of*k/(2*l + 3)
            if (size_of < 1.0e-100_wp) return
        end do
        l = order
    end function highest_order

end module mdrcontact_conduction_waves
