! SPDX-License-Identifier: GPL-3.0-or-later
!> Contribution of the layers below the surface to the Galerkin matrices: products of Bessel functions over wavenumbers
!> (theory/surfaces.md (6.5)).
!>
!> kappa - kappa_0 falls as what the layers change of 1 + chi, so that a plain rule over k serves all entries: with s_0 of the
!> surface's half-space it is change (kappa_0/s_0)^2/(1 + (1 - kappa_0/s_0) change/s_0).
module mdrcontact_tension_body_part
    use, intrinsic :: iso_c_binding, only: c_int
    use mdrcontact_body_compliance, only: compliance_t
    use mdrcontact_error, only: error_no_convergence, error_t, raise
    use mdrcontact_gsl, only: gsl_sf_bessel_jn_array, gsl_success
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_one_thread, only: add_product
    use mdrcontact_numerics_waves, only: wave_rule
    use mdrcontact_tension_green, only: green_t
    implicit none (type, external)
    private
    public :: add_body_part, wave_basis, body_waves

    !> First and last wavenumber [1/depth of all layers], [1/depth of the first].
    real(wp), parameter :: first_wave = 1.0e-13_wp, last_wave = 22.0_wp
    !> The waves by which what the layers change falls, as a distance [depth of the first].
    real(wp), parameter :: fall = 7.5_wp
    !> Bessel functions below this are negligible.
    real(wp), parameter :: smallest_bessel = 1.0e-60_wp

contains

    !> Adds int (kappa - kappa_0) q_i q_j dk/pi and its slope.
    subroutine add_body_part(green, compliance, a, matrix, slope, error)
        type(green_t), intent(in) :: green
        class(compliance_t), intent(in) :: compliance
        real(wp), intent(in) :: a
        real(wp), intent(inout) :: matrix(:, :), slope(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: k(:), weight(:), basis(:, :), rates(:, :), weighted(:, :), half(:, :)
        integer :: i, n

        if (.not. compliance%first_depth > 0.0_wp) return
        call body_waves(green, compliance, 2.0_wp*a, k, weight, error)
        if (allocated(error)) return
        n = size(matrix, 1)
        allocate (basis(n, size(k)), rates(n, size(k)), weighted(n, size(k)), half(n, n))
        call fill_basis(k, a, n - merge(1, 0, green%columns > 2), basis, rates, error)
        if (allocated(error)) return
        do i = 1, size(k)
            weighted(:, i) = pi*weight(i)*basis(:, i)
        end do
        call add_product("N", "T", n, n, size(k), 1.0_wp, weighted, n, basis, n, 1.0_wp, matrix, n)
        call add_product("N", "T", n, n, size(k), 1.0_wp, weighted, n, rates, n, 0.0_wp, half, n)
        slope = slope + half + transpose(half)
    end subroutine add_body_part

    !> Wavenumbers, and weights times kappa - kappa_0, for integrals with waves over a distance.
    subroutine body_waves(green, compliance, distance, k, weight, error)
        type(green_t), intent(in) :: green
        class(compliance_t), intent(in) :: compliance
        !> [length]
        real(wp), intent(in) :: distance
        real(wp), allocatable, intent(out) :: k(:), weight(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: ratio(:)
        complex(wp), allocatable :: bare(:), change(:)

        call wave_rule(first_wave/compliance%last_depth, last_wave/compliance%first_depth, &
                       max(distance, fall*compliance%first_depth), k, weight, error)
        if (allocated(error)) return
        allocate (bare(size(k)), change(size(k)))
        call compliance%split(cmplx(k, 0.0_wp, wp), bare, change)
        ratio = green%spectrum(k)/real(bare, wp)
        weight = weight*real(change, wp)*ratio**2/(1.0_wp + (1.0_wp - ratio)*real(change/bare, wp))
    end subroutine body_waves

    !> The basis alone.
    subroutine wave_basis(k, a, n, couple, basis, error)
        real(wp), intent(in) :: k(:), a
        !> how many cosines, and 1 with a plate, else 0
        integer, intent(in) :: n, couple
        !> (couple + n, size(k))
        real(wp), allocatable, intent(out) :: basis(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: rates(:, :)

        allocate (basis(couple + n, size(k)), rates(couple + n, size(k)))
        call fill_basis(k, a, n, basis, rates, error)
    end subroutine wave_basis

    !> (-1)^j J_2j(ka), after ka J_1(ka) with a plate, and their slopes over a.
    subroutine fill_basis(k, a, n, basis, rates, error)
        real(wp), intent(in) :: k(:), a
        integer, intent(in) :: n
        !> (basis, wavenumber)
        real(wp), intent(out) :: basis(:, :), rates(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: bessel(0:2*n), x
        integer :: i, j, couple, last

        couple = size(basis, 1) - n
        do i = 1, size(k)
            x = k(i)*a
            bessel = 0.0_wp
            last = last_order(x, 2*n)
            if (gsl_sf_bessel_jn_array(0_c_int, int(last, c_int), x, bessel(:last)) /= gsl_success) then
                call raise(error, error_no_convergence, "Bessel functions could not be computed")
                return
            end if
            if (couple == 1) then
                basis(1, i) = x*bessel(1)
                rates(1, i) = k(i)*x*bessel(0)
            end if
            basis(couple + 1:, i) = bessel(0:2*n - 2:2)
            rates(couple + 1, i) = -k(i)*bessel(1)
            do j = 1, n - 1
                rates(couple + 1 + j, i) = 0.5_wp*k(i)*(bessel(2*j - 1) - bessel(2*j + 1))
            end do
            basis(couple + 2::2, i) = -basis(couple + 2::2, i)
            rates(couple + 2::2, i) = -rates(couple + 2::2, i)
        end do
    end subroutine fill_basis

    !> Up to `most`: beyond this order J_m(x) < (x/2)^m/m! is negligible, and GSL's recurrence would underflow.
    pure function last_order(x, most) result(m)
        real(wp), intent(in) :: x
        integer, intent(in) :: most
        integer :: m
        real(wp) :: bound

        m = 0
        bound = 0.5_wp*x
        do while (bound > smallest_bessel .and. m < most)
            m = m + 1
            bound = bound*0.5_wp*x/real(m + 1, wp)
        end do
    end function last_order

end module mdrcontact_tension_body_part
