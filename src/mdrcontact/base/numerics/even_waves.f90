! SPDX-License-Identifier: GPL-3.0-or-later
!> Even Legendre polynomials in Fourier space: int_0^1 P_2j(x) cos(kx) dx = (-1)^j j_2j(k).
!>
!> Above its order j_l neither grows nor falls with l, so that the recurrence keeps its digits upwards; below GSL goes down from
!> high orders, which takes as many steps as k is large, and fails beyond 2e4.
module mdrcontact_numerics_even_waves
    use, intrinsic :: iso_c_binding, only: c_int
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_gsl, only: disable_gsl_abort, gsl_sf_bessel_jl_steed_array, gsl_success
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: even_waves, highest_order

contains

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
        if (k > max(ubound(bessel, 1), 1)) then
            call recur_upward(k, values)
            return
        end if
        call disable_gsl_abort()
        bessel = 0.0_wp
        if (gsl_sf_bessel_jl_steed_array(int(highest_order(k, ubound(bessel, 1)), c_int), k, bessel) /= gsl_success) then
            call raise(error, error_no_convergence, "spherical Bessel functions could not be computed at "//to_text(k))
            return
        end if
        do j = 0, ubound(values, 1)
            values(j) = (-1)**j*bessel(2*j)
        end do
    end subroutine even_waves

    !> The same for orders below k.
    pure subroutine recur_upward(k, values)
        real(wp), intent(in) :: k
        real(wp), intent(out) :: values(0:)
        real(wp) :: even, odd
        integer :: j

        even = sin(k)/k
        odd = (even - cos(k))/k
        do j = 0, ubound(values, 1)
            values(j) = (-1)**j*even
            even = real(4*j + 3, wp)/k*odd - even
            odd = real(4*j + 5, wp)/k*even - odd
        end do
    end subroutine recur_upward

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

end module mdrcontact_numerics_even_waves
